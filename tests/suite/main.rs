//! The integration tests: each module has one subject, and adding a test means adding a file.
//!
//! - A test that draws asks [`support::gpu`] first. Without a graphics adapter it says that it was
//!   skipped and passes; with `REQUIRE_GPU=1` it fails.
//! - Golden pictures and texts lie in `tests/goldens`, `tests/messages` and `tests/glsl`. `BLESS=1 cargo test`
//!   accepts what the program makes now; look at it before committing it.

mod arithmetic;
mod bad_folder;
mod bad_input;
mod check_many;
mod codes;
mod define;
mod directives;
mod forms;
mod fuzz;
mod glsl_lenient;
mod glsl_refuse;
mod glsl_warn;
mod json_scenes;
mod layering;
mod messages;
mod pack;
mod seeds;
mod support;
mod translate;
mod usage;
mod verdicts;

#[cfg(feature = "gpu")]
mod bad_output;
#[cfg(feature = "gpu")]
mod bands;
#[cfg(feature = "gpu")]
mod binding;
#[cfg(feature = "gpu")]
mod buffers;
#[cfg(feature = "gpu")]
mod channels;
#[cfg(feature = "gpu")]
mod clock;
#[cfg(feature = "gpu")]
mod closed_forms;
#[cfg(feature = "gpu")]
mod colours;
#[cfg(feature = "gpu")]
mod double;
#[cfg(feature = "gpu")]
mod double_functions;
#[cfg(feature = "gpu")]
mod export;
#[cfg(feature = "gpu")]
mod glsl_accept;
#[cfg(all(feature = "gpu", unix))]
mod interrupt;
#[cfg(feature = "gpu")]
mod leave_out;
#[cfg(feature = "gpu")]
mod lipschitz;
#[cfg(feature = "gpu")]
mod measure;
#[cfg(feature = "gpu")]
mod media;
#[cfg(feature = "gpu")]
mod orientation;
#[cfg(feature = "gpu")]
mod outputs;
#[cfg(feature = "gpu")]
mod reload;
#[cfg(feature = "gpu")]
mod sanitize;
#[cfg(feature = "gpu")]
mod scenes;
#[cfg(feature = "gpu")]
mod script;
#[cfg(feature = "gpu")]
mod stability;
#[cfg(feature = "web")]
mod web;
#[cfg(feature = "gpu")]
mod webgl2;
#[cfg(all(feature = "window", target_os = "linux"))]
mod window;
