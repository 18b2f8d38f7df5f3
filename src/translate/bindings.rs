//! The contract between translated programs and the renderer: which name is bound where.

use std::sync::LazyLock;

use crate::glsl::lower::{HostSampler, Interface};
use crate::scene::CHANNELS;

/// The bind group that everything lives in.
pub const GROUP: u32 = 0;

/// Binding of the uniform block.
pub const UNIFORMS: u32 = 0;

/// Binding of the texture behind `iChannel{channel}`.
pub const fn texture(channel: usize) -> u32 {
    1 + 2 * channel as u32
}

/// Binding of the sampler behind `iChannel{channel}`.
pub const fn sampler(channel: usize) -> u32 {
    2 + 2 * channel as u32
}

/// Binding of the buffer of constant tables.
pub const TABLES: u32 = 1 + 2 * CHANNELS as u32;

/// Binding of the buffer that findings go to.
pub const FINDINGS: u32 = TABLES + 1;

/// The most bytes of the uniform block: all of ShaderToy's, and room for some of the author's.
pub const BLOCK_SIZE: u32 = 1024;

/// What the renderer binds, as the front end is told of it.
pub static INTERFACE: LazyLock<Interface> = LazyLock::new(|| Interface {
    group: GROUP,
    block: UNIFORMS,
    uniforms: Uniform::ALL
        .iter()
        .chain(&Uniform::GENERATED)
        .map(|uniform| uniform.name().to_owned())
        .collect(),
    block_size: BLOCK_SIZE,
    samplers: (0..CHANNELS)
        .map(|channel| HostSampler {
            name: channel_name(channel).to_owned(),
            texture: texture(channel),
            sampler: sampler(channel),
        })
        .collect(),
    tables: TABLES,
    findings: FINDINGS,
});

/// ShaderToy's uniforms, in the order in which the site declares them, and those of the generated `main`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Uniform {
    /// `vec3 iResolution`
    Resolution,
    /// `float iTime`
    Time,
    /// `float iChannelTime[4]`
    ChannelTime,
    /// `vec4 iMouse`
    Mouse,
    /// `vec4 iDate`
    Date,
    /// `float iSampleRate`
    SampleRate,
    /// `vec3 iChannelResolution[4]`
    ChannelResolution,
    /// `int iFrame`
    Frame,
    /// `float iTimeDelta`
    TimeDelta,
    /// `float iFrameRate`
    FrameRate,
    /// `vec4 unViewport`: where the face of a cubemap lies in its target, and its size
    Viewport,
    /// `vec3 unCorners[5]`: the corners of the face of a cubemap, and the eye
    Corners,
    /// `float iTimeOffset`: when the first of a block's samples sounds, in seconds
    TimeOffset,
    /// `int iSampleOffset`: the number of the first of a block's samples
    SampleOffset,
}

impl Uniform {
    /// Those that every author's text may name.
    pub const ALL: [Uniform; 10] = [
        Uniform::Resolution,
        Uniform::Time,
        Uniform::ChannelTime,
        Uniform::Mouse,
        Uniform::Date,
        Uniform::SampleRate,
        Uniform::ChannelResolution,
        Uniform::Frame,
        Uniform::TimeDelta,
        Uniform::FrameRate,
    ];

    /// Those that only the generated text of cubemap and sound passes declares.
    pub const GENERATED: [Uniform; 4] = [
        Uniform::Viewport,
        Uniform::Corners,
        Uniform::TimeOffset,
        Uniform::SampleOffset,
    ];

    /// The name that authors write.
    pub fn name(self) -> &'static str {
        match self {
            Uniform::Resolution => "iResolution",
            Uniform::Time => "iTime",
            Uniform::ChannelTime => "iChannelTime",
            Uniform::Mouse => "iMouse",
            Uniform::Date => "iDate",
            Uniform::SampleRate => "iSampleRate",
            Uniform::ChannelResolution => "iChannelResolution",
            Uniform::Frame => "iFrame",
            Uniform::TimeDelta => "iTimeDelta",
            Uniform::FrameRate => "iFrameRate",
            Uniform::Viewport => "unViewport",
            Uniform::Corners => "unCorners",
            Uniform::TimeOffset => "iTimeOffset",
            Uniform::SampleOffset => "iSampleOffset",
        }
    }

    /// Whether sound passes have it too; they have no frames.
    pub fn is_for_sound(self) -> bool {
        matches!(
            self,
            Uniform::ChannelTime | Uniform::Date | Uniform::SampleRate | Uniform::ChannelResolution
        )
    }

    /// Its declaration in GLSL, without `uniform` and semicolon.
    pub fn declaration(self) -> String {
        let name = self.name();
        match self {
            Uniform::Resolution => format!("vec3 {name}"),
            Uniform::Mouse | Uniform::Date | Uniform::Viewport => format!("vec4 {name}"),
            Uniform::Frame | Uniform::SampleOffset => format!("int {name}"),
            Uniform::Corners => format!("vec3 {name}[5]"),
            Uniform::ChannelTime => format!("float {name}[{CHANNELS}]"),
            Uniform::ChannelResolution => format!("vec3 {name}[{CHANNELS}]"),
            Uniform::Time
            | Uniform::SampleRate
            | Uniform::TimeDelta
            | Uniform::FrameRate
            | Uniform::TimeOffset => format!("float {name}"),
        }
    }
}

/// The name that authors write for a channel.
pub fn channel_name(channel: usize) -> &'static str {
    ["iChannel0", "iChannel1", "iChannel2", "iChannel3"][channel]
}
