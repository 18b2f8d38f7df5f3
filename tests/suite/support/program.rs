use std::ffi::OsStr;
use std::io::{Read, Write as _};
use std::path::Path;
use std::process::{Command, Stdio};
use std::thread::{self, JoinHandle};
use std::time::{Duration, Instant};

/// Long enough for the slowest command on a slow machine.
const TIME_LIMIT: Duration = Duration::from_secs(60);

/// The program with its arguments, separated by blanks, not yet started. Colours are off.
pub fn vitrine(arguments: &str) -> Program {
    let mut command = Command::new(env!("CARGO_BIN_EXE_vitrine"));
    command.args(arguments.split_whitespace());
    command.env("NO_COLOR", "1");
    // Whoever runs the tests may have one; the tests ask the site for nothing.
    command.env_remove("SHADERTOY_API_KEY");
    command.env("VITRINE_API_URL", "http://127.0.0.1:9");
    Program {
        command,
        input: Vec::new(),
    }
}

pub struct Program {
    pub command: Command,
    input: Vec<u8>,
}

impl Program {
    /// Adds an argument that may hold blanks.
    pub fn arg(mut self, argument: impl AsRef<OsStr>) -> Self {
        self.command.arg(argument);
        self
    }

    /// Runs it in this folder.
    pub fn within(mut self, folder: impl AsRef<Path>) -> Self {
        self.command.current_dir(folder);
        self
    }

    /// Gives it standard input.
    pub fn input(mut self, bytes: impl Into<Vec<u8>>) -> Self {
        self.input = bytes.into();
        self
    }

    /// Runs it to its end. A program that does not end fails the test.
    pub fn run(mut self) -> Outcome {
        let mut child = self
            .command
            .stdin(Stdio::piped())
            .stdout(Stdio::piped())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let mut stdin = child.stdin.take().expect("it is piped");
        let stdout = reader(child.stdout.take().expect("it is piped"));
        let stderr = reader(child.stderr.take().expect("it is piped"));
        // A program that fails early does not read its input.
        let _ = stdin.write_all(&self.input);
        drop(stdin);
        let start = Instant::now();
        let status = loop {
            if let Some(status) = child.try_wait().expect("it can be asked") {
                break status;
            }
            if start.elapsed() > TIME_LIMIT {
                child.kill().expect("it can be ended");
                panic!("{:?} does not end", self.command);
            }
            thread::sleep(Duration::from_millis(3));
        };
        let stderr = stderr.join().expect("the reader does not panic");
        Outcome {
            code: status.code(),
            stdout: stdout.join().expect("the reader does not panic"),
            stderr: String::from_utf8_lossy(&stderr).into_owned(),
        }
    }
}

/// Reads a pipe on another thread, so that the program never waits for its reader.
fn reader(mut pipe: impl Read + Send + 'static) -> JoinHandle<Vec<u8>> {
    thread::spawn(move || {
        let mut bytes = Vec::new();
        pipe.read_to_end(&mut bytes).expect("a pipe can be read");
        bytes
    })
}

/// What became of a run.
pub struct Outcome {
    pub code: Option<i32>,
    pub stdout: Vec<u8>,
    pub stderr: String,
}

impl Outcome {
    /// Standard output as text.
    pub fn text(&self) -> String {
        String::from_utf8(self.stdout.clone()).expect("the output is text")
    }

    /// Holds the exit code against the expected one.
    #[track_caller]
    pub fn exits(&self, code: i32) -> &Self {
        assert_eq!(
            self.code,
            Some(code),
            "the exit code; it said:\n{}",
            self.stderr
        );
        self
    }

    /// Expects standard error to contain these words, spread over lines as they may be.
    #[track_caller]
    pub fn says(&self, words: &str) -> &Self {
        let flat = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(
            flat(&self.stderr).contains(&flat(words)),
            "`{words}` is not in:\n{}",
            self.stderr
        );
        self
    }
}
