//! What the names of the texture functions say, §8.8: where the coordinates are, which level is read,
//! and which argument is what.

use super::Builtin;

/// How a lookup finds the level of detail.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Level {
    /// From the neighbouring pixels; a last argument more may add to it.
    Implicit,
    /// Given as a `float`.
    Explicit,
    /// From two given derivatives.
    Gradient,
    /// One texel by its whole coordinates, of a level given as an `int`.
    Fetch,
}

/// A kind of texture lookup. The arguments are the sampler, the coordinates, what the level needs,
/// the offset, the bias.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Lookup {
    /// How the level is found.
    pub level: Level,
    /// Whether the coordinates are divided by their last component.
    pub projects: bool,
    /// Whether there is an offset in texels.
    pub offset: bool,
}

impl Lookup {
    /// Which argument comes behind the coordinates and what the level needs.
    const fn behind_level(self) -> usize {
        match self.level {
            Level::Implicit => 2,
            Level::Explicit | Level::Fetch => 3,
            Level::Gradient => 4,
        }
    }

    /// Which argument is the offset: a constant expression, each component from
    /// `gl_MinProgramTexelOffset` to `gl_MaxProgramTexelOffset`.
    pub const fn offset_argument(self) -> Option<usize> {
        if self.offset {
            Some(self.behind_level())
        } else {
            None
        }
    }

    /// Which argument is the bias, in a call with this many.
    pub const fn bias_argument(self, count: usize) -> Option<usize> {
        let index = self.behind_level() + self.offset as usize;
        if matches!(self.level, Level::Implicit) && count > index {
            Some(index)
        } else {
            None
        }
    }

    /// Which argument is the level.
    pub const fn level_argument(self) -> Option<usize> {
        match self.level {
            Level::Explicit | Level::Fetch => Some(2),
            Level::Implicit | Level::Gradient => None,
        }
    }

    /// Which arguments are the derivatives of the coordinates.
    pub const fn gradient_arguments(self) -> Option<[usize; 2]> {
        match self.level {
            Level::Gradient => Some([2, 3]),
            Level::Implicit | Level::Explicit | Level::Fetch => None,
        }
    }
}

impl Builtin {
    /// The kind of texture lookup that the function makes, if it makes one.
    pub const fn lookup(self) -> Option<Lookup> {
        use Level::{Explicit, Fetch, Gradient, Implicit};
        let (level, projects, offset) = match self {
            Builtin::Texture => (Implicit, false, false),
            Builtin::TextureProj => (Implicit, true, false),
            Builtin::TextureLod => (Explicit, false, false),
            Builtin::TextureOffset => (Implicit, false, true),
            Builtin::TexelFetch => (Fetch, false, false),
            Builtin::TexelFetchOffset => (Fetch, false, true),
            Builtin::TextureProjOffset => (Implicit, true, true),
            Builtin::TextureLodOffset => (Explicit, false, true),
            Builtin::TextureProjLod => (Explicit, true, false),
            Builtin::TextureProjLodOffset => (Explicit, true, true),
            Builtin::TextureGrad => (Gradient, false, false),
            Builtin::TextureGradOffset => (Gradient, false, true),
            Builtin::TextureProjGrad => (Gradient, true, false),
            Builtin::TextureProjGradOffset => (Gradient, true, true),
            _ => return None,
        };
        Some(Lookup {
            level,
            projects,
            offset,
        })
    }

    /// Whether the function reads texels.
    pub const fn is_texture_lookup(self) -> bool {
        self.lookup().is_some()
    }

    /// Which argument is a constant offset in texels, if any.
    pub fn offset_argument(self) -> Option<usize> {
        self.lookup()?.offset_argument()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_tell_the_kind_of_lookup() {
        for function in Builtin::ALL {
            let name = function.name();
            let reads = (name.starts_with("texture") || name.starts_with("texelFetch"))
                && name != "textureSize";
            assert_eq!(function.is_texture_lookup(), reads, "{name}");
            let Some(lookup) = function.lookup() else {
                continue;
            };
            assert_eq!(lookup.projects, name.contains("Proj"), "{name}");
            assert_eq!(lookup.offset, name.ends_with("Offset"), "{name}");
            let level = match () {
                () if name.contains("Lod") => Level::Explicit,
                () if name.contains("Grad") => Level::Gradient,
                () if name.contains("Fetch") => Level::Fetch,
                () => Level::Implicit,
            };
            assert_eq!(lookup.level, level, "{name}");
        }
    }

    #[test]
    fn arguments_stand_where_the_signatures_have_them() {
        let place = |name, count| {
            let lookup = Builtin::find(name).and_then(Builtin::lookup).expect(name);
            (lookup.offset_argument(), lookup.bias_argument(count))
        };
        assert_eq!(place("texture", 2), (None, None));
        assert_eq!(place("texture", 3), (None, Some(2)));
        assert_eq!(place("textureProjOffset", 3), (Some(2), None));
        assert_eq!(place("textureOffset", 4), (Some(2), Some(3)));
        assert_eq!(place("textureLodOffset", 4), (Some(3), None));
        assert_eq!(place("texelFetchOffset", 4), (Some(3), None));
        assert_eq!(place("textureProjGradOffset", 5), (Some(4), None));
        assert_eq!(Builtin::TextureGradOffset.offset_argument(), Some(4));
        assert_eq!(Builtin::TextureSize.offset_argument(), None);
    }
}
