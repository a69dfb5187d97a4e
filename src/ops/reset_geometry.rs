//! `resetGeometry`: back to the outline that a derivation began with.

use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Frame, Geometry, Plane, Scope, Shape};
use glam::{DVec2, DVec3};

operation! {
    /// Gives the shape the geometry of the initial shape again, at the height where its scope begins.
    /// ```cga
    /// Lot  --> setback(8) { all = Gravel | remainder : [ resetGeometry() Ring ] Lawn }
    /// Ring --> setback(3) { all = Hedge }
    /// ```
    "resetGeometry" (CityEngine, None) => pub struct ResetGeometry {}
}

impl Apply for ResetGeometry {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (height, rotation) = (shape.scope.frame.origin.y, shape.style.object);
        let frame = Frame { origin: DVec3::new(0.0, height, 0.0), rotation };
        shape.scope = Scope { frame, size: DVec3::ZERO };
        // The outline lies on the plan, the geometry in the turned scope: both about the world's origin.
        let local = |p: DVec2| Plane::Ground.foot(frame.to_local(DVec3::new(p.x, height, -p.y)));
        let area = given.outline.polygons().iter().map(|polygon| polygon.mapped(local)).collect();
        fit::refit(shape, Geometry::Flat(Plane::Ground, area));
        Ok(Pieces::left_of(shape))
    }
}
