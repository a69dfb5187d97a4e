//! A place as the command derives it, and the plants that it wrote, for measuring.

use bosquet::export::plants::read_plants;
use bosquet::geometry::{Area, Polygon, stroke};
use bosquet::layout::{Kind, Layout, Shapes, read_geojson};
use bosquet::scene::Plant;
use glam::DVec2;
use std::path::{Path, PathBuf};
use std::process::Command;
use tempfile::TempDir;

/// What is computed from published files may be off by their last digit, metres.
pub const EXACT: f64 = 1e-3;

/// A run of the command.
pub struct Ran {
    folder: TempDir,
    code: Option<i32>,
    said: String,
}

/// Derives a manifest, folder or layout; the outputs go to a folder of their own.
pub fn derive(input: &Path, arguments: &[&str]) -> Ran {
    let folder = tempfile::tempdir().expect("a folder for the outputs");
    let mut command = Command::new(env!("CARGO_BIN_EXE_bosquet"));
    command.arg("derive").arg(input).current_dir(folder.path());
    for argument in arguments {
        match argument.starts_with('-') {
            true => command.args(argument.split(' ')),
            false => command.args(["-o", argument]),
        };
    }
    let output = command.output().expect("the command runs");
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    Ran { folder, code: output.status.code(), said }
}

impl Ran {
    /// Everything that was said but notes, and but numbers beyond what is usual, which the paper's own figures have.
    pub fn complaints(&self) -> Vec<&str> {
        let is_one = |line: &&str| line.starts_with("error") || line.starts_with("warning");
        let mut lines: Vec<&str> = self.said.lines().filter(is_one).collect();
        lines.retain(|line| !line.starts_with("warning[usual]"));
        if self.code != Some(0) {
            lines.push("it did not end with 0");
        }
        lines
    }

    /// An output.
    pub fn file(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }
}

/// A place and its plants.
pub struct Planting {
    layout: Layout,
    features: Vec<(Kind, Extent)>,
    plants: Vec<Plant>,
}

/// Where a feature is.
enum Extent {
    Areas(Vec<Polygon>),
    Points(Vec<DVec2>),
}

impl Planting {
    /// Of a place under `examples/`.
    pub fn of(place: &str, layout: &str, manifest: &str) -> Planting {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(place);
        let ran = derive(&folder.join(manifest), &["plants:plants.csv"]);
        assert_eq!(ran.complaints(), Vec::<&str>::new(), "{place}");
        let bytes = std::fs::read(folder.join(layout)).expect("the layout");
        let (layout, _) = read_geojson(layout, &bytes);
        let written = std::fs::read(ran.file("plants.csv")).expect("the plants");
        let plants = read_plants(&written, &layout.georeference).expect("plants as they were written");
        assert!(!plants.is_empty(), "{place} has no plants");
        let features = layout.features.iter().map(|f| (f.kind.clone(), Extent::of(&f.shapes))).collect();
        Planting { layout, features, plants }
    }

    /// Of the place of a figure.
    pub fn figure(number: &str) -> Planting {
        let name = format!("figure-{number}");
        Planting::of(&name, &format!("{name}.geojson"), "bosquet.toml")
    }

    /// Every plant.
    pub fn all(&self) -> &[Plant] {
        &self.plants
    }

    /// The plants of a lot.
    pub fn lot(&self, id: &str) -> Vec<Plant> {
        let plants: Vec<Plant> = self.plants.iter().filter(|plant| &*plant.origin.lot == id).cloned().collect();
        assert!(!plants.is_empty(), "the lot {id} has no plants");
        plants
    }

    /// Those that a rule planted.
    pub fn by_rule(&self, rule: &str) -> Vec<Plant> {
        let plants: Vec<Plant> = self.plants.iter().filter(|plant| &*plant.origin.rule == rule).cloned().collect();
        assert!(!plants.is_empty(), "the rule {rule} has no plants");
        plants
    }

    /// The outline of a region.
    pub fn outline(&self, id: &str) -> Polygon {
        let region = self.layout.regions.iter().find(|region| &*region.id == id);
        region.expect("a region of that id").polygon.clone()
    }

    /// The outlines of all regions of a kind.
    pub fn outlines(&self, kind: &str) -> Vec<Polygon> {
        let of_kind = self.layout.regions.iter().filter(|region| region.kind.word() == kind);
        of_kind.map(|region| region.polygon.clone()).collect()
    }

    /// Metres from a point to the nearest feature of a kind, 0 inside of areas.
    pub fn to(&self, kind: &str, p: DVec2) -> f64 {
        let features = self.features.iter().filter(|(of, _)| of.word() == kind);
        features.map(|(_, extent)| extent.distance(p)).fold(f64::INFINITY, f64::min)
    }
}

impl Extent {
    /// Lines are strips of their width.
    fn of(shapes: &Shapes) -> Extent {
        match shapes {
            Shapes::Areas(polygons) => Extent::Areas(polygons.clone()),
            Shapes::Lines(lines, width) => {
                Extent::Areas(lines.iter().flat_map(|line| stroke(line, *width).polygons().to_vec()).collect())
            }
            Shapes::Points(points) => Extent::Points(points.clone()),
        }
    }

    fn distance(&self, p: DVec2) -> f64 {
        match self {
            Extent::Areas(polygons) => polygons.iter().map(|polygon| outside(polygon, p)).fold(f64::INFINITY, f64::min),
            Extent::Points(points) => points.iter().map(|q| q.distance(p)).fold(f64::INFINITY, f64::min),
        }
    }
}

/// Metres to a polygon, 0 inside.
pub fn outside(polygon: &Polygon, p: DVec2) -> f64 {
    if polygon.contains(p) { 0.0 } else { polygon.distance_to_edges(p) }
}

/// Metres from the edge of an area of polygons.
pub fn from_edge(polygon: &Polygon, plant: &Plant) -> f64 {
    Area::from(polygon.clone()).distance_to_edges(plant.position)
}

/// Checks the rule of all random strategies: no two plants are nearer than their radii together (§5.3).
pub fn assert_apart(plants: &[Plant], what: &str) {
    for (index, one) in plants.iter().enumerate() {
        for other in &plants[..index] {
            let (apart, needed) = (one.position.distance(other.position), one.spacing_radius + other.spacing_radius);
            assert!(apart > needed - EXACT, "{what}: {apart} m apart, {needed} m needed");
        }
    }
}

/// The mean of something over plants.
pub fn mean(plants: &[Plant], of: impl Fn(&Plant) -> f64) -> f64 {
    plants.iter().map(of).sum::<f64>() / plants.len() as f64
}

/// How many different words there are.
pub fn kinds(plants: &[Plant], of: impl Fn(&Plant) -> &str) -> usize {
    plants.iter().map(of).collect::<std::collections::BTreeSet<&str>>().len()
}
