//! The GLSL ES 3.00 front end, as far as it stands: the preprocessor.
//!
//! It knows GLSL and nothing of ShaderToy, of GPUs or of the file system.

pub mod preprocess;
