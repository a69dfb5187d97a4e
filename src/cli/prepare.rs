//! From a basis to what a run needs: files read, rules checked, settings understood; and the run itself.

use crate::cli::disk::Disk;
use crate::cli::job::{Basis, RunArguments};
use crate::cli::{Ended, show};
use bosquet::check::{Kind, Program};
use bosquet::derive::Options;
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::layout::Layout;
use bosquet::seed::Seed;
use bosquet::text::{counted, nearest, suggestion};
use bosquet::value::{Array, Cells, Value};
use bosquet::world::World;
use std::sync::Arc;

/// What a run needs, read and checked.
pub struct Prepared {
    /// The rules.
    pub program: Program,
    /// The layout.
    pub layout: Layout,
    /// The elements.
    pub catalogue: Catalogue,
    /// What there was to say so far.
    pub found: Vec<Diagnostic>,
    set: Vec<(usize, Value)>,
}

/// Why nothing can be derived.
pub enum Unready {
    /// The arguments are wrong.
    Usage(String),
    /// The input is: what is said about it, and the rules it points into.
    Refused(Vec<Diagnostic>, Box<Program>),
}

/// Runs work on threads with as much stack as rules may need.
pub fn on_threads(arguments: &RunArguments, work: impl FnOnce() -> Ended + Send) -> Ended {
    let threads = usize::from(arguments.threads.unwrap_or(0));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).stack_size(arguments.limits.stack());
    match pool.build() {
        Ok(pool) => pool.install(work),
        Err(error) => Ended::Usage(format!("the worker threads cannot be started: {error}")),
    }
}

/// The files that a run may read.
pub fn world(basis: &Basis, arguments: &RunArguments) -> Disk {
    let world = basis.folders.iter().fold(Disk::new(arguments.limits.limit_file), |disk, folder| disk.open(folder));
    if arguments.allow_outside { world.open_all() } else { world }
}

impl Prepared {
    /// Reads and checks everything.
    pub fn new(basis: &Basis, world: &Disk) -> Result<Prepared, Unready> {
        // What the manifest says is known; now its hash is.
        basis.manifest.iter().for_each(|path| drop(world.named(path)));
        let (program, mut found) = bosquet::check::check_style(world, &basis.rules, basis.style.as_deref());
        let is_broken = found.iter().any(Diagnostic::is_error);
        let layout = layout(basis, world, &mut found).filter(|_| !is_broken);
        let Some(layout) = layout else { return Err(Unready::Refused(found, Box::new(program))) };
        let catalogue = catalogue(basis, world, &mut found);
        let set = settings(&program, &basis.set).and_then(|set| start(basis, &program).map(|()| set));
        let set = set.map_err(Unready::Usage)?;
        Ok(Prepared { program, layout, catalogue, found, set })
    }

    /// What the engine is asked for.
    pub fn options<'a>(&'a self, basis: &Basis, world: &'a Disk, arguments: &RunArguments) -> Options<'a> {
        Options {
            start: basis.start.as_deref().map(Into::into),
            seed: Seed(basis.seed),
            set: self.set.clone(),
            catalogue: &self.catalogue,
            world,
            limits: arguments.limits.limits(),
        }
    }
}

impl Unready {
    /// Says what is wrong with the input, and gives the line that sums it up.
    pub fn briefly(self, seconds: f64) -> String {
        match self {
            Unready::Usage(message) => format!("error: {message}"),
            Unready::Refused(found, program) => {
                show::diagnostics(&found, &program.sources);
                let errors = found.iter().filter(|diagnostic| diagnostic.is_error()).count();
                format!("{} in {seconds:.1} s; nothing is written", counted(errors, "error"))
            }
        }
    }

    /// Says why; `then` is the last word.
    pub fn told(self, then: &str) -> Ended {
        match self {
            Unready::Usage(message) => Ended::Usage(message),
            Unready::Refused(found, program) => {
                show::diagnostics(&found, &program.sources);
                show::tell(then);
                Ended::Wrong
            }
        }
    }
}

/// The layout, and what there is to say about it; `None` where nothing of it can be used.
fn layout(basis: &Basis, world: &Disk, found: &mut Vec<Diagnostic>) -> Option<Layout> {
    let (layout, notes) = match world.named(&basis.layout) {
        Ok(bytes) => bosquet::layout::read_geojson(&basis.layout, &bytes),
        Err(error) => (Layout::default(), vec![Diagnostic::data("file", basis.layout.as_str(), error.to_string())]),
    };
    let is_usable = !layout.regions.is_empty() || !notes.iter().any(Diagnostic::is_error);
    found.extend(notes);
    is_usable.then_some(layout)
}

/// An error where the start rule that was asked for is not there.
fn start(basis: &Basis, program: &Program) -> Result<(), String> {
    let Some(start) = basis.start.as_deref().filter(|start| program.start_named(start).is_none()) else {
        return Ok(());
    };
    let near = nearest(start, program.starts.iter().map(|(name, _)| &**name));
    Err(format!("`{}` has no rule `{start}` without arguments{}", basis.rules, suggestion(near)))
}

fn catalogue(basis: &Basis, world: &Disk, found: &mut Vec<Diagnostic>) -> Catalogue {
    let mut catalogue = Catalogue::built_in().clone();
    for path in &basis.catalogues {
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
                return Err(format!("the rules have no attribute `{name}`{}", suggestion(near)));
            };
            let kind = program.attributes[slot].kind;
            setting(value, kind).map(|value| (slot, value)).ok_or_else(|| {
                // What a truth value is need not be known on a command line.
                let wanted = if kind == Kind::Truth { "`true` or `false`" } else { kind.words() };
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

/// A setting as it would be written on the command line.
pub fn plain(value: &toml::Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_string)
}
