//! The real window, on a display of its own: what it shows, and what it makes of files, mouse and keys.

use std::io::{BufRead as _, BufReader, Read as _};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use x11rb::connection::Connection as _;
use x11rb::protocol::xproto::{AtomEnum, ConnectionExt as _, ImageFormat, InputFocus, Window};
use x11rb::protocol::xtest::ConnectionExt as _;
use x11rb::rust_connection::RustConnection;

use crate::support::{Folder, gpu, read_png, still};

const WIDTH: u32 = 160;
const HEIGHT: u32 = 90;

/// Long enough for a driver that compiles on a busy machine.
const PATIENCE: Duration = Duration::from_secs(30);

const KEY_PRESS: u8 = 2;
const KEY_RELEASE: u8 = 3;
const BUTTON_PRESS: u8 = 4;
const BUTTON_RELEASE: u8 = 5;
const MOTION: u8 = 6;

const ESCAPE: u32 = 0xff1b;

/// Shows orientation, and the mouse: blue while the button is down, and its place as a white pixel.
const SCENE: &str = "void mainImage(out vec4 color, in vec2 coord) {
    color = vec4(coord / iResolution.xy, iMouse.z > 0.0 ? 1.0 : 0.0, 1.0);
    if (iMouse.z > 0.0 && ivec2(coord) == ivec2(iMouse.xy)) color = vec4(1.0);
}";

#[test]
fn the_window_shows_reloads_and_obeys() {
    let Some(gpu) = gpu() else { return };
    let Some(mut display) = Display::start() else {
        return;
    };
    let folder = Folder::with("corners.glsl", SCENE);
    display.run(&folder, &["corners.glsl"]);
    let expected = |text: &str| still(gpu, text, WIDTH, HEIGHT).rgb;

    display.until("the scene is shown", |d| {
        d.picture() == Some(expected(SCENE))
    });
    assert!(
        display.title().contains("corners — "),
        "{}",
        display.title()
    );

    let turned = SCENE.replace("vec4(coord /", "vec4((iResolution.xy - coord) /");
    folder.write("corners.glsl", &turned);
    display.until("the edit is shown", |d| {
        d.picture() == Some(expected(&turned))
    });

    folder.write("corners.glsl", turned.replace("color =", "colour ="));
    display.until("the title names the mistake", |d| {
        d.title().starts_with("ERROR ")
    });
    assert_eq!(
        display.picture(),
        Some(expected(&turned)),
        "the old picture goes on"
    );

    folder.write("corners.glsl", SCENE);
    display.until("the mended scene is shown", |d| {
        d.picture() == Some(expected(SCENE))
    });
    assert!(!display.title().starts_with("ERROR"), "{}", display.title());

    // A pointer lies between pixels: on the site, 30 from the top is 60 from the bottom of 90, which
    // is the row above.
    display.point(40, 30);
    display.button(true);
    display.until("the press is seen where it is", |d| {
        d.picture()
            .is_some_and(|rgb| pixel(&rgb, 40, 29) == [255, 255, 255])
    });
    display.button(false);
    display.until("the release is seen", |d| {
        d.picture() == Some(expected(SCENE))
    });

    display.press_key(ESCAPE);
    let (code, log) = display.end();
    assert_eq!(code, Some(0), "{log}");
    assert_eq!(log.matches("reloaded corners in").count(), 2, "{log}");
    assert!(log.contains("`colour` is not declared"), "{log}");
}

/// Shows `iMouse` and whether the key A is toggled, in every pixel.
const TOUCHED: &str = r#"{"ver":"0.1","info":{"id":"touched","name":"touched"},"renderpass":[{"inputs":[
    {"id":"4dXGRr","type":"keyboard","filepath":"/presets/tex00.jpg","channel":0,
     "sampler":{"filter":"nearest","wrap":"clamp","vflip":"true","srgb":"false","internal":"byte"}}],
    "outputs":[{"id":"4dfGRr","channel":0}],"name":"Image","type":"image",
    "code":"void mainImage(out vec4 c, in vec2 p) {\n    float key = texelFetch(iChannel0, ivec2(65, 2), 0).x;\n    c = vec4(iMouse.xy - iMouse.zw + (p.x < 80.0 ? iMouse.xy : vec2(0.0)), 200.0 * key, 255.0) / 255.0;\n}"}]}"#;

#[test]
fn what_is_recorded_is_exported_as_it_was_seen() {
    let Some(_) = gpu() else { return };
    let Some(mut display) = Display::start() else {
        return;
    };
    let folder = Folder::with("touched.json", TOUCHED);
    display.run(&folder, &["touched.json", "--record-input", "input.jsonl"]);
    display.until("the scene is shown", |d| d.title().starts_with("touched"));
    // On the right is xy - zw, on the left twice xy - zw.
    let shows = |d: &Display, left: [u8; 3], right: [u8; 3]| {
        d.picture()
            .is_some_and(|rgb| pixel(&rgb, 9, 9) == left && pixel(&rgb, 99, 9) == right)
    };
    display.point(20, 60);
    display.button(true);
    // w is negative in all frames but one.
    display.until("the press is seen", |d| shows(d, [20, 90, 0], [0, 60, 0]));
    display.point(50, 70);
    display.until("the drag is seen", |d| shows(d, [80, 70, 0], [30, 50, 0]));
    display.button(false);
    display.until("the release is seen", |d| {
        shows(d, [120, 70, 0], [70, 50, 0])
    });
    display.press_key(0x61);
    display.until("the key is seen", |d| {
        shows(d, [120, 70, 200], [70, 50, 200])
    });
    let last = display.picture().expect("a picture");
    display.press_key(ESCAPE);
    let (code, log) = display.end();
    assert_eq!(code, Some(0), "{log}");

    let script = String::from_utf8(folder.read("input.jsonl")).expect("it is text");
    let lines: Vec<Value> = script
        .lines()
        .map(|line| serde_json::from_str(line).expect("a line is JSON"))
        .collect();
    assert_eq!(
        (&lines[0]["width"], &lines[0]["height"]),
        (&WIDTH.into(), &HEIGHT.into())
    );
    assert!(lines.iter().any(|line| line["mouse"] == "move"), "{script}");
    let frame = lines
        .last()
        .and_then(|line| line["frame"].as_u64())
        .expect("a frame");
    let size = format!("--size {WIDTH}x{HEIGHT} --input input.jsonl");
    let export = format!("export touched.json {size} --frames {frame}..{}", frame + 1);
    folder.run(&format!("{export} --out last.png")).exits(0);
    assert!(
        read_png(&folder.path().join("last.png")).rgb == last,
        "{script}"
    );
}

/// A sound device that is a file: stereo, as floats.
#[cfg(feature = "sound")]
const DEVICE: &str = r#"
    pcm.file { type file  file "heard.raw"  format "raw"  slave.pcm { type null } }
    pcm.!default { type plug  slave { pcm "file"  format FLOAT_LE  channels 2 } }
"#;

#[cfg(feature = "sound")]
#[test]
fn sound_and_music_are_heard_together_until_they_are_muted() {
    let Some(_) = gpu() else { return };
    let Some(mut display) = Display::start() else {
        return;
    };
    let folder = Folder::with("asound.conf", DEVICE);
    // Nothing reads the music, which is heard all the same.
    folder.write(
        "s/image.glsl",
        "void mainImage(out vec4 c, vec2 p) { c = vec4(1.0); }",
    );
    folder.write(
        "s/sound.glsl",
        "vec2 mainSound(int n, float t) { return vec2(0.25, -0.5); }",
    );
    folder.write(
        "s/scene.toml",
        "[image]\niChannel0 = { music = \"music.wav\" }\n[sound]",
    );
    let spec = hound::WavSpec {
        channels: 2,
        sample_rate: 44_100,
        bits_per_sample: 32,
        sample_format: hound::SampleFormat::Float,
    };
    let mut music = hound::WavWriter::create(folder.path().join("s/music.wav"), spec).unwrap();
    for sample in [0.125_f32, 0.25].into_iter().cycle().take(1000) {
        music.write_sample(sample).unwrap();
    }
    music.finalize().unwrap();
    let heard = || {
        let bytes = std::fs::read(folder.path().join("heard.raw")).unwrap_or_default();
        let last = bytes.chunks_exact(8).last();
        last.map(|frame| {
            [0, 4].map(|at| f32::from_le_bytes(frame[at..at + 4].try_into().expect("four bytes")))
        })
    };

    display.run(&folder, &["s"]);
    display.until("both are heard", |_| heard() == Some([0.375, -0.25]));
    display.press_key(0x6d);
    display.until("nothing is heard", |_| heard() == Some([0.0, 0.0]));
    display.press_key(ESCAPE);
    let (code, log) = display.end();
    assert_eq!(code, Some(0), "{log}");
    assert!(log.contains("sound is off"), "{log}");
}

fn pixel(rgb: &[u8], x: u32, y: u32) -> &[u8] {
    let at = 3 * (y * WIDTH + x) as usize;
    &rgb[at..at + 3]
}

/// A display in memory, and the program that runs on it.
struct Display {
    server: Child,
    name: String,
    x11: RustConnection,
    root: Window,
    program: Option<Child>,
}

impl Display {
    /// Starts Xvfb; `None` where there is none, which `REQUIRE_GPU=1` forbids as well.
    fn start() -> Option<Self> {
        let server = Command::new("Xvfb")
            .args(["-displayfd", "1", "-screen", "0", "640x480x24"])
            .args(["-nolisten", "tcp"])
            .stdout(Stdio::piped())
            .stderr(Stdio::null())
            .spawn();
        let mut server = match server {
            Ok(server) => server,
            Err(error) if std::env::var("REQUIRE_GPU").is_ok_and(|value| value == "1") => {
                panic!("REQUIRE_GPU is set, but Xvfb does not start: {error}")
            }
            Err(error) => {
                eprintln!("the window is not tested: Xvfb does not start: {error}");
                return None;
            }
        };
        let mut number = String::new();
        let stdout = server.stdout.take().expect("it is piped");
        BufReader::new(stdout)
            .read_line(&mut number)
            .expect("a display number");
        let name = format!(":{}", number.trim());
        let (x11, screen) = x11rb::connect(Some(&name)).expect("the display answers");
        let root = x11.setup().roots[screen].root;
        Some(Display {
            server,
            name,
            x11,
            root,
            program: None,
        })
    }

    fn run(&mut self, folder: &Folder, arguments: &[&str]) {
        let program = Command::new(env!("CARGO_BIN_EXE_vitrine"))
            .args(["run", "--size", &format!("{WIDTH}x{HEIGHT}")])
            .args(arguments)
            .current_dir(folder.path())
            .env("DISPLAY", &self.name)
            .env("ALSA_CONFIG_PATH", folder.path().join("asound.conf"))
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .env("NO_COLOR", "1")
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        self.program = Some(program);
    }

    /// The program's window: the one on this display that has pixels of its own size.
    fn window(&self) -> Option<Window> {
        let tree = self.x11.query_tree(self.root).ok()?.reply().ok()?;
        tree.children.into_iter().find(|&window| {
            let geometry = self
                .x11
                .get_geometry(window)
                .ok()
                .and_then(|g| g.reply().ok());
            geometry.is_some_and(|g| (u32::from(g.width), u32::from(g.height)) == (WIDTH, HEIGHT))
        })
    }

    /// What the window shows, as red, green and blue from the top left.
    fn picture(&self) -> Option<Vec<u8>> {
        let window = self.window()?;
        let (width, height) = (WIDTH as u16, HEIGHT as u16);
        let format = ImageFormat::Z_PIXMAP;
        let image = self.x11.get_image(format, window, 0, 0, width, height, !0);
        let data = image.ok()?.reply().ok()?.data;
        Some(data.chunks(4).flat_map(|p| [p[2], p[1], p[0]]).collect())
    }

    fn title(&self) -> String {
        let title = || {
            let name = self
                .x11
                .intern_atom(false, b"_NET_WM_NAME")
                .ok()?
                .reply()
                .ok()?;
            let (window, any) = (self.window()?, AtomEnum::ANY);
            let property = self
                .x11
                .get_property(false, window, name.atom, any, 0, 1024);
            String::from_utf8(property.ok()?.reply().ok()?.value).ok()
        };
        title().unwrap_or_default()
    }

    /// Waits for something to become true.
    fn until(&mut self, what: &str, is_true: impl Fn(&Display) -> bool) {
        let start = Instant::now();
        while !is_true(self) {
            let program = self.program.as_mut().expect("it was started");
            let gone = program.try_wait().expect("its state").is_some();
            if gone || start.elapsed() > PATIENCE {
                let title = self.title();
                let (code, log) = self.end();
                panic!("{what}: not so. The title was {title:?}, the exit code {code:?}:\n{log}");
            }
            std::thread::sleep(Duration::from_millis(20));
        }
    }

    fn fake(&self, kind: u8, detail: u8, x: i16, y: i16) {
        let sent = self
            .x11
            .xtest_fake_input(kind, detail, 0, self.root, x, y, 0);
        sent.expect("the display takes it")
            .check()
            .expect("it is valid");
    }

    /// Moves the pointer to a pixel of the window.
    fn point(&self, x: i16, y: i16) {
        let window = self.window().expect("the window");
        let cookie = self.x11.translate_coordinates(window, self.root, x, y);
        let place = cookie
            .expect("it is sent")
            .reply()
            .expect("the window's place");
        self.fake(MOTION, 0, place.dst_x, place.dst_y);
    }

    fn button(&self, down: bool) {
        let kind = if down { BUTTON_PRESS } else { BUTTON_RELEASE };
        self.fake(kind, 1, 0, 0);
    }

    fn press_key(&self, symbol: u32) {
        let window = self.window().expect("the window");
        let focus = self
            .x11
            .set_input_focus(InputFocus::PARENT, window, x11rb::CURRENT_TIME);
        focus
            .expect("it is sent")
            .check()
            .expect("the window takes it");
        let setup = self.x11.setup();
        let (low, high) = (setup.min_keycode, setup.max_keycode);
        let cookie = self.x11.get_keyboard_mapping(low, high - low + 1);
        let map = cookie.expect("it is sent").reply().expect("the keyboard");
        let index = map
            .keysyms
            .iter()
            .position(|&s| s == symbol)
            .expect("the key exists");
        let code = low + (index / usize::from(map.keysyms_per_keycode)) as u8;
        self.fake(KEY_PRESS, code, 0, 0);
        self.fake(KEY_RELEASE, code, 0, 0);
    }

    /// Waits a little for the program to end, ends it if it does not, and returns its exit code and
    /// what it wrote.
    fn end(&mut self) -> (Option<i32>, String) {
        let mut program = self.program.take().expect("it was started");
        let start = Instant::now();
        let code = loop {
            match program.try_wait().expect("its state") {
                Some(status) => break status.code(),
                None if start.elapsed() > Duration::from_secs(10) => {
                    program.kill().expect("it can be ended");
                    break None;
                }
                None => std::thread::sleep(Duration::from_millis(20)),
            }
        };
        let mut log = String::new();
        let mut stderr = program.stderr.take().expect("it is piped");
        stderr.read_to_string(&mut log).expect("UTF-8");
        (code, log)
    }
}

impl Drop for Display {
    fn drop(&mut self) {
        if let Some(mut program) = self.program.take() {
            let _ = program.kill();
            let _ = program.wait();
        }
        let _ = self.server.kill();
        let _ = self.server.wait();
    }
}
