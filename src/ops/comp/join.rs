//! Components put together again: faces as a mesh, edges as a line.

use crate::geometry::Mesh;
use crate::ops::comp::faces::ALONG;
use crate::ops::{Gather, Problem, fit};
use crate::shape::{Geometry, Shape};
use glam::{DAffine3, DVec3};
use std::sync::Arc;

/// The components of an entry as one shape, or as one for each set that hangs together, in the parent's frame.
pub fn joined(parent: &Shape, shapes: &[Shape], gather: Gather) -> Result<Vec<Shape>, Problem> {
    let geometries = match shapes.iter().find(|shape| shape.local_mesh().is_none()).map(|shape| &shape.geometry) {
        None => surfaces(parent, shapes, gather),
        Some(Geometry::Path(_)) => lines(parent, shapes, gather)?,
        Some(_) => {
            let hint = "`:` gives one shape for each";
            return Err(Problem::new("vertices cannot be put together").hint(hint));
        }
    };
    Ok(geometries.into_iter().filter_map(|geometry| fit::fitted(parent, geometry)).collect())
}

/// Faces that have an edge in common hang together.
fn surfaces(parent: &Shape, shapes: &[Shape], gather: Gather) -> Vec<Geometry> {
    let inverse = parent.scope.frame.rotation.inverse();
    let to_parent = DAffine3::from_rotation_translation(inverse, inverse * -parent.scope.frame.origin);
    let mut mesh = Mesh::default();
    shapes.iter().filter_map(Shape::world_mesh).for_each(|face| mesh.append(&face.transformed(&to_parent)));
    let solid = |mesh: Mesh| Geometry::Mesh(Arc::new(mesh));
    match gather {
        Gather::Connected => mesh.connected_faces(ALONG).iter().map(|set| solid(mesh.only(set))).collect(),
        _ => vec![solid(mesh)],
    }
}

/// Edges that follow one another hang together.
fn lines(parent: &Shape, shapes: &[Shape], gather: Gather) -> Result<Vec<Geometry>, Problem> {
    let local = |shape: &Shape, p: DVec3| parent.scope.frame.to_local(shape.scope.frame.to_world(p));
    let ends = |shape: &Shape| match &shape.geometry {
        Geometry::Path(points) => Some((local(shape, points[0]), local(shape, *points.last()?))),
        _ => None,
    };
    let chains = chains(shapes.iter().filter_map(ends).collect());
    if gather == Gather::All && chains.len() > 1 {
        let message = format!("the edges make {} lines, and `=` wants one", chains.len());
        return Err(Problem::new(message).hint("`=:` gives one shape for each line, `:` for each edge"));
    }
    Ok(chains.into_iter().map(|points| Geometry::Path(points.into())).collect())
}

/// Segments joined end to end, in either direction; one that goes round ends where it began. Quadratic.
fn chains(mut segments: Vec<(DVec3, DVec3)>) -> Vec<Vec<DVec3>> {
    let mut chains = Vec::new();
    while !segments.is_empty() {
        let (from, to) = segments.remove(0);
        let mut chain = vec![from, to];
        prolong(&mut chain, &mut segments);
        chain.reverse();
        prolong(&mut chain, &mut segments);
        chain.reverse();
        chains.push(chain);
    }
    chains
}

/// Goes on from the last point as long as a segment begins or ends there.
fn prolong(chain: &mut Vec<DVec3>, segments: &mut Vec<(DVec3, DVec3)>) {
    while let Some(end) = chain.last().copied() {
        let meets = |p: DVec3| p.distance(end) < ALONG;
        let Some(next) = segments.iter().position(|(a, b)| meets(*a) || meets(*b)) else { return };
        let (a, b) = segments.remove(next);
        chain.push(if meets(a) { b } else { a });
    }
}
