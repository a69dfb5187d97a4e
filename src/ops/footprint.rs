//! `footprint`: a shape's outline on the ground of its scope.

use crate::geometry::{Area, Polygon};
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Geometry, Plane, Shape};
use glam::DVec2;

operation! {
    /// Replaces a shape by what it covers of the ground of its scope, flat at y = 0 and looking up.
    ///
    /// Overlapping parts become one. An inserted element leaves the rectangle of its scope. What covers nothing, as an
    /// upright face, is deleted.
    /// ```cga
    /// Lot  --> [ s(24, 8, 24) center(xz) primitiveCone(24) footprint() label("foot") Water ] Rest
    /// Rest --> without("foot") Lawn
    /// ```
    "footprint" (CityEngine, None) => pub struct Footprint {}
}

impl Apply for Footprint {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let covered = match &shape.geometry {
            Geometry::Empty | Geometry::Point | Geometry::Path(_) => Area::empty(),
            Geometry::Flat(Plane::Ground, area) | Geometry::Prism(Plane::Ground, area, _) => area.clone(),
            Geometry::Element(_) => {
                let size = shape.scope.size;
                Polygon::rectangle(DVec2::ZERO, DVec2::new(size.x, -size.z)).into_iter().collect()
            }
            _ => shape.local_mesh().unwrap_or_default().footprint(),
        };
        fit::refit(shape, Geometry::Flat(Plane::Ground, covered));
        Ok(Pieces::left_of(shape))
    }
}
