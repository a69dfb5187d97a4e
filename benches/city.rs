//! A city: lots with houses, drives and doors, every zone with strategies of its own, attributes blended over a context
//! of 180 m (Niese et al. 2022, §5.2–5.5).
//!
//! ```text
//! cargo bench --bench city                       1,000 to 100,000 lots, on 1 and 2 threads
//! BOSQUET_LOTS=2000 cargo bench --bench city     a quick look
//! ```
//!
//! Every size is derived on one thread and on two in turn; medians of seconds and lots per second are printed, the
//! growth from size to size, and the bytes that the outcome holds and that were needed at most. What is timed is the
//! derivation: the layout is there before.

#[path = "common/counting.rs"]
mod counting;

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::geometry::Polygon;
use bosquet::layout::{Feature, Kind, Layout, Region, Shapes};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::value::Value;
use bosquet::world::MemoryWorld;
use counting::counted;
use glam::DVec2;
use std::time::Instant;

const RULES: &str = r#"
@Context(180)
attr radius = 2.5
@Context(180)
attr deviation = 0.3
@Context(180)
attr palette = "temperate"

@Zone(lot, residential)
Home --> set(envelope.walls, 3) boundary(width = 3, radius = 1.5, radius_sd = 0.2, density = 0.8) { Shrub }
         semirandom(radius = radius, radius_sd = deviation, density = 0.5) { Tree } Lawn.
@Zone(lot, commercial)
Shop --> set(envelope.walls, 3) regular(cell = 8) { Tree } Paving.
@Zone(lot, industrial)
Works --> set(envelope.walls, 3) semirandom(radius = radius + 2, density = 0.2) { Tree } Grass.
@Zone(lot, street)
Street --> equidistant(spacing = 9) { Tree } Paving.
@Zone(lot, other)
Park --> cluster(cluster_radius = 8, clusters = 3, radius = radius, radius_sd = deviation) { Tree }
         single(radius = 4) { Tree } Lawn.

Tree  --> plant(palette = palette, max_age = 60, tree_ratio = 1, species_count = 4)
Shrub --> plant(palette = palette, max_age = 20, tree_ratio = 0, species_count = 3)
"#;

/// Metres along the sides of a lot.
const LOT: DVec2 = DVec2::new(24.0, 32.0);
/// Lots between two streets.
const ROW: usize = 20;
const ZONES: [&str; 5] = ["residential", "residential", "commercial", "other", "industrial"];
/// How often each size is derived on each number of threads.
const ROUNDS: usize = 3;

fn main() {
    // Under `cargo test --benches` nothing is timed.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let asked = std::env::var("BOSQUET_LOTS").ok().and_then(|text| text.parse().ok());
    let sizes = asked.map_or(vec![1_000, 10_000, 100_000], |lots| vec![lots]);
    println!("city, medians of {ROUNDS} runs in turn");
    println!("   lots    plants  threads   seconds    lots/s  bytes/lot  at most");
    for lots in sizes {
        let city = City::new(lots);
        let mut seconds = [Vec::new(), Vec::new()];
        for _ in 0..ROUNDS {
            for threads in [1, 2] {
                seconds[threads - 1].push(city.seconds(threads));
            }
        }
        let (derivation, live, peak) = counted(|| city.derive(1));
        for threads in [1, 2] {
            let seconds = median(&mut seconds[threads - 1]);
            let (plants, rate) = (plants(&derivation), lots as f64 / seconds);
            let [live, peak] = [live, peak].map(|bytes| bytes as f64 / lots as f64);
            println!("{lots:>7} {plants:>9} {threads:>8} {seconds:>9.2} {rate:>9.0} {live:>10.0} {peak:>8.0}");
        }
    }
}

fn median(values: &mut [f64]) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn plants(derivation: &Derivation) -> usize {
    let is_plant = |shape: &bosquet::shape::Shape| matches!(&shape.geometry, bosquet::shape::Geometry::Element(_));
    derivation.lots.iter().flat_map(|lot| &lot.outcome.leaves).filter(|leaf| is_plant(&leaf.shape)).count()
}

struct City {
    program: Program,
    layout: Layout,
    world: MemoryWorld,
}

impl City {
    fn new(lots: usize) -> City {
        let world = MemoryWorld::default().with("city.cga", RULES);
        let (program, found) = check(&world, "city.cga");
        assert!(!found.iter().any(|d| d.is_error()), "{found:?}");
        let across = (lots as f64).sqrt().ceil() as usize;
        let (mut regions, mut features) = (Vec::new(), Vec::new());
        for index in 0..lots {
            lot(index, [index % across, index / across], &mut regions, &mut features);
        }
        City { program, layout: Layout { regions, features, ..Layout::default() }, world }
    }

    fn derive(&self, threads: usize) -> Derivation {
        let options = Options {
            start: None,
            seed: Seed(1),
            set: Vec::new(),
            catalogue: Catalogue::built_in(),
            world: &self.world,
            limits: Limits::default(),
        };
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool");
        let (derivation, found) = pool.install(|| derive(&self.program, &self.layout, &options, &Progress::default()));
        assert!(!found.iter().any(|d| d.is_error()), "{:?}", found.first());
        derivation
    }

    fn seconds(&self, threads: usize) -> f64 {
        let begun = Instant::now();
        let derivation = self.derive(threads);
        let seconds = begun.elapsed().as_secs_f64();
        drop(derivation);
        seconds
    }
}

/// A lot with a house that is turned a little, a door and a drive; every so many rows a street of one lot's depth.
fn lot(index: usize, [column, row]: [usize; 2], regions: &mut Vec<Region>, features: &mut Vec<Feature>) {
    let corner = LOT * DVec2::new(column as f64, row as f64);
    let at = |x: f64, y: f64| corner + DVec2::new(x, y);
    let is_street = row % 3 == 2;
    let outline = [at(0.0, 0.0), at(LOT.x, 0.0), at(LOT.x, if is_street { 6.0 } else { LOT.y }), at(0.0, LOT.y)];
    let mut random = Seed(7).child(index as u64).random();
    let first = features.len();
    if !is_street {
        let (x, y) = (random.uniform(6.0, 8.0), random.uniform(8.0, 12.0));
        let house = [at(x, y), at(x + 10.0, y + 0.4), at(x + 9.6, y + 9.0), at(x - 0.3, y + 8.7)];
        let drive = [at(x + 1.0, 0.0), at(x + 4.0, 0.0), at(x + 4.0, y), at(x + 1.0, y)];
        features.push(feature(Kind::Building, Shapes::Areas(vec![Polygon::from_ring(&house)])));
        features.push(feature(Kind::Driveway, Shapes::Areas(vec![Polygon::from_ring(&drive)])));
        features.push(feature(Kind::Marker("door".into()), Shapes::Points(vec![at(x + 6.0, y + 0.2)])));
    }
    let zone = if is_street { "street" } else { ZONES[(column / ROW + row / 3) % ZONES.len()] };
    let id: std::sync::Arc<str> = index.to_string().into();
    regions.push(Region {
        name: id.clone(),
        id,
        kind: Kind::Lot,
        zone: zone.into(),
        polygon: Polygon::from_ring(&outline),
        elevation: 0.0,
        start: None,
        seed: None,
        attributes: [("radius".into(), Value::Float(random.uniform(1.5, 3.5)))].into(),
        features: (first..features.len()).collect(),
        neighbours: Vec::new(),
    });
}

fn feature(kind: Kind, shapes: Shapes) -> Feature {
    Feature {
        id: "".into(),
        name: "".into(),
        kind,
        shapes,
        elevation: 0.0,
        height: 0.0,
        attributes: Default::default(),
    }
}
