//! `regular`: places in the cells of a lattice.

use crate::geometry::Bounds;
use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::strategy;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement::{self, Field, Lattice};
use crate::shape::Shape;
use crate::unit::{Degrees, Metres, Share};
use glam::DVec2;

strategy! {
    /// Sets a point in each cell of a lattice that is aligned with the scope, in its middle or near to it.
    ///
    /// Niese et al. 2022, §5.2: regular (I). x runs along the rows, and `place.cluster` says which row.
    /// ```cga
    /// Orchard --> regular(cell = 6, jitter = 0.3) { plant("apple") } Meadow
    /// ```
    "regular" => pub struct Regular {
        /// Side of a cell (ω), metres.
        cell: Metres [5.0, 50.0],
        /// Turn of the lattice against the scope (η).
        orientation: Degrees [0.0, 180.0] = Degrees(0.0) => "0",
        /// How far points leave the middles of their cells (ψ): 0 not at all, 1 anywhere in the cell.
        jitter: Share [0.0, 1.0] = Share(0.0) => "0",
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Option<Varying<Metres>> [1.0, 10.0] = None => "cell / 2",
    }
}

impl Apply for Regular {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (shared, ground) = (self.shared(), Ground::of(shape)?);
        let radii = shared.radii_or(given, self.radius, &Field::Constant(self.cell.0))?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let direction = ground.along();
        let own = |p: DVec2| DVec2::new(direction.dot(p), direction.perp_dot(p));
        let lattice = Lattice {
            origin: DVec2::ZERO,
            direction,
            bounds: Bounds::of(ground.area.edges().map(|(corner, _)| own(corner))),
            cell: self.cell.0,
            orientation: self.orientation.0,
            jitter: self.jitter.0,
        };
        let placed = placement::regular(&site, &lattice, &radii, &shared.amount(given)?, given.seed);
        shared.pieces(&ground, shape, given, &radii, placed)
    }
}
