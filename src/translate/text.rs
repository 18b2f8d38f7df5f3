//! One pass's text, from its tokens to its program.

use std::array;
use std::collections::BTreeSet;

use super::plain::Plain;
use super::program::{Functions, Guards, Program};
use super::{Options, Output, Site, bindings, bundle, preamble, probe, refusal, write};
use crate::glsl::check::{self, check};
use crate::glsl::lower::{self, Checks, lower};
use crate::glsl::names::{Name, Names};
use crate::glsl::places::Places;
use crate::glsl::preprocess::{self, preprocess};
use crate::glsl::prune::Reachable;
use crate::glsl::types::Shape;
use crate::glsl::{Precision, double, finite, hir, syntax};
use crate::scene::{CHANNELS, Pass, PassKind, SamplerKind};
use crate::source::{Diagnostic, FileId, Severity, SourceMap, Span};

pub(super) fn translate_text(
    mut files: SourceMap,
    pass: &Pass,
    options: &Options,
) -> Result<Program, Vec<Diagnostic>> {
    let texts = pass.texts(&files);
    let plain = Plain::recognise(pass, &texts);
    let text = preamble::preamble(pass, &texts, plain.as_ref());
    let preamble = files.add("preamble", text);
    let functions = (options.precision == Precision::Double)
        .then(|| files.add("functions of 64 bits", double::TEXT));
    let text = Text {
        files: &files,
        preamble,
        functions,
        pass,
        plain,
    };
    text.translate(options)
        .map_err(|found| text.in_authors_files(found))
}

/// A pass's texts behind their preamble, and that behind the functions which drivers lack.
struct Text<'a> {
    files: &'a SourceMap,
    preamble: FileId,
    functions: Option<FileId>,
    pass: &'a Pass,
    plain: Option<Plain>,
}

impl Text<'_> {
    fn translate(&self, options: &Options) -> Result<Program, Vec<Diagnostic>> {
        // The site has no verdict on a plain fragment shader.
        let strict = options.strict && self.plain.is_none();
        let mut units = vec![self.preamble];
        units.extend(&self.pass.sources);
        let splices = self.pass.splices.iter();
        let splices: Vec<_> = splices.map(|one| (one.place, one.text)).collect();
        let preprocessed = preprocess(
            self.files,
            &units,
            &preprocess::Options {
                defines: &[("HW_PERFORMANCE", "1")],
                overrides: &options.overrides,
                splices: &splices,
                strict,
            },
            Names::default(),
        );
        let mut diagnostics = preprocessed.diagnostics;
        fail_on_errors(&mut diagnostics)?;
        // They are none of the author's macros' business, and so a text of their own.
        let functions: Vec<_> = self.functions.into_iter().collect();
        let mut functions = preprocess(
            self.files,
            &functions,
            &preprocess::Options::default(),
            preprocessed.names,
        );
        let host_tokens = functions.tokens.len();
        let mut tokens = preprocessed.tokens;
        if let Some(plain) = &self.plain {
            tokens = plain.drop_given(tokens, &functions.names, self.preamble);
        }
        if self.pass.kind == PassKind::Image {
            let is_bound = |channel: usize| self.pass.channels[channel].is_some();
            tokens = bundle::unbundle(tokens, &mut functions.names, self.preamble, is_bound);
        }
        tokens.splice(0..0, functions.tokens);
        let tokens = &tokens;
        let parsed = syntax::parse(tokens, functions.names, strict);
        diagnostics.extend(parsed.diagnostics);
        if let Some(odd) = preprocessed.odd_character {
            // A character that no one sees is most likely to blame for what follows.
            if diagnostics.iter().any(Diagnostic::is_error) {
                let severity = Severity::Error;
                return Err(vec![Diagnostic { severity, ..odd }]);
            }
            diagnostics.push(odd);
        }
        fail_on_errors(&mut diagnostics)?;
        let mut ast = parsed.ast;
        let check_options = check::Options {
            strict,
            precision: options.precision,
            host_tokens,
        };
        let checked = check(&mut ast, Places::new(tokens), check_options);
        diagnostics.extend(checked.diagnostics);
        fail_on_errors(&mut diagnostics)?;
        // The head of other passes has it; a plain shader may have left it away with its macros.
        if checked.hir.main.is_none() {
            return Err(vec![refusal::no_entry_point(self.pass.kind, &self.texts())]);
        }
        // The larger the text, the more it matters that not all its forms are kept at once.
        drop(ast);
        let names = &checked.hir.names;
        let channels = array::from_fn(|channel| names.find(bindings::channel_name(channel)));
        let program = self.lower(checked.hir, tokens, options)?;
        diagnostics.extend(self.unbound_channels(&program, channels, tokens));
        if options.checks == Checks::All {
            // It sees for itself what these only suspect.
            diagnostics.retain(|d| !matches!(d.code, "reversed-smoothstep" | "unset-variable"));
        }
        let unused = preprocessed.unused_overrides;
        Ok(Program {
            warnings: self.in_authors_files(diagnostics),
            unused_overrides: unused.into_iter().map(str::to_owned).collect(),
            ..program
        })
    }
}

impl Text<'_> {
    /// Keeps what the pass needs and makes a program of it. The text is right by now: what fails here
    /// is a fault of this program.
    fn lower(
        &self,
        mut hir: hir::Hir,
        tokens: &[preprocess::Token],
        options: &Options,
    ) -> Result<Program, Vec<Diagnostic>> {
        finite::mark_finite_loops(&mut hir);
        let output = self.output(&mut hir, &options.output)?;
        let components = output.components(&hir);
        let double_functions = double::Functions::new(&hir);
        let reachable = Reachable::new(&hir, &double_functions);
        let lowered = lower(
            &hir,
            &reachable,
            &lower::Options {
                precision: options.precision,
                arithmetic: options.arithmetic,
                output,
                round_budget: options.round_budget,
                round_limit: options.round_limit,
                low_samplers: self.has_low_samplers(options),
                interface: &bindings::INTERFACE,
                unit_0: self.pass.channels[0].as_ref().map(|channel| {
                    match channel.input.sampler() {
                        SamplerKind::TwoD => Shape::Plane,
                        SamplerKind::ThreeD => Shape::Volume,
                        SamplerKind::Cube => Shape::Cube,
                    }
                }),
                checks: options.checks.clone(),
                double_functions: &double_functions,
            },
        );
        let places = Places::new(tokens);
        if let Some(excess) = lowered.excess {
            return Err(vec![refusal::excess(excess, places)]);
        }
        let functions = self.functions(&hir, &reachable, tokens);
        let in_own_files = |extents: &[hir::Extent]| -> Vec<Span> {
            let spans = extents.iter().filter_map(|&extent| places.span(extent));
            let mut own: Vec<Span> = spans.filter(|span| self.is_authors(span)).collect();
            // What stands before each `continue` anew is one place.
            own.sort_by_key(|span| (span.file, span.start, span.end));
            own.dedup();
            own
        };
        let guards = Guards {
            loops: in_own_files(&lowered.unguarded.loops),
            accesses: in_own_files(&lowered.unguarded.accesses),
            divisions: in_own_files(&lowered.unguarded.divisions),
        };
        let own = |extent| places.span(extent).filter(|span| self.is_authors(span));
        let loops = lowered.loops.iter().map(|&extent| own(extent)).collect();
        let sites = lowered.sites.iter();
        let sites = sites
            .map(|site| {
                Site::new(
                    site.clone(),
                    own(site.extent),
                    places.origin(site.extent),
                    &hir,
                )
            })
            .collect();
        drop(hir);
        let internal = |message: &str| vec![refusal::internal(message).at(self.end())];
        let mut program = Program::new(
            self.pass.kind,
            options.precision,
            lowered,
            functions,
            guards,
            loops,
            options.round_budget,
        )
        .map_err(|message| internal(&message))?;
        program.components = components;
        program.sites = sites;
        // What validates can be written: this is for whoever changes that by mistake.
        if cfg!(debug_assertions) {
            write::spirv(&program).map_err(|message| internal(&message))?;
        }
        Ok(program)
    }

    /// Whether what is read through samplers is to be rounded.
    fn has_low_samplers(&self, options: &Options) -> bool {
        options.low_samplers
            && options.precision == Precision::Single
            && !self.texts().contains("highp sampler")
    }

    /// What is given for a pixel, looked up by name.
    fn output(
        &self,
        hir: &mut hir::Hir,
        output: &Output,
    ) -> Result<lower::Output, Vec<Diagnostic>> {
        Ok(match output {
            Output::Colour => lower::Output::Colour,
            Output::Rounds(first) => lower::Output::Rounds(*first),
            Output::AllRounds => lower::Output::AllRounds,
            Output::Spent => lower::Output::Spent,
            Output::Probe(probe) => {
                let entry = match &self.plain {
                    Some(_) => "main",
                    None => preamble::entry_point(self.pass.kind).0,
                };
                let watched = probe::find(hir, probe, entry)
                    .map_err(|problem| vec![problem.at(self.end())])?;
                if let lower::Watched::Local(function, local) = watched {
                    hir.functions[function].locals[local].written = true;
                }
                lower::Output::Value(watched)
            }
        })
    }

    /// The author's functions, used and unused.
    fn functions(
        &self,
        hir: &hir::Hir,
        reachable: &Reachable,
        tokens: &[preprocess::Token],
    ) -> Functions {
        let names = |is_used: bool| {
            let own = hir.functions.iter().filter(|(id, function)| {
                let place = tokens.get(function.at as usize);
                let is_own = place.is_some_and(|token| self.is_authors(&token.span));
                is_own && reachable.functions.contains(id) == is_used
            });
            own.map(|(_, function)| hir.names.text(function.name).to_owned())
                .collect::<BTreeSet<String>>()
        };
        let (used, unused) = (names(true), names(false));
        Functions {
            unused: unused.difference(&used).cloned().collect(),
            used: used.into_iter().collect(),
        }
    }

    /// Behind the last visible character of the pass.
    fn end(&self) -> Span {
        let own = self.own_file();
        let end = self.files.get(own).text.trim_end().len() as u32;
        Span {
            file: own,
            start: end,
            end,
        }
    }

    /// Whether a place lies in what the author wrote.
    fn is_authors(&self, span: &Span) -> bool {
        span.file != self.preamble && Some(span.file) != self.functions
    }

    fn own_file(&self) -> FileId {
        *self.pass.sources.last().expect("a pass has a text")
    }

    /// Moves what points into the preamble to where the author can do something about it.
    fn in_authors_files(&self, found: Vec<Diagnostic>) -> Vec<Diagnostic> {
        let is_foreign =
            |diagnostic: &Diagnostic| diagnostic.span.is_none_or(|span| !self.is_authors(&span));
        let (mut foreign, mut own): (Vec<_>, Vec<_>) = found.into_iter().partition(is_foreign);
        if let Some(plain) = &self.plain {
            own.retain(|finding| plain.concerns(finding, true));
            foreign.retain(|finding| plain.concerns(finding, false));
        }
        for diagnostic in &mut own {
            if diagnostic.code == "redeclared" && self.written(diagnostic.span) == "main" {
                let hint =
                    "ShaderToy code has an entry point of its own instead; the host brings `main`";
                diagnostic.hint = Some(hint.to_owned());
            }
            diagnostic.notes.retain(|(span, _)| self.is_authors(span));
        }
        for diagnostic in foreign {
            let diagnostic = match diagnostic.code {
                "no-body" => refusal::no_entry_point(self.pass.kind, &self.texts()),
                // What the author did not write is only the consequence of something else.
                _ if diagnostic.is_error() && own.iter().any(Diagnostic::is_error) => continue,
                _ => diagnostic,
            };
            own.push(Diagnostic {
                notes: Vec::new(),
                ..diagnostic.at(self.end())
            });
        }
        own
    }

    /// What the author wrote at a place.
    fn written(&self, span: Option<Span>) -> &str {
        span.and_then(|span| {
            let text = &self.files.get(span.file).text;
            text.get(span.start as usize..span.end as usize)
        })
        .unwrap_or_default()
    }

    fn texts(&self) -> String {
        self.pass.texts(self.files).concat()
    }

    fn unbound_channels(
        &self,
        program: &Program,
        names: [Option<Name>; CHANNELS],
        tokens: &[preprocess::Token],
    ) -> Vec<Diagnostic> {
        let is_unbound = |&channel: &usize| {
            program.channels[channel].texture && self.pass.channels[channel].is_none()
        };
        (0..CHANNELS)
            .filter(is_unbound)
            .map(|channel| {
                let name = bindings::channel_name(channel);
                let own = tokens.iter().filter(|token| self.is_authors(&token.span));
                let place = own
                    .into_iter()
                    .find(|token| Some(token.spelling) == names[channel]);
                Diagnostic::warning(
                    "unbound-channel",
                    format!("`{name}` is read but nothing is bound to it: it reads (0, 0, 0, 1)"),
                )
                .at(place.map(|token| token.span))
                .hint(format!(
                    "bind it in a scene folder's scene.toml: {name} = {{ procedural = \"noise\" }}"
                ))
            })
            .collect()
    }
}

fn fail_on_errors(diagnostics: &mut Vec<Diagnostic>) -> Result<(), Vec<Diagnostic>> {
    match diagnostics.iter().any(Diagnostic::is_error) {
        true => Err(std::mem::take(diagnostics)),
        false => Ok(()),
    }
}
