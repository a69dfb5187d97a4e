//! Measures of the current shape's geometry.

use crate::functions::{Function, Surroundings};
use crate::shape::Measure;
use crate::value::Value;

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
        "The area in m²: of all faces, or of those that look one way (`bottom`, `top`, `side` …).",
        area,
    )
    .words(&["all", "bottom", "top", "front", "back", "left", "right", "side"]),
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
    let way = args.first().and_then(Value::as_str).unwrap_or("all");
    Ok(Value::Float(around.shape.area_towards(way)))
}
