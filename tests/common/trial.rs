//! A program tried on an odd layout, from bytes to bytes; whatever it is, the promises of a run hold.

use crate::place;
use crate::programs::{Files, program};
use crate::read::is_told_well;
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

/// Layouts as `place` has them: plain, holed, concave, sliver, tiny, huge, on a slope of numbers, several lots.
const LAYOUTS: [&[&str]; 10] = [
    &["rect 40 30"],
    &["rect 30 30", "hole 10,10 10,20 20,20 20,10", "feature building 22,3 28,3 28,9 22,9 height=6"],
    &["polygon 0,0 30,0 30,6 6,6 6,24 30,24 30,30 0,30", "attribute size=5"],
    &["rect 60 0.004"],
    &["rect 0.02 0.03"],
    &["rect 900000 700000"],
    &["polygon 0,0 20,0.0001 40,0 21,7 20,30 19,7", "elevation 1e6"],
    &["rect 12 9", "rect 12 9 12 0", "start A", "rect 12 9 24 0", "kind park", "feature street 0,-4 36,-4"],
    &["polygon 0,0 9,0 9,9", "feature tree 3,2", "feature path 0,0 9,9", "rect 4 4 20 20"],
    &["polygon 1e6,1e6 1000030,1e6 1000030,1000012.5 1000015,1000012.5 1000015,1000025 1e6,1000025"],
];

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
    tree: String,
    told: Vec<String>,
    plan: String,
    plants: String,
    surfaces: String,
    schedule: String,
}

/// A program and where it is tried: the first byte chooses the layout, the second the seed.
pub fn of_bytes(bytes: &[u8]) -> (Files, Layout, Seed) {
    let (head, rest) = bytes.split_at(bytes.len().min(2));
    let byte = |index: usize| head.get(index).copied().unwrap_or_default();
    let layout = place::parse(LAYOUTS[usize::from(byte(0)) % LAYOUTS.len()]).expect("a layout");
    (program(rest), layout, Seed(byte(1).into()))
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
        numbers.extend([cover.elevation, cover.area.area(), bounds.min.x, bounds.max.y].iter().filter(|_| !cover.area.is_empty()));
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

/// A garden for every kind of region, which asks for streets, buildings and neighbours.
const GARDEN: &str = r#"
attr density = 0.02
@StartRule
Any --> without("building", 0.5) setback(1) { street.front : Hedge | front = Path | remainder : Rest }
Hedge --> extrude(1.5) comp(f) { top : Box. | side : Yew. }
Path --> splitArea(x) { 5 : Gravel. | ~1 : Stone. }
Rest --> case inside("park") : Lawn. else : split(x) { ~6 : Bed }*
Bed --> scatter(surface, density * geometry.area, uniform) { Tree } innerRectangle(scope) { shape : Lawn. | remainder : Meadow. }
Tree --> case overlaps(intra) : NIL else : plant("birch")
"#;

/// Reads bytes as a layout and makes a garden of it.
pub fn laid_out(bytes: &[u8]) {
    static PROGRAM: LazyLock<Program> = LazyLock::new(|| {
        let (program, told) = check(&MemoryWorld::default().with("main.cga", GARDEN), "main.cga");
        assert!(!told.iter().any(Diagnostic::is_error), "{told:?}");
        program
    });
    let (layout, told) = bosquet::layout::read_geojson("layout.geojson", bytes);
    told.iter().for_each(is_told_well);
    assert!(!layout.regions.is_empty() || !layout.features.is_empty() || !told.is_empty(), "nothing and nothing said");
    run(&PROGRAM, &layout, Seed(3), &MemoryWorld::default());
}
