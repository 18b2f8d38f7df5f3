//! Qualifiers, §4.3 to §4.7: which there may be, and in which order.

use super::Checker;
use crate::glsl::arena::Range;
use crate::glsl::syntax::ast::{
    Extent, LayoutItem, Precision, Qualifier, QualifierKind, TokenIndex,
};
use crate::glsl::types::{Base, Sampler, Scalar, Shape};

/// Where a variable lives.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Storage {
    /// No word says.
    Plain,
    Const,
    In,
    Out,
    InOut,
    Uniform,
}

/// Qualifiers put together.
#[derive(Clone, Debug)]
pub(super) struct Qualifiers {
    pub storage: Storage,
    /// How an input is interpolated, with the word's place.
    pub interpolation: Option<TokenIndex>,
    pub is_flat: bool,
    pub invariant: Option<TokenIndex>,
    pub precision: Option<TokenIndex>,
    pub layout: Vec<LayoutItem>,
}

/// Types whose precision need not be given: ES 3.00, §4.5.4, for fragment shaders.
pub(super) fn initial_precisions() -> Vec<(Base, usize)> {
    let sampler = |shape| {
        Base::Sampler(Sampler {
            texel: Scalar::Float,
            shape,
            shadow: false,
        })
    };
    vec![
        (Base::Scalar(Scalar::Int), 0),
        (sampler(Shape::Plane), 0),
        (sampler(Shape::Cube), 0),
    ]
}

/// The order in which ES 3.00 wants qualifiers, §4.7.
fn rank(kind: &QualifierKind) -> u8 {
    match kind {
        QualifierKind::Invariant => 0,
        QualifierKind::Flat | QualifierKind::Smooth => 1,
        QualifierKind::Layout(_) => 2,
        QualifierKind::Const
        | QualifierKind::In
        | QualifierKind::Out
        | QualifierKind::InOut
        | QualifierKind::Uniform
        | QualifierKind::Centroid => 3,
        QualifierKind::Precision(_) => 4,
    }
}

fn word(kind: &QualifierKind) -> &'static str {
    match kind {
        QualifierKind::Const => "const",
        QualifierKind::In => "in",
        QualifierKind::Out => "out",
        QualifierKind::InOut => "inout",
        QualifierKind::Uniform => "uniform",
        QualifierKind::Flat => "flat",
        QualifierKind::Smooth => "smooth",
        QualifierKind::Centroid => "centroid",
        QualifierKind::Invariant => "invariant",
        QualifierKind::Precision(Precision::Low) => "lowp",
        QualifierKind::Precision(Precision::Medium) => "mediump",
        QualifierKind::Precision(Precision::High) => "highp",
        QualifierKind::Layout(_) => "layout",
    }
}

impl Checker<'_> {
    /// Reports qualifiers that stand twice or in the wrong order.
    fn check_sequence(&mut self, qualifiers: &[Qualifier]) -> bool {
        let same = |a: &QualifierKind, b: &QualifierKind| {
            let both_precise = rank(a) == 4 && rank(b) == 4;
            let both_interpolate = rank(a) == 1 && rank(b) == 1;
            both_precise || both_interpolate || word(a) == word(b)
        };
        for (i, qualifier) in qualifiers.iter().enumerate() {
            let extent = Extent::of(qualifier.at);
            let before = &qualifiers[..i];
            let this = word(&qualifier.kind);
            if before
                .iter()
                .any(|other| same(&other.kind, &qualifier.kind))
            {
                let message = format!("`{this}` is one qualifier too many of its kind");
                self.error("qualifier", message, extent);
                return false;
            }
            let late = before
                .iter()
                .find(|other| rank(&other.kind) > rank(&qualifier.kind));
            if let Some(other) = late {
                let message = format!("`{this}` must stand before `{}`", word(&other.kind));
                let hint = "the order is: invariant, flat or smooth, layout, const or in or out or \
                            uniform, precision";
                self.error_with_hint("qualifier", message, extent, hint);
                return false;
            }
        }
        true
    }

    /// The qualifiers of a variable, a function's result or a block.
    pub(super) fn variable_qualifiers(&mut self, qualifiers: Range<Qualifier>) -> Qualifiers {
        let qualifiers = self.ast.qualifiers.get(qualifiers);
        let mut found = Qualifiers {
            storage: Storage::Plain,
            interpolation: None,
            is_flat: false,
            invariant: None,
            precision: None,
            layout: Vec::new(),
        };
        if !self.check_sequence(qualifiers) {
            return found;
        }
        let mut has_centroid = None;
        for Qualifier { kind, at } in qualifiers {
            let extent = Extent::of(*at);
            let storage = match kind {
                QualifierKind::Precision(_) => {
                    found.precision = Some(*at);
                    continue;
                }
                QualifierKind::Const => Storage::Const,
                _ if !self.is_global() => {
                    let message = format!("`{}` is for global variables only", word(kind));
                    self.error("qualifier", message, extent);
                    continue;
                }
                QualifierKind::Invariant => {
                    found.invariant = Some(*at);
                    continue;
                }
                QualifierKind::Flat | QualifierKind::Smooth => {
                    found.interpolation = Some(*at);
                    found.is_flat = matches!(kind, QualifierKind::Flat);
                    continue;
                }
                QualifierKind::Layout(items) => {
                    found.layout.extend(self.ast.layouts.get(*items));
                    continue;
                }
                QualifierKind::Centroid => {
                    has_centroid = Some(*at);
                    continue;
                }
                QualifierKind::In => Storage::In,
                QualifierKind::Out => Storage::Out,
                QualifierKind::InOut => Storage::InOut,
                QualifierKind::Uniform => Storage::Uniform,
            };
            if found.storage != Storage::Plain {
                let message = format!("`{}` does not go with the qualifier before it", word(kind));
                self.error("qualifier", message, extent);
                continue;
            }
            found.storage = storage;
        }
        let is_varying = matches!(found.storage, Storage::In | Storage::Out);
        if let Some(at) = found.interpolation.or(has_centroid)
            && !is_varying
        {
            let message = "interpolation is for inputs only";
            self.error("qualifier", message, Extent::of(at));
        }
        if let Some(at) = found.invariant
            && found.storage != Storage::Out
        {
            self.error(
                "qualifier",
                "only outputs can be `invariant`",
                Extent::of(at),
            );
        }
        if found.storage == Storage::InOut {
            let at = qualifiers
                .iter()
                .find(|one| matches!(one.kind, QualifierKind::InOut));
            let extent = Extent::of(at.map_or(0, |one| one.at));
            self.error("qualifier", "`inout` is for parameters only", extent);
            found.storage = Storage::Plain;
        }
        found
    }

    /// The qualifiers of a member, of which only the precision is allowed; in a block also `uniform` and
    /// how matrices are laid out.
    pub(super) fn member_qualifiers(
        &mut self,
        qualifiers: Range<Qualifier>,
        is_block: bool,
    ) -> Option<TokenIndex> {
        let qualifiers = self.ast.qualifiers.get(qualifiers);
        self.check_sequence(qualifiers);
        let mut precision = None;
        for Qualifier { kind, at } in qualifiers {
            match kind {
                QualifierKind::Precision(_) => precision = Some(*at),
                QualifierKind::Uniform if is_block => {}
                QualifierKind::Layout(items) if is_block => {
                    for item in self.ast.layouts.get(*items) {
                        let name = self.text(item.name).to_owned();
                        if !matches!(&*name, "row_major" | "column_major") {
                            let message = format!("a member cannot have the layout `{name}`");
                            let hint = "there are `row_major` and `column_major`";
                            self.error_with_hint("qualifier", message, Extent::of(item.at), hint);
                        }
                    }
                }
                kind => {
                    let message = format!("a member cannot be `{}`", word(kind));
                    self.error("qualifier", message, Extent::of(*at));
                }
            }
        }
        precision
    }

    /// The qualifiers of a parameter: its storage, and its precision's place.
    pub(super) fn parameter_qualifiers(
        &mut self,
        qualifiers: Range<Qualifier>,
    ) -> (Storage, bool, Option<TokenIndex>) {
        let qualifiers = self.ast.qualifiers.get(qualifiers);
        let mut storage = Storage::Plain;
        let mut is_const = false;
        let mut precision = None;
        if !self.check_sequence(qualifiers) {
            return (Storage::Plain, false, None);
        }
        for Qualifier { kind, at } in qualifiers {
            let next = match kind {
                QualifierKind::Precision(_) => {
                    precision = Some(*at);
                    continue;
                }
                QualifierKind::Const if storage == Storage::Plain => {
                    is_const = true;
                    continue;
                }
                QualifierKind::In => Some(Storage::In),
                QualifierKind::Out if !is_const => Some(Storage::Out),
                QualifierKind::InOut if !is_const => Some(Storage::InOut),
                _ => None,
            };
            match next.filter(|_| storage == Storage::Plain) {
                Some(next) => storage = next,
                None => {
                    let message = format!("a parameter cannot be `{}` here", word(kind));
                    let hint = "it may be `in`, `out`, `inout`, `const` or `const in`";
                    self.error_with_hint("qualifier", message, Extent::of(*at), hint);
                    return (storage, is_const, precision);
                }
            }
        }
        (storage, is_const, precision)
    }

    /// Checks that a type has a precision if it needs one, and none if it can have none.
    pub(super) fn check_precision(
        &mut self,
        given: Option<TokenIndex>,
        base: Base,
        extent: Extent,
    ) {
        let wants = match base {
            Base::Scalar(Scalar::Bool) | Base::Vector(Scalar::Bool, _) => None,
            Base::Void | Base::Struct(_) => None,
            Base::Scalar(Scalar::Float) | Base::Vector(Scalar::Float, _) | Base::Matrix { .. } => {
                Some(Base::Scalar(Scalar::Float))
            }
            Base::Scalar(_) | Base::Vector(..) => Some(Base::Scalar(Scalar::Int)),
            Base::Sampler(_) => Some(base),
        };
        match (given, wants) {
            (Some(at), None) => {
                let message = "this type has no precision";
                self.error("precision", message, Extent::of(at));
            }
            (None, Some(wants))
                if !self
                    .default_precisions
                    .iter()
                    .any(|(known, _)| *known == wants) =>
            {
                let name = self.spell(base.into());
                let message = format!("the precision of `{name}` is not given");
                let hint = format!("write `highp {name}`, or `precision highp {name};` above");
                self.error_with_hint("precision", message, extent, hint);
            }
            _ => {}
        }
    }

    /// `precision highp float;`
    pub(super) fn set_precision(&mut self, base: Option<Base>, is_array: bool, extent: Extent) {
        match base {
            Some(base @ (Base::Scalar(Scalar::Float | Scalar::Int) | Base::Sampler(_)))
                if !is_array =>
            {
                let depth = self.scopes.depth();
                if !self
                    .default_precisions
                    .iter()
                    .any(|(known, _)| *known == base)
                {
                    self.default_precisions.push((base, depth));
                }
            }
            _ => {
                let message =
                    "a default precision can be given to `float`, `int` and samplers only";
                self.error("precision", message, extent);
            }
        }
    }

    /// Ends a scope, and the default precisions that were given in it.
    pub(super) fn close_scope(&mut self) {
        self.scopes.close();
        let depth = self.scopes.depth();
        while self
            .default_precisions
            .last()
            .is_some_and(|&(_, given)| given > depth)
        {
            self.default_precisions.pop();
        }
    }
}
