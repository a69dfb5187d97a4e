//! What the operations that set points on a shape share: the plane to work on, and the children.

use crate::geometry::Area;
use crate::ops::{Part, Pieces, Problem, fit};
use crate::shape::{Geometry, Place, Plane, Shape};
use glam::{DQuat, DVec2, DVec3};

/// The plane and region that points are set on: a flat shape itself, the top of a prism.
pub fn surface(shape: &Shape) -> Result<(Plane, Area, DVec3), Problem> {
    match &shape.geometry {
        Geometry::Flat(plane, area) => Ok((plane.clone(), area.clone(), DVec3::ZERO)),
        Geometry::Prism(plane, area, height) => Ok((plane.clone(), area.clone(), plane.normal() * height.max(0.0))),
        Geometry::Empty => Ok((Plane::Ground, Area::empty(), DVec3::ZERO)),
        _ => Err(Problem::new("points are set on flat shapes and prisms").hint("`comp(f)` takes a face")),
    }
}

/// Point shapes at places of a plane, y along its normal; the shape itself stays.
pub fn children(shape: &Shape, plane: &Plane, lift: DVec3, points: &[DVec2]) -> Pieces {
    let total = points.len() as u32;
    // On the ground nothing turns; on other planes the children's y follows the normal.
    let turn = match plane {
        Plane::Ground => DQuat::IDENTITY,
        _ => DQuat::from_rotation_arc(DVec3::Y, plane.normal()),
    };
    let parts = (0..).zip(points).map(|(index, point)| {
        let mut child = fit::point(shape, plane.at(*point) + lift);
        child.scope.frame = child.scope.frame.turned(turn);
        child.ordinals.place = Place { index, total, ..Place::default() };
        Part::new(0, child)
    });
    Pieces::Beside(parts.collect())
}
