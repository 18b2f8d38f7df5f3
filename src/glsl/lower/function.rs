//! One function: its parameters and local variables.

use naga::{AddressSpace, Expression, Handle, Span, Statement, TypeInner};
use rustc_hash::FxHashMap;

use super::context::{Context, Nulls, is_pointer};
use super::emit::Shared;
use super::lowp::Needs;
use super::range::Ranges;
use super::sanitize::Here;
use super::types::is_opaque;
use crate::glsl::arena::Id;
use crate::glsl::hir::{self, Constant, Direction, Extent};
use crate::glsl::types::{Base, Type};

/// An expression of the function that is being built.
pub(super) type H = Handle<Expression>;

/// A function while it is built.
pub(super) struct Builder<'c, 'a> {
    pub context: &'c mut Context<'a>,
    pub source: &'a hir::Function,
    pub id: Id<hir::Function>,
    pub function: naga::Function,
    pub blocks: Vec<naga::Block>,
    /// The most blocks that have been open at once.
    pub deepest: usize,
    pub room: Room,
    /// The first expression that no statement has emitted yet.
    pub pending: Option<usize>,
    pub span: Span,
    /// Variables that hold nothing at present.
    pub temporaries: FxHashMap<Type, Vec<H>>,
    /// What is known of integers.
    pub ranges: Ranges,
    /// Which components are set of variables that begin without a value.
    pub marks: FxHashMap<Id<hir::Local>, H>,
    /// The operation that the next value is an operand of, if that hands on what is not finite.
    pub tree: Option<Here>,
    /// Whether what is computed at present is rounded to 16 bits.
    pub is_low: bool,
    /// The loops that the present statement stands in.
    pub loops: Vec<&'a hir::Loop>,
    /// Whether a declaration may be jumped over by the statements that see it.
    pub in_arm: bool,
    /// Set while the entry point is built.
    pub entry: Option<Entry>,
}

/// What is known of a function, in memory that serves one function after the other.
#[derive(Default)]
pub(super) struct Room {
    /// How many operations stand within each other in each expression.
    pub heights: Vec<u16>,
    pub shared: FxHashMap<Shared, H>,
    /// What stands for each of the source's variables, once it is known.
    pub locals: Vec<Option<Local>>,
    /// Which of the source's expressions change anything, as far as has been asked.
    pub effects: Vec<Option<bool>>,
    /// How precisely the source's expressions must be computed, as far as has been asked.
    pub needs: Vec<Option<Needs>>,
}

/// What only the entry point has.
#[derive(Clone, Copy)]
pub(super) struct Entry {
    /// `gl_FragCoord`
    pub position: H,
}

/// What stands for a variable.
#[derive(Clone, Copy, Debug)]
pub(super) enum Local {
    /// A variable, or what the caller gave as one.
    Pointer(H),
    /// A value that no one changes.
    Value(H),
    /// A constant that no one changes.
    Constant(Id<Constant>),
    /// Zero, which no one changes.
    Zero,
    /// A texture and what it is read through, if anything reads it so.
    Image(H, Option<H>),
    /// A sampler without texture.
    Null,
}

impl<'a> Context<'a> {
    /// A function with some of its samplers known to have no texture, lowered when first called.
    pub fn function(&mut self, id: Id<hir::Function>, nulls: Nulls) -> Handle<naga::Function> {
        let key = (id, nulls);
        if let Some(&known) = self.functions.get(&key) {
            return known;
        }
        let mut builder = Builder::new(self, id);
        builder.add_signature(&key.1);
        let source = builder.source;
        builder.body(&source.body);
        let span = builder.span_of(Extent::of(source.at));
        let function = builder.finish();
        let handle = self.module.functions.append(function, span);
        self.functions.insert(key, handle);
        handle
    }
}

impl<'c, 'a> Builder<'c, 'a> {
    pub fn new(context: &'c mut Context<'a>, id: Id<hir::Function>) -> Self {
        let hir = context.hir;
        let source = &hir.functions[id];
        let mut room = std::mem::take(&mut context.room);
        room.heights.clear();
        room.shared.clear();
        room.locals.clear();
        room.locals.resize(source.locals.len(), None);
        room.effects.clear();
        room.effects.resize(source.exprs.len(), None);
        room.needs.clear();
        room.needs.resize(source.exprs.len(), None);
        Builder {
            function: naga::Function {
                name: Some(hir.names.text(source.name).to_owned()),
                ..naga::Function::default()
            },
            blocks: vec![naga::Block::new()],
            deepest: 1,
            room,
            pending: None,
            span: Span::UNDEFINED,
            temporaries: FxHashMap::default(),
            ranges: Ranges::default(),
            marks: FxHashMap::default(),
            tree: None,
            is_low: false,
            loops: Vec::new(),
            in_arm: false,
            entry: None,
            context,
            source,
            id,
        }
    }

    /// The body in place, with a return at its end.
    pub fn body(&mut self, body: &'a hir::Block) {
        if !self.statements(body) {
            self.return_zero();
        }
        // The last statement may have been too much.
        self.is_excessive(Extent::of(self.source.at));
    }

    pub fn finish(mut self) -> naga::Function {
        self.function.body = self.close();
        debug_assert!(self.blocks.is_empty(), "every block is closed");
        self.context.room = self.room;
        self.function
    }

    pub fn span_of(&self, extent: Extent) -> Span {
        Span::new(extent.first, extent.last + 1)
    }

    fn add_signature(&mut self, nulls: &[bool]) {
        let mut copies = Vec::new();
        for (i, &direction) in self.source.parameters.iter().enumerate() {
            let id = Id::new(i);
            let local = &self.source.locals[id];
            self.span = self.span_of(Extent::of(local.at));
            let name = self.local_name(id);
            let binding = if is_opaque(local.ty) {
                match local.ty.sampler() {
                    Some(sampler) if !nulls[i] => {
                        let ty = self.context.image_type(sampler.shape);
                        let image = self.add_argument(name.clone(), ty);
                        let sampled = self.context.sampled.contains(&(self.id, id));
                        let sampler = sampled.then(|| {
                            let ty = self.context.sampler_type();
                            self.add_argument(name.map(|name| name + "_sampler"), ty)
                        });
                        Local::Image(image, sampler)
                    }
                    _ => Local::Null,
                }
            } else {
                let base = self.context.ty(local.ty);
                if is_pointer(direction) {
                    let space = AddressSpace::Function;
                    let ty = self.context.add_type(TypeInner::Pointer { base, space });
                    let pointer = self.add_argument(name, ty);
                    if direction == Direction::Out {
                        copies.push((id, pointer, None));
                    }
                    Local::Pointer(pointer)
                } else {
                    let value = self.add_argument(name, base);
                    if local.written {
                        let pointer = self.variable(local.ty, self.local_name(id));
                        copies.push((id, pointer, Some(value)));
                        Local::Pointer(pointer)
                    } else {
                        Local::Value(value)
                    }
                }
            };
            self.room.locals[i] = Some(binding);
        }
        for (id, pointer, value) in copies {
            match value {
                Some(value) => self.store(pointer, value),
                None => {
                    self.store_zero(pointer, self.source.locals[id].ty);
                    self.begin_unset(id);
                }
            }
        }
        let result = self.source.result;
        if result.base != Base::Void {
            let ty = self.context.ty(result);
            self.function.result = Some(naga::FunctionResult { ty, binding: None });
        }
    }

    pub fn add_argument(&mut self, name: Option<String>, ty: Handle<naga::Type>) -> H {
        let index = self.function.arguments.len() as u32;
        self.function.arguments.push(naga::FunctionArgument {
            name,
            ty,
            binding: None,
        });
        self.add(Expression::FunctionArgument(index))
    }

    pub fn local_name(&self, id: Id<hir::Local>) -> Option<String> {
        let name = self.source.locals[id].name?;
        Some(self.context.hir.names.text(name).to_owned())
    }

    /// What stands for a local variable. One whose declaration is jumped over gets its variable here.
    pub fn local(&mut self, id: Id<hir::Local>) -> Local {
        if let Some(known) = self.room.locals[id.index()] {
            return known;
        }
        let local = Local::Pointer(self.variable(self.source.locals[id].ty, self.local_name(id)));
        self.room.locals[id.index()] = Some(local);
        local
    }

    /// The variable behind a local that has one.
    pub fn local_pointer(&mut self, id: Id<hir::Local>) -> H {
        match self.local(id) {
            Local::Pointer(pointer) => pointer,
            other => unreachable!("{other:?} is not written"),
        }
    }

    /// A variable of no further use once it is released.
    pub fn acquire(&mut self, ty: Type) -> H {
        match self.temporaries.get_mut(&ty).and_then(Vec::pop) {
            Some(free) => free,
            None => self.variable(ty, None),
        }
    }

    pub fn release(&mut self, ty: Type, pointer: H) {
        self.temporaries.entry(ty).or_default().push(pointer);
    }

    /// Leaves the function with what the source forgot to return.
    pub fn return_zero(&mut self) {
        let value = (self.source.result.base != Base::Void).then(|| self.zero(self.source.result));
        self.leave(value);
    }

    pub fn leave(&mut self, value: Option<H>) {
        self.record_value(value);
        let value = if self.entry.is_some() {
            self.flush_findings();
            Some(self.output())
        } else {
            value
        };
        self.push(Statement::Return { value });
    }

    /// Gives a value that is emitted here a name to be written with.
    pub fn name(&mut self, value: H, id: Id<hir::Local>) {
        if !self.function.expressions[value].needs_pre_emit()
            && !self.function.named_expressions.contains_key(&value)
            && let Some(name) = self.local_name(id)
        {
            self.function.named_expressions.insert(value, name);
        }
    }
}
