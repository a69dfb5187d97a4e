//! The resolved scene: everything an exporter draws or writes, with nothing left to look up.
//!
//! Plan coordinates are metres around the layout's centre: x east, y north; heights are metres above the datum.
//! No rules, scopes or attributes are left: a plant carries the *name* of its rule. What stands in a scene:
//! covers (flat ground surfaces), solids (things with height), lines, plants, objects.

mod resolve;
mod strip;

pub use crate::element::{Material, PlantSymbol, Texture};
pub use crate::shape::{Chart, Course, Surface};
pub use resolve::resolve;
pub use strip::{Strip, strip_length};

use crate::geometry::{Area, Mesh};
use crate::layout::Georeference;
use crate::value::Value;
use glam::DVec2;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A derived layout, resolved.
#[derive(Clone, Debug, Default)]
pub struct Scene {
    /// The place's title.
    pub title: Arc<str>,
    /// The way back to the world.
    pub georeference: Georeference,
    /// The outlines of the regions, for plans and statistics.
    pub lots: Vec<LotOutline>,
    /// Flat surfaces, in drawing order: later ones lie on top.
    pub covers: Vec<Cover>,
    /// Things with height: buildings, hedges, walls.
    pub solids: Vec<Solid>,
    /// Lines without width.
    pub lines: Vec<Line>,
    /// Plants, those of the layout first.
    pub plants: Vec<Plant>,
    /// Furniture and architectural objects.
    pub objects: Vec<Object>,
    /// `report()` values per key: the sum and count of numbers, and the texts.
    pub reports: Vec<Report>,
}

/// A region's outline.
#[derive(Clone, Debug)]
pub struct LotOutline {
    /// The region's id.
    pub id: Arc<str>,
    /// Its name.
    pub name: Arc<str>,
    /// Its kind's word.
    pub kind: Arc<str>,
    /// Its zone; empty where unknown.
    pub zone: Arc<str>,
    /// Its outline.
    pub area: Area,
}

/// Where something comes from.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Origin {
    /// The lot's id; empty for features of the layout.
    pub lot: Arc<str>,
    /// The rule (or symbol) that made it; empty for features of the layout.
    pub rule: Arc<str>,
    /// The stable id: the seed's path in hexadecimal, or the layout's own id.
    pub id: Arc<str>,
}

/// A flat surface.
#[derive(Clone, Debug)]
pub struct Cover {
    /// Where it comes from.
    pub origin: Origin,
    /// What it is made of.
    pub material: Arc<Material>,
    /// Its extent in the plan.
    pub area: Area,
    /// Its height above the datum.
    pub elevation: f64,
    /// Textures, and the texture coordinates of the world's points (`Chart::uv`); none where rules set none.
    pub surface: Option<Arc<Surface>>,
}

/// Something with height.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Where it comes from.
    pub origin: Origin,
    /// What it is made of.
    pub material: Arc<Material>,
    /// Its shadow on the plan seen from above: the outline.
    pub footprint: Area,
    /// Height of its foot above the datum.
    pub base: f64,
    /// Height of its top above its foot.
    pub height: f64,
    /// Its faces where it is more than a prism over its footprint.
    pub mesh: Option<Arc<Mesh>>,
    /// Textures, and the texture coordinates of the world's points; none where rules set none.
    pub surface: Option<Arc<Surface>>,
}

/// A line without width.
#[derive(Clone, Debug)]
pub struct Line {
    /// Where it comes from.
    pub origin: Origin,
    /// How it is drawn.
    pub material: Arc<Material>,
    /// Its vertices in the plan.
    pub points: Vec<DVec2>,
    /// Its height above the datum.
    pub elevation: f64,
}

/// A plant: the record that every export carries and can be read back from.
#[derive(Clone, Debug, PartialEq)]
pub struct Plant {
    /// Where it comes from.
    pub origin: Origin,
    /// Where its trunk stands.
    pub position: DVec2,
    /// Height of its foot above the datum.
    pub elevation: f64,
    /// How it is turned: degrees counter-clockwise from east, for clipped forms.
    pub heading: f64,
    /// `tree`, `shrub`, `hedge`, `flower` …: the catalogue's word for its habit.
    pub kind: Arc<str>,
    /// The catalogue's category: `birch`.
    pub category: Arc<str>,
    /// The type within the category: `young`, `medium`, `adult`.
    pub age_class: Arc<str>,
    /// Which appearance of the type.
    pub appearance: u32,
    /// The species' Latin name; empty where unknown.
    pub species: Arc<str>,
    /// The species' common name.
    pub common_name: Arc<str>,
    /// The short code on plans: `BET`.
    pub code: Arc<str>,
    /// Radius kept clear of other plants, metres.
    pub spacing_radius: f64,
    /// Radius of the crown, metres.
    pub crown_radius: f64,
    /// Years.
    pub age: f64,
    /// Metres.
    pub height: f64,
    /// Diameter of the trunk at breast height, metres.
    pub trunk_diameter: f64,
    /// From the lowest leaves to the top, metres; 0 where unknown.
    pub crown_height: f64,
    /// One side of all leaves, m²; 0 where unknown.
    pub leaf_area: f64,
    /// What pruning left of the crown's volume, 0 to 1: 1 is unpruned.
    pub pruning: f64,
    /// Its sizes follow curves fitted to measured trees, at its age.
    pub measured: bool,
    /// The seed of its shape: growth starts from it.
    pub seed: u64,
    /// Planted and cared for, not wild.
    pub managed: bool,
    /// It stood there before: read from the layout.
    pub existing: bool,
    /// How a plan draws it.
    pub symbol: PlantSymbol,
    /// Crown colour, sRGB and opacity in 0 to 1.
    pub color: [f32; 4],
}

/// A piece of furniture or an architectural object.
#[derive(Clone, Debug)]
pub struct Object {
    /// Where it comes from.
    pub origin: Origin,
    /// The catalogue's unique id.
    pub entry: Arc<str>,
    /// The catalogue's category: `bench`, `fountain`, `statue` …
    pub category: Arc<str>,
    /// The type within the category.
    pub variant: Arc<str>,
    /// The name people read.
    pub label: Arc<str>,
    /// Its outline on the plan.
    pub footprint: Area,
    /// Its middle on the plan.
    pub position: DVec2,
    /// The angle of its x axis on the plan, degrees counter-clockwise from east.
    pub heading: f64,
    /// Height of its foot above the datum.
    pub base: f64,
    /// Size along its own x, y (up) and z, metres.
    pub size: [f64; 3],
    /// Fill colour.
    pub color: [f32; 4],
    /// The file of the user's own model; empty for built-in ones.
    pub model: Arc<str>,
}

/// All values reported under one key.
#[derive(Clone, Debug, PartialEq)]
pub struct Report {
    /// The key.
    pub key: Arc<str>,
    /// How many values.
    pub count: usize,
    /// Sum of the numbers among them.
    pub sum: f64,
    /// Least of the numbers; 0 where there is none.
    pub least: f64,
    /// Greatest of the numbers; 0 where there is none.
    pub greatest: f64,
    /// Other values with how often each came.
    pub texts: BTreeMap<String, usize>,
}

impl Report {
    /// An empty report under `key`.
    pub fn new(key: Arc<str>) -> Report {
        Report { key, count: 0, sum: 0.0, least: 0.0, greatest: 0.0, texts: BTreeMap::new() }
    }

    /// Takes one more value in.
    pub fn add(&mut self, value: &Value) {
        match value.as_float() {
            Some(number) => {
                let numbers = self.count - self.texts.values().sum::<usize>();
                self.least = if numbers == 0 { number } else { self.least.min(number) };
                self.greatest = if numbers == 0 { number } else { self.greatest.max(number) };
                self.sum += number;
            }
            None => *self.texts.entry(value.to_string()).or_default() += 1,
        }
        self.count += 1;
    }
}
