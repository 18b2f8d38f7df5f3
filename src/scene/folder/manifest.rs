//! What `scene.toml` may say, key by key.

use serde::Deserialize;
use serde::de::value::{MapAccessDeserializer, SeqAccessDeserializer};
use serde::de::{Deserializer, MapAccess, SeqAccess, Visitor};
use toml::Spanned;

use super::super::{BufferLetter, CHANNELS, FileKind, Filter, Input, PassKind, Wrap};

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Manifest {
    pub name: Option<String>,
    /// For people who read the manifest, and for the site.
    pub description: Option<String>,
    /// The size that the scene is made for, width and height in pixels.
    pub size: Option<Spanned<[u32; 2]>>,
    #[serde(default)]
    pub common: Vec<Spanned<String>>,
    /// In which order the buffers are drawn, if it is not that of the alphabet.
    pub order: Option<Spanned<Vec<Letter>>>,
    pub buffer_a: Option<Spanned<PassEntry>>,
    pub buffer_b: Option<Spanned<PassEntry>>,
    pub buffer_c: Option<Spanned<PassEntry>>,
    pub buffer_d: Option<Spanned<PassEntry>>,
    pub cube_a: Option<Spanned<PassEntry>>,
    pub sound: Option<Spanned<PassEntry>>,
    pub image: Spanned<PassEntry>,
}

impl Manifest {
    pub fn pass(&self, kind: PassKind) -> Option<&Spanned<PassEntry>> {
        match kind {
            PassKind::Image => Some(&self.image),
            PassKind::Cube => self.cube_a.as_ref(),
            PassKind::Sound => self.sound.as_ref(),
            PassKind::Buffer(BufferLetter::A) => self.buffer_a.as_ref(),
            PassKind::Buffer(BufferLetter::B) => self.buffer_b.as_ref(),
            PassKind::Buffer(BufferLetter::C) => self.buffer_c.as_ref(),
            PassKind::Buffer(BufferLetter::D) => self.buffer_d.as_ref(),
        }
    }

    /// The order of the buffers; one that is given names each of them once.
    pub fn buffers(&self) -> Result<Vec<BufferLetter>, std::ops::Range<usize>> {
        let has = |letter: BufferLetter| self.pass(PassKind::Buffer(letter)).is_some();
        let Some(order) = &self.order else {
            let all = BufferLetter::ALL.into_iter();
            return Ok(all.filter(|&letter| has(letter)).collect());
        };
        let given = order.get_ref().iter().map(|letter| letter.buffer());
        let given: Vec<BufferLetter> = given.collect();
        let is_right = BufferLetter::ALL.into_iter().all(|letter| {
            let count = given.iter().filter(|&&other| other == letter).count();
            count == usize::from(has(letter))
        });
        match is_right {
            true => Ok(given),
            false => Err(order.span()),
        }
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct PassEntry {
    /// The file with its text, if that has not the customary name.
    pub source: Option<Spanned<String>>,
    #[serde(rename = "iChannel0")]
    channel0: Option<Spanned<ChannelEntry>>,
    #[serde(rename = "iChannel1")]
    channel1: Option<Spanned<ChannelEntry>>,
    #[serde(rename = "iChannel2")]
    channel2: Option<Spanned<ChannelEntry>>,
    #[serde(rename = "iChannel3")]
    channel3: Option<Spanned<ChannelEntry>>,
}

impl PassEntry {
    pub fn channels(&self) -> [Option<&Spanned<ChannelEntry>>; CHANNELS] {
        [
            &self.channel0,
            &self.channel1,
            &self.channel2,
            &self.channel3,
        ]
        .map(Option::as_ref)
    }
}

/// A channel is bound to one thing. Filter, wrap and vflip default to what the site gives a new input of its kind.
#[derive(Deserialize)]
#[serde(try_from = "ChannelKeys")]
pub(super) struct ChannelEntry {
    pub bound: Bound,
    pub filter: Option<Filter>,
    pub wrap: Option<Wrap>,
    pub vflip: Option<bool>,
}

/// What a channel is bound to.
pub(super) enum Bound {
    /// Something without a file.
    Input(Input),
    /// A file, or one of the site's media.
    File(FileKind, Spanned<MediaName>),
}

/// How a manifest names a file.
pub(super) enum MediaName {
    /// A path, or a name, an id or a hash of the site's media.
    One(String),
    /// The six faces of a cubemap.
    Six(Vec<String>),
    /// One of the site's media that is not on the list.
    Site(SiteName),
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct SiteName {
    pub id: String,
    pub path: String,
}

impl<'de> Deserialize<'de> for MediaName {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        struct Names;

        impl<'de> Visitor<'de> for Names {
            type Value = MediaName;

            fn expecting(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
                f.write_str(
                    "a file, the name of one of the site's media, or the six files of a cubemap",
                )
            }

            fn visit_str<E>(self, name: &str) -> Result<MediaName, E> {
                Ok(MediaName::One(name.to_owned()))
            }

            fn visit_seq<A: SeqAccess<'de>>(self, list: A) -> Result<MediaName, A::Error> {
                Vec::deserialize(SeqAccessDeserializer::new(list)).map(MediaName::Six)
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<MediaName, A::Error> {
                SiteName::deserialize(MapAccessDeserializer::new(map)).map(MediaName::Site)
            }
        }

        deserializer.deserialize_any(Names)
    }
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct ChannelKeys {
    texture: Option<Spanned<MediaName>>,
    cubemap: Option<Spanned<MediaName>>,
    volume: Option<Spanned<MediaName>>,
    video: Option<Spanned<MediaName>>,
    music: Option<Spanned<MediaName>>,
    musicstream: Option<Spanned<MediaName>>,
    buffer: Option<Letter>,
    #[serde(default)]
    cube: bool,
    #[serde(default)]
    keyboard: bool,
    #[serde(default)]
    mic: bool,
    #[serde(default)]
    webcam: bool,
    procedural: Option<Procedural>,
    filter: Option<Filter>,
    wrap: Option<Wrap>,
    vflip: Option<bool>,
}

#[derive(Deserialize)]
#[serde(rename_all = "lowercase")]
enum Procedural {
    Noise,
}

/// A buffer, as a manifest spells it.
#[derive(Clone, Copy, PartialEq, Deserialize)]
pub(super) enum Letter {
    A,
    B,
    C,
    D,
}

impl Letter {
    fn buffer(self) -> BufferLetter {
        BufferLetter::ALL[self as usize]
    }
}

impl TryFrom<ChannelKeys> for ChannelEntry {
    type Error = &'static str;

    fn try_from(keys: ChannelKeys) -> Result<Self, Self::Error> {
        let files = [
            (FileKind::Texture, keys.texture),
            (FileKind::Cubemap, keys.cubemap),
            (FileKind::Volume, keys.volume),
            (FileKind::Video, keys.video),
            (FileKind::Music, keys.music),
            (FileKind::MusicStream, keys.musicstream),
        ];
        let flags = [
            (keys.cube, Input::CubeBuffer),
            (keys.keyboard, Input::Keyboard),
            (keys.mic, Input::Mic),
            (keys.webcam, Input::Webcam),
        ];
        let files = files.into_iter();
        let files = files.filter_map(|(kind, name)| Some(Bound::File(kind, name?)));
        let flags = flags.into_iter().filter(|(is_set, _)| *is_set);
        let buffer = keys.buffer.map(|letter| Input::Buffer(letter.buffer()));
        let noise = keys.procedural.map(|Procedural::Noise| Input::Noise);
        let others = flags.map(|(_, input)| input).chain(buffer).chain(noise);
        let mut all = files.chain(others.map(Bound::Input));
        match (all.next(), all.next()) {
            (Some(bound), None) => Ok(ChannelEntry {
                bound,
                filter: keys.filter,
                wrap: keys.wrap,
                vflip: keys.vflip,
            }),
            _ => Err(
                "a channel is bound to one thing: `texture`, `cubemap`, `volume`, `video` or `music` = \"…\", \
                 `buffer = \"A\"`, `procedural = \"noise\"`, or `cube`, `keyboard`, `mic` or `webcam` = true",
            ),
        }
    }
}
