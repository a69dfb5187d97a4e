//! `semirandom`: places at random, each clear of the others.

use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::strategy;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement;
use crate::shape::Shape;
use crate::unit::Metres;

strategy! {
    /// Sets points at random, none nearer to another than their radii together, until no place is left.
    ///
    /// Niese et al. 2022, §5.2: semi-random (R). Each child is a point with `place.radius`. The shape itself stays:
    /// `NIL` after the block removes it.
    /// ```cga
    /// Lot --> semirandom(radius = 2.6, radius_sd = 0.7, density = 0.6) { plant("lime") } Lawn
    /// ```
    "semirandom" => pub struct SemiRandom {
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Varying<Metres> [1.0, 10.0],
    }
}

impl Apply for SemiRandom {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (shared, ground) = (self.shared(), Ground::of(shape)?);
        let radii = shared.radii(given.field("radius", self.radius.0.0))?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let placed = placement::semirandom(&site, &radii, &shared.amount(given)?, given.seed);
        shared.pieces(&ground, shape, given, &radii, placed)
    }
}
