//! Trees as text, for tests.

use super::ast::*;
use crate::glsl::arena::{Id, Range};
use crate::glsl::types::{Base, Scalar};

/// Everything, one item a line.
pub fn tree(ast: &Ast) -> String {
    let items: Vec<_> = ast.items.iter().map(|item| Show(ast).item(item)).collect();
    items.join("\n")
}

struct Show<'a>(&'a Ast);

impl Show<'_> {
    fn item(&self, item: &Item) -> String {
        match item {
            Item::Function(header, body) => format!("{} {}", self.header(header), self.stmt(*body)),
            Item::Declaration(declaration) => self.declaration(declaration),
            Item::Empty(_) => ";".into(),
        }
    }

    fn header(&self, header: &Header) -> String {
        let parameters = header.parameters.iter().map(|parameter| {
            let name = parameter.name.map_or("_", |name| self.0.names.text(name));
            let sizes = self.sizes(parameter.sizes);
            format!("{} {name}{sizes}", self.qualified(&parameter.ty))
        });
        let parameters: Vec<_> = parameters.collect();
        let name = self.0.names.text(header.name);
        format!(
            "fn {} {name}({})",
            self.qualified(&header.result),
            parameters.join(", ")
        )
    }

    fn declaration(&self, declaration: &Declaration) -> String {
        match declaration {
            Declaration::Precision { precision, ty, .. } => {
                format!("precision {precision:?} {}", self.ty(ty))
            }
            Declaration::Variables { ty, declarators } => {
                let declarators = self.declarators(*declarators);
                format!("let {}: {}", self.qualified(ty), declarators)
            }
            Declaration::Prototype(header) => self.header(header),
            Declaration::Block {
                qualifiers,
                name,
                members,
                instance,
                ..
            } => {
                let qualifiers = self.qualifiers(*qualifiers);
                let instance = instance.as_ref().map(|it| self.declarator(it));
                format!(
                    "block {qualifiers}{} {{{}}} {}",
                    self.0.names.text(*name),
                    self.members(members),
                    instance.unwrap_or_default()
                )
            }
            Declaration::Qualifiers { qualifiers, names } => {
                let names = names.iter().map(|(name, _)| self.0.names.text(*name));
                let names: Vec<_> = names.collect();
                format!("{}{}", self.qualifiers(*qualifiers), names.join(" "))
            }
        }
    }

    fn members(&self, members: &[Members]) -> String {
        let members = members.iter().map(|members| {
            let declarators = self.declarators(members.declarators);
            format!("{}: {declarators}", self.qualified(&members.ty))
        });
        members.collect::<Vec<_>>().join("; ")
    }

    fn declarators(&self, declarators: Range<Declarator>) -> String {
        let declarators = self.0.declarators.get(declarators).iter();
        let declarators: Vec<_> = declarators.map(|it| self.declarator(it)).collect();
        declarators.join(", ")
    }

    fn declarator(&self, declarator: &Declarator) -> String {
        let init = declarator
            .init
            .map(|init| format!(" = {}", self.expr(init)));
        format!(
            "{}{}{}",
            self.0.names.text(declarator.name),
            self.sizes(declarator.sizes),
            init.unwrap_or_default()
        )
    }

    fn qualifiers(&self, qualifiers: Range<Qualifier>) -> String {
        let qualifiers = self
            .0
            .qualifiers
            .get(qualifiers)
            .iter()
            .map(|qualifier| match &qualifier.kind {
                QualifierKind::Layout(items) => {
                    let items = self.0.layouts.get(*items).iter().map(|item| {
                        let value = item.value.map(|value| format!("={value}"));
                        self.0.names.text(item.name).to_owned() + &value.unwrap_or_default()
                    });
                    format!("layout({}) ", items.collect::<Vec<_>>().join(","))
                }
                QualifierKind::Precision(precision) => format!("{precision:?} "),
                kind => format!("{kind:?} "),
            });
        qualifiers.collect()
    }

    fn qualified(&self, ty: &QualifiedType) -> String {
        self.qualifiers(ty.qualifiers) + &self.ty(&ty.ty)
    }

    fn ty(&self, ty: &TypeSpecifier) -> String {
        let name = match &ty.kind {
            TypeKind::Basic(Base::Void) => "void".into(),
            TypeKind::Basic(Base::Scalar(scalar)) => format!("{scalar:?}").to_lowercase(),
            TypeKind::Basic(Base::Vector(Scalar::Float, size)) => format!("vec{size}"),
            TypeKind::Basic(base) => format!("{base:?}"),
            TypeKind::Named(name) => self.0.names.text(*name).to_owned(),
            TypeKind::Struct(structure) => {
                let name = structure.name.map_or("_", |name| self.0.names.text(name));
                format!("struct {name} {{{}}}", self.members(&structure.members))
            }
        };
        name + &self.sizes(ty.sizes)
    }

    fn sizes(&self, sizes: Sizes) -> String {
        let sizes = self.0.sizes.get(sizes).iter().map(|size| match size.size {
            Some(size) => format!("[{}]", self.expr(size)),
            None => "[]".into(),
        });
        sizes.collect()
    }

    fn stmts(&self, stmts: Range<Id<Stmt>>) -> String {
        let stmts: Vec<_> = self
            .0
            .bodies
            .get(stmts)
            .iter()
            .map(|stmt| self.stmt(*stmt))
            .collect();
        format!("{{{}}}", stmts.join("; "))
    }

    fn stmt(&self, stmt: Id<Stmt>) -> String {
        let optional = |expr: &Option<Id<Expr>>| expr.map(|it| self.expr(it)).unwrap_or_default();
        let condition = |condition: &Condition| match condition {
            Condition::Expression(expr) => self.expr(*expr),
            Condition::Declaration(declaration) => {
                self.declaration(&self.0.declarations[*declaration])
            }
        };
        match &self.0.stmts[stmt].kind {
            StmtKind::Empty => "empty".into(),
            StmtKind::Expression(expr) => self.expr(*expr),
            StmtKind::Declaration(declaration) => {
                self.declaration(&self.0.declarations[*declaration])
            }
            StmtKind::Block(body) => self.stmts(*body),
            StmtKind::If {
                condition,
                then,
                other,
            } => {
                let other = other.map(|other| format!(" else {}", self.stmt(other)));
                format!(
                    "if {} {}{}",
                    self.expr(*condition),
                    self.stmt(*then),
                    other.unwrap_or_default()
                )
            }
            StmtKind::Switch { selector, body } => {
                format!("switch {} {}", self.expr(*selector), self.stmts(*body))
            }
            StmtKind::Label(Some(value)) => format!("case {}", self.expr(*value)),
            StmtKind::Label(None) => "default".into(),
            StmtKind::While {
                condition: it,
                body,
            } => {
                format!("while {} {}", condition(it), self.stmt(*body))
            }
            StmtKind::DoWhile { body, condition } => {
                format!("do {} while {}", self.stmt(*body), self.expr(*condition))
            }
            StmtKind::For {
                init,
                condition: it,
                step,
                body,
            } => format!(
                "for ({} | {} | {}) {}",
                self.stmt(*init),
                it.as_ref().map(condition).unwrap_or_default(),
                optional(step),
                self.stmt(*body)
            ),
            StmtKind::Break => "break".into(),
            StmtKind::Continue => "continue".into(),
            StmtKind::Return(value) => format!("return {}", optional(value)).trim_end().into(),
            StmtKind::Discard => "discard".into(),
        }
    }

    fn expr(&self, expr: Id<Expr>) -> String {
        let name = |name| self.0.names.text(name);
        match &self.0.exprs[expr].kind {
            ExprKind::Name(it) => name(*it).into(),
            ExprKind::Bool(value) => value.to_string(),
            ExprKind::Int(value) => value.to_string(),
            ExprKind::Uint(value) => format!("{value}u"),
            ExprKind::Float(value) => format!("{value:?}"),
            ExprKind::Unary(op, part) => format!("({} {})", op.symbol(), self.expr(*part)),
            ExprKind::Increment {
                place,
                down,
                prefix,
            } => {
                let op = if *down { "--" } else { "++" };
                match prefix {
                    true => format!("({op}_ {})", self.expr(*place)),
                    false => format!("(_{op} {})", self.expr(*place)),
                }
            }
            ExprKind::Binary(op, a, b) => {
                format!("({} {} {})", op.symbol(), self.expr(*a), self.expr(*b))
            }
            ExprKind::Assign(op, a, b) => {
                let op = op.map(BinaryOp::symbol).unwrap_or_default();
                format!("({op}= {} {})", self.expr(*a), self.expr(*b))
            }
            ExprKind::Ternary(a, b, c) => {
                format!("(? {} {} {})", self.expr(*a), self.expr(*b), self.expr(*c))
            }
            ExprKind::Comma(a, b) => format!("(, {} {})", self.expr(*a), self.expr(*b)),
            ExprKind::Index(a, b) => format!("{}[{}]", self.expr(*a), self.expr(*b)),
            ExprKind::Member(a, member) => format!("{}.{}", self.expr(*a), name(*member)),
            ExprKind::Call(callee, arguments) => {
                let callee = match callee {
                    Callee::Name(it) => name(*it).into(),
                    Callee::Type(ty) => format!("<{}>", self.ty(&self.0.types[*ty])),
                    Callee::Method(object, it) => format!("{}.{}", self.expr(*object), name(*it)),
                };
                let arguments = self.0.arguments.get(*arguments);
                let arguments: Vec<_> = arguments.iter().map(|it| self.expr(*it)).collect();
                format!("{callee}({})", arguments.join(", "))
            }
        }
    }
}
