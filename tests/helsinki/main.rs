//! Patterns and baselines beside the street and park trees of Helsinki, as the table of `docs/stats.md`:
//!
//! ```text
//! cargo test --test helsinki -- --nocapture
//! ```
//!
//! Needs the layers of OpenStreetMap (ODbL) in `shared/data/helsinki_osm` beside the project, and says so where they are
//! not there. Every planting is made with [`SEEDS`] seeds and thinned at random to the number of real trees in the lots;
//! the numbers are means. Rules of your own: put them into `helsinki.cga`.

mod city;
mod measure;
#[path = "../common/patterns.rs"]
mod patterns;

use bosquet::placement::uniform;
use bosquet::seed::Seed;
use bosquet::world::MemoryWorld;
use city::City;
use glam::DVec2;
use measure::{DISTANCES, Ground, Row};

/// How many plantings of each sort are made.
const SEEDS: u64 = 5;

/// Plantings and the file of the rules that make them.
const PLANTINGS: [(&str, &str); 4] = [
    ("patterns, chosen values", "main.cga"),
    ("patterns as they come", "patterns/zones.cga"),
    ("rows on axes", "patterns/baseline-benes.cga"),
    ("fully random", "patterns/baseline-random.cga"),
];

#[test]
fn patterns_are_nearer_to_real_trees_than_chance() {
    let Some(city) = City::read() else {
        return println!("skipped: the layers of shared/data/helsinki_osm are not there");
    };
    let ground = Ground::of(&city).expect("trees in the lots");
    let world = patterns::world(include_str!("helsinki.cga"));
    let several = |name: &str, make: &dyn Fn(Seed) -> Vec<DVec2>| {
        let rows: Vec<Row> = (1..=SEEDS).map(|seed| measured(&ground, &make(Seed(seed)), Seed(seed))).collect();
        (name.to_owned(), Row::mean(&rows))
    };
    let mut rows = vec![("real".to_owned(), ground.measure(ground.real()))];
    rows.extend(PLANTINGS.map(|(name, file)| several(name, &|seed| planted(&city, &world, file, seed))));
    rows.push(several("random points", &|seed| random(&ground, seed)));
    let lots = city.layout.regions.len();
    println!("{} trees, {} of them in {lots} lots", city.trees.len(), ground.real().len());
    print(&rows, ground.window.area() / 1e4);
    let [chosen, usual, _, random] = [1, 2, 3, 4].map(|index| mean_score(&rows, index));
    assert!(chosen.max(usual) < random.min(1.0), "scores of {chosen}, {usual} and {random}");
}

fn planted(city: &City, world: &MemoryWorld, file: &str, seed: Seed) -> Vec<DVec2> {
    let plants = patterns::plants(world, file, &city.layout, seed);
    plants.iter().map(|plant| city.layout.georeference.to_world(plant.position).into()).collect()
}

fn random(ground: &Ground, seed: Seed) -> Vec<DVec2> {
    uniform(ground.window.region(), ground.real().len(), seed).expect("lots with an area")
}

fn measured(ground: &Ground, planted: &[DVec2], seed: Seed) -> Row {
    let thinned = ground.thinned(planted, seed.named("thin"));
    Row { planted: planted.len() as f64, ..ground.measure(&thinned) }
}

/// The mean of the scores there are.
fn mean_score(rows: &[(String, Row)], index: usize) -> f64 {
    let (real, random) = (&rows[0].1, &rows[rows.len() - 1].1);
    let scores: Vec<f64> = rows[index].1.scores(real, random).into_iter().flatten().collect();
    scores.iter().sum::<f64>() / scores.len() as f64
}

/// Two tables in Markdown: what each planting is like, and how far it is from the real trees.
fn print(rows: &[(String, Row)], hectares: f64) {
    println!("\n{hectares:.1} ha of lots; quartiles 25 / 50 / 75 %, metres\n");
    println!(
        "| | planted | measured | per ha | R | nearest tree | lot edge | building | street |\n|{}",
        "---|".repeat(9)
    );
    for (name, row) in rows {
        let quartiles = row.quartiles.map(|[a, b, c]| format!("{a:.1} / {b:.1} / {c:.1}")).join(" | ");
        let density = row.count / hectares;
        println!("| {name} | {:.0} | {:.0} | {density:.1} | {:.2} | {quartiles} |", row.planted, row.count, row.index);
    }
    println!("\ndistance (score)\n\n| | {} | mean score |\n|{}", DISTANCES.join(" | "), "---|".repeat(7));
    for (index, (name, row)) in rows.iter().enumerate() {
        let scores = row.scores(&rows[0].1, &rows[rows.len() - 1].1);
        let cell = |i: usize| {
            let score = scores[i].map_or("–".to_owned(), |score| format!("{score:.2}"));
            format!("{:.2} ({score})", row.distances[i])
        };
        let cells: Vec<String> = (0..DISTANCES.len()).map(cell).collect();
        println!("| {name} | {} | {:.2} |", cells.join(" | "), mean_score(rows, index));
    }
}
