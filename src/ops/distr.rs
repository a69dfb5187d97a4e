//! `Distr`: the papers' points by density.

use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, points};
use crate::placement;
use crate::shape::Shape;
use crate::unit::PerArea;

operation! {
    /// Sets points on the shape by density: evenly where the deviation is 0, else Gaussian about its middle.
    ///
    /// Ulmer et al. 2007, §2.2. Each child is a point; `place.index` and `place.total` count them. The shape itself
    /// stays: `NIL` after the block removes it.
    /// ```cga
    /// Grove --> Distr(0.02, 0) { I(birch, medium, rand(7)) } Meadow
    /// ```
    "Distr" (Added, Body) => pub struct Distr {
        /// Points per square metre: the number is the area times this, rounded.
        density: PerArea,
        /// 0 spreads evenly; else the standard deviation as a share of half the shape's extent.
        deviation: f64 = 0.0 => "0",
    }
}

impl Apply for Distr {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (plane, area, lift) = points::surface(shape)?;
        let count = placement::count_at(&area, self.density.0).map_err(|e| Problem::new(e.to_string()))?;
        if count > given.most {
            return Err(Problem::new(format!("{count} points are more than the limit `children` of {}", given.most)));
        }
        let found = placement::distributed(&area, self.density.0, self.deviation, given.seed);
        let found = found.map_err(|e| Problem::new(e.to_string()))?;
        Ok(points::children(shape, &plane, lift, &found.points))
    }
}
