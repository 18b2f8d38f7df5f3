use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use glam::UVec2;
use serde::{Deserialize, Serialize};
use vitrine::measure::plot::{Against, plot};
use vitrine::measure::report::{self as reports, Machine};
use vitrine::measure::run::{Cell, Findings, Surroundings, run};
use vitrine::measure::study::{Family, Reference, Study, Value, Variant};
use vitrine::measure::summary::{Row, cheapest, rows};
use vitrine::output::{self, PngSink};
use vitrine::render::Gpu;
use vitrine::report;
use vitrine::scene::Source;

use super::media::library;
use super::opening::{adapter_choice, explain, gpu_failure, watchdog};
use super::progress::Progress;
use super::{SCENE_HAS_PROBLEMS, failure, unreadable, unwritable};
use crate::cli::MeasureArgs;

/// What is known already, one cell a line.
const CELLS: &str = "cells.jsonl";

/// What a cell was found for: nothing else that it depends on may differ.
#[derive(Clone, PartialEq, Serialize, Deserialize)]
struct Key {
    version: String,
    adapter: String,
    /// Every text of the scene and of the reference, their channels and macros, and the reference's
    /// precision, as a number.
    texts: u64,
    family: String,
    label: String,
    size: [u32; 2],
    time: f64,
    probe: String,
    flicker: bool,
}

#[derive(Serialize, Deserialize)]
struct Kept {
    key: Key,
    cell: Cell,
}

pub fn measure(args: MeasureArgs) -> anyhow::Result<ExitCode> {
    let (study, folder, name) = match args.vary.is_empty() {
        true => read(&args.study)?,
        false => (one_off(&args)?, PathBuf::new(), "variation".to_owned()),
    };
    let study = Study {
        repeats: args.repeats.unwrap_or(study.repeats),
        ..study
    };
    let out = args
        .out
        .clone()
        .unwrap_or_else(|| format!("{name}-report").into());
    let Some(texts) = texts(&study, &folder)? else {
        return Ok(SCENE_HAS_PROBLEMS.into());
    };
    let gpu = Gpu::headless(&adapter_choice(&args.gpu)).map_err(|error| gpu_failure(&error))?;
    let key = |variant: &Variant, time: f64| Key {
        version: env!("CARGO_PKG_VERSION").to_owned(),
        adapter: gpu.describe(),
        texts,
        family: variant.family.clone(),
        label: variant.label.clone(),
        size: study.size.to_array(),
        time,
        probe: study
            .probe
            .as_ref()
            .map(ToString::to_string)
            .unwrap_or_default(),
        flicker: study.flicker,
    };
    let kept = out.join(CELLS);
    let mut known = if args.fresh {
        Vec::new()
    } else {
        read_kept(&kept)
    };
    let before = known.len();
    let started = Instant::now();
    let watchdog = watchdog(&args.gpu);
    let mut bar: Option<Progress> = None;
    let variants = study.variants(&folder);
    let mut found = Vec::new();
    let findings = run(
        &study,
        Surroundings {
            gpu: &gpu,
            library: library(&args.media)?,
            folder: &folder,
            progress: &mut |step| {
                watchdog.begin();
                let bar = bar.get_or_insert_with(|| Progress::new(step.of as u32, "steps"));
                bar.say(step.next);
                bar.at(step.done as u32);
            },
            known: &|variant, time| {
                let key = key(variant, time);
                let found = known.iter().find(|kept| kept.key == key);
                found.map(|kept| kept.cell.clone())
            },
            keep: &mut |cell| {
                let is_it = |variant: &&Variant| {
                    variant.family == cell.family && variant.label == cell.label
                };
                if let Some(variant) = variants.iter().find(is_it) {
                    found.push(Kept {
                        key: key(variant, cell.time),
                        cell: cell.clone(),
                    });
                    // What cannot be kept must be found again, that is all.
                    let _ = append(&kept, found.last());
                }
            },
        },
    );
    watchdog.rest();
    if let Some(bar) = &bar {
        bar.end();
    }
    let findings = match findings {
        Ok(findings) => findings,
        Err(error) => return explain(error).map(Into::into),
    };
    let resumed = findings.cells.len() - found.len();
    known.extend(found);
    let machine = Machine {
        adapter: gpu.describe(),
        cores: std::thread::available_parallelism().map_or(1, usize::from),
        version: env!("CARGO_PKG_VERSION"),
    };
    let rows = rows(&findings);
    write(&out, &study, &findings, &rows, &machine)?;
    for &goal in &study.goals {
        if let Some(row) = cheapest(&rows, goal) {
            report::tell(format_args!("error ≤ {goal}: {}", row.name()));
        }
    }
    let again = match (resumed, before) {
        (0, _) => String::new(),
        (resumed, _) => format!(", {resumed} of them known from before"),
    };
    report::tell(format_args!(
        "{} cells{again} in {:.0} s: see {}",
        findings.cells.len(),
        started.elapsed().as_secs_f64(),
        out.join("report.md").display()
    ));
    Ok(ExitCode::SUCCESS)
}

fn read(path: &Path) -> anyhow::Result<(Study, PathBuf, String)> {
    if path.extension().is_none_or(|ending| ending != "toml") {
        return Err(failure(
            format!("`{}` is no study", path.display()),
            "a study is a TOML file; a scene is measured with `--vary NAME=A,B --reference NAME=C`",
        ));
    }
    let text = fs::read_to_string(path).map_err(|error| unreadable(path, &error))?;
    let study = Study::parse(&text).map_err(|message| {
        failure(
            format!("in `{}`: {}", path.display(), message.trim_end()),
            "docs/cli.md describes studies",
        )
    })?;
    let folder = path.parent().unwrap_or(Path::new("")).to_owned();
    let name = path.file_stem().unwrap_or_default().to_string_lossy();
    Ok((study, folder, name.into_owned()))
}

/// A study from the command line alone.
fn one_off(args: &MeasureArgs) -> anyhow::Result<Study> {
    let probe = match args.probe.as_deref().map(str::parse) {
        None => None,
        Some(Ok(probe)) => Some(probe),
        Some(Err(message)) => return Err(failure(message, "")),
    };
    let reference = args.reference.iter().cloned();
    let values = |values: &[String]| values.iter().cloned().map(Value).collect();
    Ok(Study {
        title: args.study.display().to_string(),
        scene: args.study.clone(),
        size: args.size.map_or(UVec2::new(240, 135), |size| {
            UVec2::new(size.width, size.height)
        }),
        times: match args.times.as_slice() {
            [] => vec![1.0],
            times => times.to_vec(),
        },
        probe,
        flicker: false,
        repeats: 5,
        goals: Vec::new(),
        define: BTreeMap::new(),
        reference: Reference {
            define: reference
                .into_iter()
                .map(|(name, value)| (name, Value(value)))
                .collect(),
            ..Reference::default()
        },
        findings: String::new(),
        families: vec![Family {
            name: "variation".to_owned(),
            scene: None,
            define: BTreeMap::new(),
            reference: None,
            times: None,
            vary: args
                .vary
                .iter()
                .map(|(name, all)| (name.clone(), values(all)))
                .collect(),
        }],
    })
}

/// A number for all that the study reads; `None` if a scene is broken, which has been said then.
fn texts(study: &Study, folder: &Path) -> anyhow::Result<Option<u64>> {
    let mut hash = Fnv::default();
    hash.add(format!("{:?}", study.reference.precision).as_bytes());
    let mut all = study.variants(folder);
    for (reference, refined) in study.references(folder) {
        all.push(reference);
        all.extend(refined);
    }
    for variant in &all {
        let source = Source::Path(variant.scene.clone());
        let scene = match super::loaded(&source)? {
            Ok(scene) => scene,
            Err(problems) => {
                report::show(&problems);
                return Ok(None);
            }
        };
        for pass in &scene.passes {
            for text in pass.texts(&scene.files) {
                hash.add(text.as_bytes());
            }
            hash.add(format!("{:?}", pass.channels).as_bytes());
        }
        for (name, value) in &variant.defines {
            hash.add(name.as_bytes());
            hash.add(value.as_bytes());
        }
    }
    Ok(Some(hash.0))
}

/// The hash of Fowler, Noll and Vo, 64 bits, FNV-1a: the same everywhere and for ever.
struct Fnv(u64);

impl Default for Fnv {
    fn default() -> Self {
        Fnv(0xcbf2_9ce4_8422_2325)
    }
}

impl Fnv {
    fn add(&mut self, bytes: &[u8]) {
        // 0 stands behind each, so that parts cannot be taken for one another.
        for &byte in bytes.iter().chain(&[0]) {
            self.0 = (self.0 ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
        }
    }
}

/// What an earlier run kept; a line that is cut off or of another version counts for nothing.
fn read_kept(path: &Path) -> Vec<Kept> {
    let text = fs::read_to_string(path).unwrap_or_default();
    text.lines()
        .filter_map(|line| serde_json::from_str(line).ok())
        .collect()
}

fn append(path: &Path, kept: Option<&Kept>) -> anyhow::Result<()> {
    use std::io::Write as _;
    if let Some(folder) = path.parent() {
        fs::create_dir_all(folder)?;
    }
    let mut file = fs::OpenOptions::new()
        .create(true)
        .append(true)
        .open(path)?;
    writeln!(file, "{}", serde_json::to_string(&kept)?)?;
    Ok(())
}

fn write(
    out: &Path,
    study: &Study,
    findings: &Findings,
    rows: &[Row],
    machine: &Machine,
) -> anyhow::Result<()> {
    let place = |name: &str, bytes: &[u8]| {
        let path = out.join(name);
        output::place(&path, bytes, true).map_err(|error| unwritable(&path, &error))
    };
    let error = match &study.probe {
        Some(probe) => format!("relative error of {probe}"),
        None => "RMSE of the picture".to_owned(),
    };
    let mut plots = Vec::new();
    for (name, against, what) in [
        ("error-time.svg", Against::Time, "Error against time"),
        (
            "error-rounds.svg",
            Against::Rounds,
            "Error against rounds of loops",
        ),
    ] {
        if let Some(svg) = plot(rows, against, &study.title, &error) {
            place(name, svg.as_bytes())?;
            plots.push((name.to_owned(), what.to_owned()));
        }
    }
    let mut sink = PngSink::default();
    for (index, worst) in findings.worst.iter().enumerate() {
        let name = format!("worst-{}.png", index + 1);
        let path = out.join(&name);
        (sink.write(&path, &worst.difference.to_bytes(), true))
            .map_err(|error| unwritable(&error.path, &error.error))?;
        plots.push((
            name,
            format!("Difference of {} at {} s", worst.name, worst.time),
        ));
    }
    place(
        "report.json",
        reports::json(study, findings, rows, machine).as_bytes(),
    )?;
    place("report.csv", reports::csv(rows).as_bytes())?;
    place(
        "report.md",
        reports::markdown(study, findings, rows, machine, &plots).as_bytes(),
    )
}
