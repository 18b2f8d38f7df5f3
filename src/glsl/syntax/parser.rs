//! Where the parser stands, the tree as far as it is built, and what it found wrong.

use super::Parsed;
use super::ast::{Ast, Callee, Expr, ExprKind, Extent, Item, Stmt, StmtKind, TokenIndex};
use super::expression::Pending;
use super::lexeme::{self, Lexeme, blame, blame_behind};
use super::statement::Arm;
use crate::glsl::arena::Id;
use crate::glsl::names::{Name, Names};
use crate::glsl::preprocess::Token;
use crate::glsl::words::{Symbol, Word, instead_of};
use crate::source::Diagnostic;

/// The deepest tree of an expression: as many operators in a row, or brackets in brackets.
pub const MAX_EXPRESSION_HEIGHT: usize = 20_000;

/// The deepest tree of a statement, where each `else` counts.
pub const MAX_STATEMENT_HEIGHT: usize = 3_000;

/// How deep brackets, `?:` and assignments nest. The parser recurses on them.
const MAX_NESTING: usize = 6_000;

/// More errors than this are no help.
pub(super) const MAX_ERRORS: usize = 20;

/// An error was reported, and what was being parsed is no more.
#[derive(Debug)]
pub(super) struct Failed;

/// A part of the tree.
pub(super) type Parse<T> = Result<T, Failed>;

#[derive(Debug)]
pub(super) struct Parser<'a> {
    pub tokens: &'a [Token],
    pub lexemes: Vec<Lexeme>,
    pub reserved: Vec<(Name, TokenIndex)>,
    /// Reserved words that an error was about.
    pub blamed: Vec<Name>,
    pub at: usize,
    pub ast: Ast,
    expression_heights: Vec<u16>,
    statement_heights: Vec<u16>,
    /// How deep the expression at hand is nested.
    pub nesting: usize,
    /// How deep the statement at hand is nested.
    pub blocks: usize,
    /// Whether a brace seems to be missing or too many, so that little else can be said of braces.
    pub braces_are_off: bool,
    pub diagnostics: Vec<(usize, Diagnostic)>,
    /// Keywords that were used as names.
    pub misused: Vec<Lexeme>,
    /// Nothing is reported about tokens before this one: something was, already.
    pub quiet_until: usize,
    /// Operators and their left operands that wait for the right one.
    pub pending: Vec<Pending>,
    /// Arguments of the calls at hand.
    pub arguments: Vec<Id<Expr>>,
    /// Statements of the blocks at hand.
    pub statements: Vec<Id<Stmt>>,
    /// The rungs of the `else if` ladders at hand.
    pub arms: Vec<Arm>,
}

impl<'a> Parser<'a> {
    pub fn new(tokens: &'a [Token], names: Names) -> Self {
        let read = lexeme::read(tokens, &names);
        let mut ast = Ast {
            names,
            ..Ast::default()
        };
        // About as many as there are in most texts; the largest may well be wrong before their end.
        let size = tokens.len().min(1 << 16);
        ast.exprs.reserve(size / 2);
        ast.arguments.reserve(size / 8);
        ast.stmts.reserve(size / 16);
        ast.bodies.reserve(size / 16);
        ast.declarations.reserve(size / 32);
        ast.declarators.reserve(size / 32);
        Parser {
            tokens,
            lexemes: read.list,
            reserved: read.reserved,
            blamed: Vec::new(),
            at: 0,
            ast,
            expression_heights: Vec::with_capacity(size / 2),
            statement_heights: Vec::with_capacity(size / 16),
            nesting: 0,
            blocks: 0,
            braces_are_off: false,
            diagnostics: Vec::new(),
            misused: Vec::new(),
            quiet_until: 0,
            pending: Vec::new(),
            arguments: Vec::new(),
            statements: Vec::new(),
            arms: Vec::new(),
        }
    }

    /// Everything, one item after the other.
    pub fn translation_unit(&mut self) {
        while self.peek() != Lexeme::End {
            let start = self.at;
            match self.item() {
                Ok(item) => self.ast.items.extend(item),
                Err(Failed) => self.skip_item(start),
            }
            debug_assert!(self.at > start, "no progress at token {start}");
        }
    }

    /// Reads an item; `None` if there is nothing to keep of it.
    fn item(&mut self) -> Parse<Option<Item>> {
        match self.peek() {
            Lexeme::Symbol(Symbol::Semicolon) => Ok(Some(Item::Empty(self.advance()))),
            Lexeme::Symbol(Symbol::RightBrace) => {
                let at = self.at;
                if !self.braces_are_off {
                    self.wrong(at, "there is one `}` too many", None);
                    self.braces_are_off = true;
                }
                self.advance();
                Ok(None)
            }
            _ => self.external_declaration().map(Some),
        }
    }

    /// The tree and the diagnostics.
    pub fn finish(mut self, strict: bool) -> Parsed {
        for (name, at) in self.reserved {
            if self.blamed.contains(&name) {
                continue;
            }
            let word = self.ast.names.text(name);
            let diagnostic = match strict {
                true => Diagnostic::error("reserved-word", format!("`{word}` is a reserved word")),
                false => Diagnostic::warning(
                    "reserved-word",
                    format!("`{word}` is a reserved word, which WebGL2 refuses"),
                ),
            };
            let diagnostic = blame(&self.tokens[at as usize], diagnostic).hint(instead_of(word));
            self.diagnostics.push((at as usize, diagnostic));
        }
        self.diagnostics.sort_by_key(|(at, _)| *at);
        let mut errors = 0;
        let is_wanted = |diagnostic: &Diagnostic| {
            errors += usize::from(diagnostic.is_error());
            !diagnostic.is_error() || errors <= MAX_ERRORS
        };
        let diagnostics = self
            .diagnostics
            .into_iter()
            .map(|(_, diagnostic)| diagnostic);
        Parsed {
            ast: self.ast,
            diagnostics: diagnostics.filter(is_wanted).collect(),
        }
    }
}

/// Reading.
impl Parser<'_> {
    /// The token at hand.
    pub fn peek(&self) -> Lexeme {
        self.lexemes[self.at]
    }

    /// The token behind the one at hand, or further.
    pub fn peek_at(&self, ahead: usize) -> Lexeme {
        let last = self.lexemes.len() - 1;
        self.lexemes[(self.at + ahead).min(last)]
    }

    /// The token at a place.
    pub fn lexeme(&self, at: TokenIndex) -> Lexeme {
        self.lexemes[at as usize]
    }

    /// Whether this operator or bracket is at hand.
    pub fn is(&self, symbol: Symbol) -> bool {
        self.peek() == Lexeme::Symbol(symbol)
    }

    /// The place of the token at hand.
    pub fn here(&self) -> TokenIndex {
        self.at as TokenIndex
    }

    /// Moves on and gives the place of the token that was at hand.
    pub fn advance(&mut self) -> TokenIndex {
        let here = self.at;
        self.at = (here + 1).min(self.lexemes.len() - 1);
        here as TokenIndex
    }

    /// Moves over an operator or bracket if it is at hand.
    pub fn accept(&mut self, symbol: Symbol) -> bool {
        let is = self.is(symbol);
        if is {
            self.advance();
        }
        is
    }

    /// Moves over a keyword if it is at hand.
    pub fn accept_word(&mut self, word: Word) -> bool {
        let is = self.peek() == Lexeme::Word(word);
        if is {
            self.advance();
        }
        is
    }

    /// Moves over a name.
    pub fn name(&mut self, expected: &str) -> Parse<(Name, TokenIndex)> {
        match self.peek() {
            Lexeme::Name(name) => Ok((name, self.advance())),
            _ => Err(self.unexpected(expected)),
        }
    }

    /// Moves over the `)` or `]` that belongs to the bracket at `open`.
    pub fn close(&mut self, open: TokenIndex, symbol: Symbol, expected: &str) -> Parse<()> {
        if self.accept(symbol) {
            return Ok(());
        }
        let open = open as usize;
        let bracket = self.spelling(open);
        let hint = match open.checked_sub(1).map(|before| self.lexemes[before]) {
            Some(Lexeme::Name(_) | Lexeme::Type(_) | Lexeme::Word(_)) => {
                let before = self.spelling(open - 1);
                format!("the {bracket} behind {before} is still open")
            }
            _ => format!("a {bracket} before it is still open"),
        };
        Err(self.unexpected_but(expected, Some(&hint)))
    }

    /// Moves over the `;` at the end of something.
    pub fn semicolon(&mut self, expected: &str) -> Parse<()> {
        match self.peek() {
            Lexeme::Symbol(Symbol::Semicolon) => {
                self.advance();
                Ok(())
            }
            // What follows looks like something new, so that the `;` is all that is missing.
            Lexeme::Name(_) if self.is_behind_cast() => {
                let hint = "GLSL converts with `float(x)`, not with `(float)x`";
                Err(self.unexpected_but(expected, Some(hint)))
            }
            Lexeme::Name(_)
            | Lexeme::Type(_)
            | Lexeme::Word(_)
            | Lexeme::Symbol(Symbol::RightBrace)
                if self.at > 0 =>
            {
                let found = self.spelling(self.at);
                let message = format!("a `;` is missing before {found}");
                let diagnostic = Diagnostic::error("syntax", message);
                let diagnostic = blame_behind(&self.tokens[self.at - 1], diagnostic);
                self.report(self.at, diagnostic);
                Ok(())
            }
            Lexeme::Symbol(Symbol::RightParenthesis) => {
                Err(self.unexpected_but(expected, Some("there is one `)` too many before it")))
            }
            Lexeme::Symbol(Symbol::Assign) => Err(self.unexpected_but(
                expected,
                Some("only variables and parts of them can be assigned to"),
            )),
            _ => Err(self.unexpected(expected)),
        }
    }

    /// Whether a name in parentheses precedes the token at hand.
    fn is_behind_cast(&self) -> bool {
        use Symbol::{Assign, LeftParenthesis, RightParenthesis};
        matches!(
            self.lexemes[..self.at],
            [
                ..,
                Lexeme::Symbol(Assign),
                Lexeme::Symbol(LeftParenthesis),
                Lexeme::Name(_),
                Lexeme::Symbol(RightParenthesis)
            ]
        )
    }
}

/// Building.
impl Parser<'_> {
    /// What begins at a token and ends before the one at hand.
    pub fn extent_from(&self, first: TokenIndex) -> Extent {
        // Something that is missing at the end of the text is said to be the last token.
        let first = first.min((self.tokens.len() as TokenIndex).saturating_sub(1));
        let last = self.here().saturating_sub(1).max(first);
        Extent { first, last }
    }

    /// The first token of an expression.
    pub fn first_of(&self, expr: Id<Expr>) -> TokenIndex {
        self.ast.exprs[expr].extent.first
    }

    /// Adds an expression that begins at `first` and ends before the token at hand.
    pub fn add(&mut self, kind: ExprKind, at: TokenIndex, first: TokenIndex) -> Parse<Id<Expr>> {
        let height = self.expression_height(&kind) + 1;
        if height > MAX_EXPRESSION_HEIGHT {
            let message = format!("one expression has more than {MAX_EXPRESSION_HEIGHT} levels");
            return Err(self.too_deep(at, message, "assign parts of it to variables"));
        }
        let extent = self.extent_from(first);
        self.expression_heights.push(height as u16);
        Ok(self.ast.exprs.add(Expr { kind, at, extent }))
    }

    /// Adds an expression in the place of one that is wrong.
    pub fn add_stand_in(&mut self) -> Id<Expr> {
        let extent = self.extent_from(self.here());
        self.expression_heights.push(1);
        self.ast.exprs.add(Expr {
            kind: ExprKind::Bool(true),
            at: extent.first,
            extent,
        })
    }

    fn expression_height(&self, kind: &ExprKind) -> usize {
        let height = |expr: &Id<Expr>| usize::from(self.expression_heights[expr.index()]);
        let highest = |exprs: &[Id<Expr>]| exprs.iter().map(height).max().unwrap_or(0);
        match kind {
            ExprKind::Name(_)
            | ExprKind::Bool(_)
            | ExprKind::Int(_)
            | ExprKind::Uint(_)
            | ExprKind::Float(_) => 0,
            ExprKind::Unary(_, part)
            | ExprKind::Increment { place: part, .. }
            | ExprKind::Member(part, _) => height(part),
            ExprKind::Binary(_, left, right)
            | ExprKind::Assign(_, left, right)
            | ExprKind::Comma(left, right)
            | ExprKind::Index(left, right) => height(left).max(height(right)),
            ExprKind::Ternary(condition, yes, no) => highest(&[*condition, *yes, *no]),
            ExprKind::Call(callee, arguments) => {
                highest(self.ast.arguments.get(*arguments)).max(match callee {
                    Callee::Name(_) => 0,
                    Callee::Method(object, _) => height(object),
                    Callee::Type(ty) => {
                        let sizes = self.ast.sizes.get(self.ast.types[*ty].sizes).iter();
                        let sizes = sizes.filter_map(|size| size.size.as_ref());
                        sizes.map(height).max().unwrap_or(0)
                    }
                })
            }
        }
    }

    /// Adds a statement that begins at `first` and ends before the token at hand.
    pub fn add_statement(&mut self, kind: StmtKind, first: TokenIndex) -> Id<Stmt> {
        let height = |stmt: &Id<Stmt>| usize::from(self.statement_heights[stmt.index()]);
        let highest = |stmts: &[Id<Stmt>]| stmts.iter().map(height).max().unwrap_or(0);
        let height = 1 + match &kind {
            StmtKind::Block(body) | StmtKind::Switch { body, .. } => {
                highest(self.ast.bodies.get(*body))
            }
            StmtKind::If { then, other, .. } => height(then).max(highest(other.as_slice())),
            StmtKind::While { body, .. }
            | StmtKind::DoWhile { body, .. }
            | StmtKind::For { body, .. } => height(body),
            _ => 0,
        };
        if height > MAX_STATEMENT_HEIGHT {
            let message = format!("statements are nested more than {MAX_STATEMENT_HEIGHT} deep");
            self.too_deep(first, message, "move part of it into a function");
            self.give_up();
            return self.add_statement(StmtKind::Empty, first);
        }
        let extent = self.extent_from(first);
        self.statement_heights.push(height as u16);
        self.ast.stmts.add(Stmt { kind, extent })
    }

    /// Goes one level deeper into an expression.
    pub fn enter(&mut self) -> Parse<()> {
        self.nesting += 1;
        if self.nesting > MAX_NESTING {
            let message = format!("this is nested more than {MAX_NESTING} deep");
            return Err(self.too_deep(self.here(), message, "assign parts of it to variables"));
        }
        Ok(())
    }

    /// Comes back from [`Parser::enter`]. After an error [`Parser::settle`] does it.
    pub fn leave(&mut self) {
        self.nesting -= 1;
    }
}
