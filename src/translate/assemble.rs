//! Puts the generated text around the author's tokens, and finds the way back from a byte of the whole
//! to a place in their files.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::ops::Range;

use super::bindings::{self, Uniform};
use crate::glsl::preprocess::Token;
use crate::scene::CHANNELS;
use crate::source::{SourceMap, Span};

/// One text for naga's front end: the preamble, the author's tokens with macros expanded, and `main`.
/// (The site puts `main` first, behind a prototype; naga wants callees before their callers.)
pub(super) struct Assembly<'a> {
    pub text: String,
    files: &'a SourceMap,
    /// The author's tokens, in the order of the text.
    pieces: Vec<Piece>,
    end: Span,
}

/// Where a token of the author's stands in the whole.
struct Piece {
    whole: Range<usize>,
    span: Span,
}

impl<'a> Assembly<'a> {
    /// Assembles a pass of these tokens; `end` is where its text ends.
    pub fn new(files: &'a SourceMap, tokens: &[Token<'_>], end: Span) -> Self {
        let words = tokens.iter().map(|token| &*token.text).collect();
        let mut text = preamble(&words);
        let mut pieces = Vec::with_capacity(tokens.len());
        for token in tokens {
            let start = text.len();
            text.push_str(&token.text);
            pieces.push(Piece {
                whole: start..text.len(),
                span: token.span,
            });
            text.push(' ');
        }
        text.push('\n');
        text.push_str(MAIN);
        Assembly {
            text,
            files,
            pieces,
            end,
        }
    }

    /// The place in the author's files that a range of the whole text stands for; `None` in generated
    /// text. It runs from the first token to the last, unless macros have brought them from places
    /// that are not in this order: then it is the first token.
    pub fn locate(&self, range: Range<usize>) -> Option<Span> {
        let first = self
            .pieces
            .partition_point(|piece| piece.whole.end <= range.start);
        let behind = self
            .pieces
            .partition_point(|piece| piece.whole.start < range.end);
        let begins_before = range.start < self.pieces.first()?.whole.start;
        let start = self.pieces.get(first).filter(|_| !begins_before)?.span;
        match behind.checked_sub(1).and_then(|last| self.pieces.get(last)) {
            Some(last) if last.span.file == start.file && last.span.end >= start.end => {
                Some(Span {
                    end: last.span.end,
                    ..start
                })
            }
            _ => Some(start),
        }
    }

    /// The same for a place that naga names.
    pub fn locate_naga(&self, span: naga::Span) -> Option<Span> {
        self.locate(span.to_range()?)
    }

    /// What the author wrote there.
    pub fn written(&self, span: Span) -> &'a str {
        let text = &self.files.get(span.file).text;
        text.get(span.start as usize..span.end as usize)
            .unwrap_or_default()
    }

    /// Where the author first writes a word.
    pub fn find(&self, word: &str) -> Option<Span> {
        let is_word = |piece: &&Piece| &self.text[piece.whole.clone()] == word;
        self.pieces.iter().find(is_word).map(|piece| piece.span)
    }

    /// Behind the last visible character of the author's text, where what is missing should have stood.
    pub fn end(&self) -> Span {
        self.end
    }
}

/// Calls the author's code. The colour starts at 0 because WebGL clears what an `out` parameter holds
/// on entry; alpha is ignored, as on the site.
const MAIN: &str = "\
void main() {
    vec4 vitrine_out = vec4(0.0);
    mainImage(vitrine_out, gl_FragCoord.xy);
    vitrine_color = vec4(vitrine_out.xyz, 1.0);
}
";

/// Declarations of the uniforms and channels among `words`, and of the output.
fn preamble(words: &HashSet<&str>) -> String {
    let mut text = String::from("#version 450\n");
    let uniforms: Vec<Uniform> = Uniform::ALL
        .into_iter()
        .filter(|uniform| words.contains(uniform.name()))
        .collect();
    let group = bindings::GROUP;
    if !uniforms.is_empty() {
        let binding = bindings::UNIFORMS;
        let members: String = uniforms
            .iter()
            .map(|uniform| format!("{}; ", uniform.declaration()))
            .collect();
        writeln!(
            text,
            "layout(set = {group}, binding = {binding}, std140) uniform VitrineUniforms {{ {members}}};"
        )
        .expect("strings take all text");
    }
    for channel in (0..CHANNELS).filter(|&c| words.contains(bindings::channel_name(c))) {
        let (texture, sampler) = (bindings::texture(channel), bindings::sampler(channel));
        let name = bindings::channel_name(channel);
        writeln!(
            text,
            "layout(set = {group}, binding = {texture}) uniform texture2D vitrine_texture{channel};\n\
             layout(set = {group}, binding = {sampler}) uniform sampler vitrine_sampler{channel};\n\
             #define {name} sampler2D(vitrine_texture{channel}, vitrine_sampler{channel})"
        )
        .expect("strings take all text");
    }
    text.push_str("layout(location = 0) out vec4 vitrine_color;\n");
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::glsl::preprocess::preprocess;

    /// Assembles a text and hands it to a check.
    fn with_assembly(text: &str, check: impl Fn(&Assembly<'_>)) {
        let mut files = SourceMap::default();
        let file = files.add("a", text);
        let tokens = preprocess(&files, &[file], &[]).tokens;
        check(&Assembly::new(&files, &tokens, files.whole(file)));
    }

    #[test]
    fn only_what_is_used_is_declared() {
        with_assembly("float x;", |assembly| {
            assert!(!assembly.text.contains("uniform"), "{}", assembly.text);
        });
        let text = "iTime iChannel2 /* iMouse */\n#if 0\niDate\n#endif";
        with_assembly(text, |assembly| {
            let text = &assembly.text;
            assert!(text.contains("{ float iTime; }"), "{text}");
            assert!(text.contains("binding = 5) uniform texture2D"), "{text}");
            assert!(!text.contains("iChannel0"), "{text}");
        });
    }

    #[test]
    fn places_are_the_authors() {
        let text = "\u{feff}#define TWO b + c\r\na = /* … */ TWO;";
        with_assembly(text, |assembly| {
            let written = |part: &str| {
                let at = assembly.text.find(part).expect("it is there");
                let span = assembly.locate(at..at + part.len());
                span.map(|span| assembly.written(span))
            };
            assert_eq!(written("a ="), Some("a ="));
            assert_eq!(written("b + c"), Some("b + c"), "in the macro's definition");
            assert_eq!(
                written("a = b"),
                Some("a"),
                "not from the end to the beginning"
            );
            assert_eq!(written("#version"), None, "generated text is nobody's");
            assert_eq!(written("void main"), None);
        });
    }
}
