//! `center`: moves a shape into the middle of the one it came from.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Axis, Shape};

operation! {
    /// Moves the shape so that the middle of its scope is the middle of the scope that the rule, bracket or part
    /// began with, along the given axes.
    /// ```cga
    /// Lot --> [ Lawn ] [ s('1, 0, 6) center(z) Gravel ] s(12, 0, 12) center(xz) primitiveDisk(48) Water
    /// ```
    "center" (CityEngine, None) => pub struct Center {
        /// Along which axes.
        axes: Axes,
    }
}

choice! {
    /// A choice of axes.
    pub enum Axes {
        /// x
        X = "x",
        /// y
        Y = "y",
        /// z
        Z = "z",
        /// x and y
        Xy = "xy",
        /// x and z
        Xz = "xz",
        /// y and z
        Yz = "yz",
        /// All
        Xyz = "xyz",
    }
}

impl Axes {
    fn has(self, axis: Axis) -> bool {
        match axis {
            Axis::X => matches!(self, Axes::X | Axes::Xy | Axes::Xz | Axes::Xyz),
            Axis::Y => matches!(self, Axes::Y | Axes::Xy | Axes::Yz | Axes::Xyz),
            Axis::Z => matches!(self, Axes::Z | Axes::Xz | Axes::Yz | Axes::Xyz),
        }
    }
}

impl Apply for Center {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let around = given.around;
        let wanted = around.size * 0.5;
        let middle = around.frame.to_local(shape.scope.frame.to_world(shape.scope.size * 0.5));
        let mut offset = wanted - middle;
        for axis in [Axis::X, Axis::Y, Axis::Z].into_iter().filter(|axis| !self.axes.has(*axis)) {
            offset[axis.index()] = 0.0;
        }
        let before = shape.scope.frame;
        shape.scope.frame.origin += around.frame.rotation * offset;
        shape.followed(before);
        Ok(Pieces::Changed)
    }
}
