//! How far a picture is from another.

use crate::frame::FloatImage;

/// How far the values of a probe are from those of a reference.
///
/// A pixel is a *hit* where the value is finite and positive, as a distance along a ray is that meets
/// something; its relative error is |value − reference| / |reference|, for vectors of the differences'
/// and the reference's length.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct ProbeError {
    /// The relative error that half of the common hits stay below.
    pub median: f64,
    /// That 99 of 100 stay below.
    pub p99: f64,
    /// The largest.
    pub max: f64,
    /// The mean of the relative errors.
    pub mean: f64,
    /// Pixels that both hit.
    pub hits: usize,
    /// Pixels that only one of the two hits.
    pub disagreements: usize,
}

/// How far a picture is from another, both as a display shows them: clamped to 0 to 1.
#[derive(Clone, Copy, Debug, Default, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct PictureError {
    /// Root of the mean squared difference of the three channels, where 1 is white.
    pub rmse: f64,
    /// The peak signal-to-noise ratio, −20 log₁₀ of it, in decibels; infinite for equal pictures.
    #[serde(serialize_with = "finite", deserialize_with = "maybe_infinite")]
    pub psnr: f64,
    /// The share of pixels of which some channel differs by more than 1/255.
    pub above_1: f64,
    /// The same for 8/255.
    pub above_8: f64,
}

/// JSON has no infinity.
fn finite<S: serde::Serializer>(value: &f64, serializer: S) -> Result<S::Ok, S::Error> {
    serde::Serialize::serialize(&value.is_finite().then_some(*value), serializer)
}

fn maybe_infinite<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<f64, D::Error> {
    let value: Option<f64> = serde::Deserialize::deserialize(deserializer)?;
    Ok(value.unwrap_or(f64::INFINITY))
}

/// Compares the values of a probe with so many components.
pub fn probe(value: &FloatImage, reference: &FloatImage, components: usize) -> ProbeError {
    let mut errors = Vec::with_capacity(value.rgba.len());
    let mut disagreements = 0;
    for (value, reference) in value.rgba.iter().zip(&reference.rgba) {
        let (value, reference) = (&value[..components], &reference[..components]);
        match (is_hit(value), is_hit(reference)) {
            (true, true) => errors.push(relative(value, reference)),
            (false, false) => {}
            _ => disagreements += 1,
        }
    }
    errors.sort_by(f64::total_cmp);
    ProbeError {
        median: quantile(&errors, 0.5),
        p99: quantile(&errors, 0.99),
        max: errors.last().copied().unwrap_or(0.0),
        mean: errors.iter().sum::<f64>() / errors.len().max(1) as f64,
        hits: errors.len(),
        disagreements,
    }
}

/// Whether a value is one that a ray hits, or for vectors, whether it is anything.
fn is_hit(value: &[f32]) -> bool {
    let is_positive = match value {
        [distance] => *distance > 0.0,
        vector => vector.iter().any(|&component| component != 0.0),
    };
    is_positive && value.iter().all(|component| component.is_finite())
}

fn relative(value: &[f32], reference: &[f32]) -> f64 {
    let square = |sum: f64, x: f64| sum + x * x;
    let pairs = value.iter().zip(reference);
    let differences = pairs.map(|(&a, &b)| f64::from(a) - f64::from(b));
    let length = reference.iter().map(|&b| f64::from(b)).fold(0.0, square);
    (differences.fold(0.0, square) / length).sqrt()
}

/// The smallest of sorted values that a share of them does not exceed; 0 where there is none.
pub fn quantile(sorted: &[f64], share: f64) -> f64 {
    let rank = (share * sorted.len() as f64).ceil() as usize;
    sorted.get(rank.saturating_sub(1)).copied().unwrap_or(0.0)
}

/// A component as a display shows it.
fn shown(x: f32) -> f64 {
    if x.is_nan() {
        0.0
    } else {
        f64::from(x.clamp(0.0, 1.0))
    }
}

/// Compares pictures. A component that is no number counts as black, as most displays show it.
pub fn picture(value: &FloatImage, reference: &FloatImage) -> PictureError {
    let (mut squares, mut above_1, mut above_8) = (0.0, 0_usize, 0_usize);
    for (value, reference) in value.rgba.iter().zip(&reference.rgba) {
        let differences = [0, 1, 2].map(|i| (shown(value[i]) - shown(reference[i])).abs());
        squares += differences.iter().map(|x| x * x).sum::<f64>();
        let largest = differences.into_iter().fold(0.0, f64::max);
        above_1 += usize::from(largest > 1.0 / 255.0);
        above_8 += usize::from(largest > 8.0 / 255.0);
    }
    let pixels = reference.rgba.len().max(1) as f64;
    let rmse = (squares / (3.0 * pixels)).sqrt();
    PictureError {
        rmse,
        psnr: -20.0 * rmse.log10(),
        above_1: above_1 as f64 / pixels,
        above_8: above_8 as f64 / pixels,
    }
}

/// How much the error of a picture changes from one frame to the next, which is seen as flicker: the root of the mean
/// squared change over all pixels and channels, where 1 is white. An error that stays, as that of a blurred picture does,
/// has none, and neither has what moves as the reference does. Each pair is the earlier frame and the later one.
pub fn flicker(value: [&FloatImage; 2], reference: [&FloatImage; 2]) -> f64 {
    let mut squares = 0.0;
    let pixels = reference[1].rgba.len();
    for at in 0..pixels {
        for channel in 0..3 {
            let [before, now] = [0, 1]
                .map(|i| shown(value[i].rgba[at][channel]) - shown(reference[i].rgba[at][channel]));
            squares += (now - before) * (now - before);
        }
    }
    (squares / (3 * pixels.max(1)) as f64).sqrt()
}

/// How far each channel of a picture is off, black where it is right.
pub fn difference(value: &FloatImage, reference: &FloatImage) -> FloatImage {
    let pairs = value.rgba.iter().zip(&reference.rgba);
    let pixel = |(a, b): (&[f32; 4], &[f32; 4])| {
        let [r, g, b] = [0, 1, 2].map(|i| (shown(a[i]) - shown(b[i])).abs() as f32);
        [r, g, b, 1.0]
    };
    FloatImage {
        size: value.size,
        rgba: pairs.map(pixel).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::UVec2;

    fn image(values: &[f32]) -> FloatImage {
        FloatImage {
            size: UVec2::new(values.len() as u32, 1),
            rgba: values.iter().map(|&x| [x, x, x, 1.0]).collect(),
        }
    }

    #[test]
    fn errors_of_a_probe() {
        let reference = image(&[1.0, 2.0, 4.0, -1.0, -1.0, 8.0]);
        let value = image(&[1.5, 2.0, 3.0, -1.0, 7.0, f32::NAN]);
        let error = probe(&value, &reference, 1);
        assert_eq!((error.hits, error.disagreements), (3, 2));
        assert_eq!((error.median, error.max), (0.25, 0.5));
        assert_eq!(error.p99, 0.5);
        assert_eq!(error.mean, 0.25);
        // The length of (0.5, 0.5, 0.5) over that of (1, 1, 1).
        let vectors = probe(&image(&[1.5]), &image(&[1.0]), 3);
        assert!((vectors.max - 0.5).abs() < 1e-12);
    }

    #[test]
    fn only_what_changes_otherwise_than_the_reference_flickers() {
        let (dark, light) = (image(&[0.25, 0.25]), image(&[0.5, 0.5]));
        let (still, moved) = (image(&[0.75, 0.75]), image(&[1.0, 1.0]));
        assert_eq!(flicker([&dark, &light], [&still, &moved]), 0.0);
        assert_eq!(flicker([&dark, &light], [&still, &still]), 0.25);
        let half = image(&[0.25, 0.5]);
        let expected = (0.0625_f64 / 2.0).sqrt();
        assert!((flicker([&dark, &half], [&still, &still]) - expected).abs() < 1e-12);
    }

    #[test]
    fn errors_of_pictures() {
        let equal = picture(&image(&[0.5, 2.0]), &image(&[0.5, 1.0]));
        assert_eq!((equal.rmse, equal.psnr), (0.0, f64::INFINITY));
        let error = picture(&image(&[0.5, 0.5]), &image(&[0.25, 0.5]));
        assert!((error.rmse - (0.0625_f64 / 2.0).sqrt()).abs() < 1e-12);
        assert_eq!((error.above_1, error.above_8), (0.5, 0.5));
        let text = serde_json::to_string(&equal).expect("a number or null");
        assert_eq!(serde_json::from_str::<PictureError>(&text).unwrap(), equal);
    }
}
