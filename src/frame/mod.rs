//! What varies from frame to frame, and the picture that comes out.
//!
//! [`Clock`] is the one place of the library where time is read; everything after it is handed
//! numbers, so that a frame can be drawn again exactly.

mod clock;
mod image;
mod keyboard;
mod mouse;
mod script;

pub use clock::{Clock, Date, FixedClock};
pub use image::{FloatImage, FrameImage};
pub use keyboard::Keyboard;
pub use mouse::Mouse;
pub use script::{Action, Controls, Event, Player, Script, rescaled};

use glam::{UVec2, Vec4};

/// ShaderToy's `iSampleRate`: the same in every pass.
pub const SAMPLE_RATE: f32 = 44_100.0;

/// Everything that a frame's picture may depend on besides the scene itself.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrameInput {
    /// `iTime`, seconds since the scene was started or reset, pauses left out.
    pub time: f32,
    /// `iTimeDelta`, seconds since the frame before.
    pub time_delta: f32,
    /// `iFrameRate`, frames per second.
    pub frame_rate: f32,
    /// `iFrame`, counted from 0.
    pub frame: i32,
    /// `iResolution.xy` in pixels; its third component is always 1.
    pub resolution: UVec2,
    /// `iMouse` in pixels from the bottom left, see [`Mouse::frame_value`].
    pub mouse: Vec4,
    /// `iDate`: year, month from 0, day from 1, seconds since midnight.
    pub date: Vec4,
    /// The keys, for those that read them.
    pub keyboard: Keyboard,
}
