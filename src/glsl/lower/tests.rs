//! Small programs, built by hand, through naga's validator, our own and every writer.

mod builtins;
mod program;
mod statements;
mod values;

use std::num::NonZeroU32;

use naga::back;
use naga::valid::{Capabilities, ModuleInfo, ValidationFlags, Validator};

use super::{Checks, HostSampler, Interface, Lowered, Options, Output, lower, verify};
use crate::glsl::hir::Hir;
use crate::glsl::prune::Reachable;
use crate::glsl::types::{Base, Scalar, Type};
use crate::glsl::{Arithmetic, Precision, double};

const FLOAT: Type = Type::FLOAT;
const INT: Type = Type::INT;
const BOOL: Type = Type::BOOL;

fn vec(size: u8) -> Type {
    Type::vector(Scalar::Float, size)
}

fn array(ty: Type, length: u32) -> Type {
    Type {
        array: NonZeroU32::new(length),
        base: match ty.base {
            Base::Void => unreachable!("there are no arrays of nothing"),
            base => base,
        },
    }
}

fn interface() -> Interface {
    Interface {
        group: 0,
        block: 0,
        uniforms: [
            "iResolution",
            "iTime",
            "iChannelTime",
            "iFrame",
            "iMatrix",
            "iOn",
        ]
        .map(str::to_owned)
        .to_vec(),
        block_size: 1024,
        samplers: (0..3)
            .map(|i| HostSampler {
                name: format!("iChannel{i}"),
                texture: 1 + 2 * i,
                sampler: 2 + 2 * i,
            })
            .collect(),
        tables: 9,
        findings: 10,
    }
}

/// Lowers a program, which must pass the validators.
fn lowered(hir: &Hir, precision: Precision) -> (Lowered, ModuleInfo) {
    lowered_with(hir, precision, Arithmetic::Compact)
}

fn lowered_with(hir: &Hir, precision: Precision, arithmetic: Arithmetic) -> (Lowered, ModuleInfo) {
    let interface = interface();
    let double_functions = double::Functions::default();
    let options = Options {
        precision,
        arithmetic,
        output: Output::Colour,
        round_budget: None,
        round_limit: None,
        low_samplers: false,
        interface: &interface,
        unit_0: None,
        checks: Checks::None,
        double_functions: &double_functions,
    };
    let reachable = Reachable::new(hir, &double_functions);
    let mut lowered = lower(hir, &reachable, &options);
    verify::verify(&lowered.module).expect("well-formed IR");
    naga::compact::compact(&mut lowered.module, naga::compact::KeepUnused::No);
    let info = Validator::new(ValidationFlags::all(), Capabilities::all())
        .validate(&lowered.module)
        .unwrap_or_else(|error| panic!("{}\n{:#?}", error.emit_to_string(""), lowered.module));
    (lowered, info)
}

/// Lowers a program in 32 bits, writes it in every language, and returns the WGSL, once with its
/// arithmetic expanded and once without.
fn wgsl_in_both(hir: &Hir) -> [String; 2] {
    [Arithmetic::Expanded, Arithmetic::Compact].map(|arithmetic| {
        let (lowered, info) = lowered_with(hir, Precision::Single, arithmetic);
        write_all(&lowered.module, &info)
    })
}

/// The same; only the WGSL with compact arithmetic.
fn wgsl(hir: &Hir) -> String {
    let [_, compact] = wgsl_in_both(hir);
    compact
}

fn write_all(module: &naga::Module, info: &ModuleInfo) -> String {
    back::spv::write_vec(module, info, &back::spv::Options::default(), None).expect("SPIR-V");
    let options = back::hlsl::Options {
        shader_model: back::hlsl::ShaderModel::V6_0,
        fake_missing_bindings: true,
        ..Default::default()
    };
    back::hlsl::Writer::new(&mut String::new(), &options, &Default::default())
        .write(module, info, None)
        .expect("HLSL");
    let options = back::msl::Options {
        lang_version: (2, 4),
        fake_missing_bindings: true,
        ..Default::default()
    };
    back::msl::write_string(module, info, &options, &Default::default()).expect("MSL");
    let options = back::glsl::Options {
        version: back::glsl::Version::new_gles(310),
        ..Default::default()
    };
    let pipeline = back::glsl::PipelineOptions {
        shader_stage: naga::ShaderStage::Fragment,
        entry_point: "main".to_owned(),
        multiview: None,
    };
    let mut text = String::new();
    back::glsl::Writer::new(
        &mut text,
        module,
        info,
        &options,
        &pipeline,
        Default::default(),
    )
    .and_then(|mut writer| writer.write())
    .expect("GLSL");
    back::wgsl::write_string(module, info, back::wgsl::WriterFlags::empty()).expect("WGSL")
}
