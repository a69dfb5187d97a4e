//! Plants back from their own exports, or from files that others made or changed.
//!
//! Fields may be missing (they keep their default) and further ones may be there; a field that is there must make
//! sense. The position must be there.

use crate::export::csv::parse_rows;
use crate::export::plants::{DEGREE_COLUMNS, FIELDS, Field, METRE_COLUMNS};
use crate::layout::{Crs, Georeference};
use crate::scene::{Origin, Plant, PlantSymbol};
use glam::DVec2;
use serde_json::Value;

/// Why plants could not be read.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadPlantsError {
    /// The bytes are no text.
    #[error("the file is not UTF-8 text")]
    Text,
    /// The JSON is broken.
    #[error("the file is not JSON: {0}")]
    Json(String),
    /// It is JSON, but no collection of features.
    #[error("the file is no GeoJSON feature collection")]
    Collection,
    /// The file is in another coordinate system than the layout.
    #[error("the plants are in `{found}`, the layout is in `{wanted}`: export them again, or reproject them")]
    Crs {
        /// The file's system.
        found: String,
        /// The layout's.
        wanted: String,
    },
    /// A quote is opened and not closed.
    #[error("line {0}: a quote is opened and never closed")]
    Quote(usize),
    /// The header lacks the position.
    #[error("the first line must name the columns, among them `longitude` and `latitude`, or `x` and `y`")]
    Header,
    /// A plant has no position.
    #[error("{place}: there is no position")]
    Position {
        /// The feature or line.
        place: String,
    },
    /// A field makes no sense.
    #[error("{place}: `{field}` must be {wanted}, not `{found}`")]
    Field {
        /// The feature or line.
        place: String,
        /// The field.
        field: &'static str,
        /// What would do.
        wanted: &'static str,
        /// What was written.
        found: String,
    },
}

/// The plants of a GeoJSON or CSV text, told apart by the first sign, in file order.
///
/// `georeference` is that of the layout they stand in: positions become metres in its plan.
pub fn read_plants(bytes: &[u8], georeference: &Georeference) -> Result<Vec<Plant>, ReadPlantsError> {
    let text = std::str::from_utf8(bytes).map_err(|_| ReadPlantsError::Text)?;
    let text = text.trim_start_matches('\u{feff}');
    if text.trim_start().starts_with(['{', '[']) { read_json(text, georeference) } else { read_csv(text, georeference) }
}

fn read_json(text: &str, georeference: &Georeference) -> Result<Vec<Plant>, ReadPlantsError> {
    let file: Value = serde_json::from_str(text).map_err(|error| ReadPlantsError::Json(error.to_string()))?;
    let features = file.get("features").and_then(Value::as_array).ok_or(ReadPlantsError::Collection)?;
    check_crs(&file, georeference)?;
    let read = |(index, feature)| read_feature(index + 1, feature, georeference);
    features.iter().enumerate().map(read).collect()
}

fn check_crs(file: &Value, georeference: &Georeference) -> Result<(), ReadPlantsError> {
    let Some(name) = file.pointer("/crs/properties/name").and_then(Value::as_str) else { return Ok(()) };
    if Crs::parse(name).as_ref() == Ok(&georeference.crs) {
        return Ok(());
    }
    Err(ReadPlantsError::Crs { found: name.into(), wanted: georeference.crs.to_string() })
}

fn read_feature(number: usize, feature: &Value, georeference: &Georeference) -> Result<Plant, ReadPlantsError> {
    let place = || format!("feature {number}");
    let at = |axis: usize| feature.pointer("/geometry/coordinates")?.get(axis)?.as_f64();
    let mut plant =
        plant_at(at(0).zip(at(1)), georeference).ok_or_else(|| ReadPlantsError::Position { place: place() })?;
    plant.elevation = at(2).unwrap_or(0.0);
    if let Some(id) = feature.get("id") {
        plant.origin.id = plain(id).into();
    }
    for field in FIELDS {
        match feature.pointer("/properties").and_then(|properties| properties.get(field.name)) {
            None | Some(Value::Null) => {}
            Some(value) => set(field, &mut plant, &plain(value), place)?,
        }
    }
    Ok(plant)
}

/// A JSON value as CSV would have it.
fn plain(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn read_csv(text: &str, georeference: &Georeference) -> Result<Vec<Plant>, ReadPlantsError> {
    let mut rows = parse_rows(text).map_err(ReadPlantsError::Quote)?.into_iter();
    let (_, header) = rows.next().ok_or(ReadPlantsError::Header)?;
    let column = |name: &str| header.iter().position(|title| title.trim() == name);
    let pair = |[x, y]: [&str; 2]| column(x).zip(column(y));
    let position = pair(DEGREE_COLUMNS).or_else(|| pair(METRE_COLUMNS)).ok_or(ReadPlantsError::Header)?;
    let columns: Vec<(&Field, usize)> = FIELDS.iter().filter_map(|f| Some((f, column(f.name)?))).collect();
    rows.map(|(line, row)| read_row(line, &row, position, &columns, georeference)).collect()
}

fn read_row(
    line: usize,
    row: &[String],
    position: (usize, usize),
    columns: &[(&Field, usize)],
    georeference: &Georeference,
) -> Result<Plant, ReadPlantsError> {
    let place = || format!("line {line}");
    let at = |column: usize| row.get(column)?.trim().parse::<f64>().ok();
    let mut plant = plant_at(at(position.0).zip(at(position.1)), georeference)
        .ok_or_else(|| ReadPlantsError::Position { place: place() })?;
    for (field, column) in columns {
        match row.get(*column) {
            Some(written) if field.may_be_empty() || !written.is_empty() => set(field, &mut plant, written, place)?,
            _ => {}
        }
    }
    Ok(plant)
}

fn set(field: &Field, plant: &mut Plant, written: &str, place: impl Fn() -> String) -> Result<(), ReadPlantsError> {
    if field.set(plant, written) {
        return Ok(());
    }
    let found = written.chars().take(40).collect();
    Err(ReadPlantsError::Field { place: place(), field: field.name, wanted: field.wanted(), found })
}

/// A plant of which nothing is known but where it stands; `None` where that is nowhere.
fn plant_at(world: Option<(f64, f64)>, georeference: &Georeference) -> Option<Plant> {
    let position = world.map(|(x, y)| georeference.to_plan([x, y])).filter(|plan: &DVec2| plan.is_finite())?;
    Some(Plant {
        origin: Origin::default(),
        position,
        elevation: 0.0,
        heading: 0.0,
        kind: "tree".into(),
        category: "".into(),
        age_class: "".into(),
        appearance: 0,
        species: "".into(),
        common_name: "".into(),
        code: "".into(),
        spacing_radius: 0.0,
        crown_radius: 0.0,
        age: 0.0,
        height: 0.0,
        trunk_diameter: 0.0,
        crown_height: 0.0,
        leaf_area: 0.0,
        pruning: 1.0,
        measured: false,
        seed: 0,
        managed: true,
        existing: false,
        symbol: PlantSymbol::default(),
        color: [0.69, 0.77, 0.55, 1.0],
    })
}
