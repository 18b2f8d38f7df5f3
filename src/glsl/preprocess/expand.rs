//! Replaces the uses of macros by their text.
//!
//! A macro's arguments are expanded by themselves before they are put into its text, and that text is
//! then read again together with what follows it. Arguments within arguments are levels on a stack of
//! our own, not on the machine's.

use std::rc::Rc;

use super::call::Call;
use super::directive::Directives;
use super::macros::{MacroId, Maker};
use super::token::{Kind, Token};
use super::{MAX_BROUGHT, MAX_READ};
use crate::glsl::names::Name;
use crate::glsl::words::Symbol;
use crate::source::{Diagnostic, Span};

/// An expansion under way.
#[derive(Debug)]
pub(super) struct Expansion {
    /// The last one is being read; the one before waits for it as an argument.
    pub(super) levels: Vec<Level>,
    /// The outermost macro in use.
    outermost: Option<(MacroId, Token)>,
}

/// What the expansions of a text have cost.
#[derive(Debug, Default)]
pub(super) struct Costs {
    /// Tokens read from macros and arguments so far.
    pub(super) read: usize,
    /// Tokens that macros have brought so far.
    brought: usize,
    /// Tokens in memory on the way.
    pub(super) held: usize,
    /// Whether it was said that a browser refuses so large a call.
    pub(super) has_warned: bool,
}

/// What is expanded by itself: the text, or an argument.
#[derive(Debug)]
pub(super) struct Level {
    pub(super) input: Input,
    /// Texts of macros, to be read before the input goes on; the last first.
    contexts: Vec<Context>,
    /// The tokens in `contexts`, those that were read included.
    pub(super) in_contexts: usize,
    /// A token of the input that was read too early.
    put_back: Option<Token>,
    /// Whether the arguments of a macro are being read.
    pub(super) is_calling: bool,
    /// Macros whose text ended within the arguments of another: they stay active until those are
    /// complete.
    pub(super) ending: Vec<MacroId>,
    /// The call that an argument is being expanded for.
    pub(super) call: Option<Call>,
    /// What came of an argument so far.
    pub(super) output: Vec<Token>,
}

/// Whether nothing about a token needs a look, which goes for most.
#[inline]
fn is_fine_in_itself(kind: Kind, name: Name) -> bool {
    match kind {
        Kind::Identifier | Kind::LineEnd => true,
        // It may stand for a character that GLSL does not know.
        Kind::Punctuator => name != Symbol::Question.into(),
        Kind::Number | Kind::Odd => false,
    }
}

#[inline]
fn make_room(tokens: &mut Vec<Token>) {
    if tokens.len() == tokens.capacity() {
        // To double them would be more than half a large text needs.
        tokens.reserve_exact(tokens.len() / 2 + 64);
    }
}

#[derive(Debug)]
pub(super) enum Input {
    /// The text itself, directives obeyed.
    Text,
    /// As many tokens.
    List(usize, std::vec::IntoIter<Token>),
}

/// A macro's text, read up to a point.
#[derive(Debug)]
struct Context {
    of: MacroId,
    tokens: Tokens,
    at: usize,
}

#[derive(Debug)]
pub(super) enum Tokens {
    /// The macro's own, for a use there, perhaps with white space before it.
    Body(Rc<Vec<Token>>, Span, bool),
    /// With its arguments put in.
    Filled(Vec<Token>),
}

impl Tokens {
    fn len(&self) -> usize {
        match self {
            Tokens::Body(tokens, ..) => tokens.len(),
            Tokens::Filled(tokens) => tokens.len(),
        }
    }
}

impl Level {
    pub(super) fn new(input: Input) -> Self {
        Level {
            input,
            contexts: Vec::new(),
            in_contexts: 0,
            put_back: None,
            is_calling: false,
            ending: Vec::new(),
            call: None,
            output: Vec::new(),
        }
    }
}

impl<'a> Expansion {
    /// Expands the text.
    pub fn of_text() -> Self {
        Expansion::new(Input::Text)
    }

    /// Expands some tokens by themselves.
    pub fn of_list(tokens: Vec<Token>, source: &mut Directives<'a>) -> Vec<Token> {
        let mut expansion = Expansion::new(Input::List(tokens.len(), tokens.into_iter()));
        std::iter::from_fn(|| expansion.next(source)).collect()
    }

    fn new(input: Input) -> Self {
        Expansion {
            levels: vec![Level::new(input)],
            outermost: None,
        }
    }

    pub(super) fn level(&mut self) -> &mut Level {
        self.levels.last_mut().expect("the first is never taken")
    }

    /// Whether the next token comes from the text itself.
    pub(super) fn is_reading_text(&self) -> bool {
        let [level] = &*self.levels else { return false };
        matches!(level.input, Input::Text) && level.contexts.is_empty() && level.put_back.is_none()
    }

    /// Adds the next tokens that are no uses of macros to `tokens`, up to one that may be wrong in
    /// itself, and says of what kind that is.
    pub fn next_into(
        &mut self,
        tokens: &mut Vec<Token>,
        source: &mut Directives<'a>,
    ) -> Option<Kind> {
        loop {
            // Most of a text is plain, and there is no need to ask again at each token.
            if self.is_reading_text() {
                loop {
                    let lexeme @ (kind, name, _) = source.scan()?;
                    if kind == Kind::Identifier && source.macros.find(name).is_some() {
                        self.level().put_back = source.token(lexeme);
                        break;
                    }
                    make_room(tokens);
                    tokens.push(source.token(lexeme)?);
                    if !is_fine_in_itself(kind, name) {
                        return Some(kind);
                    }
                }
            }
            let token = self.next(source)?;
            make_room(tokens);
            tokens.push(token);
            if !is_fine_in_itself(token.kind, token.spelling) {
                return Some(token.kind);
            }
        }
    }

    /// The next token that is no use of a macro.
    fn next(&mut self, source: &mut Directives<'a>) -> Option<Token> {
        loop {
            let token = self.pull(source);
            if source.is_stopped {
                return None;
            }
            let Some(token) = token else {
                if self.levels.len() == 1 {
                    return None;
                }
                self.finish_argument(source);
                continue;
            };
            let Some(token) = self.expand(token, source) else {
                continue;
            };
            if self.levels.len() > 1 {
                self.level().output.push(token);
                source.costs.held += 1;
                continue;
            }
            let is_brought = !self.levels[0].contexts.is_empty();
            source.costs.brought += usize::from(is_brought);
            return Some(token);
        }
    }

    /// The next token of the level, macros not expanded.
    pub(super) fn pull(&mut self, source: &mut Directives<'a>) -> Option<Token> {
        let level = self.levels.last_mut().expect("the first is never taken");
        if let Some(token) = level.put_back.take() {
            return Some(token);
        }
        while let Some(context) = level.contexts.last_mut() {
            let at = context.at;
            context.at += 1;
            let token = match &context.tokens {
                Tokens::Body(tokens, place, space) => tokens.get(at).map(|token| {
                    let mut token = token.brought_to(*place);
                    if at == 0 {
                        token.set_space(*space);
                    }
                    token
                }),
                Tokens::Filled(tokens) => tokens.get(at).copied(),
            };
            if token.is_some() {
                self.spend(source);
                return token;
            }
            let length = context.tokens.len();
            if let Tokens::Filled(_) = context.tokens {
                source.costs.held -= length;
            }
            level.in_contexts -= length;
            let of = context.of;
            level.contexts.pop();
            let ended = source.macros.get_mut(of);
            ended.uses -= 1;
            if level.is_calling {
                level.ending.push(of);
            } else {
                ended.is_active = false;
            }
        }
        match &mut level.input {
            Input::Text => source.next(),
            Input::List(_, list) => {
                let token = list.next();
                self.spend(source);
                token
            }
        }
    }

    /// Puts the token back that was pulled last.
    fn put_back(&mut self, token: Token) {
        let level = self.level();
        match level.contexts.last_mut() {
            Some(context) => context.at -= 1,
            None => level.put_back = Some(token),
        }
    }

    /// Counts a step of work.
    fn spend(&mut self, source: &mut Directives<'a>) {
        source.costs.read += 1;
        self.require_room(0, source);
    }

    /// Gives up if there is no room for more tokens, or if it has taken too long.
    pub(super) fn require_room(&mut self, more: usize, source: &mut Directives<'a>) {
        let costs = &source.costs;
        let is_fine = costs.read <= MAX_READ && costs.brought + costs.held + more <= MAX_BROUGHT;
        if is_fine || std::mem::replace(&mut source.is_stopped, true) {
            return;
        }
        let hint = "write macros that use fewer others, or functions in their stead";
        let problem = |message: String| Diagnostic::error("too-complex", message).hint(hint);
        match self.outermost.take() {
            Some((of, name)) => {
                let message = format!("the macro `{}` expands without end", source.quoted(&name));
                source.report_use(&name, of, problem(message));
            }
            None => source.report(problem("a directive has too many tokens".to_owned())),
        }
    }

    /// The token, unless it is a use of a macro: then the macro's text is read next.
    fn expand(&mut self, mut token: Token, source: &mut Directives<'a>) -> Option<Token> {
        if token.kind != Kind::Identifier || token.is_painted() {
            return Some(token);
        }
        let Some(of) = source.macros.find_mentioned(token.spelling) else {
            return Some(token);
        };
        let found = source.macros.get_mut(of);
        if found.is_active {
            token.paint();
            return Some(token);
        }
        found.uses += 1;
        if found.parameters.is_none() {
            let maker = found.maker;
            let tokens = match maker {
                Maker::Line | Maker::File => {
                    let mut value = source.position(maker, token.span);
                    value.set_space(token.has_space());
                    Tokens::Filled(vec![value])
                }
                _ => Tokens::Body(Rc::clone(&found.body), token.span, token.has_space()),
            };
            self.note_outermost(of, &token);
            self.enter(of, tokens, source);
            return None;
        }
        // The macro counts as used from here on: it cannot be undefined before its `(`.
        match self.pull(source) {
            Some(next) if next.is(Symbol::LeftParenthesis) => {}
            next => {
                source.macros.get_mut(of).uses -= 1;
                if let Some(next) = next {
                    self.put_back(next);
                }
                return Some(token);
            }
        }
        self.note_outermost(of, &token);
        self.call(of, token, source);
        None
    }

    fn note_outermost(&mut self, of: MacroId, token: &Token) {
        if self.levels.len() == 1 && self.levels[0].contexts.is_empty() {
            self.outermost = Some((of, *token));
        }
    }

    /// Reads a macro's text next.
    pub(super) fn enter(&mut self, of: MacroId, tokens: Tokens, source: &mut Directives<'a>) {
        source.macros.get_mut(of).is_active = true;
        let length = tokens.len();
        if let Tokens::Filled(_) = tokens {
            source.costs.held += length;
        }
        let level = self.level();
        level.in_contexts += length;
        let at = 0;
        level.contexts.push(Context { of, tokens, at });
    }
}
