//! New shapes from geometry in a parent's coordinates: the scope is fitted around it and the coordinates follow.

use crate::geometry::Area;
use crate::shape::{Geometry, Plane, Scope, Shape};
use glam::{DMat3, DQuat, DVec2, DVec3};
use std::sync::Arc;

/// A child of `parent` with the given geometry (in the parent's coordinates), its scope fitted around it.
///
/// `None` for empty geometry.
pub fn fitted(parent: &Shape, geometry: Geometry) -> Option<Shape> {
    let (low, high) = local_bounds(&geometry)?;
    Some(boxed(parent, geometry, low, high - low))
}

/// A child of `parent` with the given geometry and box, both in the parent's coordinates.
#[inline]
pub fn boxed(parent: &Shape, geometry: Geometry, origin: DVec3, size: DVec3) -> Shape {
    child(parent, Scope { frame: parent.scope.frame.moved(origin), size }, rebased(geometry, origin))
}

/// A child of `parent` in a scope of its own.
#[inline]
fn child(parent: &Shape, scope: Scope, geometry: Geometry) -> Shape {
    let (attributes, style) = (parent.attributes.clone(), parent.style.clone());
    Shape { scope, geometry, attributes, style, ordinals: parent.ordinals, seed: parent.seed }
}

/// Gives a shape another geometry, in its present coordinates, and fits its scope around it.
///
/// Where the geometry is empty so is the shape, and its scope stays.
pub fn refit(shape: &mut Shape, geometry: Geometry) {
    let Some((low, high)) = local_bounds(&geometry) else {
        shape.geometry = Geometry::Empty;
        return;
    };
    shape.scope = Scope { frame: shape.scope.frame.moved(low), size: high - low };
    shape.geometry = rebased(geometry, low);
}

/// A child of `parent` with a region of one of its planes, x along a direction of that plane.
///
/// On the ground y stays up and z points right of x; on other planes z is the plane's normal. `None` without area.
pub fn aligned(parent: &Shape, plane: &Plane, area: &Area, along: DVec2) -> Option<Shape> {
    let along = along.try_normalize()?;
    let turned: Area =
        area.polygons().iter().map(|p| p.mapped(|q| DVec2::new(along.dot(q), along.perp_dot(q)))).collect();
    let (u, v) = plane.axes();
    let (x, across) = (u * along.x + v * along.y, v * along.x - u * along.y);
    let normal = plane.normal();
    let (rotation, plane_kind) = match plane {
        Plane::Ground => (DMat3::from_cols(x, normal, -across), Plane::Ground),
        _ => (DMat3::from_cols(x, across, normal), Plane::Face),
    };
    let frame = parent.scope.frame.moved(plane.at(DVec2::ZERO)).turned(DQuat::from_mat3(&rotation));
    let mut shape = child(parent, Scope { frame, size: DVec3::ZERO }, Geometry::Empty);
    refit(&mut shape, Geometry::Flat(plane_kind, turned));
    (shape.geometry != Geometry::Empty).then_some(shape)
}

/// A point of `parent`, at a place in its coordinates, with the parent's turn.
pub fn point(parent: &Shape, at: DVec3) -> Shape {
    boxed(parent, Geometry::Point, at, DVec3::ZERO)
}

/// The least and greatest coordinates of a geometry; `None` where it is empty.
#[inline]
pub fn local_bounds(geometry: &Geometry) -> Option<(DVec3, DVec3)> {
    match geometry {
        Geometry::Empty | Geometry::Element(_) => None,
        Geometry::Point => Some((DVec3::ZERO, DVec3::ZERO)),
        Geometry::Path(points) => around(points.iter().copied()),
        Geometry::Flat(plane, area) => plane_bounds(plane, area),
        Geometry::Prism(plane, area, height) => {
            let (low, high) = plane_bounds(plane, area)?;
            let sweep = plane.normal() * *height;
            Some((low.min(low + sweep), high.max(high + sweep)))
        }
        Geometry::Mesh(mesh) => around(mesh.positions.iter().copied()),
    }
}

#[inline]
fn plane_bounds(plane: &Plane, area: &Area) -> Option<(DVec3, DVec3)> {
    if area.is_empty() {
        return None;
    }
    let bounds = area.bounds();
    match plane {
        Plane::Ground => {
            Some((DVec3::new(bounds.min.x, 0.0, -bounds.max.y), DVec3::new(bounds.max.x, 0.0, -bounds.min.y)))
        }
        Plane::Face => Some((bounds.min.extend(0.0), bounds.max.extend(0.0))),
        Plane::Free(_) => around(area.edges().map(|(a, _)| plane.at(a))),
    }
}

fn around(points: impl Iterator<Item = DVec3>) -> Option<(DVec3, DVec3)> {
    points.fold(None, |bounds, p| match bounds {
        None => Some((p, p)),
        Some((low, high)) => Some((low.min(p), high.max(p))),
    })
}

/// The geometry as seen from an origin moved by `offset`.
#[inline]
fn rebased(geometry: Geometry, offset: DVec3) -> Geometry {
    if offset == DVec3::ZERO {
        return geometry;
    }
    match geometry {
        Geometry::Empty | Geometry::Point | Geometry::Element(_) => geometry,
        Geometry::Path(points) => Geometry::Path(points.iter().map(|p| *p - offset).collect()),
        Geometry::Flat(plane, area) => {
            let (plane, area) = moved(plane, area, offset);
            Geometry::Flat(plane, area)
        }
        Geometry::Prism(plane, area, height) => {
            let (plane, area) = moved(plane, area, offset);
            Geometry::Prism(plane, area, height)
        }
        Geometry::Mesh(mesh) => {
            let mut mesh = (*mesh).clone();
            mesh.positions.iter_mut().for_each(|p| *p -= offset);
            Geometry::Mesh(Arc::new(mesh))
        }
    }
}

/// Ground and face planes keep their kind where the offset lies in them.
#[inline]
fn moved(plane: Plane, area: Area, offset: DVec3) -> (Plane, Area) {
    let across = offset.dot(plane.normal());
    match plane {
        Plane::Ground if across == 0.0 => (plane, area.into_translated(DVec2::new(-offset.x, offset.z))),
        Plane::Face if across == 0.0 => (plane, area.into_translated(-offset.truncate())),
        _ => {
            let (u, v) = plane.axes();
            (Plane::Free(Arc::new([plane.at(DVec2::ZERO) - offset, u, v])), area)
        }
    }
}
