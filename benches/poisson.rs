//! The sampler beside another: points for each second, saturated, on one thread.
//!
//! ```text
//! cargo bench --bench poisson                      54,000 points
//! BOSQUET_POINTS=1000000 cargo bench --bench poisson
//! ```
//!
//! All sides run in turn and only the time of their thread is counted; medians and the best are printed. The other
//! places one radius in a rectangle and leaves gaps; ours leave none.

use bosquet::geometry::{Area, Polygon};
use bosquet::placement::{Amount, Field, Radii, Site, semirandom};
use bosquet::seed::Seed;
use glam::DVec2;
use std::hint::black_box;
use std::sync::OnceLock;
use std::time::Instant;

/// How often each side runs.
const ROUNDS: u64 = 5;
/// Points for each square of their distance, when no more fit (Feder's 0.547 · 4 / π).
const JAMMED: f64 = 0.6965;

fn main() {
    // Under `cargo test --benches` nothing is timed.
    let timed = std::env::args().any(|argument| argument == "--bench");
    let asked = std::env::var("BOSQUET_POINTS").ok().and_then(|text| text.parse().ok());
    let count: f64 = asked.unwrap_or(if timed { 54_000.0 } else { 500.0 });
    let rounds = if timed { ROUNDS } else { 1 };
    let side = (count / JAMMED).sqrt();
    let square = Site::new(Polygon::rectangle(DVec2::ZERO, DVec2::splat(side)).expect("an extent").into());
    let star = Site::new(star(count / 0.098));
    let varied = Radii { mean: Field::Constant(2.0), deviation: 0.5, least: None };
    let ours = |site: &Site, radii: &Radii, seed: u64| {
        semirandom(site, radii, &Amount::default(), Seed(seed)).expect("allowed").spots.len()
    };
    let sides: [(&str, &dyn Fn(u64) -> usize); 3] = [
        ("one radius, square", &|seed| ours(&square, &Radii::constant(0.5), seed)),
        ("radii N(2, 0.5), star", &|seed| ours(&star, &varied, seed)),
        ("fast_poisson", &|seed| {
            fast_poisson::Poisson2D::new().with_dimensions([side, side], 1.0).with_seed(seed).iter().count()
        }),
    ];
    let mut rates = vec![Vec::new(); sides.len()];
    for round in 1..=rounds {
        for ((_, run), rates) in sides.iter().zip(&mut rates) {
            let begun = seconds();
            let found = black_box(run(round));
            rates.push((found as f64 / (seconds() - begun), found));
        }
    }
    for ((name, _), mut rates) in sides.iter().zip(rates) {
        rates.sort_by(|a, b| a.0.total_cmp(&b.0));
        let (rate, found) = rates[rates.len() / 2];
        println!(
            "{name:<24} {rate:>12.0} points/s at the median, {:>12.0} at best   {found} points",
            rates[rates.len() - 1].0
        );
    }
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
