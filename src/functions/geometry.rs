//! Measures of the current shape's geometry.

use crate::functions::args::{number, text_at, word_at};
use crate::functions::{Function, Surroundings};
use crate::shape::{Facing, Geometry, Measure};
use crate::value::Value;

/// Which faces are meant: all of them, or those that look one way.
const FACING: [&str; 2 + Facing::WORDS.len()] = {
    let mut words = ["all"; 2 + Facing::WORDS.len()];
    words[1] = "surface";
    let (_, ways) = words.split_at_mut(2);
    ways.copy_from_slice(&Facing::WORDS);
    words
};

macro_rules! measure {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "", (0, 0), $docs, |_, around| {
            let f: fn(Measure) -> Value = $f;
            Ok(f(around.shape.measure()))
        })
    };
}

pub(super) static LIST: &[Function] = &[
    Function::new(
        "geometry.area",
        "() | (orientation)",
        (0, 1),
        "The area in m²: of all faces, or of those that look one way (`bottom`, `object.front`, `world.up` …).",
        area,
    )
    .words(&FACING),
    Function::new(
        "geometry.isOriented",
        "(orientation)",
        (1, 1),
        "Whether a face looks one way (`front`, `object.side`, `world.up` …).",
        |args, around| match text_at(args, 0)? {
            "all" | "surface" => Ok(Value::Bool(around.shape.measure().faces > 0)),
            word => Ok(Value::Bool(around.shape.looks(facing(word)?))),
        },
    )
    .words(&FACING)
    .truth(),
    Function::new(
        "geometry.angle",
        "(maxSlope|azimuth|zenith)",
        (1, 1),
        "The steepest slope of the faces, degrees from level; the way that it falls, degrees clockwise from north; or 90 \
         less the slope. A line slopes as it runs.",
        |args, around| {
            let (slope, azimuth) = around.shape.steepest();
            Ok(Value::Float(match word_at(args, 0, &["maxSlope", "azimuth", "zenith"])? {
                "maxSlope" => slope,
                "azimuth" => azimuth,
                _ => 90.0 - slope,
            }))
        },
    )
    .words(&["maxSlope", "azimuth", "zenith"]),
    Function::new(
        "geometry.isPlanar",
        "() | (tolerance)",
        (0, 1),
        "Whether there are faces and all are flat, the normals at their corners within a tolerance in degrees (0.25).",
        |args, around| {
            let tolerance = if args.is_empty() { 0.25 } else { number(args, 0)? };
            Ok(Value::Bool(around.shape.is_planar(tolerance)))
        },
    )
    .truth(),
    Function::new(
        "geometry.isClosedSurface",
        "()",
        (0, 0),
        "Whether there are faces and every edge has one on both sides.",
        |_, around| Ok(Value::Bool(around.shape.is_closed())),
    )
    .truth(),
    Function::new(
        "geometry.isInstanced",
        "()",
        (0, 0),
        "Whether the shape is an element as it was inserted.",
        |_, around| Ok(Value::Bool(matches!(around.shape.geometry, Geometry::Element(_)))),
    )
    .truth(),
    measure!("geometry.volume", "The volume in m³; 0 where the geometry is not closed.", |m| Value::Float(m.volume)),
    measure!("geometry.boundaryLength", "The length of the outline in metres.", |m| Value::Float(m.boundary)),
    measure!("geometry.nVertices", "The number of vertices.", |m| Value::Float(m.vertices as f64)),
    measure!("geometry.nEdges", "The number of edges.", |m| Value::Float(m.edges as f64)),
    measure!("geometry.nFaces", "The number of faces.", |m| Value::Float(m.faces as f64)),
    measure!("geometry.nHoles", "The number of holes.", |m| Value::Float(m.holes as f64)),
    measure!("geometry.isConcave", "Whether a face is concave.", |m| Value::Bool(m.concave)).truth(),
    Function::new("geometry.height", "", (0, 0), "The extent along the scope's y axis in metres.", |_, around| {
        Ok(Value::Float(around.shape.scope.size.y))
    }),
    Function::new(
        "geometry.isRectangular",
        "() | (tolerance)",
        (0, 1),
        "Whether the face is a rectangle, its angles within a tolerance in degrees (5).",
        |args, around| {
            let tolerance = args.first().and_then(Value::as_float).unwrap_or(5.0);
            Ok(Value::Bool(around.shape.is_rectangular(tolerance)))
        },
    )
    .truth(),
];

fn area(args: &[Value], around: &mut Surroundings) -> Result<Value, String> {
    let area = match args.first().map(|_| text_at(args, 0)).transpose()? {
        None | Some("all" | "surface") => around.shape.measure().area,
        Some(word) => around.shape.area_towards(facing(word)?),
    };
    Ok(Value::Float(area))
}

fn facing(word: &str) -> Result<Facing, String> {
    Facing::of_word(word).ok_or_else(|| format!("takes a way to look such as `front` or `world.up`, found `{word}`"))
}
