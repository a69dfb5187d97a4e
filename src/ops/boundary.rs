//! `boundary`: places in a band along the edge.

use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::{not_negative, strategy};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement;
use crate::shape::Shape;
use crate::unit::Metres;

strategy! {
    /// Sets points in a band along the edge of the shape, holes included, each clear of the others.
    ///
    /// Niese et al. 2022, §5.2: boundary (B). The band is measured by true distance, so it is as wide at corners as
    /// elsewhere.
    /// ```cga
    /// Lot --> boundary(width = 5, radius = 2.2, radius_sd = 0.4, density = 0.9) { plant("hornbeam") } Lawn
    /// ```
    "boundary" => pub struct Boundary {
        /// Width of the band from the edge inwards (β), metres.
        width: Metres [0.0, 5.0],
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Varying<Metres> [1.0, 10.0],
    }
}

impl Apply for Boundary {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (shared, ground) = (self.shared(), Ground::of(shape)?);
        let width = not_negative("width", self.width.0)?;
        let radii = shared.radii(given.field("radius", self.radius.0.0))?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let amount = shared.amount(given)?;
        let placed = placement::boundary(&site, &ground.area, width, &radii, &amount, given.seed);
        shared.pieces(&ground, shape, given, &radii, placed)
    }
}
