use std::time::Duration;

use glam::UVec2;

use super::gpu::Gpu;

/// How long the device should be busy with one band. Systems end what takes some seconds, and a desktop
/// stands still meanwhile.
const BAND: Duration = Duration::from_millis(250);

/// A picture that is drawn at once and takes longer than this is one too many.
const SLOW: Duration = Duration::from_millis(500);

/// How much larger or smaller than the last a band may be: how long a shader takes differs from place to
/// place.
const MOST_CHANGE: f64 = 4.0;

/// With fewer pixels than this a GPU is not busy, so that smaller bands would only take longer together.
const BUSY_PIXELS: u32 = 1 << 14;

/// How many rows of a picture to hand to the device at once, so that it is never busy for long: few to
/// begin with, all of them once they are quick.
#[derive(Clone, Debug)]
pub struct Pace {
    rows: u32,
    least: u32,
    height: u32,
}

impl Pace {
    /// For a scene that has not been drawn yet, in pictures of this size.
    pub fn new(gpu: &Gpu, size: UVec2) -> Self {
        let least = match gpu.is_cpu() {
            true => 2,
            false => BUSY_PIXELS.div_ceil(size.x),
        };
        Pace::beginning_with(least, size.y)
    }

    /// For a scene that is known to end, and of which the first frame is urgent.
    pub fn whole(gpu: &Gpu, size: UVec2) -> Self {
        let pace = Pace::new(gpu, size);
        Pace {
            rows: even(size.y).max(pace.least),
            ..pace
        }
    }

    fn beginning_with(least: u32, height: u32) -> Self {
        let least = even(least);
        Pace {
            rows: least,
            least,
            height,
        }
    }

    /// How many rows to draw next; always even, so that no pixel is parted from those it is compared with in
    /// derivatives.
    pub fn rows(&self) -> u32 {
        self.rows
    }

    /// Whether the whole picture is drawn at once.
    pub fn is_whole(&self) -> bool {
        self.rows >= self.height
    }

    /// Learns from a band of so many rows. Whole pictures stay so until one is slow: what else was under way
    /// counts with them.
    pub fn took(&mut self, rows: u32, time: Duration) {
        if self.is_whole() && time <= SLOW {
            return;
        }
        let fits = BAND.as_secs_f64() / time.as_secs_f64().max(1e-9);
        let change = fits.clamp(1.0 / MOST_CHANGE, MOST_CHANGE);
        let wanted = even((f64::from(rows) * change) as u32);
        self.rows = wanted.clamp(self.least, even(self.height).max(self.least));
    }
}

fn even(rows: u32) -> u32 {
    rows.next_multiple_of(2).max(2)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The bands of a picture whose rows take so long each.
    fn bands(pace: &mut Pace, row: Duration) -> Vec<u32> {
        let mut bands = Vec::new();
        let mut from = 0;
        while from < pace.height {
            let rows = pace.rows().min(pace.height - from);
            pace.took(rows, row * rows);
            bands.push(rows);
            from += rows;
        }
        bands
    }

    #[test]
    fn a_quick_picture_is_soon_drawn_at_once() {
        let mut pace = Pace::beginning_with(2, 720);
        let quick = Duration::from_micros(10);
        assert_eq!(bands(&mut pace, quick), [2, 8, 32, 128, 512, 38]);
        bands(&mut pace, quick);
        assert!(pace.is_whole());
    }

    #[test]
    fn a_slow_picture_is_drawn_in_bands_that_take_their_time() {
        let mut pace = Pace::beginning_with(2, 720);
        let slow = Duration::from_millis(10);
        bands(&mut pace, slow);
        assert!(!pace.is_whole());
        assert_eq!(pace.rows() % 2, 0);
        for rows in bands(&mut pace, slow) {
            assert!(slow * rows <= 2 * BAND, "{rows} rows");
        }
    }

    #[test]
    fn bands_never_vanish() {
        let mut pace = Pace::beginning_with(13, 100);
        pace.took(14, Duration::from_secs(60));
        assert_eq!(pace.rows(), 14);
        let mut pace = Pace::beginning_with(2, 1);
        assert_eq!(bands(&mut pace, Duration::from_secs(9)), [1]);
        assert!(pace.is_whole());
    }
}
