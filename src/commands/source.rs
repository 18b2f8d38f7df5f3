//! Where a scene comes from that is named on the command line.

use std::io::Read as _;
use std::path::Path;

use vitrine::scene::{self, Source};
use vitrine::web::{self, ShaderId};

use super::failure;

/// Finds a scene by its name: a path, `-` for standard input, which is read here, or a shader of the site, which is
/// fetched here, unless it was before and is not to be `refresh`ed.
pub fn source(path: &Path, refresh: bool) -> anyhow::Result<Source> {
    if path == Path::new("-") {
        return standard_input();
    }
    let Some(text) = path.to_str().filter(|_| !path.exists()) else {
        return Ok(Source::Path(path.to_owned()));
    };
    if let Some(id) = shader_id(text) {
        return from_site(&id, refresh);
    }
    match web::is_address(text) {
        true => Err(failure(
            format!("`{text}` is no address of a shader"),
            "one looks like https://www.shadertoy.com/view/4dXGR8; nothing else is fetched",
        )),
        false => Ok(Source::Path(path.to_owned())),
    }
}

/// Whether a scene of this name is not read from a file.
pub fn comes_from_outside(path: &Path) -> bool {
    path == Path::new("-") || (!path.exists() && path.to_str().and_then(shader_id).is_some())
}

fn shader_id(text: &str) -> Option<ShaderId> {
    ShaderId::from_address(text).or_else(|| ShaderId::from_word(text))
}

fn standard_input() -> anyhow::Result<Source> {
    let mut bytes = Vec::new();
    std::io::stdin()
        .take(scene::MAX_BYTES + 1)
        .read_to_end(&mut bytes)
        .map_err(|error| failure(format!("cannot read standard input: {error}"), ""))?;
    Ok(Source::Text {
        name: "<stdin>".to_owned(),
        bytes,
    })
}

#[cfg(not(feature = "web"))]
fn from_site(id: &ShaderId, _refresh: bool) -> anyhow::Result<Source> {
    Err(failure(
        format!(
            "there is no file `{}`, and this program was built without the feature `web`, which fetches shaders",
            id.as_str()
        ),
        &id.by_hand(),
    ))
}

#[cfg(feature = "web")]
fn from_site(id: &ShaderId, refresh: bool) -> anyhow::Result<Source> {
    use vitrine::{config, report};

    let cache = config::cache().map(|folder| web::Cache::within(&folder));
    if !refresh && let Some(answer) = cache.as_ref().and_then(|cache| cache.get(id)) {
        return Ok(id.source(answer));
    }
    let complain = |error: web::WebError| {
        let message = format!("no shader `{}`: {error}", id.as_str());
        failure(message, &error.hint(id))
    };
    let base = std::env::var("VITRINE_API_URL").unwrap_or_else(|_| web::Site::BASE.to_owned());
    let site = web::Site::new(&base, &key(id)?, web::Site::TIMEOUT).map_err(complain)?;
    let answer = site.fetch(id).map_err(complain)?;
    if let Some(Err(error)) = cache.map(|cache| cache.keep(id, &answer)) {
        report::tell(format_args!("the shader is not kept for later: {error}"));
    }
    Ok(id.source(answer))
}

/// The user's own key.
#[cfg(feature = "web")]
fn key(id: &ShaderId) -> anyhow::Result<String> {
    use vitrine::config;

    const VARIABLE: &str = "SHADERTOY_API_KEY";
    let given = std::env::var(VARIABLE).ok().filter(|key| !key.is_empty());
    if let Some(key) = given {
        return Ok(key);
    }
    let config = super::media::configured()?;
    config.api_key.ok_or_else(|| {
        let file = config::path().map_or_else(String::new, |path| {
            format!(", or `api_key = \"…\"` in {}", path.display())
        });
        failure(
            format!(
                "there is no file `{}`, and to fetch a shader from the site needs a key of yours",
                id.as_str()
            ),
            &format!(
                "the site gives one at https://www.shadertoy.com/myapps; set {VARIABLE} to it{file}. \
                 Without one: {}",
                id.by_hand()
            ),
        )
    })
}
