//! What a run can write: the one table of kinds and endings.

use bosquet::export::plan::{self, PlanOptions, PlanSize, Resolution};
use bosquet::export::plants::{plants_csv, plants_geojson};
use bosquet::export::report::{ReportInput, report_json};
use bosquet::export::schedule::schedule_csv;
use bosquet::export::surfaces::surfaces_geojson;
use bosquet::scene::Scene;
use bosquet::text::{nearest, suggestion};
use std::path::PathBuf;

/// What every writer may use.
pub struct Material<'a> {
    /// The resolved scene.
    pub scene: &'a Scene,
    /// What the report says.
    pub report: &'a ReportInput<'a>,
    /// How plans are drawn.
    pub plan: &'a PlanOptions,
}

/// A kind of output.
struct Kind {
    name: &'static str,
    /// Endings, each with its writer; the first kind that has an ending is meant by a bare file name.
    endings: &'static [(&'static str, Writer)],
}

type Writer = fn(&Material) -> Result<Vec<u8>, String>;

/// Every kind. A bare ending means the first kind that has it, unless [`BARE`] says otherwise.
static KINDS: &[Kind] = &[
    Kind { name: "plan", endings: &[("svg", plan_svg), ("png", plan_png)] },
    Kind { name: "surfaces", endings: &[("geojson", |m| Ok(surfaces_geojson(m.scene).into()))] },
    Kind {
        name: "plants",
        endings: &[("geojson", |m| Ok(plants_geojson(m.scene).into())), ("csv", |m| Ok(plants_csv(m.scene).into()))],
    },
    Kind { name: "schedule", endings: &[("csv", |m| Ok(schedule_csv(m.scene).into()))] },
    Kind { name: "report", endings: &[("json", |m| Ok(report_json(m.report).into()))] },
];

/// Kinds of a bare ending that holds more than one: `garden.geojson` has plants and surfaces.
const BARE: &[(&str, Writer)] = &[("geojson", everything_geojson), ("csv", |m| Ok(schedule_csv(m.scene).into()))];

/// One file to write.
pub struct Output {
    /// Where.
    pub path: PathBuf,
    write: Writer,
}

impl Output {
    /// `[KIND:]FILE`.
    pub fn parse(text: &str) -> Result<Output, String> {
        let (kind, file) = match text.split_once(':') {
            // A single letter before the colon is a drive.
            Some((kind, file)) if kind.len() > 1 => (Some(kind), file),
            _ => (None, text),
        };
        let path = PathBuf::from(file);
        let ending = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        let write = match kind {
            Some(kind) => of_kind(kind, &ending)?,
            None => bare(&ending)?,
        };
        Ok(Output { path, write })
    }

    /// Its bytes.
    pub fn bytes(&self, material: &Material) -> Result<Vec<u8>, String> {
        (self.write)(material).map_err(|message| format!("`{}`: {message}", self.path.display()))
    }
}

fn of_kind(name: &str, ending: &str) -> Result<Writer, String> {
    let Some(kind) = KINDS.iter().find(|kind| kind.name == name) else {
        let known: Vec<&str> = KINDS.iter().map(|kind| kind.name).collect();
        let near = suggestion(nearest(name, known.iter().copied()));
        return Err(format!("there is no output kind `{name}`{near} (there are {})", known.join(", ")));
    };
    let found = kind.endings.iter().find(|(known, _)| *known == ending);
    found.map(|(_, write)| *write).ok_or_else(|| {
        let known: Vec<String> = kind.endings.iter().map(|(known, _)| format!(".{known}")).collect();
        format!("`{name}` is written as {}, not as `.{ending}`", known.join(" or "))
    })
}

fn bare(ending: &str) -> Result<Writer, String> {
    let own = BARE.iter().find(|(known, _)| *known == ending);
    let usual = KINDS.iter().flat_map(|kind| kind.endings).find(|(known, _)| *known == ending);
    own.or(usual).map(|(_, write)| *write).ok_or_else(|| {
        let mut known: Vec<String> =
            KINDS.iter().flat_map(|kind| kind.endings).map(|(known, _)| format!(".{known}")).collect();
        known.sort();
        known.dedup();
        format!("nothing is written as `.{ending}`: there are {}", known.join(", "))
    })
}

fn plan_svg(material: &Material) -> Result<Vec<u8>, String> {
    Ok(plan::svg(&plan::draw(material.scene, material.plan)).into())
}

fn plan_png(material: &Material) -> Result<Vec<u8>, String> {
    let drawing = plan::draw(material.scene, material.plan);
    plan::png(&drawing, Resolution::Drawn).map_err(|error| error.to_string())
}

/// Plants and surfaces as one collection.
fn everything_geojson(material: &Material) -> Result<Vec<u8>, String> {
    let parse = |text: String| serde_json::from_str::<serde_json::Value>(&text).map_err(|error| error.to_string());
    let mut all = parse(surfaces_geojson(material.scene))?;
    let mut plants = parse(plants_geojson(material.scene))?;
    let more = plants["features"].as_array_mut().map(std::mem::take).unwrap_or_default();
    if let Some(features) = all["features"].as_array_mut() {
        features.extend(more);
    }
    serde_json::to_vec(&all).map_err(|error| error.to_string())
}

/// `800x600` pixels, or `0.5m` for metres per pixel.
pub fn size(text: &str) -> Result<PlanSize, String> {
    let wrong = || format!("`{text}` is not a size: write it as in `1600x1200`, or `0.5m` for metres per pixel");
    if let Some(metres) = text.strip_suffix('m') {
        let metres: f64 = metres.parse().map_err(|_| wrong())?;
        return if metres > 0.0 && metres.is_finite() { Ok(PlanSize::MetresPerPixel(metres)) } else { Err(wrong()) };
    }
    let (width, height) = text.split_once(['x', '×']).ok_or_else(wrong)?;
    match (width.parse(), height.parse()) {
        (Ok(width), Ok(height)) if width > 0 && height > 0 => Ok(PlanSize::Pixels(width, height)),
        _ => Err(wrong()),
    }
}
