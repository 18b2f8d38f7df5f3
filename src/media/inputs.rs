use std::sync::{Arc, Mutex};

use super::sound::Sound;
use super::{Feed, Texels};
use crate::scene::CHANNELS;

/// What a channel reads, loaded.
#[derive(Clone, Debug)]
pub enum Content {
    /// Texels that stay as they are.
    Still(Arc<Texels>),
    /// Texels that change with time.
    Live(Arc<Mutex<dyn Feed>>),
}

/// What the channels of a scene's passes read, loaded: by pass, in the scene's order, and by channel. What is drawn, the
/// keyboard, and what no pass needs is not among it.
#[derive(Clone, Debug, Default)]
pub struct Inputs {
    passes: Vec<[Option<Content>; CHANNELS]>,
}

impl Inputs {
    /// Of these passes.
    pub fn new(passes: Vec<[Option<Content>; CHANNELS]>) -> Self {
        Inputs { passes }
    }

    /// What a channel of a pass reads.
    pub fn of(&self, pass: usize, channel: usize) -> Option<&Content> {
        self.passes.get(pass)?[channel].as_ref()
    }

    /// What is heard of it all, each sound once.
    pub fn sounds(&self) -> Vec<Arc<Sound>> {
        let mut found: Vec<Arc<Sound>> = Vec::new();
        for content in self.passes.iter().flatten().flatten() {
            if let Content::Live(feed) = content
                && let Some(sound) = feed.lock().expect("no holder panics").sound()
                && !found.iter().any(|known| Arc::ptr_eq(known, sound))
            {
                found.push(Arc::clone(sound));
            }
        }
        found
    }

    /// Keeps only the passes for which `keep` holds.
    pub fn retain(&mut self, mut keep: impl FnMut(usize) -> bool) {
        let mut place = 0;
        self.passes.retain(|_| {
            place += 1;
            keep(place - 1)
        });
    }
}
