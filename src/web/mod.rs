//! Shaders by the name that the site gives them: what is such a name, what was fetched before, and the site's
//! public interface. Nothing here happens unless a scene is named by its id or its address.

mod cache;
#[cfg(feature = "web")]
mod fetch;

pub use cache::Cache;
#[cfg(feature = "web")]
pub use fetch::{Site, WebError};

use crate::scene::Source;

/// How many characters an id has.
const LENGTH: usize = 6;

/// The site's name of a shader: six letters and digits.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ShaderId(String);

impl ShaderId {
    /// An id by itself. A word of lower-case letters alone is none: that is rather the name of a file, mistyped, which nobody
    /// wants to be looked for elsewhere.
    pub fn from_word(text: &str) -> Option<Self> {
        let tells = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit();
        ShaderId::new(text).filter(|id| id.0.contains(tells))
    }

    /// The address of a shader's page: `https://www.shadertoy.com/view/ID`, or `/embed/ID`.
    pub fn from_address(text: &str) -> Option<Self> {
        let (scheme, rest) = text.split_once("://")?;
        let path = rest.split(['?', '#']).next().unwrap_or_default();
        let mut parts = path.trim_end_matches('/').split('/');
        let host = parts.next()?.to_ascii_lowercase();
        let is_site = host == "www.shadertoy.com" || host == "shadertoy.com";
        let is_page = matches!(parts.next(), Some("view" | "embed"));
        let id = ShaderId::new(parts.next()?)?;
        let is_whole = parts.next().is_none() && is_web(scheme);
        (is_site && is_page && is_whole).then_some(id)
    }

    fn new(text: &str) -> Option<Self> {
        let is_id = text.len() == LENGTH && text.bytes().all(|byte| byte.is_ascii_alphanumeric());
        is_id.then(|| ShaderId(text.to_owned()))
    }

    /// The six characters.
    pub fn as_str(&self) -> &str {
        &self.0
    }

    /// The shader's page.
    pub fn address(&self) -> String {
        format!("https://www.shadertoy.com/view/{}", self.0)
    }

    /// How the shader comes here without the site's interface.
    pub fn by_hand(&self) -> String {
        format!(
            "In a browser it is at {}: export its JSON there, or copy its code. `vitrine run FILE` plays a file, \
             `vitrine run -` what comes on standard input, and Ctrl+V in the window what is in the clipboard",
            self.address()
        )
    }

    /// The scene of what the site's interface answered.
    pub fn source(&self, answer: Vec<u8>) -> Source {
        Source::Text {
            name: format!("shadertoy.com/view/{}", self.0),
            bytes: answer,
        }
    }
}

/// Whether a text is some address in the web, and so certainly no file.
pub fn is_address(text: &str) -> bool {
    text.split_once("://")
        .is_some_and(|(scheme, _)| is_web(scheme))
}

fn is_web(scheme: &str) -> bool {
    scheme.eq_ignore_ascii_case("https") || scheme.eq_ignore_ascii_case("http")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn words_and_addresses() {
        let word = |text| ShaderId::from_word(text).map(|id| id.0);
        assert_eq!(word("4dXGR8").as_deref(), Some("4dXGR8"));
        for none in ["canyon", "4dXGR", "4dXGR8a", "4dXG-8", "", "ä4dXG"] {
            assert_eq!(word(none), None, "{none}");
        }
        let address = |text| ShaderId::from_address(text).map(|id| id.0);
        for good in [
            "https://www.shadertoy.com/view/canyon",
            "http://shadertoy.com/embed/canyon?gui=true&t=10",
            "HTTPS://WWW.ShaderToy.com/view/canyon/#comments",
        ] {
            assert_eq!(address(good).as_deref(), Some("canyon"), "{good}");
        }
        for bad in [
            "www.shadertoy.com/view/canyon",
            "https://www.shadertoy.com/user/canyon",
            "https://www.shadertoy.com/view/canyon/x",
            "https://www.shadertoy.com/view/../../x",
            "https://www.shadertoy.com.example.org/view/canyon",
            "https://example.org/www.shadertoy.com/view/canyon",
            "https://someone@www.shadertoy.com/view/canyon",
            "ftp://www.shadertoy.com/view/canyon",
            "https://",
        ] {
            assert_eq!(address(bad), None, "{bad}");
        }
        assert!(is_address("https://example.org"));
        assert!(!is_address("folder/file.glsl") && !is_address("C://view"));
    }
}
