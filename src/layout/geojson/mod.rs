//! GeoJSON (RFC 7946) → layout.
//!
//! In: the bytes of a FeatureCollection, a Feature or a bare geometry. Out: the layout in plan metres and what there is
//! to say about it. Nothing is dropped in silence: what cannot be used is named, what was guessed or repaired is
//! counted. Knows no rules and no files.

mod build;
mod document;
mod order;
mod properties;
mod report;

use crate::diag::Diagnostic;
use crate::layout::nearby::relate;
use crate::layout::{Crs, CrsError, Georeference, Layout};
use build::Builder;
use document::{Document, Item};
use report::Report;

/// More features than this in one layout are refused: cut the layout into tiles.
pub const MOST_FEATURES: usize = 1_000_000;
/// More positions than this in one layout are refused.
pub const MOST_POSITIONS: usize = 20_000_000;

/// Local metres nearer to their origin than this keep it.
const LOCAL_REACH: f64 = 100_000.0;

/// Reads a GeoJSON text. Never fails: what cannot be used is reported with its feature and left out.
///
/// Coordinates are WGS84 degrees, or what the old `crs` member names: `"crs": "EPSG:2154"`, its long form with
/// `urn:ogc:def:crs:EPSG::2154`, or `"crs": "local"` for metres without a place on earth.
///
/// A feature's `kind` says what it is; without one an area is taken for a lot, a point for a marker, or for a tree
/// where it has a `species`. Lots, blocks, patios, avenues, regions and kinds of the user's own become regions where
/// they have an area; buildings, drives, trees and markers become features. Water, streets and footways are both:
/// rules may start on them, and other regions see them. A line of a street, footway, avenue or water with a `width`
/// gets its area from it. The id is the feature's `id`, its property `id`, or its number counted from 1; what comes
/// in several parts has regions `id/1`, `id/2` …
///
/// Cost: n log n for ordinary layouts.
pub fn read_geojson(path: &str, bytes: &[u8]) -> (Layout, Vec<Diagnostic>) {
    let mut report = Report::new(path);
    let document = match document::read(path, bytes) {
        Ok(document) => document,
        Err(diagnostic) => return (Layout::default(), vec![*diagnostic]),
    };
    let georeference = match georeference(path, &document) {
        Ok(georeference) => georeference,
        Err(diagnostic) => return (Layout::default(), vec![*diagnostic]),
    };
    let mut builder = Builder::new(georeference);
    for item in document.items {
        builder.add(item, &mut report);
    }
    let (mut layout, origins) = builder.finish();
    relate(&mut layout, &origins);
    let diagnostics = report.finish(&layout);
    (layout, diagnostics)
}

/// The way from the document's coordinates to the plan.
fn georeference(path: &str, document: &Document) -> Result<Georeference, Box<Diagnostic>> {
    let refused = |error: CrsError| {
        let hint = "name a system of the EPSG register, as in `\"crs\": \"EPSG:2154\"`, or `\"crs\": \"local\"` for metres \
                    without a place on earth";
        Box::new(Diagnostic::data("layout-crs", path, error.to_string()).hint(hint))
    };
    let crs = document.crs.clone().map_err(refused)?;
    if crs == Crs::Wgs84 {
        expect_degrees(path, document)?;
    }
    let centre = centre(&crs, &document.items);
    Georeference::new(crs, centre).map_err(refused)
}

/// An error where most of the coordinates cannot be degrees.
fn expect_degrees(path: &str, document: &Document) -> Result<(), Box<Diagnostic>> {
    let strange = |p: &[f64; 2]| !document::are_degrees(*p);
    let firsts = || document.items.iter().filter_map(Item::first_position);
    let Some(example) = firsts().find(strange) else { return Ok(()) };
    if firsts().filter(strange).count() * 2 <= firsts().count() {
        return Ok(());
    }
    let message = format!("the coordinates are no degrees: {}, {} lies off the globe", example[0], example[1]);
    let diagnostic = Diagnostic::data("layout-crs", path, message)
        .hint("they look like projected metres: name their system beside `features`, as in `\"crs\": \"EPSG:2154\"`")
        .hint("for metres without a place on earth write `\"crs\": \"local\"`");
    Err(Box::new(diagnostic))
}

/// The plan's origin: the median place, so that one stray feature moves nothing, and on a coarse grid, so that small
/// edits move nothing either.
fn centre(crs: &Crs, items: &[Item]) -> [f64; 2] {
    let firsts = || items.iter().filter_map(Item::first_position);
    let median = |axis: usize| {
        let mut values: Vec<f64> = firsts().map(|p| p[axis]).collect();
        let middle = values.len() / 2;
        if values.is_empty() { 0.0 } else { *values.select_nth_unstable_by(middle, f64::total_cmp).1 }
    };
    let middle = [median(0), median(1)];
    match crs {
        Crs::Wgs84 => middle.map(|v| (v * 1000.0).round() / 1000.0),
        Crs::Local if middle.iter().all(|v| v.abs() < LOCAL_REACH) => [0.0; 2],
        Crs::Local | Crs::Epsg(_) => middle.map(|v| (v / 100.0).round() * 100.0),
    }
}
