use std::io;
use std::time::{Duration, Instant};

use serde_json::Value;
use ureq::http::Uri;
use ureq::{Agent, Error};

use super::ShaderId;
use crate::scene::MAX_BYTES;

/// How often the site may send us on.
const MAX_REDIRECTS: u32 = 3;

/// The most that is shown of what the site says.
const MAX_SAYING: usize = 200;

/// The site's public interface, and the key with which it is asked.
#[derive(Clone)]
pub struct Site {
    base: String,
    key: String,
    timeout: Duration,
}

impl std::fmt::Debug for Site {
    /// The key is nobody else's business.
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Site")
            .field("base", &self.base)
            .finish_non_exhaustive()
    }
}

/// Why there is no answer. No message holds the key.
#[derive(Debug, thiserror::Error)]
pub enum WebError {
    /// The key cannot be one.
    #[error("the key to the site's interface is none: it has letters and digits only")]
    Key,
    /// The site has no such shader for programs.
    #[error("the site gives programs no shader `{id}`")]
    NotFound {
        /// The shader.
        id: String,
    },
    /// The site refuses for another reason.
    #[error("the site answers: {0}")]
    Refused(String),
    /// The site wants to see a browser.
    #[error("the site answers with a page for browsers, to keep programs out")]
    Challenge,
    /// The site answers with an error of HTTP.
    #[error("the site answers with status {0}")]
    Status(u16),
    /// The answer is no shader.
    #[error("the site's answer is no shader")]
    NoShader,
    /// The answer does not end.
    #[error("the site's answer is larger than {} MiB", MAX_BYTES >> 20)]
    TooLarge,
    /// The site sends us elsewhere.
    #[error("the site sends its visitors to another place, where the key has no business")]
    Elsewhere,
    /// The site takes too long.
    #[error("the site has not answered within {} s", .0.as_secs())]
    Timeout(Duration),
    /// The site is not there.
    #[error("the site cannot be reached: {0}")]
    Unreachable(String),
}

impl Site {
    /// Where the site's interface is.
    pub const BASE: &str = "https://www.shadertoy.com/api/v1";

    /// How long the site may take.
    pub const TIMEOUT: Duration = Duration::from_secs(10);

    /// The interface below this address.
    pub fn new(base: &str, key: &str, timeout: Duration) -> Result<Self, WebError> {
        // It becomes part of an address.
        if key.is_empty() || !key.bytes().all(|byte| byte.is_ascii_alphanumeric()) {
            return Err(WebError::Key);
        }
        Ok(Site {
            base: base.trim_end_matches('/').to_owned(),
            key: key.to_owned(),
            timeout,
        })
    }

    /// Asks for a shader, and returns the answer as it came.
    pub fn fetch(&self, id: &ShaderId) -> Result<Vec<u8>, WebError> {
        let address = format!("{}/shaders/{}?key={}", self.base, id.as_str(), self.key);
        let address = address.parse::<Uri>();
        let mut uri = address.map_err(|_| unreachable("its address is none"))?;
        let began = Instant::now();
        for _ in 0..=MAX_REDIRECTS {
            let left = self.timeout.saturating_sub(began.elapsed());
            match self.ask(&uri, left.max(Duration::from_millis(1)))? {
                Answer::Body(body) => return self.judge(id, body),
                Answer::Redirect(next) => uri = next,
            }
        }
        Err(WebError::Elsewhere)
    }

    fn ask(&self, uri: &Uri, timeout: Duration) -> Result<Answer, WebError> {
        // Redirects are followed here, so that the key stays with the host that it was given for.
        let agent: Agent = Agent::config_builder()
            .timeout_global(Some(timeout))
            .max_redirects(0)
            .max_redirects_will_error(false)
            .http_status_as_error(false)
            .user_agent(concat!("vitrine/", env!("CARGO_PKG_VERSION")))
            .build()
            .into();
        let answer = agent.get(uri).header("accept", "application/json").call();
        let mut answer = answer.map_err(|error| self.failure(error))?;
        let status = answer.status();
        if status.is_redirection() {
            let location = answer.headers().get("location");
            let location = location.and_then(|location| location.to_str().ok());
            let next = location.and_then(|location| within_site(uri, location));
            return next.map(Answer::Redirect).ok_or(WebError::Elsewhere);
        }
        match status.as_u16() {
            403 | 503 => return Err(WebError::Challenge),
            _ if status.is_success() => {}
            code => return Err(WebError::Status(code)),
        }
        let body = answer.body_mut().with_config().limit(MAX_BYTES);
        let body = body.read_to_vec().map_err(|error| self.failure(error))?;
        Ok(Answer::Body(body))
    }

    /// What an answer means.
    fn judge(&self, id: &ShaderId, body: Vec<u8>) -> Result<Vec<u8>, WebError> {
        if body.trim_ascii_start().starts_with(b"<") {
            return Err(WebError::Challenge);
        }
        let answer: Value = serde_json::from_slice(&body).map_err(|_| WebError::NoShader)?;
        if let Some(error) = answer["Error"].as_str() {
            if error.to_ascii_lowercase().contains("not found") {
                let id = id.as_str().to_owned();
                return Err(WebError::NotFound { id });
            }
            // It goes to terminals, which obey control characters.
            let words = error.replace(&self.key, "…").replace(char::is_control, " ");
            return Err(WebError::Refused(words.chars().take(MAX_SAYING).collect()));
        }
        match answer["Shader"].is_object() {
            true => Ok(body),
            false => Err(WebError::NoShader),
        }
    }

    /// What went wrong, in words of our own: those of the library may quote the address, and with it the key.
    fn failure(&self, error: Error) -> WebError {
        match error {
            Error::Timeout(_) => WebError::Timeout(self.timeout),
            Error::BodyExceedsLimit(_) => WebError::TooLarge,
            Error::HostNotFound => unreachable("its name is not known here; is there a network?"),
            Error::Io(error) => match error.kind() {
                io::ErrorKind::TimedOut => WebError::Timeout(self.timeout),
                kind => unreachable(&kind.to_string()),
            },
            Error::Tls(_) | Error::Rustls(_) | Error::Pem(_) | Error::TlsRequired => {
                unreachable("its certificate is not accepted, or there is no safe connection")
            }
            Error::InvalidProxyUrl | Error::ConnectProxyFailed(_) => {
                unreachable("the proxy that the environment names does not take us there")
            }
            Error::Protocol(_) | Error::LargeResponseHeader(..) | Error::BodyStalled => {
                unreachable("what answers there does not speak HTTP")
            }
            _ => unreachable("the connection failed"),
        }
    }
}

enum Answer {
    Body(Vec<u8>),
    Redirect(Uri),
}

fn unreachable(why: &str) -> WebError {
    WebError::Unreachable(why.to_owned())
}

/// Where a redirect leads, if that is the same host in the same manner.
fn within_site(from: &Uri, location: &str) -> Option<Uri> {
    let (scheme, authority) = (from.scheme_str()?, from.authority()?);
    let is_path = location.starts_with('/') && !location.starts_with("//");
    let to: Uri = match is_path {
        true => format!("{scheme}://{authority}{location}").parse().ok()?,
        false => location.parse().ok()?,
    };
    let is_same = to.scheme_str() == Some(scheme) && to.authority() == Some(authority);
    is_same.then_some(to)
}

impl WebError {
    /// What can be done about it.
    pub fn hint(&self, id: &ShaderId) -> String {
        let by_hand = id.by_hand();
        match self {
            WebError::Key => "the site shows it at https://www.shadertoy.com/myapps".to_owned(),
            WebError::NotFound { .. } => format!(
                "it gives programs only shaders that their authors have published as \"public + API\". {by_hand}"
            ),
            WebError::Refused(_) => format!(
                "is the key one of https://www.shadertoy.com/myapps, and still good? {by_hand}"
            ),
            WebError::Timeout(_) | WebError::Unreachable(_) => {
                format!("try again later, or see to the network. {by_hand}")
            }
            _ => by_hand,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn redirects_stay_with_the_host() {
        let from: Uri = "https://www.shadertoy.com/api/v1/shaders/x?key=k"
            .parse()
            .unwrap();
        let to = |location| within_site(&from, location).map(|uri| uri.to_string());
        let there = "https://www.shadertoy.com/b?c=d";
        assert_eq!(to("/b?c=d").as_deref(), Some(there));
        assert_eq!(to(there).as_deref(), Some(there));
        for elsewhere in [
            "http://www.shadertoy.com/b",
            "https://shadertoy.com.example.org/b",
            "https://www.shadertoy.com@example.org/b",
            "https://www.shadertoy.com:8443/b",
            "//example.org/b",
            "b",
            "",
            "\u{7}",
        ] {
            assert_eq!(to(elsewhere), None, "{elsewhere}");
        }
    }

    #[test]
    fn a_key_is_letters_and_digits() {
        for bad in ["", "a b", "k&x=y", "../k", "ä"] {
            assert!(matches!(
                Site::new(Site::BASE, bad, Site::TIMEOUT),
                Err(WebError::Key)
            ));
        }
        let site = Site::new(Site::BASE, "fdKjWm", Site::TIMEOUT).unwrap();
        assert!(!format!("{site:?}").contains("fdKjWm"));
    }
}
