//! The sampler beside others: points for each second, on one thread.
//!
//! ```text
//! cargo bench --bench poisson
//! ```
//!
//! All sides run in turn and only the time of their thread is counted. Printed are the median rate, how dense the result
//! is (points times the square of their distance for each unit of area; for varying radii the mean distance), the least
//! distance as a share of what was asked, and the share of probes that still find room. Ours leave none.
//! `bluenoise` tries four places on the rim of each disk unless it is told otherwise, and so leaves many gaps; with
//! thirty it leaves few. It puts neighbours at the least distance, which makes the result denser than random disks are.

use bosquet::geometry::{Area, PointGrid, Polygon};
use bosquet::placement::{Amount, Field, Radii, Site, boundary, clusters, semirandom, uniform};
use bosquet::seed::Seed;
use glam::DVec2;
use rand_xoshiro::Xoshiro256PlusPlus;
use std::hint::black_box;
use std::sync::OnceLock;
use std::time::Instant;

/// How often each side runs.
const ROUNDS: u64 = 5;
/// Points for each square of their distance, when no more fit (Feder's 0.547 · 4 / π).
const JAMMED: f64 = 0.6965;
/// Places looked at for room.
const PROBES: usize = 200_000;

/// A centre and a radius.
type Disk = (DVec2, f64);

/// A contender.
struct Side<'a> {
    name: &'static str,
    area: &'a Area,
    /// The least radius.
    least: f64,
    run: &'a dyn Fn(u64) -> Vec<Disk>,
}

fn main() {
    // Under `cargo test --benches` nothing is timed.
    let timed = std::env::args().any(|argument| argument == "--bench");
    let rounds = if timed { ROUNDS } else { 1 };
    for count in if timed { [54_000.0, 1_000_000.0] } else { [300.0, 500.0] } {
        compare(count, rounds);
    }
    strategies(if timed { 100_000.0 } else { 300.0 }, rounds);
}

/// All samplers, at one distance in one square; and varied radii in a star.
fn compare(count: f64, rounds: u64) {
    let side = (count / JAMMED).sqrt();
    let square = Site::new(Polygon::rectangle(DVec2::ZERO, DVec2::splat(side)).expect("an extent").into());
    let star = Site::new(star(count / 0.098));
    let ours = |site: &Site, radii: &Radii, seed: u64| {
        let placed = semirandom(site, radii, &Amount::default(), Seed(seed)).expect("allowed");
        placed.spots.iter().map(|spot| (spot.position, spot.radius)).collect()
    };
    let blue = |seed: u64, samples: Option<u32>| {
        let mut noise = bluenoise::BlueNoise::<Xoshiro256PlusPlus>::from_seed(side as f32, side as f32, 1.0, seed);
        samples.map(|samples| noise.with_samples(samples));
        noise.map(|p| (DVec2::new(f64::from(p.x), f64::from(p.y)), 0.5)).collect()
    };
    let fast = |seed| {
        let sampler = fast_poisson::Poisson2D::new().with_dimensions([side, side], 1.0).with_seed(seed);
        sampler.iter().map(|[x, y]| (DVec2::new(x, y), 0.5)).collect()
    };
    let one = |seed| ours(&square, &Radii::constant(0.5), seed);
    let many = |seed| ours(&star, &varied(), seed);
    let (few, thirty) = (|seed| blue(seed, None), |seed| blue(seed, Some(30)));
    let in_square = |name, run| Side { name, area: square.area(), least: 0.5, run };
    let mut sides: Vec<Side> = vec![
        in_square("one radius, square", &one),
        in_square("bluenoise", &few),
        in_square("bluenoise, 30 samples", &thirty),
        Side { name: "radii N(2, 0.5), star", area: star.area(), least: 1.0, run: &many },
    ];
    if count < 1e5 {
        sides.push(in_square("fast_poisson", &fast));
    }
    println!("{count:.0} points");
    let (mut rates, mut last) = (vec![Vec::new(); sides.len()], vec![Vec::new(); sides.len()]);
    for round in 1..=rounds {
        for (index, side) in sides.iter().enumerate() {
            let begun = seconds();
            let found = black_box((side.run)(round));
            rates[index].push(found.len() as f64 / (seconds() - begun));
            last[index] = found;
        }
    }
    let rates: Vec<f64> = rates.into_iter().map(median).collect();
    for ((side, rate), disks) in sides.iter().zip(&rates).zip(&last) {
        report(side, *rate, rates[0] / rate, disks);
    }
}

fn report(side: &Side, rate: f64, ratio: f64, disks: &[Disk]) {
    let points: &[DVec2] = &disks.iter().map(|(p, _)| *p).collect::<Vec<_>>();
    let most = disks.iter().map(|(_, r)| *r).fold(side.least, f64::max);
    let mean = disks.iter().map(|(_, r)| *r).sum::<f64>() / disks.len().max(1) as f64;
    let density = 4.0 * mean * mean * disks.len() as f64 / side.area.area();
    let grid = PointGrid::new(points, 2.0 * most);
    let near = |p: DVec2| grid.within(p, 2.2 * most).map(move |i| (i, (points[i].distance(p), disks[i].1)));
    let share = |i: usize| near(disks[i].0).filter(move |(j, _)| *j != i).map(move |(_, (d, r))| d / (r + disks[i].1));
    let least = (0..disks.len()).flat_map(share).fold(f64::INFINITY, f64::min);
    let probes = uniform(side.area, PROBES, Seed(7)).expect("allowed");
    let free = probes.iter().filter(|p| near(**p).all(|(_, (d, r))| d >= r + side.least)).count();
    println!(
        "  {:<22} {rate:>10.0} points/s (ours x{ratio:.2})  {:>8} points  N d2 {density:.3}  mean radius {mean:.3}  \
         least {least:.4}  free {:.1e}",
        side.name,
        disks.len(),
        free as f64 / PROBES as f64
    );
}

/// What the other strategies cost beside the plain one.
fn strategies(count: f64, rounds: u64) {
    let site = Site::new(star(count / 0.098));
    let amount = Amount::default();
    let runs: [(&str, &dyn Fn(u64) -> usize); 3] = [
        ("semirandom", &|seed| semirandom(&site, &varied(), &amount, Seed(seed)).expect("allowed").spots.len()),
        ("boundary", &|seed| {
            boundary(&site, site.area(), 1e4, &varied(), &amount, Seed(seed)).expect("allowed").spots.len()
        }),
        ("1000 clusters", &|seed| {
            clusters(&site, 40.0, [1000, 1000], &varied(), &amount, Seed(seed)).expect("allowed").spots.len()
        }),
    ];
    for (name, run) in runs {
        let rate = |seed: u64| {
            let begun = seconds();
            black_box(run(seed)) as f64 / (seconds() - begun)
        };
        println!("  {name:<22} {:>10.0} points/s", median((1..=rounds).map(rate).collect()));
    }
}

fn varied() -> Radii {
    Radii { mean: Field::Constant(2.0), deviation: 0.5, least: None }
}

fn median(mut rates: Vec<f64>) -> f64 {
    rates.sort_by(f64::total_cmp);
    rates[rates.len() / 2]
}

/// Seconds this thread has run, where the system tells; else seconds on the clock since the first call.
fn seconds() -> f64 {
    static BEGUN: OnceLock<Instant> = OnceLock::new();
    let told = std::fs::read_to_string("/proc/thread-self/schedstat").ok();
    let nanoseconds = told.and_then(|text| text.split(' ').next()?.parse::<f64>().ok());
    nanoseconds.map_or_else(|| BEGUN.get_or_init(Instant::now).elapsed().as_secs_f64(), |n| n * 1e-9)
}

/// A concave polygon with 80 vertices and five holes, of the given area.
fn star(area: f64) -> Area {
    let mut random = Seed(11).draw("star");
    let mut ring = |centre: DVec2, count: usize, low: f64, high: f64| -> Vec<DVec2> {
        let step = std::f64::consts::TAU / count as f64;
        (0..count).map(|i| centre + DVec2::from_angle(step * i as f64) * random.uniform(low, high)).collect()
    };
    let outer = ring(DVec2::ZERO, 80, 0.55, 1.0);
    let around = |i: usize| DVec2::from_angle(i as f64 * std::f64::consts::TAU / 5.0) * 0.3;
    let holes: Vec<_> = (0..5).map(|i| ring(around(i), 20, 0.05, 0.12)).collect();
    let unit = Polygon::new(&outer, &holes).expect("a star");
    let scale = (area / unit.area()).sqrt();
    unit.mapped(|p| p * scale).into()
}
