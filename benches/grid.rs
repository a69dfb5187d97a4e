//! The grid that the engine is measured by: one region, a million convex cells, three rules.
//!
//! A split in a split cuts a quadrilateral into cells; each is shrunk, extruded and built. Cells at the rim are cut by
//! the outline. Beside it stands the bound: a bare work list with the same cuts and insets and no rules at all.
//!
//! ```text
//! cargo bench --bench grid                        a million cells
//! BOSQUET_CELLS=10000 cargo bench --bench grid    a quick look
//! ```
//!
//! After Criterion's figures a summary follows: both sides run in turn, so that a busy machine slows both, and the
//! medians and the bytes that stay and that were needed at most are printed. Everything runs on one thread.

#[path = "common/counting.rs"]
mod counting;
#[path = "common/grid.rs"]
mod grid;

use counting::counted;
use criterion::{Criterion, Throughput};
use grid::{Grid, leaves};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// How often the summary runs each side.
const ROUNDS: usize = 7;

fn main() {
    let one = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a pool of one thread");
    one.install(|| {
        let grid = Grid::new(cells_asked());
        measure(&grid, &mut Criterion::default().configure_from_args());
        // Under `cargo test --benches` nothing is timed.
        if std::env::args().any(|argument| argument == "--bench") {
            summary(&grid);
        }
    });
}

/// `BOSQUET_CELLS`, or a million.
fn cells_asked() -> usize {
    std::env::var("BOSQUET_CELLS").ok().and_then(|text| text.parse().ok()).unwrap_or(1_000_000)
}

fn measure(grid: &Grid, criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("grid");
    group.sample_size(10).warm_up_time(Duration::from_secs(1)).measurement_time(Duration::from_secs(5));
    group.throughput(Throughput::Elements(leaves(&grid.derive()) as u64));
    group.bench_function("rules", |bencher| bencher.iter_with_large_drop(|| grid.derive()));
    group.bench_function("bound", |bencher| bencher.iter_with_large_drop(|| grid.bound()));
    group.finish();
}

/// Medians of runs in turn, the ratio of the two, and bytes.
fn summary(grid: &Grid) {
    let (mut rules, mut bound) = (Vec::new(), Vec::new());
    for _ in 0..ROUNDS {
        rules.push(rate(|| grid.derive(), leaves));
        bound.push(rate(|| grid.bound(), Vec::len));
    }
    let (rules, bound) = (median(rules), median(bound));
    println!("grid, one thread, medians of {ROUNDS} runs in turn");
    println!("  rules  {rules:>12.0} leaves/s");
    println!("  bound  {bound:>12.0} leaves/s   bare work list: {:.2} times the rules", bound / rules);
    let (derivation, live, peak) = counted(|| grid.derive());
    let count = leaves(&derivation);
    println!("  bytes  {:>12.0} a leaf         at most {:.0}, {count} leaves", per(live, count), per(peak, count));
}

/// Leaves per second of one run; taking the result down is not timed.
fn rate<T>(run: impl Fn() -> T, count: impl Fn(&T) -> usize) -> f64 {
    let begun = Instant::now();
    let result = black_box(run());
    let seconds = begun.elapsed().as_secs_f64();
    count(&result) as f64 / seconds
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

fn per(bytes: isize, count: usize) -> f64 {
    bytes as f64 / count as f64
}
