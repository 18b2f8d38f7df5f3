//! No text makes the program panic, and every complaint points into the author's own text. The cases
//! are the same in every run.

use std::fs;

use vitrine::report;
use vitrine::scene::{self, LoadErrorKind, Source};
use vitrine::source::Report;
use vitrine::translate::{Options, translate};

use crate::support::{Folder, plain, repository};

/// Texts that have broken parsers before.
const NASTY: &[&str] = &[
    "#define A A\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(A); }",
    "#define F(x) F(x)\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(F(1.0)); }",
    "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0 / 0.0, 1 / 0, 1 % 0, 0); }",
    "int a[0]; int b[-1]; int d[2147483647]; void mainImage(out vec4 c, in vec2 p) {}",
    "struct S { S s; }; void mainImage(out vec4 c, in vec2 p) { S s; }",
    "void f(); void g() { f(); } void f() { g(); } void mainImage(out vec4 c, in vec2 p) { f(); }",
    "const int a = -2147483648 / -1; void mainImage(out vec4 c, in vec2 p) { c = vec4(a << 99); }",
    "void mainImage(out vec4 c, in vec2 p) { for (;;) { if (c.x == 9.0) { continue; } } }",
    "void mainImage(out vec4 c, in vec2 p) { switch (1) { default: case 1: case 1: } }",
    "vec4 v = vec4(iTime); void mainImage(out vec4 c, in vec2 p) { c = v.xyzwx; c.rr = p; v[7] = 1.; }",
    "#if 1 / 0\n#elif (\n#else\n#endif\n#line 99999999999\n#pragma \u{e9}\n#",
    "layout(location = 9) in vec3 a; uniform sampler2D b; precision highp float; void main() {}",
    "void mainImage(out vec4 c, in vec2 p) { mat3 m = mat3(1); m[3][3] = m[0].w; c = m * p; }",
    "\u{feff}\u{feff}/**/ // \\\n \u{0}\u{1b}[31m \u{202e} 1e999999 0x 08 1.f.f .. ...",
    "void mainImage(out vec4 c, in vec2 p) { return c; } float f() { } int g() { return 1.0; }",
    "#define B(a, b) a ## b\nvoid mainImage(out vec4 c, in vec2 p) { c = vec4(B(1, .0), B(, ), B((, ))); }",
];

/// Xorshift64 (Marsaglia, "Xorshift RNGs", 2003).
struct Random(u64);

impl Random {
    fn below(&mut self, limit: usize) -> usize {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 % limit.max(1) as u64) as usize
    }
}

/// Changes a few places: bytes and tokens removed, doubled, replaced, swapped.
fn mutated(text: &str, random: &mut Random) -> Vec<u8> {
    const SCRAPS: &[&str] = &[
        "{",
        "}",
        "(",
        ")",
        ";",
        ",",
        "#",
        "/*",
        "\\\n",
        "\"",
        "[",
        "0",
        "1e39",
        "iTime",
        "vec3",
        "=",
        "\u{e4}",
        "\0",
        "\r",
        "else",
        "#define x",
        "#if",
        "struct",
        "in",
        "sampler2D",
        "-",
        "?",
        ".x",
    ];
    let mut bytes = text.as_bytes().to_vec();
    for _ in 0..1 + random.below(4) {
        let at = random.below(bytes.len() + 1);
        let end = (at + random.below(20)).min(bytes.len());
        match random.below(5) {
            0 => drop(bytes.drain(at..end)),
            1 => {
                let copy = bytes[at..end].to_vec();
                let to = random.below(bytes.len() + 1);
                bytes.splice(to..to, copy);
            }
            2 if at < bytes.len() => bytes[at] = random.below(256) as u8,
            3 => bytes.truncate(at),
            _ => drop(bytes.splice(at..at, SCRAPS[random.below(SCRAPS.len())].bytes())),
        }
    }
    bytes
}

/// Loads and translates, and checks whatever comes of it.
fn try_text(bytes: &[u8]) {
    let source = Source::Text {
        name: "fuzz.glsl".to_owned(),
        bytes: bytes.to_vec(),
    };
    let text = String::from_utf8_lossy(bytes);
    match scene::load(&source).map(|scene| translate(&scene, &Options::default())) {
        Ok(Ok(programs)) => assert_eq!(programs.len(), 1),
        Ok(Err(report)) => assert_sound(&report, &text),
        Err(error) => match error.kind {
            LoadErrorKind::Scene(report) => assert_sound(&report, &text),
            LoadErrorKind::Io { .. } => panic!("no file is read"),
        },
    }
}

fn assert_sound(report: &Report, text: &str) {
    assert!(report.has_errors(), "a failure without an error: {text}");
    for diagnostic in &report.diagnostics {
        assert!(!diagnostic.message.trim().is_empty(), "no message: {text}");
        let Some(span) = diagnostic.span else {
            continue;
        };
        let file = &report.files.get(span.file).text;
        let marked = file.get(span.start as usize..span.end as usize);
        assert!(marked.is_some(), "{diagnostic:?} marks no part of: {text}");
    }
    // What a terminal would obey stays out of what is shown.
    let shown = plain(report);
    assert!(
        !shown.chars().any(|c| c.is_control() && c != '\n'),
        "{shown:?}"
    );
    assert_eq!(
        report::json(report).lines().count(),
        report.diagnostics.len()
    );
}

#[test]
fn broken_texts_are_refused_with_a_place() {
    let mut random = Random(0x5eed);
    let seeds = fs::read_dir(repository("tests/seeds")).expect("the seeds");
    let mut paths: Vec<_> = seeds.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    for path in paths {
        let text = fs::read_to_string(&path).expect("a seed");
        for _ in 0..30 {
            try_text(&mutated(&text, &mut random));
        }
    }
    for text in NASTY {
        try_text(text.as_bytes());
        for _ in 0..12 {
            try_text(&mutated(text, &mut random));
        }
    }
}

#[test]
fn random_bytes_are_refused_with_a_place() {
    let mut random = Random(0xb17e5);
    for length in 0..60 {
        let any: Vec<u8> = (0..length).map(|_| random.below(256) as u8).collect();
        try_text(&any);
        let printable: Vec<u8> = (0..4 * length)
            .map(|_| 32 + random.below(95) as u8)
            .collect();
        try_text(&printable);
    }
}

#[test]
fn broken_manifests_are_refused_with_a_place() {
    let manifest =
        fs::read_to_string(repository("shadertoy/canyon/scene.toml")).expect("a manifest");
    let mut random = Random(0x7031);
    let folder = Folder::new();
    for _ in 0..150 {
        folder.write("scene.toml", mutated(&manifest, &mut random));
        match scene::load(&Source::Path(folder.path().to_owned())) {
            Ok(_) => panic!("its texts do not exist"),
            Err(error) => match error.kind {
                LoadErrorKind::Scene(report) => assert_sound(&report, "a manifest"),
                LoadErrorKind::Io { path, error } => panic!("{}: {error}", path.display()),
            },
        }
    }
}

#[cfg(feature = "gpu")]
#[test]
fn patterns_never_panic_and_tell_frames_apart() {
    use vitrine::export::OutPattern;
    let mut random = Random(0xa77e4);
    let scraps = [
        "%", "%d", "%05d", "%%", "d", "0", "9", "21", "frames/", ".png", "\u{e4}", " ", "s",
    ];
    let mut accepted = 0;
    for _ in 0..5_000 {
        let count = random.below(7);
        let text: String = (0..count)
            .map(|_| scraps[random.below(scraps.len())])
            .collect();
        if let Ok(pattern) = OutPattern::parse(&(text + [".png", ""][random.below(2)])) {
            accepted += 1;
            assert_eq!(
                pattern.is_numbered(),
                pattern.path(1) != pattern.path(2_147_483_647)
            );
        }
    }
    assert!(accepted > 100, "only {accepted} patterns were good");
}
