//! Finds built-in functions by name: every call of the program asks.

use super::Builtin;
use super::table::ROWS;

/// Slots of [`INDEX`]: a power of two, about three times the number of functions.
const SLOTS: usize = 256;

/// What an empty slot holds.
const EMPTY: u8 = u8::MAX;

/// The functions' places in the table, where their names' hashes are or behind.
static INDEX: [u8; SLOTS] = index();

/// The FNV-1a hash of a name, folded to a slot.
const fn slot(name: &[u8]) -> usize {
    let mut hash = 0x811c_9dc5_u32;
    let mut i = 0;
    while i < name.len() {
        hash = (hash ^ name[i] as u32).wrapping_mul(0x0100_0193);
        i += 1;
    }
    (hash ^ (hash >> 15)) as usize % SLOTS
}

const fn index() -> [u8; SLOTS] {
    let mut index = [EMPTY; SLOTS];
    let mut place = 0;
    while place < Builtin::COUNT {
        let mut at = slot(super::table::NAMES[place].as_bytes());
        while index[at] != EMPTY {
            at = (at + 1) % SLOTS;
        }
        index[at] = place as u8;
        place += 1;
    }
    index
}

impl Builtin {
    /// The function of this name.
    pub fn find(name: &str) -> Option<Builtin> {
        let mut at = slot(name.as_bytes());
        loop {
            let row = ROWS.get(usize::from(INDEX[at]))?;
            if row.name == name {
                return Some(row.function);
            }
            at = (at + 1) % SLOTS;
        }
    }

    /// The function that took the place of one which only GLSL ES 1.00 or its extensions have.
    pub fn find_legacy(name: &str) -> Option<Builtin> {
        Some(match name {
            "texture2D" | "texture3D" | "textureCube" | "shadow2DEXT" => Builtin::Texture,
            "texture2DProj" | "texture3DProj" | "shadow2DProjEXT" => Builtin::TextureProj,
            "texture2DLod" | "texture2DLodEXT" | "texture3DLod" | "textureCubeLod"
            | "textureCubeLodEXT" => Builtin::TextureLod,
            "texture2DProjLod" | "texture2DProjLodEXT" | "texture3DProjLod" => {
                Builtin::TextureProjLod
            }
            "texture2DGradEXT" | "textureCubeGradEXT" => Builtin::TextureGrad,
            "texture2DProjGradEXT" => Builtin::TextureProjGrad,
            _ => return None,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_name_is_found_and_no_other() {
        for function in Builtin::ALL {
            assert_eq!(Builtin::find(function.name()), Some(function));
        }
        for name in [
            "",
            "Sin",
            "sinn",
            "si",
            "texture2D",
            "fma",
            "mainImage",
            "é",
        ] {
            assert_eq!(Builtin::find(name), None, "{name}");
        }
    }

    #[test]
    fn old_names_lead_to_new_functions() {
        for (old, new) in [
            ("texture2D", "texture"),
            ("texture2DProj", "textureProj"),
            ("texture2DLodEXT", "textureLod"),
            ("texture2DProjLod", "textureProjLod"),
            ("textureCubeGradEXT", "textureGrad"),
            ("texture2DProjGradEXT", "textureProjGrad"),
        ] {
            assert_eq!(Builtin::find_legacy(old), Builtin::find(new), "{old}");
        }
        assert_eq!(Builtin::find_legacy("texture"), None);
    }
}
