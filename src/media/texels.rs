/// Texels in memory, ready to become a texture.
#[derive(Clone, Debug, PartialEq)]
pub struct Texels {
    /// Width, height and depth: a picture has the depth 1, a cubemap its six faces +X, −X, +Y, −Y, +Z, −Z.
    pub size: [u32; 3],
    /// What one texel is.
    pub format: Format,
    /// Texels row by row and layer by layer. Pictures and faces have their top row first, as files do.
    pub bytes: Vec<u8>,
}

/// What one texel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// One number from 0 to 1 in 8 bits; it is read as (r, 0, 0, 1).
    R8,
    /// Red, green, blue and alpha, each from 0 to 1 in 8 bits.
    Rgba8,
    /// One 32-bit float.
    R32Float,
    /// Four 32-bit floats.
    Rgba32Float,
}

impl Format {
    /// Bytes of a texel.
    pub fn bytes(self) -> usize {
        match self {
            Format::R8 => 1,
            Format::Rgba8 | Format::R32Float => 4,
            Format::Rgba32Float => 16,
        }
    }
}
