use std::collections::HashMap;
use std::rc::Rc;

use super::directive::Directives;
use super::lexer::{Kind, Token};
use crate::source::Diagnostic;

/// Arguments within arguments; each is a level of recursion here.
const MAX_DEPTH: usize = 2_000;

/// A macro's definition.
#[derive(Debug)]
pub(super) struct Macro<'a> {
    /// The parameters of a function-like macro.
    pub parameters: Option<Vec<String>>,
    pub body: Vec<Token<'a>>,
    /// Whether the language or the host defined it.
    pub predefined: bool,
}

impl Macro<'_> {
    /// Whether two definitions differ in nothing but the amount of white space.
    pub fn agrees_with(&self, other: &Macro<'_>) -> bool {
        let same = |i: usize, a: &Token<'_>, b: &Token<'_>| {
            a.text == b.text && (i == 0 || a.space == b.space)
        };
        let bodies = self.body.iter().zip(&other.body);
        self.parameters == other.parameters
            && self.body.len() == other.body.len()
            && bodies.enumerate().all(|(i, (a, b))| same(i, a, b))
    }
}

pub(super) type Macros<'a> = HashMap<String, Rc<Macro<'a>>>;

/// An expansion under way: what it reads, and what of that waits to be read again.
#[derive(Debug)]
pub(super) struct Expansion<'a> {
    input: Input<'a>,
    contexts: Vec<Context<'a>>,
    /// Macros that are being expanded, and so are not expanded again.
    active: Vec<String>,
    /// Macros whose text ended within the arguments of another: they stay active until those are
    /// complete.
    ending: Option<Vec<String>>,
    depth: usize,
}

#[derive(Debug)]
enum Input<'a> {
    /// The text itself, directives obeyed.
    Text,
    /// Some tokens, the last first.
    List(Vec<Token<'a>>),
}

/// Tokens to be read before the input goes on, the last first.
#[derive(Debug)]
struct Context<'a> {
    /// The macro that they come from; `None` for a token that was put back.
    name: Option<String>,
    rest: Vec<Token<'a>>,
}

impl<'a> Expansion<'a> {
    /// Expands the text.
    pub fn of_text() -> Self {
        Expansion::new(Input::Text, Vec::new(), 0)
    }

    fn new(input: Input<'a>, active: Vec<String>, depth: usize) -> Self {
        Expansion {
            input,
            contexts: Vec::new(),
            active,
            ending: None,
            depth,
        }
    }

    /// Expands some tokens by themselves.
    pub fn of_list(mut tokens: Vec<Token<'a>>, source: &mut Directives<'a>) -> Vec<Token<'a>> {
        tokens.reverse();
        Expansion::new(Input::List(tokens), Vec::new(), 0).all(source)
    }

    fn all(mut self, source: &mut Directives<'a>) -> Vec<Token<'a>> {
        std::iter::from_fn(|| self.next(source)).collect()
    }

    /// The next token that is no use of a macro.
    pub fn next(&mut self, source: &mut Directives<'a>) -> Option<Token<'a>> {
        loop {
            let mut token = self.pull(source)?;
            if token.kind != Kind::Identifier || token.painted {
                return Some(token);
            }
            let Some(found) = source.find(&token) else {
                return Some(token);
            };
            if self.active.iter().any(|name| *name == token.text) {
                token.painted = true;
                return Some(token);
            }
            let mut body = match &found.parameters {
                None => found.body.clone(),
                Some(_) if !self.is_called(source) => return Some(token),
                Some(parameters) => match self.arguments(source, &token, parameters.len()) {
                    Some(arguments) => substitute(&found.body, parameters, &arguments),
                    None => continue,
                },
            };
            source.spend(body.len());
            if let Some(first) = body.first_mut() {
                first.space = token.space;
            }
            body.reverse();
            let name = token.text.into_owned();
            self.active.push(name.clone());
            self.contexts.push(Context {
                name: Some(name),
                rest: body,
            });
        }
    }

    /// The next token, macros not expanded.
    fn pull(&mut self, source: &mut Directives<'a>) -> Option<Token<'a>> {
        while let Some(context) = self.contexts.last_mut() {
            if let Some(token) = context.rest.pop() {
                return source.spend(1).then_some(token);
            }
            let used_up = self.contexts.pop().and_then(|context| context.name);
            match (&mut self.ending, used_up) {
                (Some(ending), Some(name)) => ending.push(name),
                (None, Some(name)) => self.release(&name),
                (_, None) => {}
            }
        }
        match &mut self.input {
            Input::Text => source.next(),
            Input::List(list) => list.pop().filter(|_| source.spend(1)),
        }
    }

    fn release(&mut self, name: &str) {
        if let Some(at) = self.active.iter().rposition(|active| active == name) {
            self.active.remove(at);
        }
    }

    /// Whether a `(` follows, which is then taken.
    fn is_called(&mut self, source: &mut Directives<'a>) -> bool {
        match self.pull(source) {
            Some(token) if token.is("(") => true,
            Some(token) => {
                self.contexts.push(Context {
                    name: None,
                    rest: vec![token],
                });
                false
            }
            None => false,
        }
    }

    /// Reads the arguments of a call up to its `)` and expands each.
    fn arguments(
        &mut self,
        source: &mut Directives<'a>,
        name: &Token<'a>,
        expected: usize,
    ) -> Option<Vec<Vec<Token<'a>>>> {
        self.ending = Some(Vec::new());
        let collected = self.collect(source);
        for ended in self.ending.take().unwrap_or_default() {
            self.release(&ended);
        }
        let Some(mut arguments) = collected else {
            source.report(
                Diagnostic::error("macro-call", format!("`{}(` is never closed", name.text))
                    .at(name.span)
                    .hint("add the `)` that ends the macro's arguments"),
            );
            return None;
        };
        if expected == 0 && arguments.len() == 1 && arguments[0].is_empty() {
            arguments.clear();
        }
        if arguments.len() != expected {
            let given = arguments.len();
            source.report(
                Diagnostic::error(
                    "macro-call",
                    format!(
                        "the macro `{}` takes {expected} arguments, not {given}",
                        name.text
                    ),
                )
                .at(name.span),
            );
            return None;
        }
        if self.depth >= MAX_DEPTH {
            source.give_up("macros are called within macro calls too deeply", name.span);
            return None;
        }
        let expanded = arguments.into_iter().map(|mut argument| {
            argument.reverse();
            let input = Input::List(argument);
            Expansion::new(input, self.active.clone(), self.depth + 1).all(source)
        });
        Some(expanded.collect())
    }

    /// The arguments as they stand; `None` if the text ends before they do.
    fn collect(&mut self, source: &mut Directives<'a>) -> Option<Vec<Vec<Token<'a>>>> {
        let mut arguments = vec![Vec::new()];
        let mut depth = 1;
        loop {
            let token = self.pull(source)?;
            match &*token.text {
                "(" => depth += 1,
                ")" if depth == 1 => return Some(arguments),
                ")" => depth -= 1,
                "," if depth == 1 => {
                    arguments.push(Vec::new());
                    continue;
                }
                _ => {}
            }
            arguments.last_mut().expect("there is one").push(token);
        }
    }
}

fn substitute<'a>(
    body: &[Token<'a>],
    parameters: &[String],
    arguments: &[Vec<Token<'a>>],
) -> Vec<Token<'a>> {
    let mut result = Vec::with_capacity(body.len());
    for token in body {
        let parameter = match token.kind {
            Kind::Identifier => parameters.iter().position(|name| *name == token.text),
            _ => None,
        };
        let Some(parameter) = parameter else {
            result.push(token.clone());
            continue;
        };
        let first = result.len();
        result.extend_from_slice(&arguments[parameter]);
        if let Some(first) = result.get_mut(first) {
            first.space = token.space;
        }
    }
    result
}
