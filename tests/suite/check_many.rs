//! Checking many scenes at once: in order, counted, and whatever one of them does to the program.

use serde_json::{Value, json};

use crate::support::{Folder, vitrine};

const GOOD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(1.0); }\n";
const WARNED: &str = "void mainImage(out vec4 c, in vec2 p) { c = texture(iChannel0, p); }\n";
const BAD: &str = "void mainImage(out vec4 c, in vec2 p) { c = vec4(lost); }\n";

/// Twelve scenes, of which each third is bad.
fn twelve() -> Folder {
    let folder = Folder::new();
    for n in 0..12 {
        let text = [GOOD, WARNED, BAD][n % 3];
        folder.write(&format!("scenes/{n:02}.glsl"), text);
    }
    folder
}

#[test]
fn verdicts_come_in_the_order_of_the_names() {
    let folder = twelve();
    let text = folder
        .run("check scenes --jobs 3 --format json")
        .exits(1)
        .text();
    let lines: Vec<Value> = text
        .lines()
        .map(|line| serde_json::from_str(line).expect("an object a line"))
        .collect();
    assert_eq!(lines.len(), 12);
    for (n, line) in lines.iter().enumerate() {
        let file = line["file"].as_str().expect("a name").replace('\\', "/");
        assert_eq!(file, format!("scenes/{n:02}.glsl"));
        let verdict = ["accept", "accept", "refuse"][n % 3];
        assert_eq!(line["verdict"], verdict, "{line}");
        assert_eq!(line["passes"][0]["verdict"], verdict, "{line}");
    }
}

#[test]
fn people_read_the_same_with_and_without_workers() {
    let folder = twelve();
    let few = folder.run("check scenes/00.glsl scenes/01.glsl scenes/02.glsl");
    let workers = folder.run("check scenes/00.glsl scenes/01.glsl scenes/02.glsl --jobs 2");
    assert_eq!(few.exits(1).stderr, workers.exits(1).stderr);
    assert!(workers.stdout.is_empty());
    workers
        .says("scenes/00.glsl: fine")
        .says("warning[unbound-channel]")
        .says("error[unknown-variable]: `lost` is not declared");
}

#[test]
fn a_summary_counts() {
    let folder = twelve();
    folder.write("list.txt", "scenes\nscenes/00.glsl\n\ngone.glsl\n");
    let outcome = folder.run("check --list list.txt --summary");
    let table = outcome.exits(2).text();
    let rows: Vec<Vec<&str>> = table
        .lines()
        .map(|l| l.split_whitespace().collect())
        .collect();
    let expected = [
        "accepted 9",
        "with warnings 4",
        "refused 4",
        "unknown-variable 4",
        "could not be read 1",
        "cut off 0",
        "all 14",
    ];
    assert_eq!(
        rows.iter().map(|row| row.join(" ")).collect::<Vec<_>>(),
        expected
    );
    outcome.says("cannot read `gone.glsl`");
    assert!(!outcome.stderr.contains("fine"), "{}", outcome.stderr);

    let outcome = folder.run("check scenes --summary --format json");
    let counts: Value = serde_json::from_str(&outcome.exits(1).text()).expect("an object");
    let expected = json!({
        "files": 12, "accepted": 8, "with_warnings": 4, "refused": 4,
        "codes": { "unknown-variable": 4 }, "unreadable": 0, "cut_off": 0,
    });
    assert_eq!(counts, expected);
}

#[test]
fn standard_input_is_one_of_many() {
    let folder = twelve();
    let outcome = vitrine("check scenes - gone.glsl --format json")
        .within(folder.path())
        .input(GOOD)
        .run();
    let text = outcome.exits(2).text();
    let lines: Vec<Value> = text
        .lines()
        .map(|l| serde_json::from_str(l).unwrap())
        .collect();
    assert_eq!(lines[12]["verdict"], "accept");
    assert_eq!(lines[13]["verdict"], "unreadable");
    assert_eq!(lines[13]["diagnostics"][0]["code"], "unreadable");
    let message = lines[13]["diagnostics"][0]["message"]
        .as_str()
        .expect("words");
    assert!(
        message.starts_with("cannot read `gone.glsl`: "),
        "{message}"
    );
}

#[test]
fn a_list_comes_from_standard_input_too() {
    let folder = twelve();
    let outcome = vitrine("check --list - --summary")
        .within(folder.path())
        .input("scenes/00.glsl\nscenes/01.glsl\r\n")
        .run();
    assert!(
        outcome.exits(0).text().contains("all"),
        "{}",
        outcome.text()
    );
    folder
        .run("check --list gone.txt")
        .exits(2)
        .says("cannot read `gone.txt`");
}

/// A pipe that nobody writes to: who reads it waits for ever.
#[cfg(unix)]
fn add_pipe(folder: &Folder, name: &str) {
    let path = folder.path().join(name);
    let status = std::process::Command::new("mkfifo").arg(path).status();
    assert!(status.expect("mkfifo runs").success());
}

#[cfg(unix)]
#[test]
fn a_scene_that_never_ends_is_cut_off_and_named() {
    let folder = twelve();
    add_pipe(&folder, "endless.glsl");
    let outcome = folder.run("check scenes/00.glsl endless.glsl scenes --timeout 1 --jobs 1");
    outcome
        .exits(1)
        .says("error[cut-off]: `endless.glsl` was cut off: it takes longer than 1 s")
        .says("`--timeout SECONDS`")
        .says("scenes/10.glsl: fine");

    let line = "check endless.glsl scenes/00.glsl --timeout 1 --format json";
    let text = folder.run(line).exits(1).text();
    let lines: Vec<Value> = text
        .lines()
        .map(|l| serde_json::from_str(l).unwrap())
        .collect();
    assert_eq!(lines[0]["file"], "endless.glsl");
    assert_eq!(lines[0]["verdict"], "cut-off");
    assert_eq!(lines[0]["passes"], json!([]));
    assert_eq!(lines[1]["verdict"], "accept");

    let outcome = folder.run("check endless.glsl --timeout 1 --summary");
    assert!(
        outcome.exits(1).text().contains("cut off"),
        "{}",
        outcome.text()
    );
    outcome.says("`endless.glsl` was cut off");
}

#[cfg(target_os = "linux")]
#[test]
fn a_scene_that_takes_too_much_memory_is_cut_off_and_named() {
    let folder = Folder::new();
    // Nothing fits into one MiB, this program least of all; the pipe gives time to find that out.
    add_pipe(&folder, "a.glsl");
    folder
        .run("check a.glsl --memory 1 --timeout 20")
        .exits(1)
        .says("error[cut-off]: `a.glsl` was cut off: it takes more than 1 MiB of memory")
        .says("`--memory MIB`");
}

#[test]
fn limits_are_numbers_within_reason() {
    for option in ["--jobs 0", "--timeout 0", "--timeout soon", "--memory 0"] {
        let outcome = vitrine(&format!("check a.glsl {option}")).run();
        outcome.exits(2).says("invalid value");
    }
}
