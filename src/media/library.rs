use std::collections::HashMap;
use std::fs::{self, File};
use std::io::Read as _;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex};

use super::film::{Film, TestCard};
use super::site::{ITEMS, Item, Kind};
use super::sound::{Sound, SoundFeed};
use super::{Content, Feed, Format, MediaError, Texels, picture, stand_in, volume};
use crate::scene::{Input, Media, NOISE_SIZE, noise_texture};

/// The most bytes of a file that is read as a whole.
const MAX_BYTES: u64 = 1 << 28;

/// How deep below the user's folder files are looked for.
const MAX_DEPTH: usize = 2;

/// The most files that are looked at there.
const MAX_FILES: usize = 10_000;

/// Where media come from: the user's folder, whose copies of the site's files win, and stand-ins for what it lacks.
#[derive(Debug, Default)]
pub struct Library {
    /// The user's files, by the names that they answer to.
    files: HashMap<String, PathBuf>,
    stand_ins: StandIns,
    pictures: Memory<Texels>,
    sounds: Memory<Sound>,
}

/// What is done about media that the user has no copy of.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub enum StandIns {
    /// Their channels stay unbound.
    None,
    /// Others are made.
    #[default]
    Made,
    /// Others are made, and kept in this folder.
    Kept(PathBuf),
}

/// What was loaded before, by what it was loaded from.
#[derive(Debug)]
struct Memory<T>(Mutex<Vec<(Key, Arc<T>)>>);

/// What a loaded input was made of: its files, as they were then, or what it stands in for.
#[derive(Clone, Debug, PartialEq)]
enum Key {
    Noise,
    StandIn(String),
    Files(
        Vec<(PathBuf, Option<std::time::SystemTime>)>,
        Option<Format>,
    ),
}

/// One of the site's media, and what shows for it here.
#[derive(Debug)]
pub struct Entry {
    /// What it is.
    pub item: &'static Item,
    /// Where it comes from.
    pub origin: Origin,
}

/// Where something of the site's comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Origin {
    /// The user's folder has it.
    File(PathBuf),
    /// It is made up.
    StandIn,
}

impl Library {
    /// Of the files in `folder`. Files are known by an id, by the
    /// name that they have on the site, or by what the site calls them; spaces, case and the ending do not matter.
    pub fn new(folder: Option<&Path>, stand_ins: StandIns) -> Result<Self, MediaError> {
        let mut files = HashMap::new();
        if let Some(folder) = folder {
            let mut found = Vec::new();
            list(folder, MAX_DEPTH, &mut found).map_err(|error| MediaError::Io {
                path: folder.to_owned(),
                error,
            })?;
            // In the order of their paths, so that of two that answer to one name always the same is taken.
            found.sort();
            for path in found {
                let name = path.file_stem().map(|stem| plain(&stem.to_string_lossy()));
                files.entry(name.unwrap_or_default()).or_insert(path);
            }
        }
        Ok(Library {
            files,
            stand_ins,
            ..Library::default()
        })
    }

    /// Everything that the site has, and where it comes from here.
    pub fn entries(&self) -> impl Iterator<Item = Entry> {
        ITEMS.iter().map(|item| Entry {
            item,
            origin: self.origin(item),
        })
    }

    /// Where one of the site's media comes from here.
    pub fn origin(&self, item: &'static Item) -> Origin {
        let own = [item.id, item.hash, item.name];
        let mut names = own.iter().chain(names_of_collections(item));
        match names.find_map(|name| self.files.get(&plain(name))) {
            Some(path) => Origin::File(path.clone()),
            None => Origin::StandIn,
        }
    }

    /// What an input reads; `None` of what is drawn, of the keyboard, and of what shall have no stand-in.
    pub fn open(&self, input: &Input) -> Result<Option<Content>, MediaError> {
        if self.stand_ins == StandIns::None && self.is_missing(input) {
            return Ok(None);
        }
        match input {
            Input::Buffer(_) | Input::CubeBuffer | Input::Keyboard => Ok(None),
            Input::Noise | Input::Texture(_) | Input::Cubemap(_) | Input::Volume(_) => self
                .texels(input)
                .map(|texels| Some(Content::Still(texels))),
            Input::Music(media) | Input::MusicStream(media) => {
                let sound = match self.recording(input)? {
                    Some(sound) => sound,
                    None => {
                        let name = media.to_string();
                        let key = Key::StandIn(name.clone());
                        self.sounds.once(key, || Ok(Sound::synthetic(&name)))?
                    }
                };
                Ok(Some(live(SoundFeed::music(sound))))
            }
            Input::Mic => Ok(Some(live(SoundFeed::microphone(Arc::new(Sound::murmur()))))),
            Input::Video(media) => Ok(Some(match self.file(media) {
                Some(path) => live(Film::open(&path)?),
                None => live(match item(media) {
                    Some(item) => TestCard::item(item),
                    None => TestCard::film(&media.to_string()),
                }),
            })),
            Input::Webcam => Ok(Some(live(TestCard::webcam()))),
        }
    }

    /// The music that an input names, as far as the user has it.
    pub fn recording(&self, input: &Input) -> Result<Option<Arc<Sound>>, MediaError> {
        let (Input::Music(media) | Input::MusicStream(media)) = input else {
            return Ok(None);
        };
        let path = self.file(media);
        path.map(|path| {
            let key = Key::files(std::slice::from_ref(&path), None);
            self.sounds.once(key, || Sound::open(&path))
        })
        .transpose()
    }

    /// The user's file for an input, if there is one.
    fn file(&self, media: &Media) -> Option<PathBuf> {
        match media {
            Media::Files(paths) => paths.first().cloned(),
            Media::Site { .. } => match self.origin(item(media)?) {
                Origin::File(path) => Some(path),
                Origin::StandIn => None,
            },
        }
    }

    /// Whether an input names something that the user has no copy of.
    pub fn is_missing(&self, input: &Input) -> bool {
        match input.media() {
            Some(media) => self.file(media).is_none(),
            None => matches!(input, Input::Mic | Input::Webcam),
        }
    }

    fn texels(&self, input: &Input) -> Result<Arc<Texels>, MediaError> {
        match input {
            Input::Noise => self.pictures.once(Key::Noise, || Ok(noise())),
            Input::Texture(media) | Input::Cubemap(media) | Input::Volume(media) => match media {
                Media::Files(paths) => self.read(input, paths, None),
                Media::Site { id, path } => {
                    let item = Item::of_media(id, path).filter(|item| fits(item, input));
                    let item = item.ok_or_else(|| MediaError::Unknown { name: path.clone() })?;
                    self.of_site(input, item)
                }
            },
            _ => Err(MediaError::Unknown {
                name: input.name().to_owned(),
            }),
        }
    }

    fn of_site(&self, input: &Input, item: &'static Item) -> Result<Arc<Texels>, MediaError> {
        let format = match item.kind {
            Kind::Texture { format, .. } => Some(format),
            _ => None,
        };
        match self.origin(item) {
            Origin::File(path) => self.read(input, &[path], format),
            Origin::StandIn => self.pictures.once(Key::StandIn(item.id.to_owned()), || {
                self.stand_in(item).ok_or_else(|| MediaError::Unknown {
                    name: item.name.to_owned(),
                })
            }),
        }
    }

    /// Makes a stand-in, or takes it from the cache. A cache that cannot be used costs time and nothing else.
    fn stand_in(&self, item: &Item) -> Option<Texels> {
        let StandIns::Kept(cache) = &self.stand_ins else {
            return stand_in::make(item);
        };
        let folder = cache.join(format!("stand-ins-{}", stand_in::VERSION));
        let path = folder.join(format!("{}.png", item.id));
        if let Some(kept) = fs::read(&path)
            .ok()
            .and_then(|png| unstacked(&path, &png, item))
        {
            return Some(kept);
        }
        let made = stand_in::make(item)?;
        if let Some(png) = stacked(&made)
            && fs::create_dir_all(&folder).is_ok()
            && let Ok(mut file) = tempfile::NamedTempFile::new_in(&folder)
            && std::io::Write::write_all(&mut file, &png).is_ok()
        {
            let _ = file.persist(&path);
        }
        Some(made)
    }

    /// What shows for one of the site's pictures, cubemaps or volumes, as a PNG, layer below layer. `None` of films and music.
    pub fn to_png(&self, item: &'static Item) -> Result<Option<Vec<u8>>, MediaError> {
        let media = item.media();
        let input = match item.kind {
            Kind::Texture { .. } => Input::Texture(media),
            Kind::Cubemap { .. } => Input::Cubemap(media),
            Kind::Volume { .. } => Input::Volume(media),
            Kind::Video | Kind::Music => return Ok(None),
        };
        Ok(stacked(&*self.texels(&input)?))
    }

    fn read(
        &self,
        input: &Input,
        paths: &[PathBuf],
        format: Option<Format>,
    ) -> Result<Arc<Texels>, MediaError> {
        let paths = match (input, paths) {
            (Input::Cubemap(_), [base]) => faces_beside(base).unwrap_or_else(|| paths.to_vec()),
            _ => paths.to_vec(),
        };
        self.pictures.once(Key::files(&paths, format), || {
            let pictures = || -> Result<Vec<Texels>, MediaError> {
                paths
                    .iter()
                    .map(|path| picture::read(path, &bytes(path)?, format))
                    .collect()
            };
            match (input, &*paths) {
                (Input::Volume(_), [path, ..]) => volume::read(path, &bytes(path)?),
                (Input::Cubemap(_), [path]) => {
                    picture::cut_faces(path, &picture::read(path, &bytes(path)?, format)?)
                }
                (Input::Cubemap(_), _) if paths.len() == 6 => picture::faces(&paths, pictures()?),
                (Input::Texture(_), [path]) => picture::read(path, &bytes(path)?, format),
                _ => Err(MediaError::NotA {
                    path: paths.first().cloned().unwrap_or_default(),
                    what: input.name(),
                    words: format!("{} files are named for it", paths.len()),
                }),
            }
        })
    }
}

impl Key {
    fn files(paths: &[PathBuf], format: Option<Format>) -> Key {
        let changed = |path: &PathBuf| fs::metadata(path).and_then(|data| data.modified()).ok();
        let files = paths.iter().map(|path| (path.clone(), changed(path)));
        Key::Files(files.collect(), format)
    }
}

impl<T> Default for Memory<T> {
    fn default() -> Self {
        Memory(Mutex::default())
    }
}

impl<T> Memory<T> {
    /// Loads something, or hands out what was loaded before.
    fn once(
        &self,
        key: Key,
        load: impl FnOnce() -> Result<T, MediaError>,
    ) -> Result<Arc<T>, MediaError> {
        let loaded = || self.0.lock().expect("no holder panics");
        if let Some((_, known)) = loaded().iter().find(|(known, _)| *known == key) {
            return Ok(Arc::clone(known));
        }
        let new = Arc::new(load()?);
        let mut loaded = loaded();
        // What no scene holds any more goes, so that reloads with ever other files do not fill the memory.
        loaded.retain(|(_, held)| Arc::strong_count(held) > 1);
        loaded.push((key, Arc::clone(&new)));
        Ok(new)
    }
}

/// Which of the site's media it is, if it is one.
fn item(media: &Media) -> Option<&'static Item> {
    match media {
        Media::Site { id, path } => Item::of_media(id, path),
        Media::Files(_) => None,
    }
}

fn live(feed: impl Feed + 'static) -> Content {
    Content::Live(Arc::new(Mutex::new(feed)))
}

fn fits(item: &Item, input: &Input) -> bool {
    matches!(
        (item.kind, input),
        (Kind::Texture { .. }, Input::Texture(_))
            | (Kind::Cubemap { .. }, Input::Cubemap(_))
            | (Kind::Volume { .. }, Input::Volume(_))
    )
}

/// A name without what people write differently.
fn plain(name: &str) -> String {
    let letters = name.chars().filter(|letter| letter.is_alphanumeric());
    letters.flat_map(char::to_lowercase).collect()
}

/// What public collections of the site's files call some of them.
fn names_of_collections(item: &Item) -> &'static [&'static str] {
    match item.id {
        "XsfGzn" => &["Gallery", "Uffizi"],
        "4sfGzn" => &["GalleryB", "UffiziBlurred"],
        "XdX3zn" => &["Basilica", "StPeters"],
        "4dX3zn" => &["BasilicaBlur", "BasilicaBlurred"],
        "4sX3zn" => &["ForestBlur", "ForestB"],
        _ => &[],
    }
}

/// The files in a folder and in those below it.
fn list(folder: &Path, depth: usize, found: &mut Vec<PathBuf>) -> std::io::Result<()> {
    for entry in fs::read_dir(folder)? {
        let path = entry?.path();
        if path.is_dir() {
            if depth > 0 {
                list(&path, depth - 1, found)?;
            }
        } else if found.len() < MAX_FILES {
            found.push(path);
        }
    }
    Ok(())
}

/// The faces of a cubemap whose first one is named: the others have `_1` to `_5` ahead of the ending, as on the site.
fn faces_beside(base: &Path) -> Option<Vec<PathBuf>> {
    let stem = base.file_stem()?.to_string_lossy().into_owned();
    let ending = base
        .extension()
        .map(|ending| format!(".{}", ending.to_string_lossy()));
    let ending = ending.unwrap_or_default();
    let others = (1..6).map(|face| base.with_file_name(format!("{stem}_{face}{ending}")));
    let faces: Vec<PathBuf> = std::iter::once(base.to_owned()).chain(others).collect();
    faces
        .iter()
        .skip(1)
        .all(|path| path.is_file())
        .then_some(faces)
}

fn bytes(path: &Path) -> Result<Vec<u8>, MediaError> {
    let io = |error| MediaError::Io {
        path: path.to_owned(),
        error,
    };
    let mut bytes = Vec::new();
    // A pipe or a device would never end.
    if !fs::metadata(path).map_err(io)?.is_file() {
        return Err(io(std::io::Error::other("it is not a file")));
    }
    File::open(path)
        .map_err(io)?
        .take(MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(io)?;
    if bytes.len() as u64 > MAX_BYTES {
        return Err(MediaError::NotA {
            path: path.to_owned(),
            what: "input",
            words: format!("it has more than {} MiB", MAX_BYTES >> 20),
        });
    }
    Ok(bytes)
}

/// The noise of the scenes that name it. It is made with its bottom row first.
fn noise() -> Texels {
    let row = 4 * NOISE_SIZE as usize;
    Texels {
        size: [NOISE_SIZE, NOISE_SIZE, 1],
        format: Format::Rgba8,
        bytes: noise_texture()
            .chunks(row)
            .rev()
            .flatten()
            .copied()
            .collect(),
    }
}

/// Texels as one picture, layer below layer.
fn stacked(texels: &Texels) -> Option<Vec<u8>> {
    let [width, height, depth] = texels.size;
    let color = match texels.format {
        Format::R8 => image::ExtendedColorType::L8,
        Format::Rgba8 => image::ExtendedColorType::Rgba8,
        _ => return None,
    };
    let mut png = Vec::new();
    let encoder = image::codecs::png::PngEncoder::new(&mut png);
    image::ImageEncoder::write_image(encoder, &texels.bytes, width, height * depth, color).ok()?;
    Some(png)
}

/// The same the other way, if it is what the item should be.
fn unstacked(path: &Path, png: &[u8], item: &Item) -> Option<Texels> {
    let (size, format) = match item.kind {
        Kind::Texture {
            size: [width, height],
            format,
        } => ([width, height, 1], format),
        Kind::Cubemap { size } => ([size, size, 6], Format::Rgba8),
        Kind::Volume { size, format } => ([size; 3], format),
        Kind::Video | Kind::Music => return None,
    };
    let picture = picture::read(path, png, Some(format)).ok()?;
    let [width, height, depth] = size;
    (picture.size == [width, height * depth, 1] && picture.format == format)
        .then_some(Texels { size, ..picture })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_a_scene_holds_is_loaded_once_and_what_none_holds_is_forgotten() {
        let memory = Memory::default();
        let load = |name: &str| {
            let key = Key::StandIn(name.to_owned());
            memory.once(key, || Ok(name.to_owned())).unwrap()
        };
        let first = load("first");
        assert!(Arc::ptr_eq(&first, &load("first")));
        drop(first);
        assert_eq!(*load("second"), "second");
        assert_eq!(memory.0.lock().unwrap().len(), 1);
    }

    #[test]
    fn a_file_that_has_changed_is_another() {
        let file = tempfile::NamedTempFile::new().unwrap();
        let key = || Key::files(&[file.path().to_owned()], None);
        let before = key();
        assert_eq!(key(), before);
        let later = std::time::SystemTime::now() + std::time::Duration::from_secs(9);
        file.as_file().set_modified(later).unwrap();
        assert_ne!(key(), before);
    }
}
