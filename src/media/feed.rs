//! What changes with time, as the renderer pulls it.

use std::sync::Arc;

use super::Format;
use super::sound::Sound;

/// Texels that change with time: a film, the spectrum of a sound.
///
/// Times are seconds of the scene's time. They may go on, stand still, jump, and go back to 0; what is not finite or
/// negative counts as 0. Whatever a feed has remembered, its texels depend on the time alone, so that frames can be
/// drawn in any order.
pub trait Feed: Send + std::fmt::Debug {
    /// Width and height in texels.
    fn size(&self) -> [u32; 2];

    /// What one texel is.
    fn format(&self) -> Format;

    /// Where it stands at `time` (`iChannelTime`), in seconds: within its length, if it begins again behind its end.
    /// What has no position, such as a camera, stands at 0.
    fn position(&self, time: f64) -> f64;

    /// The texels at `time`, row by row, or `None` if they are the same as at the call before.
    ///
    /// Pictures have their top row first, as files do. Of a sound, row 0 is the spectrum and row 1 the waveform: these
    /// are uploaded as they are, and never flipped.
    fn texels(&mut self, time: f64) -> Option<&[u8]>;

    /// What is heard of it: from the scene's time 0 on, and again from the beginning behind its end.
    fn sound(&self) -> Option<&Arc<Sound>> {
        None
    }
}

/// A time that can be computed with: from 0 to some ten thousand years.
pub(super) fn sane(time: f64) -> f64 {
    match time > 0.0 {
        true => time.min(3e11),
        // Also what is no number.
        false => 0.0,
    }
}

#[cfg(test)]
mod tests {
    #[test]
    fn times_that_are_none_count_as_the_beginning() {
        for time in [f64::NAN, f64::NEG_INFINITY, -1.0] {
            assert_eq!(super::sane(time), 0.0);
        }
        assert!(super::sane(f64::INFINITY).is_finite());
        assert_eq!(super::sane(2.5), 2.5);
    }
}
