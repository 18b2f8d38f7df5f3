//! Statements, §6.

use super::ast::{Condition, Declaration, Declarator, Expr, Sizes, Stmt, StmtKind, TokenIndex};
use super::declaration::Declared;
use super::lexeme::Lexeme;
use super::parser::{Failed, Parse, Parser};
use crate::glsl::arena::{Id, Range};
use crate::glsl::words::{Symbol, Word};

/// How deep statements nest, `else if` apart. The parser recurses on them.
const MAX_NESTING: usize = 1_000;

/// How many `else if`s may follow one another. The tree nests in them.
const MAX_LADDER: usize = 2_000;

/// One rung of an `else if` ladder.
#[derive(Clone, Copy, Debug)]
pub(super) struct Arm {
    first: TokenIndex,
    condition: Id<Expr>,
    then: Id<Stmt>,
}

impl Parser<'_> {
    /// A block from its `{`.
    pub fn block(&mut self) -> Parse<Id<Stmt>> {
        let first = self.here();
        let body = self.braced_statements()?;
        Ok(self.add_statement(StmtKind::Block(body), first))
    }

    fn braced_statements(&mut self) -> Parse<Range<Id<Stmt>>> {
        if !self.accept(Symbol::LeftBrace) {
            return Err(self.unexpected("`{`"));
        }
        let base = self.statements.len();
        while !self.accept(Symbol::RightBrace) {
            if self.peek() == Lexeme::End {
                self.unexpected("a `}`, a `)` or a `;`");
                break;
            }
            let statement = self.statement();
            self.statements.push(statement);
        }
        let body = self.ast.bodies.add(&self.statements[base..]);
        self.statements.truncate(base);
        Ok(body)
    }

    /// A statement. If it is wrong, what stands in its place does nothing.
    pub fn statement(&mut self) -> Id<Stmt> {
        let first = self.here();
        self.blocks += 1;
        let kind = match self.blocks > MAX_NESTING {
            false => self.statement_kind(),
            true => {
                let message = format!("statements are nested more than {MAX_NESTING} deep");
                let failed = self.too_deep(first, message, "move part of it into a function");
                self.give_up();
                Err(failed)
            }
        };
        self.blocks -= 1;
        let kind = kind.unwrap_or_else(|Failed| {
            self.skip_statement(first as usize);
            StmtKind::Empty
        });
        self.add_statement(kind, first)
    }

    fn statement_kind(&mut self) -> Parse<StmtKind> {
        match self.peek() {
            Lexeme::Symbol(Symbol::LeftBrace) => Ok(StmtKind::Block(self.braced_statements()?)),
            Lexeme::Symbol(Symbol::Semicolon) => {
                self.advance();
                Ok(StmtKind::Empty)
            }
            Lexeme::Word(word) if word.begins_statement() => self.controlled(word),
            Lexeme::Word(Word::Else) => {
                let at = self.advance() as usize;
                let hint = "is there a `;` too many before it, or a `{` missing?";
                self.wrong(at, "this `else` has no `if`", Some(hint));
                // What follows may still be right or wrong by itself.
                let statement = self.statement();
                Ok(StmtKind::Block(self.ast.bodies.add(&[statement])))
            }
            _ if self.starts_declaration() => self.local_declaration().map(StmtKind::Declaration),
            Lexeme::Symbol(Symbol::RightParenthesis) => {
                let hint = "there is one `)` too many";
                Err(self.unexpected_but("a statement", Some(hint)))
            }
            _ => {
                let expr = self.expression()?;
                self.semicolon("`;`")?;
                Ok(StmtKind::Expression(expr))
            }
        }
    }

    fn local_declaration(&mut self) -> Parse<Id<Declaration>> {
        let declaration = match self.declared()? {
            Declared::Declaration(declaration) => declaration,
            Declared::Function(header) => {
                if !self.braces_are_off {
                    let message = "a function cannot be defined inside another";
                    let hint = "is a `}` missing above it?";
                    self.wrong(header.at as usize, message, Some(hint));
                    self.braces_are_off = true;
                }
                // The body's own mistakes are worth telling.
                self.braced_statements()?;
                Declaration::Prototype(header)
            }
        };
        Ok(self.ast.declarations.add(declaration))
    }

    /// A statement that begins with a keyword.
    fn controlled(&mut self, word: Word) -> Parse<StmtKind> {
        if word == Word::If {
            return self.ladder();
        }
        self.advance();
        match word {
            Word::Switch => {
                let open = self.open(word)?;
                let selector = self.in_header(open, false, "`)`", Self::expression);
                let body = self.braced_statements()?;
                let selector = selector?;
                Ok(StmtKind::Switch { selector, body })
            }
            Word::Case => {
                let value = self.conditional()?;
                self.colon()?;
                Ok(StmtKind::Label(Some(value)))
            }
            Word::Default => {
                self.colon()?;
                Ok(StmtKind::Label(None))
            }
            Word::While => {
                let open = self.open(word)?;
                let condition = self.in_header(open, false, "`)`", Self::condition);
                let body = self.statement();
                let condition = condition?;
                Ok(StmtKind::While { condition, body })
            }
            Word::Do => {
                let body = self.statement();
                if !self.accept_word(Word::While) {
                    return Err(self.unexpected("`while` behind the body of `do`"));
                }
                let open = self.open(Word::While)?;
                let condition = self.in_header(open, false, "`)`", Self::expression);
                self.semicolon("`;`")?;
                let condition = condition?;
                Ok(StmtKind::DoWhile { body, condition })
            }
            Word::For => self.for_loop(),
            Word::Return if self.accept(Symbol::Semicolon) => Ok(StmtKind::Return(None)),
            Word::Return => {
                let value = self.expression()?;
                self.semicolon("`;`")?;
                Ok(StmtKind::Return(Some(value)))
            }
            _ => {
                self.semicolon("`;`")?;
                Ok(match word {
                    Word::Break => StmtKind::Break,
                    Word::Continue => StmtKind::Continue,
                    _ => StmtKind::Discard,
                })
            }
        }
    }

    /// The `(` behind a keyword.
    fn open(&mut self, word: Word) -> Parse<TokenIndex> {
        let at = self.here();
        match self.accept(Symbol::LeftParenthesis) {
            true => Ok(at),
            false => Err(self.unexpected(&format!("`(` behind `{word}`"))),
        }
    }

    fn colon(&mut self) -> Parse<()> {
        match self.accept(Symbol::Colon) {
            true => Ok(()),
            false => Err(self.unexpected("`:`")),
        }
    }

    /// `if … else if … else …`, without recursion along the ladder.
    fn ladder(&mut self) -> Parse<StmtKind> {
        let base = self.arms.len();
        let other = loop {
            let first = self.advance();
            let open = match self.open(Word::If) {
                Ok(open) => open,
                Err(failed) => {
                    self.arms.truncate(base);
                    return Err(failed);
                }
            };
            let condition = self.in_header(open, false, "`)`", Self::expression);
            let condition = condition.unwrap_or_else(|Failed| self.add_stand_in());
            let then = self.statement();
            self.arms.push(Arm {
                first,
                condition,
                then,
            });
            let at = self.here();
            if !self.accept_word(Word::Else) {
                break None;
            }
            if self.peek() != Lexeme::Word(Word::If) {
                break Some(self.statement());
            }
            if self.arms.len() - base > MAX_LADDER {
                let message = format!("more than {MAX_LADDER} `else if` follow one another");
                self.too_deep(at, message, "use a `switch`, a loop or functions");
                self.give_up();
                break None;
            }
        };
        let mut other = other;
        while self.arms.len() > base + 1 {
            let Some(arm) = self.arms.pop() else { break };
            let kind = StmtKind::If {
                condition: arm.condition,
                then: arm.then,
                other,
            };
            other = Some(self.add_statement(kind, arm.first));
        }
        let outermost = self.arms.pop().ok_or(Failed)?;
        Ok(StmtKind::If {
            condition: outermost.condition,
            then: outermost.then,
            other,
        })
    }

    fn for_loop(&mut self) -> Parse<StmtKind> {
        let open = self.open(Word::For)?;
        let header = self.in_header(open, true, "`)`", |parser| {
            let init = parser.for_init()?;
            let condition = match parser.is(Symbol::Semicolon) {
                true => None,
                false => Some(parser.condition()?),
            };
            parser.for_semicolon()?;
            let step = match parser.is(Symbol::RightParenthesis) {
                true => None,
                false => Some(parser.expression()?),
            };
            Ok((init, condition, step))
        });
        let body = self.statement();
        let (init, condition, step) = header?;
        Ok(StmtKind::For {
            init,
            condition,
            step,
            body,
        })
    }

    fn for_init(&mut self) -> Parse<Id<Stmt>> {
        let first = self.here();
        let kind = if self.accept(Symbol::Semicolon) {
            StmtKind::Empty
        } else if self.starts_declaration() {
            StmtKind::Declaration(self.local_declaration()?)
        } else {
            let expr = self.expression()?;
            self.for_semicolon()?;
            StmtKind::Expression(expr)
        };
        Ok(self.add_statement(kind, first))
    }

    fn for_semicolon(&mut self) -> Parse<()> {
        match self.accept(Symbol::Semicolon) {
            true => Ok(()),
            false => {
                let hint = "a `for` has three parts: `for (int i = 0; i < 8; i++)`";
                Err(self.unexpected_but("`;`", Some(hint)))
            }
        }
    }

    /// What `while` and `for` go by.
    fn condition(&mut self) -> Parse<Condition> {
        if !self.starts_declaration() {
            return Ok(Condition::Expression(self.expression()?));
        }
        let ty = self.qualified_type()?;
        let (name, at) = self.name("a name")?;
        if !self.accept(Symbol::Assign) {
            return Err(self.unexpected("`=`"));
        }
        let init = self.assignment()?;
        let declarator = Declarator {
            name,
            at,
            sizes: Sizes::default(),
            init: Some(init),
        };
        let declarators = self.ast.declarators.add(&[declarator]);
        let declaration = Declaration::Variables { ty, declarators };
        Ok(Condition::Declaration(
            self.ast.declarations.add(declaration),
        ))
    }
}
