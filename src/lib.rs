//! Vitrine runs ShaderToy GLSL: unchanged, live and frame by frame.
pub mod frame;
pub mod scene;
pub mod source;
pub mod translate;
pub mod report;
#[cfg(feature = "gpu")]
pub mod render;
#[cfg(feature = "gpu")]
pub mod session;
#[cfg(feature = "gpu")]
pub mod export;
