use glam::UVec2;

/// A finished picture: 8 bits a channel, red, green, blue, no alpha, top row first, no padding.
///
/// The bytes are the shader's numbers times 255, rounded: nothing is encoded as sRGB, because the
/// site shows them as they are.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FrameImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// `3 · width · height` bytes.
    pub rgb: Vec<u8>,
}

/// A picture of floats as the shader gives them: red, green, blue and alpha, top row first.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct FloatImage {
    /// Width and height in pixels.
    pub size: UVec2,
    /// `width · height` pixels.
    pub rgba: Vec<[f32; 4]>,
}

impl FloatImage {
    /// The picture in bytes, as a target of 8 bits holds it: clamped to 0 to 1, times 255, rounded.
    pub fn to_bytes(&self) -> FrameImage {
        let byte = |value: f32| (value.clamp(0.0, 1.0) * 255.0).round_ties_even() as u8;
        let pixels = self.rgba.iter();
        FrameImage {
            size: self.size,
            rgb: pixels
                .flat_map(|pixel| [0, 1, 2].map(|i| byte(pixel[i])))
                .collect(),
        }
    }
}

impl FrameImage {
    /// Red, green and blue of the pixel in column `x` and row `y`, counted from the top left.
    ///
    /// # Panics
    /// When the pixel lies outside the picture.
    pub fn pixel(&self, x: u32, y: u32) -> [u8; 3] {
        assert!(
            x < self.size.x && y < self.size.y,
            "pixel outside the picture"
        );
        let at = 3 * (y as usize * self.size.x as usize + x as usize);
        [self.rgb[at], self.rgb[at + 1], self.rgb[at + 2]]
    }
}
