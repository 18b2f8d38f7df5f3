//! What a film is, asked of ffprobe, and how ffmpeg's programs are started.

use std::ffi::OsString;
use std::fs::File;
use std::io::{self, Read as _};
use std::path::Path;
use std::process::{Child, Command, Stdio};
use std::sync::mpsc;
use std::thread;
use std::time::Duration;

use super::super::MediaError;

/// The most texels that a side of a film may have.
pub(super) const LIMIT: u32 = 4096;
/// Pictures a second beyond which a rate is a mistake, or only the unit of a film's times.
const FASTEST: f64 = 120.0;
/// How long ffprobe may take.
const PATIENCE: Duration = Duration::from_secs(15);

/// What must be known of a film to read it.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Facts {
    /// Width and height in texels, as it is shown.
    pub size: [u32; 2],
    /// Pictures a second, as a fraction.
    pub rate: [u32; 2],
    /// How long it lasts, in seconds.
    pub seconds: f64,
    /// ffmpeg's name of its format.
    pub demuxer: &'static str,
}

impl Facts {
    /// Pictures a second.
    pub(super) fn rate(&self) -> f64 {
        f64::from(self.rate[0]) / f64::from(self.rate[1])
    }
}

/// Asks ffprobe.
pub(super) fn probe(path: &Path) -> Result<Facts, MediaError> {
    let demuxer = demuxer(path)?;
    let entries = "stream=width,height,r_frame_rate,avg_frame_rate,duration:stream_side_data=rotation:format=duration";
    let ask = |more: &[&str], entries: &str| {
        let mut command = guarded("ffprobe", path, demuxer);
        command.args(["-select_streams", "V:0"]).args(more);
        command.args([
            "-of",
            "default=noprint_wrappers=1",
            "-show_entries",
            entries,
        ]);
        answer(command, path)
    };
    let text = ask(&[], entries)?;
    let mut facts = facts(&text, demuxer, path)?;
    if facts.seconds <= 0.0 {
        // Films that were recorded live do not say how long they are, so their pictures are counted.
        let text = ask(&["-count_packets"], "stream=nb_read_packets")?;
        let count = value(&text, "nb_read_packets").and_then(|count| count.parse::<f64>().ok());
        facts.seconds = count.unwrap_or(0.0) / facts.rate();
    }
    if !(facts.seconds > 0.0 && facts.seconds < 1e7) {
        return Err(not_a(path, "it does not say how long it lasts"));
    }
    Ok(facts)
}

/// Reads ffprobe's answer. The length is 0 if it is not there.
fn facts(text: &str, demuxer: &'static str, path: &Path) -> Result<Facts, MediaError> {
    let number = |key| value(text, key).and_then(|value| value.parse::<f64>().ok());
    let (Some(width), Some(height)) = (number("width"), number("height")) else {
        return Err(not_a(path, "it has no moving picture"));
    };
    let (width, height) = (width as u32, height as u32);
    if width == 0 || height == 0 {
        return Err(not_a(path, "its pictures are empty"));
    }
    if width > LIMIT || height > LIMIT {
        return Err(MediaError::TooLarge {
            path: path.to_owned(),
            size: [width, height, 1],
            limit: LIMIT,
        });
    }
    // Telephones write how they were held.
    let is_turned = number("rotation").is_some_and(|degrees| (degrees / 90.0).round() % 2.0 != 0.0);
    let rate = |key| {
        let (over, under) = value(text, key)?.split_once('/')?;
        let rate = [over.parse::<u32>().ok()?, under.parse::<u32>().ok()?];
        let per_second = f64::from(rate[0]) / f64::from(rate[1]);
        (0.1..=FASTEST).contains(&per_second).then_some(rate)
    };
    // Both the film's and its pictures' length are called so; the longest counts, as in browsers.
    let lengths = text
        .lines()
        .filter_map(|line| line.strip_prefix("duration="));
    let seconds = lengths.filter_map(|length| length.parse().ok());
    Ok(Facts {
        size: if is_turned {
            [height, width]
        } else {
            [width, height]
        },
        rate: rate("r_frame_rate")
            .or_else(|| rate("avg_frame_rate"))
            .unwrap_or([60, 1]),
        seconds: seconds.fold(0.0, f64::max),
        demuxer,
    })
}

/// The value in a line `key=value`.
fn value<'a>(text: &'a str, key: &str) -> Option<&'a str> {
    let mut lines = text.lines();
    lines
        .find_map(|line| line.strip_prefix(key)?.strip_prefix('='))
        .map(str::trim)
}

/// Which of ffmpeg's readers the file is given to, by its first bytes. Left to itself, ffmpeg would also read formats that
/// name other files and addresses to open (playlists, scripts, descriptions of sessions); none of those is here.
fn demuxer(path: &Path) -> Result<&'static str, MediaError> {
    let io = |error| MediaError::Io {
        path: path.to_owned(),
        error,
    };
    let file = File::open(path).map_err(io)?;
    // Reading from a pipe or a device might never end.
    if !file.metadata().map_err(io)?.is_file() {
        return Err(not_a(path, "it is no regular file"));
    }
    let mut head = Vec::new();
    file.take(192).read_to_end(&mut head).map_err(io)?;
    by_head(&head).ok_or_else(|| not_a(path, "its format is unknown"))
}

fn by_head(head: &[u8]) -> Option<&'static str> {
    let is_at = |at: usize, word: &[u8]| head.get(at..at + word.len()) == Some(word);
    let boxes: [&[u8]; 5] = [b"ftyp", b"moov", b"mdat", b"wide", b"free"];
    Some(match () {
        () if is_at(0, b"\x1a\x45\xdf\xa3") => "matroska",
        () if boxes.iter().any(|word| is_at(4, word)) => "mov",
        () if is_at(0, b"OggS") => "ogg",
        () if is_at(0, b"RIFF") && is_at(8, b"AVI ") => "avi",
        () if is_at(0, b"GIF8") => "gif",
        () if is_at(0, b"FLV") => "flv",
        () if is_at(0, b"\0\0\x01\xba") => "mpeg",
        () if is_at(0, b"\x47") && is_at(188, b"\x47") => "mpegts",
        () if is_at(0, b"YUV4MPEG2 ") => "yuv4mpegpipe",
        () => return None,
    })
}

/// `program` with its input: that file and no other, whatever its name and its content say.
pub(super) fn guarded(program: &str, path: &Path, demuxer: &str) -> Command {
    let mut command = Command::new(program);
    command.args(["-hide_banner", "-v", "error"]);
    command.args(["-protocol_whitelist", "file,pipe", "-f", demuxer]);
    if program == "ffprobe" {
        command.arg("-i").arg(address(path));
    }
    command
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped());
    command
}

/// A path as ffmpeg cannot misunderstand it: with `file:` in front, a colon or a hyphen in it means nothing.
pub(super) fn address(path: &Path) -> OsString {
    let mut address = OsString::from("file:");
    address.push(path);
    address
}

/// Starts a program of ffmpeg's.
pub(super) fn start(mut command: Command, path: &Path) -> Result<Child, MediaError> {
    command.spawn().map_err(|error| match error.kind() {
        io::ErrorKind::NotFound => MediaError::NoFfmpeg,
        _ => MediaError::Io {
            path: path.to_owned(),
            error,
        },
    })
}

/// What a program prints, which must end before long.
fn answer(command: Command, path: &Path) -> Result<String, MediaError> {
    let mut child = start(command, path)?;
    let (sender, receiver) = mpsc::channel();
    let (stdout, stderr) = (child.stdout.take(), child.stderr.take());
    thread::spawn(move || {
        let printed = all(stdout);
        let _ = sender.send(printed);
    });
    let complaint = thread::spawn(move || all(stderr));
    let printed = receiver.recv_timeout(PATIENCE);
    // A child that has ended does not mind.
    let _ = child.kill();
    let _ = child.wait();
    match printed {
        Ok(printed) if !printed.trim().is_empty() => Ok(printed),
        Ok(_) => {
            let complaint = complaint.join().unwrap_or_default();
            Err(not_a(
                path,
                last_line(&complaint).unwrap_or("it has no moving picture"),
            ))
        }
        Err(_) => Err(not_a(path, "ffprobe gave no answer within 15 seconds")),
    }
}

/// What comes out of a pipe, but not without end.
pub(super) fn all(pipe: Option<impl io::Read>) -> String {
    let mut bytes = Vec::new();
    if let Some(mut pipe) = pipe {
        let _ = pipe.by_ref().take(1 << 16).read_to_end(&mut bytes);
        // The child would stand still if nobody read on.
        let _ = io::copy(&mut pipe, &mut io::sink());
    }
    String::from_utf8_lossy(&bytes).into_owned()
}

/// The last line with words: the one that says what all came to.
pub(super) fn last_line(text: &str) -> Option<&str> {
    let line = text
        .lines()
        .rev()
        .map(str::trim)
        .find(|line| !line.is_empty())?;
    // ffmpeg puts the address in front, which the message has already.
    Some(match line.starts_with("file:") {
        true => line.rsplit(": ").next().unwrap_or(line),
        false => line,
    })
}

/// That the file is no film, and why.
pub(super) fn not_a(path: &Path, words: &str) -> MediaError {
    MediaError::NotA {
        path: path.to_owned(),
        what: "film",
        words: words.to_owned(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn read(text: &str) -> Result<Facts, MediaError> {
        facts(text, "mov", Path::new("a.mp4"))
    }

    #[test]
    fn answers_are_read() {
        let text = "width=512\nheight=396\nr_frame_rate=25/1\navg_frame_rate=25/1\nduration=N/A\nduration=2.5\n";
        let facts = read(text).unwrap();
        assert_eq!(
            (facts.size, facts.rate, facts.seconds),
            ([512, 396], [25, 1], 2.5)
        );
        let turned = read(&format!("{text}rotation=-90\n")).unwrap();
        assert_eq!(turned.size, [396, 512]);
        let text = "width=8\nheight=8\nr_frame_rate=1000/1\navg_frame_rate=0/0\n";
        let facts = read(text).unwrap();
        assert_eq!((facts.rate, facts.seconds), ([60, 1], 0.0));
    }

    #[test]
    fn what_cannot_be_shown_is_refused() {
        let error = read("width=9000\nheight=16\n").unwrap_err();
        assert!(matches!(error, MediaError::TooLarge { limit: LIMIT, .. }));
        assert!(read("duration=2\n").is_err());
        assert!(read("width=0\nheight=1\n").is_err());
    }

    #[test]
    fn formats_that_name_other_files_are_unknown() {
        for text in [
            "#EXTM3U\nhttp://a/b.ts\n",
            "ffconcat version 1.0\nfile /etc/passwd\n",
            "v=0\no=- 0 0 IN IP4 127.0.0.1\n",
            "<?xml version=\"1.0\"?><MPD>",
            "",
        ] {
            assert_eq!(by_head(text.as_bytes()), None, "{text}");
        }
        assert_eq!(by_head(b"\0\0\0\x20ftypisom"), Some("mov"));
    }
}
