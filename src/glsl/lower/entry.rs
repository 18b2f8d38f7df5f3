//! The entry point: `main` between the machine's position and colour.

use naga::{BuiltIn, Span};

use super::constant::Part;
use super::context::{Binding, Context, Nulls};
use super::function::{Builder, Entry, H};
use crate::glsl::hir::{Extent, GlobalKind};
use crate::glsl::types::{Base, Scalar, Type};

impl Context<'_> {
    pub fn add_entry_point(&mut self) {
        let hir = self.hir;
        let main = hir.main.expect("a checked program has a main");
        let initialisers = hir
            .initialisers
            .filter(|_| self.reachable.initialised)
            .map(|id| self.function(id, Nulls::new()));
        let color = naga::Type {
            name: None,
            inner: naga::TypeInner::Vector {
                size: naga::VectorSize::Quad,
                scalar: naga::Scalar::F32,
            },
        };
        let color = self.module.types.insert(color, Span::UNDEFINED);
        let mut builder = Builder::new(self, main);
        let position = builder.add_argument(Some("position".to_owned()), color);
        builder.function.arguments[0].binding = Some(naga::Binding::BuiltIn(BuiltIn::Position {
            invariant: false,
        }));
        builder.function.result = Some(naga::FunctionResult {
            ty: color,
            binding: Some(naga::Binding::Location {
                location: 0,
                interpolation: None,
                sampling: None,
                blend_src: None,
                per_primitive: false,
            }),
        });
        builder.note_pixel(position);
        let position = builder.widen(position);
        builder.entry = Some(Entry { position });
        builder.set_globals(position);
        if let Some(function) = initialisers {
            builder.push(naga::Statement::Call {
                function,
                arguments: Vec::new(),
                result: None,
            });
        }
        let source = builder.source;
        builder.span = builder.span_of(Extent::of(source.at));
        builder.body(&source.body);
        let function = builder.finish();
        self.module.entry_points.push(naga::EntryPoint {
            name: "main".to_owned(),
            stage: naga::ShaderStage::Fragment,
            early_depth_test: None,
            workgroup_size: [0; 3],
            workgroup_size_overrides: None,
            function,
            mesh_info: None,
            task_payload: None,
            incoming_ray_payload: None,
        });
    }
}

impl Builder<'_, '_> {
    /// Sets the global variables that no constant expression of naga's can.
    fn set_globals(&mut self, position: H) {
        let hir = self.context.hir;
        for &id in &self.context.reachable.globals {
            let Some(&Binding::Variable(variable)) = self.context.globals.get(&id) else {
                continue;
            };
            let global = &hir.globals[id];
            match global.kind {
                GlobalKind::FragCoord => {
                    let pointer = self.global(variable);
                    self.store(pointer, position);
                }
                GlobalKind::Private(Some(constant))
                    if self.context.module.global_variables[variable]
                        .init
                        .is_none() =>
                {
                    let pointer = self.global(variable);
                    self.store_constant(pointer, Part::whole(constant), global.ty);
                }
                _ => {}
            }
        }
    }

    /// The colour of the pixel, or what is asked for in its place.
    pub fn output(&mut self) -> H {
        let hir = self.context.hir;
        let color = Type::vector(Scalar::Float, 4);
        let output = || {
            self.context.reachable.globals.iter().find_map(|id| {
                let global = &hir.globals[*id];
                match (global.kind, self.context.globals.get(id)) {
                    (GlobalKind::Output(0), Some(&Binding::Variable(variable))) => {
                        Some((variable, global.ty))
                    }
                    _ => None,
                }
            })
        };
        let Some((variable, ty)) = self.recorded().or_else(output) else {
            let zero = self.zero(color);
            return self.narrow(zero);
        };
        let mut pointer = self.global(variable);
        if ty.is_array() {
            pointer = self.part(pointer, 0);
        }
        let value = self.load(pointer);
        let (scalar, count) = match ty.base {
            Base::Scalar(scalar) => (scalar, 1),
            Base::Vector(scalar, count) => (scalar, count),
            _ => unreachable!("outputs are scalars and vectors"),
        };
        let value = self.convert(value, scalar, Scalar::Float);
        let value = if count == 4 {
            value
        } else {
            let mut components = vec![value];
            for i in count..4 {
                components.push(self.float(f64::from(u8::from(i == 3))));
            }
            self.compose(color, components)
        };
        self.narrow(value)
    }

    /// `gl_FragCoord` where it is at hand without a variable.
    pub fn position(&self, kind: GlobalKind) -> Option<H> {
        (kind == GlobalKind::FragCoord).then_some(self.entry?.position)
    }
}
