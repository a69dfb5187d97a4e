//! Program + layout → derivation: the engine that chooses a rule, evaluates, applies and queues.
//!
//! A lot's derivation needs the program, the lot, its features, its neighbours' outlines and a seed, and nothing
//! else; so lots are derived in parallel, and threads change nothing. The engine knows no operation by name.

mod arrays;
mod beginning;
mod context;
mod engine;
mod evaluate;
mod frame;
mod initial;
mod measure;
mod position;
mod select;
mod start;

pub use start::{StartError, start_of};

use crate::check::Program;
use crate::diag::{Diagnostic, Place, Severity};
use crate::element::Catalogue;
use crate::files::Files;
use crate::geometry::BoxGrid;
use crate::layout::Layout;
use crate::raster::Rasters;
use crate::seed::Seed;
use crate::shape::{Derivation, Lot};
use crate::value::Value;
use crate::world::World;
use rayon::prelude::*;
use std::collections::BTreeSet;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

/// What a run is asked for beside program and layout.
pub struct Options<'a> {
    /// The start rule for every region, before all other ways to find one.
    pub start: Option<Arc<str>>,
    /// The seed of the run.
    pub seed: Seed,
    /// Values for attributes by slot, before the layout's.
    pub set: Vec<(usize, Value)>,
    /// The element repository.
    pub catalogue: &'a Catalogue,
    /// Where models come from.
    pub world: &'a dyn World,
    /// Where a run stops by itself.
    pub limits: Limits,
}

/// A run as its lots see it.
#[derive(Clone, Copy)]
struct Run<'a> {
    program: &'a Program,
    layout: &'a Layout,
    options: &'a Options<'a>,
    rasters: &'a Rasters<'a>,
    files: &'a Files<'a>,
    /// Where features reach; none where no rule looks around.
    reaches: Option<&'a BoxGrid>,
    /// Every kind and layer of the layout and every label of the rules; none where labels are made up on the way.
    names: Option<&'a BTreeSet<Arc<str>>>,
    /// The way to every shape is kept.
    records: bool,
    progress: &'a Progress,
}

/// Where a derivation stops by itself, per lot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// Rules inside rules.
    pub depth: usize,
    /// Functions inside functions.
    pub calls: usize,
    /// Shapes of one lot, inner ones included.
    pub shapes: usize,
    /// Children of one operation.
    pub children: usize,
    /// Time for one lot; a lot that takes longer stops with a diagnostic.
    pub time: Duration,
}

impl Default for Limits {
    fn default() -> Limits {
        Limits { depth: 1_000, calls: 200, shapes: 1_500_000, children: 1_000_000, time: Duration::from_secs(600) }
    }
}

/// How far a run is, and whether it shall stop: shared between the run and who watches it.
#[derive(Debug, Default)]
pub struct Progress {
    /// Regions derived.
    pub done: AtomicUsize,
    /// Set to stop the run at the next shape.
    pub stop: AtomicBool,
}

impl Progress {
    /// Whether the run shall stop.
    pub fn stopped(&self) -> bool {
        self.stop.load(Ordering::Relaxed)
    }
}

/// Derives every region of the layout that has a start rule, in parallel; the result is in the layout's order.
///
/// Never fails: what stops a branch or a lot is among the lot's diagnostics. A stopped run gives what was done.
pub fn derive(
    program: &Program,
    layout: &Layout,
    options: &Options,
    progress: &Progress,
) -> (Derivation, Vec<Diagnostic>) {
    run(program, layout, options, progress, None)
}

/// Derives some regions, by index, exactly as [`derive()`] does, and keeps the way to every shape: some 500 bytes each.
pub fn recorded(
    program: &Program,
    layout: &Layout,
    options: &Options,
    progress: &Progress,
    regions: &[usize],
) -> (Derivation, Vec<Diagnostic>) {
    run(program, layout, options, progress, Some(regions))
}

/// A run over all regions, or over some with their record.
fn run(
    program: &Program,
    layout: &Layout,
    options: &Options,
    progress: &Progress,
    recorded: Option<&[usize]>,
) -> (Derivation, Vec<Diagnostic>) {
    let starts: Vec<Result<u32, StartError>> =
        layout.regions.iter().map(|region| start_of(program, region, options.start.as_deref())).collect();
    let mut diagnostics = start::report(program, layout, &starts);
    let rules: Vec<Option<u32>> = starts.iter().map(|start| start.as_ref().ok().copied()).collect();
    let main = program.sources.first().map_or("", |source| source.path());
    let rasters = Rasters::new(options.world, main, layout.georeference.clone());
    let files = Files::new(options.world, program.sources.iter().map(|source| source.path().to_string()));
    let reaches = program.looks_around.then(|| initial::reaches(layout));
    let labels: Option<BTreeSet<Arc<str>>> = program.labels.iter().cloned().collect();
    let names = labels.map(|labels| labels.into_iter().chain(initial::names(layout)).collect());
    let (reaches, names) = (reaches.as_ref(), names.as_ref());
    let records = recorded.is_some();
    let run = Run { program, layout, options, rasters: &rasters, files: &files, reaches, names, records, progress };
    let contexts = context::contexts(&run, &rules);
    let lots: Vec<Lot> = layout
        .regions
        .par_iter()
        .zip(&rules)
        .enumerate()
        .filter(|(index, _)| recorded.is_none_or(|regions| regions.contains(index)))
        .filter_map(|(index, (region, rule))| {
            let context = contexts.get(index).map_or(&[][..], Vec::as_slice);
            let outcome = engine::lot(&run, index, (*rule)?, context);
            progress.done.fetch_add(1, Ordering::Relaxed);
            Some(Lot { region: index, id: region.id.clone(), outcome })
        })
        .collect();
    let without_rule = layout.regions.iter().zip(&starts).filter(|(_, s)| s.is_err()).map(|(r, _)| r.id.clone());
    let derivation = Derivation { symbols: program.symbols.clone().into(), without_rule: without_rule.collect(), lots };
    diagnostics.extend(derivation.lots.iter().flat_map(|lot| lot.outcome.diagnostics.iter().cloned()));
    let tables = files.remarks().into_iter();
    diagnostics.extend(tables.map(|(path, remark)| {
        let message = format!("the table `{path}` has {remark}");
        Diagnostic::new(Severity::Lint, "table", Place::Data(path.into()), message)
    }));
    (derivation, diagnostics)
}
