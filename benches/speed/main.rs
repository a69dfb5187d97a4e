//! How fast bosquet is, in one run: what it does against what bounds it, medians and ratios.
//!
//! ```text
//! cargo bench --bench speed                 everything: some minutes
//! cargo bench --bench speed -- grid lots    some of it
//! ```
//!
//! Both sides of a comparison run in turn, so that a busy machine slows both. Everything but `threads` runs on one
//! thread; no time includes taking results down.

mod lots;
mod start;
mod versailles;

#[path = "../common/counting.rs"]
mod counting;
#[path = "../common/gardens.rs"]
mod gardens;
#[path = "../common/grid.rs"]
mod grid;

use counting::counted;
use std::hint::black_box;
use std::time::Instant;

/// How often each side runs.
const ROUNDS: usize = 7;

/// What can be measured, in the order of the report.
const SUBJECTS: &[(&str, fn())] = &[
    ("grid", grid),
    ("lots", lots),
    ("versailles", versailles),
    ("parse", parse),
    ("start", start::report),
    ("threads", threads),
];

fn main() {
    // Under `cargo test --benches` nothing is timed.
    if !std::env::args().any(|argument| argument == "--bench") {
        return;
    }
    let asked: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with('-')).collect();
    println!("medians of {ROUNDS} runs in turn");
    let wanted = SUBJECTS.iter().filter(|(name, _)| asked.is_empty() || asked.iter().any(|a| a == name));
    wanted.for_each(|(_, measure)| measure());
}

/// A million cells: split, split, offset, extrude; the bound is the same geometry from a bare work list.
fn grid() {
    let grid = grid::Grid::new(1_000_000);
    let [rules, bound] = alone(|| in_turn([&|| keep(grid.derive()), &|| keep(grid.bound())]));
    let (derivation, live, peak) = alone(|| counted(|| grid.derive()));
    let count = grid::leaves(&derivation) as f64;
    println!("grid        {:>11.0} leaves/s   bare work list {:.2} times as fast", count / rules, rules / bound);
    println!("            {:>11.0} bytes a leaf, at most {:.0}", live as f64 / count, peak as f64 / count);
}

/// Lots with a single extrusion; the bound makes the same prisms without rules.
fn lots() {
    let lots = lots::Lots::new(100_000);
    let [rules, bound] = alone(|| in_turn([&|| keep(lots.derive()), &|| keep(lots.bound())]));
    println!("lots        {:>11.0} lots/s     bare loop {:.2} times as fast", lots.count() / rules, rules / bound);
}

/// Threads against each other, on the same lots.
fn threads() {
    let lots = lots::Lots::new(400_000);
    let two = pool(2);
    let [one, both] = in_turn([&|| alone(|| keep(lots.derive())), &|| two.install(|| keep(lots.derive()))]);
    println!("threads     {:>11.2} times as fast on two threads as on one", one / both);
}

fn versailles() {
    let park = versailles::Park::with_recursions(8);
    let [seconds] = alone(|| in_turn([&|| keep(park.derive())]));
    let count = grid::leaves(&park.derive()) as f64;
    println!("versailles  {:>11.2} s          8 recursions, {count} leaves, {:.0} leaves/s", seconds, count / seconds);
}

fn parse() {
    let source = gardens::source();
    let [seconds] = in_turn([&|| keep(bosquet::syntax::parse(0, &source))]);
    println!("parse       {:>11.2} MB/s       text to tree", gardens::BYTES as f64 / 1e6 / seconds);
}

/// Something that was made, and is taken down when nobody times it.
type Kept = Box<dyn std::any::Any + Send>;

fn keep<T: Send + 'static>(made: T) -> Kept {
    Box::new(black_box(made))
}

/// Median seconds of each side, all sides in turn.
fn in_turn<const N: usize>(sides: [&(dyn Fn() -> Kept + Sync); N]) -> [f64; N] {
    let mut seconds = [const { Vec::new() }; N];
    for _ in 0..ROUNDS {
        for (side, seconds) in sides.iter().zip(&mut seconds) {
            let begun = Instant::now();
            let made = side();
            seconds.push(begun.elapsed().as_secs_f64());
            drop(made);
        }
    }
    seconds.map(median)
}

fn median(mut values: Vec<f64>) -> f64 {
    values.sort_by(f64::total_cmp);
    values[values.len() / 2]
}

/// On one thread.
fn alone<T: Send>(run: impl FnOnce() -> T + Send) -> T {
    pool(1).install(run)
}

fn pool(threads: usize) -> rayon::ThreadPool {
    rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("a pool")
}
