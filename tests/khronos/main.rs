//! Khronos' own tests of GLSL ES 3.00, run against the front end.
//!
//! They are the shader library of VK-GL-CTS, which is not a part of this project:
//!
//! ```text
//! git clone --depth 1 https://github.com/KhronosGroup/VK-GL-CTS
//! KHRONOS=VK-GL-CTS/data/gles3/shaders \
//!     cargo test --test khronos -- --ignored --nocapture
//! ```
//!
//! `KHRONOS_CASE=switch/conditional` runs only the cases whose path contains it, and shows for each
//! the text that the front end was given and what came of it.
//!
//! Only fragment shaders are run. Their inputs are uniforms, since there is no vertex shader. Where
//! WebGL2 has other rules than Khronos, its rules hold.

mod compile;
mod draw;
mod format;
mod report;
mod specialise;

use std::cell::RefCell;
use std::collections::BTreeMap;
use std::panic::{self, AssertUnwindSafe};
use std::path::PathBuf;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Once, OnceLock};

use compile::{Refusal, compile};
use draw::Gpu;
use format::{Case, Scalar, Value};
use report::{Outcome, Tally};
use specialise::{Program, Show, Task, task};

/// Enough for whatever the parser lets through, in an unoptimised build too.
const STACK: usize = 64 << 20;

#[test]
#[ignore = "it needs Khronos' tests, which are not part of this repository: KHRONOS=/path/to/VK-GL-CTS/data/gles3/shaders"]
fn khronos_shader_library() {
    let Some(folder) = std::env::var_os("KHRONOS").map(PathBuf::from) else {
        println!("skipped: set KHRONOS to the folder data/gles3/shaders of VK-GL-CTS");
        return;
    };
    let wanted = std::env::var("KHRONOS_CASE").ok();
    let files = read(&folder, wanted.as_deref());
    let adapter = draw::adapter().expect("a graphics adapter");
    println!("drawn by {}", adapter.get_info().name);
    let cases: Vec<&Case> = files.iter().flat_map(|(_, cases)| cases).collect();
    let mut outcomes = run(&adapter, &cases, wanted.is_some()).into_iter();
    let mut total = Tally::default();
    let mut skipped = BTreeMap::<_, usize>::new();
    for (file, cases) in &files {
        let mut tally = Tally::default();
        let mut lines = Vec::new();
        for case in cases {
            let outcome = outcomes.next().expect("every case has come to something");
            tally.add(&outcome);
            match outcome {
                Outcome::Failed(reason) | Outcome::WronglyAccepted(reason) => {
                    lines.push(format!("    {}: {reason}", case.path));
                }
                Outcome::Skipped(reason) => *skipped.entry(reason).or_default() += 1,
                Outcome::Passed | Outcome::Refused(_) => {}
            }
        }
        println!("{file:<32}{tally}");
        lines.iter().for_each(|line| println!("{line}"));
        total.join(tally);
    }
    println!("{:<32}{total}", "all");
    for (reason, count) in &skipped {
        println!("    {count} skipped: {reason}");
    }
    assert_eq!(total.failures(), 0, "cases that are not as Khronos has it");
}

/// The cases of all files in the folder, or those that are wanted.
fn read(folder: &PathBuf, wanted: Option<&str>) -> Vec<(String, Vec<Case>)> {
    let entries = std::fs::read_dir(folder).expect("KHRONOS names a folder");
    let paths = entries.map(|entry| entry.expect("a readable folder").path());
    let mut paths: Vec<_> = paths
        .filter(|path| {
            path.extension()
                .is_some_and(|extension| extension == "test")
        })
        .collect();
    paths.sort();
    let files = paths.iter().map(|path| {
        let name = path.file_stem().unwrap_or_default().to_string_lossy();
        let mut cases = format::read(path).unwrap_or_else(|error| panic!("{error}"));
        for case in &mut cases {
            case.path = format!("{name}/{}", case.path);
        }
        cases.retain(|case| wanted.is_none_or(|wanted| case.path.contains(wanted)));
        (name.into_owned(), cases)
    });
    files.filter(|(_, cases)| !cases.is_empty()).collect()
}

/// Runs the cases on two threads: one compiles while the other waits for the device.
fn run(adapter: &wgpu::Adapter, cases: &[&Case], is_verbose: bool) -> Vec<Outcome> {
    let next = AtomicUsize::new(0);
    let outcomes: Vec<OnceLock<Outcome>> = cases.iter().map(|_| OnceLock::new()).collect();
    let work = || {
        let mut gpu = Gpu::open(adapter).expect("a device");
        loop {
            let index = next.fetch_add(1, Ordering::Relaxed);
            let (Some(case), Some(slot)) = (cases.get(index), outcomes.get(index)) else {
                return;
            };
            let outcome = judge(&gpu, case);
            if gpu.is_lost() {
                gpu = Gpu::open(adapter).expect("another device");
            }
            if is_verbose {
                println!("{}\n{}\n{outcome:?}\n", case.path, text(case));
            }
            slot.set(outcome).expect("each case is taken once");
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..2 {
            let thread = std::thread::Builder::new().stack_size(STACK);
            thread.spawn_scoped(scope, work).expect("a thread");
        }
    });
    let outcomes = outcomes.into_iter().map(OnceLock::into_inner);
    outcomes
        .map(|outcome| outcome.expect("every case was taken"))
        .collect()
}

fn judge(gpu: &Gpu, case: &Case) -> Outcome {
    const VARYINGS: Outcome = Outcome::Skipped("reads what a vertex shader writes");
    let (program, must_be_white) = match task(case, Show::Verdict) {
        Task::Skip(reason) => return Outcome::Skipped(reason),
        Task::Refuse(text) => {
            return match built(&text, Vec::new()) {
                Err(Refusal::Text(message)) => Outcome::Refused(message),
                Err(Refusal::Varyings) => VARYINGS,
                Err(Refusal::Internal(message)) => Outcome::WronglyAccepted(message),
                Ok(_) => Outcome::WronglyAccepted("accepted, though it must be refused".to_owned()),
            };
        }
        Task::Build(program) => (program, false),
        Task::Draw(program) => (program, true),
    };
    match drawn(gpu, &program) {
        Err(Refusal::Varyings) => VARYINGS,
        Err(Refusal::Text(message)) => Outcome::Failed(format!("refused: {message}")),
        Err(Refusal::Internal(message)) => Outcome::Failed(message),
        Ok(colors) => match colors.iter().position(|color| !is_white(*color)) {
            Some(set) if must_be_white => Outcome::Failed(difference(gpu, case, set, colors[set])),
            _ => Outcome::Passed,
        },
    }
}

/// Compiles a text; a panic is a failure of the front end's.
fn built(text: &str, uniforms: Vec<String>) -> Result<vitrine::glsl::lower::Lowered, Refusal> {
    caught(|| compile(text, uniforms)).unwrap_or_else(|message| Err(Refusal::Internal(message)))
}

/// Compiles a program and draws it.
fn drawn(gpu: &Gpu, program: &Program) -> Result<Vec<[f32; 4]>, Refusal> {
    let names = program.uniforms.iter().map(|value| value.name.clone());
    let lowered = built(&program.text, names.collect())?;
    caught(|| gpu.draw(&lowered, program))
        .and_then(|drawn| drawn)
        .map_err(Refusal::Internal)
}

/// As a target of eight bits would have it; opacity does not matter.
fn is_white(color: [f32; 4]) -> bool {
    color[..3].iter().all(|channel| *channel >= 254.5 / 255.0)
}

/// Says what a case computes with a set of values, and what it should.
fn difference(gpu: &Gpu, case: &Case, set: usize, color: [f32; 4]) -> String {
    let all = case.values.sets();
    let mut text = format!("wrong in set {} of {all}", set + 1);
    let inputs = case.values.inputs.iter().chain(&case.values.uniforms);
    for value in inputs {
        text += &format!("; {} = {}", value.name, listed(value, set));
    }
    if case.values.outputs.is_empty() {
        return format!("{text}; drew {color:?}");
    }
    let Task::Draw(program) = task(case, Show::Results) else {
        return text;
    };
    let computed: Vec<f32> = match drawn(gpu, &program) {
        Ok(parts) => parts
            .iter()
            .skip(set)
            .step_by(all)
            .flatten()
            .copied()
            .collect(),
        Err(refusal) => return format!("{text}; its outputs cannot be shown: {refusal:?}"),
    };
    let mut rest = computed.as_slice();
    for value in &case.values.outputs {
        let (own, behind) = rest.split_at(value.ty.components());
        let own: Vec<_> = own.iter().map(f32::to_string).collect();
        let (own, expected) = (own.join(" "), listed(value, set));
        text += &format!("; {} is {own}, expected {expected}", value.name);
        rest = behind;
    }
    text
}

/// A value in a set.
fn listed(value: &Value, set: usize) -> String {
    let numbers = value.set(set).iter().map(|&word| match value.ty.scalar {
        Scalar::Float => f32::from_bits(word).to_string(),
        Scalar::Int => (word as i32).to_string(),
        Scalar::Uint | Scalar::Bool => word.to_string(),
    });
    numbers.collect::<Vec<_>>().join(" ")
}

/// What the front end is given of a case.
fn text(case: &Case) -> String {
    match task(case, Show::Verdict) {
        Task::Skip(reason) => reason.to_owned(),
        Task::Refuse(text) => text,
        Task::Build(program) | Task::Draw(program) => program.text,
    }
}

/// Turns a panic into an error.
fn caught<T>(work: impl FnOnce() -> T) -> Result<T, String> {
    keep_panics();
    PANIC.set(Some(String::new()));
    let result = panic::catch_unwind(AssertUnwindSafe(work));
    let message = PANIC.take().unwrap_or_default();
    result.map_err(|_| message)
}

thread_local! {
    /// Within [`caught`], what the last panic of this thread said.
    static PANIC: RefCell<Option<String>> = const { RefCell::new(None) };
}

/// Keeps panics within [`caught`] off standard error.
fn keep_panics() {
    static ONCE: Once = Once::new();
    ONCE.call_once(|| {
        let report = panic::take_hook();
        panic::set_hook(Box::new(move |info| {
            PANIC.with_borrow_mut(|kept| match kept {
                Some(message) => *message = info.to_string().replace('\n', " "),
                None => report(info),
            });
        }));
    });
}
