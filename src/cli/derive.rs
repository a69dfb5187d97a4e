//! `bosquet derive`: from a layout and rules to files.

use crate::cli::disk::{Disk, write_all};
use crate::cli::job::{Arguments, Job};
use crate::cli::outputs::Material;
use crate::cli::prepare::{Prepared, Unready, on_threads, plain, world};
use crate::cli::{Ended, progress, show, tree, watch};
use bosquet::check::Program;
use bosquet::derive::Progress;
use bosquet::diag::Diagnostic;
use bosquet::export::report::{ReportInput, ReportedDiagnostic, Summary};
use bosquet::layout::Layout;
use bosquet::scene::{self, Scene};
use bosquet::shape::Derivation;
use bosquet::text::counted;
use std::collections::BTreeMap;
use std::path::PathBuf;
use std::time::Instant;

/// What is said where nothing could be derived.
pub const NOTHING: &str = "nothing is written";

/// Runs it.
pub fn run(arguments: &Arguments) -> Ended {
    if arguments.watch {
        return watch::run(arguments);
    }
    let begun = Instant::now();
    let job = match Job::new(arguments) {
        Ok(job) => job,
        Err(message) => return Ended::Usage(message),
    };
    on_threads(&arguments.run, || {
        let progress = progress::interruptible();
        let world = world(&job.basis, &arguments.run);
        if arguments.tree {
            let shown = tree::show(arguments, &job, &world, &progress);
            if job.outputs.is_empty() || !matches!(shown, Ended::Well) {
                return shown;
            }
        }
        match once(arguments, &job, &world, &progress, write_all) {
            Ok(done) => done.told(begun),
            Err(stop) => stop.told(),
        }
    })
}

/// What a run has done.
pub struct Done {
    /// Counts of what came out, for people.
    pub counts: String,
    /// The files that were written.
    pub written: Vec<PathBuf>,
    /// Errors that were found on the way.
    pub errors: usize,
}

/// Why a run wrote nothing.
pub enum Stop {
    /// The input or the arguments are wrong.
    Unready(Unready),
    /// The files cannot be written.
    Unwritten(String),
    /// Ctrl-C.
    Stopped,
}

/// Writes files; gives the indices of those that it did write.
type Write = fn(&[(PathBuf, Vec<u8>)]) -> Result<Vec<usize>, String>;

/// Derives and writes once; what there is to say about rules and layout is said.
pub fn once(
    arguments: &Arguments,
    job: &Job,
    world: &Disk,
    progress: &Progress,
    write_files: Write,
) -> Result<Done, Stop> {
    let basis = &job.basis;
    let mut ready = Prepared::new(basis, world).map_err(Stop::Unready)?;
    let mut found = std::mem::take(&mut ready.found);
    let options = ready.options(basis, world, &arguments.run);
    let (program, layout) = (&ready.program, &ready.layout);
    let (derivation, stopped) = progress::with_bar(layout.regions.len(), progress, || {
        bosquet::derive::derive(program, layout, &options, progress)
    });
    if progress.stopped() {
        return Err(Stop::Stopped);
    }
    found.extend(stopped);
    let (scene, left_out) = scene::resolve(layout, &derivation, &ready.catalogue, &basis.title);
    found.extend(left_out);
    prints(&derivation);
    show::diagnostics(&found, &program.sources);
    let report = report(job, world, &scene, &derivation, &found, program);
    let written = write(job, &scene, &report, progress, write_files)?;
    let errors = found.iter().filter(|diagnostic| diagnostic.is_error()).count();
    Ok(Done { counts: counts(layout, &derivation, &scene), written, errors })
}

impl Done {
    fn told(self, begun: Instant) -> Ended {
        self.written.iter().for_each(|path| show::tell(format_args!("wrote {}", path.display())));
        show::tell(format_args!("{} in {:.1} s", self.counts, begun.elapsed().as_secs_f64()));
        if self.errors > 0 { Ended::Wrong } else { Ended::Well }
    }
}

impl Stop {
    /// Says why.
    pub fn told(self) -> Ended {
        match self {
            Stop::Unready(unready) => unready.told(NOTHING),
            Stop::Unwritten(message) => {
                show::tell(format_args!("error: {message}"));
                Ended::Wrong
            }
            Stop::Stopped => {
                show::tell("stopped: nothing is written");
                Ended::Stopped
            }
        }
    }
}

fn write(
    job: &Job,
    scene: &Scene,
    report: &ReportInput,
    progress: &Progress,
    write_files: Write,
) -> Result<Vec<PathBuf>, Stop> {
    let material = Material { scene, report, plan: &job.plan };
    let mut files = Vec::new();
    for output in &job.outputs {
        let bytes = output.bytes(&material).map_err(|message| Stop::Unready(Unready::Usage(message)))?;
        files.push((output.path.clone(), bytes));
        if progress.stopped() {
            return Err(Stop::Stopped);
        }
    }
    let written = write_files(&files).map_err(Stop::Unwritten)?;
    Ok(written.into_iter().map(|index| files[index].0.clone()).collect())
}

fn counts(layout: &Layout, derivation: &Derivation, scene: &Scene) -> String {
    let nodes = || derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes);
    let rules: std::collections::BTreeSet<u32> = nodes().filter_map(|node| node.rule).collect();
    let counts = [
        counted(layout.regions.len(), "region"),
        counted(rules.len(), "rule"),
        counted(nodes().count(), "shape"),
        counted(scene.plants.len(), "plant"),
    ];
    counts.join(", ")
}

/// What rules printed, on standard output.
pub fn prints(derivation: &Derivation) {
    for lot in &derivation.lots {
        for print in &lot.outcome.prints {
            let symbol = &derivation.symbols[print.symbol as usize];
            show::print(format_args!("{} {symbol}: {}\n", lot.id, print.value));
        }
    }
}

fn report<'a>(
    job: &Job,
    world: &Disk,
    scene: &'a Scene,
    derivation: &Derivation,
    found: &[Diagnostic],
    program: &Program,
) -> ReportInput<'a> {
    let mut counts_by_rule: BTreeMap<String, usize> = BTreeMap::new();
    let mut counts_by_symbol: BTreeMap<String, usize> = BTreeMap::new();
    for node in derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes) {
        let name = &derivation.symbols[node.symbol as usize];
        *counts_by_symbol.entry(name.to_string()).or_default() += 1;
        if node.rule.is_some() {
            *counts_by_rule.entry(name.to_string()).or_default() += 1;
        }
    }
    let diagnostics = found.iter().map(|d| ReportedDiagnostic::of(d, show::place(d, &program.sources))).collect();
    ReportInput {
        version: env!("CARGO_PKG_VERSION"),
        seed: job.basis.seed,
        settings: job.basis.set.iter().map(|(name, value)| (name.clone(), plain(value))).collect(),
        inputs: world.inputs(),
        without_rule: derivation.without_rule.iter().map(|id| id.to_string()).collect(),
        summary: Summary::of(scene),
        counts_by_rule,
        counts_by_symbol,
        reports: &scene.reports,
        diagnostics,
    }
}
