//! `bosquet diff`: what two runs, plantings or reports have different.
//!
//! Exit codes are those of every diff: 0 equal, 1 different, 2 trouble.

use crate::cli::differences::{record, text};
use crate::cli::disk::Disk;
use crate::cli::job::{Basis, RunArguments};
use crate::cli::prepare::{Prepared, on_threads, world};
use crate::cli::{Ended, place, progress, show};
use bosquet::derive::Progress;
use bosquet::diag::Diagnostic;
use bosquet::diff::{Difference, Side};
use bosquet::export::plants::read_plants;
use bosquet::layout::{Crs, Georeference};
use bosquet::scene;
use serde_json::Value;
use std::path::{Path, PathBuf};

/// Arguments of `bosquet diff`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A place or a layout with `--rules`, plants as GeoJSON or CSV, or a report
    #[arg(value_name = "A")]
    a: PathBuf,
    /// The same of another; A itself with another seed or setting where it is left out
    #[arg(value_name = "B")]
    b: Option<PathBuf>,
    #[command(flatten)]
    run: RunArguments,
    /// The rule file of A alone
    #[arg(long, value_name = "FILE.cga")]
    rules_a: Option<String>,
    /// The rule file of B alone
    #[arg(long, value_name = "FILE.cga")]
    rules_b: Option<String>,
    /// The seed of A alone
    #[arg(long, value_name = "N")]
    seed_a: Option<u64>,
    /// The seed of B alone
    #[arg(long, value_name = "N")]
    seed_b: Option<u64>,
    /// Set an attribute of A alone
    #[arg(long, value_name = "NAME=VALUE")]
    set_a: Vec<String>,
    /// Set an attribute of B alone
    #[arg(long, value_name = "NAME=VALUE")]
    set_b: Vec<String>,
    /// As JSON, every plant among it
    #[arg(long)]
    json: bool,
}

/// A side, and the way to its coordinates where it has plants.
type Known = (Side, Georeference);

/// Runs it.
pub fn run(arguments: &Arguments) -> Ended {
    on_threads(&arguments.run, || match work(arguments) {
        Ok(difference) if difference.is_empty() => Ended::Well,
        Ok(_) => Ended::Different,
        Err(ended) => ended,
    })
}

fn work(arguments: &Arguments) -> Result<Difference, Ended> {
    let progress = progress::interruptible();
    let b = arguments.b.as_ref().unwrap_or(&arguments.a);
    let (a, way) = side(&arguments.a, &arguments.of_a(), None, &progress)?;
    let (b, own) = side(b, &arguments.of_b(), Some(&way), &progress)?;
    let b = shared(b, &own, &way).map_err(Ended::Usage)?;
    if a.plants.is_some() != b.plants.is_some() {
        show::tell("a report knows no single plants: figures alone are compared");
    }
    let difference = Difference::between(&a, &b);
    match arguments.json {
        true => {
            let record = serde_json::to_string_pretty(&record(&difference)).unwrap_or_default();
            show::print(format_args!("{record}\n"));
        }
        false => show::print(text(&difference)),
    }
    Ok(difference)
}

impl Arguments {
    fn of_a(&self) -> RunArguments {
        self.of(&self.rules_a, self.seed_a, &self.set_a)
    }

    fn of_b(&self) -> RunArguments {
        self.of(&self.rules_b, self.seed_b, &self.set_b)
    }

    fn of(&self, rules: &Option<String>, seed: Option<u64>, set: &[String]) -> RunArguments {
        let run = self.run.clone();
        RunArguments {
            rules: rules.clone().or(run.rules),
            seed: seed.or(run.seed),
            set: run.set.into_iter().chain(set.iter().cloned()).collect(),
            ..run
        }
    }
}

/// One side: a run where the path is a place or there are rules, else a file that one wrote.
fn side(path: &Path, run: &RunArguments, way: Option<&Georeference>, progress: &Progress) -> Result<Known, Ended> {
    let named = path.extension().map(|ending| ending.to_ascii_lowercase()).unwrap_or_default();
    let is_layout = run.rules.is_some() && named != "csv";
    if place::find(path).is_some() || is_layout {
        return derived(path, run, progress);
    }
    let name = path.to_string_lossy();
    let bytes = Disk::new(run.limits.limit_file).named(&name).map_err(|error| Ended::Usage(error.to_string()))?;
    written(&bytes, way).map_err(|message| Ended::Usage(format!("`{name}`: {message}")))
}

fn derived(path: &Path, run: &RunArguments, progress: &Progress) -> Result<Known, Ended> {
    let basis = Basis::new(path, run).map_err(Ended::Usage)?;
    let world = world(&basis, run);
    let ready = Prepared::new(&basis, &world).map_err(|unready| match unready.told("nothing is compared") {
        Ended::Wrong => Ended::Trouble,
        other => other,
    })?;
    let options = ready.options(&basis, &world, run);
    let (derivation, found) = bosquet::derive::derive(&ready.program, &ready.layout, &options, progress);
    if progress.stopped() {
        return Err(Ended::Stopped);
    }
    let (scene, left_out) = scene::resolve(&ready.layout, &derivation, &ready.catalogue, &basis.title);
    let errors = ready.found.iter().cloned().chain(found).chain(left_out).filter(Diagnostic::is_error);
    let errors: Vec<Diagnostic> = errors.collect();
    if !errors.is_empty() {
        show::diagnostics(&errors, &ready.program.sources);
        return Err(Ended::Trouble);
    }
    Ok((Side::of_run(&scene, &derivation), scene.georeference.clone()))
}

/// A report, or plants; `way` is that of the other side, where it is known.
fn written(bytes: &[u8], way: Option<&Georeference>) -> Result<Known, String> {
    let json: Option<Value> = serde_json::from_slice(bytes).ok();
    if let Some(side) = json.as_ref().and_then(Side::of_report) {
        return Ok((side, way.cloned().unwrap_or_default()));
    }
    let bytes = json.as_ref().and_then(points).unwrap_or_else(|| bytes.to_vec());
    let own = own_way(&bytes, json.as_ref())?;
    // In the plan of the other side where that is in the same system, or may be: a table in metres does not say.
    let metres = |way: &Georeference| way.crs != Crs::Wgs84;
    let fits = |way: &&Georeference| way.crs == own.crs || (json.is_none() && metres(&own) && metres(way));
    let way = way.filter(fits).cloned().unwrap_or(own);
    let plants = read_plants(&bytes, &way).map_err(|error| error.to_string())?;
    Ok((Side::of_plants(plants), way))
}

/// A collection with its points alone, since exports hold surfaces beside plants.
fn points(json: &Value) -> Option<Vec<u8>> {
    let mut json = json.clone();
    let features = json.get_mut("features")?.as_array_mut()?;
    features.retain(|f| f.pointer("/geometry/type").and_then(Value::as_str).is_none_or(|kind| kind == "Point"));
    serde_json::to_vec(&json).ok()
}

/// The way to the coordinates of a file, around its first position.
fn own_way(bytes: &[u8], json: Option<&Value>) -> Result<Georeference, String> {
    let crs = match json {
        Some(json) => {
            let name = json.pointer("/crs/properties/name").or(json.get("crs")).and_then(Value::as_str);
            name.map_or(Ok(Crs::Wgs84), Crs::parse).map_err(|error| error.to_string())?
        }
        None => {
            let head = bytes.split(|byte| *byte == b'\n').next().unwrap_or_default();
            let in_degrees = String::from_utf8_lossy(head).split(',').any(|title| title.trim() == "longitude");
            if in_degrees { Crs::Wgs84 } else { Crs::Local }
        }
    };
    let local = Georeference::new(crs.clone(), [0.0; 2]);
    let first = json.and_then(|json| json.pointer("/features/0/geometry/coordinates"));
    let first = first.and_then(|c| Some([c.get(0)?.as_f64()?, c.get(1)?.as_f64()?]));
    match (crs, first) {
        (Crs::Local, _) => Ok(Georeference::default()),
        (crs, Some(first)) => Georeference::new(crs, first).map_err(|error| error.to_string()),
        (Crs::Wgs84, None) => local.map_err(|error| error.to_string()),
        (_, None) => Ok(Georeference::default()),
    }
}

/// The second side in the plan of the first; an error where their coordinates have nothing in common.
fn shared(mut side: Side, own: &Georeference, way: &Georeference) -> Result<Side, String> {
    let Some(plants) = side.plants.as_mut().filter(|plants| own != way && !plants.is_empty()) else { return Ok(side) };
    if own.crs != way.crs {
        return Err(format!("A is in `{}`, B in `{}`: bring them into one coordinate system", way.crs, own.crs));
    }
    plants.iter_mut().for_each(|plant| plant.position = way.to_plan(own.to_world(plant.position)));
    Ok(side)
}
