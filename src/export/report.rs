//! The run's report as JSON: what went in, what came out, what was reported and what was wrong.
//!
//! In: plain values of a finished run. Out: JSON with keys in a fixed order and no date, so that equal runs write equal
//! bytes. Every file's hash is beside its name: two reports tell whether two runs can be compared.

use crate::diag::Diagnostic;
use crate::scene::{self, Scene};
use serde::{Serialize, Serializer};
use std::collections::BTreeMap;

/// Everything a report says.
#[derive(Clone, Debug, Serialize)]
pub struct ReportInput<'a> {
    /// The program's version.
    pub version: &'a str,
    /// The seed of the run.
    pub seed: u64,
    /// The attributes that were set for all regions, by name: by the manifest and on the command line.
    pub settings: BTreeMap<String, String>,
    /// The files that went in, with the BLAKE3 hash of each in hexadecimal.
    #[serde(serialize_with = "inputs")]
    pub inputs: Vec<(String, String)>,
    /// The figures of the scene.
    pub summary: Summary,
    /// The regions on which no rule started, by id.
    pub without_rule: Vec<String>,
    /// How often each rule was applied.
    pub counts_by_rule: BTreeMap<String, usize>,
    /// How many shapes carry each symbol, leaves and inner ones.
    pub counts_by_symbol: BTreeMap<String, usize>,
    /// What the rules reported.
    #[serde(serialize_with = "reports")]
    pub reports: &'a [scene::Report],
    /// What was wrong, or worth knowing.
    pub diagnostics: Vec<ReportedDiagnostic>,
}

/// The figures of a scene: areas in m².
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Summary {
    /// Regions that were derived.
    pub lots: usize,
    /// Surfaces on the ground.
    pub covers: usize,
    /// Things with height.
    pub solids: usize,
    /// Lines without width.
    pub lines: usize,
    /// Plants, those of the layout among them.
    pub plants: usize,
    /// Plants of the layout.
    pub existing_plants: usize,
    /// Furniture and architectural objects.
    pub objects: usize,
    /// Area of the regions.
    #[serde(serialize_with = "plain")]
    pub lot_area: f64,
    /// Area under crowns, overlaps counted twice.
    #[serde(serialize_with = "plain")]
    pub crown_area: f64,
    /// Plants by species; by category where the species is not known.
    pub plants_by_species: BTreeMap<String, usize>,
    /// Area of surfaces by material, as they lie: what a later one hides is counted.
    #[serde(serialize_with = "plain_map")]
    pub area_by_material: BTreeMap<String, f64>,
}

/// A diagnostic as machines read it.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ReportedDiagnostic {
    /// `note`, `warning` or `error`.
    pub severity: &'static str,
    /// The stable word.
    pub code: &'static str,
    /// What was found and what would do.
    pub message: String,
    /// Where, in words: `rules/garden.cga:12:5`.
    pub place: String,
    /// Advice.
    pub hints: Vec<String>,
    /// The lot it happened in; empty where it concerns all.
    pub lot: String,
    /// The rules on the way down, innermost first.
    pub rules: Vec<String>,
}

/// The report as indented JSON with a final line break.
pub fn report_json(input: &ReportInput<'_>) -> String {
    // Only numbers, texts, lists and maps with text keys: writing these cannot fail.
    let text = serde_json::to_string_pretty(input).unwrap_or_default();
    text + "\n"
}

impl Summary {
    /// The figures of a scene.
    pub fn of(scene: &Scene) -> Summary {
        let mut summary = Summary {
            lots: scene.lots.len(),
            covers: scene.covers.len(),
            solids: scene.solids.len(),
            lines: scene.lines.len(),
            plants: scene.plants.len(),
            existing_plants: scene.plants.iter().filter(|plant| plant.existing).count(),
            objects: scene.objects.len(),
            lot_area: scene.lots.iter().map(|lot| lot.area.area()).sum(),
            ..Summary::default()
        };
        for plant in &scene.plants {
            let name = if plant.species.is_empty() { &plant.category } else { &plant.species };
            *summary.plants_by_species.entry(name.to_string()).or_default() += 1;
            summary.crown_area += std::f64::consts::PI * plant.crown_radius * plant.crown_radius;
        }
        for cover in &scene.covers {
            *summary.area_by_material.entry(cover.material.name.to_string()).or_default() += cover.area.area();
        }
        summary
    }
}

impl ReportedDiagnostic {
    /// A diagnostic whose place has been put into words.
    pub fn of(diagnostic: &Diagnostic, place: impl Into<String>) -> ReportedDiagnostic {
        ReportedDiagnostic {
            severity: diagnostic.severity.word(),
            code: diagnostic.code,
            message: diagnostic.message.clone(),
            place: place.into(),
            hints: diagnostic.hints.clone(),
            lot: diagnostic.lot.as_deref().unwrap_or_default().to_owned(),
            rules: diagnostic.trace.iter().map(|step| step.rule.to_string()).collect(),
        }
    }
}

/// A file that went in.
#[derive(Serialize)]
struct InputFile<'a> {
    name: &'a str,
    blake3: &'a str,
}

fn inputs<S: Serializer>(files: &[(String, String)], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(files.iter().map(|(name, blake3)| InputFile { name, blake3 }))
}

/// What was reported under one key.
#[derive(Serialize)]
struct ReportedValues<'a> {
    key: &'a str,
    count: usize,
    #[serde(serialize_with = "plain")]
    sum: f64,
    #[serde(serialize_with = "plain")]
    min: f64,
    #[serde(serialize_with = "plain")]
    max: f64,
    #[serde(serialize_with = "plain")]
    average: f64,
    texts: &'a BTreeMap<String, usize>,
}

fn reports<S: Serializer>(reports: &[scene::Report], to: S) -> Result<S::Ok, S::Error> {
    to.collect_seq(reports.iter().map(|report| {
        let numbers = report.count.saturating_sub(report.texts.values().sum());
        ReportedValues {
            key: &report.key,
            count: report.count,
            sum: report.sum,
            min: report.least,
            max: report.greatest,
            average: if numbers == 0 { 0.0 } else { report.sum / numbers as f64 },
            texts: &report.texts,
        }
    }))
}

/// A number without a needless `.0`; `null` where it is none.
struct Plain(f64);

impl Serialize for Plain {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let rounded = (self.0 * 1e6).round() / 1e6;
        // Up to here every whole number is exact.
        if rounded.fract() == 0.0 && rounded.abs() < 9e15 {
            return to.serialize_i64(rounded as i64);
        }
        to.serialize_f64(if rounded.is_finite() { rounded } else { self.0 })
    }
}

fn plain<S: Serializer>(number: &f64, to: S) -> Result<S::Ok, S::Error> {
    Plain(*number).serialize(to)
}

fn plain_map<S: Serializer>(numbers: &BTreeMap<String, f64>, to: S) -> Result<S::Ok, S::Error> {
    to.collect_map(numbers.iter().map(|(key, number)| (key, Plain(*number))))
}
