//! What every GeoJSON export shares: the frame of the collection, coordinates in the layout's own system, texts.
//!
//! One feature stands on a line, so that two runs can be compared line by line.

use crate::geometry::{Area, Polygon};
use crate::layout::Georeference;
use crate::scene::Scene;
use glam::DVec2;
use std::fmt::Write;

/// Degrees keep a tenth of a millimetre with nine places, metres with four.
const DEGREE_PLACES: usize = 9;
const METRE_PLACES: usize = 4;

/// Plan metres as texts in the layout's own system.
pub(super) struct Coordinates<'a> {
    georeference: &'a Georeference,
    places: usize,
}

impl<'a> Coordinates<'a> {
    /// For this way back to the world.
    pub fn new(georeference: &'a Georeference) -> Coordinates<'a> {
        let [a, b] = [DVec2::ZERO, DVec2::Y].map(|plan| georeference.to_world(plan)[1]);
        let degrees = (b - a).abs() < 0.01;
        Coordinates { georeference, places: if degrees { DEGREE_PLACES } else { METRE_PLACES } }
    }

    /// Whether they are longitude and latitude.
    pub fn in_degrees(&self) -> bool {
        self.places == DEGREE_PLACES
    }

    /// Both coordinates of a point; empty where the plan leaves the system.
    pub fn texts(&self, plan: DVec2) -> [String; 2] {
        let text = |number: f64| if number.is_finite() { format!("{number:.*}", self.places) } else { String::new() };
        self.georeference.to_world(plan).map(text)
    }

    /// An area as a GeoJSON geometry, all of it at one elevation.
    pub fn push_area(&self, out: &mut String, area: &Area, elevation: f64) {
        let rings = |out: &mut String, polygon: &Polygon| {
            push_list(out, polygon.rings(), |out, ring| self.push_ring(out, ring, elevation));
        };
        match area.polygons() {
            [] => out.push_str("null"),
            [polygon] => {
                out.push_str("{\"type\":\"Polygon\",\"coordinates\":");
                rings(out, polygon);
                out.push('}');
            }
            polygons => {
                out.push_str("{\"type\":\"MultiPolygon\",\"coordinates\":");
                push_list(out, polygons.iter(), rings);
                out.push('}');
            }
        }
    }

    /// A point as a GeoJSON position.
    pub fn push_position(&self, out: &mut String, plan: DVec2, elevation: f64) {
        out.push('[');
        for text in self.texts(plan) {
            out.push_str(if text.is_empty() { "null" } else { &text });
            out.push(',');
        }
        push_number(out, elevation);
        out.push(']');
    }

    fn push_ring(&self, out: &mut String, ring: &[DVec2], elevation: f64) {
        let closed = ring.iter().chain(ring.first());
        push_list(out, closed, |out, point| self.push_position(out, *point, elevation));
    }
}

/// A feature collection of features that are written one by one, each as a whole object.
pub(super) fn collection<T>(
    scene: &Scene,
    layer: &str,
    items: impl IntoIterator<Item = T>,
    mut push: impl FnMut(&mut String, T),
) -> String {
    let mut out = String::from("{\"type\":\"FeatureCollection\",\"name\":");
    push_text(&mut out, layer);
    out.push_str(",\"title\":");
    push_text(&mut out, &scene.title);
    if let Some(name) = scene.georeference.crs.name() {
        out.push_str(",\"crs\":{\"type\":\"name\",\"properties\":{\"name\":");
        push_text(&mut out, &name);
        out.push_str("}}");
    }
    out.push_str(",\"features\":[");
    for (index, item) in items.into_iter().enumerate() {
        out.push_str(if index == 0 { "\n" } else { ",\n" });
        push(&mut out, item);
    }
    out.push_str("\n]}\n");
    out
}

/// A JSON text.
pub(super) fn push_text(out: &mut String, text: &str) {
    out.push_str(&serde_json::Value::from(text).to_string());
}

/// A JSON number with the fewest digits that read back the same; `null` where it is none.
pub(super) fn push_number(out: &mut String, number: f64) {
    if number.is_finite() {
        let _ = write!(out, "{number}");
    } else {
        out.push_str("null");
    }
}

fn push_list<T>(out: &mut String, items: impl Iterator<Item = T>, mut push: impl FnMut(&mut String, T)) {
    out.push('[');
    for (index, item) in items.enumerate() {
        if index > 0 {
            out.push(',');
        }
        push(out, item);
    }
    out.push(']');
}
