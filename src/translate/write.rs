//! A program as text or binary in the languages of graphics drivers.

use naga::back;

use super::{Program, guard};
use crate::source::Diagnostic;

/// A language that a program can be written in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Language {
    /// WebGPU's shading language.
    Wgsl,
    /// SPIR-V 1.3, little-endian, with names.
    Spirv,
    /// GLSL ES 3.10.
    Glsl,
    /// HLSL for shader model 6.0.
    Hlsl,
    /// Metal Shading Language 2.4.
    Msl,
}

/// Writes a program's fragment shader. Text is UTF-8.
pub fn write(program: &Program, language: Language) -> Result<Vec<u8>, Diagnostic> {
    let program = program.clone();
    guard::guarded(move || match language {
        Language::Wgsl => wgsl(&program),
        Language::Spirv => spirv(&program),
        Language::Glsl => glsl(&program),
        Language::Hlsl => hlsl(&program),
        Language::Msl => msl(&program),
    })
    .unwrap_or_else(|failure| Err(failure.diagnostic().message))
    .map_err(|message| {
        Diagnostic::error(
            "unwritable",
            format!("{language:?} cannot express this: {message}"),
        )
        .hint("try another language; `--to spirv` is what Vulkan is given")
    })
}

fn wgsl(program: &Program) -> Result<Vec<u8>, String> {
    back::wgsl::write_string(
        &program.module,
        &program.info,
        back::wgsl::WriterFlags::empty(),
    )
    .map(String::into_bytes)
    .map_err(|error| error.to_string())
}

pub(super) fn spirv(program: &Program) -> Result<Vec<u8>, String> {
    let mut options = back::spv::Options {
        lang_version: (1, 3),
        ..Default::default()
    };
    // The picture's first row is its bottom row all the way; nothing is to be turned here.
    options
        .flags
        .remove(back::spv::WriterFlags::ADJUST_COORDINATE_SPACE);
    let words = back::spv::write_vec(&program.module, &program.info, &options, None)
        .map_err(|error| error.to_string())?;
    Ok(words.into_iter().flat_map(u32::to_le_bytes).collect())
}

fn glsl(program: &Program) -> Result<Vec<u8>, String> {
    let options = back::glsl::Options {
        version: back::glsl::Version::new_gles(310),
        ..Default::default()
    };
    let pipeline = back::glsl::PipelineOptions {
        shader_stage: naga::ShaderStage::Fragment,
        entry_point: Program::ENTRY_POINT.to_owned(),
        multiview: None,
    };
    let mut text = String::new();
    back::glsl::Writer::new(
        &mut text,
        &program.module,
        &program.info,
        &options,
        &pipeline,
        Default::default(),
    )
    .and_then(|mut writer| writer.write())
    .map_err(|error| error.to_string())?;
    Ok(text.into_bytes())
}

fn hlsl(program: &Program) -> Result<Vec<u8>, String> {
    let options = back::hlsl::Options {
        shader_model: back::hlsl::ShaderModel::V6_0,
        fake_missing_bindings: true,
        ..Default::default()
    };
    let pipeline = Default::default();
    let mut text = String::new();
    back::hlsl::Writer::new(&mut text, &options, &pipeline)
        .write(&program.module, &program.info, None)
        .map_err(|error| error.to_string())?;
    Ok(text.into_bytes())
}

fn msl(program: &Program) -> Result<Vec<u8>, String> {
    let options = back::msl::Options {
        lang_version: (2, 4),
        fake_missing_bindings: true,
        ..Default::default()
    };
    back::msl::write_string(
        &program.module,
        &program.info,
        &options,
        &Default::default(),
    )
    .map(|(text, _)| text.into_bytes())
    .map_err(|error| error.to_string())
}
