//! Builds the checked form of programs.

use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::*;
use crate::glsl::types::{Base, Field, Struct, Type};

pub type E = Id<Expr>;

const EXTENT: Extent = Extent { first: 0, last: 0 };

/// A program while it is built; calls with expressions and locals concern the last function begun.
pub struct Program {
    pub hir: Hir,
    open: Vec<Function>,
}

pub fn stmt(kind: StmtKind) -> Stmt {
    Stmt {
        kind,
        extent: EXTENT,
    }
}

pub fn set(id: E) -> Stmt {
    stmt(StmtKind::Expression(id))
}

impl Program {
    pub fn new() -> Self {
        Program {
            hir: Hir::default(),
            open: Vec::new(),
        }
    }

    pub fn structure(&mut self, name: &str, fields: &[(&str, Type)]) -> Type {
        let names = &mut self.hir.names;
        let fields = fields
            .iter()
            .map(|(name, ty)| Field {
                name: names.intern(name),
                ty: *ty,
            })
            .collect();
        let name = Some(names.intern(name));
        let structure = Struct::new(name, fields, &self.hir.structs);
        Type::of(Base::Struct(self.hir.structs.add(structure)))
    }

    pub fn global(&mut self, name: &str, ty: Type, kind: GlobalKind) -> Id<Global> {
        let name = self.hir.names.intern(name);
        self.hir.globals.add(Global {
            name,
            ty,
            kind,
            at: Some(0),
            written: true,
        })
    }

    pub fn begin(&mut self, name: &str, result: Type) {
        let name = self.hir.names.intern(name);
        self.open.push(Function {
            name,
            at: 0,
            result,
            parameters: Vec::new(),
            locals: Default::default(),
            exprs: Default::default(),
            operands: Default::default(),
            body: Vec::new(),
        });
    }

    pub fn end(&mut self, body: Block) -> Id<Function> {
        let mut function = self.open.pop().expect("a function is open");
        function.body = body;
        self.hir.functions.add(function)
    }

    /// Ends `main`, which sets the colour.
    pub fn finish(mut self, body: Block) -> Hir {
        let main = self.end(body);
        self.hir.main = Some(main);
        self.hir
    }

    /// The program as it is, with this as the body of `main`.
    pub fn hir_with_main(&self, body: Block) -> Hir {
        let mut hir = self.hir.clone();
        let mut main = self.open.last().expect("a function is open").clone();
        main.body = body;
        hir.main = Some(hir.functions.add(main));
        hir
    }

    fn function(&mut self) -> &mut Function {
        self.open.last_mut().expect("a function is open")
    }

    pub fn parameter(&mut self, name: &str, ty: Type, direction: Direction) -> Id<Local> {
        self.function().parameters.push(direction);
        self.local(name, ty, false)
    }

    pub fn local(&mut self, name: &str, ty: Type, written: bool) -> Id<Local> {
        let name = Some(self.hir.names.intern(name));
        let at = 0;
        self.function().locals.add(Local {
            name,
            ty,
            written,
            at,
        })
    }

    pub fn expr(&mut self, kind: ExprKind, ty: Type) -> E {
        let extent = EXTENT;
        self.function().exprs.add(Expr { kind, ty, extent })
    }

    pub fn constant(&mut self, values: &[Value], ty: Type) -> E {
        let constant = self.hir.constants.add(values);
        self.expr(ExprKind::Constant(constant), ty)
    }

    pub fn float(&mut self, value: f64) -> E {
        self.constant(&[Value::Float(value)], Type::FLOAT)
    }

    pub fn int(&mut self, value: i32) -> E {
        self.constant(&[Value::Int(value)], Type::INT)
    }

    pub fn get(&mut self, local: Id<Local>) -> E {
        let ty = self.function().locals[local].ty;
        self.expr(ExprKind::Local(local), ty)
    }

    pub fn get_global(&mut self, global: Id<Global>) -> E {
        let ty = self.hir.globals[global].ty;
        self.expr(ExprKind::Global(global), ty)
    }

    pub fn ty(&mut self, id: E) -> Type {
        self.function().exprs[id].ty
    }

    pub fn binary(&mut self, op: BinaryOp, left: E, right: E, ty: Type) -> E {
        self.expr(ExprKind::Binary(op, left, right), ty)
    }

    pub fn assign(&mut self, place: E, value: E) -> E {
        let ty = self.ty(place);
        self.expr(ExprKind::Assign(place, value), ty)
    }

    pub fn increment(&mut self, place: E) -> E {
        let ty = self.ty(place);
        self.expr(
            ExprKind::Increment {
                place,
                down: false,
                prefix: false,
            },
            ty,
        )
    }

    pub fn index(&mut self, base: E, index: E) -> E {
        let ty = super::super::place::element_type(self.ty(base));
        self.expr(ExprKind::Index(base, index), ty)
    }

    pub fn member(&mut self, base: E, member: u32) -> E {
        let Base::Struct(id) = self.ty(base).base else {
            unreachable!("only structures have members");
        };
        let ty = self.hir.structs[id].fields[member as usize].ty;
        self.expr(ExprKind::Member(base, member), ty)
    }

    pub fn swizzle(&mut self, base: E, components: &[u8]) -> E {
        let scalar = self.ty(base).scalar().expect("it is a vector");
        let len = components.len() as u8;
        let mut all = [0; 4];
        all[..components.len()].copy_from_slice(components);
        let swizzle = Swizzle {
            len,
            components: all,
        };
        self.expr(ExprKind::Swizzle(base, swizzle), Type::vector(scalar, len))
    }

    pub fn construct(&mut self, ty: Type, operands: &[E]) -> E {
        let operands = self.function().operands.add(operands);
        self.expr(ExprKind::Construct(operands), ty)
    }

    pub fn call(&mut self, callee: Id<Function>, operands: &[E]) -> E {
        let ty = self.hir.functions[callee].result;
        let operands = self.function().operands.add(operands);
        self.expr(ExprKind::Call(callee, operands), ty)
    }

    pub fn builtin(&mut self, builtin: Builtin, operands: &[E], ty: Type) -> E {
        let operands = self.function().operands.add(operands);
        self.expr(ExprKind::Builtin(builtin, operands), ty)
    }
}
