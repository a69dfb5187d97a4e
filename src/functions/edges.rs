//! Attributes of the edges of a region: `edgeAttr.getFloat` and its like.
//!
//! An attribute of the region that is an array has a value for each edge of the outline, in its order. The current
//! shape has that of the edge it covers most.

use crate::functions::args::text_at;
use crate::functions::{Function, Surroundings};
use crate::geometry::nearest_on_segment;
use crate::shape::{Geometry, on_plan};
use crate::value::{Array, Value};
use glam::DVec2;
use std::sync::Arc;

/// Edges count as covered no worse than by this much (metres) for every metre that the shape is farther away.
const NEARNESS: f64 = 1.0;

pub(super) static LIST: &[Function] = &[
    Function::new(
        "edgeAttr.getFloat",
        "(name)",
        (1, 1),
        "The number that the region's edge under the shape has in an attribute with a value for each edge; else 0.",
        |args, around| {
            let value = value(text_at(args, 0)?, around);
            Ok(Value::Float(value.as_ref().and_then(Value::as_float).unwrap_or(0.0)))
        },
    ),
    Function::new(
        "edgeAttr.getString",
        "(name)",
        (1, 1),
        "The text that the region's edge under the shape has in an attribute with a value for each edge; else empty.",
        |args, around| {
            let value = value(text_at(args, 0)?, around);
            Ok(Value::text(value.as_ref().and_then(Value::as_str).unwrap_or_default()))
        },
    )
    .text(),
    Function::new(
        "edgeAttr.getBool",
        "(name)",
        (1, 1),
        "The truth value that the region's edge under the shape has in an attribute with one for each edge; else false.",
        |args, around| {
            let value = value(text_at(args, 0)?, around);
            Ok(Value::Bool(value.as_ref().and_then(Value::as_bool).unwrap_or(false)))
        },
    )
    .truth(),
];

/// What the edge under the shape has; none where no attribute of that name has a value for each edge.
fn value(name: &str, around: &Surroundings) -> Option<Value> {
    let edges = &around.initial.edge_attributes;
    let (_, array): &(Arc<str>, Arc<Array>) = edges.iter().find(|(own, _)| **own == *name)?;
    Some(array.at(edge(around)?))
}

/// The edge of the region's outline that the shape covers most when it is laid on it.
fn edge(around: &Surroundings) -> Option<usize> {
    let points = outline(around);
    let middle = points.iter().sum::<DVec2>() / points.len().max(1) as f64;
    let ring = around.initial.outline.as_ref()?.outer();
    let cover = |index: usize| {
        let (a, b) = (ring[index], ring[(index + 1) % ring.len()]);
        let along = (b - a).normalize_or_zero();
        let places = points.iter().map(|p| along.dot(*p - a).clamp(0.0, a.distance(b)));
        let (low, high) = places.fold((f64::INFINITY, 0.0_f64), |(low, high), x| (low.min(x), high.max(x)));
        (high - low) - NEARNESS * nearest_on_segment(middle, a, b).distance(middle)
    };
    (0..ring.len()).max_by(|a, b| cover(*a).total_cmp(&cover(*b)).then(b.cmp(a)))
}

/// The vertices of the shape on the plan.
fn outline(around: &Surroundings) -> Vec<DVec2> {
    let frame = &around.shape.scope.frame;
    let world = |p| on_plan(frame.to_world(p));
    match &around.shape.geometry {
        Geometry::Path(points) => points.iter().copied().map(world).collect(),
        Geometry::Flat(plane, area) | Geometry::Prism(plane, area, _) => {
            area.edges().map(|(a, _)| world(plane.at(a))).collect()
        }
        Geometry::Mesh(mesh) => mesh.positions.iter().copied().map(world).collect(),
        Geometry::Empty | Geometry::Point | Geometry::Element(_) => {
            vec![world(around.shape.scope.size * 0.5)]
        }
    }
}
