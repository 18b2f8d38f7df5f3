use std::process::ExitCode;

use serde::Serialize;
use vitrine::report;
use vitrine::scene::{Channel, Pass, Scene};
use vitrine::source::Span;
use vitrine::translate::bindings::{self, Uniform};
use vitrine::translate::{ChannelUse, Program};

use super::{SCENE_HAS_PROBLEMS, Translation, options, print, source, translated};
use crate::cli::{Format, InspectArgs};

/// What one pass uses, and what was left out of it.
#[derive(Serialize)]
struct Findings<'a> {
    scene: &'a str,
    pass: &'static str,
    uniforms: Vec<&'static str>,
    /// Bytes of the uniform block; absent without one.
    uniform_block: Option<u32>,
    channels: Vec<ChannelFindings>,
    functions: &'a [String],
    /// Bytes of constant tables that are bound as a buffer.
    tables: usize,
    guards: Guards,
    left_out: LeftOut<'a>,
}

/// Places that are checked while the pass runs, as `file:line:column`.
#[derive(Serialize)]
struct Guards {
    loops: Vec<String>,
    accesses: Vec<String>,
    divisions: Vec<String>,
}

#[derive(Serialize)]
struct ChannelFindings {
    name: &'static str,
    /// Its kind, `noise` for example, or `unbound`.
    input: &'static str,
    /// Which of the site's files it is.
    media: Option<String>,
    filter: Option<&'static str>,
    wrap: Option<&'static str>,
    texture: bool,
    sampler: bool,
}

#[derive(Serialize)]
struct LeftOut<'a> {
    uniforms: Vec<&'static str>,
    channels: Vec<&'static str>,
    functions: &'a [String],
    /// GPU objects that other scenes need and this pass does not.
    objects: Vec<&'static str>,
}

pub fn inspect(args: InspectArgs) -> anyhow::Result<ExitCode> {
    let options = options(args.define);
    let (scene, programs) = match translated(&source(&args.scene, args.web.refresh)?, &options)? {
        Translation::Done(scene, programs) => (scene, programs),
        Translation::Problems(report) => {
            report::show(&report);
            return Ok(SCENE_HAS_PROBLEMS.into());
        }
    };
    for (pass, program) in scene.passes.iter().zip(&programs) {
        let findings = findings(&scene, pass, program);
        let text = match args.format {
            Format::Json => serde_json::to_string(&findings)? + "\n",
            Format::Human => human(&findings),
        };
        print(text.as_bytes())?;
    }
    Ok(ExitCode::SUCCESS)
}

fn findings<'a>(scene: &'a Scene, pass: &'a Pass, program: &'a Program) -> Findings<'a> {
    let (used, unused): (Vec<_>, Vec<_>) = Uniform::ALL
        .into_iter()
        .partition(|&uniform| program.reads(uniform));
    let channels = || program.channels.iter().zip(&pass.channels).enumerate();
    let is_used = |usage: &ChannelUse| usage.texture || usage.sampler;
    let mut objects = Vec::new();
    if program.uniforms.is_none() {
        objects.push("uniform block");
    }
    if !program.channels.iter().any(|usage| usage.texture) {
        objects.push("textures");
    }
    if !program.channels.iter().any(|usage| usage.sampler) {
        objects.push("samplers");
    }
    if program.uniforms.is_none() && !program.channels.iter().any(is_used) {
        objects.push("bind group");
    }
    Findings {
        scene: &scene.name,
        pass: pass.kind.name(),
        uniforms: used.into_iter().map(Uniform::name).collect(),
        uniform_block: program.uniforms.as_ref().map(|block| block.size),
        channels: channels()
            .filter(|(_, (usage, _))| is_used(usage))
            .map(|(index, (usage, bound))| channel(index, *usage, bound.as_ref()))
            .collect(),
        functions: &program.functions.used,
        tables: program
            .tables
            .as_ref()
            .map_or(0, |tables| 4 * tables.words.len()),
        guards: Guards {
            loops: places(scene, &program.guards.loops),
            accesses: places(scene, &program.guards.accesses),
            divisions: places(scene, &program.guards.divisions),
        },
        left_out: LeftOut {
            uniforms: unused.into_iter().map(Uniform::name).collect(),
            channels: channels()
                .filter(|(_, (usage, _))| !is_used(usage))
                .map(|(index, _)| bindings::channel_name(index))
                .collect(),
            functions: &program.functions.unused,
            objects,
        },
    }
}

fn places(scene: &Scene, spans: &[Span]) -> Vec<String> {
    spans.iter().map(|&span| scene.files.place(span)).collect()
}

fn channel(index: usize, usage: ChannelUse, bound: Option<&Channel>) -> ChannelFindings {
    ChannelFindings {
        name: bindings::channel_name(index),
        input: bound.map_or("unbound", |channel| channel.input.name()),
        media: bound.and_then(|channel| Some(channel.input.media()?.to_string())),
        filter: bound.map(|channel| channel.sampling.filter.name()),
        wrap: bound.map(|channel| channel.sampling.wrap.name()),
        texture: usage.texture,
        sampler: usage.sampler,
    }
}

fn human(findings: &Findings<'_>) -> String {
    let owned = |names: &[&str]| {
        names
            .iter()
            .map(|&name| name.to_owned())
            .collect::<Vec<_>>()
    };
    let left_out = &findings.left_out;
    let channels: Vec<_> = findings.channels.iter().map(channel_line).collect();
    let mut text = format!("{}, pass {}\n", findings.scene, findings.pass);
    text += &line("uniforms", &owned(&findings.uniforms));
    text += &line("channels", &channels);
    text += &line("functions", findings.functions);
    if findings.tables > 0 {
        text += &line("tables", &[format!("{} bytes", findings.tables)]);
    }
    text += "checked at run time\n";
    text += &line("loops", &findings.guards.loops);
    text += &line("indices", &findings.guards.accesses);
    text += &line("divisions", &findings.guards.divisions);
    text += "left out\n";
    text += &line("uniforms", &owned(&left_out.uniforms));
    text += &line("channels", &owned(&left_out.channels));
    text += &line("functions", left_out.functions);
    text += &line("objects", &owned(&left_out.objects));
    text
}

fn line(title: &str, items: &[String]) -> String {
    match items {
        [] => format!("  {title:<10} none\n"),
        items => format!("  {title:<10} {}\n", items.join(", ")),
    }
}

fn channel_line(channel: &ChannelFindings) -> String {
    let how = match (channel.filter, channel.wrap) {
        (Some(filter), Some(wrap)) => format!(", {filter}, {wrap}"),
        _ => String::new(),
    };
    let only = if channel.sampler { "" } else { ", not sampled" };
    format!("{} ({}{how}{only})", channel.name, channel.input)
}
