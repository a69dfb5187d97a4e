//! Regions and the features that lie in them.

use crate::geometry::Polygon;
use crate::layout::Georeference;
use crate::value::Value;
use glam::DVec2;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Everything a derivation starts from.
#[derive(Clone, Debug, Default)]
pub struct Layout {
    /// What rules start on, in file order.
    pub regions: Vec<Region>,
    /// What regions see and plans show: buildings, drives, streets, water, trees, markers, in file order.
    pub features: Vec<Feature>,
    /// The way back to the world.
    pub georeference: Georeference,
}

/// What something is.
///
/// The first six are regions, on which rules start; the others are features, which regions see. Streets, footways
/// and water with an area are both.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Kind {
    /// A parcel, with its buildings.
    Lot,
    /// Land enclosed by streets, without buildings.
    Block,
    /// A lot without a street edge.
    Patio,
    /// Land along a street, over several blocks.
    Avenue,
    /// Land over several blocks: park, forest, field; and anything of the user's own kind.
    Region,
    /// A building's footprint.
    Building,
    /// A drive.
    Driveway,
    /// A street: a line with a width, or a polygon.
    Street,
    /// A footway: a line with a width, or a polygon.
    Footway,
    /// Water.
    Water,
    /// A standing tree: kept, drawn, and kept clear of.
    Tree,
    /// Entrance, door, window, garage, pool …: a point or line with its own word.
    Marker(Arc<str>),
    /// The user's own word: a region when it has an area.
    Other(Arc<str>),
}

/// An initial shape.
#[derive(Clone, Debug)]
pub struct Region {
    /// Unique in the layout: the feature's id, or its number.
    pub id: Arc<str>,
    /// The name people use; the id where there is none.
    pub name: Arc<str>,
    /// What it is.
    pub kind: Kind,
    /// Residential, commercial, industrial, street, other, or the user's own word; empty where unknown.
    pub zone: Arc<str>,
    /// Its outline in plan metres. A multipolygon becomes several regions with ids `id/1`, `id/2` …
    pub polygon: Polygon,
    /// Height of the ground, metres.
    pub elevation: f64,
    /// The feature's `start` property: the rule to begin with.
    pub start: Option<Arc<str>>,
    /// The feature's `seed` property.
    pub seed: Option<u64>,
    /// Every property by name.
    pub attributes: BTreeMap<Arc<str>, Value>,
    /// Indices of the features that lie in it or touch it, ascending.
    pub features: Vec<usize>,
    /// Indices of the regions that touch it (nearer than 0.5 m), ascending.
    pub neighbours: Vec<usize>,
}

/// Something a region sees.
#[derive(Clone, Debug)]
pub struct Feature {
    /// Unique in the layout.
    pub id: Arc<str>,
    /// The name people use; the id where there is none.
    pub name: Arc<str>,
    /// What it is.
    pub kind: Kind,
    /// Where.
    pub shapes: Shapes,
    /// Height of its ground, metres.
    pub elevation: f64,
    /// Height above its ground, metres; 0 for flat things.
    pub height: f64,
    /// Every property by name.
    pub attributes: BTreeMap<Arc<str>, Value>,
}

/// The extent of a feature in plan metres.
#[derive(Clone, Debug, PartialEq)]
pub enum Shapes {
    /// Areas, one per part.
    Areas(Vec<Polygon>),
    /// Lines with a width (0 where none is known); streets and footways get an area from it.
    Lines(Vec<Vec<DVec2>>, f64),
    /// Points.
    Points(Vec<DVec2>),
}

impl Kind {
    /// The word of GeoJSON's `kind` property and of `@Zone(kind, …)`.
    pub fn word(&self) -> &str {
        match self {
            Kind::Lot => "lot",
            Kind::Block => "block",
            Kind::Patio => "patio",
            Kind::Avenue => "avenue",
            Kind::Region => "region",
            Kind::Building => "building",
            Kind::Driveway => "driveway",
            Kind::Street => "street",
            Kind::Footway => "footway",
            Kind::Water => "water",
            Kind::Tree => "tree",
            Kind::Marker(word) | Kind::Other(word) => word,
        }
    }
}
