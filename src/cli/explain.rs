//! `bosquet explain`: which rules, with which arguments, choices and numbers, made what lies at a place.
//!
//! All lots are derived as usual, and the lots of what was found once more with their record.

use crate::cli::disk::Disk;
use crate::cli::explained::text;
use crate::cli::job::{Basis, RunArguments};
use crate::cli::prepare::{Prepared, on_threads, world};
use crate::cli::{Ended, progress, show};
use bosquet::diag::Diagnostic;
use bosquet::layout::{Crs, Georeference};
use bosquet::scene::{self, Scene};
use bosquet::trace::{Explanation, Thing, at, by_id, explain};
use glam::DVec2;
use serde_json::json;
use std::path::PathBuf;

/// Arguments of `bosquet explain`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A layout (GeoJSON), or a place: a folder with `bosquet.toml`
    #[arg(value_name = "LAYOUT|PLACE")]
    input: PathBuf,
    #[command(flatten)]
    run: RunArguments,
    /// What lies at these coordinates of the layout, from top to bottom
    #[arg(long, value_name = "X,Y", allow_hyphen_values = true, value_parser = coordinates)]
    #[arg(required_unless_present = "id", conflicts_with = "id")]
    at: Option<Coordinates>,
    /// The plant, surface or object with this id, or with the only one that begins so
    #[arg(long, value_name = "ID")]
    id: Option<String>,
    /// As JSON
    #[arg(long)]
    json: bool,
}

/// Coordinates of the layout: x or longitude first.
#[derive(Clone, Copy)]
struct Coordinates([f64; 2]);

/// Runs it.
pub fn run(arguments: &Arguments) -> Ended {
    match Basis::new(&arguments.input, &arguments.run) {
        Ok(basis) => on_threads(&arguments.run, || work(arguments, &basis)),
        Err(message) => Ended::Usage(message),
    }
}

fn work(arguments: &Arguments, basis: &Basis) -> Ended {
    let world = world(basis, &arguments.run);
    let ready = match Prepared::new(basis, &world) {
        Ok(ready) => ready,
        Err(unready) => return unready.told("nothing is explained"),
    };
    let progress = progress::interruptible();
    let options = ready.options(basis, &world, &arguments.run);
    let (program, layout) = (&ready.program, &ready.layout);
    let (derivation, mut found) = bosquet::derive::derive(program, layout, &options, &progress);
    let (scene, left_out) = scene::resolve(layout, &derivation, &ready.catalogue, &basis.title);
    if progress.stopped() {
        return Ended::Stopped;
    }
    found.extend(left_out);
    let things = match things(arguments, &scene) {
        Ok(things) => things,
        Err(message) => return Ended::Usage(message),
    };
    let explanations = explained(&ready, basis, &world, arguments, &scene, &things);
    told(arguments, &scene.georeference, &explanations, &things);
    let errors: Vec<Diagnostic> = ready.found.iter().cloned().chain(found).filter(Diagnostic::is_error).collect();
    show::diagnostics(&errors, &program.sources);
    Ended::Well
}

/// What is asked about.
fn things<'a>(arguments: &Arguments, scene: &'a Scene) -> Result<Vec<Thing<'a>>, String> {
    if let Some(Coordinates(place)) = arguments.at {
        let plan = scene.georeference.to_plan(place);
        let things = if plan.is_finite() { at(scene, plan) } else { Vec::new() };
        return if things.is_empty() { Err(nothing_at(place, plan, scene)) } else { Ok(things) };
    }
    let id = arguments.id.as_deref().unwrap_or_default();
    let things = by_id(scene, id);
    let whole = things.iter().filter(|thing| &*thing.origin().id == id).count();
    match things.len() {
        0 => Err(format!("nothing has the id `{id}`: ids stand in exported plants and surfaces")),
        1 => Ok(things),
        _ if whole > 0 => Ok(things),
        more => Err(format!("{more} things have an id that begins with `{id}`: write more of it")),
    }
}

/// Nothing lies there: where the lots are instead.
fn nothing_at([x, y]: [f64; 2], plan: DVec2, scene: &Scene) -> String {
    let far = |lot: &scene::LotOutline| match lot.area.contains(plan) {
        true => 0.0,
        false => lot.area.distance_to_edges(plan),
    };
    let near = scene.lots.iter().map(|lot| (far(lot), lot)).min_by(|(a, _), (b, _)| a.total_cmp(b));
    let unit = if scene.georeference.crs == Crs::Wgs84 { "longitude, latitude" } else { "x, y" };
    let crs = &scene.georeference.crs;
    match near.filter(|(distance, _)| distance.is_finite()) {
        Some((0.0, lot)) => format!("nothing lies at {x}, {y} in lot `{}`", lot.id),
        Some((distance, lot)) => format!(
            "nothing lies at {x}, {y} ({unit} in {crs}): the nearest lot, `{}`, is {distance:.1} m away",
            lot.id
        ),
        None => format!("nothing lies at {x}, {y} ({unit} in {crs})"),
    }
}

fn explained(
    ready: &Prepared,
    basis: &Basis,
    world: &Disk,
    arguments: &Arguments,
    scene: &Scene,
    things: &[Thing],
) -> Vec<Explanation> {
    let lots: Vec<usize> = (0..ready.layout.regions.len())
        .filter(|index| things.iter().any(|thing| thing.origin().lot == ready.layout.regions[*index].id))
        .collect();
    let options = ready.options(basis, world, &arguments.run);
    let progress = bosquet::derive::Progress::default();
    let (recorded, _) = bosquet::derive::recorded(&ready.program, &ready.layout, &options, &progress, &lots);
    things.iter().map(|thing| explain(&ready.program, &recorded, scene, *thing)).collect()
}

fn told(arguments: &Arguments, way: &Georeference, explanations: &[Explanation], things: &[Thing]) {
    let places = things.iter().map(|thing| match thing {
        Thing::Plant(plant) => Some(way.to_world(plant.position)),
        Thing::Object(object) => Some(way.to_world(object.position)),
        _ => None,
    });
    let all: Vec<(&Explanation, Option<[f64; 2]>)> = explanations.iter().zip(places).collect();
    if arguments.json {
        let records: Vec<serde_json::Value> = all
            .iter()
            .map(|(explanation, place)| {
                let mut record = json!(explanation);
                record["coordinates"] = json!(place);
                record
            })
            .collect();
        return show::print(format_args!("{}\n", serde_json::to_string_pretty(&records).unwrap_or_default()));
    }
    show::print(text(&all));
}

fn coordinates(text: &str) -> Result<Coordinates, String> {
    let numbers: Option<Vec<f64>> =
        text.split(',').map(|n| n.trim().parse().ok().filter(|n: &f64| n.is_finite())).collect();
    match numbers.as_deref() {
        Some([x, y]) => Ok(Coordinates([*x, *y])),
        _ => Err("write two numbers as in `12.5,40`: x and y, or longitude and latitude".into()),
    }
}
