//! `alignScopeToAxes`: turns a scope to the world's or the object's axes without moving the geometry.

use crate::geometry::Area;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Frame, Geometry, Plane, Scope, Shape};
use glam::{DAffine3, DQuat, DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// Turns the scope to other axes and fits it again; the geometry stays where it is.
    ///
    /// `y` levels the scope: its y points up, its x stays as near as it can. `world.xyz` takes the world's axes,
    /// `object.xyz` those of the initial shape; a single letter after the dot turns only that axis.
    /// ```cga
    /// Lot  --> s(28, 0, 18) center(xz) r(scopeCenter, 0, 25, 0) Both
    /// Both --> split(x) { ~1 : Half | 1 : NIL | ~1 : alignScopeToAxes(world.xyz) Half }
    /// Half --> split(z) { ~3 : Lawn | 1 : Gravel }*
    /// ```
    "alignScopeToAxes" (CityEngine, None) => pub struct AlignScopeToAxes {
        /// Which axes.
        axes: To = To::WorldXyz => "world.xyz",
    }
}

choice! {
    /// The axes a scope is turned to.
    pub enum To {
        /// x along the world's.
        X = "x",
        /// y up.
        Y = "y",
        /// z along the world's.
        Z = "z",
        /// x along the world's.
        WorldX = "world.x",
        /// y up.
        WorldY = "world.y",
        /// z along the world's.
        WorldZ = "world.z",
        /// The world's axes.
        WorldXyz = "world.xyz",
        /// x along the initial shape's.
        ObjectX = "object.x",
        /// y along the initial shape's.
        ObjectY = "object.y",
        /// z along the initial shape's.
        ObjectZ = "object.z",
        /// The initial shape's axes.
        ObjectXyz = "object.xyz",
    }
}

impl Apply for AlignScopeToAxes {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let old = shape.scope.frame.rotation;
        let object = shape.style.object;
        let rotation = match self.axes {
            To::WorldXyz => DQuat::IDENTITY,
            To::ObjectXyz => object,
            To::X | To::WorldX => brought(old, DVec3::X, DVec3::X),
            To::Y | To::WorldY => brought(old, DVec3::Y, DVec3::Y),
            To::Z | To::WorldZ => brought(old, DVec3::Z, DVec3::Z),
            To::ObjectX => brought(old, DVec3::X, object * DVec3::X),
            To::ObjectY => brought(old, DVec3::Y, object * DVec3::Y),
            To::ObjectZ => brought(old, DVec3::Z, object * DVec3::Z),
        };
        turn(shape, rotation);
        Ok(Pieces::Changed)
    }
}

/// The rotation turned by as little as brings a local axis to a world direction.
fn brought(rotation: DQuat, axis: DVec3, to: DVec3) -> DQuat {
    (DQuat::from_rotation_arc(rotation * axis, to) * rotation).normalize()
}

/// Turns the scope and fits it again.
pub(super) fn turn(shape: &mut Shape, rotation: DQuat) {
    let local = rotation.inverse() * shape.scope.frame.rotation;
    let geometry = match &shape.geometry {
        Geometry::Element(_) => return,
        Geometry::Empty | Geometry::Point => shape.geometry.clone(),
        Geometry::Path(points) => Geometry::Path(points.iter().map(|p| local * *p).collect()),
        Geometry::Flat(plane, area) => {
            let (plane, area) = on(plane, area, local);
            Geometry::Flat(plane, area)
        }
        Geometry::Prism(plane, area, height) => {
            let (plane, area) = on(plane, area, local);
            Geometry::Prism(plane, area, *height)
        }
        Geometry::Mesh(mesh) => Geometry::Mesh(Arc::new(mesh.transformed(&DAffine3::from_quat(local)))),
    };
    shape.scope = Scope { frame: Frame { origin: shape.scope.frame.origin, rotation }, size: DVec3::ZERO };
    fit::refit(shape, geometry);
}

/// A plane after a turn: the ground stays the ground where it is level.
fn on(plane: &Plane, area: &Area, turn: DQuat) -> (Plane, Area) {
    let (u, v) = plane.axes();
    let (origin, u, v) = (turn * plane.at(DVec2::ZERO), turn * u, turn * v);
    let ground = u.cross(v).y > 1.0 - 1e-12 && origin.y.abs() < 1e-9;
    if !ground {
        return (Plane::Free(Arc::new([origin, u, v])), area.clone());
    }
    let flat = |p: DVec3| DVec2::new(p.x, -p.z);
    let (at, u, v) = (flat(origin), flat(u), flat(v));
    (Plane::Ground, area.polygons().iter().map(|polygon| polygon.mapped(|p| at + u * p.x + v * p.y)).collect())
}
