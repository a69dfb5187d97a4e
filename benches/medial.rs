//! The medial axis against the Voronoi diagram it is made of: 480 outlines, one thread.
//!
//! A third each: stars with star-shaped holes, lots minus a house, bent strips with round holes. Beside the axis with
//! its checks and its pruning stands the bound: the crate's diagram of the same edges, and nothing else.
//!
//! ```text
//! cargo bench --bench medial
//! ```

use boostvoronoi::prelude::{Builder, Diagram};
use bosquet::geometry::{Area, MedialAxis, Polygon, Pruning, difference};
use bosquet::seed::{Random, Seed};
use criterion::Criterion;
use glam::{DAffine2, DVec2};
use std::hint::black_box;
use std::time::Instant;

const OUTLINES: u64 = 480;

/// How often the summary runs each side.
const ROUNDS: usize = 7;

fn main() {
    let areas = outlines();
    let edges: Vec<Vec<[i32; 4]>> = areas.iter().map(edges).collect();
    let mut criterion = Criterion::default().configure_from_args().sample_size(10);
    criterion.bench_function("medial/axis", |bencher| bencher.iter(|| axes(&areas)));
    criterion.bench_function("medial/diagram", |bencher| bencher.iter(|| diagrams(&edges)));
    if std::env::args().any(|argument| argument == "--bench") {
        summary(&areas, &edges);
    }
}

fn axes(areas: &[Area]) -> Vec<MedialAxis> {
    areas.iter().map(|area| MedialAxis::new(black_box(area), Pruning::default())).collect()
}

fn diagrams(edges: &[Vec<[i32; 4]>]) -> Vec<Diagram> {
    let build = |edges: &Vec<[i32; 4]>| Builder::<i32>::default().with_segments(black_box(edges).iter())?.build();
    edges.iter().filter_map(|edges| build(edges).ok()).collect()
}

/// Medians of runs in turn, so that a busy machine slows both.
fn summary(areas: &[Area], edges: &[Vec<[i32; 4]>]) {
    let (mut axis, mut diagram) = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        axis.push(micros(|| axes(areas)));
        diagram.push(micros(|| diagrams(edges)));
    }
    let (axis, diagram) = (median(axis), median(diagram));
    let vertices: usize = edges.iter().map(Vec::len).sum();
    println!("medial, one thread, {OUTLINES} outlines, {vertices} vertices, medians of {ROUNDS} runs in turn");
    println!("  axis     {axis:>8.1} µs an outline");
    println!("  diagram  {diagram:>8.1} µs an outline   the axis takes {:.2} times as long", axis / diagram);
}

fn micros<T>(work: impl Fn() -> T) -> f64 {
    let start = Instant::now();
    black_box(work());
    start.elapsed().as_secs_f64() * 1e6 / OUTLINES as f64
}

fn median(mut times: Vec<f64>) -> f64 {
    times.sort_by(f64::total_cmp);
    times[times.len() / 2]
}

/// The edges in millimetres.
fn edges(area: &Area) -> Vec<[i32; 4]> {
    let step = |x: f64| (x * 1000.0).round() as i32;
    area.edges().map(|(a, b)| [step(a.x), step(a.y), step(b.x), step(b.y)]).collect()
}

fn outlines() -> Vec<Area> {
    let makers: [fn(&mut Random) -> Area; 3] = [star, lot, strip];
    (0..OUTLINES).map(|i| makers[i as usize % 3](&mut Seed(1).child(i).random())).collect()
}

fn ring(centre: DVec2, count: usize, random: &mut Random, [low, high]: [f64; 2]) -> Vec<DVec2> {
    let step = std::f64::consts::TAU / count as f64;
    (0..count).map(|i| centre + DVec2::from_angle(step * i as f64) * random.uniform(low, high)).collect()
}

fn star(random: &mut Random) -> Area {
    let size = random.uniform(20.0, 200.0);
    let outer = ring(DVec2::ZERO, 20 + random.below(60) as usize, random, [0.5 * size, size]);
    let centre = |i: usize| DVec2::from_angle(i as f64 * 1.6) * size * 0.25;
    let holes: Vec<_> =
        (0..random.below(4) as usize).map(|i| ring(centre(i), 8, random, [0.03 * size, 0.08 * size])).collect();
    Polygon::new(&outer, &holes).into_iter().collect()
}

fn lot(random: &mut Random) -> Area {
    let size = DVec2::new(random.uniform(15.0, 60.0), random.uniform(15.0, 60.0));
    let house = random.uniform(0.1, 0.3) * size;
    let part = |a, b| -> Area { Polygon::rectangle(a, b).into_iter().collect() };
    let drive = part(DVec2::new(house.x * 0.5, -1.0), house + 0.1);
    let built = part(house, house + random.uniform(0.2, 0.4) * size);
    let rest = difference(&difference(&part(DVec2::ZERO, size), &built), &drive);
    rest.transformed(&DAffine2::from_angle(random.uniform(0.0, 3.0)))
}

fn strip(random: &mut Random) -> Area {
    let (bend, width) = (random.uniform(20.0, 80.0), random.uniform(2.0, 8.0));
    let at = |i: usize, r: f64| DVec2::from_angle(i as f64 * 0.05) * (bend + r) + DVec2::X * (i % 3) as f64 * 0.01;
    let outer: Vec<_> = (0..40).map(|i| at(i, width)).chain((0..40).rev().map(|i| at(i, -width))).collect();
    let disk = |i: usize| Polygon::regular(at(8 + 10 * i, 0.0), 0.4 * width, 12);
    let holes: Vec<_> = (0..random.below(3) as usize).filter_map(disk).map(|disk| disk.outer().to_vec()).collect();
    Polygon::new(&outer, &holes).into_iter().collect()
}
