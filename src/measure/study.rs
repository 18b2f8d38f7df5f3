//! What to measure: a study names a scene, its variants and the reference they are held against.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use glam::UVec2;
use serde::{Deserialize, Serialize};

use crate::translate::Probe;

/// A study, as its TOML file has it.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Study {
    /// What it is about.
    pub title: String,
    /// The scene of all variants that name no other; a path from the study's folder.
    pub scene: PathBuf,
    /// Width and height of every picture.
    #[serde(default = "default_size", deserialize_with = "size")]
    pub size: UVec2,
    /// The moments, `iTime` in seconds, of all families that have none of their own.
    #[serde(default = "default_times")]
    pub times: Vec<f64>,
    /// The value to compare besides the picture.
    #[serde(default, deserialize_with = "probe")]
    pub probe: Option<Probe>,
    /// Whether to compare each picture with the one a frame before, too.
    #[serde(default)]
    pub flicker: bool,
    /// How often each variant is timed.
    #[serde(default = "default_repeats")]
    pub repeats: u32,
    /// Errors for which the report names the cheapest variant: medians of the probe, or the picture's
    /// RMSE where there is no probe.
    #[serde(default)]
    pub goals: Vec<f64>,
    /// Macros of all variants and of the reference.
    #[serde(default)]
    pub define: Defines,
    /// What the variants are held against.
    pub reference: Reference,
    /// What a person found in it: the end of the report, in Markdown.
    #[serde(default)]
    pub findings: String,
    /// The variants.
    #[serde(rename = "family")]
    pub families: Vec<Family>,
}

/// How long a frame is shown, in seconds.
const FRAME: f64 = 1.0 / 60.0;

/// Macros with their values.
pub type Defines = BTreeMap<String, Value>;

/// What is taken for true.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Reference {
    /// Its scene, if it is another.
    pub scene: Option<PathBuf>,
    /// Its macros.
    #[serde(default)]
    pub define: Defines,
    /// Macros that refine it: how far the two are apart is how far the reference can be trusted.
    #[serde(default)]
    pub refined: Defines,
    /// Whether it is drawn in double precision.
    #[serde(default)]
    pub precision: ReferencePrecision,
}

/// What a reference is computed in.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
pub enum ReferencePrecision {
    /// 64 bits.
    #[default]
    #[serde(rename = "f64")]
    Double,
    /// 32 bits, where the device has no others; rounding and discretisation are then not told apart.
    #[serde(rename = "f32")]
    Single,
}

/// Variants that differ in the values of a few macros: a curve of a plot.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Family {
    /// Its name.
    pub name: String,
    /// Its scene, if it is another.
    pub scene: Option<PathBuf>,
    /// Macros of all its variants.
    #[serde(default)]
    pub define: Defines,
    /// What its variants are held against, if it is not what the study's others are.
    pub reference: Option<Reference>,
    /// Its moments, if they are not the study's.
    pub times: Option<Vec<f64>>,
    /// Macros with the values that they take in turn; of several, every combination.
    #[serde(default)]
    pub vary: BTreeMap<String, Vec<Value>>,
}

/// The value of a macro, as GLSL has it: a number of TOML keeps its point.
#[derive(Clone, Debug, PartialEq, Eq, Hash, PartialOrd, Ord, Serialize)]
pub struct Value(pub String);

impl<'de> Deserialize<'de> for Value {
    fn deserialize<D: serde::Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        #[derive(Deserialize)]
        #[serde(untagged, expecting = "a number or a string")]
        enum Written {
            Int(i64),
            Float(f64),
            Text(String),
        }
        Ok(Value(match Written::deserialize(deserializer)? {
            Written::Int(value) => value.to_string(),
            Written::Float(value) => format!("{value:?}"),
            Written::Text(value) => value,
        }))
    }
}

fn default_size() -> UVec2 {
    UVec2::new(240, 135)
}

fn default_times() -> Vec<f64> {
    vec![1.0]
}

fn default_repeats() -> u32 {
    5
}

fn size<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<UVec2, D::Error> {
    let text = String::deserialize(deserializer)?;
    let sides = text.split_once('x').map(|(x, y)| (x.parse(), y.parse()));
    match sides {
        Some((Ok(x), Ok(y))) if x > 0 && y > 0 => Ok(UVec2::new(x, y)),
        _ => Err(serde::de::Error::custom(format!(
            "`{text}` is no size: write it as \"240x135\""
        ))),
    }
}

fn probe<'de, D: serde::Deserializer<'de>>(deserializer: D) -> Result<Option<Probe>, D::Error> {
    let text = String::deserialize(deserializer)?;
    text.parse().map(Some).map_err(serde::de::Error::custom)
}

/// A variant of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct Variant {
    /// The family that it belongs to.
    pub family: String,
    /// What tells it apart in its family, as `STEP_FACTOR=0.4`; empty if it is alone.
    pub label: String,
    /// Its scene.
    pub scene: PathBuf,
    /// Its macros.
    pub defines: Vec<(String, String)>,
    /// Its moments.
    pub times: Vec<f64>,
    /// What it is held against, by its number among [`Study::references`]; of no meaning for a
    /// reference itself.
    pub reference: usize,
}

impl Variant {
    /// Family and label.
    pub fn name(&self) -> String {
        name(&self.family, &self.label)
    }
}

/// How a variant is called: its family, and what tells it apart there, if anything does.
pub(super) fn name(family: &str, label: &str) -> String {
    match label {
        "" => family.to_owned(),
        label => format!("{family} {label}"),
    }
}

impl Study {
    /// Reads a study from the text of its file; the message names the line.
    pub fn parse(text: &str) -> Result<Self, String> {
        let study: Study = toml::from_str(text).map_err(|error| error.to_string())?;
        let problem = if study.families.is_empty() {
            "a study has at least one [[family]]"
        } else if study.all_times().any(<[f64]>::is_empty) {
            "`times` names no moment"
        } else if study.flicker && study.all_times().flatten().any(|&time| time < FRAME) {
            "`flicker` compares with the frame before, so that `times` are at least a sixtieth of a second"
        } else if study.repeats == 0 {
            "`repeats` is at least 1"
        } else {
            return Ok(study);
        };
        Err(problem.to_owned())
    }

    fn all_times(&self) -> impl Iterator<Item = &[f64]> {
        let own = self
            .families
            .iter()
            .filter_map(|family| family.times.as_deref());
        std::iter::once(self.times.as_slice()).chain(own)
    }

    /// The moments of a family.
    pub fn times_of<'a>(&'a self, family: &'a Family) -> &'a [f64] {
        family.times.as_deref().unwrap_or(&self.times)
    }

    /// All variants, in order, with scenes as paths from `folder`.
    pub fn variants(&self, folder: &Path) -> Vec<Variant> {
        let mut variants = Vec::new();
        let references = self.distinct_references();
        for family in &self.families {
            let times = self.times_of(family);
            let own = (family.reference.as_ref().unwrap_or(&self.reference), times);
            let reference = references.iter().position(|known| *known == own);
            let scene = folder.join(family.scene.as_ref().unwrap_or(&self.scene));
            let mut labels: Vec<Vec<(&String, &Value)>> = vec![Vec::new()];
            for (name, values) in &family.vary {
                let extended = labels.iter().flat_map(|before| {
                    values.iter().map(move |value| {
                        let mut label = before.clone();
                        label.push((name, value));
                        label
                    })
                });
                labels = extended.collect();
            }
            variants.extend(labels.into_iter().map(|label| {
                let own = label.iter().copied();
                let text: Vec<_> = own.clone().map(|(n, v)| format!("{n}={}", v.0)).collect();
                Variant {
                    family: family.name.clone(),
                    label: text.join(" "),
                    scene: scene.clone(),
                    defines: merged([&self.define, &family.define], own),
                    times: times.to_owned(),
                    reference: reference.unwrap_or(0),
                }
            }));
        }
        variants
    }

    /// What is held for true, and when. The same reference at other moments is another one: only what is
    /// held against the same at the same moments can be compared.
    fn distinct_references(&self) -> Vec<(&Reference, &[f64])> {
        let mut distinct = vec![(&self.reference, self.times.as_slice())];
        for family in &self.families {
            let reference = family.reference.as_ref().unwrap_or(&self.reference);
            let own = (reference, self.times_of(family));
            if !distinct.contains(&own) {
                distinct.push(own);
            }
        }
        distinct
    }

    /// Every reference, with that refined if it is to be.
    pub fn references(&self, folder: &Path) -> Vec<(Variant, Option<Variant>)> {
        let references = self.distinct_references().into_iter();
        references
            .map(|(reference, times)| {
                let scene = folder.join(reference.scene.as_ref().unwrap_or(&self.scene));
                let of = |family: &str, refined: Option<&Defines>| Variant {
                    family: family.to_owned(),
                    label: String::new(),
                    scene: scene.clone(),
                    defines: merged(
                        [&self.define, &reference.define],
                        refined.into_iter().flatten(),
                    ),
                    times: times.to_owned(),
                    reference: 0,
                };
                let refined = Some(&reference.refined).filter(|refined| !refined.is_empty());
                let refined = refined.map(|refined| of("refined reference", Some(refined)));
                (of("reference", None), refined)
            })
            .collect()
    }
}

/// Macros of which the later win.
fn merged<'a>(
    common: [&'a Defines; 2],
    own: impl Iterator<Item = (&'a String, &'a Value)>,
) -> Vec<(String, String)> {
    let all = common.into_iter().flatten().chain(own);
    let all: BTreeMap<_, _> = all
        .map(|(name, value)| (name.clone(), value.0.clone()))
        .collect();
    all.into_iter().collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    const TEXT: &str = r#"
title = "March"
scene = "../template"
size = "64x36"
times = [1, 2.5]
probe = "t"
define = { TERRAIN_OCTAVES = 4 }
[reference]
define = { STEP_FACTOR = 0.02 }
refined = { STEP_FACTOR = 0.01 }
[[family]]
name = "adaptive"
vary = { STEP_FACTOR = [0.1, 1.0], MAX_STEPS = ["80", 300] }
[[family]]
name = "other"
scene = "../relaxation"
define = { TERRAIN_OCTAVES = 9 }
reference = { scene = "../canyon" }
[[family]]
name = "late"
times = [3600, 86400]
"#;

    #[test]
    fn variants_are_every_combination_at_their_moments() {
        let study = Study::parse(TEXT).expect("a study");
        let variants = study.variants(Path::new("studies"));
        let names: Vec<_> = variants.iter().map(Variant::name).collect();
        assert_eq!(
            names,
            [
                "adaptive MAX_STEPS=80 STEP_FACTOR=0.1",
                "adaptive MAX_STEPS=80 STEP_FACTOR=1.0",
                "adaptive MAX_STEPS=300 STEP_FACTOR=0.1",
                "adaptive MAX_STEPS=300 STEP_FACTOR=1.0",
                "other",
                "late"
            ]
        );
        let pair = |name: &str, value: &str| (name.to_owned(), value.to_owned());
        assert_eq!(
            variants[1].defines,
            [
                pair("MAX_STEPS", "80"),
                pair("STEP_FACTOR", "1.0"),
                pair("TERRAIN_OCTAVES", "4")
            ]
        );
        assert_eq!(variants[4].defines, [pair("TERRAIN_OCTAVES", "9")]);
        assert_eq!(variants[4].scene, Path::new("studies/../relaxation"));
        let references = study.references(Path::new(""));
        let [
            (first, Some(refined)),
            (other, None),
            (late, Some(late_refined)),
        ] = references.as_slice()
        else {
            panic!("{references:?}");
        };
        assert_eq!(first.defines[0], pair("STEP_FACTOR", "0.02"));
        assert_eq!(refined.defines[0], pair("STEP_FACTOR", "0.01"));
        assert_eq!(other.scene, Path::new("../canyon"));
        let numbers = [0, 4, 5].map(|variant: usize| variants[variant].reference);
        assert_eq!(numbers, [0, 1, 2]);
        assert_eq!((&late.scene, &late.defines), (&first.scene, &first.defines));
        for early in [&variants[0], &variants[4], first, refined, other] {
            assert_eq!(early.times, [1.0, 2.5]);
        }
        for late in [&variants[5], late, late_refined] {
            assert_eq!(late.times, [3600.0, 86400.0]);
        }
    }

    #[test]
    fn what_is_wrong_is_named() {
        for (from, to, words) in [
            ("64x36", "64", "is no size"),
            ("\"t\"", "\"t t\"", "names no value"),
            ("times = [1, 2.5]", "times = []", "no moment"),
            ("times = [3600, 86400]", "times = []", "no moment"),
            ("title", "titel", "unknown field `titel`"),
            ("size = \"64x36\"", "repeats = 0", "at least 1"),
            ("= 0.02", "= []", "a number or a string"),
            (
                "times = [1, 2.5]",
                "flicker = true\ntimes = [0]",
                "the frame before",
            ),
        ] {
            let message = Study::parse(&TEXT.replacen(from, to, 1)).expect_err(from);
            assert!(message.contains(words), "{from}: {message}");
        }
    }
}
