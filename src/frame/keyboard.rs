/// ShaderToy's keyboard as a state machine. A key is named by JavaScript's old `keyCode`: letters and digits by
/// their ASCII, 37 to 40 for the arrows left, up, right, down, 32 for the space bar.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Keyboard {
    held: Keys,
    /// Went down since the latest frame.
    pressed: Keys,
    /// Changes with each press.
    toggled: Keys,
}

/// A bit for each key.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
struct Keys([u64; 4]);

impl Keys {
    fn has(self, key: u8) -> bool {
        self.0[usize::from(key / 64)] >> (key % 64) & 1 == 1
    }

    fn set(&mut self, key: u8, is_set: bool) {
        let bit = 1 << (key % 64);
        let word = &mut self.0[usize::from(key / 64)];
        *word = if is_set { *word | bit } else { *word & !bit };
    }
}

impl Keyboard {
    /// The columns and rows of the texture that shaders read.
    pub const SIZE: [u32; 2] = [256, 3];

    /// A key went down. That it repeats while it is held is no press.
    pub fn press(&mut self, key: u8) {
        if !self.held.has(key) {
            self.held.set(key, true);
            self.pressed.set(key, true);
            self.toggled.set(key, !self.toggled.has(key));
        }
    }

    /// A key went up.
    pub fn release(&mut self, key: u8) {
        self.held.set(key, false);
        self.pressed.set(key, false);
    }

    /// Every key went up, or no one sees any more when it does.
    pub fn release_all(&mut self) {
        self.held = Keys::default();
        self.pressed = Keys::default();
    }

    /// The keys that are held.
    pub fn held(&self) -> impl Iterator<Item = u8> + use<> {
        let held = self.held;
        (0..=u8::MAX).filter(move |&key| held.has(key))
    }

    /// A frame has seen the keys that were pressed.
    pub fn frame_drawn(&mut self) {
        self.pressed = Keys::default();
    }

    /// The texture, row by row: which keys are held, which went down since the latest frame, which are
    /// toggled. 255 is yes.
    pub fn texels(&self) -> Vec<u8> {
        let rows = [self.held, self.pressed, self.toggled].into_iter();
        let bytes = rows.flat_map(|row| (0..=u8::MAX).map(move |key| 255 * u8::from(row.has(key))));
        bytes.collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the three rows say of a key.
    fn rows(keyboard: &Keyboard, key: usize) -> [u8; 3] {
        let texels = keyboard.texels();
        [texels[key], texels[256 + key], texels[512 + key]]
    }

    #[test]
    fn a_press_lasts_one_frame_and_toggles() {
        let mut keyboard = Keyboard::default();
        keyboard.press(65);
        assert_eq!(rows(&keyboard, 65), [255, 255, 255]);
        keyboard.frame_drawn();
        keyboard.press(65);
        assert_eq!(rows(&keyboard, 65), [255, 0, 255], "it only repeats");
        keyboard.release(65);
        assert_eq!(rows(&keyboard, 65), [0, 0, 255]);
        keyboard.press(65);
        assert_eq!(rows(&keyboard, 65), [255, 255, 0]);
        assert_eq!(rows(&keyboard, 66), [0; 3]);
    }

    #[test]
    fn a_release_before_the_frame_takes_the_press_away() {
        let mut keyboard = Keyboard::default();
        keyboard.press(255);
        keyboard.press(0);
        keyboard.release(255);
        assert_eq!(rows(&keyboard, 255), [0, 0, 255]);
        keyboard.release_all();
        assert_eq!(rows(&keyboard, 0), [0, 0, 255]);
    }
}
