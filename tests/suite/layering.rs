//! The rooms of `src/` use only what the architecture lets them use.

use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

use crate::support::repository;

/// A room, the rooms it may use, and the crates it may use besides `std`. `std::fs` counts as a
/// crate: few rooms touch files. `docs/ARCHITECTURE.md` gives the reasons.
#[rustfmt::skip]
const RULES: &[(&str, &str, &str)] = &[
    ("source", "", ""),
    ("frame", "", "glam jiff"),
    ("config", "", "etcetera serde thiserror toml std::fs"),
    ("input_script", "frame", "glam serde serde_json thiserror std::fs"),
    ("report", "source", "annotate_snippets anstream serde serde_json"),
    ("scene", "source", "image serde serde_json toml std::fs"),
    ("media", "scene", "epaint_default_fonts image realfft symphonia tempfile thiserror ttf_parser std::fs"),
    ("glsl", "source", "hashbrown memchr naga rustc_hash smallvec"),
    ("translate", "glsl scene source", "naga"),
    ("render", "frame media scene translate", "bytemuck glam half pollster thiserror wgpu"),
    ("session", "frame media render scene source translate", "glam"),
    ("measure", "frame media render scene session source translate", "glam plotters serde serde_json toml"),
    ("output", "frame", "exr glam hound image tempfile thiserror std::fs"),
    ("web", "output scene", "serde_json thiserror ureq std::fs"),
    ("export", "frame output render scene session source translate", "glam thiserror std::fs"),
    ("window", "frame input_script media output render report scene session source translate",
        "anstream arboard cpal glam notify winit"),
    ("cli", "", "clap"),
    ("commands", "cli config export frame input_script measure media output render report scene session source translate web window",
        "anstream anyhow ctrlc glam indicatif serde serde_json std::fs"),
    ("main", "cli commands", "clap"),
    ("lib", "", ""),
];

#[test]
fn every_room_keeps_to_its_row() {
    let files = files(&repository("src"));
    let rooms = files.iter().map(|(_, room)| room.as_str()).collect();
    let crates = crates();
    let mut broken = String::new();
    for (path, room) in &files {
        let row = RULES.iter().find(|(name, ..)| name == room);
        let (_, may_use, may_import) =
            row.unwrap_or_else(|| panic!("`{room}` has no row in RULES"));
        let text = fs::read_to_string(repository("src").join(path)).expect("a source file");
        // Unit tests may use what they need.
        let (program, _) = text
            .split_once("\n#[cfg(test)]\nmod ")
            .unwrap_or((&text, ""));
        for (line, code) in (1..).zip(program.lines()) {
            for used in used(code, &rooms, &crates) {
                // A module's own child hides a crate of the same name.
                let is_own = used == *room || program.contains(&format!("mod {used};"));
                let is_allowed = |list: &str| list.split(' ').any(|name| name == used);
                if !is_own && !is_allowed(may_use) && !is_allowed(may_import) {
                    broken += &format!(
                        "src/{}:{line}: `{room}` may use [{may_use}] and [{may_import}], not `{used}`\n",
                        path.display()
                    );
                }
            }
        }
    }
    assert!(broken.is_empty(), "\n{broken}");
}

/// Every Rust file below `src`, with the room that it belongs to.
fn files(src: &Path) -> Vec<(PathBuf, String)> {
    let mut found = Vec::new();
    let mut open = vec![src.to_owned()];
    while let Some(path) = open.pop() {
        if path.is_dir() {
            let entries = fs::read_dir(&path).expect("a folder");
            open.extend(entries.map(|entry| entry.expect("an entry").path()));
        } else if path.extension().is_some_and(|ending| ending == "rs") {
            let inside = path.strip_prefix(src).expect("it lies within");
            let first = inside.iter().next().expect("a name").to_string_lossy();
            found.push((inside.to_owned(), first.trim_end_matches(".rs").to_owned()));
        }
    }
    found.sort();
    found
}

/// The names of all dependencies, as code spells them.
fn crates() -> BTreeSet<String> {
    let manifest = fs::read_to_string(repository("Cargo.toml")).expect("the manifest");
    let manifest: toml::Table = manifest.parse().expect("it is TOML");
    let dependencies = manifest["dependencies"].as_table().expect("a table");
    dependencies
        .keys()
        .map(|name| name.replace('-', "_"))
        .collect()
}

/// The rooms that a line of code names behind `crate::`, or `vitrine::` in the binary, and the crates
/// that it names in front of `::`.
fn used(code: &str, rooms: &BTreeSet<&str>, crates: &BTreeSet<String>) -> Vec<String> {
    let is_in_name = |c: char| c.is_alphanumeric() || c == '_';
    let code = code.split("//").next().unwrap_or_default();
    let mut used = Vec::new();
    for (at, _) in code.match_indices("::") {
        let (before, behind) = (&code[..at], &code[at + 2..]);
        let name = before.rsplit(|c| !is_in_name(c)).next().unwrap_or_default();
        if before[..at - name.len()].ends_with("::") {
            continue;
        }
        if name == "crate" || name == "vitrine" {
            let names = match behind.strip_prefix('{') {
                Some(group) => group.split(", ").collect(),
                None => vec![behind],
            };
            let heads = names
                .iter()
                .map(|path| path.split(|c| !is_in_name(c)).next());
            used.extend(
                heads
                    .flatten()
                    .filter(|name| rooms.contains(name))
                    .map(str::to_owned),
            );
        } else if name == "std" && behind.starts_with("fs") {
            used.push("std::fs".to_owned());
        } else if crates.contains(name) {
            used.push(name.to_owned());
        }
    }
    used
}

#[test]
fn a_line_shows_what_it_uses() {
    let crates = ["wgpu".to_owned()].into();
    let used = |code| used(code, &["scene", "frame"].into(), &crates).join(" ");
    assert_eq!(
        used("use crate::{frame::Clock, other, scene};"),
        "frame scene"
    );
    assert_eq!(
        used("pub(crate) use vitrine::frame::{Clock, scene}; // wgpu::Queue"),
        "frame"
    );
    assert_eq!(
        used("fn f(a: &wgpu::Queue) -> std::fs::File { super::wgpu::g() }"),
        "wgpu std::fs"
    );
}
