//! Declarations, §4 and §6.1.

use smallvec::SmallVec;

use super::ast::{
    Declaration, Declarator, Header, Item, Parameter, QualifiedType, Qualifier, QualifierKind,
    Sizes, TokenIndex, TypeKind,
};
use super::lexeme::Lexeme;
use super::parser::{Failed, Parse, Parser};
use crate::glsl::arena::Range;
use crate::glsl::names::Name;
use crate::glsl::types::Base;
use crate::glsl::words::{Symbol, Word};

/// A declaration, or what precedes the body of a function.
#[derive(Debug)]
pub(super) enum Declared {
    Declaration(Declaration),
    /// The `{` of the body is at hand.
    Function(Header),
}

/// Declarators that belong together; mostly there is one.
pub(super) type Declarators = SmallVec<[Declarator; 4]>;

pub(super) const LIST_OR_END: &str = "`,` or `;`";

impl Parser<'_> {
    /// Something at global scope.
    pub fn external_declaration(&mut self) -> Parse<Item> {
        if self.is_astray() {
            return Err(self.astray());
        }
        Ok(match self.declared()? {
            Declared::Declaration(declaration) => Item::Declaration(declaration),
            Declared::Function(header) => Item::Function(header, self.block()?),
        })
    }

    /// Whether the token at hand is nothing that a declaration begins with.
    fn is_astray(&self) -> bool {
        match self.peek() {
            Lexeme::Type(_) => false,
            Lexeme::Word(word) => !word.begins_declaration(),
            Lexeme::Name(_) => !matches!(
                self.peek_at(1),
                Lexeme::Name(_)
                    | Lexeme::Type(_)
                    | Lexeme::Word(_)
                    | Lexeme::Symbol(Symbol::Comma | Symbol::Semicolon | Symbol::LeftBracket)
            ),
            _ => true,
        }
    }

    /// Reports what cannot stand between functions, and only once: if one statement lies outside of
    /// all functions then so do those that follow it.
    fn astray(&mut self) -> Failed {
        if self.braces_are_off {
            return Failed;
        }
        let is_call = self.peek_at(1) == Lexeme::Symbol(Symbol::LeftParenthesis);
        if is_call && matches!(self.peek(), Lexeme::Name(_)) && self.is_function() {
            let hint = "a function's type stands before its name, `void` if it returns nothing";
            return self.unexpected_but("a type", Some(hint));
        }
        let is_statement = match (self.peek(), self.peek_at(1)) {
            (Lexeme::Word(_), _) => true,
            (Lexeme::Name(_), Lexeme::Symbol(next)) => next.follows_place(),
            _ => false,
        };
        let hint = match self.peek() {
            _ if is_statement => {
                self.braces_are_off = true;
                Some("statements stand in functions: is there a `}` too many above?")
            }
            Lexeme::Name(_) => Some("is it a type that is spelled differently?"),
            _ => None,
        };
        self.unexpected_but("a declaration", hint)
    }

    /// Whether a `{` stands behind the parentheses behind the name at hand.
    fn is_function(&self) -> bool {
        let mut depth = 0_usize;
        for ahead in 1.. {
            match self.peek_at(ahead) {
                Lexeme::Symbol(Symbol::LeftParenthesis) => depth += 1,
                Lexeme::Symbol(Symbol::RightParenthesis) => depth = depth.saturating_sub(1),
                Lexeme::Symbol(Symbol::LeftBrace) => return depth == 0,
                Lexeme::Symbol(Symbol::Semicolon) | Lexeme::End => return false,
                _ => {}
            }
        }
        false
    }

    /// Any declaration, with its `;`.
    pub fn declared(&mut self) -> Parse<Declared> {
        if self.peek() == Lexeme::Word(Word::Precision) {
            return self.default_precision().map(Declared::Declaration);
        }
        let qualifiers = self.qualifiers()?;
        if !qualifiers.is_empty() {
            match (self.peek(), self.peek_at(1)) {
                (Lexeme::Symbol(Symbol::Semicolon), _) => {
                    self.advance();
                    let names = Vec::new();
                    return Ok(Declared::Declaration(Declaration::Qualifiers {
                        qualifiers,
                        names,
                    }));
                }
                (Lexeme::Name(name), Lexeme::Symbol(Symbol::Semicolon)) => {
                    let names = vec![(name, self.advance())];
                    self.advance();
                    return Ok(Declared::Declaration(Declaration::Qualifiers {
                        qualifiers,
                        names,
                    }));
                }
                (Lexeme::Name(_), Lexeme::Symbol(Symbol::LeftBrace)) => {
                    return self.interface_block(qualifiers).map(Declared::Declaration);
                }
                _ => {}
            }
        }
        let ty = self.type_specifier()?;
        let ty = QualifiedType { qualifiers, ty };
        let is_function = matches!(self.peek(), Lexeme::Name(_))
            && self.peek_at(1) == Lexeme::Symbol(Symbol::LeftParenthesis);
        match is_function {
            true => self.function(ty),
            false => self.variables(ty).map(Declared::Declaration),
        }
    }

    fn default_precision(&mut self) -> Parse<Declaration> {
        let at = self.advance();
        let Some(QualifierKind::Precision(precision)) = self.plain_qualifier() else {
            return Err(self.unexpected("`lowp`, `mediump` or `highp`"));
        };
        self.advance();
        let ty = self.type_specifier()?;
        self.semicolon("`;`")?;
        Ok(Declaration::Precision { precision, ty, at })
    }

    fn variables(&mut self, ty: QualifiedType) -> Parse<Declaration> {
        let mut declarators = Declarators::new();
        match self.peek() {
            Lexeme::Name(_) => declarators.push(self.declarator()?),
            Lexeme::Symbol(Symbol::Comma | Symbol::Semicolon) => {}
            _ if matches!(ty.ty.kind, TypeKind::Struct(_)) => {}
            _ if self.is_keyword_as_name() => declarators.push(self.declarator()?),
            _ if matches!(ty.ty.kind, TypeKind::Basic(_)) && self.plain_qualifier().is_some() => {
                self.unexpected_but("a name", Some("qualifiers stand before the type"));
                self.qualifiers()?;
                declarators.push(self.declarator()?);
            }
            _ => return Err(self.no_name(&ty)),
        }
        while self.accept(Symbol::Comma) {
            if matches!(self.peek(), Lexeme::Type(_)) && !self.is_keyword_as_name() {
                let hint = "give the type once, or write `;` instead of the `,`";
                return Err(self.unexpected_but("a name", Some(hint)));
            }
            declarators.push(self.declarator()?);
        }
        self.semicolon(LIST_OR_END)?;
        let declarators = self.ast.declarators.add(&declarators);
        Ok(Declaration::Variables { ty, declarators })
    }

    /// Reports what stands where a declared name should.
    pub fn no_name(&mut self, ty: &QualifiedType) -> Failed {
        let named = matches!(ty.ty.kind, TypeKind::Named(_)) && ty.ty.sizes.is_empty();
        let hint = match self.peek() {
            Lexeme::Type(_) | Lexeme::Word(_) if named => {
                let at = ty.ty.extent.first as usize;
                let unknown = self.spelling(at);
                let message = format!("{unknown} is neither a type nor a qualifier");
                // The error is noticed at the next token, but it is about this one.
                return self.wrong_about(at, message, "leave it out");
            }
            Lexeme::Symbol(Symbol::Assign) if named => Some("is its type missing before it?"),
            Lexeme::Symbol(Symbol::Star | Symbol::And) => Some("GLSL has no pointers"),
            _ => None,
        };
        self.unexpected_but("a name", hint)
    }

    /// A name, with sizes and an initialiser if it has them.
    fn declarator(&mut self) -> Parse<Declarator> {
        let mut declarator = self.plain_declarator()?;
        if self.accept(Symbol::Assign) {
            declarator.init = Some(self.assignment()?);
        }
        Ok(declarator)
    }

    /// A name, with sizes if it has them.
    pub fn plain_declarator(&mut self) -> Parse<Declarator> {
        let (name, at) = self.declared_name()?;
        Ok(Declarator {
            name,
            at,
            sizes: self.array_sizes()?,
            init: None,
        })
    }

    /// The name of something new. A keyword is refused, but taken for one.
    fn declared_name(&mut self) -> Parse<(Name, TokenIndex)> {
        match self.is_keyword_as_name() {
            true => Ok(self.keyword_as_name()),
            false => self.name("a name"),
        }
    }

    /// Whether a keyword is at hand, and what follows it would follow a declared name.
    pub fn is_keyword_as_name(&self) -> bool {
        use Symbol::{Assign, Comma, LeftBracket, RightParenthesis, Semicolon};
        matches!(
            (self.peek(), self.peek_at(1)),
            (
                Lexeme::Word(_) | Lexeme::Type(_) | Lexeme::Bool(_),
                Lexeme::Symbol(Assign | Comma | LeftBracket | RightParenthesis | Semicolon)
            )
        )
    }

    fn function(&mut self, result: QualifiedType) -> Parse<Declared> {
        let (name, at) = self.name("a name")?;
        let open = self.advance();
        let parameters = self.in_header(open, true, "`,` or `)`", Self::parameters);
        let parameters = parameters.unwrap_or_default();
        let header = Header {
            result,
            name,
            at,
            parameters,
            end: self.here(),
        };
        match self.peek() {
            Lexeme::Symbol(Symbol::LeftBrace) => return Ok(Declared::Function(header)),
            Lexeme::Word(word) if word.begins_statement() => return Err(self.unexpected("`{`")),
            _ => self.semicolon("`{` or `;`")?,
        }
        Ok(Declared::Declaration(Declaration::Prototype(header)))
    }

    /// What stands between a function's parentheses.
    fn parameters(&mut self) -> Parse<Vec<Parameter>> {
        let mut parameters = Vec::new();
        if self.is(Symbol::RightParenthesis) {
            return Ok(parameters);
        }
        loop {
            parameters.push(self.parameter()?);
            if !self.accept(Symbol::Comma) {
                break;
            }
        }
        if self.is(Symbol::Assign) {
            let hint = "parameters have no default values";
            return Err(self.unexpected_but("`,` or `)`", Some(hint)));
        }
        match &*parameters {
            [lone]
                if lone.name.is_none()
                    && lone.ty.ty.basic().is_some_and(|ty| ty.base == Base::Void) =>
            {
                Ok(Vec::new())
            }
            _ => Ok(parameters),
        }
    }

    fn parameter(&mut self) -> Parse<Parameter> {
        let is_value = matches!(
            self.peek(),
            Lexeme::Int(_) | Lexeme::Float(_) | Lexeme::Bool(_)
        );
        if self.blocks > 0 && is_value {
            let hint = "a variable gets its value with a `=`";
            return Err(self.unexpected_but("a type", Some(hint)));
        }
        let ty = self.qualified_type()?;
        let mut parameter = Parameter {
            at: ty.ty.extent.first,
            ty,
            name: None,
            sizes: Sizes::default(),
        };
        if matches!(self.peek(), Lexeme::Name(_)) || self.is_keyword_as_name() {
            let (name, at) = self.declared_name()?;
            parameter.name = Some(name);
            parameter.at = at;
            parameter.sizes = self.array_sizes()?;
        }
        Ok(parameter)
    }

    fn interface_block(&mut self, qualifiers: Range<Qualifier>) -> Parse<Declaration> {
        let (name, at) = self.name("a name")?;
        let members = self.members()?;
        let instance = match self.peek() {
            Lexeme::Name(_) => Some(self.plain_declarator()?),
            _ => None,
        };
        self.semicolon("a name or `;`")?;
        Ok(Declaration::Block {
            qualifiers,
            name,
            at,
            members,
            instance,
        })
    }

    /// Whether the names at hand begin a declaration rather than an expression: two names in a row,
    /// perhaps with `[…]` between, or a type without the `(` of a constructor. Looks at no token
    /// twice, because nothing between brackets asks again.
    pub fn starts_declaration(&self) -> bool {
        let named: Option<Name> = match self.peek() {
            Lexeme::Word(word) => return word.begins_declaration(),
            Lexeme::Type(_) => None,
            Lexeme::Name(name) => Some(name),
            _ => return false,
        };
        let mut ahead = 1;
        while self.peek_at(ahead) == Lexeme::Symbol(Symbol::LeftBracket) {
            let Some(length) = self.bracketed(ahead) else {
                return false;
            };
            ahead += length;
        }
        match (named, self.peek_at(ahead)) {
            (None, behind) => behind != Lexeme::Symbol(Symbol::LeftParenthesis),
            (Some(_), behind) => match behind {
                Lexeme::Name(_) => true,
                // An unknown qualifier, most likely.
                Lexeme::Type(_) => ahead == 1,
                Lexeme::Word(word) => ahead == 1 && word.begins_declaration(),
                _ => false,
            },
        }
    }

    /// The number of tokens from a `[` to its `]`, both counted.
    fn bracketed(&self, ahead: usize) -> Option<usize> {
        let mut depth = 0_usize;
        for length in 0.. {
            match self.peek_at(ahead + length) {
                Lexeme::Symbol(Symbol::LeftBracket | Symbol::LeftParenthesis) => depth += 1,
                Lexeme::Symbol(Symbol::RightBracket | Symbol::RightParenthesis) => depth -= 1,
                Lexeme::Symbol(Symbol::Semicolon | Symbol::LeftBrace | Symbol::RightBrace)
                | Lexeme::End => return None,
                _ => {}
            }
            if depth == 0 {
                return Some(length + 1);
            }
        }
        None
    }
}
