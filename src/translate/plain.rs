//! Plain fragment shaders: texts that draw in a `main` of their own, as tutorials have them.
//!
//! Their hosts agree on nothing, but their names are customary. Each customary name becomes a variable
//! of the preamble that begins as one of ShaderToy's uniforms, in the type that the author declares it
//! with; the author's own declaration of it is dropped, because nobody would set it.

use std::fmt::Write as _;

use super::bindings;
use crate::glsl::names::Names;
use crate::glsl::preprocess::Token;
use crate::scene::{CHANNELS, Pass, PassKind};
use crate::source::{Diagnostic, FileId};

/// Something that the host knows under other names.
struct Custom {
    names: &'static [&'static str],
    /// The types that it may be declared with and its value in each, the usual one first.
    values: &'static [(&'static str, &'static str)],
}

const CUSTOMS: [Custom; 5] = [
    Custom {
        names: &["uTime", "u_time", "time"],
        values: &[("float", "iTime")],
    },
    Custom {
        names: &["uResolution", "u_resolution", "resolution"],
        values: &[("vec2", "iResolution.xy"), ("vec3", "iResolution")],
    },
    Custom {
        names: &["uMouse", "u_mouse", "mouse"],
        values: &[("vec2", "iMouse.xy"), ("vec4", "iMouse")],
    },
    Custom {
        names: &["uFrame", "u_frame"],
        values: &[("int", "iFrame")],
    },
    Custom {
        names: &["vUv", "v_uv"],
        values: &[("vec2", "gl_FragCoord.xy / iResolution.xy")],
    },
];

/// The customary names of each channel's texture.
const TEXTURES: [&[&str]; CHANNELS] = [
    &["uTexture", "u_texture", "uTexture0", "u_texture0"],
    &["uTexture1", "u_texture1"],
    &["uTexture2", "u_texture2"],
    &["uTexture3", "u_texture3"],
];

/// A pass that is a plain fragment shader, and what its author expects of the host.
#[derive(Debug)]
pub(super) struct Plain {
    given: Vec<Given>,
    /// The customary names of textures, with their channels.
    textures: Vec<(&'static str, usize)>,
    /// Whether the author names the colour, as GLSL ES 3.00 has it.
    has_output: bool,
}

/// A customary name that the preamble declares.
#[derive(Debug)]
struct Given {
    name: &'static str,
    ty: &'static str,
    value: &'static str,
}

impl Plain {
    /// Recognises one by its `main` and by the absence of `mainImage`.
    pub(super) fn recognise(pass: &Pass, texts: &[&str]) -> Option<Self> {
        let has_main_image = matches!(pass.kind, PassKind::Image | PassKind::Buffer(_));
        // Most texts have no `main`, and are not looked at any closer.
        if !has_main_image || !texts.iter().any(|text| has_main(text)) {
            return None;
        }
        let text = texts.join("\n");
        let outline = Outline::of(&text);
        let begins_in_main = outline.words.windows(2).any(|two| two == ["void", "main"]);
        // A macro may make another function of what looks like one.
        if outline.mentions("mainImage") || outline.macros.contains(&"main") || !begins_in_main {
            return None;
        }
        let mut given = Vec::new();
        for Custom { names, values } in CUSTOMS {
            for name in names {
                let expected = outline.expected_type(name, values[0].0);
                let value = values.iter().find(|(ty, _)| Some(*ty) == expected);
                given.extend(value.map(|&(ty, value)| Given { name, ty, value }));
            }
        }
        let mut textures = Vec::new();
        for (channel, names) in TEXTURES.iter().enumerate() {
            let is_texture = |name: &&&str| {
                let ty = outline.expected_type(name, "sampler2D");
                ty.is_some_and(|ty| ty.starts_with("sampler"))
            };
            let names = names.iter().filter(is_texture);
            textures.extend(names.map(|&name| (name, channel)));
        }
        Some(Plain {
            given,
            textures,
            has_output: outline.statements.iter().any(|one| one.contains(&"out")),
        })
    }

    /// What stands before the author's text, behind the host's uniforms.
    pub(super) fn preamble(&self) -> String {
        let mut text = String::new();
        for Given { name, ty, value } in &self.given {
            writeln!(text, "{ty} {name} = {value};").expect("strings take all text");
        }
        for &(name, channel) in &self.textures {
            let channel = bindings::channel_name(channel);
            writeln!(text, "#define {name} {channel}").expect("strings take all text");
        }
        if !self.has_output {
            text += "out vec4 shadertoy_out_color;\n#define gl_FragColor shadertoy_out_color\n";
        }
        // Those that are not customary are missed where they are read, as inputs of any other name.
        text + "#define varying in\n"
    }

    /// Drops the author's declarations of what the preamble declares. Directives and macros are gone
    /// by now, and textures have their channels' names.
    pub(super) fn drop_given(&self, tokens: Vec<Token>, names: &Names, host: FileId) -> Vec<Token> {
        let is_given = |name: &str| {
            let is_texture = |&(_, channel): &(_, usize)| bindings::channel_name(channel) == name;
            self.given.iter().any(|one| one.name == name) || self.textures.iter().any(is_texture)
        };
        let text = |token: &Token| names.text(token.spelling);
        let mut kept = Vec::with_capacity(tokens.len());
        let mut depth = 0;
        let mut rest = tokens.into_iter();
        while let Some(token) = rest.next() {
            let is_declaration = matches!(text(&token), "uniform" | "in") && depth == 0;
            depth += depth_change(text(&token));
            if !is_declaration || token.span.file == host {
                kept.push(token);
                continue;
            }
            let mut statement = vec![token];
            for token in rest.by_ref() {
                statement.push(token);
                depth += depth_change(text(&token));
                if matches!(text(&token), ";" | "{") {
                    break;
                }
            }
            let is_comma = |token: &Token| text(token) == ",";
            drop_declarators(&mut statement, |token| is_given(text(token)), is_comma);
            kept.append(&mut statement);
        }
        kept
    }

    /// Whether a finding is about this style. What is only there for want of the site is none.
    pub(super) fn concerns(&self, finding: &Diagnostic, is_authors: bool) -> bool {
        const OLD_STYLE: [&str; 3] = ["old-texture-name", "extension", "version"];
        finding.is_error() || (is_authors && !OLD_STYLE.contains(&finding.code))
    }
}

/// Drops declarators from `uniform vec2 a, b;`: nothing is left once none of them is.
fn drop_declarators(
    statement: &mut Vec<Token>,
    is_given: impl Fn(&Token) -> bool,
    is_comma: impl Fn(&Token) -> bool,
) {
    let count = |what: &dyn Fn(&Token) -> bool| statement.iter().filter(|one| what(one)).count();
    if count(&is_given) == count(&is_comma) + 1 {
        statement.clear();
    }
    let mut kept: Vec<Token> = Vec::with_capacity(statement.len());
    let mut rest = statement.drain(..).peekable();
    while let Some(token) = rest.next() {
        if !is_given(&token) {
            kept.push(token);
        } else if rest.next_if(&is_comma).is_none() && kept.last().is_some_and(&is_comma) {
            // The last has its comma before it.
            kept.pop();
        }
    }
    drop(rest);
    *statement = kept;
}

/// Whether a text has the word `main`, perhaps in a comment.
fn has_main(text: &str) -> bool {
    text.match_indices("main").any(|(at, main)| {
        let behind = text.as_bytes().get(at + main.len());
        !behind.is_some_and(|&byte| byte.is_ascii_alphanumeric() || byte == b'_')
    })
}

fn depth_change(token: &str) -> i32 {
    match token {
        "{" | "(" => 1,
        "}" | ")" => -1,
        _ => 0,
    }
}

/// What can be seen of a text before it is preprocessed: what both branches of an `#if` say, comments
/// left out.
struct Outline<'a> {
    words: Vec<&'a str>,
    /// The words outside of all brackets, cut at semicolons and bodies.
    statements: Vec<Vec<&'a str>>,
    macros: Vec<&'a str>,
}

impl<'a> Outline<'a> {
    fn of(text: &'a str) -> Self {
        let mut outline = Outline {
            words: Vec::new(),
            statements: Vec::new(),
            macros: Vec::new(),
        };
        let mut statement = Vec::new();
        let mut depth = 0;
        let mut rest = text;
        while let Some(first) = rest.chars().next() {
            let is_word = |c: char| c.is_ascii_alphanumeric() || c == '_';
            // Looked for only where it matters: a line may be a million characters long.
            let end_of_line = || rest.find('\n').unwrap_or(rest.len());
            let length = if rest.starts_with("//") {
                end_of_line()
            } else if rest.starts_with("/*") {
                rest.find("*/").map_or(rest.len(), |end| end + 2)
            } else if first == '#' {
                let end = end_of_line();
                let mut words = rest[1..end].split(|c| !is_word(c));
                if words.by_ref().find(|word| !word.is_empty()) == Some("define") {
                    outline.macros.extend(words.next());
                }
                end
            } else {
                let end = rest.find(|c| !is_word(c)).unwrap_or(rest.len());
                end.max(first.len_utf8())
            };
            let (word, behind) = rest.split_at(length);
            rest = behind;
            if word.starts_with('#') || word.starts_with("//") || word.starts_with("/*") {
                continue;
            }
            if !word.trim().is_empty() {
                outline.words.push(word);
            }
            depth += depth_change(word);
            if depth == 0 && is_word(first) {
                statement.push(word);
            } else if depth == 0 && matches!(word, ";" | "}") {
                outline.statements.push(std::mem::take(&mut statement));
            }
        }
        outline
    }

    fn mentions(&self, name: &str) -> bool {
        self.words.contains(&name)
    }

    /// The type that the author expects of a name: as an input declares it, or the usual one where
    /// it is not declared. `None` where it is something else, or is not there at all.
    fn expected_type(&self, name: &str, usual: &'a str) -> Option<&'a str> {
        const INPUTS: [&str; 3] = ["uniform", "varying", "in"];
        const OTHER_QUALIFIERS: [&str; 7] = [
            "highp", "mediump", "lowp", "flat", "smooth", "centroid", "layout",
        ];
        if self.macros.contains(&name) || !self.mentions(name) {
            return None;
        }
        let Some(words) = self.statements.iter().find(|words| words.contains(&name)) else {
            return Some(usual);
        };
        if !words.iter().any(|word| INPUTS.contains(word)) {
            return None;
        }
        let is_type = |word: &&&str| !INPUTS.contains(word) && !OTHER_QUALIFIERS.contains(word);
        words.iter().find(is_type).copied()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::scene::{self, Source};

    fn recognised(text: &str) -> Option<Plain> {
        let scene = scene::load(&Source::Text {
            name: "a".to_owned(),
            bytes: text.into(),
        });
        Plain::recognise(scene.expect("a scene").image(), &[text])
    }

    fn given(text: &str) -> String {
        let plain = recognised(text).expect("a plain fragment shader");
        plain.preamble()
    }

    #[test]
    fn a_main_without_main_image_makes_it_plain() {
        assert!(recognised("void main() {}").is_some());
        assert!(recognised("// mainImage is elsewhere\nvoid\nmain(void) {}").is_some());
        assert!(recognised("void mainImage(out vec4 c, in vec2 p) {}").is_none());
        assert!(recognised("void mainImage(out vec4 c, in vec2 p) {}\nvoid main() {}").is_none());
        assert!(recognised("/* void main() {} */ float f() { return 1.0; }").is_none());
        assert!(recognised("float main() { return 1.0; }").is_none());
        let renamed = "#define main() mainImage(out vec4 c, in vec2 p)\nvoid main() {}";
        assert!(recognised(renamed).is_none());
    }

    #[test]
    fn names_get_the_type_that_they_are_declared_with() {
        let text = given(
            "#ifdef GL_ES\nprecision mediump float;\n#endif\n\
             uniform highp vec3 resolution; uniform float a, u_time; varying vec2 vUv;\n\
             void main() { vec4 c = uMouse.xyxy; }",
        );
        assert_eq!(
            text,
            "float u_time = iTime;\nvec3 resolution = iResolution;\nvec2 uMouse = iMouse.xy;\n\
             vec2 vUv = gl_FragCoord.xy / iResolution.xy;\nout vec4 shadertoy_out_color;\n\
             #define gl_FragColor shadertoy_out_color\n#define varying in\n"
        );
    }

    #[test]
    fn what_the_author_makes_of_a_name_is_left_alone() {
        let text = given(
            "#define u_time 1.0\nuniform int uTime; float time() { return 1.0; }\n\
             layout(location = 0) out vec4 colour; void f(out vec4 c);\nvoid main() {}",
        );
        assert_eq!(text, "#define varying in\n");
    }

    #[test]
    fn textures_have_their_channels() {
        let text = given("uniform sampler2D uTexture, u_texture2; void main() {}");
        assert!(text.contains("#define uTexture iChannel0\n#define u_texture2 iChannel2\n"));
    }
}
