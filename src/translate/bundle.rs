//! `iCh0` to `iCh3`: what the Image pass knows of a channel, as one uniform structure. It holds a sampler, so that a text
//! can do no more with it than to name its members, and those stand elsewhere too: so each becomes what it is.

use super::bindings::{self, Uniform};
use crate::glsl::names::{Name, Names};
use crate::glsl::preprocess::{Kind, Token};
use crate::scene::CHANNELS;
use crate::source::FileId;

/// What the structure of a channel is called.
pub(super) fn name(channel: usize) -> String {
    format!("iCh{channel}")
}

/// Writes `iChannelResolution[0]` for `iCh0.size` and so on, but in the preamble, which declares the structures.
pub(super) fn unbundle(
    tokens: Vec<Token>,
    names: &mut Names,
    preamble: FileId,
    is_bound: impl Fn(usize) -> bool,
) -> Vec<Token> {
    let found: Vec<(usize, Name)> = (0..CHANNELS)
        .filter_map(|channel| Some((channel, names.find(&name(channel))?)))
        .collect();
    if found.is_empty() {
        return tokens;
    }
    let mut written = Vec::with_capacity(tokens.len());
    let mut rest = tokens.as_slice();
    while let [first, behind @ ..] = rest {
        let channel = found.iter().find(|(_, name)| *name == first.spelling);
        let is_authors = first.span.file != preamble;
        let member = match (channel, behind) {
            (Some((channel, _)), [dot, member, ..])
                if is_authors && names.text(dot.spelling) == "." =>
            {
                let bound = is_bound(*channel);
                spelled(*channel, names.text(member.spelling), bound)
            }
            _ => None,
        };
        let Some(member) = member else {
            written.push(*first);
            rest = behind;
            continue;
        };
        written.extend(member.into_iter().map(|(kind, text)| {
            let mut token = *first;
            (token.kind, token.spelling) = (kind, names.intern(&text));
            token
        }));
        rest = &behind[2..];
    }
    written
}

/// What a member of a channel's structure is.
fn spelled(channel: usize, member: &str, is_bound: bool) -> Option<Vec<(Kind, String)>> {
    let element = |uniform: Uniform| {
        vec![
            (Kind::Identifier, uniform.name().to_owned()),
            (Kind::Punctuator, "[".to_owned()),
            (Kind::Number, channel.to_string()),
            (Kind::Punctuator, "]".to_owned()),
        ]
    };
    Some(match member {
        "sampler" => vec![(Kind::Identifier, bindings::channel_name(channel).to_owned())],
        "size" => element(Uniform::ChannelResolution),
        "time" => element(Uniform::ChannelTime),
        "loaded" => vec![(Kind::Number, u8::from(is_bound).to_string())],
        _ => return None,
    })
}
