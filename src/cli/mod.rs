//! The command line: clap types and the reading of their values, nothing else.

mod define;
#[cfg(feature = "gpu")]
mod value;

use std::path::PathBuf;

use clap::builder::RangedU64ValueParser;
use clap::{Args, Parser, Subcommand, ValueEnum};

#[cfg(feature = "gpu")]
pub use value::Size;
#[cfg(feature = "window")]
use value::scale;
#[cfg(feature = "gpu")]
use value::{FrameRange, Mouse, not_negative, positive, time};

#[cfg(feature = "gpu")]
use define::vary;

/// Run ShaderToy GLSL: unchanged, live and frame by frame.
#[derive(Debug, Parser)]
#[command(version, about, max_term_width = 100, arg_required_else_help = true)]
pub struct Cli {
    #[command(subcommand)]
    pub command: Command,
}

#[derive(Debug, Subcommand)]
pub enum Command {
    /// Play a scene in a window; save the file and the picture follows
    #[cfg(feature = "window")]
    Run(RunArgs),
    /// Write frames as PNG files
    #[cfg(feature = "gpu")]
    Export(ExportArgs),
    /// Hold variants of a scene against a reference: error against run time
    #[cfg(feature = "gpu")]
    Measure(MeasureArgs),
    /// Put a scene to extreme times, sizes, mice and frame numbers, and say where it breaks
    #[cfg(feature = "gpu")]
    Stability(StabilityArgs),
    /// Say what is wrong with scenes, without a GPU
    Check(CheckArgs),
    /// Write a scene's shader in another language
    Translate(TranslateArgs),
    /// Say what a scene uses, and what was therefore left out
    Inspect(InspectArgs),
    /// List the site's media, and which of them are stand-ins
    Media(MediaListArgs),
    /// Write a scene folder of a shader in ShaderToy's JSON
    Import(ImportArgs),
    /// Write a scene folder as ShaderToy's JSON
    Pack(PackArgs),
    /// List the graphics adapters, and what to install when there is none
    #[cfg(feature = "gpu")]
    Doctor,
}

#[cfg(feature = "gpu")]
const LOWP_HELP: &str = "Round texels, and what is computed of texels and constants alone, to 16 bits, as Mesa's CPU driver \
     does for WebGL: samplers are `lowp` there. Other GPUs of 16 bits, as in phones, are similar";

const SCENE_HELP: &str = "A file of ShaderToy GLSL or JSON, a scene folder, a shader's id or address on shadertoy.com, \
     or `-` for standard input";

#[cfg(feature = "gpu")]
const SANITIZE_HELP: &str = "Look for what GLSL leaves undefined and for what is suspicious: divisions by zero, \
     roots of negatives, indices out of range, variables that are not set, where NaN comes from …";

#[cfg(feature = "window")]
#[derive(Debug, Args)]
#[command(after_help = "Keys:\n  \
    space, pause  stop time, go on       S       save the picture as PNG\n  \
    . ,           a frame on, back       F       full screen\n  \
    R             back to the start      M       sound off, on\n  \
    Esc           leave                  Ctrl+V  play the clipboard's text\n  \
    mouse         is iMouse              drop a file to open it\n\n\
    Where the scene reads the keyboard, the keys are the scene's: press Ctrl with them, but for Esc.")]
pub struct RunArgs {
    #[arg(help = format!("{SCENE_HELP} [default: a scene that comes with the program]"))]
    pub scene: Option<PathBuf>,
    /// Size of the window's picture in pixels [default: the scene's own, or 960x540]
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Pixels drawn for each pixel of the window's width and height, from 0.05 to 4
    #[arg(long, value_name = "FACTOR", default_value = "1", value_parser = scale)]
    pub scale: f64,
    /// Draw at most this many frames per second [default: the display's rate]
    #[arg(long, value_name = "N", value_parser = positive)]
    pub fps_limit: Option<f64>,
    /// The local date and time of the first frame, as in 2026-11-25T12:00:00 [default: now]
    #[arg(long, value_name = "DATE")]
    pub date: Option<String>,
    /// Record mouse and keys for `vitrine export --input`
    #[arg(long, value_name = "FILE")]
    pub record_input: Option<PathBuf>,
    /// Replace the recording if it exists already
    #[arg(long, requires = "record_input")]
    pub overwrite: bool,
    /// Do not watch the files for changes
    #[arg(long)]
    pub no_watch: bool,
    /// Begin without sound
    #[arg(long)]
    pub mute: bool,
    #[arg(long, help = LOWP_HELP)]
    pub lowp: bool,
    #[arg(long, help = SANITIZE_HELP)]
    pub sanitize: bool,
    #[command(flatten)]
    pub web: WebArgs,
    #[command(flatten)]
    pub define: DefineArgs,
    #[command(flatten)]
    pub inputs: InputArgs,
    #[command(flatten)]
    pub gpu: GpuArgs,
}

#[cfg(feature = "gpu")]
#[derive(Debug, Args)]
pub struct ExportArgs {
    #[arg(help = SCENE_HELP)]
    pub scene: PathBuf,
    /// Where to write, as PNG or EXR: `%d` or `%05d` stands for the frame number, `%%` for a percent sign
    #[arg(long, short, value_name = "PATTERN", required_unless_present = "sound")]
    pub out: Option<String>,
    /// Write the sound of the Sound pass instead, as WAV with 44,100 samples a second
    #[arg(long, value_name = "FILE.wav", conflicts_with_all = ["out", "time", "probe", "count", "stats", "sanitize"])]
    pub sound: Option<PathBuf>,
    /// How long the sound is [default: as long as the frames, or 180]
    #[arg(long, value_name = "N", value_parser = positive, requires = "sound", conflicts_with = "frames")]
    pub seconds: Option<f64>,
    /// What the samples of the sound are
    #[arg(long, value_enum, value_name = "FORMAT", default_value_t = SoundFormat::Pcm16)]
    pub sound_format: SoundFormat,
    /// The frames, by number: from A up to, not including, B [default: frame 0 alone]
    #[arg(long, value_name = "A..B", conflicts_with = "time")]
    pub frames: Option<FrameRange>,
    /// The one frame at this time in seconds
    #[arg(long, value_name = "T", value_parser = time, allow_negative_numbers = true)]
    pub time: Option<f64>,
    /// Frames per second: frame n is drawn with iTime = n/N. With `--input`, the recording's by default
    /// [default: 60]
    #[arg(long, value_name = "N", value_parser = positive)]
    pub fps: Option<f64>,
    /// Size of the pictures in pixels [default: the scene's own, or 1280x720]
    #[arg(long, value_name = "WxH")]
    pub size: Option<Size>,
    /// Replay mouse and keys that `vitrine run --record-input` recorded
    #[arg(long, value_name = "FILE", conflicts_with = "mouse")]
    pub input: Option<PathBuf>,
    /// `iMouse` in every frame, in pixels from the bottom left; without Z and W held down at X,Y
    #[arg(long, value_name = "X,Y[,Z,W]", allow_hyphen_values = true)]
    pub mouse: Option<Mouse>,
    /// The local date and time in every frame [default: 2024-01-01T12:00:00]
    #[arg(long, value_name = "DATE")]
    pub date: Option<String>,
    /// Replace files that exist already
    #[arg(long)]
    pub overwrite: bool,
    /// Write these values too, as channels of EXR files; in PNG files, one instead of the colour. A
    /// value is a variable of the entry point, `FUNCTION.NAME` or `FUNCTION()`
    #[arg(long, value_name = "NAME,…", value_delimiter = ',')]
    pub probe: Vec<String>,
    /// Count the rounds of loops: a heat map as PNG, or a channel of EXR files
    #[arg(long, value_enum, value_name = "WHAT")]
    pub count: Option<Count>,
    /// What to compute in
    #[arg(long, value_enum, default_value_t = Precision::F32)]
    pub precision: Precision,
    #[arg(long, help = LOWP_HELP, conflicts_with = "precision")]
    pub lowp: bool,
    #[arg(long, help = SANITIZE_HELP)]
    pub sanitize: bool,
    /// Write where the time went, as JSON
    #[arg(long, value_name = "FILE.json")]
    pub stats: Option<PathBuf>,
    #[command(flatten)]
    pub web: WebArgs,
    #[command(flatten)]
    pub define: DefineArgs,
    #[command(flatten)]
    pub inputs: InputArgs,
    #[command(flatten)]
    pub gpu: GpuArgs,
}

#[cfg(feature = "gpu")]
#[derive(Debug, Args)]
pub struct MeasureArgs {
    /// A study in TOML, or with `--vary` a scene
    pub study: PathBuf,
    /// The folder for report, tables and plots [default: the study's name and `-report`]
    #[arg(long, short, value_name = "DIR")]
    pub out: Option<PathBuf>,
    /// Give a macro these values in turn; of several macros every combination
    #[arg(long, value_name = "NAME=A,B,…", value_parser = vary, requires = "reference")]
    pub vary: Vec<(String, Vec<String>)>,
    /// The macros of the reference, which is computed in 64 bits
    #[arg(long, value_name = "NAME=VALUE,…", value_parser = define::define, value_delimiter = ',', requires = "vary")]
    pub reference: Vec<(String, String)>,
    /// Compare this value too: a variable of the entry point, `FUNCTION.NAME` or `FUNCTION()`
    #[arg(long, value_name = "NAME", requires = "vary")]
    pub probe: Option<String>,
    /// The moments, `iTime` in seconds
    #[arg(long, value_name = "T", value_parser = time, value_delimiter = ',', requires = "vary")]
    pub times: Vec<f64>,
    /// Size of the pictures in pixels
    #[arg(long, value_name = "WxH", requires = "vary")]
    pub size: Option<Size>,
    /// How often each variant is timed [default: 5, or as the study says]
    #[arg(long, value_name = "N", value_parser = RangedU64ValueParser::<u32>::new().range(1..=1000))]
    pub repeats: Option<u32>,
    /// Do not go on from what an earlier run left in the folder
    #[arg(long)]
    pub fresh: bool,
    #[command(flatten)]
    pub media: MediaArgs,
    #[command(flatten)]
    pub gpu: GpuArgs,
}

#[cfg(feature = "gpu")]
#[derive(Debug, Args)]
pub struct StabilityArgs {
    #[arg(help = SCENE_HELP)]
    pub scene: PathBuf,
    /// Give a macro these values in turn, too
    #[arg(long, value_name = "NAME=A,B,…", value_parser = vary)]
    pub vary: Vec<(String, Vec<String>)>,
    #[arg(long, help = SANITIZE_HELP)]
    pub sanitize: bool,
    /// How to write the verdicts
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    /// The same as `--format json`
    #[arg(long, conflicts_with = "format")]
    pub json: bool,
    #[command(flatten)]
    pub web: WebArgs,
    #[command(flatten)]
    pub define: DefineArgs,
    #[command(flatten)]
    pub inputs: InputArgs,
    #[command(flatten)]
    pub gpu: GpuArgs,
}

#[cfg(feature = "gpu")]
#[derive(Debug, Args)]
pub struct GpuArgs {
    /// The graphics adapter: part of its name, `cpu` or `gpu`
    #[arg(long, value_name = "NAME|cpu|gpu")]
    pub adapter: Option<String>,
    /// Give up when one frame takes longer than this many seconds; 0 waits for ever
    #[arg(long, value_name = "SECONDS", default_value = "60", value_parser = not_negative)]
    pub frame_timeout: f64,
}

#[derive(Clone, Copy, Debug, Args)]
pub struct WebArgs {
    /// Fetch a shader of the site again that was fetched before
    #[arg(long)]
    pub refresh: bool,
}

#[derive(Clone, Debug, Args)]
pub struct MediaArgs {
    /// A folder with copies of the site's media, which are used in place of stand-ins
    #[arg(long, value_name = "DIR", env = "VITRINE_MEDIA")]
    pub media: Option<PathBuf>,
    /// Make nothing up: a channel reads (0, 0, 0, 1) where a copy is missing
    #[arg(long)]
    pub no_stand_ins: bool,
}

#[cfg(feature = "gpu")]
#[derive(Clone, Debug, Args)]
pub struct InputArgs {
    #[command(flatten)]
    pub media: MediaArgs,
    /// Bind a channel to a file, one of the site's media, keyboard, mic, webcam or noise. Of another pass than Image, put
    /// its name ahead, as in A.0=clip.mp4
    #[arg(long, value_name = "[PASS.]N=FILE")]
    pub channel: Vec<String>,
}

#[derive(Clone, Debug, Args)]
pub struct DefineArgs {
    /// Define a macro, whatever the text defines it as; without a value it is 1
    #[arg(long, short = 'D', value_name = "NAME[=VALUE]", value_parser = define::define)]
    pub define: Vec<(String, String)>,
}

const CHECK_HELP: &str = "Files of ShaderToy GLSL or JSON, scene folders, folders of such, \
                          shaders' ids or addresses on shadertoy.com, or `-` for standard input";

#[derive(Debug, Args)]
pub struct CheckArgs {
    #[arg(help = CHECK_HELP, required_unless_present_any = ["list", "worker"])]
    pub scenes: Vec<PathBuf>,
    /// Check the scenes that this file names too, one a line; `-` is standard input
    #[arg(long, value_name = "FILE")]
    pub list: Option<PathBuf>,
    /// Refuse what WebGL2 refuses, also where it could be drawn
    #[arg(long)]
    pub strict: bool,
    /// Print only how many scenes got which verdict
    #[arg(long)]
    pub summary: bool,
    /// Check this many scenes at once [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = RangedU64ValueParser::<u16>::new().range(1..=1024))]
    pub jobs: Option<u16>,
    /// Cut off a scene that takes longer [default: 8]
    #[arg(long, value_name = "SECONDS", value_parser = RangedU64ValueParser::<u32>::new().range(1..=86_400))]
    pub timeout: Option<u32>,
    /// Cut off a scene that takes more memory [default: 2048]
    #[arg(long, value_name = "MIB", value_parser = RangedU64ValueParser::<u64>::new().range(1..=1 << 24))]
    pub memory: Option<u64>,
    /// Answer another process
    #[arg(long, hide = true)]
    pub worker: bool,
    #[command(flatten)]
    pub web: WebArgs,
    #[command(flatten)]
    pub define: DefineArgs,
    /// How to write what was found
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct TranslateArgs {
    #[arg(help = SCENE_HELP)]
    pub scene: PathBuf,
    /// The language to write
    #[arg(long, value_enum, value_name = "LANGUAGE")]
    pub to: Language,
    /// The pass to write, by its name on the site
    #[arg(long, value_name = "NAME", default_value = "Image")]
    pub pass: String,
    /// Write to a file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
    #[command(flatten)]
    pub web: WebArgs,
    #[command(flatten)]
    pub define: DefineArgs,
}

#[derive(Debug, Args)]
pub struct InspectArgs {
    #[arg(help = SCENE_HELP)]
    pub scene: PathBuf,
    /// How to write it
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
    #[command(flatten)]
    pub web: WebArgs,
    #[command(flatten)]
    pub define: DefineArgs,
}

#[derive(Debug, Args)]
pub struct MediaListArgs {
    #[command(flatten)]
    pub media: MediaArgs,
    /// Write the pictures that are shown for them into this folder, to look at
    #[arg(long, value_name = "DIR")]
    pub write: Option<PathBuf>,
    /// How to write the list
    #[arg(long, value_enum, default_value_t = Format::Human)]
    pub format: Format,
}

#[derive(Debug, Args)]
pub struct ImportArgs {
    /// A shader in ShaderToy's JSON, or `-` for standard input
    pub shader: PathBuf,
    /// The folder to write
    #[arg(long, value_name = "DIR")]
    pub into: PathBuf,
    /// Write into a folder that is not empty; files of other names stay
    #[arg(long)]
    pub overwrite: bool,
}

#[derive(Debug, Args)]
pub struct PackArgs {
    /// A scene folder
    pub folder: PathBuf,
    /// Write to a file instead of standard output
    #[arg(long, short, value_name = "FILE")]
    pub out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Format {
    /// For people
    Human,
    /// For tools: one JSON object a line
    Json,
}

#[cfg(feature = "gpu")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Count {
    /// Rounds of all loops
    Loops,
}

#[cfg(feature = "gpu")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum SoundFormat {
    /// Integers of 16 bits, which every program plays
    #[value(name = "16")]
    Pcm16,
    /// Floats of 32 bits, as the shader gives them
    Float,
}

#[cfg(feature = "gpu")]
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Precision {
    /// 32-bit floats, as browsers do
    F32,
    /// 64-bit floats throughout, where the adapter has them
    F64,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Language {
    Wgsl,
    Spirv,
    Glsl,
    Hlsl,
    Msl,
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_definitions_are_consistent() {
        <Cli as clap::CommandFactory>::command().debug_assert();
    }
}
