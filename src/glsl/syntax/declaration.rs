//! Declarations, §4 and §6.1.

use super::ast::{
    ArraySize, Declaration, Declarator, Header, Item, LayoutItem, Members, Parameter, Precision,
    QualifiedType, Qualifier, QualifierKind, StructDefinition, TokenIndex, TypeKind, TypeSpecifier,
};
use super::lexeme::{Lexeme, Symbol};
use super::parser::{Failed, Parse, Parser};
use super::words::Word;
use crate::glsl::types::Base;

/// A declaration, or what precedes the body of a function.
#[derive(Debug)]
pub(super) enum Declared {
    Declaration(Declaration),
    /// The `{` of the body is at hand.
    Function(Header),
}

const LIST_OR_END: &str = "`,` or `;`";

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
        let hint = match self.peek() {
            Lexeme::Name(_) | Lexeme::Word(_) => {
                self.braces_are_off = true;
                Some("statements stand in functions: is there a `}` too many above?")
            }
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
        let mut declarators = Vec::new();
        match self.peek() {
            Lexeme::Name(_) => declarators.push(self.declarator()?),
            Lexeme::Symbol(Symbol::Comma | Symbol::Semicolon) => {}
            _ if matches!(ty.ty.kind, TypeKind::Struct(_)) => {}
            _ => return Err(self.no_name(&ty)),
        }
        while self.accept(Symbol::Comma) {
            if let Lexeme::Type(_) = self.peek() {
                let hint = "give the type once, or write `;` instead of the `,`";
                return Err(self.unexpected_but("a name", Some(hint)));
            }
            declarators.push(self.declarator()?);
        }
        self.semicolon(LIST_OR_END)?;
        Ok(Declaration::Variables { ty, declarators })
    }

    /// Reports what stands where a declared name should.
    fn no_name(&mut self, ty: &QualifiedType) -> Failed {
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
            Lexeme::Word(word) if word.begins_declaration() => {
                Some("qualifiers stand before the type, and no keyword can be a name")
            }
            Lexeme::Word(_) | Lexeme::Type(_) | Lexeme::Bool(_) => Some("no keyword can be a name"),
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
    fn plain_declarator(&mut self) -> Parse<Declarator> {
        let (name, at) = self.name("a name")?;
        let mut sizes = Vec::new();
        self.array_sizes(&mut sizes)?;
        Ok(Declarator {
            name,
            at,
            sizes,
            init: None,
        })
    }

    /// Any number of `[3]` and `[]`.
    pub fn array_sizes(&mut self, sizes: &mut Vec<ArraySize>) -> Parse<()> {
        while self.is(Symbol::LeftBracket) {
            let at = self.advance();
            let size = match self.is(Symbol::RightBracket) {
                true => None,
                false => Some(self.conditional()?),
            };
            self.close(at, Symbol::RightBracket, "`]`")?;
            sizes.push(ArraySize { size, at });
        }
        Ok(())
    }

    fn function(&mut self, result: QualifiedType) -> Parse<Declared> {
        let (name, at) = self.name("a name")?;
        let open = self.advance();
        let parameters = self.parameters(open)?;
        let header = Header {
            result,
            name,
            at,
            parameters,
            end: self.here(),
        };
        if self.is(Symbol::LeftBrace) {
            return Ok(Declared::Function(header));
        }
        self.semicolon("`{` or `;`")?;
        Ok(Declared::Declaration(Declaration::Prototype(header)))
    }

    fn parameters(&mut self, open: TokenIndex) -> Parse<Vec<Parameter>> {
        let mut parameters = Vec::new();
        if self.accept(Symbol::RightParenthesis) {
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
        self.close(open, Symbol::RightParenthesis, "`,` or `)`")?;
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
        let ty = self.qualified_type()?;
        let mut parameter = Parameter {
            at: ty.ty.extent.first,
            ty,
            name: None,
            sizes: Vec::new(),
        };
        if let Lexeme::Name(name) = self.peek() {
            parameter.name = Some(name);
            parameter.at = self.advance();
            self.array_sizes(&mut parameter.sizes)?;
        }
        Ok(parameter)
    }

    fn interface_block(&mut self, qualifiers: Vec<Qualifier>) -> Parse<Declaration> {
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

    /// The members of a structure or block, from their `{`.
    fn members(&mut self) -> Parse<Vec<Members>> {
        self.enter()?;
        self.advance();
        let mut members = Vec::new();
        while !self.is(Symbol::RightBrace) {
            let ty = self.qualified_type()?;
            let mut declarators = Vec::new();
            loop {
                match self.peek() {
                    Lexeme::Name(_) => declarators.push(self.plain_declarator()?),
                    _ => return Err(self.no_name(&ty)),
                }
                if !self.accept(Symbol::Comma) {
                    break;
                }
            }
            if self.is(Symbol::Assign) {
                let hint = "members get their values from a constructor";
                return Err(self.unexpected_but(LIST_OR_END, Some(hint)));
            }
            self.semicolon(LIST_OR_END)?;
            members.push(Members { ty, declarators });
        }
        if members.is_empty() {
            return Err(self.unexpected("a member"));
        }
        self.advance();
        self.leave();
        Ok(members)
    }

    /// A type with what precedes it.
    pub fn qualified_type(&mut self) -> Parse<QualifiedType> {
        let qualifiers = self.qualifiers()?;
        let ty = self.type_specifier()?;
        Ok(QualifiedType { qualifiers, ty })
    }

    /// A type by its name, or as it is defined here, with sizes.
    pub fn type_specifier(&mut self) -> Parse<TypeSpecifier> {
        let first = self.here();
        let kind = match self.peek() {
            Lexeme::Type(base) => {
                self.advance();
                TypeKind::Basic(base)
            }
            Lexeme::Name(name) => {
                self.advance();
                TypeKind::Named(name)
            }
            Lexeme::Word(Word::Struct) => {
                self.advance();
                TypeKind::Struct(Box::new(self.structure(first)?))
            }
            _ => return Err(self.unexpected("a type")),
        };
        let mut sizes = Vec::new();
        self.array_sizes(&mut sizes)?;
        Ok(TypeSpecifier {
            kind,
            sizes,
            extent: self.extent_from(first),
        })
    }

    /// A structure behind the word `struct`, which stands at `at`.
    fn structure(&mut self, at: TokenIndex) -> Parse<StructDefinition> {
        let (name, at) = match self.peek() {
            Lexeme::Name(name) => (Some(name), self.advance()),
            _ => (None, at),
        };
        if !self.is(Symbol::LeftBrace) {
            let hint = match name {
                Some(_) => "a structure's name alone is its type: `S s;`",
                None => "a structure is defined like `struct S { float x; };`",
            };
            return Err(self.unexpected_but("`{`", Some(hint)));
        }
        let members = self.members()?;
        Ok(StructDefinition { name, at, members })
    }

    fn qualifiers(&mut self) -> Parse<Vec<Qualifier>> {
        let mut qualifiers = Vec::new();
        loop {
            let at = self.here();
            let kind = match self.plain_qualifier() {
                Some(kind) => {
                    self.advance();
                    kind
                }
                None if self.accept_word(Word::Layout) => self.layout()?,
                None => return Ok(qualifiers),
            };
            qualifiers.push(Qualifier { kind, at });
        }
    }

    /// The qualifier of one word that is at hand.
    fn plain_qualifier(&self) -> Option<QualifierKind> {
        let Lexeme::Word(word) = self.peek() else {
            return None;
        };
        Some(match word {
            Word::Const => QualifierKind::Const,
            Word::In => QualifierKind::In,
            Word::Out => QualifierKind::Out,
            Word::InOut => QualifierKind::InOut,
            Word::Uniform => QualifierKind::Uniform,
            Word::Flat => QualifierKind::Flat,
            Word::Smooth => QualifierKind::Smooth,
            Word::Centroid => QualifierKind::Centroid,
            Word::Invariant => QualifierKind::Invariant,
            Word::Low => QualifierKind::Precision(Precision::Low),
            Word::Medium => QualifierKind::Precision(Precision::Medium),
            Word::High => QualifierKind::Precision(Precision::High),
            _ => return None,
        })
    }

    /// What stands behind the word `layout`.
    fn layout(&mut self) -> Parse<QualifierKind> {
        let open = self.here();
        if !self.accept(Symbol::LeftParenthesis) {
            return Err(self.unexpected("`(` behind `layout`"));
        }
        let mut items = Vec::new();
        loop {
            let (name, at) = self.name("a name")?;
            let value = match self.accept(Symbol::Assign) {
                true => Some(self.layout_value()?),
                false => None,
            };
            items.push(LayoutItem { name, at, value });
            if !self.accept(Symbol::Comma) {
                break;
            }
        }
        self.close(open, Symbol::RightParenthesis, "`,` or `)`")?;
        Ok(QualifierKind::Layout(items))
    }

    fn layout_value(&mut self) -> Parse<u32> {
        let value = match self.peek() {
            Lexeme::Int(value) => value as u32,
            Lexeme::Uint(value) => value,
            _ => return Err(self.unexpected("a whole number")),
        };
        self.advance();
        Ok(value)
    }
}
