//! What a study found, as Markdown, CSV and JSON.

use std::fmt::Write as _;

use serde::Serialize;

use super::run::Findings;
use super::study::{ReferencePrecision, Study};
use super::summary::{Row, cheapest};

/// Where it was measured.
#[derive(Clone, Debug, PartialEq, Eq, Serialize)]
pub struct Machine {
    /// Adapter and driver.
    pub adapter: String,
    /// The processor's cores that the program may use.
    pub cores: usize,
    /// This program's version.
    pub version: &'static str,
}

/// Everything, for programs.
pub fn json(study: &Study, findings: &Findings, rows: &[Row], machine: &Machine) -> String {
    #[derive(Serialize)]
    struct Report<'a> {
        title: &'a str,
        probe: Option<String>,
        size: [u32; 2],
        times: &'a [f64],
        repeats: u32,
        machine: &'a Machine,
        variants: &'a [Row],
        #[serde(flatten)]
        findings: &'a Findings,
    }
    let report = Report {
        title: &study.title,
        probe: study.probe.as_ref().map(ToString::to_string),
        size: study.size.to_array(),
        times: &study.times,
        repeats: study.repeats,
        machine,
        variants: rows,
        findings,
    };
    serde_json::to_string_pretty(&report).expect("numbers and texts") + "\n"
}

/// A line for each variant.
pub fn csv(rows: &[Row]) -> String {
    let mut text = "family,variant,ms,spread,ns_per_pixel,rounds,most_rounds,error,discretisation,\
                    rounding,p99,disagreements,rmse,psnr,above_1,above_8,flicker,best\n"
        .to_owned();
    for row in rows {
        let known = |value: Option<f64>| value.map_or(String::new(), |value| format!("{value:e}"));
        let _ = writeln!(
            text,
            "{},{},{},{},{},{:e},{},{},{},{},{},{},{:e},{},{:e},{:e},{},{}",
            quoted(&row.family),
            quoted(&row.label),
            known(row.milliseconds),
            known(row.spread),
            known(row.nanoseconds),
            row.rounds,
            row.most_rounds,
            known(row.error),
            known(row.discretisation),
            known(row.rounding),
            known(row.p99),
            known(row.disagreements),
            row.rmse,
            known(row.psnr),
            row.above_1,
            row.above_8,
            known(row.flicker),
            row.is_best
        );
    }
    text
}

fn quoted(text: &str) -> String {
    match text.contains([',', '"', '\n']) {
        true => format!("\"{}\"", text.replace('"', "\"\"")),
        false => text.to_owned(),
    }
}

/// The same for people; `plots` are the files' names with what they show.
pub fn markdown(
    study: &Study,
    findings: &Findings,
    rows: &[Row],
    machine: &Machine,
    plots: &[(String, String)],
) -> String {
    let mut text = format!("# {}\n\n", study.title);
    let probe = study.probe.as_ref().map(ToString::to_string);
    let error = match &probe {
        Some(probe) => format!("relative error of `{probe}`, a picture's median"),
        None => "RMSE of the picture, 1 is white".to_owned(),
    };
    let _ = writeln!(
        text,
        "{}×{} pixels {}; error: {error}. Of several moments the largest error and the mean time \
         count. Times are medians of {} rounds in which all variants take turns.\n",
        study.size.x,
        study.size.y,
        moments(study),
        study.repeats
    );
    let precision = match study.reference.precision {
        ReferencePrecision::Double => "64 bits",
        ReferencePrecision::Single => "32 bits",
    };
    let _ = write!(text, "The reference is computed in {precision}");
    let cells = findings.cells.iter();
    let largest = cells.filter_map(|cell| cell.reference_error?.main());
    match largest.reduce(f64::max) {
        Some(own) => {
            let _ = writeln!(text, "; refined once more it moves by {}.\n", number(own));
        }
        None => text += ".\n\n",
    }
    for goal in &study.goals {
        let _ = match cheapest(rows, *goal) {
            Some(row) => writeln!(
                text,
                "- The cheapest with an error of at most {}: **{}** ({}, error {}).",
                number(*goal),
                row.name(),
                row.milliseconds
                    .map_or(format!("{:.0} rounds", row.rounds), |ms| format!(
                        "{ms:.2} ms"
                    )),
                row.error.map_or("–".to_owned(), number)
            ),
            None => writeln!(
                text,
                "- No variant has an error of at most {}.",
                number(*goal)
            ),
        };
    }
    if !study.goals.is_empty() {
        text.push('\n');
    }
    for (file, what) in plots {
        let _ = writeln!(text, "![{what}]({file})\n");
    }
    table(&mut text, rows, probe.is_some(), study.flicker);
    let _ = write!(
        text,
        "\nVariants in bold are beaten by none in both time and error. *Method* is the error in 64 bits \
         against the reference, *rounding* that of 32 bits against 64.{}\n\n\
         Measured with Vitrine {} on {}, {} cores.\n",
        match study.flicker {
            true => " *Flicker* is the RMSE of the error's change since the frame before.",
            false => "",
        },
        machine.version,
        machine.adapter,
        machine.cores
    );
    if !study.findings.trim().is_empty() {
        let _ = write!(text, "\n## What was found\n\n{}\n", study.findings.trim());
    }
    text
}

/// When it was drawn: with the families that this holds for, if it does not for all.
fn moments(study: &Study) -> String {
    let mut groups: Vec<(&[f64], Vec<&str>)> = Vec::new();
    for family in &study.families {
        let times = study.times_of(family);
        match groups.iter_mut().find(|group| group.0 == times) {
            Some((_, names)) => names.push(&family.name),
            None => groups.push((times, vec![&family.name])),
        }
    }
    let is_one = groups.len() == 1;
    let say = |(times, names): (&[f64], Vec<&str>)| {
        let times: Vec<_> = times.iter().map(|time| format!("{time} s")).collect();
        let at = format!("at {}", times.join(", "));
        match is_one {
            true => at,
            false => format!("{at} ({})", names.join("; ")),
        }
    };
    let all: Vec<_> = groups.into_iter().map(say).collect();
    all.join(", ")
}

fn table(text: &mut String, rows: &[Row], has_probe: bool, has_flicker: bool) {
    let probe_head = if has_probe {
        " p99 | hit or miss |"
    } else {
        ""
    };
    let probe_line = if has_probe { "--:|--:|" } else { "" };
    let flicker_head = if has_flicker { " flicker |" } else { "" };
    let flicker_line = if has_flicker { "--:|" } else { "" };
    let _ = writeln!(
        text,
        "| variant | ms | ± | ns/pixel | rounds | error | method | rounding |{probe_head} RMSE | PSNR | > 1/255 | > 8/255 |{flicker_head}"
    );
    let _ = writeln!(
        text,
        "|---|--:|--:|--:|--:|--:|--:|--:|{probe_line}--:|--:|--:|--:|{flicker_line}"
    );
    for row in rows {
        let known = |value: Option<f64>| value.map_or("–".to_owned(), number);
        let percent = |share: f64| format!("{:.2} %", share * 100.0);
        let mark = if row.is_best { "**" } else { "" };
        let _ = write!(
            text,
            "| {mark}{}{mark} | {} | {} | {} | {:.1} | {} | {} | {} |",
            row.name(),
            row.milliseconds
                .map_or("–".to_owned(), |ms| format!("{ms:.2}")),
            row.spread.map_or("–".to_owned(), |spread| format!(
                "{:.0} %",
                spread * 100.0
            )),
            row.nanoseconds
                .map_or("–".to_owned(), |ns| format!("{ns:.1}")),
            row.rounds,
            known(row.error),
            known(row.discretisation),
            known(row.rounding)
        );
        if has_probe {
            let _ = write!(
                text,
                " {} | {} |",
                known(row.p99),
                row.disagreements.map_or("–".to_owned(), percent)
            );
        }
        let _ = write!(
            text,
            " {} | {} | {} | {} |",
            number(row.rmse),
            row.psnr.map_or("∞".to_owned(), |psnr| format!("{psnr:.1}")),
            percent(row.above_1),
            percent(row.above_8)
        );
        if has_flicker {
            let _ = write!(text, " {} |", known(row.flicker));
        }
        text.push('\n');
    }
}

/// Two digits that mean something.
fn number(value: f64) -> String {
    match value.abs() {
        0.0 => "0".to_owned(),
        size if (0.01..1000.0).contains(&size) => format!("{value:.3}"),
        _ => format!("{value:.1e}"),
    }
}
