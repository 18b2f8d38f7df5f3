//! Vitrine runs ShaderToy GLSL: unchanged, live and frame by frame.
#[cfg(feature = "gpu")]
pub mod export;
pub mod frame;
#[cfg(feature = "gpu")]
pub mod output;
#[cfg(feature = "gpu")]
pub mod render;
pub mod report;
pub mod scene;
#[cfg(feature = "gpu")]
pub mod session;
pub mod source;
pub mod translate;
#[cfg(feature = "window")]
pub mod window;
