//! What stands in for sound in a program that was built without the feature `sound`.

use std::sync::Arc;

use crate::render::Gpu;
use crate::report;
use crate::scene::Source;
use crate::session::Setup;

/// Plays nothing.
pub(super) struct Sound;

impl Sound {
    pub fn new(_is_muted: bool) -> Self {
        Sound
    }

    #[expect(clippy::unused_self, reason = "it stands in for what has a state")]
    pub fn play(&mut self, _gpu: &Arc<Gpu>, _source: &Source, _setup: &Setup, has_sound: bool) {
        if has_sound {
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
