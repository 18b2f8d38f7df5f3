//! Where the parser stands, the tree as far as it is built, and what it found wrong.

use super::Parsed;
use super::ast::{
    Ast, Callee, Expr, ExprKind, Extent, Item, Stmt, StmtKind, TokenIndex, TypeSpecifier,
};
use super::expression::Pending;
use super::lexeme::{self, Lexeme, Symbol, blame, blame_behind, quoted};
use super::statement::Arm;
use super::words::{Word, instead_of};
use crate::glsl::arena::Id;
use crate::glsl::names::Name;
use crate::glsl::preprocess::Token;
use crate::source::Diagnostic;

/// The deepest tree of an expression: as many operators in a row, or brackets in brackets.
pub const MAX_EXPRESSION_HEIGHT: usize = 20_000;

/// The deepest tree of a statement, where each `else` counts.
pub const MAX_STATEMENT_HEIGHT: usize = 3_000;

/// How deep brackets, `?:` and assignments nest. The parser recurses on them.
const MAX_NESTING: usize = 6_000;

/// More errors than this are no help.
const MAX_ERRORS: usize = 20;

/// An error was reported, and what was being parsed is no more.
#[derive(Debug)]
pub(super) struct Failed;

/// A part of the tree.
pub(super) type Parse<T> = Result<T, Failed>;

#[derive(Debug)]
pub(super) struct Parser<'a> {
    tokens: &'a [Token<'a>],
    lexemes: Vec<Lexeme>,
    reserved: Vec<(Name, TokenIndex)>,
    at: usize,
    pub ast: Ast,
    expression_heights: Vec<u16>,
    statement_heights: Vec<u16>,
    /// How deep the expression at hand is nested.
    nesting: usize,
    /// How deep the statement at hand is nested.
    pub blocks: usize,
    /// Whether a brace seems to be missing or too many, so that little else can be said of braces.
    pub braces_are_off: bool,
    diagnostics: Vec<(usize, Diagnostic)>,
    /// Nothing is reported about tokens before this one: something was, already.
    quiet_until: usize,
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
    pub fn new(tokens: &'a [Token<'a>]) -> Self {
        let mut ast = Ast::default();
        let read = lexeme::read(tokens, &mut ast.names);
        Parser {
            tokens,
            lexemes: read.list,
            reserved: read.reserved,
            at: 0,
            ast,
            expression_heights: Vec::new(),
            statement_heights: Vec::new(),
            nesting: 0,
            blocks: 0,
            braces_are_off: false,
            diagnostics: Vec::new(),
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

    /// The tree and the diagnostics.
    pub fn finish(mut self, strict: bool) -> Parsed {
        let reserved = std::mem::take(&mut self.reserved);
        for (name, at) in reserved {
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
        let bracket = &self.tokens[open].text;
        let hint = match open.checked_sub(1).map(|before| self.lexemes[before]) {
            Some(Lexeme::Name(_) | Lexeme::Type(_) | Lexeme::Word(_)) => {
                let before = quoted(&self.tokens[open - 1]);
                format!("the `{bracket}` behind {before} is still open")
            }
            _ => format!("a `{bracket}` before it is still open"),
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
            Lexeme::Name(_)
            | Lexeme::Type(_)
            | Lexeme::Word(_)
            | Lexeme::Symbol(Symbol::RightBrace)
                if self.at > 0 && self.blamed_word().is_none() =>
            {
                let found = quoted(&self.tokens[self.at]);
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
}

/// Building.
impl Parser<'_> {
    /// What begins at a token and ends before the one at hand.
    pub fn extent_from(&self, first: TokenIndex) -> Extent {
        let last = (self.here().saturating_sub(1)).max(first);
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
        let at = self.here();
        self.expression_heights.push(1);
        self.ast.exprs.add(Expr {
            kind: ExprKind::Bool(true),
            at,
            extent: Extent::of(at),
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
            ExprKind::Call(callee, arguments) => highest(arguments).max(match callee {
                Callee::Name(_) => 0,
                Callee::Method(object, _) => height(object),
                Callee::Type(TypeSpecifier { sizes, .. }) => {
                    let sizes = sizes.iter().filter_map(|size| size.size.as_ref());
                    sizes.map(height).max().unwrap_or(0)
                }
            }),
        }
    }

    /// Adds a statement that begins at `first` and ends before the token at hand.
    pub fn add_statement(&mut self, kind: StmtKind, first: TokenIndex) -> Id<Stmt> {
        let height = |stmt: &Id<Stmt>| usize::from(self.statement_heights[stmt.index()]);
        let highest = |stmts: &[Id<Stmt>]| stmts.iter().map(height).max().unwrap_or(0);
        let height = 1 + match &kind {
            StmtKind::Block(body) | StmtKind::Switch { body, .. } => highest(body),
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
            let message = format!("an expression is nested more than {MAX_NESTING} deep");
            return Err(self.too_deep(self.here(), message, "assign parts of it to variables"));
        }
        Ok(())
    }

    /// Comes back from [`Parser::enter`]. After an error [`Parser::settle`] does it.
    pub fn leave(&mut self) {
        self.nesting -= 1;
    }
}

/// What is wrong.
impl Parser<'_> {
    /// Reports a diagnostic about what was found at a token, unless it is a consequence of another.
    pub fn report(&mut self, at: usize, diagnostic: Diagnostic) {
        if at < self.quiet_until || self.lexemes[at] == Lexeme::Refused {
            return;
        }
        self.quiet_until = at + 1;
        self.diagnostics.push((at, diagnostic));
        if self.diagnostics.len() >= MAX_ERRORS {
            self.give_up();
        }
    }

    /// Goes to the end of the text and reports no more.
    pub fn give_up(&mut self) {
        self.at = self.lexemes.len() - 1;
        self.quiet_until = usize::MAX;
    }

    /// Reports that something else was expected at the token at hand.
    pub fn unexpected(&mut self, expected: &str) -> Failed {
        self.unexpected_but(expected, None)
    }

    /// Like [`Parser::unexpected`], with a hint.
    pub fn unexpected_but(&mut self, expected: &str, hint: Option<&str>) -> Failed {
        if self.peek() == Lexeme::End {
            return self.too_early(expected);
        }
        if let Some((name, at)) = self.blamed_word() {
            let word = self.ast.names.text(name);
            let message = format!("`{word}` is a reserved word and means nothing here");
            let diagnostic = Diagnostic::error("reserved-word", message).hint(instead_of(word));
            let diagnostic = blame(&self.tokens[at], diagnostic);
            self.reserved.retain(|(reserved, _)| *reserved != name);
            self.report(self.at, diagnostic);
            return Failed;
        }
        let found = quoted(&self.tokens[self.at]);
        let message = format!("expected {expected}, found {found}");
        self.wrong(self.at, message, hint)
    }

    /// Reports a mistake at a token.
    pub fn wrong(&mut self, at: usize, message: impl Into<String>, hint: Option<&str>) -> Failed {
        let mut diagnostic = Diagnostic::error("syntax", message);
        if let Some(hint) = hint {
            diagnostic = diagnostic.hint(hint);
        }
        self.report(at, blame(&self.tokens[at], diagnostic));
        Failed
    }

    /// Reports a mistake that the token at hand gives away about an earlier one.
    pub fn wrong_about(&mut self, earlier: usize, message: String, hint: &str) -> Failed {
        let diagnostic = Diagnostic::error("syntax", message).hint(hint);
        match self.blamed_word() {
            Some(_) => self.unexpected("something else"),
            None => {
                self.report(self.at, blame(&self.tokens[earlier], diagnostic));
                Failed
            }
        }
    }

    /// A token as messages quote it.
    pub fn spelling(&self, at: usize) -> String {
        quoted(&self.tokens[at])
    }

    fn too_early(&mut self, expected: &str) -> Failed {
        if let Some(last) = self.tokens.last() {
            let diagnostic = Diagnostic::error("syntax", "the text ends too early")
                .hint(format!("{expected} is missing, here or somewhere above"));
            let diagnostic = blame_behind(last, diagnostic);
            if !self.braces_are_off {
                self.report(self.at, diagnostic);
            }
        }
        Failed
    }

    /// Reports that something is nested beyond reason.
    pub fn too_deep(&mut self, at: TokenIndex, message: String, hint: &str) -> Failed {
        let at = (at as usize).min(self.tokens.len() - 1);
        let diagnostic = Diagnostic::error("too-deep", message).hint(hint);
        let diagnostic = blame(&self.tokens[at], diagnostic);
        self.report(self.at.min(self.lexemes.len() - 1), diagnostic);
        Failed
    }

    /// A reserved word at hand or just before, which explains why nothing fits.
    fn blamed_word(&self) -> Option<(Name, usize)> {
        let places = [self.at.checked_sub(1), Some(self.at)];
        places.into_iter().flatten().find_map(|at| {
            let Lexeme::Name(name) = self.lexemes[at] else {
                return None;
            };
            let is_member = at > 0 && self.lexemes[at - 1] == Lexeme::Symbol(Symbol::Dot);
            let is_reserved = self.reserved.iter().any(|(reserved, _)| *reserved == name);
            (is_reserved && !is_member).then_some((name, at))
        })
    }
}

/// Going on behind what is wrong.
impl Parser<'_> {
    /// Forgets what was begun; the next token may well be wrong for the same reason as the last.
    pub fn settle(&mut self) {
        self.nesting = 0;
        self.pending.clear();
        self.arguments.clear();
        self.quiet_until = self.quiet_until.max(self.at + 1);
    }

    /// Moves behind the end of a statement that begins at `start`, but not out of its block.
    pub fn skip_statement(&mut self, start: usize) {
        loop {
            match self.peek() {
                Lexeme::End | Lexeme::Symbol(Symbol::RightBrace) => break,
                Lexeme::Symbol(Symbol::Semicolon) => {
                    self.advance();
                    break;
                }
                Lexeme::Symbol(Symbol::LeftBrace) => {
                    self.skip_braces();
                    break;
                }
                Lexeme::Word(word)
                    if self.at > start && (word.begins_statement() || word == Word::Else) =>
                {
                    break;
                }
                _ => {
                    self.advance();
                }
            }
        }
        self.settle();
    }

    /// Moves to where another item is likely to begin, at least by one token from `start`.
    pub fn skip_item(&mut self, start: usize) {
        loop {
            match self.peek() {
                Lexeme::End => break,
                Lexeme::Symbol(Symbol::Semicolon) => {
                    self.advance();
                    break;
                }
                Lexeme::Symbol(Symbol::LeftBrace) => {
                    self.skip_braces();
                    self.accept(Symbol::Semicolon);
                    break;
                }
                _ if self.at > start && self.begins_item() => break,
                _ => {
                    self.advance();
                }
            }
        }
        self.settle();
    }

    fn begins_item(&self) -> bool {
        match self.peek() {
            Lexeme::Symbol(Symbol::RightBrace)
            | Lexeme::Word(Word::Struct | Word::Uniform | Word::Precision | Word::Const) => true,
            Lexeme::Type(_) | Lexeme::Name(_) => matches!(
                (self.peek_at(1), self.peek_at(2)),
                (
                    Lexeme::Name(_),
                    Lexeme::Symbol(Symbol::LeftParenthesis | Symbol::Assign)
                )
            ),
            _ => false,
        }
    }

    /// Moves from a `{` behind its `}`.
    fn skip_braces(&mut self) {
        let mut depth = 0;
        loop {
            match self.peek() {
                Lexeme::End => return,
                Lexeme::Symbol(Symbol::LeftBrace) => depth += 1,
                Lexeme::Symbol(Symbol::RightBrace) => depth -= 1,
                _ => {}
            }
            self.advance();
            if depth == 0 {
                return;
            }
        }
    }

    /// Moves behind the `)` of the `(` at `open`, which something before the token at hand follows.
    /// Stops before what cannot stand in parentheses.
    pub fn skip_header(&mut self, open: TokenIndex, may_hold_semicolons: bool) {
        let here = self.at;
        self.at = open as usize;
        let mut depth = 0;
        loop {
            match self.peek() {
                Lexeme::Symbol(Symbol::LeftParenthesis) => depth += 1,
                Lexeme::Symbol(Symbol::RightParenthesis) => depth -= 1,
                Lexeme::End | Lexeme::Symbol(Symbol::LeftBrace | Symbol::RightBrace) => break,
                Lexeme::Symbol(Symbol::Semicolon) if !may_hold_semicolons => break,
                _ => {}
            }
            self.advance();
            if depth == 0 {
                break;
            }
        }
        self.at = self.at.max(here);
        self.settle();
    }

    /// Reads what stands in the `(…)` of a statement. If it is wrong, moves behind the `)`, so that
    /// the statement's body can be read all the same.
    pub fn in_header<T>(
        &mut self,
        open: TokenIndex,
        may_hold_semicolons: bool,
        read: impl FnOnce(&mut Self) -> Parse<T>,
    ) -> Parse<T> {
        let content = read(self).and_then(|content| {
            self.close(open, Symbol::RightParenthesis, "`)`")?;
            Ok(content)
        });
        if content.is_err() {
            self.skip_header(open, may_hold_semicolons);
        }
        content
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
}
