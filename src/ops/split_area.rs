//! `splitArea`: cuts a shape along an axis into parts of given areas.

use crate::geometry::Sweep;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::split::{self, Adjust, Interval};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Axis, Geometry, Plane, Shape};
use glam::{DVec2, DVec3};

operation! {
    /// Cuts a flat shape or prism along an axis of its scope into parts of given areas.
    ///
    /// As `split`, but sizes are areas: absolute (`200` m²), relative (`'0.3` of the shape's) or floating (`~3`, a
    /// weight in what is left). Of a prism the base is measured.
    /// ```cga
    /// Lot  --> s(36, 0, 28) center(xz) primitiveDisk(48) Four
    /// Four --> splitArea(x) { '0.25 : Lawn | '0.25 : Bed | '0.25 : Meadow | ~1 : Gravel }
    /// ```
    "splitArea" (CityEngine, Cuts) => pub struct SplitArea {
        /// The axis to cut along.
        axis: OfScope,
        /// `adjust` fits the parts' scopes to their geometry, `noAdjust` keeps the parent's extent across the axis.
        scope: Adjust = Adjust::Fitted => "adjust",
    }
}

choice! {
    /// An axis of the scope.
    pub enum OfScope {
        /// x
        X = "x",
        /// y
        Y = "y",
        /// z
        Z = "z",
    }
}

impl Apply for SplitArea {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (plane, area) = match &shape.geometry {
            Geometry::Flat(plane, area) | Geometry::Prism(plane, area, _) => (plane, area),
            _ => {
                return Err(Problem::new("`splitArea` takes flat shapes and prisms").hint("`split` cuts any by length"));
            }
        };
        let axis = [Axis::X, Axis::Y, Axis::Z][self.axis as usize];
        let (slope, start) = slope(plane, axis.direction());
        let steepness = slope.length();
        if steepness < 1e-9 {
            let message =
                format!("the shape has no extent along `{}` that could be shared", ["x", "y", "z"][axis.index()]);
            return Err(Problem::new(message).hint("it lies across that axis: another may be meant"));
        }
        let sweep = Sweep::new(area, slope / steepness);
        let mut intervals = split::intervals(given.cuts, sweep.area(), given.most)?;
        let place = |swept: f64| start + sweep.place(swept) * steepness;
        intervals.iter_mut().for_each(|i| *i = Interval { from: place(i.from), to: place(i.to), ..*i });
        split::parts(shape, axis, self.scope, &intervals)
    }
}

/// How an axis rises over a plane, and where the plane's origin stands on it.
fn slope(plane: &Plane, direction: DVec3) -> (DVec2, f64) {
    let (u, v) = plane.axes();
    (DVec2::new(direction.dot(u), direction.dot(v)), direction.dot(plane.at(DVec2::ZERO)))
}
