//! The scenes hold the code that they grew from, token for token, and shared functions stand once.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;

use vitrine::scene::{self, Source};

use crate::support::repository;

/// Scene and a seed that stands in it as one run of tokens.
const VARIANTS: [(&str, &str); 43] = [
    ("refinement", "bisect"),
    ("relaxation", "relax"),
    ("sign_flip", "sign_flip"),
    ("canyon", "canyon"),
    ("erosion", "erosion"),
    ("clouds", "clouds"),
    ("dither", "dither"),
    ("tiers", "levels"),
    ("objects", "grid"),
    ("sphere", "sphere"),
    ("sphere", "sphere_march"),
    ("sphere", "sdf_normal"),
    ("sphere", "diffuse"),
    ("union", "union"),
    ("union", "smoothmin"),
    ("blobs", "smoothmin"),
    ("motion", "moved"),
    ("motion", "rotated"),
    ("motion", "scaled"),
    ("repetition", "repeat"),
    ("menger", "box_and_cross"),
    ("perlin", "perlin"),
    ("derivatives", "noise_texture"),
    ("derivatives", "derivatives"),
    ("haze", "noise_texture"),
    ("haze", "derivatives"),
    ("haze", "fog"),
    ("haze", "haze"),
    ("mars", "noise_texture"),
    ("mars", "derivatives"),
    ("even_march", "cast_even"),
    ("even_march", "shade_even"),
    ("even_march", "normalised_fbm"),
    ("even_march", "fbm_terrain"),
    ("even_march", "blend"),
    ("even_march", "sun"),
    ("growing_march", "cast_growing"),
    ("growing_march", "normalised_fbm"),
    ("growing_march", "fbm_terrain"),
    ("growing_march", "blend"),
    ("growing_march", "sun"),
    ("lipschitz", "heightfield_distance"),
    ("lipschitz", "sphere_distance"),
];

/// Shorter bodies, a plain call say, are not worth sharing.
const SHORT_BODY: usize = 16;

#[test]
fn the_template_is_its_seed() {
    let (scene, seed) = (scene_tokens("template"), seed_tokens("template"));
    let first = scene.iter().zip(&seed).position(|(a, b)| a != b);
    let first = first.unwrap_or(scene.len().min(seed.len()));
    let around = |tokens: &[String]| {
        tokens[first.saturating_sub(8)..]
            .iter()
            .take(16)
            .cloned()
            .collect::<Vec<_>>()
    };
    assert!(
        scene == seed,
        "they part at token {first}:\nscene {:?}\nseed  {:?}",
        around(&scene),
        around(&seed)
    );
}

#[test]
fn every_variant_holds_its_seed_in_one_piece() {
    for (folder, seed_name) in VARIANTS {
        let (scene, seed) = (scene_tokens(folder), seed_tokens(seed_name));
        assert!(!seed.is_empty(), "{seed_name}");
        let found = scene.windows(seed.len()).any(|window| window == seed);
        assert!(
            found,
            "shadertoy/{folder} does not hold tests/seeds/{seed_name}.glsl"
        );
    }
}

#[test]
fn every_seed_stands_in_a_scene() {
    let used = VARIANTS.iter().map(|(_, seed)| *seed).chain(["template"]);
    let used: BTreeSet<String> = used.map(|seed| format!("{seed}.glsl")).collect();
    let seeds = fs::read_dir(repository("tests/seeds")).expect("the seeds");
    let seeds = seeds.map(|entry| entry.expect("an entry").file_name());
    let seeds = seeds.map(|name| name.to_string_lossy().into_owned());
    assert_eq!(seeds.collect::<BTreeSet<_>>(), used);
}

#[test]
fn no_function_stands_in_two_files() {
    let mut seen: BTreeMap<Vec<String>, String> = BTreeMap::new();
    for (name, text) in all_scene_files() {
        for body in bodies(&tokens(&text)) {
            if body.len() < SHORT_BODY {
                continue;
            }
            if let Some(other) = seen.insert(body.to_vec(), name.clone()) {
                panic!("{other} and {name} both hold `{}`", body.join(" "));
            }
        }
    }
}

fn seed_tokens(name: &str) -> Vec<String> {
    let path = repository("tests/seeds").join(format!("{name}.glsl"));
    tokens(&fs::read_to_string(path).expect("a seed"))
}

/// The tokens of everything that a scene's Image pass is made of, in order.
fn scene_tokens(name: &str) -> Vec<String> {
    let folder = repository("shadertoy").join(name);
    let scene = scene::load(&Source::Path(folder)).expect("a scene");
    let sources = scene.image().sources.iter();
    sources
        .flat_map(|&file| tokens(&scene.files.get(file).text))
        .collect()
}

/// Every GLSL file below `shadertoy`, as name and text.
fn all_scene_files() -> Vec<(String, String)> {
    let mut files = Vec::new();
    for folder in fs::read_dir(repository("shadertoy")).expect("the scenes") {
        for file in fs::read_dir(folder.expect("an entry").path()).expect("a folder") {
            let path = file.expect("an entry").path();
            if path.extension().is_some_and(|ending| ending == "glsl") {
                let text = fs::read_to_string(&path).expect("a text");
                files.push((path.display().to_string(), text));
            }
        }
    }
    files.sort();
    files
}

/// The outermost `{ … }` that follow a `)`.
fn bodies(tokens: &[String]) -> Vec<&[String]> {
    let mut found = Vec::new();
    let (mut depth, mut start) = (0, 0);
    for (at, token) in tokens.iter().enumerate() {
        match token.as_str() {
            "{" => {
                if depth == 0 {
                    start = at;
                }
                depth += 1;
            }
            "}" => {
                depth -= 1;
                if depth == 0 && start > 0 && tokens[start - 1] == ")" {
                    found.push(&tokens[start + 1..at]);
                }
            }
            _ => {}
        }
    }
    found
}

/// Words, numbers and operators, without comments. Blanks mean nothing to GLSL, except that a line
/// end closes a directive: there it is a token.
fn tokens(text: &str) -> Vec<String> {
    const PAIRS: [&str; 13] = [
        "++", "--", "+=", "-=", "*=", "/=", "<=", ">=", "==", "!=", "&&", "||", "^^",
    ];
    let text = without_comments(text);
    let mut tokens = Vec::new();
    let mut in_directive = false;
    let mut rest = text.as_str();
    while let Some(first) = rest.chars().next() {
        let word = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let number = |c: char| c.is_ascii_alphanumeric() || c == '.';
        let behind_dot = rest[1.min(rest.len())..].starts_with(|c: char| c.is_ascii_digit());
        let length = if first.is_ascii_digit() || (first == '.' && behind_dot) {
            rest.find(|c| !number(c)).unwrap_or(rest.len())
        } else if word(first) {
            rest.find(|c| !word(c)).unwrap_or(rest.len())
        } else if PAIRS.iter().any(|pair| rest.starts_with(pair)) {
            2
        } else {
            first.len_utf8()
        };
        let (token, behind) = rest.split_at(length);
        rest = behind;
        in_directive |= token == "#";
        if first == '\n' && in_directive {
            tokens.push("line end".to_owned());
            in_directive = false;
        } else if !first.is_whitespace() {
            tokens.push(token.to_owned());
        }
    }
    tokens
}

fn without_comments(text: &str) -> String {
    let mut kept = String::new();
    let mut rest = text;
    while let Some(at) = rest.find('/') {
        let (before, comment) = rest.split_at(at);
        kept.push_str(before);
        rest = if comment.starts_with("//") {
            comment.find('\n').map_or("", |end| &comment[end..])
        } else if comment.starts_with("/*") {
            kept.push(' ');
            comment.split_once("*/").map_or("", |(_, behind)| behind)
        } else {
            kept.push('/');
            &comment[1..]
        };
    }
    kept + rest
}

#[test]
fn tokens_are_cut_as_glsl_cuts_them() {
    let cut = |text| tokens(text).join(" ");
    assert_eq!(cut("a+=1.5e3;/* b */c // d\n++e"), "a += 1.5e3 ; c ++ e");
    assert_eq!(
        cut("#define A .5 // b\nx/y"),
        "# define A .5 line end x / y"
    );
}
