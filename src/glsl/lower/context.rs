//! What the functions of a program share while it is lowered.

use naga::{AddressSpace, Handle, Span};
use rustc_hash::{FxHashMap, FxHashSet};
use smallvec::{SmallVec, smallvec};

use super::constant::Part;
use super::function::Room;
use super::output::{self, Record};
use super::sanitize::Sanitizer;
use super::table::TableBuilder;
use super::types::is_opaque;
use super::{Excess, Lowered, Options, Unguarded, UniformBlock};
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{
    Constant, Direction, Expr, ExprKind, Extent, Function, Global, GlobalKind, Hir, Local,
};
use crate::glsl::prune::Reachable;
use crate::glsl::types::{Scalar, Type};

pub(super) struct Context<'a> {
    pub hir: &'a Hir,
    pub reachable: &'a Reachable,
    pub options: &'a Options<'a>,
    pub module: naga::Module,
    pub types: FxHashMap<Type, Handle<naga::Type>>,
    /// The alignments of structures.
    pub alignments: FxHashMap<Handle<naga::Type>, naga::proc::Alignment>,
    pub globals: FxHashMap<Id<Global>, Binding>,
    /// The host's textures that are declared, by the binding of each.
    images: Vec<(u32, Binding)>,
    /// What has been lowered: functions in their forms.
    pub functions: FxHashMap<(Id<Function>, Nulls), Handle<naga::Function>>,
    /// Whether a function other than `main` asks for `gl_FragCoord`.
    pub shares_position: bool,
    /// The parameters of which not only the texture is used but also the sampler.
    pub sampled: FxHashSet<(Id<Function>, Id<Local>)>,
    /// Constant arrays that are variables so that they can be indexed.
    pub arrays: FxHashMap<(Part, Type), Handle<naga::GlobalVariable>>,
    pub tables: TableBuilder,
    pub uniforms: Option<UniformBlock>,
    pub unguarded: Unguarded,
    /// Every loop, in the order of the text, and whether it is known to end.
    pub loops: Vec<(Extent, bool)>,
    /// What is given for a pixel instead of its colour.
    pub record: Record,
    /// Whether the pixel has been discarded, if any loop asks.
    pub discarded: Option<Handle<naga::GlobalVariable>>,
    /// What is looked at, and where findings are noted.
    pub sanitizer: Sanitizer,
    /// What the next function's builder begins with.
    pub room: Room,
    /// How many expressions there are in all functions.
    pub operations: usize,
    /// Set when the program is more than can be borne; no more statements are lowered then.
    pub excess: Option<Excess>,
}

/// Which of a function's parameters are samplers without texture.
pub(super) type Nulls = SmallVec<[bool; 16]>;

/// What stands for a global variable.
#[derive(Clone, Copy, Debug)]
pub(super) enum Binding {
    /// A variable in naga's private space.
    Variable(Handle<naga::GlobalVariable>),
    /// A value that no one changes.
    Constant(Id<Constant>),
    /// A value that no one gives.
    Zero,
    /// `true`
    True,
    /// A member of the uniform block.
    Uniform(Handle<naga::GlobalVariable>, u32),
    /// A texture and what it is read through.
    Image(Handle<naga::GlobalVariable>, Handle<naga::GlobalVariable>),
}

impl<'a> Context<'a> {
    pub fn new(hir: &'a Hir, reachable: &'a Reachable, options: &'a Options<'a>) -> Self {
        let mut context = Context {
            hir,
            reachable,
            options,
            module: naga::Module::default(),
            types: FxHashMap::default(),
            alignments: FxHashMap::default(),
            globals: FxHashMap::default(),
            images: Vec::new(),
            functions: FxHashMap::default(),
            shares_position: false,
            sampled: FxHashSet::default(),
            arrays: FxHashMap::default(),
            tables: TableBuilder::default(),
            uniforms: None,
            unguarded: Unguarded::default(),
            loops: output::loops(hir, reachable),
            record: Record::default(),
            discarded: None,
            sanitizer: Sanitizer::default(),
            room: Room::default(),
            operations: 0,
            excess: None,
        };
        for (id, expressions) in reachable.bodies() {
            context.analyse(id, expressions);
        }
        context.add_uniforms();
        context.add_record();
        context.add_discarded();
        context.add_findings();
        for &id in &reachable.globals {
            context.add_global(id);
        }
        context
    }

    /// Notes what has to be known of a function before any is lowered, but for those it calls.
    fn analyse(&mut self, id: Id<Function>, expressions: &[Id<Expr>]) {
        let hir = self.hir;
        let function = &hir.functions[id];
        for &expr in expressions {
            let Expr { kind, ty, .. } = function.exprs[expr];
            match kind {
                ExprKind::Constant(constant) => self.reserve_table(constant, ty),
                ExprKind::Global(global) if hir.main != Some(id) => {
                    self.shares_position |= hir.globals[global].kind == GlobalKind::FragCoord;
                }
                ExprKind::Builtin(builtin, operands) if samples(builtin) => {
                    let sampler = function.operands.get(operands)[0];
                    if let ExprKind::Local(local) = last(function, sampler) {
                        self.sampled.insert((id, local));
                    }
                }
                ExprKind::Call(callee, operands) => {
                    for (i, &operand) in function.operands.get(operands).iter().enumerate() {
                        if let ExprKind::Local(local) = last(function, operand)
                            && self.sampled.contains(&(callee, Id::new(i)))
                        {
                            self.sampled.insert((id, local));
                        }
                    }
                }
                _ => {}
            }
        }
    }

    fn add_global(&mut self, id: Id<Global>) {
        let global = &self.hir.globals[id];
        let written = self.reachable.written.contains(id);
        let binding = match global.kind {
            GlobalKind::Private(Some(constant)) if !written => {
                self.reserve_table(constant, global.ty);
                Binding::Constant(constant)
            }
            GlobalKind::Private(None) if !written => Binding::Zero,
            GlobalKind::Private(init) => {
                let init = init.and_then(|constant| {
                    self.reserve_table(constant, global.ty);
                    self.global_expression(Part::whole(constant), global.ty)
                });
                Binding::Variable(self.add_variable(id, init))
            }
            // The block has got those that the host knows.
            GlobalKind::Uniform if self.globals.contains_key(&id) => return,
            GlobalKind::Uniform => self.sampler_uniform(id),
            GlobalKind::Input | GlobalKind::PointCoord => Binding::Zero,
            GlobalKind::FragCoord if !self.shares_position => return,
            GlobalKind::FrontFacing => Binding::True,
            GlobalKind::Output(_) | GlobalKind::FragCoord | GlobalKind::FragDepth => {
                Binding::Variable(self.add_variable(id, None))
            }
        };
        self.globals.insert(id, binding);
    }

    fn add_variable(
        &mut self,
        id: Id<Global>,
        init: Option<Handle<naga::Expression>>,
    ) -> Handle<naga::GlobalVariable> {
        let global = &self.hir.globals[id];
        let variable = naga::GlobalVariable {
            name: Some(self.hir.names.text(global.name).to_owned()),
            space: AddressSpace::Private,
            binding: None,
            ty: self.ty(global.ty),
            init,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        let span = global
            .at
            .map_or(Span::UNDEFINED, |at| Span::new(at, at + 1));
        self.module.global_variables.append(variable, span)
    }

    /// The texture behind a sampler uniform, if the host has one.
    fn sampler_uniform(&mut self, id: Id<Global>) -> Binding {
        let global = &self.hir.globals[id];
        let name = self.hir.names.text(global.name);
        let interface = self.options.interface;
        let named = interface.samplers.iter().find(|known| known.name == name);
        let Some(sampler) = global.ty.sampler() else {
            return Binding::Zero;
        };
        let first = interface.samplers.first();
        let known = named.or(first.filter(|_| self.options.unit_0 == Some(sampler.shape)));
        let known = known.filter(|_| sampler.texel == Scalar::Float && !sampler.shadow);
        let Some(known) = known else {
            return Binding::Zero;
        };
        // A binding is declared once, however many uniforms read it.
        if let Some(&(_, binding)) = self.images.iter().find(|(at, _)| *at == known.texture) {
            return binding;
        }
        let name = &known.name;
        let ty = self.image_type(sampler.shape);
        let image = self.add_handle(name.clone(), ty, known.texture);
        let ty = self.sampler_type();
        let handle = self.add_handle(format!("{name}_sampler"), ty, known.sampler);
        let binding = Binding::Image(image, handle);
        self.images.push((known.texture, binding));
        binding
    }

    fn add_handle(
        &mut self,
        name: String,
        ty: Handle<naga::Type>,
        binding: u32,
    ) -> Handle<naga::GlobalVariable> {
        let variable = naga::GlobalVariable {
            name: Some(name),
            space: AddressSpace::Handle,
            binding: Some(self.resource(binding)),
            ty,
            init: None,
            memory_decorations: naga::MemoryDecorations::empty(),
        };
        self.module
            .global_variables
            .append(variable, Span::UNDEFINED)
    }

    pub fn resource(&self, binding: u32) -> naga::ResourceBinding {
        naga::ResourceBinding {
            group: self.options.interface.group,
            binding,
        }
    }

    /// Lowers the functions that are needed in one form only; the others follow where they are
    /// called. The order keeps that from going deep.
    pub fn add_functions(&mut self) {
        let hir = self.hir;
        for &id in &self.reachable.functions {
            let function = &hir.functions[id];
            let parameters = function.locals.iter().take(function.parameters.len());
            let takes_samplers = parameters.into_iter().any(|(_, local)| is_opaque(local.ty));
            if hir.main != Some(id) && !takes_samplers {
                self.function(id, smallvec![false; function.parameters.len()]);
            }
        }
    }

    pub fn finish(mut self) -> Lowered {
        let tables = self.finish_tables();
        let (sites, findings) = self.finish_findings();
        let order = |extent: &Extent| (extent.first, extent.last);
        let Unguarded {
            loops,
            accesses,
            divisions,
        } = &mut self.unguarded;
        for found in [loops, accesses, divisions] {
            found.sort_by_key(order);
            // A function that is lowered in several forms finds the same again.
            found.dedup();
        }
        Lowered {
            module: self.module,
            uniforms: self.uniforms,
            tables,
            unguarded: self.unguarded,
            loops: self.loops.into_iter().map(|(extent, _)| extent).collect(),
            sites,
            findings,
            excess: self.excess,
        }
    }
}

/// Whether a function reads through the sampler, rather than only the texture.
pub(super) fn samples(builtin: Builtin) -> bool {
    use Builtin as B;
    matches!(
        builtin,
        B::Texture
            | B::TextureProj
            | B::TextureLod
            | B::TextureOffset
            | B::TextureProjOffset
            | B::TextureLodOffset
            | B::TextureProjLod
            | B::TextureProjLodOffset
            | B::TextureGrad
            | B::TextureGradOffset
            | B::TextureProjGrad
            | B::TextureProjGradOffset
    )
}

/// Whether a parameter is a pointer.
pub(super) fn is_pointer(direction: Direction) -> bool {
    direction != Direction::In
}

/// What an expression names behind all commas.
fn last(function: &Function, mut id: Id<Expr>) -> ExprKind {
    while let ExprKind::Comma(_, second) = function.exprs[id].kind {
        id = second;
    }
    function.exprs[id].kind
}
