//! Types with what stands around them: qualifiers, sizes, the members of structures.

use smallvec::SmallVec;

use super::ast::{
    ArraySize, LayoutItem, Members, Precision, QualifiedType, Qualifier, QualifierKind, Sizes,
    StructDefinition, TokenIndex, TypeKind, TypeSpecifier,
};
use super::declaration::{Declarators, LIST_OR_END};
use super::lexeme::Lexeme;
use super::parser::{Parse, Parser};
use crate::glsl::arena::Range;
use crate::glsl::words::{Symbol, Word};

impl Parser<'_> {
    /// Any number of `[3]` and `[]`.
    pub fn array_sizes(&mut self) -> Parse<Sizes> {
        if !self.is(Symbol::LeftBracket) {
            return Ok(Sizes::default());
        }
        let mut sizes = Vec::new();
        self.more_sizes(&mut sizes)?;
        Ok(self.ast.sizes.add(&sizes))
    }

    /// The same behind others.
    pub fn more_sizes(&mut self, sizes: &mut Vec<ArraySize>) -> Parse<()> {
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

    /// The members of a structure or block, from their `{`.
    pub fn members(&mut self) -> Parse<Vec<Members>> {
        self.enter()?;
        self.advance();
        let mut members = Vec::new();
        while !self.is(Symbol::RightBrace) {
            let ty = self.qualified_type()?;
            let mut declarators = Declarators::new();
            loop {
                match self.peek() {
                    Lexeme::Type(_) | Lexeme::Word(_) if !self.is_keyword_as_name() => {
                        return Err(self.no_name(&ty));
                    }
                    _ => declarators.push(self.plain_declarator()?),
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
            let declarators = self.ast.declarators.add(&declarators);
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
        Ok(TypeSpecifier {
            kind,
            sizes: self.array_sizes()?,
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

    pub fn qualifiers(&mut self) -> Parse<Range<Qualifier>> {
        let mut qualifiers = SmallVec::<[Qualifier; 4]>::new();
        loop {
            let at = self.here();
            let kind = match self.plain_qualifier() {
                Some(kind) => {
                    self.advance();
                    kind
                }
                None if self.accept_word(Word::Layout) => self.layout()?,
                None => return Ok(self.ast.qualifiers.add(&qualifiers)),
            };
            qualifiers.push(Qualifier { kind, at });
        }
    }

    /// The qualifier of one word that is at hand.
    pub fn plain_qualifier(&self) -> Option<QualifierKind> {
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
        Ok(QualifierKind::Layout(self.ast.layouts.add(&items)))
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
