//! Puts the generated text in front of the author's, and finds the way back from a byte of the
//! whole to a byte of theirs.

use std::collections::HashSet;
use std::fmt::Write as _;
use std::ops::Range;

use super::bindings::{self, Uniform};
use super::scan;
use crate::scene::{CHANNELS, Pass};
use crate::source::{FileId, SourceMap, Span};

/// One text for the front end: the preamble, every Common text, the pass's own, and `main`. (The site
/// puts `main` first, behind a prototype; naga wants callees before their callers.)
pub(super) struct Assembly {
    pub text: String,
    segments: Vec<Segment>,
}

/// A run of the author's bytes.
struct Segment {
    /// Where it stands in the whole.
    whole: Range<usize>,
    file: FileId,
    /// Where it begins in its file: behind the byte-order mark.
    start: usize,
}

impl Assembly {
    /// Assembles a pass; `words` are the identifiers that its texts use.
    pub fn new(files: &SourceMap, pass: &Pass, words: &HashSet<&str>) -> Self {
        let mut text = preamble(words);
        let mut segments = Vec::new();
        for &file in &pass.sources {
            let verbatim = &files.get(file).text;
            let body = verbatim.strip_prefix('\u{feff}').unwrap_or(verbatim);
            let start = text.len();
            text.push_str(body);
            segments.push(Segment {
                whole: start..text.len(),
                file,
                start: verbatim.len() - body.len(),
            });
            text.push('\n');
        }
        text.push_str(MAIN);
        Assembly { text, segments }
    }

    /// The place in the author's files that a range of the whole text stands for; `None` inside
    /// generated text. A range that leaves its file is cut to it.
    pub fn locate(&self, range: Range<usize>) -> Option<Span> {
        let segment = self
            .segments
            .iter()
            .find(|segment| segment.whole.contains(&range.start))?;
        let offset = |at: usize| {
            let inside = at.clamp(segment.whole.start, segment.whole.end);
            (inside - segment.whole.start + segment.start) as u32
        };
        Some(Span {
            file: segment.file,
            start: offset(range.start),
            end: offset(range.end),
        })
    }

    /// The same for a place that naga names.
    pub fn locate_naga(&self, span: naga::Span) -> Option<Span> {
        self.locate(span.to_range()?)
    }

    /// The first character of the author's that GLSL does not know.
    pub fn odd_character(&self) -> Option<Span> {
        self.segments.iter().find_map(|segment| {
            let at = scan::odd_character(&self.text[segment.whole.clone()])?;
            let start = segment.whole.start + at;
            let character = self.text[start..].chars().next()?;
            self.locate(start..start + character.len_utf8())
        })
    }

    /// Where the author first writes a word.
    pub fn find(&self, word: &str) -> Option<Span> {
        self.segments.iter().find_map(|segment| {
            let at = self.text[segment.whole.clone()].find(word)?;
            let start = segment.whole.start + at;
            self.locate(start..start + word.len())
        })
    }

    /// Behind the last visible character of the author's text, where what is missing should have stood.
    pub fn end(&self) -> Option<Span> {
        let segment = self.segments.last()?;
        let visible = self.text[segment.whole.clone()].trim_end().len();
        let end = (visible + segment.start) as u32;
        Some(Span {
            file: segment.file,
            start: end,
            end,
        })
    }
}

/// Calls the author's code. The colour starts at 0 because WebGL clears what an `out` parameter holds
/// on entry; alpha is ignored, as on the site.
///
/// On the site `main` stands ahead of the author's text, whose macros do not reach it.
const MAIN: &str = "\
#undef main
#undef mainImage
#undef void
#undef vec4
#undef gl_FragCoord
void main() {
    vec4 vitrine_out = vec4(0.0);
    mainImage(vitrine_out, gl_FragCoord.xy);
    vitrine_color = vec4(vitrine_out.xyz, 1.0);
}
";

/// Declarations of the uniforms and channels among `words`, and of the output.
fn preamble(words: &HashSet<&str>) -> String {
    let mut text = String::from("#version 450\n#define GL_ES 1\n#define HW_PERFORMANCE 1\n");
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
    use crate::scene::{Source, load};

    fn assembly(text: &str) -> (SourceMap, Assembly) {
        let scene = load(&Source::Text {
            name: "a".to_owned(),
            bytes: text.into(),
        });
        let scene = scene.expect("a scene");
        let words = super::super::scan::scan(scene.image().sources[0], text).words;
        let assembly = Assembly::new(&scene.files, scene.image(), &words);
        (scene.files.clone(), assembly)
    }

    #[test]
    fn only_what_is_used_is_declared() {
        let (_, none) = assembly("float x;");
        assert!(!none.text.contains("uniform"), "{}", none.text);
        let (_, some) = assembly("iTime iChannel2 /* iMouse */");
        assert!(some.text.contains("{ float iTime; }"), "{}", some.text);
        assert!(
            some.text.contains("binding = 5) uniform texture2D"),
            "{}",
            some.text
        );
        assert!(!some.text.contains("iChannel0"), "{}", some.text);
    }

    #[test]
    fn the_authors_text_stands_verbatim_and_can_be_found_again() {
        let (files, assembly) = assembly("\u{feff}a\r\nb");
        let at = assembly.text.find("a\r\nb").expect("verbatim");
        let span = assembly.locate(at + 3..at + 4).expect("the author's");
        let text = &files.get(span.file).text;
        assert_eq!(&text[span.start as usize..span.end as usize], "b");
        assert_eq!(assembly.locate(0..5), None, "generated text is nobody's");
    }

    #[test]
    fn ranges_are_cut_to_their_file() {
        let (files, assembly) = assembly("ab");
        let start = assembly.text.find("ab").expect("verbatim");
        let span = assembly.locate(start..start + 900).expect("the author's");
        assert_eq!(span.end as usize, files.get(span.file).text.len());
    }
}
