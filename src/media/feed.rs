use std::fmt::Debug;

use super::Format;

/// Texels that change with time: a film, the spectrum of a sound.
pub trait Feed: Send + Debug {
    /// Width and height in texels.
    fn size(&self) -> [u32; 2];

    /// What one texel is.
    fn format(&self) -> Format;

    /// Where it stands at `time` seconds of the scene (`iChannelTime`): what has an end begins again behind it.
    fn position(&self, time: f64) -> f64;

    /// The texels at `time`, which may jump either way. The first row of a picture is its top one; of a sound it is the
    /// spectrum. `None` if they are the same as at the call before.
    fn texels(&mut self, time: f64) -> Option<&[u8]>;
}
