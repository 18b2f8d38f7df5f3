use std::borrow::Cow;
use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::token::Token;
use crate::source::Span;

/// A macro's definition.
#[derive(Debug)]
pub(super) struct Macro<'a> {
    /// The parameters of a function-like macro.
    pub parameters: Option<Vec<Cow<'a, str>>>,
    /// The tokens that take the place of a use. Those that name parameters know it.
    pub body: Rc<Vec<Token<'a>>>,
    pub maker: Maker,
    /// Whether it is being expanded, and so is not expanded again.
    pub is_active: bool,
    /// Expansions under way, those included whose `(` is still looked for.
    pub uses: u32,
}

/// Who defined a macro.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Maker {
    /// The language.
    Language,
    /// `__LINE__` and `__FILE__`: their value is not in the body.
    Line,
    File,
    /// The host, as if in a text before the author's.
    Host,
    /// The author, there.
    Text(Span),
    /// The user, in place of all that the text says.
    User {
        is_mentioned: bool,
        /// Whether a definition was met in the text that can be named as the place.
        has_place: bool,
    },
}

impl<'a> Macro<'a> {
    pub fn new(
        parameters: Option<Vec<Cow<'a, str>>>,
        mut body: Vec<Token<'a>>,
        maker: Maker,
    ) -> Self {
        let names: &[Cow<'_, str>] = parameters.as_deref().unwrap_or_default();
        let names: FxHashMap<&str, u32> = names.iter().map(|name| &**name).zip(0..).collect();
        for token in &mut body {
            if !names.is_empty()
                && let Some(&index) = names.get(&*token.text)
            {
                token.set_parameter(index);
            }
        }
        Macro {
            parameters,
            body: Rc::new(body),
            maker,
            is_active: false,
            uses: 0,
        }
    }

    /// Whether the language keeps it as it is.
    pub fn is_predefined(&self) -> bool {
        matches!(self.maker, Maker::Language | Maker::Line | Maker::File)
    }

    pub fn is_users(&self) -> bool {
        matches!(self.maker, Maker::User { .. })
    }

    /// Where the text defines it.
    pub fn place(&self) -> Option<Span> {
        match self.maker {
            Maker::Text(place) => Some(place),
            _ => None,
        }
    }

    /// Whether two definitions differ in nothing but the amount of white space.
    pub fn agrees_with(&self, other: &Macro<'_>) -> bool {
        let same = |index: usize, a: &Token<'_>, b: &Token<'_>| {
            a.text == b.text && (index == 0 || a.has_space() == b.has_space())
        };
        let bodies = self.body.iter().zip(&*other.body);
        self.parameters == other.parameters
            && self.body.len() == other.body.len()
            && bodies.enumerate().all(|(index, (a, b))| same(index, a, b))
    }
}

/// Names a macro that is or was defined.
pub(super) type MacroId = usize;

/// The macros that are defined.
#[derive(Debug, Default)]
pub(super) struct Macros<'a> {
    names: FxHashMap<Cow<'a, str>, MacroId>,
    /// All there ever were: one may be undefined while its text is still being read.
    list: Vec<Macro<'a>>,
    /// A bit for each mark of a name that was ever defined. Nearly every name of a text is no
    /// macro's, and this tells most of them apart without hashing them.
    marks: [u64; 16],
}

/// A number below 1024 that depends on the name.
fn mark(name: &str) -> usize {
    let bytes = name.as_bytes();
    let at = |index: usize| usize::from(bytes.get(index).copied().unwrap_or(0));
    let last = at(bytes.len().wrapping_sub(1));
    (at(0) ^ (at(1) << 3) ^ (last << 5) ^ (bytes.len() << 7)) & 1023
}

impl<'a> Macros<'a> {
    /// Puts a macro in force.
    pub fn define(&mut self, name: impl Into<Cow<'a, str>>, definition: Macro<'a>) {
        let name = name.into();
        let mark = mark(&name);
        self.marks[mark / 64] |= 1 << (mark % 64);
        self.names.insert(name, self.list.len());
        self.list.push(definition);
    }

    pub fn undefine(&mut self, name: &str) {
        self.names.remove(name);
    }

    /// The macro of a name.
    pub fn find(&self, name: &str) -> Option<MacroId> {
        let mark = mark(name);
        match self.marks[mark / 64] >> (mark % 64) & 1 {
            0 => None,
            _ => self.names.get(name).copied(),
        }
    }

    /// The same for a name that the text mentions.
    pub fn find_mentioned(&mut self, name: &str) -> Option<MacroId> {
        let id = self.find(name)?;
        if let Maker::User { is_mentioned, .. } = &mut self.list[id].maker {
            *is_mentioned = true;
        }
        Some(id)
    }

    pub fn get(&self, id: MacroId) -> &Macro<'a> {
        &self.list[id]
    }

    pub fn get_mut(&mut self, id: MacroId) -> &mut Macro<'a> {
        &mut self.list[id]
    }
}
