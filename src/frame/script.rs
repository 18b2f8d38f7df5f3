use std::sync::Arc;

use glam::{DVec2, IVec2, UVec2, Vec4};

use super::{FrameInput, Keyboard, Mouse};

/// What someone did with mouse and keys, frame by frame: played back, it gives every frame the `iMouse` and the keyboard
/// that it had then.
#[derive(Clone, Debug, PartialEq)]
pub struct Script {
    /// Width and height of the picture that positions were taken in.
    pub size: UVec2,
    /// Frames per second that it was made with, as far as is known.
    pub fps: f64,
    /// What happened; frame numbers never decrease.
    pub events: Vec<Event>,
}

/// One thing that happened.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Event {
    /// The number of the first frame that sees it.
    pub frame: u32,
    /// What it was.
    pub action: Action,
}

/// What can happen. Positions are whole pixels from the bottom left of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Action {
    /// The button went down.
    Press(IVec2),
    /// The pointer moved.
    Move(IVec2),
    /// The button went up.
    Release,
    /// A key, by JavaScript's `keyCode`, went down.
    KeyDown(u8),
    /// A key went up.
    KeyUp(u8),
}

/// The pixel of a picture of another size that lies where this one does. In the same size it is the same.
pub fn rescaled(at: IVec2, from: UVec2, to: UVec2) -> IVec2 {
    let middle = at.as_dvec2() + DVec2::splat(0.5);
    let part = middle / from.max(UVec2::ONE).as_dvec2();
    (part * to.as_dvec2()).floor().as_ivec2()
}

/// Plays a script in pictures of one size.
#[derive(Clone, Debug)]
pub struct Player {
    script: Arc<Script>,
    size: UVec2,
    mouse: Mouse,
    keyboard: Keyboard,
    /// How many events have happened.
    done: usize,
    /// The frame that the state is of.
    frame: u32,
}

impl Player {
    /// Begins at the first frame.
    pub fn new(script: Arc<Script>, size: UVec2) -> Self {
        Player {
            script,
            size,
            mouse: Mouse::default(),
            keyboard: Keyboard::default(),
            done: 0,
            frame: 0,
        }
    }

    /// What a frame sees: all that happened up to it. It does not matter which frames were asked for before, so
    /// that an export can be cut in parts.
    pub fn at(&mut self, frame: u32) -> (Vec4, Keyboard) {
        if frame < self.frame {
            *self = Player::new(Arc::clone(&self.script), self.size);
        }
        while let Some(event) = self.script.events.get(self.done)
            && event.frame <= frame
        {
            let action = event.action;
            self.go_to(event.frame);
            self.act(action);
            self.done += 1;
        }
        self.go_to(frame);
        (self.mouse.frame_value(), self.keyboard)
    }

    /// The frames before this one have seen the state.
    fn go_to(&mut self, frame: u32) {
        if frame > self.frame {
            self.mouse.frame_drawn();
            self.keyboard.frame_drawn();
            self.frame = frame;
        }
    }

    fn act(&mut self, action: Action) {
        let here = |at| rescaled(at, self.script.size, self.size);
        match action {
            Action::Press(at) => self.mouse.press(here(at)),
            Action::Move(to) => self.mouse.moved(here(to)),
            Action::Release => self.mouse.release(),
            Action::KeyDown(key) => self.keyboard.press(key),
            Action::KeyUp(key) => self.keyboard.release(key),
        }
    }
}

/// Where the mouse and the keys of frames come from that are drawn without a window.
#[derive(Clone, Debug, Default, PartialEq)]
pub enum Controls {
    /// Nobody touches anything.
    #[default]
    Untouched,
    /// `iMouse` is this in every frame.
    Mouse(Vec4),
    /// What a script says.
    Script(Arc<Script>),
}

impl Controls {
    /// Gives frames of one size what they see; best called in the order of the frames.
    pub fn hands(&self, size: UVec2) -> impl FnMut(FrameInput) -> FrameInput + use<> {
        let mut player = match self {
            Controls::Script(script) => Some(Player::new(Arc::clone(script), size)),
            _ => None,
        };
        let still = match self {
            Controls::Mouse(mouse) => *mouse,
            _ => Vec4::ZERO,
        };
        move |input| {
            let (mouse, keyboard) = match &mut player {
                Some(player) => player.at(input.frame.max(0) as u32),
                None => (still, Keyboard::default()),
            };
            FrameInput {
                mouse,
                keyboard,
                ..input
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn script(events: &[(u32, Action)]) -> Arc<Script> {
        let events = events
            .iter()
            .map(|&(frame, action)| Event { frame, action });
        Arc::new(Script {
            size: UVec2::new(100, 50),
            fps: 60.0,
            events: events.collect(),
        })
    }

    /// What a keyboard's rows say of a key.
    fn rows(keyboard: &Keyboard, key: usize) -> [u8; 3] {
        let texels = keyboard.texels();
        [texels[key], texels[256 + key], texels[512 + key]]
    }

    #[test]
    fn a_frame_sees_what_happened_up_to_it() {
        let script = script(&[
            (2, Action::Press(IVec2::new(10, 20))),
            (2, Action::KeyDown(65)),
            (4, Action::Move(IVec2::new(30, 40))),
            (5, Action::Release),
            (5, Action::KeyUp(65)),
        ]);
        let mut player = Player::new(Arc::clone(&script), script.size);
        let in_order: Vec<_> = (0..8).map(|frame| player.at(frame)).collect();
        let mouse = |frame: usize| in_order[frame].0.to_array();
        assert_eq!(mouse(1), [0.0; 4]);
        assert_eq!(mouse(2), [10.0, 20.0, 10.0, 20.0]);
        assert_eq!(mouse(3), [10.0, 20.0, 10.0, -20.0], "w only once");
        assert_eq!(mouse(4), [30.0, 40.0, 10.0, -20.0]);
        assert_eq!(mouse(7), [30.0, 40.0, -10.0, -20.0]);
        let key = |frame: usize| rows(&in_order[frame].1, 65);
        assert_eq!([key(1), key(2)], [[0; 3], [255; 3]]);
        assert_eq!(key(3), [255, 0, 255], "pressed in one frame only");
        assert_eq!(key(6), [0, 0, 255]);
        for frame in [7, 3, 0, 2, 5, 4, 2] {
            assert_eq!(player.at(frame), in_order[frame as usize], "{frame} alone");
        }
        let mut late = Player::new(script, UVec2::new(100, 50));
        assert_eq!(late.at(3), in_order[3], "frame 2 has seen the press");
    }

    #[test]
    fn positions_scale_with_the_picture() {
        let at = |x, y| IVec2::new(x, y);
        let (small, large) = (UVec2::new(100, 50), UVec2::new(400, 200));
        assert_eq!(rescaled(at(10, 20), small, small), at(10, 20));
        assert_eq!(rescaled(at(-1, 99), small, small), at(-1, 99));
        assert_eq!(rescaled(at(10, 20), small, large), at(42, 82));
        assert_eq!(rescaled(at(42, 82), large, small), at(10, 20));
        let far = rescaled(IVec2::MAX, UVec2::ONE, UVec2::MAX);
        assert_eq!(far, IVec2::MAX, "nothing overflows");
    }

    #[test]
    fn without_a_script_nothing_or_one_thing_is_touched() {
        let size = UVec2::new(4, 4);
        let input = super::super::Clock::fixed(60.0).at(3, size);
        assert_eq!(Controls::Untouched.hands(size)(input), input);
        let mouse = Vec4::new(1.0, 2.0, 3.0, -4.0);
        assert_eq!(Controls::Mouse(mouse).hands(size)(input).mouse, mouse);
    }
}
