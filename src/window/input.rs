//! What keys and pointer mean, as pure functions.

use glam::{DVec2, IVec2, UVec2};
use winit::keyboard::{Key, ModifiersState, NamedKey};

/// What a key asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Command {
    /// Stop time, or let it go on.
    TogglePause,
    /// Stop time and move by this many frames.
    Step(i32),
    /// Back to time 0.
    Restart,
    /// Write the picture to a file.
    Save,
    /// Fill the screen, or leave it.
    ToggleFullScreen,
    /// Open the clipboard's text as a scene.
    Paste,
    /// Close the window.
    Leave,
}

/// The command of a key, if it has one.
pub(super) fn command(key: &Key, modifiers: ModifiersState) -> Option<Command> {
    // Command on a Mac, Control elsewhere; both are taken everywhere.
    let shortcut = modifiers.control_key() || modifiers.super_key();
    match key {
        Key::Character(text) if shortcut => match text.to_lowercase().as_str() {
            "v" => Some(Command::Paste),
            _ => None,
        },
        Key::Character(text) => match text.to_lowercase().as_str() {
            "." => Some(Command::Step(1)),
            "," => Some(Command::Step(-1)),
            "r" => Some(Command::Restart),
            "s" => Some(Command::Save),
            "f" => Some(Command::ToggleFullScreen),
            _ => None,
        },
        Key::Named(NamedKey::Space | NamedKey::Pause) => Some(Command::TogglePause),
        Key::Named(NamedKey::Paste) => Some(Command::Paste),
        Key::Named(NamedKey::Escape) => Some(Command::Leave),
        _ => None,
    }
}

/// The picture's pixel under a point of the window, counted from the bottom left and floored as the
/// site does. `at` counts from the top left in window pixels, and may lie outside.
pub(super) fn pixel_under(at: DVec2, window: UVec2, picture: UVec2) -> IVec2 {
    let part = at / window.max(UVec2::ONE).as_dvec2();
    let from_bottom = DVec2::new(part.x, 1.0 - part.y);
    (from_bottom * picture.as_dvec2()).floor().as_ivec2()
}

#[cfg(test)]
mod tests {
    use super::*;

    const PLAIN: ModifiersState = ModifiersState::empty();

    #[test]
    fn keys() {
        let character = |text: &str| Key::Character(text.into());
        assert_eq!(command(&character("."), PLAIN), Some(Command::Step(1)));
        assert_eq!(command(&character(","), PLAIN), Some(Command::Step(-1)));
        assert_eq!(
            command(&character("R"), ModifiersState::SHIFT),
            Some(Command::Restart)
        );
        assert_eq!(
            command(&character("v"), ModifiersState::CONTROL),
            Some(Command::Paste)
        );
        assert_eq!(command(&character("v"), PLAIN), None);
        assert_eq!(command(&character("s"), ModifiersState::CONTROL), None);
        let named = |key| command(&Key::Named(key), PLAIN);
        assert_eq!(named(NamedKey::Space), Some(Command::TogglePause));
        assert_eq!(named(NamedKey::Escape), Some(Command::Leave));
        assert_eq!(named(NamedKey::Tab), None);
    }

    #[test]
    fn the_pointer_counts_pixels_from_the_bottom_left() {
        let window = UVec2::new(200, 100);
        let at = |x, y, picture| pixel_under(DVec2::new(x, y), window, picture).to_array();
        assert_eq!(at(0.5, 99.5, window), [0, 0]);
        assert_eq!(at(199.9, 0.1, window), [199, 99]);
        assert_eq!(
            at(100.0, 50.0, UVec2::new(50, 25)),
            [25, 12],
            "in the picture's pixels"
        );
        assert_eq!(
            at(-3.0, 150.0, window),
            [-3, -50],
            "a drag may leave the window"
        );
    }
}
