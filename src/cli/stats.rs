//! `bosquet stats`: how plants stand, in numbers, and how far two plantings are from each other.

use crate::cli::disk::{Disk, write_all};
use crate::cli::points::{Source, share_plan};
use crate::cli::statistics::{Set, csv, json, table};
use crate::cli::{Ended, show};
use bosquet::diag::Diagnostic;
use bosquet::geometry::{Area, Polygon, convex_hull};
use bosquet::layout::Kind;
use bosquet::placement::PlacementError;
use bosquet::seed::Seed;
use bosquet::stats::{Pattern, Segments, Window, compare, default_reach};
use bosquet::text::counted;
use glam::DVec2;
use std::path::PathBuf;

/// Arguments of `bosquet stats`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Points: plants that bosquet wrote as GeoJSON or CSV, or any GeoJSON with points
    #[arg(value_name = "POINTS")]
    first: String,
    /// Points to compare them with
    #[arg(value_name = "OTHERS")]
    second: Option<String>,
    /// GeoJSON polygons in which the points were observed; otherwise the lots beside the points, or their convex hull
    #[arg(long, value_name = "FILE")]
    window: Option<String>,
    /// Only points of this kind: `tree`, `shrub` …
    #[arg(long, value_name = "WORD")]
    kind: Option<String>,
    /// GeoJSON polygons to measure distances to
    #[arg(long, value_name = "FILE")]
    buildings: Option<String>,
    /// GeoJSON lines to measure distances to
    #[arg(long, value_name = "FILE")]
    streets: Option<String>,
    /// As many random points in the same window beside them
    #[arg(long)]
    random: bool,
    /// Seed of the random points
    #[arg(long, value_name = "NUMBER", default_value_t = 1)]
    seed: u64,
    /// How far the curves reach, metres; otherwise a quarter of the window's shorter side at most
    #[arg(long, value_name = "METRES", value_parser = metres)]
    rmax: Option<f64>,
    /// Distances at which the curves are taken
    #[arg(long, value_name = "COUNT", default_value_t = 64, value_parser = clap::value_parser!(u16).range(1..=4096))]
    radii: u16,
    /// Write the curves as a table
    #[arg(long, value_name = "FILE")]
    csv: Option<PathBuf>,
    /// Write everything as JSON
    #[arg(long, value_name = "FILE")]
    json: Option<PathBuf>,
    /// Bytes of one file that is read
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 30)]
    limit_file: u64,
}

/// The files of a run, in one plan.
struct Files {
    sets: Vec<Source>,
    window: Option<Source>,
    buildings: Option<Source>,
    streets: Option<Source>,
}

/// Runs it.
pub fn run(arguments: &Arguments) -> Ended {
    match work(arguments) {
        Ok(flaws) if flaws.is_empty() => Ended::Well,
        Ok(flaws) | Err(flaws) => {
            show::diagnostics(&flaws, &[]);
            Ended::Wrong
        }
    }
}

/// Measures and writes; what could not be used of the files comes back.
fn work(arguments: &Arguments) -> Result<Vec<Diagnostic>, Vec<Diagnostic>> {
    let mut files = Files::read(arguments)?;
    let mut sets = Vec::new();
    for source in &files.sets {
        sets.push((source.path.clone(), files.pattern(source, arguments.kind.as_deref())?));
    }
    if arguments.random {
        let baseline = sets[0].1.random(Seed(arguments.seed));
        let refused = |error: PlacementError| vec![Diagnostic::data("points", &*sets[0].0, error.to_string())];
        sets.push(("random".into(), baseline.map_err(refused)?));
    }
    let measured = files.measure(&sets, arguments);
    let others = sets.iter().skip(1).map(|(name, other)| (name.as_str(), compare(&sets[0].1, other)));
    let compared: Vec<_> = others.collect();
    let outputs = [(&arguments.csv, csv(&measured)), (&arguments.json, json(&measured, &compared))];
    let named = outputs.into_iter().filter_map(|(path, text)| Some((path.clone()?, text.into_bytes())));
    let written: Vec<(PathBuf, Vec<u8>)> = named.collect();
    write_all(&written).map_err(|message| vec![Diagnostic::data("file", "stats", message)])?;
    show::print(table(&measured, &compared));
    written.iter().for_each(|(path, _)| show::tell(format_args!("wrote {}", path.display())));
    Ok(files.flaws())
}

impl Files {
    fn read(arguments: &Arguments) -> Result<Files, Vec<Diagnostic>> {
        let disk = Disk::new(arguments.limit_file);
        let read = |path: &String| Source::read(path, &disk);
        let sets = std::iter::once(&arguments.first).chain(&arguments.second);
        let mut files = Files {
            sets: sets.map(read).collect::<Result<_, _>>()?,
            window: arguments.window.as_ref().map(read).transpose()?,
            buildings: arguments.buildings.as_ref().map(read).transpose()?,
            streets: arguments.streets.as_ref().map(read).transpose()?,
        };
        let further = [&mut files.window, &mut files.buildings, &mut files.streets].into_iter().flatten();
        share_plan(&mut files.sets.iter_mut().chain(further).collect::<Vec<_>>())?;
        Ok(files)
    }

    /// Everything that is measured of each pattern by itself.
    fn measure(&self, patterns: &[(String, Pattern)], arguments: &Arguments) -> Vec<Set> {
        let (buildings, streets) = (self.buildings(), self.streets());
        let to_building = |w: &Window, p: DVec2| if w.contains(p) { 0.0 } else { w.distance_to_rim(p) };
        let measure = |(name, pattern): &(String, Pattern)| {
            let reach = arguments.rmax.unwrap_or_else(|| default_reach(pattern));
            let mut set = Set::measure(name, pattern, reach, arguments.radii.into());
            let points = || pattern.points().iter();
            set.add("to buildings", buildings.as_ref().map(|w| points().map(|p| to_building(w, *p))));
            set.add("to streets", streets.as_ref().map(|s| points().map(|p| s.distance(*p))));
            set
        };
        patterns.iter().map(measure).collect()
    }

    /// The points of a file in their window; what is assumed or left out is told.
    fn pattern(&self, source: &Source, kind: Option<&str>) -> Result<Pattern, Vec<Diagnostic>> {
        let refused = |message: String| vec![Diagnostic::data("points", &*source.path, message)];
        let points = source.points_of(kind);
        if let Some(kind) = kind.filter(|_| points.is_empty()) {
            let mut words: Vec<String> = source.points.iter().map(|(_, word)| format!("`{word}`")).collect();
            words.sort();
            words.dedup();
            let there = if words.is_empty() { "no points".into() } else { words.join(", ") };
            return Err(refused(format!("there is no point of kind `{kind}`: there are {there}")));
        }
        if points.is_empty() {
            return Err(refused("there are no points in it".into()));
        }
        let pattern = Pattern::new(&points, self.window(source, &points)?).map_err(|e| refused(e.to_string()))?;
        if pattern.outside() > 0 {
            let count = counted(pattern.outside(), "point");
            show::tell(format_args!("{}: {count} outside of the window left out", source.path));
        }
        Ok(pattern)
    }

    fn window(&self, source: &Source, points: &[DVec2]) -> Result<Window, Vec<Diagnostic>> {
        if let Some(file) = &self.window {
            let refused = || vec![Diagnostic::data("points", &*file.path, "the window has no polygon, and so no area")];
            return Window::new(&file.all_areas()).ok_or_else(refused);
        }
        if let Some(lots) = Window::new(&source.areas_of(&Kind::Lot)) {
            return Ok(lots);
        }
        show::tell(format_args!("{}: no window is given: the convex hull of the points is taken", source.path));
        let hull = Polygon::new(&convex_hull(points), &[]).map(Area::from);
        Window::new(&hull).ok_or_else(|| {
            let message = format!("the convex hull of {} has no area", counted(points.len(), "point"));
            let hint = "give the polygons in which they were observed: `--window lots.geojson`";
            vec![Diagnostic::data("points", &*source.path, message).hint(hint)]
        })
    }

    /// The union of the buildings: of the features of that kind, or of all polygons.
    fn buildings(&self) -> Option<Window> {
        let file = self.buildings.as_ref()?;
        let known = file.areas_of(&Kind::Building);
        Window::new(&if known.is_empty() { file.all_areas() } else { known })
    }

    /// The axes of the streets, or the edges of their polygons where there are no lines.
    fn streets(&self) -> Option<Segments> {
        let file = self.streets.as_ref()?;
        let axes: Vec<_> = file.lines.iter().flat_map(|line| line.windows(2)).map(|pair| (pair[0], pair[1])).collect();
        let edges = || file.areas.iter().flat_map(|(_, polygon)| polygon.edges()).collect();
        Some(Segments::new(if axes.is_empty() { edges() } else { axes }))
    }

    fn flaws(&mut self) -> Vec<Diagnostic> {
        let further = [&mut self.window, &mut self.buildings, &mut self.streets].into_iter().flatten();
        self.sets.iter_mut().chain(further).flat_map(|file| std::mem::take(&mut file.flaws)).collect()
    }
}

fn metres(text: &str) -> Result<f64, String> {
    let metres = text.parse::<f64>().ok().filter(|m| m.is_finite() && *m > 0.0);
    metres.ok_or_else(|| format!("`{text}` is not a length: write metres above 0"))
}
