//! `r`: turns a shape.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::unit::Degrees;
use glam::{DQuat, DVec3};

operation! {
    /// Turns the shape about the axes of its scope, through its origin or its centre; x first, then y, then z.
    ///
    /// The papers write `Rx(a)`, `Ry(a)`, `Rz(a)`.
    /// ```cga
    /// Statue --> r(scopeCenter, 0, 90, 0) I(statue, marble, 0)
    /// ```
    "r" (CityEngine, None) => pub struct Rotate {
        /// The point that stays.
        centre: About = About::Origin => "scopeOrigin",
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
        /// The origin of the scope.
        Origin = "scopeOrigin",
        /// The middle of the scope.
        Center = "scopeCenter",
    }
}

impl Apply for Rotate {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let angles = [self.x, self.y, self.z].map(Degrees::radians);
        if angles.iter().any(|a| !a.is_finite()) {
            return Err(Problem::new("an angle is not a number"));
        }
        let about = |axis: DVec3, angle: f64| {
            let (sin, cos) = libm::sincos(angle * 0.5);
            DQuat::from_xyzw(axis.x * sin, axis.y * sin, axis.z * sin, cos)
        };
        let turn = about(DVec3::X, angles[0]) * about(DVec3::Y, angles[1]) * about(DVec3::Z, angles[2]);
        let fixed = match self.centre {
            About::Origin => DVec3::ZERO,
            About::Center => shape.scope.size * 0.5,
        };
        shape.scope.frame = shape.scope.frame.moved(fixed - turn * fixed).turned(turn);
        Ok(Pieces::Changed)
    }
}
