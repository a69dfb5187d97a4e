//! Texture coordinates and tags of the current shape.

use crate::functions::args::{number, text_at};
use crate::functions::{Function, Gives, Surroundings};
use crate::geometry::Bounds;
use crate::shape::{Part, Way};
use crate::value::{Array, Cells, Value};
use std::sync::Arc;

const SPACES: &[&str] = &["uvSpace", "unitSpace"];
const EXTENT: &str = "(uvSet, uvSpace|unitSpace)";
const SET: &str = "() | (uvSet)";
const PARTS: &[&str] = &["f", "e", "v"];

macro_rules! limit {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, SET, (0, 1), $docs, |args, around| {
            let f: fn(Bounds) -> f64 = $f;
            Ok(Value::Float(extent(args, around)?.map_or(0.0, f)))
        })
    };
}

pub(super) static LIST: &[Function] = &[
    Function::new(
        "geometry.du",
        EXTENT,
        (1, 2),
        "The extent along u: in u itself, or with `unitSpace` in metres in the middle of the shape.",
        |args, around| length(args, around, Way::U),
    )
    .words(SPACES),
    Function::new(
        "geometry.dv",
        EXTENT,
        (1, 2),
        "The extent along v: in v itself, or with `unitSpace` in metres.",
        |args, around| length(args, around, Way::V),
    )
    .words(SPACES),
    limit!("geometry.uMin", "The least u.", |b| b.min.x),
    limit!("geometry.uMax", "The greatest u.", |b| b.max.x),
    limit!("geometry.vMin", "The least v.", |b| b.min.y),
    limit!("geometry.vMax", "The greatest v.", |b| b.max.y),
    Function::new(
        "geometry.hasUVs",
        SET,
        (0, 1),
        "Whether there are texture coordinates: every surface has some.",
        |args, around| Ok(Value::Bool(extent(args, around)?.is_some())),
    )
    .truth(),
    Function::new(
        "isTagged",
        "(query) | (query, f|e|v)",
        (1, 2),
        "Whether a face, edge or vertex has a tag: its name or its beginning up to a dot, with `?` and `*`.",
        |args, around| {
            let query = text_at(args, 0)?;
            Ok(Value::Bool(around.shape.is_tagged(query, part(args, 1, around)?)))
        },
    )
    .truth()
    .tagging()
    .words(PARTS),
    Function::new(
        "geometry.hasTags",
        "() | (query) | (query, f|e|v)",
        (0, 2),
        "Whether a face, edge or vertex has a tag, or one that answers to a query.",
        |args, around| {
            let query = if args.is_empty() { "*" } else { text_at(args, 0)? };
            Ok(Value::Bool(around.shape.is_tagged(query, part(args, 1, around)?)))
        },
    )
    .truth()
    .tagging()
    .words(PARTS),
    Function::new(
        "geometry.tags",
        "() | (f|e|v)",
        (0, 1),
        "The names of all tags on faces, edges or vertices, in alphabetical order.",
        |args, around| {
            let names: Vec<Arc<str>> = around.shape.tags(part(args, 0, around)?);
            Ok(Value::Array(Arc::new(Array::row(Cells::Texts(names)))))
        },
    )
    .gives(Gives::Texts)
    .tagging()
    .words(PARTS),
    Function::new(
        "geometry.groups",
        "",
        (0, 0),
        "The names of groups in a model: none, since models are not taken apart.",
        |_, _| Ok(Value::Array(Arc::new(Array::row(Cells::Texts(Vec::new()))))),
    )
    .gives(Gives::Texts),
    Function::new("geometry.materials", "", (0, 0), "The names of materials: that of the shape.", |_, around| {
        let name = around.shape.style.material.clone();
        Ok(Value::Array(Arc::new(Array::row(Cells::Texts(name.into_iter().collect())))))
    })
    .gives(Gives::Texts),
];

/// The set that the first argument names, 0 where there is none.
fn set(args: &[Value]) -> Result<u32, String> {
    match args.first() {
        Some(_) => Ok(number(args, 0)?.clamp(0.0, 9.0) as u32),
        None => Ok(0),
    }
}

/// The shape's extent in texture coordinates; none for what has no surface.
fn extent(args: &[Value], around: &Surroundings) -> Result<Option<Bounds>, String> {
    let chart = around.shape.chart(set(args)?);
    Ok(chart.map(|chart| chart.extent(around.shape)).filter(|bounds| !bounds.is_empty()))
}

fn length(args: &[Value], around: &Surroundings, way: Way) -> Result<Value, String> {
    let Some(chart) = around.shape.chart(set(args)?) else { return Ok(Value::Float(0.0)) };
    let extent = chart.extent(around.shape);
    if extent.is_empty() {
        return Ok(Value::Float(0.0));
    }
    let (low, high) = (extent.min[way.index()], extent.max[way.index()]);
    match args.get(1).and_then(Value::as_str) {
        Some("unitSpace") => Ok(Value::Float(chart.metres(way, low, high, chart.places(around.shape)))),
        None | Some("uvSpace") => Ok(Value::Float(high - low)),
        Some(other) => Err(format!("takes `uvSpace` or `unitSpace`, found `{other}`")),
    }
}

/// `f`, `e` or `v`; what the shape is made of where nothing is said.
fn part(args: &[Value], index: usize, around: &Surroundings) -> Result<Part, String> {
    match args.get(index).map(Value::as_str) {
        None => Ok(around.shape.main_part()),
        Some(Some("f" | "faces")) => Ok(Part::Faces),
        Some(Some("e" | "edges")) => Ok(Part::Edges),
        Some(Some("v" | "vertices")) => Ok(Part::Vertices),
        Some(_) => Err("takes `f`, `e` or `v` for faces, edges or vertices".into()),
    }
}
