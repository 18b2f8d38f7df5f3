use super::Format;

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
