//! `r`: turns a shape.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::unit::Degrees;
use glam::{DQuat, DVec3};

operation! {
    /// Turns the shape about the axes of its scope, through its pivot, its origin or its centre; x first, then y, then
    /// z. The pivot is the origin unless `setPivot` moved it.
    ///
    /// The papers write `Rx(a)`, `Ry(a)`, `Rz(a)`.
    /// ```cga
    /// Lot --> [ Lawn ] s(20, 0, 12) center(xz) [ Bed ] r(scopeCenter, 0, 30, 0) Gravel
    /// ```
    "r" (CityEngine, None) => pub struct Rotate {
        /// The point that stays.
        centre: About = About::Pivot => "pivot",
        /// About x (degrees).
        x: Degrees,
        /// About y (degrees).
        y: Degrees,
        /// About z (degrees).
        z: Degrees,
    }
}

choice! {
    /// The point that a turn leaves where it is.
    pub enum About {
        /// The pivot.
        Pivot = "pivot",
        /// The origin of the scope.
        Origin = "scopeOrigin",
        /// The middle of the scope.
        Center = "scopeCenter",
    }
}

impl Apply for Rotate {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let turn = turn([self.x, self.y, self.z])?;
        let before = shape.scope.frame;
        let (fixed, turn) = match (self.centre, shape.attached().and_then(|surface| surface.pivot)) {
            (About::Center, _) => (shape.scope.size * 0.5, turn),
            (About::Pivot, Some(pivot)) => {
                let axes = before.rotation.inverse() * pivot.rotation;
                (before.to_local(pivot.origin), axes * turn * axes.inverse())
            }
            _ => (DVec3::ZERO, turn),
        };
        shape.scope.frame = before.moved(fixed - turn * fixed).turned(turn);
        shape.followed(before);
        Ok(Pieces::Changed)
    }
}

/// The turn by three angles: about x first, then y, then z.
pub(super) fn turn(angles: [Degrees; 3]) -> Result<DQuat, Problem> {
    let angles = angles.map(Degrees::radians);
    if angles.iter().any(|a| !a.is_finite()) {
        return Err(Problem::new("an angle is not a number"));
    }
    let about = |axis: DVec3, angle: f64| {
        let (sin, cos) = libm::sincos(angle * 0.5);
        DQuat::from_xyzw(axis.x * sin, axis.y * sin, axis.z * sin, cos)
    };
    Ok(about(DVec3::X, angles[0]) * about(DVec3::Y, angles[1]) * about(DVec3::Z, angles[2]))
}
