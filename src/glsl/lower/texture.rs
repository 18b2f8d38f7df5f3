//! Texture lookups, §8.8. A sampler without texture reads (0, 0, 0, 1), as WebGL's incomplete
//! textures do.

use naga::{Expression, ImageQuery, MathFunction, SampleLevel, ScalarKind};

use super::call::Sampler;
use super::expression::Typed;
use super::function::{Builder, H};
use crate::glsl::Precision;
use crate::glsl::arena::Id;
use crate::glsl::builtins::Builtin;
use crate::glsl::hir::{Expr, ExprKind, Value};
use crate::glsl::types::{Scalar, Shape, Type};

use Builtin as B;

/// How the operands of a lookup follow each other, behind the sampler and the coordinates.
struct Form {
    is_projected: bool,
    level: Level,
    has_offset: bool,
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Level {
    /// By the derivatives, perhaps with a bias as the last operand.
    Auto,
    Lod,
    Gradient,
}

impl Form {
    fn of(builtin: Builtin) -> Self {
        use Level::{Auto, Gradient, Lod};
        let (is_projected, level, has_offset) = match builtin {
            B::Texture => (false, Auto, false),
            B::TextureOffset => (false, Auto, true),
            B::TextureProj => (true, Auto, false),
            B::TextureProjOffset => (true, Auto, true),
            B::TextureLod => (false, Lod, false),
            B::TextureLodOffset => (false, Lod, true),
            B::TextureProjLod => (true, Lod, false),
            B::TextureProjLodOffset => (true, Lod, true),
            B::TextureGrad => (false, Gradient, false),
            B::TextureGradOffset => (false, Gradient, true),
            B::TextureProjGrad => (true, Gradient, false),
            B::TextureProjGradOffset => (true, Gradient, true),
            _ => unreachable!("it reads through no sampler"),
        };
        Form {
            is_projected,
            level,
            has_offset,
        }
    }
}

impl Builder<'_, '_> {
    /// A lookup, or a texture's size.
    pub(super) fn texture(&mut self, builtin: Builtin, operands: &[Id<Expr>], ty: Type) -> H {
        let sampler = self.sampler(operands[0]);
        let Sampler::Image(image, sampler) = sampler else {
            for &operand in &operands[1..] {
                self.effect(operand);
            }
            return self.no_texture(builtin, ty);
        };
        let shape = match self.source.exprs[operands[0]].ty.sampler() {
            Some(sampler) => sampler.shape,
            None => unreachable!("the first operand is a sampler"),
        };
        match builtin {
            B::TextureSize => {
                let level = self.value(operands[1]);
                self.texture_size(image, shape, level, ty)
            }
            B::TexelFetch | B::TexelFetchOffset => self.texel_fetch(image, shape, operands),
            _ => {
                let sampler = sampler.expect("the analysis finds what is read through");
                self.sample(Form::of(builtin), image, sampler, shape, operands)
            }
        }
    }

    fn no_texture(&mut self, builtin: Builtin, ty: Type) -> H {
        let scalar = ty.scalar().expect("texels are numbers");
        if builtin == B::TextureSize {
            let one = self.number(1, scalar);
            return self.splat(one, ty.vector_size().unwrap_or(1));
        }
        let zero = self.number(0, scalar);
        if ty.is_scalar() {
            return zero;
        }
        let one = self.number(1, scalar);
        self.compose(ty, vec![zero, zero, zero, one])
    }

    fn texture_size(&mut self, image: H, shape: Shape, level: H, ty: Type) -> H {
        let query = ImageQuery::Size { level: Some(level) };
        let size = self.add(Expression::ImageQuery { image, query });
        let size = self.cast(size, ScalarKind::Sint, Some(4));
        if shape != Shape::Layers {
            return size;
        }
        let query = ImageQuery::NumLayers;
        let layers = self.add(Expression::ImageQuery { image, query });
        let layers = self.cast(layers, ScalarKind::Sint, Some(4));
        self.compose(ty, vec![size, layers])
    }

    fn texel_fetch(&mut self, image: H, shape: Shape, operands: &[Id<Expr>]) -> H {
        let mut at = self.value(operands[1]);
        let level = self.value(operands[2]);
        let layer = (shape == Shape::Layers).then(|| self.part(at, 2));
        if layer.is_some() {
            at = self.swizzle(at, &[0, 1]);
        }
        if let Some(&offset) = operands.get(3) {
            let offset = self.value(offset);
            at = self.sum(at, offset);
        }
        if shape == Shape::Plane && self.is_sanitized() {
            let query = ImageQuery::Size { level: Some(level) };
            let size = self.add(Expression::ImageQuery { image, query });
            let ty = Type::vector(Scalar::Int, 2);
            self.check_texel(Typed { value: at, ty }, size);
        }
        let texel = self.add(Expression::ImageLoad {
            image,
            coordinate: at,
            array_index: layer,
            sample: None,
            level: Some(level),
        });
        self.widen_texel(texel)
    }

    fn sample(
        &mut self,
        form: Form,
        image: H,
        sampler: H,
        shape: Shape,
        operands: &[Id<Expr>],
    ) -> H {
        let coordinates = self.typed(operands[1]);
        let (coordinate, array_index) = self.coordinates(coordinates, shape, form.is_projected);
        let mut rest = operands[2..].iter();
        let mut next = |b: &mut Self| {
            let value = b.value(*rest.next()?);
            Some(b.narrow(value))
        };
        let mut level = match form.level {
            Level::Auto => SampleLevel::Auto,
            Level::Lod => SampleLevel::Exact(next(self).expect("it has a level")),
            Level::Gradient => SampleLevel::Gradient {
                x: next(self).expect("it has a gradient"),
                y: next(self).expect("it has a gradient"),
            },
        };
        let offset = form.has_offset.then(|| rest.next().copied()).flatten();
        let offset = offset.and_then(|id| self.offset(id));
        if form.level == Level::Auto
            && let Some(&bias) = rest.next()
        {
            let bias = self.value(bias);
            level = SampleLevel::Bias(self.narrow(bias));
        }
        let texel = self.add(Expression::ImageSample {
            image,
            sampler,
            gather: None,
            coordinate,
            array_index,
            offset,
            level,
            depth_ref: None,
            clamp_to_edge: false,
        });
        self.widen_texel(texel)
    }

    /// The coordinates proper, and the layer.
    fn coordinates(&mut self, operand: Typed, shape: Shape, is_projected: bool) -> (H, Option<H>) {
        let own = operand.ty.vector_size().expect("coordinates are a vector");
        let size = match shape {
            Shape::Plane | Shape::Layers => 2,
            Shape::Volume | Shape::Cube => 3,
        };
        let value = self.narrow(operand.value);
        let mut at = value;
        if own > size {
            at = self.swizzle(value, &[0, 1, 2][..usize::from(size)]);
        }
        if is_projected {
            let divisor = self.part(value, u32::from(own) - 1);
            let divisor = self.splat(divisor, size);
            at = self.quotient(at, divisor);
        }
        let layer = (shape == Shape::Layers).then(|| {
            let layer = self.part(value, 2);
            let layer = self.math(MathFunction::Round, &[layer]);
            self.cast(layer, ScalarKind::Sint, Some(4))
        });
        (at, layer)
    }

    /// An offset, which naga wants as literals.
    fn offset(&mut self, id: Id<Expr>) -> Option<H> {
        let Expr { kind, ty, .. } = self.source.exprs[id];
        let ExprKind::Constant(constant) = kind else {
            debug_assert!(false, "the checker takes only constant offsets");
            return None;
        };
        let values = self.context.hir.constants.get(constant);
        let components: Vec<_> = values
            .iter()
            .map(|value| match value {
                Value::Int(value) => self.int(*value),
                other => unreachable!("{other:?} is no offset"),
            })
            .collect();
        Some(self.compose(ty, components))
    }

    /// A texel from 32 bits, whatever the precision. It goes component by component: a driver was seen to
    /// make anything of the conversion of a whole texel.
    fn widen_texel(&mut self, texel: H) -> H {
        if self.context.options.precision == Precision::Single {
            return texel;
        }
        let components = (0..4).map(|index| {
            let component = self.part(texel, index);
            self.widen(component)
        });
        let components = components.collect();
        self.compose(Type::vector(Scalar::Float, 4), components)
    }
}
