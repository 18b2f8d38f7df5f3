use glam::UVec2;

use super::{OpenError, Session, Setup};
use crate::frame::{Clock, FloatImage};
use crate::render::{Canvas, Extras, Format, Gpu, GpuError, Pace, ReadBack, SOUND_SIDE, Slot};
use crate::scene::{PassKind, Source};

/// The sound of a scene.
#[derive(Debug)]
pub struct Track {
    /// Its Sound pass.
    pub session: Session,
    canvas: Canvas,
    slot: Slot,
    pace: Pace,
    image: FloatImage,
}

impl Track {
    /// How long the site lets a sound be, in seconds.
    pub const SECONDS: f64 = 180.0;

    /// Opens a scene for its sound; `None` if it has none.
    pub fn open(gpu: &Gpu, source: &Source, setup: &Setup) -> Result<Option<Self>, OpenError> {
        let setup = Setup {
            format: Format::Floats,
            for_sound: true,
            ..setup.clone()
        };
        let session = Session::open(gpu, source, &setup)?;
        if session.scene.passes.last().map(|pass| pass.kind) != Some(PassKind::Sound) {
            return Ok(None);
        }
        let size = UVec2::splat(SOUND_SIDE);
        let canvas = session.renderer.canvas(gpu, size)?;
        let mut ring = ReadBack::new(gpu, &canvas.target, 1, Extras::default())?;
        Ok(Some(Track {
            slot: ring.slots.pop().expect("one slot was asked for"),
            pace: Pace::new(gpu, size),
            image: FloatImage::default(),
            session,
            canvas,
        }))
    }

    /// Computes the samples of a block, left and right, [`SOUND_BLOCK`](crate::render::SOUND_BLOCK) of them, and waits for
    /// them. They are as the shader gives them, also where that is no number. `between` is called now and then; `false`
    /// gives up, and then there are none.
    pub fn block(
        &mut self,
        gpu: &Gpu,
        number: u32,
        between: &mut dyn FnMut() -> bool,
    ) -> Result<Option<Vec<[f32; 2]>>, GpuError> {
        let size = UVec2::splat(SOUND_SIDE);
        let input = Clock::fixed(60.0).at(number, size);
        let Track {
            session,
            canvas,
            slot,
            pace,
            image,
        } = self;
        let renderer = &session.renderer;
        if !renderer.render_in_bands(gpu, &input, canvas, Some(slot), pace, between)? {
            return Ok(None);
        }
        while !slot.is_ready(gpu)? {
            between();
        }
        slot.take_floats(gpu, image)?;
        // The picture's top row comes first, the samples begin in the bottom one.
        let rows = image.rgba.chunks(SOUND_SIDE as usize).rev();
        Ok(Some(
            rows.flatten()
                .map(|&[left, right, ..]| [left, right])
                .collect(),
        ))
    }
}
