//! `t`: moves a shape along its own axes.

use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::value::Size;
use glam::DVec3;

operation! {
    /// Moves the shape along the axes of its scope.
    ///
    /// The papers write `T(x, y, z)`.
    /// ```cga
    /// Lot --> [ Lawn ] [ t(4, 0, 4) Court ] t(22, 0, 14) Court
    /// Court --> s(14, 0, 12) Gravel
    /// ```
    "t" (CityEngine, None) => pub struct Translate {
        /// Along x: metres, or with `'` a share of the scope.
        x: Size,
        /// Along y: metres, or with `'` a share of the scope.
        y: Size,
        /// Along z: metres, or with `'` a share of the scope.
        z: Size,
    }
}

impl Apply for Translate {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let offset = lengths([self.x, self.y, self.z], shape.scope.size)?;
        let before = shape.scope.frame;
        shape.scope.frame = before.moved(offset);
        shape.followed(before);
        Ok(Pieces::Changed)
    }
}

/// Three sizes in metres, relative ones of the given box.
pub fn lengths(sizes: [Size; 3], of: DVec3) -> Result<DVec3, Problem> {
    let mut lengths = DVec3::ZERO;
    for (axis, size) in sizes.into_iter().enumerate() {
        lengths[axis] = match size {
            Size::Absolute(metres) => metres,
            Size::Relative(share) | Size::Floating(share) => share * of[axis],
        };
    }
    match lengths.is_finite() {
        true => Ok(lengths),
        false => Err(Problem::new(format!("({}, {}, {}) is not a place", lengths.x, lengths.y, lengths.z))),
    }
}
