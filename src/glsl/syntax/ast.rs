//! What the parser makes of the tokens: the text's shape, no meaning yet. A name may turn out to be a
//! variable, a function or a type; a number has a value but an expression has no type.

use crate::glsl::arena::{Arena, Id, Pool, Range};
use crate::glsl::names::{Name, Names};
use crate::glsl::types::{Base, Type};

/// A token's place in the list that the preprocessor made.
pub type TokenIndex = u32;

/// Tokens that belong together, both ends included.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub struct Extent {
    /// The first token.
    pub first: TokenIndex,
    /// The last token.
    pub last: TokenIndex,
}

impl Extent {
    /// One token.
    pub const fn of(token: TokenIndex) -> Self {
        Extent {
            first: token,
            last: token,
        }
    }
}

/// A whole translation unit.
#[derive(Clone, Debug, Default)]
pub struct Ast {
    /// Every name.
    pub names: Names,
    /// Every expression; operands come before what uses them.
    pub exprs: Arena<Expr>,
    /// Arguments of calls.
    pub arguments: Pool<Id<Expr>>,
    /// Every statement; parts come before the whole.
    pub stmts: Arena<Stmt>,
    /// Statements of blocks.
    pub bodies: Pool<Id<Stmt>>,
    /// What is declared in functions.
    pub declarations: Arena<Declaration>,
    /// Variables and members.
    pub declarators: Pool<Declarator>,
    /// Types of constructors.
    pub types: Arena<TypeSpecifier>,
    /// Sizes of arrays.
    pub sizes: Pool<ArraySize>,
    /// Qualifiers of types.
    pub qualifiers: Pool<Qualifier>,
    /// Items of layout qualifiers.
    pub layouts: Pool<LayoutItem>,
    /// What stands at global scope, in order.
    pub items: Vec<Item>,
}

/// Something at global scope.
#[derive(Clone, Debug)]
pub enum Item {
    /// A function with its body, always a [`StmtKind::Block`].
    Function(Header, Id<Stmt>),
    /// Anything else that is declared.
    Declaration(Declaration),
    /// A `;` by itself.
    Empty(TokenIndex),
}

/// What precedes a function's body, or a prototype's semicolon.
#[derive(Clone, Debug)]
pub struct Header {
    /// What it returns.
    pub result: QualifiedType,
    /// Its name.
    pub name: Name,
    /// Where its name stands.
    pub at: TokenIndex,
    /// Its parameters; `(void)` is written as none.
    pub parameters: Vec<Parameter>,
    /// Behind the `)`.
    pub end: TokenIndex,
}

/// A function's parameter.
#[derive(Clone, Debug)]
pub struct Parameter {
    /// Its type with qualifiers.
    pub ty: QualifiedType,
    /// Its name, if it has one.
    pub name: Option<Name>,
    /// Where its name stands, or else its type.
    pub at: TokenIndex,
    /// Sizes behind the name.
    pub sizes: Sizes,
}

/// A declaration, at global scope or in a function.
#[derive(Clone, Debug)]
pub enum Declaration {
    /// `precision highp float;`
    Precision {
        /// The precision.
        precision: Precision,
        /// The type it is for.
        ty: TypeSpecifier,
        /// The word `precision`.
        at: TokenIndex,
    },
    /// `vec3 a, b = …;`, `struct S { … } s;`, `float;`
    Variables {
        /// The type of all.
        ty: QualifiedType,
        /// The variables; there may be none.
        declarators: Range<Declarator>,
    },
    /// A function without its body.
    Prototype(Header),
    /// `uniform Name { … } instance[2];`
    Block {
        /// What precedes the name.
        qualifiers: Range<Qualifier>,
        /// The block's name.
        name: Name,
        /// Where the name stands.
        at: TokenIndex,
        /// Its members.
        members: Vec<Members>,
        /// The name of the instance and its sizes.
        instance: Option<Declarator>,
    },
    /// Qualifiers without a type: `layout(std140) uniform;`, `invariant gl_Position, a;`.
    Qualifiers {
        /// The qualifiers.
        qualifiers: Range<Qualifier>,
        /// The names they are for, with their tokens.
        names: Vec<(Name, TokenIndex)>,
    },
}

/// One declared variable.
#[derive(Clone, Copy, Debug)]
pub struct Declarator {
    /// Its name.
    pub name: Name,
    /// Where its name stands.
    pub at: TokenIndex,
    /// Sizes behind the name.
    pub sizes: Sizes,
    /// What it is set to.
    pub init: Option<Id<Expr>>,
}

/// What stands in brackets behind a type or a name: a row in [`Ast::sizes`].
pub type Sizes = Range<ArraySize>;

/// `[3]` or `[]`.
#[derive(Clone, Copy, Debug)]
pub struct ArraySize {
    /// The number of elements; `None` when left to the initialiser.
    pub size: Option<Id<Expr>>,
    /// The `[`.
    pub at: TokenIndex,
}

/// A type with what stands before it.
#[derive(Clone, Debug)]
pub struct QualifiedType {
    /// Qualifiers in the order written.
    pub qualifiers: Range<Qualifier>,
    /// The type.
    pub ty: TypeSpecifier,
}

/// A qualifier and its token.
#[derive(Clone, Copy, Debug)]
pub struct Qualifier {
    /// Which.
    pub kind: QualifierKind,
    /// Where it stands.
    pub at: TokenIndex,
}

/// The qualifiers of §4.3 to §4.7.
#[derive(Clone, Copy, Debug)]
#[allow(missing_docs, reason = "each is the word itself")]
pub enum QualifierKind {
    Const,
    In,
    Out,
    InOut,
    Uniform,
    Flat,
    Smooth,
    Centroid,
    Invariant,
    Precision(Precision),
    /// `layout(a, b = 1)`
    Layout(Range<LayoutItem>),
}

/// One item of a layout qualifier.
#[derive(Clone, Copy, Debug)]
pub struct LayoutItem {
    /// Its name.
    pub name: Name,
    /// Where its name stands.
    pub at: TokenIndex,
    /// Its value, a literal: ES 3.00 has no expressions here.
    pub value: Option<u32>,
}

/// `lowp`, `mediump` or `highp`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is the word itself")]
pub enum Precision {
    Low,
    Medium,
    High,
}

/// A type as it is written.
#[derive(Clone, Debug)]
pub struct TypeSpecifier {
    /// The type's name.
    pub kind: TypeKind,
    /// Sizes behind it: `float[3]`.
    pub sizes: Sizes,
    /// All of it.
    pub extent: Extent,
}

/// A type's name.
#[derive(Clone, Debug)]
pub enum TypeKind {
    /// A type that the language has a keyword for; never a struct.
    Basic(Base),
    /// A structure by its name, or a word that is no type.
    Named(Name),
    /// A structure that is defined here.
    Struct(Box<StructDefinition>),
}

/// `struct S { … }`
#[derive(Clone, Debug)]
pub struct StructDefinition {
    /// Its name.
    pub name: Option<Name>,
    /// The name's token, or the word `struct`.
    pub at: TokenIndex,
    /// Its members.
    pub members: Vec<Members>,
}

/// Members of a structure or block that share a type.
#[derive(Clone, Debug)]
pub struct Members {
    /// Their type.
    pub ty: QualifiedType,
    /// Their names; none has an initialiser.
    pub declarators: Range<Declarator>,
}

/// An expression.
#[derive(Clone, Copy, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// The token that decides: the operator, the name, the function's name, the `[` or the member.
    pub at: TokenIndex,
    /// All its tokens.
    pub extent: Extent,
}

/// The kinds of expression, §5.
#[derive(Clone, Copy, Debug)]
pub enum ExprKind {
    /// A variable, or something that only the checker can tell.
    Name(Name),
    /// `true` or `false`.
    Bool(bool),
    /// An integer's 32 bits; 4294967295 is −1.
    Int(i32),
    /// `1u`
    Uint(u32),
    /// `1.0`, not rounded to 32 bits.
    Float(f64),
    /// A sign or a negation.
    Unary(UnaryOp, Id<Expr>),
    /// `++` or `--`.
    Increment {
        /// The variable.
        place: Id<Expr>,
        /// Whether it is `--`.
        down: bool,
        /// Whether the operator stands before the variable.
        prefix: bool,
    },
    /// An operator between two operands.
    Binary(BinaryOp, Id<Expr>, Id<Expr>),
    /// `=`, or with an operator `+=` and the like.
    Assign(Option<BinaryOp>, Id<Expr>, Id<Expr>),
    /// `condition ? yes : no`
    Ternary(Id<Expr>, Id<Expr>, Id<Expr>),
    /// `a, b`
    Comma(Id<Expr>, Id<Expr>),
    /// `base[index]`
    Index(Id<Expr>, Id<Expr>),
    /// `base.name`
    Member(Id<Expr>, Name),
    /// `callee(arguments)`; a lone `void` is written as no arguments.
    Call(Callee, Range<Id<Expr>>),
}

/// What is called.
#[derive(Clone, Copy, Debug)]
pub enum Callee {
    /// A function, or a structure's constructor.
    Name(Name),
    /// A constructor: `vec2`, `float[3]`, `S[]`.
    Type(Id<TypeSpecifier>),
    /// `a.length`
    Method(Id<Expr>, Name),
}

/// Operators with one operand and no side effect.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `+`
    Plus,
    /// `-`
    Negate,
    /// `!`
    Not,
    /// `~`
    Complement,
}

/// Operators with two operands.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[allow(missing_docs, reason = "each is its operator's name")]
pub enum BinaryOp {
    Add,
    Subtract,
    Multiply,
    Divide,
    Remainder,
    ShiftLeft,
    ShiftRight,
    BitAnd,
    BitOr,
    BitXor,
    LogicalAnd,
    LogicalOr,
    LogicalXor,
    Equal,
    NotEqual,
    Less,
    Greater,
    LessEqual,
    GreaterEqual,
}

impl UnaryOp {
    /// As it is written.
    pub fn symbol(self) -> &'static str {
        match self {
            UnaryOp::Plus => "+",
            UnaryOp::Negate => "-",
            UnaryOp::Not => "!",
            UnaryOp::Complement => "~",
        }
    }
}

impl BinaryOp {
    /// As it is written.
    pub fn symbol(self) -> &'static str {
        match self {
            BinaryOp::Add => "+",
            BinaryOp::Subtract => "-",
            BinaryOp::Multiply => "*",
            BinaryOp::Divide => "/",
            BinaryOp::Remainder => "%",
            BinaryOp::ShiftLeft => "<<",
            BinaryOp::ShiftRight => ">>",
            BinaryOp::BitAnd => "&",
            BinaryOp::BitOr => "|",
            BinaryOp::BitXor => "^",
            BinaryOp::LogicalAnd => "&&",
            BinaryOp::LogicalOr => "||",
            BinaryOp::LogicalXor => "^^",
            BinaryOp::Equal => "==",
            BinaryOp::NotEqual => "!=",
            BinaryOp::Less => "<",
            BinaryOp::Greater => ">",
            BinaryOp::LessEqual => "<=",
            BinaryOp::GreaterEqual => ">=",
        }
    }
}

/// A statement.
#[derive(Clone, Copy, Debug)]
pub struct Stmt {
    /// What it is.
    pub kind: StmtKind,
    /// All its tokens.
    pub extent: Extent,
}

/// The kinds of statement, §6.
#[derive(Clone, Copy, Debug)]
pub enum StmtKind {
    /// `;`
    Empty,
    /// `a = b;`
    Expression(Id<Expr>),
    /// Variables, a structure, a precision, or a prototype (which is not allowed in a function).
    Declaration(Id<Declaration>),
    /// `{ … }`
    Block(Range<Id<Stmt>>),
    /// `if (condition) then else other`
    If {
        /// The condition.
        condition: Id<Expr>,
        /// If it holds.
        then: Id<Stmt>,
        /// If it does not.
        other: Option<Id<Stmt>>,
    },
    /// `switch (selector) { … }`
    Switch {
        /// What is compared.
        selector: Id<Expr>,
        /// Labels and statements in order.
        body: Range<Id<Stmt>>,
    },
    /// `case 1:`, or `default:` with `None`.
    Label(Option<Id<Expr>>),
    /// `while (condition) body`
    While {
        /// The condition.
        condition: Condition,
        /// The body.
        body: Id<Stmt>,
    },
    /// `do body while (condition);`
    DoWhile {
        /// The body.
        body: Id<Stmt>,
        /// The condition.
        condition: Id<Expr>,
    },
    /// `for (init; condition; step) body`
    For {
        /// An expression, a declaration or an empty statement.
        init: Id<Stmt>,
        /// The condition.
        condition: Option<Condition>,
        /// What is done after each round.
        step: Option<Id<Expr>>,
        /// The body.
        body: Id<Stmt>,
    },
    /// `break;`
    Break,
    /// `continue;`
    Continue,
    /// `return;` or `return value;`
    Return(Option<Id<Expr>>),
    /// `discard;`
    Discard,
}

/// What `while` or `for` goes by.
#[derive(Clone, Copy, Debug)]
pub enum Condition {
    /// An expression.
    Expression(Id<Expr>),
    /// `bool b = …`: one variable, with the initialiser always present.
    Declaration(Id<Declaration>),
}

impl TypeSpecifier {
    /// The type, if it is one that the language has a keyword for and no array.
    pub fn basic(&self) -> Option<Type> {
        match &self.kind {
            TypeKind::Basic(base) if self.sizes.is_empty() => Some(Type::of(*base)),
            _ => None,
        }
    }
}
