//! The checked program: names are resolved, every expression has its type, constants are folded,
//! built-in functions are identified. Nothing that comes after it can fail on the author's account.

use super::arena::{Arena, Id, Pool, Range};
use super::builtins::Builtin;
use super::names::{Name, Names};
pub use super::syntax::ast::{BinaryOp, Extent, TokenIndex};
use super::types::{Content, Struct, Type};

/// A whole program.
#[derive(Clone, Debug, Default)]
pub struct Hir {
    /// Every name.
    pub names: Names,
    /// Every structure; members' structures come before those that hold them.
    pub structs: Arena<Struct>,
    /// Every global variable but constants, in order of declaration.
    pub globals: Arena<Global>,
    /// Every function that has a body, callees in no particular order.
    pub functions: Arena<Function>,
    /// The values of all constants.
    pub constants: Constants,
    /// `main`.
    pub main: Option<Id<Function>>,
    /// A function without parameters that sets globals whose initialisers are not constant, in order
    /// of declaration; called before `main`.
    pub initialisers: Option<Id<Function>>,
}

/// A global variable.
#[derive(Clone, Debug)]
pub struct Global {
    /// Its name.
    pub name: Name,
    /// Its type.
    pub ty: Type,
    /// Where its value comes from.
    pub kind: GlobalKind,
    /// Where its name was declared; `None` for what the language brings.
    pub at: Option<TokenIndex>,
    /// Whether anything may assign to it.
    pub written: bool,
}

/// Where a global's value comes from, or goes to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum GlobalKind {
    /// The program; begins as the constant, or as zero.
    Private(Option<Id<Constant>>),
    /// The host: a uniform, a sampler or an instance of a uniform block.
    Uniform,
    /// The vertex shader; only unread ones pass.
    Input,
    /// The colour at this location.
    Output(u32),
    /// `gl_FragCoord`
    FragCoord,
    /// `gl_FrontFacing`
    FrontFacing,
    /// `gl_PointCoord`
    PointCoord,
    /// `gl_FragDepth`
    FragDepth,
}

/// A function.
#[derive(Clone, Debug)]
pub struct Function {
    /// Its name.
    pub name: Name,
    /// Where its name stands.
    pub at: TokenIndex,
    /// What it returns.
    pub result: Type,
    /// Its parameters: the first of `locals`, as many as this.
    pub parameters: Vec<Direction>,
    /// Parameters, then every other variable.
    pub locals: Arena<Local>,
    /// Its expressions.
    pub exprs: Arena<Expr>,
    /// Arguments of its calls and constructors.
    pub operands: Pool<Id<Expr>>,
    /// What it does.
    pub body: Block,
}

impl Function {
    /// Calls back with every operand of an expression, from left to right.
    #[inline]
    pub fn for_each_operand(&self, id: Id<Expr>, mut each: impl FnMut(Id<Expr>)) {
        match self.exprs[id].kind {
            ExprKind::Constant(_) | ExprKind::Local(_) | ExprKind::Global(_) => {}
            ExprKind::Unary(_, a)
            | ExprKind::Increment { place: a, .. }
            | ExprKind::Member(a, _)
            | ExprKind::Swizzle(a, _) => each(a),
            ExprKind::Binary(_, a, b)
            | ExprKind::And(a, b)
            | ExprKind::Or(a, b)
            | ExprKind::Comma(a, b)
            | ExprKind::Assign(a, b)
            | ExprKind::Compound(_, a, b)
            | ExprKind::Index(a, b) => {
                each(a);
                each(b);
            }
            ExprKind::Ternary(a, b, c) => {
                each(a);
                each(b);
                each(c);
            }
            ExprKind::Construct(row) | ExprKind::Call(_, row) | ExprKind::Builtin(_, row) => {
                self.operands.get(row).iter().copied().for_each(each);
            }
        }
    }
}

/// How a parameter is passed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Direction {
    /// A copy in; also samplers.
    In,
    /// A copy out; it begins as zero, as WebGL has it.
    Out,
    /// A copy in and out.
    InOut,
}

/// A variable or parameter of a function.
#[derive(Clone, Debug)]
pub struct Local {
    /// Its name; `None` for parameters without one and for variables that no one wrote.
    pub name: Option<Name>,
    /// Its type.
    pub ty: Type,
    /// Whether anything assigns to it other than its declaration.
    pub written: bool,
    /// Where it is declared.
    pub at: TokenIndex,
}

/// Statements in order.
pub type Block = Vec<Stmt>;

/// A statement.
#[derive(Clone, Debug)]
pub struct Stmt {
    /// What it does.
    pub kind: StmtKind,
    /// Where it is written.
    pub extent: Extent,
}

/// The kinds of statement.
#[derive(Clone, Debug)]
pub enum StmtKind {
    /// Evaluates for the side effects.
    Expression(Id<Expr>),
    /// A variable begins, at this value or at zero: also each time around a loop.
    Declare(Id<Local>, Option<Id<Expr>>),
    /// Statements in a scope of their own.
    Block(Block),
    /// A choice. The condition is a `bool`.
    If(Id<Expr>, Block, Block),
    /// A loop.
    Loop(Loop),
    /// A choice by number.
    Switch(Switch),
    /// Leaves the innermost loop or switch.
    Break,
    /// Starts the innermost loop's next round.
    Continue,
    /// Leaves the function.
    Return(Option<Id<Expr>>),
    /// Gives the pixel up.
    Discard,
}

/// `for`, `while` and `do`. What a `for` begins with stands before it, in the same [`StmtKind::Block`].
#[derive(Clone, Debug)]
pub struct Loop {
    /// A variable declared in the condition, set to `condition` each time before it is asked.
    pub declared: Option<Id<Local>>,
    /// Asked before each round, or behind it in a `do` loop; `None` holds always.
    pub condition: Option<Id<Expr>>,
    /// Whether the condition is asked behind the body.
    pub tests_last: bool,
    /// What is repeated.
    pub body: Block,
    /// Evaluated after each round, also after `continue`.
    pub step: Option<Id<Expr>>,
    /// Whether it is known to end after finitely many rounds.
    pub is_finite: bool,
}

/// `switch`. Execution falls from one arm into the next unless it breaks.
#[derive(Clone, Debug)]
pub struct Switch {
    /// An `int` or a `uint`.
    pub selector: Id<Expr>,
    /// The arms in order, each with at least one label.
    pub arms: Vec<Arm>,
}

/// The statements behind some labels.
#[derive(Clone, Debug)]
pub struct Arm {
    /// The bits of each label; `None` is `default`.
    pub labels: Vec<Option<i32>>,
    /// What follows them, up to the next label.
    pub body: Block,
}

/// An expression.
#[derive(Clone, Copy, Debug)]
pub struct Expr {
    /// What it is.
    pub kind: ExprKind,
    /// Its type.
    pub ty: Type,
    /// Where it is written.
    pub extent: Extent,
}

/// Operands of which there may be many: a row in [`Function::operands`].
pub type Operands = Range<Id<Expr>>;

/// The kinds of expression. Operands are evaluated from left to right.
#[derive(Clone, Copy, Debug)]
pub enum ExprKind {
    /// A value known now, of any type but samplers.
    Constant(Id<Constant>),
    /// A variable or parameter.
    Local(Id<Local>),
    /// A global variable.
    Global(Id<Global>),
    /// `-` on numbers, `!` on a `bool`, `~` on integers; also `not()` is a [`Builtin`], not this.
    Unary(UnaryOp, Id<Expr>),
    /// Any operator but `&&` and `||`. Scalars mix with vectors and matrices as §5.9 has it; `==` and
    /// `!=` take all types that can be compared, arrays and structures too.
    Binary(BinaryOp, Id<Expr>, Id<Expr>),
    /// `&&`: the right side only if the left holds.
    And(Id<Expr>, Id<Expr>),
    /// `||`: the right side only if the left does not hold.
    Or(Id<Expr>, Id<Expr>),
    /// `?:`: evaluates only the side that is chosen.
    Ternary(Id<Expr>, Id<Expr>, Id<Expr>),
    /// Both, for the value of the second.
    Comma(Id<Expr>, Id<Expr>),
    /// Sets a place; the value is what was set.
    Assign(Id<Expr>, Id<Expr>),
    /// `place op= value`. The place is evaluated once.
    Compound(BinaryOp, Id<Expr>, Id<Expr>),
    /// `++` and `--`.
    Increment {
        /// The variable.
        place: Id<Expr>,
        /// Whether it is `--`.
        down: bool,
        /// Whether the value is the one after the change.
        prefix: bool,
    },
    /// An element of an array, a column of a matrix, a component of a vector.
    Index(Id<Expr>, Id<Expr>),
    /// A member of a structure.
    Member(Id<Expr>, u32),
    /// Components of a vector.
    Swizzle(Id<Expr>, Swizzle),
    /// A constructor of the expression's type, §5.4: the arguments are as the author wrote them.
    Construct(Operands),
    /// A call of one of the program's functions. Arguments of `out` and `inout` parameters are places.
    Call(Id<Function>, Operands),
    /// A call of a built-in function; of which signature, the types of the arguments tell.
    Builtin(Builtin, Operands),
}

/// Operators with one operand.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum UnaryOp {
    /// `-`
    Negate,
    /// `!`
    Not,
    /// `~`
    Complement,
}

/// One to four components of a vector, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Swizzle {
    /// How many.
    pub len: u8,
    /// Which: 0 to 3 each, the first `len` count.
    pub components: [u8; 4],
}

impl Swizzle {
    /// The components.
    pub fn as_slice(&self) -> &[u8] {
        &self.components[..usize::from(self.len)]
    }
}

/// One component of a constant.
#[derive(Clone, Copy, Debug)]
pub enum Value {
    /// A `float`: rounded to 32 bits unless the program is compiled in double precision.
    Float(f64),
    /// An `int`.
    Int(i32),
    /// A `uint`.
    Uint(u32),
    /// A `bool`.
    Bool(bool),
}

/// A constant: a row of [`Value`]s. Arrays and structures are flat, matrices column by column.
#[derive(Clone, Copy, Debug)]
pub struct Constant {
    start: u32,
    len: u32,
}

/// The values of all constants.
#[derive(Clone, Debug, Default)]
pub struct Constants {
    values: Vec<Value>,
    rows: Arena<Constant>,
}

impl Constants {
    /// Adds a constant.
    pub fn add(&mut self, values: &[Value]) -> Id<Constant> {
        let start = self.values.len() as u32;
        self.values.extend_from_slice(values);
        self.rows.add(Constant {
            start,
            len: values.len() as u32,
        })
    }

    /// A part of a constant, which shares its values.
    pub fn part(&mut self, of: Id<Constant>, start: u32, len: u32) -> Id<Constant> {
        let whole = self.rows[of];
        debug_assert!(start + len <= whole.len, "a part lies within the whole");
        self.rows.add(Constant {
            start: whole.start + start,
            len,
        })
    }

    /// A constant's values.
    pub fn get(&self, id: Id<Constant>) -> &[Value] {
        let Constant { start, len } = self.rows[id];
        &self.values[start as usize..(start + len) as usize]
    }
}

impl Hir {
    /// The number of [`Value`]s that a value of this type consists of; samplers count as none.
    pub fn value_count(&self, ty: Type) -> u32 {
        value_count(&self.structs, ty)
    }
}

/// The number of [`Value`]s that a value of a type consists of; samplers count as none.
pub fn value_count(structs: &Arena<Struct>, ty: Type) -> u32 {
    Content::of(ty, structs).values
}
