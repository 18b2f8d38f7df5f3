//! Uses of function-like macros: their arguments, each expanded by itself, and what comes of them.

use std::rc::Rc;

use super::directive::Directives;
use super::expand::{Expansion, Input, Level, Tokens};
use super::macros::{MacroId, Maker};
use super::token::{Kind, Token};
use super::{MAX_CALL, MAX_DEPTH};
use crate::glsl::words::Symbol;
use crate::source::Diagnostic;

/// A use of a function-like macro whose arguments are being expanded.
#[derive(Debug)]
pub(super) struct Call {
    of: MacroId,
    name: Token,
    raw: std::vec::IntoIter<Vec<Token>>,
    expanded: Vec<Vec<Token>>,
    /// The tokens in `expanded`.
    length: usize,
}

impl<'a> Expansion {
    /// Reads the arguments of a call, its `(` taken.
    pub(super) fn call(&mut self, of: MacroId, name: Token, source: &mut Directives<'a>) {
        self.level().is_calling = true;
        let mut raw = vec![Vec::new()];
        let is_closed = self.collect(&mut raw, source);
        if source.is_stopped {
            return;
        }
        let length: usize = raw.iter().map(Vec::len).sum();
        let parameters = &source.macros.get(of).parameters;
        let expected = parameters.as_ref().map_or(0, Vec::len);
        if expected == 0 && length == 0 && raw.len() == 1 {
            raw.clear();
        }
        if is_closed && raw.len() == expected {
            self.level().call = Some(Call {
                of,
                name,
                expanded: Vec::with_capacity(expected),
                raw: raw.into_iter(),
                length: 0,
            });
            return self.advance(source);
        }
        source.costs.held -= length;
        source.macros.get_mut(of).uses -= 1;
        self.end_call(source);
        let problem = match is_closed {
            false => {
                let message = format!("`{}(` is never closed", source.quoted(&name));
                Diagnostic::error("macro-call", message)
                    .hint("add the `)` that ends the macro's arguments")
            }
            true => {
                let noun = if expected == 1 {
                    "argument"
                } else {
                    "arguments"
                };
                let (name, given) = (source.quoted(&name), raw.len());
                let message = format!("the macro `{name}` takes {expected} {noun}, not {given}");
                Diagnostic::error("macro-call", message)
            }
        };
        source.report_use(&name, of, problem);
    }

    /// Reads the arguments as they stand; `false` if the text ends before they do.
    fn collect(&mut self, arguments: &mut Vec<Vec<Token>>, source: &mut Directives<'a>) -> bool {
        let mut depth = 1;
        while let Some(mut token) = self.pull(source) {
            match token.spelling.symbol() {
                Some(Symbol::LeftParenthesis) => depth += 1,
                Some(Symbol::RightParenthesis) if depth == 1 => return true,
                Some(Symbol::RightParenthesis) => depth -= 1,
                Some(Symbol::Comma) if depth == 1 => {
                    arguments.push(Vec::new());
                    continue;
                }
                Some(_) => {}
                None => {
                    let found = source.macros.find(token.spelling);
                    let maker = found.map(|found| source.macros.get(found).maker);
                    if maker == Some(Maker::Line) && self.is_reading_text() {
                        // Its value is that of its own line, and not of the line where the call ends.
                        token = source.position(Maker::Line, token.span);
                    }
                }
            }
            source.costs.held += 1;
            arguments.last_mut().expect("there is one").push(token);
        }
        false
    }

    /// Expands the next argument of the call, or puts them all into the macro's text.
    fn advance(&mut self, source: &mut Directives<'a>) {
        let depth = self.levels.len();
        let Some(mut call) = self.level().call.take() else {
            return;
        };
        while let Some(argument) = call.raw.next() {
            if depth > MAX_DEPTH {
                let message = format!("macro calls are nested more than {MAX_DEPTH} deep");
                let problem = Diagnostic::error("too-complex", message);
                source.report_use(&call.name, call.of, problem);
                source.costs.held -= argument.len();
                return self.drop_call(call, source);
            }
            let is_use = |token: &Token| {
                token.kind == Kind::Identifier && source.macros.find(token.spelling).is_some()
            };
            if argument.iter().any(is_use) {
                self.level().call = Some(call);
                let input = Input::List(argument.len(), argument.into_iter());
                self.levels.push(Level::new(input));
                return;
            }
            if !self.keep_argument(&mut call, argument, source) {
                return self.drop_call(call, source);
            }
        }
        if let Some(filled) = self.fill(&call, source) {
            source.costs.held -= call.length;
            self.end_call(source);
            self.enter(call.of, Tokens::Filled(filled), source);
        } else {
            self.drop_call(call, source);
        }
    }

    /// Hands the argument that was expanded last to its call.
    pub(super) fn finish_argument(&mut self, source: &mut Directives<'a>) {
        let Some(level) = self.levels.pop() else {
            return;
        };
        if let Input::List(length, _) = level.input {
            source.costs.held -= length;
        }
        let Some(mut call) = self.level().call.take() else {
            return;
        };
        match self.keep_argument(&mut call, level.output, source) {
            true => {
                self.level().call = Some(call);
                self.advance(source);
            }
            false => self.drop_call(call, source),
        }
    }

    /// Whether the expanded argument is not one too many.
    fn keep_argument(
        &mut self,
        call: &mut Call,
        argument: Vec<Token>,
        source: &mut Directives<'a>,
    ) -> bool {
        call.length += argument.len();
        call.expanded.push(argument);
        self.may_bring(call.length, call, source)
    }

    /// Whether a call may have so many tokens in its arguments or as its result.
    fn may_bring(&mut self, length: usize, call: &Call, source: &mut Directives<'a>) -> bool {
        if length + self.level().in_contexts <= MAX_CALL {
            return true;
        }
        let message = format!("WebGL2 refuses a macro call of more than {MAX_CALL} tokens");
        if source.options.strict {
            let problem = Diagnostic::error("too-complex", message);
            source.report_use(&call.name, call.of, problem);
            return false;
        }
        if !std::mem::replace(&mut source.costs.has_warned, true) {
            let problem = Diagnostic::warning("too-complex", message);
            source.report_use(&call.name, call.of, problem);
        }
        true
    }

    /// The macro's text with the arguments in the places of the parameters.
    fn fill(&mut self, call: &Call, source: &mut Directives<'a>) -> Option<Vec<Token>> {
        let body = Rc::clone(&source.macros.get(call.of).body);
        let argument = |part: &Token| Some(&call.expanded[part.parameter()?]);
        let mut length = 0;
        let mut most = 0;
        for part in &*body {
            most = length;
            length += argument(part).map_or(1, Vec::len);
        }
        source.costs.read += length;
        self.require_room(length, source);
        if source.is_stopped {
            return None;
        }
        // The last part is not counted, because ANGLE does not.
        if most > 0 && !self.may_bring(most, call, source) {
            return None;
        }
        let mut filled = Vec::with_capacity(length);
        for part in &*body {
            let first = filled.len();
            match argument(part) {
                None => filled.push(part.brought_to(call.name.span)),
                Some(argument) => filled.extend_from_slice(argument),
            }
            if let Some(first) = filled.get_mut(first) {
                first.set_space(part.has_space());
            }
        }
        if let Some(first) = filled.first_mut() {
            first.set_space(call.name.has_space());
        }
        Some(filled)
    }

    /// Goes on behind a call as if it were not there.
    fn drop_call(&mut self, call: Call, source: &mut Directives<'a>) {
        let raw: usize = call.raw.map(|argument| argument.len()).sum();
        source.costs.held -= call.length + raw;
        source.macros.get_mut(call.of).uses -= 1;
        self.end_call(source);
    }

    fn end_call(&mut self, source: &mut Directives<'a>) {
        let level = self.level();
        level.is_calling = false;
        for ended in std::mem::take(&mut level.ending) {
            source.macros.get_mut(ended).is_active = false;
        }
    }
}
