//! A program tried on an odd layout, from bytes to bytes; whatever it is, the promises of a run hold.

use crate::told::is_told_well;
use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::export::plan::{PlanOptions, draw, svg};
use bosquet::export::plants::{plants_csv, plants_geojson};
use bosquet::export::schedule::schedule_csv;
use bosquet::export::surfaces::surfaces_geojson;
use bosquet::layout::Layout;
use bosquet::scene::{Scene, resolve};
use bosquet::seed::Seed;
use bosquet::shape::{Derivation, Outcome};
use bosquet::trace::{TreeOptions, tree_text};
use bosquet::world::MemoryWorld;
use std::sync::LazyLock;
use std::time::Duration;

/// Small enough for thousands of runs; time is no limit, since it would not be the same twice.
pub const LIMITS: Limits =
    Limits { depth: 12, calls: 40, shapes: 1_500, children: 300, time: Duration::from_secs(86_400) };

/// A program as its two files.
#[derive(Debug)]
pub struct Files {
    /// Begins on lots with `Lot`.
    pub main: String,
    /// What it imports, as `second.cga`.
    pub second: String,
}

/// What a trial came to.
pub enum Verdict {
    /// The checker has said why not.
    Refused(Vec<Diagnostic>),
    /// It ran; what came out.
    Ran(Box<Written>),
}

/// A run as bytes.
#[derive(PartialEq)]
pub struct Written {
    pub tree: String,
    pub told: Vec<String>,
    pub plan: String,
    pub plants: String,
    pub surfaces: String,
    pub schedule: String,
}

/// What the files may ask for.
pub fn world(files: &Files) -> MemoryWorld {
    let world = MemoryWorld::default().with("main.cga", &files.main).with("second.cga", &files.second);
    world.with("table.csv", "a,b\n1,2\nx,é\n").with("a", "one\ntwo\n")
}

/// Checks and derives, on one thread and on two.
pub fn tried(files: &Files, layout: &Layout, seed: Seed) -> Verdict {
    static POOLS: LazyLock<[rayon::ThreadPool; 2]> = LazyLock::new(|| [1, 2].map(threads));
    let world = world(files);
    let (program, told) = check(&world, "main.cga");
    told.iter().for_each(is_told_well);
    if told.iter().any(Diagnostic::is_error) {
        return Verdict::Refused(told);
    }
    let [one, two] = [&POOLS[0], &POOLS[1]].map(|pool| pool.install(|| run(&program, layout, seed, &world)));
    assert!(one == two, "threads change it:\n{}\n{}", one.tree, two.tree);
    Verdict::Ran(Box::new(one))
}

fn threads(count: usize) -> rayon::ThreadPool {
    let stack = 64 << 20;
    rayon::ThreadPoolBuilder::new().num_threads(count).stack_size(stack).build().expect("threads")
}

/// Derives, resolves and writes all that can be written.
pub fn run(program: &Program, layout: &Layout, seed: Seed, world: &MemoryWorld) -> Written {
    let catalogue = Catalogue::built_in();
    let options = Options { start: None, seed, set: Vec::new(), catalogue, world, limits: LIMITS };
    let (derivation, told) = derive(program, layout, &options, &Progress::default());
    told.iter().for_each(is_told_well);
    derivation.lots.iter().for_each(|lot| is_within_limits(&lot.outcome));
    let (scene, left_out) = resolve(layout, &derivation, catalogue, "a trial");
    left_out.iter().for_each(is_told_well);
    is_finite(&scene);
    written(&derivation, &scene, told.iter().chain(&left_out))
}

fn written<'d>(derivation: &Derivation, scene: &Scene, told: impl Iterator<Item = &'d Diagnostic>) -> Written {
    let written = Written {
        tree: tree_text(derivation, &TreeOptions::default()),
        told: told.map(|d| format!("{d:?}")).collect(),
        plan: svg(&draw(scene, &PlanOptions { codes: true, ..PlanOptions::default() })),
        plants: plants_geojson(scene) + &plants_csv(scene),
        surfaces: surfaces_geojson(scene),
        schedule: schedule_csv(scene),
    };
    // Words may say anything; numbers stand in tags.
    let tags = written.plan.split('<').map(|tag| tag.split('>').next().unwrap_or_default());
    let numbers = tags.flat_map(|tag| tag.split(|c: char| !c.is_alphanumeric()));
    numbers.for_each(|word| assert!(!["NaN", "inf"].contains(&word), "the plan has {word}"));
    for geojson in [plants_geojson(scene), surfaces_geojson(scene)] {
        let read: serde_json::Value = serde_json::from_str(&geojson).expect("JSON");
        let features = read["features"].as_array().expect("features");
        features.iter().for_each(|feature| assert!(is_placed(&feature["geometry"]["coordinates"]), "{feature}"));
    }
    written
}

/// All coordinates are numbers; none at all is a surface without extent.
fn is_placed(coordinates: &serde_json::Value) -> bool {
    match coordinates {
        serde_json::Value::Array(inner) => inner.iter().all(|c| c.is_number() || c.is_array() && is_placed(c)),
        other => other.is_null(),
    }
}

fn is_within_limits(outcome: &Outcome) {
    // The rule at work when the limit is met may still make what it makes.
    let most = LIMITS.shapes + LIMITS.children;
    assert!(outcome.nodes.len() <= most, "{} shapes", outcome.nodes.len());
    for node in &outcome.nodes {
        assert!(outcome.nodes.get(node.parent.0 as usize).is_some(), "an orphan");
    }
}

fn is_finite(scene: &Scene) {
    let mut numbers: Vec<f64> = Vec::new();
    for cover in &scene.covers {
        let bounds = cover.area.bounds();
        numbers.extend(
            [cover.elevation, cover.area.area(), bounds.min.x, bounds.max.y].iter().filter(|_| !cover.area.is_empty()),
        );
    }
    for solid in &scene.solids {
        numbers.extend([solid.base, solid.height, solid.footprint.area()]);
        let vertices = solid.mesh.iter().flat_map(|mesh| mesh.positions.iter());
        numbers.extend(vertices.flat_map(|v| v.to_array()));
    }
    numbers.extend(scene.lines.iter().flat_map(|line| line.points.iter().flat_map(|p| p.to_array())));
    for plant in &scene.plants {
        let sizes = [plant.elevation, plant.heading, plant.spacing_radius, plant.crown_radius, plant.age, plant.height];
        let more = [plant.trunk_diameter, plant.crown_height, plant.leaf_area, plant.pruning];
        numbers.extend(sizes.iter().chain(&more).chain(&plant.position.to_array()));
    }
    for object in &scene.objects {
        let place = [object.position.x, object.position.y, object.heading, object.base];
        numbers.extend(place.iter().chain(&object.size));
    }
    assert!(numbers.iter().all(|number| number.is_finite()), "the scene has numbers that are none");
}
