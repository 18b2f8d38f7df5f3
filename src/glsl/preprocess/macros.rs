use std::rc::Rc;

use rustc_hash::FxHashMap;

use super::token::Token;
use crate::glsl::names::Name;
use crate::source::Span;

/// A macro's definition.
#[derive(Debug)]
pub(super) struct Macro {
    /// The parameters of a function-like macro.
    pub parameters: Option<Vec<Name>>,
    /// The tokens that take the place of a use. Those that name parameters know it.
    pub body: Rc<Vec<Token>>,
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

impl Macro {
    pub fn new(parameters: Option<Vec<Name>>, mut body: Vec<Token>, maker: Maker) -> Self {
        if let Some(names) = parameters.as_ref().filter(|names| !names.is_empty()) {
            let indices: FxHashMap<Name, u32> = names.iter().copied().zip(0..).collect();
            for token in &mut body {
                if let Some(&index) = indices.get(&token.spelling) {
                    token.set_parameter(index);
                }
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
    pub fn agrees_with(&self, other: &Macro) -> bool {
        let same = |index: usize, a: &Token, b: &Token| {
            a.spelling == b.spelling && (index == 0 || a.has_space() == b.has_space())
        };
        let bodies = self.body.iter().zip(&*other.body);
        self.parameters == other.parameters
            && self.body.len() == other.body.len()
            && bodies.enumerate().all(|(index, (a, b))| same(index, a, b))
    }
}

/// Names a macro that is or was defined.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct MacroId(u32);

/// The macros that are defined.
#[derive(Debug, Default)]
pub(super) struct Macros {
    /// What each name stands for; names that come last and stand for nothing are left out.
    by_name: Vec<Option<MacroId>>,
    /// All there ever were: one may be undefined while its text is still being read.
    list: Vec<Macro>,
}

impl Macros {
    /// Puts a macro in force.
    pub fn define(&mut self, name: Name, definition: Macro) {
        if name.index() >= self.by_name.len() {
            self.by_name.resize(name.index() + 1, None);
        }
        self.by_name[name.index()] = Some(MacroId(self.list.len() as u32));
        self.list.push(definition);
    }

    pub fn undefine(&mut self, name: Name) {
        if let Some(known) = self.by_name.get_mut(name.index()) {
            *known = None;
        }
    }

    /// The macro of a name.
    #[inline]
    pub fn find(&self, name: Name) -> Option<MacroId> {
        self.by_name.get(name.index()).copied().flatten()
    }

    /// The same for a name that the text mentions.
    pub fn find_mentioned(&mut self, name: Name) -> Option<MacroId> {
        let id = self.find(name)?;
        if let Maker::User { is_mentioned, .. } = &mut self.get_mut(id).maker {
            *is_mentioned = true;
        }
        Some(id)
    }

    pub fn get(&self, MacroId(index): MacroId) -> &Macro {
        &self.list[index as usize]
    }

    pub fn get_mut(&mut self, MacroId(index): MacroId) -> &mut Macro {
        &mut self.list[index as usize]
    }
}
