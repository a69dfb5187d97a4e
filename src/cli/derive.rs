//! `bosquet derive`: from a layout and rules to files.

use crate::cli::disk::{Disk, write_all};
use crate::cli::job::{Arguments, Job};
use crate::cli::outputs::Material;
use crate::cli::{Ended, progress, show};
use bosquet::check::{Kind, Program};
use bosquet::derive::Options;
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::export::report::{ReportInput, ReportedDiagnostic, Summary};
use bosquet::layout::Layout;
use bosquet::scene::{self, Scene};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::text::{counted, nearest};
use bosquet::value::{Array, Cells, Value};
use bosquet::world::World;
use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

/// Runs it.
pub fn run(arguments: &Arguments) -> Ended {
    let begun = Instant::now();
    let job = match Job::new(arguments) {
        Ok(job) => job,
        Err(message) => return Ended::Usage(message),
    };
    let threads = usize::from(arguments.threads.unwrap_or(0));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(arguments.limits.stack());
    match pool.build() {
        Ok(pool) => pool.install(|| work(arguments, &job, begun)),
        Err(error) => Ended::Usage(format!("the worker threads cannot be started: {error}")),
    }
}

fn work(arguments: &Arguments, job: &Job, begun: Instant) -> Ended {
    let progress = progress::interruptible();
    let world = job.folders.iter().fold(Disk::new(arguments.limits.limit_file), |disk, folder| disk.open(folder));
    let world = if arguments.allow_outside { world.open_all() } else { world };
    // What the manifest says is known; now its hash is.
    job.manifest.iter().for_each(|path| drop(world.named(path)));
    let (program, mut found) = bosquet::check::check_style(&world, &job.rules, job.style.as_deref());
    let is_broken = found.iter().any(Diagnostic::is_error);
    let layout = layout(job, &world, &mut found).filter(|_| !is_broken);
    let Some(layout) = layout else { return refused(&found, &program) };
    let catalogue = catalogue(job, &world, &mut found);
    let options = Options {
        start: job.start.as_deref().map(Into::into),
        seed: Seed(job.seed),
        set: match settings(&program, &job.set).and_then(|set| start(job, &program).map(|()| set)) {
            Ok(set) => set,
            Err(message) => return Ended::Usage(message),
        },
        catalogue: &catalogue,
        world: &world,
        limits: arguments.limits.limits(),
    };
    let total = layout.regions.len();
    let (derivation, stopped) =
        progress::with_bar(total, &progress, || bosquet::derive::derive(&program, &layout, &options, &progress));
    if progress.stopped() {
        return interrupted();
    }
    found.extend(stopped);
    let (scene, left_out) = scene::resolve(&layout, &derivation, &catalogue, &job.title);
    found.extend(left_out);
    prints(&derivation);
    show::diagnostics(&found, &program.sources);
    let report = report(job, &world, &scene, &derivation, &found, &program);
    if let Err(ended) = write(job, &scene, &report, &progress) {
        return ended;
    }
    summary(&layout, &derivation, &scene, begun);
    if found.iter().any(Diagnostic::is_error) { Ended::Wrong } else { Ended::Well }
}

/// The layout, and what there is to say about it; `None` where nothing of it can be used.
fn layout(job: &Job, world: &Disk, found: &mut Vec<Diagnostic>) -> Option<Layout> {
    let (layout, notes) = match world.named(&job.layout) {
        Ok(bytes) => bosquet::layout::read_geojson(&job.layout, &bytes),
        Err(error) => (Layout::default(), vec![Diagnostic::data("file", job.layout.as_str(), error.to_string())]),
    };
    let is_usable = !layout.regions.is_empty() || !notes.iter().any(Diagnostic::is_error);
    found.extend(notes);
    is_usable.then_some(layout)
}

/// An error where the start rule that was asked for is not there.
fn start(job: &Job, program: &Program) -> Result<(), String> {
    let Some(start) = job.start.as_deref().filter(|start| program.start_named(start).is_none()) else { return Ok(()) };
    let near = nearest(start, program.starts.iter().map(|(name, _)| &**name));
    let advice = near.map(|n| format!(": did you mean `{n}`?")).unwrap_or_default();
    Err(format!("`{}` has no rule `{start}` without arguments{advice}", job.rules))
}

fn refused(found: &[Diagnostic], program: &Program) -> Ended {
    show::diagnostics(found, &program.sources);
    show::tell("nothing is written");
    Ended::Wrong
}

fn interrupted() -> Ended {
    show::tell("stopped: nothing is written");
    Ended::Stopped
}

fn write(job: &Job, scene: &Scene, report: &ReportInput, progress: &bosquet::derive::Progress) -> Result<(), Ended> {
    let material = Material { scene, report, plan: &job.plan };
    let mut files = Vec::new();
    for output in &job.outputs {
        files.push((output.path.clone(), output.bytes(&material).map_err(Ended::Usage)?));
        if progress.stopped() {
            return Err(interrupted());
        }
    }
    if let Err(message) = write_all(&files) {
        show::tell(format_args!("error: {message}"));
        return Err(Ended::Wrong);
    }
    files.iter().for_each(|(path, _)| show::tell(format_args!("wrote {}", path.display())));
    Ok(())
}

fn summary(layout: &Layout, derivation: &Derivation, scene: &Scene, begun: Instant) {
    let nodes = || derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes);
    let rules: std::collections::BTreeSet<u32> = nodes().filter_map(|node| node.rule).collect();
    show::tell(format_args!(
        "{}, {}, {}, {} in {:.1} s",
        counted(layout.regions.len(), "region"),
        counted(rules.len(), "rule"),
        counted(nodes().count(), "shape"),
        counted(scene.plants.len(), "plant"),
        begun.elapsed().as_secs_f64()
    ));
}

/// What rules printed, on standard output.
fn prints(derivation: &Derivation) {
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
        seed: job.seed,
        settings: job.set.iter().map(|(name, value)| (name.clone(), plain(value))).collect(),
        inputs: world.inputs(),
        without_rule: derivation.without_rule.iter().map(|id| id.to_string()).collect(),
        summary: Summary::of(scene),
        counts_by_rule,
        counts_by_symbol,
        reports: &scene.reports,
        diagnostics,
    }
}

/// A setting as it would be written on the command line.
fn plain(value: &toml::Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_string)
}

fn catalogue(job: &Job, world: &Disk, found: &mut Vec<Diagnostic>) -> Catalogue {
    let mut catalogue = Catalogue::built_in().clone();
    for path in &job.catalogues {
        match world.source(path) {
            Ok(bytes) => {
                let (extended, notes) = catalogue.extended(path, &bytes, world);
                catalogue = extended;
                found.extend(notes);
            }
            Err(error) => found.push(Diagnostic::data("file", path.as_str(), error.to_string())),
        }
    }
    catalogue
}

/// The slots and values of `--set` and of the manifest's attributes.
fn settings(program: &Program, set: &[(String, toml::Value)]) -> Result<Vec<(usize, Value)>, String> {
    set.iter()
        .map(|(name, value)| {
            let Some(slot) = program.slot(name) else {
                let near = nearest(name, program.public_attributes().map(|(_, a)| &*a.name));
                let advice = near.map(|n| format!(": did you mean `{n}`?")).unwrap_or_default();
                return Err(format!("the rules have no attribute `{name}`{advice}"));
            };
            let kind = program.attributes[slot].kind;
            setting(value, kind).map(|value| (slot, value)).ok_or_else(|| {
                let wanted = match kind {
                    Kind::Number => "a number",
                    Kind::Truth => "`true` or `false`",
                    Kind::Numbers => "a list of numbers",
                    Kind::Truths => "a list of truth values",
                    Kind::Texts => "a list of texts",
                    Kind::Text | Kind::Unknown => "a text",
                };
                format!("`{name}` takes {wanted}, found `{value}`")
            })
        })
        .collect()
}

fn setting(value: &toml::Value, kind: Kind) -> Option<Value> {
    let text = plain(value);
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite()).map(Value::Float);
    let truth = text.parse::<bool>().ok().map(Value::Bool);
    match kind {
        Kind::Number => number,
        Kind::Truth => truth,
        Kind::Text => Some(Value::text(text)),
        Kind::Numbers | Kind::Truths | Kind::Texts => array(value, kind),
        Kind::Unknown if value.is_array() => {
            [Kind::Numbers, Kind::Truths, Kind::Texts].into_iter().find_map(|kind| array(value, kind))
        }
        Kind::Unknown => number.or(truth).or_else(|| Some(Value::text(text))),
    }
}

/// A list, all of the same type; on the command line written as in a manifest: `[1, 2]`, `["oak", "lime"]`.
fn array(value: &toml::Value, kind: Kind) -> Option<Value> {
    let written = value.as_str().and_then(|text| toml::from_str::<toml::Table>(&format!("list = {text}")).ok());
    let list = written.as_ref().and_then(|table| table.get("list")).unwrap_or(value).as_array()?;
    let cells = match kind {
        Kind::Numbers => Cells::Numbers(list.iter().map(|v| plain(v).parse().ok()).collect::<Option<_>>()?),
        Kind::Truths => Cells::Truths(list.iter().map(toml::Value::as_bool).collect::<Option<_>>()?),
        _ => Cells::Texts(list.iter().map(|v| plain(v).into()).collect()),
    };
    Some(Value::Array(Arc::new(Array::row(cells))))
}
