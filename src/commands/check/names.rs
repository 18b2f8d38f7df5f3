//! Which scenes to check.

use std::fs;
use std::io::Read as _;
use std::path::{Path, PathBuf};

use super::super::unreadable;
use crate::cli::CheckArgs;

/// The scenes named on the command line, then those of the list, with folders opened.
pub(super) fn gather(args: &CheckArgs) -> anyhow::Result<Vec<PathBuf>> {
    let mut names = Vec::new();
    for name in &args.scenes {
        add(name, &mut names);
    }
    if let Some(list) = &args.list {
        let text = read(list).map_err(|error| unreadable(list, &error))?;
        for line in text.lines().filter(|line| !line.trim().is_empty()) {
            add(Path::new(line), &mut names);
        }
    }
    Ok(names)
}

fn read(list: &Path) -> std::io::Result<String> {
    if list != Path::new("-") {
        return fs::read_to_string(list);
    }
    let mut text = String::new();
    std::io::stdin().read_to_string(&mut text)?;
    Ok(text)
}

/// Adds a scene, or every scene below a folder that is none itself.
fn add(name: &Path, names: &mut Vec<PathBuf>) {
    let before = names.len();
    if name.is_dir() && !is_scene_folder(name) {
        walk(name, names);
    }
    if names.len() == before {
        names.push(name.to_owned());
    }
}

fn is_scene_folder(folder: &Path) -> bool {
    let holds = |name| folder.join(name).exists();
    holds("scene.toml") || holds("image.glsl")
}

/// Adds the scenes below a folder in the order of their names. Links to folders are left alone: they
/// may lead in circles.
fn walk(folder: &Path, names: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else {
        // A folder that cannot be read is named as such when it is checked.
        names.push(folder.to_owned());
        return;
    };
    let mut entries: Vec<_> = entries.filter_map(Result::ok).collect();
    entries.sort_by_key(fs::DirEntry::file_name);
    for entry in entries {
        let path = entry.path();
        let is_folder = entry.file_type().is_ok_and(|kind| kind.is_dir());
        if is_folder && !is_scene_folder(&path) {
            walk(&path, names);
        } else if is_folder || is_scene_file(&path) {
            names.push(path);
        }
    }
}

fn is_scene_file(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default();
    (ending == "json" || ending == "glsl") && path.is_file()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn folders_are_opened_unless_they_are_scenes() {
        let folder = tempfile::tempdir().unwrap();
        let root = folder.path();
        for path in [
            "b.json",
            "a.glsl",
            "notes.txt",
            "deep/c.glsl",
            "scene/image.glsl",
            "scene/part.glsl",
            "named/scene.toml",
        ] {
            fs::create_dir_all(root.join(path).parent().unwrap()).unwrap();
            fs::write(root.join(path), "").unwrap();
        }
        let gathered = |name: &Path| {
            let mut names = Vec::new();
            add(name, &mut names);
            names
        };
        let expected = ["a.glsl", "b.json", "deep/c.glsl", "named", "scene"];
        assert_eq!(gathered(root), expected.map(|name| root.join(name)));
        let scene = root.join("scene");
        assert_eq!(gathered(&scene), std::slice::from_ref(&scene));
        fs::create_dir(root.join("empty")).unwrap();
        let empty = root.join("empty");
        let itself = std::slice::from_ref(&empty);
        assert_eq!(gathered(&empty), itself, "it is refused later");
    }
}
