//! Shaders from the site: against a server of the test's own, on this machine. Nothing here reaches any other.

use std::fs;
use std::io::{BufRead as _, BufReader, Write as _};
use std::net::{TcpListener, TcpStream};
use std::sync::{Arc, Mutex};
use std::thread;
use std::time::{Duration, Instant};

use vitrine::web::{ShaderId, Site, WebError};

use crate::support::{Folder, vitrine};

const KEY: &str = "fdKjWm";

const ANSWER: &str = r#"{"Shader":{"ver":"0.1","info":{"id":"4dXGR8","name":"Sea","flags":0},"renderpass":[
    {"inputs":[],"outputs":[{"id":37,"channel":0}],"name":"Image","type":"image",
     "code":"void mainImage(out vec4 c, in vec2 p) { c = vec4(iTime); }"}]}}"#;

/// A server that gives each visitor to `answer`, with the first line of what is asked.
struct Server {
    address: String,
    asked: Arc<Mutex<Vec<String>>>,
}

impl Server {
    fn start(answer: impl Fn(&mut TcpStream, &str) + Send + 'static) -> Self {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        let address = format!("http://{}/api", listener.local_addr().expect("its address"));
        let asked = Arc::new(Mutex::new(Vec::new()));
        let heard = Arc::clone(&asked);
        // It ends with the tests.
        thread::spawn(move || {
            for stream in listener.incoming() {
                let mut stream = stream.expect("a visitor");
                let reader = BufReader::new(stream.try_clone().expect("a second hand"));
                let mut lines = reader.lines().map_while(Result::ok);
                let first = lines.next().unwrap_or_default();
                // All of it is read, or closing would take the answer away.
                lines.find(String::is_empty);
                heard.lock().expect("no panic").push(first.clone());
                answer(&mut stream, &first);
            }
        });
        Server { address, asked }
    }

    /// Answers everyone alike.
    fn says(status: &str, headers: &str, body: &str) -> Self {
        let length = body.len();
        let text = format!(
            "HTTP/1.1 {status}\r\nConnection: close\r\nContent-Length: {length}\r\n{headers}\r\n{body}"
        );
        Server::start(move |stream, _| {
            let _ = stream.write_all(text.as_bytes());
        })
    }

    fn asked(&self) -> Vec<String> {
        self.asked.lock().expect("no panic").clone()
    }

    fn fetch(&self) -> Result<Vec<u8>, WebError> {
        let id = ShaderId::from_word("4dXGR8").expect("an id");
        let site = Site::new(&self.address, KEY, Duration::from_millis(1500));
        let result = site.expect("a key").fetch(&id);
        if let Err(error) = &result {
            let told = format!("{error} {error:?} {}", error.hint(&id));
            assert!(!told.contains(KEY), "the key is told: {told}");
        }
        result
    }

    /// Runs the program with this as the site, and its folders in `home`.
    fn run(&self, home: &Folder, key: Option<&str>, arguments: &str) -> crate::support::Outcome {
        let mut program = vitrine(arguments).within(home.path());
        let command = &mut program.command;
        command.env("VITRINE_API_URL", &self.address);
        for (name, folder) in [
            ("HOME", ""),
            ("XDG_CONFIG_HOME", "config"),
            ("XDG_CACHE_HOME", "cache"),
            ("APPDATA", "config"),
            ("LOCALAPPDATA", "cache"),
        ] {
            command.env(name, home.path().join(folder));
        }
        if let Some(key) = key {
            command.env("SHADERTOY_API_KEY", key);
        }
        let outcome = program.run();
        assert!(!outcome.stderr.contains(KEY), "{}", outcome.stderr);
        outcome
    }
}

#[test]
fn a_shader_comes_from_the_site_once() {
    let server = Server::says("200 OK", "Content-Type: application/json\r\n", ANSWER);
    let home = Folder::new();
    let run = |key, arguments: &str| server.run(&home, key, arguments);
    run(Some(KEY), "check 4dXGR8").exits(0).says("4dXGR8: fine");
    let asked = "GET /api/shaders/4dXGR8?key=fdKjWm HTTP/1.1";
    assert_eq!(server.asked(), [asked]);
    // From now on it is here, whatever it is called and without a key.
    let text = run(None, "inspect https://www.shadertoy.com/view/4dXGR8")
        .exits(0)
        .text();
    assert!(text.contains("Sea, pass Image"), "{text}");
    run(None, "check 4dXGR8 --jobs 2")
        .exits(0)
        .says("4dXGR8: fine");
    assert_eq!(server.asked().len(), 1);
    run(Some(KEY), "check 4dXGR8 --refresh").exits(0);
    assert_eq!(server.asked().len(), 2);
    // A file of that name comes first.
    home.write("4dXGR8", "float f(");
    run(Some(KEY), "check 4dXGR8").exits(1).says("4dXGR8:1");
    assert_eq!(server.asked().len(), 2);
}

#[test]
fn without_a_key_nothing_is_asked() {
    let server = Server::says("200 OK", "", ANSWER);
    let home = Folder::new();
    let outcome = server.run(&home, None, "inspect 4dXGR8");
    outcome
        .exits(2)
        .says("there is no file `4dXGR8`")
        .says("https://www.shadertoy.com/myapps")
        .says("SHADERTOY_API_KEY")
        .says("Ctrl+V");
    server
        .run(&home, Some("a b"), "inspect 4dXGR8")
        .exits(2)
        .says("letters and digits only");
    // What is no id, and what is another site's.
    server
        .run(&home, Some(KEY), "inspect canyon")
        .exits(2)
        .says("cannot read `canyon`");
    let elsewhere = "inspect https://example.org/view/4dXGR8";
    server
        .run(&home, Some(KEY), elsewhere)
        .exits(2)
        .says("no address of a shader");
    assert!(server.asked().is_empty(), "{:?}", server.asked());
    assert!(home.files().is_empty(), "{:?}", home.files());
}

#[cfg(target_os = "linux")]
#[test]
fn the_key_may_lie_in_the_configuration() {
    let server = Server::says("200 OK", "", ANSWER);
    let home = Folder::with(
        "config/vitrine/config.toml",
        format!("api_key = \"{KEY}\"\n"),
    );
    server.run(&home, None, "check 4dXGR8").exits(0);
    assert_eq!(
        home.files(),
        [
            "cache/vitrine/shaders/4dXGR8.json",
            "config/vitrine/config.toml"
        ]
    );
    home.write(
        "config/vitrine/config.toml",
        format!("apikey = \"{KEY}\"\n"),
    );
    let outcome = server.run(&home, None, "inspect 4dXGR8 --refresh");
    outcome
        .exits(2)
        .says("config.toml`, line 1: unknown field `apikey`");
    assert_eq!(server.asked().len(), 1);
}

#[test]
fn a_cache_that_cannot_be_written_is_told_and_no_more() {
    let server = Server::says("200 OK", "", ANSWER);
    let home = Folder::with("cache", "a file where the folder should be");
    if cfg!(target_os = "linux") {
        server
            .run(&home, Some(KEY), "check 4dXGR8")
            .exits(0)
            .says("not kept for later");
    }
    assert_eq!(
        fs::read(home.path().join("cache"))
            .expect("it is left alone")
            .len(),
        33
    );
}

#[test]
fn what_the_site_says_is_explained() {
    let server = Server::says("200 OK", "", r#"{"Error":"Shader not found"}"#);
    assert!(matches!(server.fetch(), Err(WebError::NotFound { .. })));
    server
        .run(&Folder::new(), Some(KEY), "inspect 4dXGR8")
        .exits(2)
        .says("the site gives programs no shader `4dXGR8`")
        .says("\"public + API\"")
        .says("https://www.shadertoy.com/view/4dXGR8");
    let refusal = format!("{{\"Error\":\"Invalid\\u001b key {KEY}\"}}");
    match Server::says("200 OK", "", &refusal).fetch() {
        Err(WebError::Refused(words)) => assert_eq!(words, "Invalid  key …"),
        other => panic!("{other:?}"),
    }
    let page = "<!DOCTYPE html><title>Just a moment...</title>";
    for status in ["403 Forbidden", "503 Service Unavailable", "200 OK"] {
        let server = Server::says(status, "Content-Type: text/html\r\n", page);
        assert!(
            matches!(server.fetch(), Err(WebError::Challenge)),
            "{status}"
        );
    }
    for body in ["", "[]", "{}", "{\"Shader\":5}", "no JSON", "\u{feff}"] {
        let result = Server::says("200 OK", "", body).fetch();
        assert!(
            matches!(result, Err(WebError::NoShader)),
            "{body}: {result:?}"
        );
    }
    let result = Server::says("500 Oops", "", "{}").fetch();
    assert!(matches!(result, Err(WebError::Status(500))), "{result:?}");
}

#[test]
fn redirects_are_followed_to_the_same_host_alone() {
    let there = Server::start(|stream, first| {
        let text = match first.contains("/b") {
            false => "HTTP/1.1 302 Found\r\nConnection: close\r\nContent-Length: 0\r\nLocation: /b\r\n\r\n".to_owned(),
            true => format!("HTTP/1.1 200 OK\r\nConnection: close\r\nContent-Length: {}\r\n\r\n{ANSWER}", ANSWER.len()),
        };
        let _ = stream.write_all(text.as_bytes());
    });
    assert_eq!(there.fetch().expect("an answer"), ANSWER.as_bytes());
    assert_eq!(there.asked().len(), 2);

    let other = Server::says("200 OK", "", ANSWER);
    for location in [
        other.address.as_str(),
        "https://127.0.0.1/b",
        "//127.0.0.1/b",
        "nowhere",
    ] {
        let server = Server::says("302 Found", &format!("Location: {location}\r\n"), "");
        assert!(
            matches!(server.fetch(), Err(WebError::Elsewhere)),
            "{location}"
        );
    }
    assert!(other.asked().is_empty());

    let round = Server::says("302 Found", "Location: /again\r\n", "");
    assert!(matches!(round.fetch(), Err(WebError::Elsewhere)));
    assert_eq!(round.asked().len(), 4);
}

#[test]
fn a_site_that_does_not_answer_is_given_up() {
    let silent = Server::start(|stream, _| {
        let _ = stream.write_all(b"HTTP/1.1 200 OK\r\n");
        thread::sleep(Duration::from_secs(5));
    });
    let began = Instant::now();
    let result = silent.fetch();
    assert!(matches!(result, Err(WebError::Timeout(_))), "{result:?}");
    assert!(
        began.elapsed() < Duration::from_secs(4),
        "{:?}",
        began.elapsed()
    );

    // One drop at a time.
    let slow = Server::start(|stream, _| {
        let _ = stream.write_all(b"HTTP/1.1 200 OK\r\nContent-Length: 100000\r\n\r\n");
        for _ in 0..50 {
            let _ = stream.write_all(b" ");
            thread::sleep(Duration::from_millis(100));
        }
    });
    let result = slow.fetch();
    assert!(matches!(result, Err(WebError::Timeout(_))), "{result:?}");

    let endless = Server::start(|stream, _| {
        let _ = stream.write_all(b"HTTP/1.1 200 OK\r\nConnection: close\r\n\r\n");
        while stream.write_all(&[b' '; 65_536]).is_ok() {}
    });
    let id = ShaderId::from_word("4dXGR8").expect("an id");
    let site = Site::new(&endless.address, KEY, Duration::from_secs(60)).expect("a key");
    assert!(matches!(site.fetch(&id), Err(WebError::TooLarge)));
}

#[test]
fn a_site_that_is_not_there_is_told() {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let address = format!("http://{}", listener.local_addr().expect("its address"));
    drop(listener);
    for base in [
        address.as_str(),
        "http://",
        "nonsense",
        "http://[",
        "ftp://127.0.0.1",
    ] {
        let id = ShaderId::from_word("4dXGR8").expect("an id");
        let site = Site::new(base, KEY, Duration::from_secs(5)).expect("a key");
        match site.fetch(&id) {
            Err(error @ WebError::Unreachable(_)) => {
                assert!(!error.to_string().contains(KEY), "{error}");
            }
            other => panic!("{base}: {other:?}"),
        }
    }
    let babble = Server::start(|stream, _| {
        let _ = stream.write_all(b"220 mail.example.org ESMTP\r\n");
    });
    let result = babble.fetch();
    assert!(
        matches!(result, Err(WebError::Unreachable(_))),
        "{result:?}"
    );
}
