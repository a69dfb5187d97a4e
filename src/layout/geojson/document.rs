//! The text as items: properties and positions, nothing yet understood or placed.
//!
//! Only a text that is no GeoJSON at all is refused as a whole; an item that cannot be read carries its flaw.

use crate::diag::Diagnostic;
use crate::layout::geojson::{MOST_FEATURES, MOST_POSITIONS};
use crate::layout::{Crs, CrsError};
use crate::text::{nearest, thousands};
use geojson::{Geometry, GeometryValue, Position};
use serde_json::{Map, Value as Json};
use std::sync::Arc;

/// What a text holds.
pub struct Document {
    /// The system of its coordinates.
    pub crs: Result<Crs, CrsError>,
    /// Its features in file order.
    pub items: Vec<Item>,
}

/// One feature.
pub struct Item {
    /// Its own `id`, or its number in the file, from 1.
    pub id: Arc<str>,
    /// Its properties.
    pub properties: Map<String, Json>,
    /// Its geometry, taken apart.
    pub parts: Result<Parts, Flaw>,
}

/// Longitude or easting, latitude or northing, and the height if there is one.
pub type Place = ([f64; 2], Option<f64>);

/// A geometry taken apart.
#[derive(Default)]
pub struct Parts {
    /// Outlines with their holes.
    pub polygons: Vec<Vec<Vec<Place>>>,
    /// Lines.
    pub lines: Vec<Vec<Place>>,
    /// Points.
    pub points: Vec<Place>,
}

/// Why a feature, or a part of it, is left out.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Flaw {
    /// It is something else.
    #[error("it is no feature")]
    NotAFeature,
    /// `"geometry": null`, or no geometry.
    #[error("it has no geometry")]
    NoGeometry,
    /// The geometry is not GeoJSON.
    #[error("its geometry cannot be read: {0}")]
    Unreadable(String),
    /// Nothing in the geometry.
    #[error("its geometry is empty")]
    Empty,
    /// An outline or a line of too few points.
    #[error("it has fewer than {0} different points")]
    TooFew(usize),
    /// An outline that encloses nothing.
    #[error("it encloses no area")]
    NoArea,
    /// Degrees that are none.
    #[error("it lies off the globe: degrees are within ±180 and ±90, longitude first")]
    OffTheGlobe,
    /// Nowhere in the plan.
    #[error("its coordinates cannot be brought into the plan")]
    Unplaceable,
}

impl Item {
    /// Where it begins.
    pub fn first_position(&self) -> Option<[f64; 2]> {
        self.parts.as_ref().ok()?.positions().next().map(|p| p.0)
    }
}

impl Parts {
    /// Every position.
    pub fn positions(&self) -> impl Iterator<Item = &Place> {
        let outlines = self.polygons.iter().flatten().flatten();
        outlines.chain(self.lines.iter().flatten()).chain(&self.points)
    }

    /// Takes a geometry apart; what holds nothing adds nothing.
    fn add(&mut self, value: GeometryValue) {
        match value {
            GeometryValue::Point { coordinates } => self.points.extend(place(&coordinates)),
            GeometryValue::MultiPoint { coordinates } => self.points.extend(coordinates.iter().filter_map(place)),
            GeometryValue::LineString { coordinates } => self.lines.push(line(&coordinates)),
            GeometryValue::MultiLineString { coordinates } => self.lines.extend(coordinates.iter().map(|l| line(l))),
            GeometryValue::Polygon { coordinates } => self.polygons.push(rings(&coordinates)),
            GeometryValue::MultiPolygon { coordinates } => self.polygons.extend(coordinates.iter().map(|p| rings(p))),
            GeometryValue::GeometryCollection { geometries } => geometries.into_iter().for_each(|g| self.add(g.value)),
        }
    }
}

/// Whether the pair can be a longitude and a latitude.
pub fn are_degrees([longitude, latitude]: [f64; 2]) -> bool {
    longitude.abs() <= 180.0 && latitude.abs() <= 90.0
}

/// Reads the text; an error where it is no GeoJSON or too large.
pub fn read(path: &str, bytes: &[u8]) -> Result<Document, Box<Diagnostic>> {
    let refused = |message: String| Box::new(Diagnostic::data("layout-geojson", path, message));
    // A byte order mark is no JSON, but editors on Windows write it.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let json: Json = serde_json::from_slice(bytes).map_err(|e| {
        let place = format!("{path}:{}:{}", e.line(), e.column());
        Box::new(Diagnostic::data("layout-json", place, format!("this is no valid JSON: {e}")))
    })?;
    let Json::Object(mut object) = json else {
        return Err(refused("a layout is a JSON object with a `type`, this is something else".to_owned()));
    };
    let crs = named_crs(object.get("crs"));
    let items: Vec<Item> = match object.get("type").and_then(Json::as_str) {
        Some("FeatureCollection") => collection(object.remove("features")).map_err(refused)?,
        Some("Feature") => vec![item(0, Json::Object(object))],
        Some(word) if GEOMETRIES.contains(&word) => vec![bare(0, Json::Object(object))],
        found => return Err(strange_type(path, found)),
    };
    let positions: usize = items.iter().filter_map(|i| i.parts.as_ref().ok()).map(|p| p.positions().count()).sum();
    for (count, most, noun) in [(items.len(), MOST_FEATURES, "features"), (positions, MOST_POSITIONS, "positions")] {
        if count > most {
            let message = format!("{} {noun} are more than the limit of {}", thousands(count), thousands(most));
            return Err(Box::new(refused(message).hint("cut the layout into tiles")));
        }
    }
    Ok(Document { crs, items })
}

/// The geometries of RFC 7946.
const GEOMETRIES: [&str; 7] =
    ["Point", "MultiPoint", "LineString", "MultiLineString", "Polygon", "MultiPolygon", "GeometryCollection"];

fn strange_type(path: &str, found: Option<&str>) -> Box<Diagnostic> {
    let message = match found {
        Some(word) => format!("`{word}` is no GeoJSON type"),
        None => "the layout has no `type`: GeoJSON begins with `\"type\": \"FeatureCollection\"`".to_owned(),
    };
    let diagnostic = Diagnostic::data("layout-geojson", path, message);
    let types = GEOMETRIES.into_iter().chain(["FeatureCollection", "Feature"]);
    Box::new(match found {
        Some("Topology") => diagnostic.hint("this is TopoJSON: convert it to GeoJSON first"),
        Some(word) => diagnostic.did_you_mean(nearest(word, types)),
        None => diagnostic,
    })
}

/// The old `crs` member: a name, or `{"type": "name", "properties": {"name": …}}`.
fn named_crs(member: Option<&Json>) -> Result<Crs, CrsError> {
    match member {
        None | Some(Json::Null) => Ok(Crs::Wgs84),
        Some(Json::String(name)) => Crs::parse(name),
        Some(other) => match other.pointer("/properties/name").and_then(Json::as_str) {
            Some(name) => Crs::parse(name),
            None => Err(CrsError::Unknown(other.to_string())),
        },
    }
}

fn collection(features: Option<Json>) -> Result<Vec<Item>, String> {
    match features {
        Some(Json::Array(features)) => Ok(features.into_iter().enumerate().map(|(i, f)| item(i, f)).collect()),
        _ => Err("the `FeatureCollection` has no list of `features`".to_owned()),
    }
}

fn item(index: usize, json: Json) -> Item {
    let Json::Object(mut object) = json else { return flawed(index, Flaw::NotAFeature) };
    match object.get("type").and_then(Json::as_str) {
        Some("Feature") => {}
        Some(word) if GEOMETRIES.contains(&word) => return bare(index, Json::Object(object)),
        _ => return flawed(index, Flaw::NotAFeature),
    }
    let properties = match object.remove("properties") {
        Some(Json::Object(properties)) => properties,
        _ => Map::new(),
    };
    let id = word(object.get("id")).or_else(|| word(properties.get("id")));
    let parts = match object.remove("geometry") {
        None | Some(Json::Null) => Err(Flaw::NoGeometry),
        Some(geometry) => parts(geometry),
    };
    Item { id: id.map_or_else(|| number(index), Arc::from), properties, parts }
}

fn bare(index: usize, geometry: Json) -> Item {
    Item { id: number(index), properties: Map::new(), parts: parts(geometry) }
}

fn flawed(index: usize, flaw: Flaw) -> Item {
    Item { id: number(index), properties: Map::new(), parts: Err(flaw) }
}

fn number(index: usize) -> Arc<str> {
    (index + 1).to_string().into()
}

/// A text or number as an id or a name.
pub fn word(json: Option<&Json>) -> Option<String> {
    match json? {
        Json::String(text) => Some(text.trim().to_owned()).filter(|t| !t.is_empty()),
        Json::Number(number) => Some(number.to_string()),
        _ => None,
    }
}

fn parts(json: Json) -> Result<Parts, Flaw> {
    let geometry: Geometry = serde_json::from_value(json).map_err(|e| Flaw::Unreadable(e.to_string()))?;
    let mut parts = Parts::default();
    parts.add(geometry.value);
    if parts.positions().next().is_none() { Err(Flaw::Empty) } else { Ok(parts) }
}

fn place(position: &Position) -> Option<Place> {
    match position.as_slice() {
        [x, y, rest @ ..] => Some(([*x, *y], rest.first().copied())),
        _ => None,
    }
}

fn line(positions: &[Position]) -> Vec<Place> {
    positions.iter().filter_map(place).collect()
}

fn rings(rings: &[Vec<Position>]) -> Vec<Vec<Place>> {
    rings.iter().map(|r| line(r)).collect()
}
