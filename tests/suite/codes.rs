//! docs/diagnostics.md lists every code that the program gives, and no other.

use std::collections::BTreeSet;
use std::path::Path;

/// Calls whose first argument is a code.
const GIVING: [&str; 7] = [
    "Diagnostic::error(",
    "Diagnostic::warning(",
    ".error(",
    ".error_with_hint(",
    ".refused_by_webgl(",
    ".warn(",
    "refused(source, ",
];

#[test]
fn every_code_is_documented() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let mut given = BTreeSet::new();
    for file in sources(&root.join("src")) {
        let text = std::fs::read_to_string(&file).expect("it can be read");
        for call in GIVING {
            for (at, _) in text.match_indices(call) {
                given.extend(literal(&text[at + call.len()..]).map(str::to_owned));
            }
        }
    }
    let page = std::fs::read_to_string(root.join("docs/diagnostics.md")).expect("it is there");
    let documented: BTreeSet<String> = page
        .lines()
        .filter_map(|line| line.strip_prefix("| `")?.split(" |").next())
        .flat_map(|cell| cell.split("`, `"))
        .map(|code| code.trim_matches('`').to_owned())
        .collect();
    let missing: Vec<_> = given.difference(&documented).collect();
    assert!(
        missing.is_empty(),
        "not in docs/diagnostics.md: {missing:?}"
    );
    for code in &documented {
        let quoted = format!("\"{code}\"");
        let is_given = sources(&root.join("src"))
            .iter()
            .any(|file| std::fs::read_to_string(file).is_ok_and(|text| text.contains(&quoted)));
        assert!(
            is_given,
            "docs/diagnostics.md lists `{code}`, which nothing gives"
        );
    }
}

/// The string that a text begins with, blanks skipped.
fn literal(text: &str) -> Option<&str> {
    text.trim_start().strip_prefix('"')?.split('"').next()
}

fn sources(folder: &Path) -> Vec<std::path::PathBuf> {
    let mut files = Vec::new();
    for entry in std::fs::read_dir(folder).expect("it is a folder") {
        let path = entry.expect("it can be read").path();
        if path.is_dir() {
            files.extend(sources(&path));
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            files.push(path);
        }
    }
    files
}
