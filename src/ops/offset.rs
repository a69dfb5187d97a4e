//! `offset`: moves the whole outline of a flat shape.

use crate::geometry::{self, Area};
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Geometry, Shape};
use crate::unit::Metres;

operation! {
    /// Moves the outline of a flat shape or prism by a distance, outwards where it is positive, with mitred corners.
    ///
    /// `inside` keeps the moved shape, `border` the band between the old outline and the new one, `all` both: then
    /// `comp` finds them under `inside` and `border`. What vanishes is deleted.
    /// ```cga
    /// Lot --> offset(-5) comp(f) { inside : Lawn | border : Bed }
    /// ```
    "offset" (CityEngine, None) => pub struct Offset {
        /// How far (metres), negative inwards.
        distance: Metres,
        /// What is kept.
        selector: Keep = Keep::All => "all",
    }
}

choice! {
    /// What an offset keeps.
    pub enum Keep {
        /// The moved shape and the band.
        All = "all",
        /// The moved shape.
        Inside = "inside",
        /// The band.
        Border = "border",
    }
}

impl Apply for Offset {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let distance = self.distance.0;
        if !distance.is_finite() {
            return Err(Problem::new(format!("an offset of {distance} m cannot be done")));
        }
        let geometry = match std::mem::replace(&mut shape.geometry, Geometry::Empty) {
            Geometry::Flat(plane, area) => Geometry::Flat(plane, self.moved(area)),
            Geometry::Prism(plane, area, height) => Geometry::Prism(plane, self.moved(area), height),
            _ => return Err(Problem::new("`offset` takes flat shapes and prisms")),
        };
        fit::refit(shape, geometry);
        Ok(Pieces::left_of(shape))
    }
}

impl Offset {
    fn moved(&self, area: Area) -> Area {
        if self.selector == Keep::Inside {
            return geometry::into_offset(area, self.distance.0);
        }
        let moved = geometry::offset(&area, self.distance.0);
        let (kept, outer) = if self.distance.0 < 0.0 { (&moved, &area) } else { (&area, &moved) };
        let band = geometry::difference(outer, kept);
        match self.selector {
            Keep::All => kept.polygons().iter().chain(band.polygons()).cloned().collect(),
            _ => band,
        }
    }
}
