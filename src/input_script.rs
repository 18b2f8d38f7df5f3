//! Input scripts as files: a line of JSON for each thing that happened, behind a line that says in what picture.
//!
//! ```text
//! {"version":1,"width":960,"height":540,"fps":60}
//! {"frame":12,"time":0.2,"mouse":"press","x":100,"y":50}
//! {"frame":14,"time":0.233,"mouse":"move","x":104,"y":52}
//! {"frame":20,"time":0.333,"mouse":"release"}
//! {"frame":20,"time":0.333,"key":65,"down":true}
//! ```

use std::fs::{self, File, OpenOptions};
use std::io::{self, Read as _, Seek as _, SeekFrom, Write as _};
use std::path::{Path, PathBuf};

use glam::{IVec2, UVec2};
use serde::{Deserialize, Serialize};

use crate::frame::{Action, Event, FrameInput, Script, rescaled};

/// The most bytes that a script has: some hours of dragging.
pub const MAX_BYTES: u64 = 64 << 20;

/// The form of the lines that this program writes and reads.
const VERSION: u32 = 1;

/// The first line is written again when more is known, so it has room: this many bytes with its line break.
const HEADER_BYTES: usize = 80;

/// The rates that a clock takes.
const RATES: std::ops::RangeInclusive<f64> = 1e-6..=1e6;

/// Why there is no script.
#[derive(Debug, thiserror::Error)]
pub enum ScriptError {
    /// The file could not be read.
    #[error("cannot read `{}`: {error}", path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What the system said.
        error: io::Error,
    },
    /// Something in it is wrong.
    #[error("`{}`, line {line}: {message}", path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// Counted from 1.
        line: usize,
        /// What is wrong.
        message: String,
    },
    /// It is larger than [`MAX_BYTES`].
    #[error("`{}` is larger than {} MiB", .0.display(), MAX_BYTES >> 20)]
    TooLarge(PathBuf),
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Header {
    version: u32,
    width: u32,
    height: u32,
    fps: f64,
}

#[derive(Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
struct Line {
    frame: u32,
    /// `iTime` of the frame. It is for people: the frame's number alone counts.
    #[serde(skip_serializing_if = "Option::is_none")]
    time: Option<f64>,
    #[serde(skip_serializing_if = "Option::is_none")]
    mouse: Option<Button>,
    #[serde(skip_serializing_if = "Option::is_none")]
    x: Option<i32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    y: Option<i32>,
    #[serde(skip_serializing_if = "Option::is_none")]
    key: Option<u8>,
    #[serde(skip_serializing_if = "Option::is_none")]
    down: Option<bool>,
}

#[derive(Clone, Copy, Serialize, Deserialize)]
#[serde(rename_all = "kebab-case")]
enum Button {
    Press,
    Move,
    Release,
}

impl Line {
    fn new(event: Event, time: f32) -> Self {
        let mut line = Line {
            frame: event.frame,
            time: Some((f64::from(time) * 1000.0).round() / 1000.0),
            mouse: None,
            x: None,
            y: None,
            key: None,
            down: None,
        };
        let mut mouse = |button, at: Option<IVec2>| {
            line.mouse = Some(button);
            (line.x, line.y) = (at.map(|at| at.x), at.map(|at| at.y));
        };
        match event.action {
            Action::Press(at) => mouse(Button::Press, Some(at)),
            Action::Move(to) => mouse(Button::Move, Some(to)),
            Action::Release => mouse(Button::Release, None),
            Action::KeyDown(key) => (line.key, line.down) = (Some(key), Some(true)),
            Action::KeyUp(key) => (line.key, line.down) = (Some(key), Some(false)),
        }
        line
    }

    fn event(&self) -> Result<Event, &'static str> {
        let at = || match (self.x, self.y) {
            (Some(x), Some(y)) => Ok(IVec2::new(x, y)),
            _ => Err("the mouse's place is missing: `x` and `y`, in pixels from the bottom left"),
        };
        let action = match (self.mouse, self.key, self.down) {
            (Some(_), Some(_), _) => return Err("a line is of the mouse or of a key, not of both"),
            (Some(Button::Press), None, None) => Action::Press(at()?),
            (Some(Button::Move), None, None) => Action::Move(at()?),
            // Where the button is released changes nothing.
            (Some(Button::Release), None, None) => Action::Release,
            (Some(_), None, Some(_)) => return Err("`down` is of keys, not of the mouse"),
            (None, Some(_), _) if self.x.is_some() || self.y.is_some() => {
                return Err("`x` and `y` are of the mouse, not of keys");
            }
            (None, Some(key), Some(true)) => Action::KeyDown(key),
            (None, Some(key), Some(false)) => Action::KeyUp(key),
            (None, Some(_), None) => return Err("`down` is missing: true or false"),
            (None, None, _) => return Err("nothing happens: `mouse` or `key` is missing"),
        };
        Ok(Event {
            frame: self.frame,
            action,
        })
    }
}

/// Reads a script.
pub fn read(path: &Path) -> Result<Script, ScriptError> {
    let io = |error| ScriptError::Io {
        path: path.to_owned(),
        error,
    };
    let mut bytes = Vec::new();
    let file = File::open(path).map_err(io)?;
    let mut start = file.take(MAX_BYTES + 1);
    start.read_to_end(&mut bytes).map_err(io)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(ScriptError::TooLarge(path.to_owned()));
    }
    parse(&bytes).map_err(|(line, message)| ScriptError::Line {
        path: path.to_owned(),
        line,
        message,
    })
}

/// Reads a script's text; what is wrong comes with the number of its line.
fn parse(bytes: &[u8]) -> Result<Script, (usize, String)> {
    let lines = bytes.split(|&byte| byte == b'\n').map(<[u8]>::trim_ascii);
    let mut lines = (1..).zip(lines).filter(|(_, line)| !line.is_empty());
    let Some((number, first)) = lines.next() else {
        return Err((1, "the script is empty".to_owned()));
    };
    let header = serde_json::from_slice::<Header>(first).map_err(|error| {
        let what = "the first line says in what picture it was made";
        (number, format!("{}; {what}", words(&error)))
    })?;
    if header.version != VERSION {
        let message = format!(
            "this is version {} of scripts, and this program knows {VERSION}",
            header.version
        );
        return Err((number, message));
    }
    let size = UVec2::new(header.width, header.height);
    if size.min_element() == 0 {
        return Err((
            number,
            "a picture has at least one pixel each way".to_owned(),
        ));
    }
    if !RATES.contains(&header.fps) {
        let message = "`fps` must lie between 0.000001 and 1000000";
        return Err((number, message.to_owned()));
    }
    let mut events: Vec<Event> = Vec::new();
    for (number, text) in lines {
        let line = serde_json::from_slice::<Line>(text);
        let line = line.map_err(|error| (number, words(&error)))?;
        let event = line.event().map_err(|words| (number, words.to_owned()))?;
        if let Some(last) = events.last()
            && event.frame < last.frame
        {
            let message = format!("frame {} comes behind frame {}", event.frame, last.frame);
            return Err((number, message));
        }
        events.push(event);
    }
    Ok(Script {
        size,
        fps: header.fps,
        events,
    })
}

/// What the parser says, with the place in a line that is the only one it knows.
fn words(error: &serde_json::Error) -> String {
    let words = error.to_string();
    let words = words.split(" at line ").next().unwrap_or_default();
    format!("{words}, at column {}", error.column())
}

/// Writes a script while its input happens. Every line is in the file as soon as its frame is drawn, so that what
/// was recorded outlives the program.
#[derive(Debug)]
pub struct Recorder {
    file: File,
    size: UVec2,
    fps: f64,
    /// What the next frame will see.
    pending: Vec<Action>,
    /// The latest frame's number and time.
    latest: Option<(i32, f32)>,
}

impl Recorder {
    /// Creates the file, of pictures of this size and about so many frames a second. A file that is there already
    /// is replaced only with `overwrite`.
    pub fn create(path: &Path, size: UVec2, fps: f64, overwrite: bool) -> io::Result<Self> {
        if let Some(folder) = path.parent() {
            fs::create_dir_all(folder)?;
        }
        let mut options = OpenOptions::new();
        match overwrite {
            true => options.create(true).truncate(true),
            false => options.create_new(true),
        };
        let mut recorder = Recorder {
            file: options.write(true).open(path)?,
            size,
            fps,
            pending: Vec::new(),
            latest: None,
        };
        recorder.write_header(fps)?;
        Ok(recorder)
    }

    /// Something happened, in a picture of this size.
    pub fn note(&mut self, action: Action, size: UVec2) {
        let here = |at| rescaled(at, size, self.size);
        let action = match action {
            Action::Press(at) => Action::Press(here(at)),
            Action::Move(to) => Action::Move(here(to)),
            other => other,
        };
        // Of a way between two frames, they see only where it ends.
        if matches!(action, Action::Move(_))
            && let Some(latest @ Action::Move(_)) = self.pending.last_mut()
        {
            *latest = action;
        } else {
            self.pending.push(action);
        }
    }

    /// A frame sees what happened since the one before.
    pub fn frame_drawn(&mut self, input: &FrameInput) -> io::Result<()> {
        self.latest = Some((input.frame, input.time));
        let mut text = Vec::new();
        for action in self.pending.drain(..) {
            let event = Event {
                frame: input.frame.max(0) as u32,
                action,
            };
            serde_json::to_writer(&mut text, &Line::new(event, input.time))?;
            text.push(b'\n');
        }
        self.file.write_all(&text)
    }

    /// Time begins again, and with it the script.
    pub fn restart(&mut self) -> io::Result<()> {
        self.pending.clear();
        self.latest = None;
        self.file.set_len(0)?;
        self.write_header(self.fps)
    }

    /// The recording ends: the first line tells how many frames a second there really were.
    pub fn finish(mut self) -> io::Result<()> {
        match self.latest {
            Some((frame, time)) if frame > 0 && time > 0.0 => {
                let rate = f64::from(frame) / f64::from(time);
                self.write_header((rate * 1000.0).round().clamp(1.0, 1e9) / 1000.0)
            }
            _ => Ok(()),
        }
    }

    /// Writes the first line, padded to its room, and stands behind it.
    fn write_header(&mut self, fps: f64) -> io::Result<()> {
        let header = Header {
            version: VERSION,
            width: self.size.x,
            height: self.size.y,
            fps,
        };
        let text = serde_json::to_string(&header)?;
        self.file.seek(SeekFrom::Start(0))?;
        let room = HEADER_BYTES - 1;
        writeln!(self.file, "{text:<room$}")
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::frame::Clock;

    const HEADER: &str = "{\"version\":1,\"width\":100,\"height\":50,\"fps\":60}\n";

    #[test]
    fn what_is_recorded_is_read_again() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("new").join("a.jsonl");
        let size = UVec2::new(100, 50);
        let mut recorder = Recorder::create(&path, size, 60.0, false).unwrap();
        let clock = Clock::fixed(25.0);
        let at = |x, y| IVec2::new(x, y);
        recorder.note(Action::KeyDown(9), size);
        recorder.frame_drawn(&clock.at(7, size)).unwrap();
        recorder.restart().unwrap();
        recorder.frame_drawn(&clock.at(0, size)).unwrap();
        recorder.note(Action::Press(at(10, 20)), size);
        recorder.note(Action::Move(at(11, 21)), size);
        recorder.note(Action::Move(at(12, 22)), size);
        recorder.frame_drawn(&clock.at(1, size)).unwrap();
        // The window is twice as large now.
        recorder.note(Action::Move(at(-3, 60)), size * 2);
        recorder.note(Action::Release, size * 2);
        recorder.note(Action::KeyDown(65), size);
        recorder.note(Action::KeyUp(65), size);
        recorder.frame_drawn(&clock.at(5, size)).unwrap();
        let expected = [
            (1, Action::Press(at(10, 20))),
            (1, Action::Move(at(12, 22))),
            (5, Action::Move(at(-2, 30))),
            (5, Action::Release),
            (5, Action::KeyDown(65)),
            (5, Action::KeyUp(65)),
        ];
        let expected = expected.map(|(frame, action)| Event { frame, action });
        let script = read(&path).expect("nothing has to be finished first");
        assert_eq!((script.size, script.fps), (size, 60.0));
        assert_eq!(script.events, expected);
        recorder.finish().unwrap();
        let script = read(&path).unwrap();
        assert_eq!(
            (script.fps, script.events.as_slice()),
            (25.0, &expected[..])
        );

        let again = Recorder::create(&path, size, 60.0, false);
        assert_eq!(again.unwrap_err().kind(), io::ErrorKind::AlreadyExists);
        Recorder::create(&path, size, 60.0, true).unwrap();
        assert_eq!(read(&path).unwrap().events, []);
    }

    #[test]
    fn mistakes_are_told_with_their_line() {
        for (text, line, what) in [
            ("", 1, "empty"),
            ("\n \n", 1, "empty"),
            ("{}", 1, "missing field `version`"),
            ("\nnonsense", 2, "first line says"),
            (
                r#"{"version":2,"width":1,"height":1,"fps":60}"#,
                1,
                "version 2",
            ),
            (
                r#"{"version":1,"width":0,"height":1,"fps":60}"#,
                1,
                "one pixel",
            ),
            (r#"{"version":1,"width":1,"height":1,"fps":0}"#, 1, "`fps`"),
        ] {
            let (at, message) = parse(text.as_bytes()).unwrap_err();
            assert!(
                at == line && message.contains(what),
                "{text}: {at} {message}"
            );
        }
        for (text, what) in [
            ("{", "EOF while parsing an object, at column 1"),
            ("[]", "invalid"),
            (r#"{"frame":-1,"key":65,"down":true}"#, "expected u32"),
            (r#"{"frame":1}"#, "nothing happens"),
            (r#"{"frame":1,"mouse":"hover"}"#, "unknown variant `hover`"),
            (r#"{"frame":1,"mouse":"press","x":1}"#, "place is missing"),
            (
                r#"{"frame":1,"mouse":"release","down":true}"#,
                "`down` is of keys",
            ),
            (r#"{"frame":1,"mouse":"release","key":5}"#, "not of both"),
            (r#"{"frame":1,"key":256,"down":true}"#, "expected u8"),
            (r#"{"frame":1,"key":65}"#, "`down` is missing"),
            (r#"{"frame":1,"key":65,"down":true,"x":1}"#, "of the mouse"),
            (
                r#"{"frame":1,"key":65,"down":true,"z":1}"#,
                "unknown field `z`",
            ),
            ("{\"frame\":1,\"key\":65,\"down\":\"\u{7}", "parsing"),
        ] {
            let (at, message) = parse(format!("{HEADER}{text}").as_bytes()).unwrap_err();
            assert!(at == 2 && message.contains(what), "{text}: {at} {message}");
        }
        let key = |frame| format!("{{\"frame\":{frame},\"key\":65,\"down\":true}}\n");
        let text = [HEADER, &key(5), "\n", &key(4)].concat();
        let (at, message) = parse(text.as_bytes()).unwrap_err();
        assert_eq!((at, message.as_str()), (4, "frame 4 comes behind frame 5"));
        assert!(parse(b"\xff\xfe").is_err());
    }
}
