//! What a program found while it ran, in its author's words.

use std::fmt::Write as _;

use crate::glsl::builtins::Builtin;
use crate::glsl::hir::Hir;
use crate::glsl::lower::{self, Form, Hazard, OPERAND_WORDS};
use crate::glsl::types::{Base, Scalar, Type};
use crate::source::{Diagnostic, Span};

/// A place in a program where something can go wrong while it runs.
#[derive(Clone, Debug, PartialEq)]
pub struct Site {
    /// What.
    pub hazard: Hazard,
    /// Where, unless it is in the host's text.
    pub span: Option<Span>,
    origin: Option<Span>,
    form: Form,
    /// What the text calls it, if it has a name.
    name: String,
    operands: Vec<Type>,
}

/// What went wrong at a site.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// The site, by its number in [`Program::sites`](super::Program::sites).
    pub site: usize,
    /// The operation that is to blame: this site's, or one within it.
    pub cause: usize,
    /// In how many pixels, of all frames that were looked at.
    pub pixels: u64,
    /// In how many frames.
    pub frames: u32,
    /// Column and row of the first pixel, from the bottom left.
    pub first: [u16; 2],
    /// Which frame that is in, as `frame 3` or `iTime = 60`; empty if there is no other.
    pub within: String,
    /// What the operands were there, as GLSL; empty if they are not known.
    pub operands: String,
}

impl Site {
    pub(super) fn new(
        site: lower::Site,
        span: Option<Span>,
        origin: Option<Span>,
        hir: &Hir,
    ) -> Self {
        let name = match site.form {
            Form::Variable(name) => hir.names.text(name).to_owned(),
            Form::Call(builtin) => builtin.name().to_owned(),
            Form::Operator(op) => op.symbol().to_owned(),
            Form::Conversion(scalar) => Base::Scalar(scalar)
                .keyword()
                .unwrap_or_default()
                .to_owned(),
            Form::Texel => Builtin::TexelFetch.name().to_owned(),
            Form::Index(_) | Form::Loop => String::new(),
        };
        Site {
            hazard: site.hazard,
            span,
            origin,
            form: site.form,
            name,
            operands: site.operands,
        }
    }

    /// Whether a second look can tell what the operands were.
    pub fn has_operands(&self) -> bool {
        !self.operands.is_empty()
    }

    /// What the operands were, from the bits of their components; `None` if there are too few.
    fn operands(&self, words: &[u32]) -> Option<String> {
        let mut words = words.iter();
        let operands = self.operands.iter();
        let values: Option<Vec<String>> = operands
            .map(|&ty| value(ty, &mut || words.next().copied()))
            .collect();
        let values = values?;
        Some(match (self.form, values.as_slice()) {
            (Form::Operator(op), [left, right]) => format!("{left} {} {right}", op.symbol()),
            (Form::Index(_), [index]) => format!("[{index}]"),
            (Form::Texel, [at]) => at.clone(),
            _ => format!("{}({})", self.name, values.join(", ")),
        })
    }

    fn message(&self) -> String {
        let name = &self.name;
        match self.hazard {
            Hazard::DivisionByZero if name == "/" => "division by zero".to_owned(),
            Hazard::DivisionByZero => format!("`{name}` by zero"),
            Hazard::IntegerDivision => {
                "a division of integers that GLSL leaves undefined".to_owned()
            }
            Hazard::Domain => match name.as_str() {
                "sqrt" => "`sqrt` of a negative number".to_owned(),
                "asin" | "acos" => format!("`{name}` of a number beyond 1"),
                "acosh" => "`acosh` of a number below 1".to_owned(),
                "atanh" => "`atanh` of a number that is not within 1".to_owned(),
                "atan" => "`atan` of a point without direction".to_owned(),
                _ => format!("`{name}` of a number that is not positive"),
            },
            Hazard::NegativeBase => "`pow` of a base that is not positive".to_owned(),
            Hazard::ZeroVector => "`normalize` of a vector without length".to_owned(),
            Hazard::Limits if name == "clamp" => {
                "`clamp` with its lower limit above the upper".to_owned()
            }
            Hazard::Limits => format!("`{name}` whose first edge is not below the second"),
            Hazard::Index => match self.form {
                Form::Index(count) => format!("an index out of range: there are {count} elements"),
                _ => format!("`{name}` outside of the texture"),
            },
            Hazard::Conversion => format!("`{name}` of a number that it cannot hold"),
            Hazard::Shift => "a shift by fewer than 0 or more than 31 bits".to_owned(),
            Hazard::Unset => format!("`{name}` is read before it is set"),
            Hazard::NotFinite => match self.form {
                Form::Call(_) => format!("`{name}` of finite numbers is infinite or no number"),
                _ => "finite operands give infinity or what is no number".to_owned(),
            },
            Hazard::Endless => "this loop does not end".to_owned(),
        }
    }

    /// The message's code, and the way out.
    fn advice(&self) -> (&'static str, &'static str) {
        match self.hazard {
            Hazard::DivisionByZero => (
                "division-by-zero",
                "keep the divisor away from zero: `max(x, 1e-6)`, or ask before dividing",
            ),
            Hazard::IntegerDivision => ("integer-division", "ask before dividing"),
            Hazard::Domain => (
                "domain",
                match self.name.as_str() {
                    "asin" | "acos" => "rounding leads beyond 1 easily: `clamp(x, -1.0, 1.0)`",
                    "atan" => "add something small to an argument, or ask before",
                    _ => "bring the argument into range: `max(x, 0.0)`, `max(x, 1e-6)`",
                },
            ),
            Hazard::NegativeBase => (
                "negative-base",
                "machines disagree here: `pow(abs(x), y)`, `pow(max(x, 1e-6), y)`, or `x * x`",
            ),
            Hazard::ZeroVector => (
                "zero-vector",
                "ask for the length before, or add something small: `normalize(v + 1e-6)`",
            ),
            Hazard::Limits => match self.name.as_str() {
                "clamp" => ("limits", "swap the limits"),
                _ => (
                    "limits",
                    "edges in rising order work everywhere: `1.0 - smoothstep(b, a, x)`",
                ),
            },
            Hazard::Index => (
                "index-out-of-range",
                "bring it into range: `clamp(i, 0, last)`",
            ),
            Hazard::Conversion => (
                "conversion",
                "bring it into range before; `uint(int(x))` takes negative numbers",
            ),
            Hazard::Shift => ("shift", "machines disagree here: `n & 31`"),
            Hazard::Unset => ("unset-variable", "give it a value where it is declared"),
            Hazard::NotFinite => (
                "not-finite",
                "everything computed from it will be no number either",
            ),
            Hazard::Endless => (
                "endless-loop",
                "let it count its rounds and break; check that every round changes what its condition asks",
            ),
        }
    }
}

impl Finding {
    /// Takes in what a second look has noted of the site: the operation that is to blame, and its operands.
    ///
    /// # Panics
    /// When there are fewer than [`OPERAND_WORDS`] words.
    pub fn look_up(&mut self, sites: &[Site], words: &[u32]) {
        let (mark, words) = (words[0], &words[1..OPERAND_WORDS as usize]);
        if let Some(cause) = mark.checked_sub(1)
            && let Some(site) = sites.get(cause as usize)
        {
            self.cause = cause as usize;
            self.operands = site.operands(words).unwrap_or_default();
        }
    }

    /// As a compiler would put it.
    pub fn diagnostic(&self, sites: &[Site]) -> Diagnostic {
        let site = &sites[self.cause];
        let (code, hint) = site.advice();
        let mut message = format!("{} in {}", site.message(), counted(self.pixels, "pixel"));
        if self.frames > 1 {
            let _ = write!(message, " of {}", counted(self.frames.into(), "frame"));
        }
        let [x, y] = self.first;
        let first = if self.pixels > 1 {
            ", the first at"
        } else {
            " at"
        };
        let _ = write!(message, "{first} ({x}, {y})");
        if !self.within.is_empty() {
            let _ = write!(message, " of {}", self.within);
        }
        if !self.operands.is_empty() {
            let _ = write!(message, ": {}", self.operands);
        }
        let diagnostic = Diagnostic::warning(code, message).at(site.span).hint(hint);
        match site.origin {
            Some(origin) => diagnostic.note(origin, "a macro brings it from here"),
            None => diagnostic,
        }
    }
}

fn counted(count: u64, noun: &str) -> String {
    match count {
        1 => format!("1 {noun}"),
        _ => format!("{count} {noun}s"),
    }
}

/// A value as GLSL writes it; `None` when there are too few words.
fn value(ty: Type, next: &mut dyn FnMut() -> Option<u32>) -> Option<String> {
    Some(match ty.base {
        Base::Scalar(scalar) => {
            let word = next()?;
            match scalar {
                Scalar::Float => float(f32::from_bits(word)),
                Scalar::Int => (word as i32).to_string(),
                Scalar::Uint => format!("{word}u"),
                Scalar::Bool => (word != 0).to_string(),
            }
        }
        Base::Vector(scalar, size) => {
            let parts: Option<Vec<_>> = (0..size)
                .map(|_| value(Type::vector(scalar, 1), next))
                .collect();
            let mut parts = parts?;
            if parts.iter().all(|part| *part == parts[0]) {
                parts.truncate(1);
            }
            format!("{}({})", ty.base.keyword()?, parts.join(", "))
        }
        Base::Matrix { columns, rows } => {
            let column = Type::vector(Scalar::Float, rows);
            let parts: Option<Vec<_>> = (0..columns).map(|_| value(column, next)).collect();
            format!("{}({})", ty.base.keyword()?, parts?.join(", "))
        }
        _ => return None,
    })
}

/// With the fewest digits that tell it from its neighbours.
fn float(value: f32) -> String {
    if value.is_nan() {
        "NaN".to_owned()
    } else if value.is_infinite() {
        if value > 0.0 { "infinity" } else { "-infinity" }.to_owned()
    } else {
        format!("{value:?}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glsl::hir::BinaryOp;

    fn site(form: Form, name: &str, operands: Vec<Type>) -> Site {
        Site {
            hazard: Hazard::NotFinite,
            span: None,
            origin: None,
            form,
            name: name.to_owned(),
            operands,
        }
    }

    fn words(values: &[f32]) -> Vec<u32> {
        values.iter().map(|value| value.to_bits()).collect()
    }

    #[test]
    fn operands_are_written_as_glsl() {
        let vector = Type::vector(Scalar::Float, 2);
        let division = Form::Operator(BinaryOp::Divide);
        let site_of = |ty| site(division, "/", vec![ty, Type::FLOAT]);
        let text = site_of(vector).operands(&words(&[1.0, -2.5, 0.0]));
        assert_eq!(text.as_deref(), Some("vec2(1.0, -2.5) / 0.0"));
        let text = site_of(Type::matrix(2, 2)).operands(&words(&[1.0, 0.0, 0.0, 1e30, 3.0]));
        let expected = "mat2(vec2(1.0, 0.0), vec2(0.0, 1e30)) / 3.0";
        assert_eq!(text.as_deref(), Some(expected));
        let pow = site(Form::Call(Builtin::Pow), "pow", vec![Type::FLOAT; 2]);
        let text = pow.operands(&words(&[-0.25, 2.2]));
        assert_eq!(text.as_deref(), Some("pow(-0.25, 2.2)"));
        assert_eq!(pow.operands(&[0]), None);
    }

    #[test]
    fn a_finding_names_pixel_frame_and_operands() {
        let sites = [site(Form::Call(Builtin::Exp), "exp", vec![Type::FLOAT])];
        let finding = Finding {
            site: 0,
            cause: 0,
            pixels: 12,
            frames: 2,
            first: [3, 4],
            within: "frame 7".to_owned(),
            operands: "exp(100.0)".to_owned(),
        };
        let diagnostic = finding.diagnostic(&sites);
        assert_eq!(
            diagnostic.message,
            "`exp` of finite numbers is infinite or no number in 12 pixels of 2 frames, the first at (3, 4) \
             of frame 7: exp(100.0)"
        );
    }
}
