//! `rectify`: makes almost right angles right.

use crate::geometry;
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Geometry, Shape};
use crate::unit::Degrees;

operation! {
    /// Makes the almost right angles of a flat shape or prism right.
    ///
    /// Edges that run within the angle along or across the longest one turn about their middles until they run so
    /// exactly; others stay, and meet them where their lines do. A part that would cross itself stays as it was.
    /// ```cga
    /// Lot --> split(x) { ~1 : primitiveDisk(9) Lawn | ~1 : primitiveDisk(9) rectify(30) Lawn }
    /// ```
    "rectify" (CityEngine, None) => pub struct Rectify {
        /// How far from right an angle may be (degrees, up to 45).
        angle: Degrees,
    }
}

impl Apply for Rectify {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let angle = self.angle.0;
        if !(0.0..=45.0).contains(&angle) {
            let message = format!("angles within {angle}° of right ones cannot be told");
            return Err(Problem::new(message).hint("the angle is 0 to 45 degrees"));
        }
        let straight = |area| geometry::rectified(area, angle.to_radians());
        let geometry = match &shape.geometry {
            Geometry::Flat(plane, area) => Geometry::Flat(plane.clone(), straight(area)),
            Geometry::Prism(plane, area, height) => Geometry::Prism(plane.clone(), straight(area), *height),
            Geometry::Empty => return Ok(Pieces::Changed),
            _ => return Err(Problem::new("`rectify` takes flat shapes and prisms").hint("`comp(f)` takes a face")),
        };
        fit::refit(shape, geometry);
        Ok(Pieces::left_of(shape))
    }
}
