//! What a run starts from: the arguments of `bosquet derive` over the manifest of the place.

use crate::cli::limits::LimitArguments;
use crate::cli::outputs::{self, Output};
use crate::cli::place::{self, Manifest, Plan};
use bosquet::export::plan::{PlanOptions, PlanSize};
use bosquet::geometry::Bounds;
use bosquet::library;
use std::path::{Path, PathBuf};

/// Arguments of every command that derives.
#[derive(clap::Args, Clone)]
pub struct RunArguments {
    /// The rule file
    #[arg(long, value_name = "FILE.cga")]
    pub rules: Option<String>,
    /// The rule to begin with on every region
    #[arg(long, value_name = "RULE")]
    pub start: Option<String>,
    /// The style of the rule file
    #[arg(long, value_name = "NAME")]
    pub style: Option<String>,
    /// The seed of everything that is left to chance
    #[arg(long, value_name = "N")]
    pub seed: Option<u64>,
    /// Set an attribute of the rules
    #[arg(long = "set", value_name = "NAME=VALUE")]
    pub set: Vec<String>,
    /// A catalogue of further elements
    #[arg(long, value_name = "FILE.toml")]
    pub catalogue: Vec<String>,
    /// Worker threads; the result is the same for any number
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(..=256))]
    pub threads: Option<u16>,
    /// Imports and models may lie outside the place's folder
    #[arg(long)]
    pub allow_outside: bool,
    #[command(flatten)]
    pub limits: LimitArguments,
}

/// Arguments of `bosquet derive`.
#[derive(clap::Args)]
pub struct Arguments {
    /// A layout (GeoJSON), or a place: a folder with `bosquet.toml`
    #[arg(value_name = "LAYOUT|PLACE")]
    pub input: PathBuf,
    #[command(flatten)]
    pub run: RunArguments,
    /// Write a file: plan.svg, plan.png, schedule.csv, report.json, plants:trees.geojson, surfaces:ground.geojson …
    #[arg(short, long = "output", value_name = "[KIND:]FILE")]
    pub output: Vec<String>,
    /// Derive again whenever a file that was read changes, until Ctrl-C
    #[arg(long, conflicts_with = "tree")]
    pub watch: bool,
    /// Show the derivation as text, made to be compared; files are written only where `-o` asks for them
    #[arg(long)]
    pub tree: bool,
    /// Show the tree of this lot alone, and the whole of it
    #[arg(long, value_name = "ID", requires = "tree")]
    pub lot: Option<String>,
    /// Show so many rules inside rules of a tree
    #[arg(long, value_name = "N", requires = "tree")]
    pub depth: Option<usize>,
    /// The scale of plans
    #[arg(long, value_name = "1:500")]
    pub scale: Option<String>,
    /// The size of plans as pictures: pixels, or metres per pixel
    #[arg(long, value_name = "WxH|METRESm")]
    pub size: Option<String>,
    /// Turn plans on the sheet, degrees counter-clockwise
    #[arg(long, value_name = "DEGREES", allow_negative_numbers = true)]
    pub rotate: Option<f64>,
    /// Show a part of the plan: metres east and north of the layout's centre
    #[arg(long, value_name = "X0,Y0,X1,Y1", allow_hyphen_values = true)]
    pub extent: Option<String>,
    /// Write plant codes into plans
    #[arg(long)]
    pub codes: bool,
    /// Plans without names of regions
    #[arg(long)]
    pub no_names: bool,
    /// Plans without a legend
    #[arg(long)]
    pub no_legend: bool,
}

/// What a run starts from, whatever becomes of its result.
pub struct Basis {
    /// The manifest, where the input is a place.
    pub manifest: Option<String>,
    /// The layout.
    pub layout: String,
    /// The rule file.
    pub rules: String,
    /// The folders that rules and catalogues may read from.
    pub folders: Vec<PathBuf>,
    /// The start rule for every region.
    pub start: Option<String>,
    /// The style of the rule file.
    pub style: Option<String>,
    /// The seed.
    pub seed: u64,
    /// Values of attributes, later ones over earlier ones.
    pub set: Vec<(String, toml::Value)>,
    /// Further catalogues, later ones over earlier ones.
    pub catalogues: Vec<String>,
    /// The title of plans.
    pub title: String,
}

/// Everything a run is asked for.
pub struct Job {
    /// What it starts from.
    pub basis: Basis,
    /// What is written.
    pub outputs: Vec<Output>,
    /// How plans are drawn.
    pub plan: PlanOptions,
}

impl Basis {
    /// Arguments over manifest; the error is for people.
    pub fn new(input: &Path, arguments: &RunArguments) -> Result<Basis, String> {
        Basis::with_manifest(input, arguments).map(|(basis, _)| basis)
    }

    /// The same, and the manifest for what else it says.
    fn with_manifest(input: &Path, arguments: &RunArguments) -> Result<(Basis, Manifest), String> {
        let place = place::find(input);
        let manifest = place.as_deref().map(place::read).transpose()?;
        let folder = place.as_deref().and_then(Path::parent).unwrap_or(Path::new(""));
        let here = |path: &String| match path.starts_with(library::PREFIX) {
            true => path.clone(),
            false => folder.join(path).to_string_lossy().into_owned(),
        };
        let (layout, rules) = match &manifest {
            Some(Manifest { layout, rules, .. }) => (here(layout), Some(here(rules))),
            None => (input.to_string_lossy().into_owned(), None),
        };
        if manifest.is_none() && !input.exists() {
            return Err(format!("there is no file or folder `{layout}`"));
        }
        let rules = arguments.rules.clone().or(rules).ok_or("a layout needs rules: `--rules FILE.cga`")?;
        let named = arguments.catalogue.iter().chain(&arguments.rules).map(|path| folder_of(path));
        let folders = place.is_some().then(|| folder.to_path_buf()).into_iter().chain(named).collect();
        let mut manifest = manifest.unwrap_or_default();
        let basis = Basis {
            folders,
            start: arguments.start.clone().or(manifest.start.take()),
            style: arguments.style.clone().or(manifest.style.take()),
            seed: arguments.seed.or(manifest.seed).unwrap_or(1),
            set: set(std::mem::take(&mut manifest.attributes), &arguments.set)?,
            catalogues: manifest.catalogues.iter().map(here).chain(arguments.catalogue.iter().cloned()).collect(),
            title: manifest.title.take().unwrap_or_else(|| stem(input)),
            manifest: place.map(|path| path.to_string_lossy().into_owned()),
            layout,
            rules,
        };
        Ok((basis, manifest))
    }
}

impl Job {
    /// Arguments over manifest; the error is for people.
    pub fn new(arguments: &Arguments) -> Result<Job, String> {
        let (basis, manifest) = Basis::with_manifest(&arguments.input, &arguments.run)?;
        let asked = !arguments.tree || !arguments.output.is_empty();
        let outputs = || outputs(&arguments.output, &manifest.outputs, &stem(&arguments.input));
        let job = Job {
            outputs: if asked { outputs()? } else { Vec::new() },
            plan: plan(arguments, &manifest.plan, manifest.subtitle)?,
            basis,
        };
        job.spare_inputs()?;
        Ok(job)
    }

    /// An error where an output would be written over what the run reads.
    fn spare_inputs(&self) -> Result<(), String> {
        let basis = &self.basis;
        let inputs = basis.catalogues.iter().chain([&basis.layout, &basis.rules]).chain(&basis.manifest);
        let real: Vec<PathBuf> = inputs.filter_map(|path| Path::new(path).canonicalize().ok()).collect();
        let is_input = |output: &&Output| output.path.canonicalize().is_ok_and(|path| real.contains(&path));
        match self.outputs.iter().find(is_input) {
            Some(output) => Err(format!("`{}` is read by this run: write to another file", output.path.display())),
            None => Ok(()),
        }
    }
}

fn folder_of(path: &str) -> PathBuf {
    Path::new(path).parent().unwrap_or(Path::new("")).to_path_buf()
}

/// The attributes of the manifest, and those of the command line after them.
fn set(
    manifest: impl IntoIterator<Item = (String, toml::Value)>,
    arguments: &[String],
) -> Result<Vec<(String, toml::Value)>, String> {
    manifest.into_iter().map(Ok).chain(arguments.iter().map(|text| assignment(text))).collect()
}

/// The outputs asked for, else the manifest's, else the plan as SVG and PNG.
fn outputs(arguments: &[String], manifest: &[String], stem: &str) -> Result<Vec<Output>, String> {
    let usual = [format!("plan:{stem}.svg"), format!("plan:{stem}.png")];
    let asked = [arguments, manifest].into_iter().find(|list| !list.is_empty()).unwrap_or(&usual);
    let outputs = asked.iter().map(|text| Output::parse(text)).collect::<Result<Vec<_>, _>>()?;
    let mut taken = Vec::new();
    for output in &outputs {
        let place = target(&output.path)?;
        if taken.contains(&place) {
            return Err(format!("`{}` would be written twice", output.path.display()));
        }
        taken.push(place);
    }
    Ok(outputs)
}

/// Where a file will really lie; an error where it cannot, told before a long run and not after it.
fn target(path: &Path) -> Result<PathBuf, String> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let real = folder.canonicalize().ok().filter(|folder| folder.is_dir());
    match (real, path.file_name()) {
        (Some(folder), Some(name)) if !path.is_dir() => Ok(folder.join(name)),
        (Some(_), _) => Err(format!("`{}` is a folder: a file is wanted", path.display())),
        (None, _) => Err(format!("there is no folder `{}` to write `{}` in", folder.display(), path.display())),
    }
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

fn extent(text: &str) -> Result<Bounds, String> {
    let numbers: Vec<f64> = text.split(',').filter_map(|n| n.trim().parse().ok()).collect();
    match numbers.as_slice() {
        [x0, y0, x1, y1] if x0 < x1 && y0 < y1 && numbers.iter().all(|n| n.is_finite()) => {
            Ok(Bounds { min: glam::DVec2::new(*x0, *y0), max: glam::DVec2::new(*x1, *y1) })
        }
        _ => Err(format!("`{text}` is not an extent: write it as west, south, east, north in metres")),
    }
}
