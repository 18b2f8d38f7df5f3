use std::sync::{Arc, Mutex};

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

    /// Keeps only the passes for which `keep` holds.
    pub fn retain(&mut self, mut keep: impl FnMut(usize) -> bool) {
        let mut place = 0;
        self.passes.retain(|_| {
            place += 1;
            keep(place - 1)
        });
    }
}
