//! Plants as data: GeoJSON for GIS programs, CSV for spreadsheets, and back.
//!
//! In: a scene. Out: text in the layout's own coordinates, x (longitude) first. Both formats carry the same record,
//! [`FIELDS`], and [`read_plants`] reads it back without loss (positions to a tenth of a millimetre). Texts are written
//! as they are: nothing is added to keep a spreadsheet from taking one for a formula.

mod fields;
mod read;

pub use fields::{FIELDS, Field};
pub use read::{ReadPlantsError, read_plants};

use crate::export::csv::push_row;
use crate::export::geo::{Coordinates, collection, push_text};
use crate::scene::{Plant, Scene};
use fields::Cell;

/// The columns of a position: in degrees, and in metres.
const DEGREE_COLUMNS: [&str; 2] = ["longitude", "latitude"];
const METRE_COLUMNS: [&str; 2] = ["x", "y"];

/// Every plant as a GeoJSON point feature with its elevation as third coordinate, one feature a line.
///
/// Coordinates are the layout's own; where those are not WGS84, the collection has a `crs` member.
pub fn plants_geojson(scene: &Scene) -> String {
    let coordinates = Coordinates::new(&scene.georeference);
    collection(scene, "plants", &scene.plants, |out, plant| push_feature(out, plant, &coordinates))
}

/// Every plant as a row under a header: two columns of position, then the fields in their order.
pub fn plants_csv(scene: &Scene) -> String {
    let coordinates = Coordinates::new(&scene.georeference);
    let columns = if coordinates.in_degrees() { DEGREE_COLUMNS } else { METRE_COLUMNS };
    let mut out = String::new();
    push_row(&mut out, columns.into_iter().chain(FIELDS.iter().map(|field| field.name)));
    for plant in &scene.plants {
        let position = coordinates.texts(plant.position).into_iter();
        push_row(&mut out, position.chain(FIELDS.iter().map(|field| field.get(plant).into_text())));
    }
    out
}

fn push_feature(out: &mut String, plant: &Plant, coordinates: &Coordinates<'_>) {
    out.push_str("{\"type\":\"Feature\",\"id\":");
    push_text(out, &plant.origin.id);
    out.push_str(",\"geometry\":{\"type\":\"Point\",\"coordinates\":");
    coordinates.push_position(out, plant.position, plant.elevation);
    out.push_str("},\"properties\":{");
    for (index, field) in FIELDS.iter().enumerate() {
        if index > 0 {
            out.push(',');
        }
        push_text(out, field.name);
        out.push(':');
        field.get(plant).push_json(out);
    }
    out.push_str("}}");
}

impl Cell {
    fn into_text(self) -> String {
        match self {
            Cell::Text(text) | Cell::Plain(text) => text,
            Cell::Missing => String::new(),
        }
    }

    fn push_json(&self, out: &mut String) {
        match self {
            Cell::Text(text) => push_text(out, text),
            Cell::Plain(text) => out.push_str(text),
            Cell::Missing => out.push_str("null"),
        }
    }
}
