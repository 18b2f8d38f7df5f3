//! Vitrine runs ShaderToy GLSL: unchanged, live and frame by frame.
//!
//! A scene goes through the same four steps wherever it is drawn:
//!
//! ```text
//! path ─load─► Scene ─translate─► Program(s) ─build─► Renderer ─render(FrameInput)─► FrameImage
//! ```
//!
//! [`scene::load`] reads it, [`translate::translate`] turns its GLSL into validated naga IR,
//! `render::Renderer` draws it with wgpu; `session::Session` is all three, and `export` and
//! `window` are what it is for. What is wrong with a scene comes back as
//! [`source::Diagnostic`]s that point into the author's own files; [`report`] draws them.
//!
//! Without the feature `gpu` the steps up to [`translate`] remain, for checking scenes where nothing
//! can be drawn. `docs/ARCHITECTURE.md` explains the rooms and which of them may use which.

pub mod config;
#[cfg(feature = "gpu")]
pub mod export;
pub mod frame;
pub mod glsl;
pub mod input_script;
#[cfg(feature = "gpu")]
pub mod measure;
pub mod media;
pub mod output;
#[cfg(feature = "gpu")]
pub mod render;
pub mod report;
pub mod scene;
#[cfg(feature = "gpu")]
pub mod session;
pub mod source;
pub mod translate;
pub mod web;
#[cfg(feature = "window")]
pub mod window;
