//! `equidistant`: places along the medial axis.

use crate::geometry::{MedialAxis, Pruning};
use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::{not_negative, strategy};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement;
use crate::shape::Shape;
use crate::unit::{Degrees, Metres};

strategy! {
    /// Sets points along the medial axis of the shape, equally far apart, centred on each branch.
    ///
    /// Niese et al. 2022, §5.2: equidistant (E). The axis is what is farthest from the edges: the middle line of a
    /// strip, a loop around a hole. x runs along it, and `place.cluster` says which branch.
    /// ```cga
    /// Lot    --> split(z) { ~1 : Lawn | 9 : Median | ~1 : Lawn }
    /// Median --> equidistant(spacing = 8) { plant("plane") } Gravel
    /// ```
    "equidistant" => pub struct Equidistant {
        /// From point to point along the axis (δ), metres.
        spacing: Varying<Metres> [0.0, 10.0],
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Option<Varying<Metres>> [1.0, 10.0] = None => "spacing / 2",
        /// A branch that ends blindly is left out where it is shorter than so many times the distance from the edges at
        /// its start.
        prune: f64 = 1.5 => "1.5",
        /// The axis runs into corners that are sharper than this.
        corner: Degrees = Degrees(30.0) => "30",
    }
}

impl Apply for Equidistant {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (shared, ground) = (self.shared(), Ground::of(shape)?);
        let pruning =
            Pruning { branch: not_negative("prune", self.prune)?, corner: not_negative("corner", self.corner.0)? };
        let spacing = given.field("spacing", self.spacing.0.0);
        let radii = shared.radii_or(given, self.radius, &spacing)?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let axis = MedialAxis::new(&ground.area, pruning);
        let placed = placement::equidistant(&site, &axis, &spacing, &radii, &shared.amount(given)?, given.seed);
        shared.pieces(&ground, shape, given, &radii, placed)
    }
}
