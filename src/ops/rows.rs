//! `rows` and `quincunx`: places in parallel rows.

use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::{Shared, strategy};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement::{self, Field, Rows};
use crate::shape::Shape;
use crate::unit::{Degrees, Metres, Share};
use glam::DVec2;

strategy! {
    /// Sets points in parallel rows that lie in the middle of the shape.
    ///
    /// Concavities and holes cut rows without moving a point. x runs along the rows, and `place.cluster` says which.
    /// ```cga
    /// Orchard --> rows(spacing = 5, distance = 8, inset = 3) { plant("cherry") } Meadow
    /// ```
    "rows" => pub struct ParallelRows {
        /// From point to point in a row, metres.
        spacing: Metres,
        /// From row to row, metres.
        distance: Option<Metres> = None => "spacing",
        /// How far points stay from the edges, metres.
        inset: Metres = Metres(0.0) => "0",
        /// By which share of the spacing each second row is shifted.
        stagger: Share [0.0, 1.0] = Share(0.0) => "0",
        /// Turn of the rows against the scope's x.
        orientation: Degrees = Degrees(0.0) => "0",
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Option<Varying<Metres>> [1.0, 10.0] = None => "half the least distance",
    }
}

strategy! {
    /// Sets points in a quincunx: every point in the middle of six others, all equally far away.
    ///
    /// The pattern of formal groves and squares; `distance` between the rows makes it narrower or wider.
    /// ```cga
    /// Grove --> quincunx(spacing = 6, inset = 3) { plant("lime") } Gravel
    /// ```
    "quincunx" => pub struct Quincunx {
        /// From point to point in a row, metres.
        spacing: Metres,
        /// From row to row, metres.
        distance: Option<Metres> = None => "0.866 spacing",
        /// How far points stay from the edges, metres.
        inset: Metres = Metres(0.0) => "0",
        /// Turn of the rows against the scope's x.
        orientation: Degrees = Degrees(0.0) => "0",
        /// Mean radius that a plant keeps for itself (μ), metres.
        radius: Option<Varying<Metres>> [1.0, 10.0] = None => "half the least distance",
    }
}

impl Apply for ParallelRows {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let distance = self.distance.map_or(self.spacing.0, |distance| distance.0);
        let rows = Rows { spacing: self.spacing.0, distance, inset: self.inset.0, stagger: self.stagger.0 };
        plant(&self.shared(), &rows, self.orientation, self.radius, shape, given)
    }
}

impl Apply for Quincunx {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let usual = Rows::quincunx(self.spacing.0, self.inset.0);
        let rows = Rows { distance: self.distance.map_or(usual.distance, |distance| distance.0), ..usual };
        plant(&self.shared(), &rows, self.orientation, self.radius, shape, given)
    }
}

fn plant(
    shared: &Shared,
    rows: &Rows,
    orientation: Degrees,
    radius: Option<Varying<Metres>>,
    shape: &Shape,
    given: &Given,
) -> Result<Pieces, Problem> {
    let ground = Ground::of(shape)?;
    let radii = shared.radii_or(given, radius, &Field::Constant(rows.apart()))?;
    let site = shared.site(&ground, shape, given, &radii)?;
    let (sin, cos) = libm::sincos(orientation.radians());
    let direction = DVec2::new(cos, sin).rotate(ground.along());
    let placed = placement::rows(&site, direction, rows, &radii, &shared.amount(given)?, given.seed);
    shared.pieces(&ground, shape, given, &radii, placed)
}
