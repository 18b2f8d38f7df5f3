use std::sync::OnceLock;

use glam::UVec2;
use vitrine::frame::{Clock, FrameImage, FrameInput};
use vitrine::render::{AdapterChoice, Extras, Gpu, GpuError, ReadBack, Renderer};
use vitrine::scene::Source;
use vitrine::session::{OpenError, Session, Setup};

use super::{pasted, plain};

/// The device that all tests share, or `None` where there is no graphics adapter: the test is then
/// skipped, which is said, and which `REQUIRE_GPU=1` forbids.
pub fn gpu() -> Option<&'static Gpu> {
    static GPU: OnceLock<Option<Gpu>> = OnceLock::new();
    let gpu = GPU.get_or_init(|| match Gpu::headless(&AdapterChoice::Auto) {
        Ok(gpu) => Some(gpu),
        Err(error) if std::env::var("REQUIRE_GPU").is_ok_and(|value| value == "1") => {
            panic!("REQUIRE_GPU is set, but {error}: {}", error.hint())
        }
        Err(_) => None,
    });
    if gpu.is_none() {
        let test = std::thread::current().name().unwrap_or_default().to_owned();
        eprintln!("{test}: skipped, no graphics adapter was found");
    }
    gpu.as_ref()
}

/// Opens a scene that is known to be good.
pub fn open(gpu: &Gpu, source: &Source) -> Session {
    match Session::open(gpu, source, &Setup::default()) {
        Ok(session) => session,
        Err(OpenError::Scene { report, .. }) => panic!("{}", plain(&report)),
        Err(error) => panic!("{error:?}"),
    }
}

/// Draws one frame and reads it back, as an export does.
pub fn draw(gpu: &Gpu, session: &Session, input: &FrameInput) -> FrameImage {
    draw_with(gpu, &session.renderer, input).expect("the device works")
}

/// The same for those who have translated and built the scene themselves.
pub fn draw_with(
    gpu: &Gpu,
    renderer: &Renderer,
    input: &FrameInput,
) -> Result<FrameImage, GpuError> {
    let mut canvas = renderer.canvas(gpu, input.resolution)?;
    let ring = ReadBack::new(gpu, &canvas.target, 1, Extras::default())?;
    let mut slot = ring.slots.into_iter().next().expect("one slot");
    if renderer.feeds_back() {
        for frame in 0..u32::try_from(input.frame).unwrap_or(0) {
            let before = Clock::fixed(60.0).at(frame, input.resolution);
            renderer.render(gpu, &before, &mut canvas, None);
        }
    }
    renderer.render(gpu, input, &mut canvas, Some(&mut slot));
    while !slot.is_ready(gpu)? {}
    let mut image = FrameImage::default();
    slot.take(gpu, &mut image)?;
    Ok(image)
}

/// Draws a pasted text at time 0.
pub fn still(gpu: &Gpu, text: &str, width: u32, height: u32) -> FrameImage {
    let session = open(gpu, &pasted(text));
    let input = Clock::fixed(60.0).at(0, UVec2::new(width, height));
    draw(gpu, &session, &input)
}
