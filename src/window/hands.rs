//! Mouse and keys as the next frame will see them, and the recording of both.

use std::path::Path;

use glam::{IVec2, UVec2};

use crate::frame::{Action, FrameInput, Keyboard, Mouse};
use crate::input_script::Recorder;
use crate::report;

use super::{PlayError, Record};

/// What someone holds and points at.
#[derive(Default)]
pub(super) struct Hands {
    mouse: Mouse,
    keyboard: Keyboard,
    recorder: Option<Recorder>,
}

impl Hands {
    /// Records what happens from now on.
    pub fn record(&mut self, record: &Record, size: UVec2, fps: f64) -> Result<(), PlayError> {
        let path: &Path = &record.path;
        let recorder = Recorder::create(path, size, fps, record.overwrite);
        let recorder = recorder.map_err(|error| PlayError::Record {
            path: path.to_owned(),
            error,
        })?;
        self.recorder = Some(recorder);
        Ok(())
    }

    pub fn is_recording(&self) -> bool {
        self.recorder.is_some()
    }

    pub fn is_dragging(&self) -> bool {
        self.mouse.is_down()
    }

    /// The pointer moved within a picture of this size.
    pub fn moved(&mut self, to: IVec2, size: UVec2) {
        let before = self.mouse;
        self.mouse.moved(to);
        if self.mouse != before {
            self.note(Action::Move(to), size);
        }
    }

    /// The button went down in a picture of this size.
    pub fn press(&mut self, at: IVec2, size: UVec2) {
        self.mouse.press(at);
        self.note(Action::Press(at), size);
    }

    /// The button went up.
    pub fn release(&mut self) {
        if self.mouse.is_down() {
            self.mouse.release();
            self.note(Action::Release, UVec2::ONE);
        }
    }

    /// A key went down or up.
    pub fn key(&mut self, code: u8, is_down: bool) {
        let before = self.keyboard;
        let action = match is_down {
            true => {
                self.keyboard.press(code);
                Action::KeyDown(code)
            }
            false => {
                self.keyboard.release(code);
                Action::KeyUp(code)
            }
        };
        // A key that is held repeats itself.
        if self.keyboard != before {
            self.note(action, UVec2::ONE);
        }
    }

    /// No one sees any more when the keys go up.
    pub fn release_keys(&mut self) {
        for code in self.keyboard.held() {
            self.key(code, false);
        }
        self.keyboard.release_all();
    }

    /// Gives a frame that is about to be drawn what it sees.
    pub fn give(&mut self, input: &mut FrameInput) {
        input.mouse = self.mouse.frame_value();
        self.mouse.frame_drawn();
        input.keyboard = self.keyboard;
        self.keyboard.frame_drawn();
        let recorder = self.recorder.as_mut();
        let result = recorder.map_or(Ok(()), |recorder| recorder.frame_drawn(input));
        self.go_on_recording(result);
    }

    /// Another scene comes, which nobody has touched yet.
    pub fn let_go(&mut self) {
        (self.mouse, self.keyboard) = (Mouse::default(), Keyboard::default());
        let recorder = self.recorder.as_mut();
        let result = recorder.map_or(Ok(()), Recorder::restart);
        self.go_on_recording(result);
    }

    /// Time begins again. What is recorded begins at rest, or the script would not tell all.
    pub fn restart(&mut self) {
        if self.is_recording() {
            self.let_go();
        }
    }

    /// Nothing more happens.
    pub fn finish(self) {
        if let Some(Err(error)) = self.recorder.map(Recorder::finish) {
            tell_lost(&error);
        }
    }

    fn note(&mut self, action: Action, size: UVec2) {
        if let Some(recorder) = &mut self.recorder {
            recorder.note(action, size);
        }
    }

    /// A full disk ends the recording, not the playing.
    fn go_on_recording(&mut self, result: std::io::Result<()>) {
        if let Err(error) = result {
            tell_lost(&error);
            self.recorder = None;
        }
    }
}

fn tell_lost(error: &std::io::Error) {
    report::tell(format_args!("input is not recorded any more: {error}"));
}
