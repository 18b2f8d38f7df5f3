//! What a user binds to a channel in the place of what the scene says.

use std::path::{Path, PathBuf};
use std::str::FromStr;

use super::file_kind::{FACES, face_of};
use super::site::{Item, Kind};
use super::{BufferLetter, CHANNELS, Channel, FileKind, Input, Media, PassKind, Sampling, Scene};
use crate::source::{Diagnostic, Report};

/// A channel of a pass, and what it shall read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Binding {
    /// The pass.
    pub pass: PassKind,
    /// The channel's number, less than [`CHANNELS`].
    pub channel: usize,
    /// A file, the name of one of the site's media, `keyboard`, `mic`, `webcam` or `noise`.
    pub what: String,
}

impl FromStr for Binding {
    type Err = String;

    /// Reads `0=clip.mp4`, for the Image pass, or `A.0=clip.mp4`.
    fn from_str(text: &str) -> Result<Self, String> {
        let form = "write it as N=FILE or PASS.N=FILE, as in 0=clip.mp4 or A.1=sky.png";
        let (place, what) = text.split_once('=').ok_or(form)?;
        let (pass, channel) = match place.rsplit_once('.') {
            Some((pass, channel)) => (pass_of(pass.trim())?, channel),
            None => (PassKind::Image, place),
        };
        let channel = channel.trim().trim_start_matches("iChannel");
        let Some(channel) = (0..CHANNELS).find(|number| number.to_string() == channel) else {
            return Err(format!(
                "there is no channel `{channel}`, only 0 to 3; {form}"
            ));
        };
        match what.trim() {
            "" => Err(form.to_owned()),
            what => Ok(Binding {
                pass,
                channel,
                what: what.to_owned(),
            }),
        }
    }
}

/// The pass that a person means.
fn pass_of(text: &str) -> Result<PassKind, String> {
    let word: String = text.chars().filter(char::is_ascii_alphanumeric).collect();
    let word = word.to_ascii_lowercase();
    let letter = BufferLetter::ALL.into_iter().find(|letter| {
        let name = letter.pass_name().replace(' ', "").to_ascii_lowercase();
        word == name || Some(&*word) == name.strip_prefix("buffer")
    });
    match (letter, &*word) {
        (Some(letter), _) => Ok(PassKind::Buffer(letter)),
        (None, "image") => Ok(PassKind::Image),
        (None, "cube" | "cubea") => Ok(PassKind::Cube),
        (None, "sound") => Ok(PassKind::Sound),
        _ => Err(format!(
            "there is no pass `{text}`: it is Image, A, B, C, D, Cube or Sound"
        )),
    }
}

impl Scene {
    /// Binds channels to something else than what the scene says. Files count from the working folder.
    pub fn bind(&mut self, bindings: &[Binding]) -> Result<(), Report> {
        bindings.iter().try_for_each(|binding| {
            self.bind_one(binding).map_err(|problem| Report {
                files: self.files.clone(),
                diagnostics: vec![problem],
            })
        })
    }

    fn bind_one(&mut self, binding: &Binding) -> Result<(), Diagnostic> {
        let error = |message: String| Diagnostic::error("binding", message);
        let mut passes = self.passes.iter_mut();
        let Some(pass) = passes.find(|pass| pass.kind == binding.pass) else {
            let has = self.passes.iter().map(|pass| pass.kind.name());
            let has: Vec<_> = has.collect();
            let message = format!("the scene has no {}", binding.pass.name());
            let hint = format!("it has: {}", has.join(", "));
            return Err(error(message).hint(hint));
        };
        let channel = &mut pass.channels[binding.channel];
        let old = channel.take();
        let input = input(&binding.what, old.as_ref().map(|old| &old.input)).map_err(|hint| {
            let message = format!("`{}` is nothing that a channel can read", binding.what);
            error(message).hint(hint)
        })?;
        if let Some(Media::Files(files)) = input.media() {
            self.read.extend(files.iter().cloned());
        }
        let sampling = match old {
            Some(old) if old.input.name() == input.name() => old.sampling,
            _ => Sampling::usual(&input),
        };
        *channel = Some(Channel { input, sampling });
        Ok(())
    }
}

/// What a person means, where `old` was bound. A file wins over what is called like it.
fn input(what: &str, old: Option<&Input>) -> Result<Input, String> {
    let path = Path::new(what);
    if !path.is_file() {
        match what {
            "keyboard" => return Ok(Input::Keyboard),
            "mic" => return Ok(Input::Mic),
            "webcam" => return Ok(Input::Webcam),
            "noise" => return Ok(Input::Noise),
            _ => {}
        }
        if let Some(item) = Item::named(what) {
            let kind = match item.kind {
                Kind::Texture { .. } => FileKind::Texture,
                Kind::Cubemap { .. } => FileKind::Cubemap,
                Kind::Volume { .. } => FileKind::Volume,
                Kind::Video => FileKind::Video,
                Kind::Music => FileKind::Music,
            };
            return Ok(kind.input(item.media()));
        }
    }
    let endings = || {
        let endings: Vec<_> = FileKind::endings().collect();
        format!(
            "name a file that ends in one of {}; one of the site's media, as in `0=London`; or keyboard, mic, webcam or noise",
            endings.join(", ")
        )
    };
    let kind = FileKind::of_file(path).ok_or_else(endings)?;
    if !path.is_file() {
        return Err(
            "there is no such file; paths count from the folder that you are in".to_owned(),
        );
    }
    let was_cube = matches!(old, Some(Input::Cubemap(_) | Input::CubeBuffer));
    Ok(match kind {
        FileKind::Texture if was_cube => Input::Cubemap(Media::Files(faces(path))),
        kind => kind.input(Media::Files(vec![path.to_owned()])),
    })
}

/// The six pictures of which this is the first, if they are there.
fn faces(first: &Path) -> Vec<PathBuf> {
    let faces: Vec<PathBuf> = (0..FACES).map(|number| face_of(first, number)).collect();
    match faces.iter().all(|path| path.is_file()) {
        true => faces,
        false => vec![first.to_owned()],
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_binding_names_pass_channel_and_what_it_reads() {
        let read = |text: &str| text.parse::<Binding>();
        let binding = |pass, channel, what: &str| {
            Ok(Binding {
                pass,
                channel,
                what: what.to_owned(),
            })
        };
        let buffer = PassKind::Buffer;
        assert_eq!(read("0=clip.mp4"), binding(PassKind::Image, 0, "clip.mp4"));
        assert_eq!(
            read("image.iChannel3=a=b.png"),
            binding(PassKind::Image, 3, "a=b.png")
        );
        assert_eq!(
            read("A.1=x.y.png"),
            binding(buffer(BufferLetter::A), 1, "x.y.png")
        );
        assert_eq!(
            read("Buffer D.2=mic"),
            binding(buffer(BufferLetter::D), 2, "mic")
        );
        assert_eq!(
            read("cube_a.0=sky.png"),
            binding(PassKind::Cube, 0, "sky.png")
        );
        for (bad, words) in [
            ("clip.mp4", "write it as N=FILE"),
            ("4=clip.mp4", "only 0 to 3"),
            ("E.0=clip.mp4", "no pass `E`"),
            ("0=", "write it as N=FILE"),
        ] {
            let message = read(bad).expect_err(bad);
            assert!(message.contains(words), "{bad}: {message}");
        }
    }
}
