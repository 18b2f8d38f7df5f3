//! The media that the site offers to its shaders: a closed list, told by what 96,768 published shaders use. The files
//! themselves are not ours; see [`stand_in`](crate::media::stand_in).

use super::Media;
use Format::{R8, Rgba8};

/// What one texel is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// One number from 0 to 1 in 8 bits; it is read as (r, 0, 0, 1).
    R8,
    /// Red, green, blue and alpha, each from 0 to 1 in 8 bits.
    Rgba8,
    /// One 32-bit float.
    R32Float,
    /// Four 32-bit floats.
    Rgba32Float,
}

impl Format {
    /// Bytes of a texel.
    pub fn bytes(self) -> usize {
        match self {
            Format::R8 => 1,
            Format::Rgba8 | Format::R32Float => 4,
            Format::Rgba32Float => 16,
        }
    }
}

/// One of the site's files.
#[derive(Debug, PartialEq, Eq)]
pub struct Item {
    /// What the site calls it.
    pub name: &'static str,
    /// Six characters: how shaders' JSON names it.
    pub id: &'static str,
    /// What its file on the site is called, without the ending.
    pub hash: &'static str,
    /// The ending of that name.
    pub extension: &'static str,
    /// What it is.
    pub kind: Kind,
}

/// What one of the site's files is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// A picture.
    Texture {
        /// Width and height in texels.
        size: [u32; 2],
        /// How the site uploads it.
        format: Format,
    },
    /// Six square pictures.
    Cubemap {
        /// Width and height of each in texels.
        size: u32,
    },
    /// A cube of texels.
    Volume {
        /// Width, height and depth in texels.
        size: u32,
        /// How the site uploads it.
        format: Format,
    },
    /// A film.
    Video,
    /// A piece of music.
    Music,
}

impl Kind {
    /// What this kind of input is called, by the site's JSON and in a manifest.
    pub fn name(self) -> &'static str {
        match self {
            Kind::Texture { .. } => "texture",
            Kind::Cubemap { .. } => "cubemap",
            Kind::Volume { .. } => "volume",
            Kind::Video => "video",
            Kind::Music => "music",
        }
    }
}

impl Item {
    /// Where its file lies on the site.
    pub fn path(&self) -> String {
        format!("/media/a/{}.{}", self.hash, self.extension)
    }

    /// How a scene refers to it.
    pub fn media(&self) -> Media {
        Media::Site {
            id: self.id.to_owned(),
            path: self.path(),
        }
    }

    /// The item that a scene refers to. The site's two dialects of JSON agree on paths, not on ids.
    pub fn of_media(id: &str, path: &str) -> Option<&'static Item> {
        let by_hash = |item: &&Item| path.contains(item.hash);
        let by_id = |item: &&Item| item.id == id;
        ITEMS
            .iter()
            .find(by_hash)
            .or_else(|| ITEMS.iter().find(by_id))
    }

    /// The item that a person means: by its name, in capitals or not, its id, its hash or its path.
    pub fn named(text: &str) -> Option<&'static Item> {
        ITEMS.iter().find(|item| {
            item.name.eq_ignore_ascii_case(text)
                || item.id == text
                || item.hash == text
                || text == format!("{}.{}", item.hash, item.extension)
                || text == item.path()
        })
    }
}

use Kind::{Cubemap, Music, Texture, Video, Volume};

#[rustfmt::skip]
/// All of them.
pub const ITEMS: &[Item] = &[
    Item { name: "Abstract 1", id: "XdX3Rn", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "52d2a8f514c4fd2d9866587f4d7b2a5bfa1a11a0e772077d7682deb8b3b517e5" },
    Item { name: "Abstract 2", id: "4dX3Rn", extension: "jpg", kind: Texture { size: [512, 512], format: Rgba8 },
        hash: "bd6464771e47eed832c5eb2cd85cdc0bfc697786b903bfd30f890f9d4fc36657" },
    Item { name: "Abstract 3", id: "XdXGzr", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "8979352a182bde7c3c651ba2b2f4e0615de819585cc37b7175bcefbca15a6683" },
    Item { name: "Bayer", id: "Xdf3zn", extension: "png", kind: Texture { size: [8, 8], format: R8 },
        hash: "85a6d68622b36995ccb98a89bbb119edf167c914660e4450d313de049320005c" },
    Item { name: "Blue Noise", id: "XsBSR3", extension: "png", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "cb49c003b454385aa9975733aff4571c62182ccdda480aaba9a8d250014f00ec" },
    Item { name: "Font 1", id: "4dXGzr", extension: "png", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "08b42b43ae9d3c0605da11d0eac86618ea888e62cdd9518ee8b9097488b31560" },
    Item { name: "Gray Noise Medium", id: "4dXGzn", extension: "png", kind: Texture { size: [256, 256], format: R8 },
        hash: "0c7bf5fe9462d5bffbd11126e82908e39be3ce56220d900f633d58fb432e56f5" },
    Item { name: "Gray Noise Small", id: "4sf3Rn", extension: "png", kind: Texture { size: [64, 64], format: R8 },
        hash: "0a40562379b63dfb89227e6d172f39fdce9022cba76623f1054a2c83d6c0ba5d" },
    Item { name: "Lichen", id: "4sfGRn", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "fb918796edc3d2221218db0811e240e72e340350008338b0c07a52bd353666a6" },
    Item { name: "London", id: "4dfGRn", extension: "jpg", kind: Texture { size: [512, 512], format: Rgba8 },
        hash: "8de3a3924cb95bd0e95a443fff0326c869f9d4979cd1d5b6e94e2a01f5be53e9" },
    Item { name: "Nyancat", id: "Xsf3Rn", extension: "png", kind: Texture { size: [256, 32], format: Rgba8 },
        hash: "cbcbb5a6cfb55c36f8f021fbb0e3f69ac96339a39fa85cd96f2017a2192821b5" },
    Item { name: "Organic 1", id: "XsXGRn", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "cd4c518bc6ef165c39d4405b347b51ba40f8d7a065ab0e8d2e4f422cbc1e8a43" },
    Item { name: "Organic 2", id: "XsX3Rn", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "92d7758c402f0927011ca8d0a7e40251439fba3a1dac26f5b8b62026323501aa" },
    Item { name: "Organic 3", id: "Xsf3Rr", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "79520a3d3a0f4d3caa440802ef4362e99d54e12b1392973e4ea321840970a88a" },
    Item { name: "Organic 4", id: "4df3Rr", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "3871e838723dd6b166e490664eead8ec60aedd6b8d95bc8e2fe3f882f0fd90f0" },
    Item { name: "Pebbles", id: "4sf3Rr", extension: "png", kind: Texture { size: [512, 512], format: R8 },
        hash: "ad56fba948dfba9ae698198c109e71f118a54d209c0ea50d77ea546abad89c57" },
    Item { name: "RGBA Noise Medium", id: "Xsf3zn", extension: "png", kind: Texture { size: [256, 256], format: Rgba8 },
        hash: "f735bee5b64ef98879dc618b016ecf7939a5756040c2cde21ccb15e69a6e1cfb" },
    Item { name: "RGBA Noise Small", id: "XdXGzn", extension: "png", kind: Texture { size: [64, 64], format: Rgba8 },
        hash: "3083c722c0c738cad0f468383167a0d246f91af2bfa373e9c5c094fb8c8413e0" },
    Item { name: "Rock Tiles", id: "4dXGRn", extension: "jpg", kind: Texture { size: [512, 512], format: Rgba8 },
        hash: "10eb4fe0ac8a7dc348a2cc282ca5df1759ab8bf680117e4047728100969e7b43" },
    Item { name: "Rusty Metal", id: "4sXGRn", extension: "jpg", kind: Texture { size: [512, 512], format: Rgba8 },
        hash: "95b90082f799f48677b4f206d856ad572f1d178c676269eac6347631d4447258" },
    Item { name: "Stars", id: "XdfGRn", extension: "jpg", kind: Texture { size: [512, 512], format: Rgba8 },
        hash: "e6e5631ce1237ae4c05b3563eda686400a401df4548d0f9fad40ecac1659c46c" },
    Item { name: "Wood", id: "XsfGRn", extension: "jpg", kind: Texture { size: [1024, 1024], format: Rgba8 },
        hash: "1f7dca9c22f324751f2a5a59c9b181dfe3b5564a04b724c657732d0bf09c99db" },
    Item { name: "Forest", id: "XsX3zn", extension: "png", kind: Cubemap { size: 256 },
        hash: "94284d43be78f00eb6b298e6d78656a1b34e2b91b34940d02f1ca8b22310e8a0" },
    Item { name: "Forest Blurred", id: "4sX3zn", extension: "png", kind: Cubemap { size: 64 },
        hash: "0681c014f6c88c356cf9c0394ffe015acc94ec1474924855f45d22c3e70b5785" },
    Item { name: "St. Peter's Basilica", id: "XdX3zn", extension: "jpg", kind: Cubemap { size: 256 },
        hash: "488bd40303a2e2b9a71987e48c66ef41f5e937174bf316d3ed0e86410784b919" },
    Item { name: "St. Peter's Basilica Blurred", id: "4dX3zn", extension: "png", kind: Cubemap { size: 64 },
        hash: "550a8cce1bf403869fde66dddf6028dd171f1852f4a704a465e1b80d23955663" },
    Item { name: "Uffizi Gallery", id: "XsfGzn", extension: "jpg", kind: Cubemap { size: 512 },
        hash: "585f9546c092f53ded45332b343144396c0b2d70d9965f585ebc172080d8aa58" },
    Item { name: "Uffizi Gallery Blurred", id: "4sfGzn", extension: "png", kind: Cubemap { size: 64 },
        hash: "793a105653fbdadabdc1325ca08675e1ce48ae5f12e37973829c87bea4be3232" },
    Item { name: "Grey Noise 3D", id: "4sfGRr", extension: "bin", kind: Volume { size: 32, format: R8 },
        hash: "27012b4eadd0c3ce12498b867058e4f717ce79e10a99568cca461682d84a4b04" },
    Item { name: "RGBA Noise 3D", id: "XdX3Rr", extension: "bin", kind: Volume { size: 32, format: Rgba8 },
        hash: "aea6b99da1d53055107966b59ac5444fc8bc7b3ce2d0bbb6a4a3cbae1d97f3aa" },
    Item { name: "Britney Spears", id: "Xdf3Rn", extension: "webm", kind: Video,
        hash: "e81e818ac76a8983d746784b423178ee9f6cdcdf7f8e8d719341a6fe2d2ab303" },
    Item { name: "Google Logo", id: "4sX3Rn", extension: "ogv", kind: Video,
        hash: "c3a071ecf273428bc72fc72b2dd972671de8da420a2d4f917b75d20e1c24b34c" },
    Item { name: "Jean-Claude Van Damme", id: "XdfGRr", extension: "webm", kind: Video,
        hash: "35c87bcb8d7af24c54d41122dadb619dd920646a0bd0e477e7bdc6d12876df17" },
    Item { name: "Lustre Creme", id: "4df3zn", extension: "ogv", kind: Video,
        hash: "3405e48f74815c7baa49133bdc835142948381fbe003ad2f12f5087715731153" },
    Item { name: "8 Bit Mentality", id: "4sXGzn", extension: "mp3", kind: Music,
        hash: "a6a1cf7a09adfed8c362492c88c30d74fb3d2f4f7ba180ba34b98556660fada1" },
    Item { name: "Electronebulae", id: "4df3Rn", extension: "mp3", kind: Music,
        hash: "3c33c415862bb7964d256f4749408247da6596f2167dca2c86cc38f83c244aa6" },
    Item { name: "Experiment", id: "XsXGzn", extension: "mp3", kind: Music,
        hash: "29de534ed5e4a6a224d2dfffab240f2e19a9d95f5e39de8898e850efdb2a99de" },
    Item { name: "Most Geometric Person", id: "4sXGRr", extension: "mp3", kind: Music,
        hash: "48e2d9ef22ca6673330b8c38a260c87694d2bbc94c19fec9dfa4a1222c364a99" },
    Item { name: "ourpithyator", id: "4dfGzn", extension: "mp3", kind: Music,
        hash: "ec8a6ea755d34600547a5353f21f0a453f9f55ff95514383b2d80b8d71283eda" },
    Item { name: "Tropical Beeper", id: "XsXGRr", extension: "mp3", kind: Music,
        hash: "d96b229eeb7a08d53adfcf1ff89e54c9ffeebed193d317d1a01cc8125c0f5cca" },
    Item { name: "X TrackTure", id: "XdfGzn", extension: "mp3", kind: Music,
        hash: "894a09f482fb9b2822c093630fc37f0ce6cfec02b652e4e341323e4b6e4a4543" },
];
