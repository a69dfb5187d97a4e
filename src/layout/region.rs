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
    /// What the word of a `kind` property stands for; case does not count for the kinds there are.
    pub fn parse(word: &str) -> Kind {
        Kind::known(word).unwrap_or_else(|| Kind::Other(word.into()))
    }

    /// The kind called so, or by one of its common other names; none for the user's own words.
    pub fn known(word: &str) -> Option<Kind> {
        let word = word.to_ascii_lowercase();
        Some(match word.as_str() {
            "lot" | "parcel" | "plot" => Kind::Lot,
            "block" => Kind::Block,
            "patio" => Kind::Patio,
            "avenue" => Kind::Avenue,
            "region" => Kind::Region,
            "building" => Kind::Building,
            "driveway" | "drive" => Kind::Driveway,
            "street" | "road" => Kind::Street,
            "footway" | "path" | "sidewalk" => Kind::Footway,
            "water" => Kind::Water,
            "tree" => Kind::Tree,
            "marker" | "entrance" | "door" | "window" | "garage" | "pool" => Kind::Marker(word.into()),
            _ => return None,
        })
    }

    /// Whether rules may start on its areas.
    pub fn is_region(&self) -> bool {
        !matches!(self, Kind::Building | Kind::Driveway | Kind::Tree | Kind::Marker(_))
    }

    /// Whether regions see its areas.
    pub fn is_feature(&self) -> bool {
        !matches!(self, Kind::Lot | Kind::Block | Kind::Patio | Kind::Avenue | Kind::Region | Kind::Other(_))
    }

    /// Whether it means nothing without an area.
    pub(super) fn needs_area(&self) -> bool {
        matches!(self, Kind::Lot | Kind::Block | Kind::Patio | Kind::Avenue | Kind::Region)
    }

    /// Whether a line with a width is as good as an area.
    pub(super) fn is_drawn_by_lines(&self) -> bool {
        matches!(self, Kind::Avenue | Kind::Street | Kind::Footway | Kind::Water)
    }

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
