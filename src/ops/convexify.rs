//! `convexify`: splits concave outlines into convex ones.

use crate::geometry::{self, Area};
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Geometry, Shape};
use crate::unit::Metres;

operation! {
    /// Splits concave parts of a flat shape or prism into convex ones.
    ///
    /// The shape stays one, of several faces: `comp(f)` takes them. Cuts prolong edges at inner corners, the shortest
    /// first, so an L becomes two rectangles.
    /// ```cga
    /// Lot --> shapeL(12, 10) { shape : convexify() comp(f) { 0 : Bed | all : Lawn } | remainder : Gravel }
    /// ```
    "convexify" (CityEngine, None) => pub struct Convexify {
        /// How long a cut may be (metres); where a longer one is needed the part stays concave.
        max_length: Metres = Metres(f64::INFINITY) => "any",
    }
}

impl Apply for Convexify {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let parts = |area: &Area| -> Area {
            let parts = area.polygons().iter().map(|polygon| geometry::convexify(polygon, self.max_length.0));
            parts.flat_map(Area::into_polygons).collect()
        };
        let geometry = match &shape.geometry {
            Geometry::Flat(plane, area) => Geometry::Flat(plane.clone(), parts(area)),
            Geometry::Prism(plane, area, height) => Geometry::Prism(plane.clone(), parts(area), *height),
            Geometry::Mesh(_) | Geometry::Element(_) => {
                return Err(Problem::new("`convexify` takes flat shapes and prisms").hint("`comp(f)` takes a face"));
            }
            Geometry::Empty | Geometry::Point | Geometry::Path(_) => return Ok(Pieces::Changed),
        };
        shape.geometry = geometry;
        Ok(Pieces::Changed)
    }
}
