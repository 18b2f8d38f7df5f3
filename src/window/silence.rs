//! What stands in for sound in a program that was built without the feature `sound`.

use std::sync::Arc;

use crate::render::Gpu;
use crate::report;
use crate::scene::Source;
use crate::session::{Session, Setup};

/// Plays nothing.
pub(super) struct Sound;

impl Sound {
    pub fn new(_is_muted: bool) -> Self {
        Sound
    }

    #[expect(clippy::unused_self, reason = "it stands in for what has a state")]
    pub fn play(&mut self, _gpu: &Arc<Gpu>, session: &Session, _source: &Source, _setup: &Setup) {
        let has_music = !session.inputs.sounds().is_empty() || !session.idle_music().is_empty();
        if session.has_sound() || has_music {
            report::tell(
                "the scene's sound is not heard: this program was built without the feature `sound`",
            );
        }
    }

    pub fn follow(&self, _time: f32, _runs: bool) {}

    pub fn toggle_mute(&self) -> bool {
        true
    }
}
