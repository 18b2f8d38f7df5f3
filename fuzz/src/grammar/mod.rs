//! Texts in the shape of GLSL: declared names, fitting types, and now and then a mistake.

mod builtins;
mod expression;
mod program;
mod statement;
mod types;

use arbitrary::{Arbitrary, Result, Unstructured};

use types::{Structure, Type};

/// The text of an image pass.
#[derive(Debug)]
pub struct Text(pub String);

impl<'a> Arbitrary<'a> for Text {
    fn arbitrary(u: &mut Unstructured<'a>) -> Result<Self> {
        let mut writer = Writer::new(u);
        writer.program()?;
        Ok(Text(writer.text))
    }
}

/// A function that can be called.
#[derive(Clone, Debug)]
struct Function {
    name: String,
    result: Option<Type>,
    /// Types, and whether a variable is needed.
    parameters: Vec<(Type, bool)>,
}

/// A variable in scope.
#[derive(Clone, Debug)]
struct Variable {
    name: String,
    ty: Type,
    written: bool,
    constant: bool,
}

/// A text as far as it is written.
struct Writer<'u, 'a> {
    u: &'u mut Unstructured<'a>,
    text: String,
    structures: Vec<Structure>,
    functions: Vec<Function>,
    variables: Vec<Variable>,
    /// Macros without and with a parameter; both are `float`.
    macros: Vec<(String, bool)>,
    names: usize,
    loops: u32,
    switches: u32,
    /// Whether only constants may be named.
    constant: bool,
    result: Option<Type>,
}

impl<'u, 'a> Writer<'u, 'a> {
    fn new(u: &'u mut Unstructured<'a>) -> Self {
        Writer {
            u,
            text: String::new(),
            structures: Vec::new(),
            functions: Vec::new(),
            variables: Vec::new(),
            macros: Vec::new(),
            names: 0,
            loops: 0,
            switches: 0,
            constant: false,
            result: None,
        }
    }

    /// A number below a limit; zero when there is nothing left to choose by.
    fn below(&mut self, limit: usize) -> Result<usize> {
        if self.u.is_empty() {
            return Ok(0);
        }
        self.u.int_in_range(0..=limit.max(1) - 1)
    }

    /// Whether something happens that happens once in so many times.
    fn once_in(&mut self, count: usize) -> Result<bool> {
        Ok(self.below(count)? == count - 1)
    }

    fn pick<T: Clone>(&mut self, from: &[T]) -> Result<T> {
        let index = self.below(from.len())?;
        Ok(from[index].clone())
    }

    fn put(&mut self, text: &str) {
        self.text.push_str(text);
    }

    /// A new name, or sometimes one that exists.
    fn name(&mut self, prefix: &str) -> Result<String> {
        if self.names > 0 && self.once_in(24)? {
            let old = self.below(self.names)?;
            return Ok(format!("{prefix}{old}"));
        }
        self.names += 1;
        Ok(format!("{prefix}{}", self.names - 1))
    }
}
