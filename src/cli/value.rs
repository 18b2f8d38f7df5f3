//! Values of options: sizes, ranges, numbers within bounds.

use std::str::FromStr;

/// Width and height in pixels, neither of them 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Size {
    pub width: u32,
    pub height: u32,
}

impl FromStr for Size {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let (width, height) = text
            .split_once(['x', 'X', '×'])
            .ok_or("write it as WxH, as in 640x360")?;
        let side = |digits: &str| match digits.parse() {
            Ok(0) => Err("a picture has at least one pixel each way".to_owned()),
            Ok(side) => Ok(side),
            Err(_) => Err(format!("`{digits}` is not a number of pixels")),
        };
        Ok(Size {
            width: side(width)?,
            height: side(height)?,
        })
    }
}

/// Frame numbers from `start` up to, not including, `end`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct FrameRange {
    pub start: u32,
    pub end: u32,
}

/// `iFrame` is an int.
const MAX_FRAME: u32 = i32::MAX as u32;

impl FromStr for FrameRange {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let number = |digits: &str| match digits.parse::<u32>() {
            Ok(frame) if frame <= MAX_FRAME => Ok(frame),
            Ok(_) => Err(format!("frame numbers end at {MAX_FRAME}")),
            Err(_) => Err(format!("`{digits}` is not a frame number")),
        };
        let (start, end) = match text.split_once("..") {
            Some((start, end)) => (number(start)?, number(end)?),
            None => return Err("write it as A..B, as in 0..60 for the first sixty".to_owned()),
        };
        match start.cmp(&end) {
            std::cmp::Ordering::Less => Ok(FrameRange { start, end }),
            std::cmp::Ordering::Equal => Err(format!(
                "{start}..{end} holds no frame: B is not included; did you mean {start}..{}?",
                end.saturating_add(1)
            )),
            std::cmp::Ordering::Greater => Err(format!(
                "the range ends before it begins; did you mean {end}..{start}?"
            )),
        }
    }
}

/// `iMouse`.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Mouse(pub [f32; 4]);

impl FromStr for Mouse {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        let numbers = text.split(',').map(|part| number(part.trim()));
        let numbers: Vec<f64> = numbers.collect::<Result<_, _>>()?;
        let bound = 1e9;
        if numbers.iter().any(|number| number.abs() > bound) {
            return Err("no picture is so large".to_owned());
        }
        let numbers: Vec<f32> = numbers.iter().map(|&number| number as f32).collect();
        match numbers[..] {
            // As on the site: z is positive while the button is down, w in the frame of the press alone.
            [x, y] => Ok(Mouse([x, y, x, -y])),
            [x, y, z, w] => Ok(Mouse([x, y, z, w])),
            _ => Err("write it as X,Y or X,Y,Z,W, as in 320,180".to_owned()),
        }
    }
}

fn number(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(number),
        _ => Err(format!("`{text}` is not a number")),
    }
}

pub(super) fn positive(text: &str) -> Result<f64, String> {
    match number(text)? {
        number if (1e-6..=1e6).contains(&number) => Ok(number),
        _ => Err("it must lie between 0.000001 and 1000000".to_owned()),
    }
}

pub(super) fn not_negative(text: &str) -> Result<f64, String> {
    match number(text)? {
        number if (0.0..=1e9).contains(&number) => Ok(number),
        _ => Err("it must lie between 0 and 1000000000".to_owned()),
    }
}

pub(super) fn time(text: &str) -> Result<f64, String> {
    number(text)
}

#[cfg(feature = "window")]
pub(super) fn scale(text: &str) -> Result<f64, String> {
    match number(text)? {
        number if (0.05..=4.0).contains(&number) => Ok(number),
        _ => Err("it must lie between 0.05 and 4".to_owned()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sizes() {
        let size = |text: &str| text.parse::<Size>().map(|size| (size.width, size.height));
        assert_eq!(size("640x360"), Ok((640, 360)));
        assert!(size("0x5").unwrap_err().contains("at least one pixel"));
        for bad in [
            "640",
            "x",
            "640x",
            "-1x5",
            "1x2x3",
            "99999999999x1",
            "1.5x2",
        ] {
            assert!(size(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn mice() {
        let mouse = |text: &str| text.parse::<Mouse>().map(|mouse| mouse.0);
        assert_eq!(mouse("3,4"), Ok([3.0, 4.0, 3.0, -4.0]));
        assert_eq!(mouse("3, 4, -5, 6.5"), Ok([3.0, 4.0, -5.0, 6.5]));
        for bad in [
            "",
            "3",
            "3,4,5",
            "3,4,5,6,7",
            "a,b",
            "3,nan",
            "inf,3",
            "1e99,0",
        ] {
            assert!(mouse(bad).is_err(), "{bad}");
        }
    }

    #[test]
    fn frame_ranges() {
        let range = |text: &str| {
            text.parse::<FrameRange>()
                .map(|range| (range.start, range.end))
        };
        assert_eq!(range("0..60"), Ok((0, 60)));
        assert!(range("9..3").unwrap_err().contains("did you mean 3..9"));
        assert!(range("3..3").unwrap_err().contains("did you mean 3..4"));
        for bad in [
            "5",
            "..",
            "a..b",
            "0..99999999999",
            "0..3000000000",
            "-1..4",
        ] {
            assert!(range(bad).is_err(), "{bad}");
        }
    }
}
