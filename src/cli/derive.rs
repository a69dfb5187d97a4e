//! `bosquet derive`: from a layout and rules to files.

use crate::cli::disk::{Disk, read_file, write_all};
use crate::cli::limits::LimitArguments;
use crate::cli::outputs::{self, Material, Output};
use crate::cli::place::{self, Manifest, Plan};
use crate::cli::{Ended, progress, show};
use bosquet::check::{Kind, Program};
use bosquet::derive::Options;
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::export::plan::{PlanOptions, PlanSize};
use bosquet::export::report::{ReportInput, ReportedDiagnostic, Summary};
use bosquet::layout::Layout;
use bosquet::scene::{self, Scene};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::text::{counted, nearest};
use bosquet::value::Value;
use bosquet::world::World;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::time::Instant;

/// The stack of a worker: expressions and functions are evaluated recursively, within limits.
const STACK: usize = 256 << 20;

/// Arguments of `bosquet derive`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A layout (GeoJSON), or a place: a folder with `bosquet.toml`
    #[arg(value_name = "LAYOUT|PLACE")]
    input: PathBuf,
    /// The rule file
    #[arg(long, value_name = "FILE.cga")]
    rules: Option<String>,
    /// The rule to begin with on every region
    #[arg(long, value_name = "RULE")]
    start: Option<String>,
    /// The seed of everything that is left to chance
    #[arg(long, value_name = "N")]
    seed: Option<u64>,
    /// Set an attribute of the rules
    #[arg(long = "set", value_name = "NAME=VALUE")]
    set: Vec<String>,
    /// A catalogue of further elements
    #[arg(long, value_name = "FILE.toml")]
    catalogue: Vec<String>,
    /// Write a file: plan.svg, plan.png, schedule.csv, report.json, plants:trees.geojson, surfaces:ground.geojson …
    #[arg(short, long = "output", value_name = "[KIND:]FILE")]
    output: Vec<String>,
    /// The scale of plans
    #[arg(long, value_name = "1:500")]
    scale: Option<String>,
    /// The size of plans as pictures: pixels, or metres per pixel
    #[arg(long, value_name = "WxH|METRESm")]
    size: Option<String>,
    /// Turn plans on the sheet, degrees counter-clockwise
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    rotate: Option<f64>,
    /// Show a part of the plan: metres east and north of the layout's centre
    #[arg(long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true)]
    extent: Option<String>,
    /// Write plant codes into plans
    #[arg(long)]
    codes: bool,
    /// Plans without names of regions
    #[arg(long)]
    no_names: bool,
    /// Plans without a legend
    #[arg(long)]
    no_legend: bool,
    /// Worker threads; the result is the same for any number
    #[arg(long, value_name = "N")]
    threads: Option<usize>,
    /// Imports and models may lie outside the place's folder
    #[arg(long)]
    allow_outside: bool,
    #[command(flatten)]
    limits: LimitArguments,
}

/// What a run starts from: arguments over manifest.
struct Job {
    layout: String,
    rules: String,
    root: PathBuf,
    start: Option<String>,
    seed: u64,
    set: Vec<(String, toml::Value)>,
    catalogues: Vec<String>,
    outputs: Vec<Output>,
    plan: PlanOptions,
    title: String,
}

/// Runs it.
pub fn run(arguments: &Arguments) -> Ended {
    let begun = Instant::now();
    let job = match job(arguments) {
        Ok(job) => job,
        Err(message) => return Ended::Usage(message),
    };
    let threads = rayon::ThreadPoolBuilder::new().num_threads(arguments.threads.unwrap_or(0)).stack_size(STACK).build();
    match threads {
        Ok(pool) => pool.install(|| work(arguments, &job, begun)),
        Err(error) => Ended::Usage(format!("the worker threads cannot be started: {error}")),
    }
}

fn work(arguments: &Arguments, job: &Job, begun: Instant) -> Ended {
    let progress = progress::interruptible();
    let world = Disk::new(&job.root, arguments.allow_outside, arguments.limits.limit_file);
    let (program, mut found) = bosquet::check::check(&world, &job.rules);
    let mut inputs: Vec<(String, String)> = Vec::new();
    let layout = match read_file(&job.layout, arguments.limits.limit_file) {
        Ok(bytes) => {
            inputs.push((job.layout.clone(), hash(&bytes)));
            let (layout, notes) = bosquet::layout::read_geojson(&job.layout, &bytes);
            (!layout.regions.is_empty() || !notes.iter().any(Diagnostic::is_error))
                .then(|| {
                    found.extend(notes.clone());
                    layout
                })
                .ok_or(notes)
        }
        Err(error) => Err(vec![Diagnostic::data("file", job.layout.as_str(), error.to_string())]),
    };
    let broken = found
        .iter()
        .any(|d| d.is_error() && matches!(d.place, bosquet::diag::Place::Rule(_) | bosquet::diag::Place::Run));
    let layout = match layout {
        Ok(layout) if !broken => layout,
        Ok(_) => return refused(&found, &program),
        Err(notes) => {
            found.extend(notes);
            return refused(&found, &program);
        }
    };
    let catalogue = catalogue(job, &world, &mut inputs, &mut found);
    let set = match settings(&program, &job.set) {
        Ok(set) => set,
        Err(message) => return Ended::Usage(message),
    };
    if let Some(start) = job.start.as_deref().filter(|start| program.start_named(start).is_none()) {
        let near = nearest(start, program.starts.iter().map(|(name, _)| &**name));
        let advice = near.map(|n| format!(": did you mean `{n}`?")).unwrap_or_default();
        return Ended::Usage(format!("`{}` has no rule `{start}` without arguments{advice}", job.rules));
    }
    inputs.extend(program.sources.iter().filter_map(|s| Some((s.path().into(), hash(&world.source(s.path()).ok()?)))));
    let options = Options {
        start: job.start.as_deref().map(Into::into),
        seed: Seed(job.seed),
        set,
        catalogue: &catalogue,
        world: &world,
        limits: arguments.limits.limits(),
    };
    let total = layout.regions.len();
    let (derivation, stopped) =
        progress::with_bar(total, &progress, || bosquet::derive::derive(&program, &layout, &options, &progress));
    if progress.stopped() {
        eprintln!("stopped: nothing is written");
        return Ended::Stopped;
    }
    found.extend(stopped);
    let scene = scene::resolve(&layout, &derivation, &catalogue, &job.title);
    prints(&derivation);
    show::diagnostics(&found, &program.sources);
    let report = report(job, inputs, &scene, &derivation, &found, &program);
    if let Err(ended) = write(job, &scene, &report, &progress) {
        return ended;
    }
    summary(&layout, &derivation, &scene, begun);
    if found.iter().any(Diagnostic::is_error) { Ended::Wrong } else { Ended::Well }
}

fn refused(found: &[Diagnostic], program: &Program) -> Ended {
    show::diagnostics(found, &program.sources);
    eprintln!("nothing is written");
    Ended::Wrong
}

fn write(job: &Job, scene: &Scene, report: &ReportInput, progress: &bosquet::derive::Progress) -> Result<(), Ended> {
    let material = Material { scene, report, plan: &job.plan };
    let mut files = Vec::new();
    for output in &job.outputs {
        match output.bytes(&material) {
            Ok(bytes) => files.push((output.path.clone(), bytes)),
            Err(message) => return Err(Ended::Usage(message)),
        }
        if progress.stopped() {
            eprintln!("stopped: nothing is written");
            return Err(Ended::Stopped);
        }
    }
    if let Err(message) = write_all(&files) {
        eprintln!("error: {message}");
        return Err(Ended::Wrong);
    }
    files.iter().for_each(|(path, _)| eprintln!("wrote {}", path.display()));
    Ok(())
}

fn summary(layout: &Layout, derivation: &Derivation, scene: &Scene, begun: Instant) {
    let nodes = || derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes);
    let rules: std::collections::BTreeSet<u32> = nodes().filter_map(|node| node.rule).collect();
    eprintln!(
        "{}, {}, {}, {} in {:.1} s",
        counted(layout.regions.len(), "region"),
        counted(rules.len(), "rule"),
        counted(nodes().count(), "shape"),
        counted(scene.plants.len(), "plant"),
        begun.elapsed().as_secs_f64()
    );
}

/// What rules printed, on standard output.
fn prints(derivation: &Derivation) {
    for lot in &derivation.lots {
        for print in &lot.outcome.prints {
            println!("{} {}: {}", lot.id, derivation.symbols[print.symbol as usize], print.value);
        }
    }
}

fn report<'a>(
    job: &Job,
    inputs: Vec<(String, String)>,
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
        inputs,
        summary: Summary::of(scene),
        counts_by_rule,
        counts_by_symbol,
        reports: &scene.reports,
        diagnostics,
    }
}

fn hash(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

fn catalogue(job: &Job, world: &Disk, inputs: &mut Vec<(String, String)>, found: &mut Vec<Diagnostic>) -> Catalogue {
    let mut catalogue = Catalogue::built_in().clone();
    for path in &job.catalogues {
        match world.source(path) {
            Ok(bytes) => {
                inputs.push((path.clone(), hash(&bytes)));
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
                    Kind::Text | Kind::Unknown => "a text",
                };
                format!("`{name}` takes {wanted}, found `{value}`")
            })
        })
        .collect()
}

fn setting(value: &toml::Value, kind: Kind) -> Option<Value> {
    let text = match value {
        toml::Value::String(text) => text.clone(),
        other => other.to_string(),
    };
    let number = text.parse::<f64>().ok().filter(|n| n.is_finite()).map(Value::Float);
    let truth = text.parse::<bool>().ok().map(Value::Bool);
    match kind {
        Kind::Number => number,
        Kind::Truth => truth,
        Kind::Text => Some(Value::text(text)),
        Kind::Unknown => number.or(truth).or_else(|| Some(Value::text(text))),
    }
}

/// Arguments over manifest.
fn job(arguments: &Arguments) -> Result<Job, String> {
    let (manifest, folder) = match place::find(&arguments.input) {
        Some(path) => {
            let folder = path.parent().unwrap_or(Path::new("")).to_path_buf();
            (place::read(&path)?, folder)
        }
        None => (Manifest::default(), PathBuf::new()),
    };
    let here = |path: &str| folder.join(path).to_string_lossy().into_owned();
    let is_place = !manifest.layout.is_empty();
    let layout = if is_place { here(&manifest.layout) } else { arguments.input.to_string_lossy().into_owned() };
    let rules = match (&arguments.rules, is_place) {
        (Some(rules), _) => rules.clone(),
        (None, true) => here(&manifest.rules),
        (None, false) => return Err("a layout needs rules: `--rules FILE.cga`".into()),
    };
    let root = match &arguments.rules {
        Some(rules) => Path::new(rules).parent().unwrap_or(Path::new("")).to_path_buf(),
        None => folder.clone(),
    };
    let attributes = manifest.attributes.clone().into_iter();
    let set = arguments.set.iter().map(|text| assignment(text)).collect::<Result<Vec<_>, _>>()?;
    let stem = stem(&arguments.input);
    let outputs = if !arguments.output.is_empty() {
        arguments.output.clone()
    } else if !manifest.outputs.is_empty() {
        manifest.outputs.clone()
    } else {
        vec![format!("{stem}.svg"), format!("{stem}.png")]
    };
    Ok(Job {
        layout,
        rules,
        root,
        start: arguments.start.clone().or(manifest.start.clone()),
        seed: arguments.seed.or(manifest.seed).unwrap_or(1),
        set: attributes.chain(set).collect(),
        catalogues: manifest.catalogues.iter().map(|c| here(c)).chain(arguments.catalogue.iter().cloned()).collect(),
        outputs: outputs.iter().map(|text| Output::parse(text)).collect::<Result<_, _>>()?,
        plan: plan(arguments, &manifest.plan, manifest.subtitle)?,
        title: manifest.title.unwrap_or(stem),
    })
}

/// The name of outputs: the place's or layout's own.
fn stem(input: &Path) -> String {
    let real = input.canonicalize().unwrap_or_else(|_| input.into());
    let named = if real.is_dir() { real.file_name() } else { real.file_stem() };
    let stem = named.map_or_else(|| "plan".into(), |name| name.to_string_lossy().into_owned());
    match real.parent().and_then(Path::file_name) {
        Some(folder) if real.is_file() && stem == "bosquet" => folder.to_string_lossy().into_owned(),
        _ => stem,
    }
}

fn assignment(text: &str) -> Result<(String, toml::Value), String> {
    match text.split_once('=') {
        Some((name, value)) if !name.trim().is_empty() => {
            Ok((name.trim().into(), toml::Value::String(value.trim().into())))
        }
        _ => Err(format!("`--set {text}` is not of the form NAME=VALUE")),
    }
}

fn plan(arguments: &Arguments, plan: &Plan, subtitle: Option<String>) -> Result<PlanOptions, String> {
    let usual = PlanOptions::default();
    let scale = match (&arguments.scale, &plan.scale) {
        (Some(text), _) => Some(place::scale(text)?),
        (None, Some(toml::Value::String(text))) => Some(place::scale(text)?),
        (None, Some(value)) => Some(place::scale(&value.to_string())?),
        (None, None) => None,
    };
    let rotation = arguments.rotate.or(plan.rotation).unwrap_or(0.0);
    if !rotation.is_finite() {
        return Err("a plan cannot be turned by that".into());
    }
    Ok(PlanOptions {
        scale,
        size: arguments.size.as_deref().map_or(Ok(PlanSize::Auto), outputs::size)?,
        rotation,
        codes: arguments.codes || plan.codes.unwrap_or(usual.codes),
        names: !arguments.no_names && plan.names.unwrap_or(usual.names),
        legend: !arguments.no_legend && plan.legend.unwrap_or(usual.legend),
        title: None,
        subtitle,
        extent: arguments.extent.as_deref().map(extent).transpose()?,
    })
}

fn extent(text: &str) -> Result<bosquet::geometry::Bounds, String> {
    let numbers: Vec<f64> = text.split(',').filter_map(|n| n.trim().parse().ok()).collect();
    match numbers.as_slice() {
        [x0, y0, x1, y1] if x0 < x1 && y0 < y1 => {
            Ok(bosquet::geometry::Bounds { min: glam::DVec2::new(*x0, *y0), max: glam::DVec2::new(*x1, *y1) })
        }
        _ => Err(format!("`{text}` is not an extent: write it as west, south, east, north in metres")),
    }
}
