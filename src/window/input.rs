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
    /// Make the sound silent, or heard again.
    ToggleMute,
    /// Fill the screen, or leave it.
    ToggleFullScreen,
    /// Open the clipboard's text as a scene.
    Paste,
    /// Close the window.
    Leave,
}

/// The command of a key, if it has one. Where the scene reads the keyboard, the keys are the scene's, and commands
/// are given with Control.
pub(super) fn command(key: &Key, modifiers: ModifiersState, is_scenes: bool) -> Option<Command> {
    // Command on a Mac, Control elsewhere; both are taken everywhere.
    let shortcut = modifiers.control_key() || modifiers.super_key();
    match key {
        Key::Character(text) if shortcut => match text.to_lowercase().as_str() {
            "v" => Some(Command::Paste),
            _ if is_scenes => command(key, ModifiersState::empty(), false),
            _ => None,
        },
        Key::Character(_) | Key::Named(NamedKey::Space) if is_scenes && !shortcut => None,
        Key::Character(text) => match text.to_lowercase().as_str() {
            "." => Some(Command::Step(1)),
            "," => Some(Command::Step(-1)),
            "r" => Some(Command::Restart),
            "s" => Some(Command::Save),
            "f" => Some(Command::ToggleFullScreen),
            "m" => Some(Command::ToggleMute),
            _ => None,
        },
        Key::Named(NamedKey::Space | NamedKey::Pause) => Some(Command::TogglePause),
        Key::Named(NamedKey::Paste) => Some(Command::Paste),
        Key::Named(NamedKey::Escape) => Some(Command::Leave),
        _ => None,
    }
}

/// JavaScript's old `keyCode` of a key, which is how shaders know it.
pub(super) fn key_code(key: &Key) -> Option<u8> {
    use NamedKey as N;
    Some(match key {
        Key::Character(text) => {
            let mut characters = text.chars();
            let (first, None) = (characters.next()?.to_ascii_uppercase(), characters.next()) else {
                return None;
            };
            match first {
                'A'..='Z' | '0'..='9' => first as u8,
                ';' | ':' => 186,
                '=' | '+' => 187,
                ',' | '<' => 188,
                '-' | '_' => 189,
                '.' | '>' => 190,
                '/' | '?' => 191,
                '`' | '~' => 192,
                '[' | '{' => 219,
                '\\' | '|' => 220,
                ']' | '}' => 221,
                '\'' | '"' => 222,
                _ => return None,
            }
        }
        Key::Named(name) => match name {
            N::Backspace => 8,
            N::Tab => 9,
            N::Enter => 13,
            N::Shift => 16,
            N::Control => 17,
            N::Alt => 18,
            N::Pause => 19,
            N::CapsLock => 20,
            N::Escape => 27,
            N::Space => 32,
            N::PageUp => 33,
            N::PageDown => 34,
            N::End => 35,
            N::Home => 36,
            N::ArrowLeft => 37,
            N::ArrowUp => 38,
            N::ArrowRight => 39,
            N::ArrowDown => 40,
            N::Insert => 45,
            N::Delete => 46,
            N::F1 => 112,
            N::F2 => 113,
            N::F3 => 114,
            N::F4 => 115,
            N::F5 => 116,
            N::F6 => 117,
            N::F7 => 118,
            N::F8 => 119,
            N::F9 => 120,
            N::F10 => 121,
            N::F11 => 122,
            N::F12 => 123,
            _ => return None,
        },
        _ => return None,
    })
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
        assert_eq!(
            command(&character("."), PLAIN, false),
            Some(Command::Step(1))
        );
        assert_eq!(
            command(&character(","), PLAIN, false),
            Some(Command::Step(-1))
        );
        assert_eq!(
            command(&character("R"), ModifiersState::SHIFT, false),
            Some(Command::Restart)
        );
        assert_eq!(
            command(&character("v"), ModifiersState::CONTROL, false),
            Some(Command::Paste)
        );
        assert_eq!(command(&character("v"), PLAIN, false), None);
        assert_eq!(
            command(&character("s"), ModifiersState::CONTROL, false),
            None
        );
        let named = |key| command(&Key::Named(key), PLAIN, false);
        assert_eq!(named(NamedKey::Space), Some(Command::TogglePause));
        assert_eq!(named(NamedKey::Escape), Some(Command::Leave));
        assert_eq!(named(NamedKey::Tab), None);
    }

    #[test]
    fn keys_of_a_scene_that_reads_them() {
        let character = |text: &str| Key::Character(text.into());
        assert_eq!(command(&character("s"), PLAIN, true), None);
        assert_eq!(command(&Key::Named(NamedKey::Space), PLAIN, true), None);
        let with_control = |text| command(&character(text), ModifiersState::CONTROL, true);
        assert_eq!(with_control("s"), Some(Command::Save));
        assert_eq!(with_control("v"), Some(Command::Paste));
        let escape = command(&Key::Named(NamedKey::Escape), PLAIN, true);
        assert_eq!(escape, Some(Command::Leave));
    }

    #[test]
    fn keys_have_the_numbers_of_browsers() {
        let character = |text: &str| key_code(&Key::Character(text.into()));
        assert_eq!(character("a"), Some(65));
        assert_eq!(character("Z"), Some(90));
        assert_eq!(character("7"), Some(55));
        assert_eq!(character("é"), None);
        assert_eq!(key_code(&Key::Named(NamedKey::ArrowLeft)), Some(37));
        assert_eq!(key_code(&Key::Named(NamedKey::Space)), Some(32));
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
