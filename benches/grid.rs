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

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::geometry::{self, Area, Bounds, Polygon};
use bosquet::layout::{Kind, Layout, Region};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::world::MemoryWorld;
use counting::counted;
use criterion::{Criterion, Throughput};
use glam::DVec2;
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Natural side of a cell, metres; what the rules below write out.
const CELL: f64 = 4.0;

const RULES: &str = "
Lot --> split(x) { ~4 : split(z) { ~4 : Cell }* }*
Cell --> offset(-0.5, inside) extrude(3) Leaf.
";

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

fn leaves(derivation: &Derivation) -> usize {
    derivation.lots.iter().map(|lot| lot.outcome.leaves.len()).sum()
}

/// A checked program and the layout it runs on.
struct Grid {
    program: Program,
    layout: Layout,
    world: MemoryWorld,
    outline: Polygon,
}

impl Grid {
    /// About so many cells in a quadrilateral without a right angle.
    fn new(cells: usize) -> Grid {
        let corners = [(0.0, 0.0), (1.0, 0.03), (0.97, 1.0), (0.04, 0.96)].map(|(x, y)| DVec2::new(x, y));
        let unit = geometry::ring_area(&corners);
        let side = CELL * (cells as f64 / unit).sqrt();
        let outline = Polygon::from_ring(&corners.map(|c| c * side));
        let world = MemoryWorld::default().with("grid.cga", RULES);
        let (program, found) = check(&world, "grid.cga");
        assert!(found.is_empty(), "{found:?}");
        let layout = Layout { regions: vec![region(outline.clone())], ..Layout::default() };
        Grid { program, layout, world, outline }
    }

    fn derive(&self) -> Derivation {
        let options = Options {
            start: Some("Lot".into()),
            seed: Seed(1),
            set: Vec::new(),
            catalogue: Catalogue::built_in(),
            world: &self.world,
            limits: Limits::default(),
        };
        let (derivation, found) = derive(&self.program, &self.layout, &options, &Progress::default());
        assert!(found.is_empty(), "{found:?}");
        derivation
    }

    /// The same cells from a plain work list: cut, cut, pushed, popped, shrunk, kept.
    fn bound(&self) -> Vec<(Area, Bounds)> {
        let whole = Area::from(self.outline.clone());
        let columns = geometry::bands(&whole, DVec2::X, &cuts(&whole, DVec2::X));
        let mut waiting: Vec<Area> =
            columns.iter().flat_map(|column| geometry::bands(column, DVec2::Y, &cuts(column, DVec2::Y))).collect();
        let mut built = Vec::new();
        while let Some(cell) = waiting.pop() {
            let cell = geometry::offset(&cell, -0.5);
            let bounds = cell.bounds();
            built.push((cell.into_translated(-bounds.min), bounds));
        }
        built
    }
}

/// Where cells of about [`CELL`] begin and end along an axis.
fn cuts(area: &Area, axis: DVec2) -> Vec<f64> {
    let bounds = area.bounds();
    let (from, length) = (bounds.min.dot(axis), bounds.size().dot(axis));
    let count = (length / CELL).round().max(1.0);
    (0..=count as usize).map(|i| from + length * i as f64 / count).collect()
}

fn region(polygon: Polygon) -> Region {
    Region {
        id: "grid".into(),
        name: "grid".into(),
        kind: Kind::Lot,
        zone: "".into(),
        polygon,
        elevation: 0.0,
        start: None,
        seed: None,
        attributes: Default::default(),
        features: Vec::new(),
        neighbours: Vec::new(),
    }
}
