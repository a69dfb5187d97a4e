//! `single`: one place at random.

use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::strategy::strategy;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::placement;
use crate::shape::Shape;
use crate::unit::Metres;

strategy! {
    /// Sets one point anywhere where a plant may stand.
    ///
    /// Niese et al. 2022, §5.2: single (S).
    /// ```cga
    /// Lot --> setback(6) { all = Gravel | remainder : single(radius = 6) { plant("oak") } Lawn }
    /// ```
    "single" => pub struct Single {
        /// Mean radius that the plant keeps for itself (μ), metres.
        radius: Varying<Metres> [1.0, 10.0],
    }
}

impl Apply for Single {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (shared, ground) = (self.shared(), Ground::of(shape)?);
        if shared.count.is_some() || shared.per_area.is_some() {
            let parameter = if shared.count.is_some() { "count" } else { "per_area" };
            let problem = Problem::new("`single` places one plant").hint("`semirandom` places more");
            return Err(Problem { parameter: Some(parameter), ..problem });
        }
        let radii = shared.radii(given.field("radius", self.radius.0.0))?;
        let site = shared.site(&ground, shape, given, &radii)?;
        let placed = placement::single(&site, &radii, &shared.amount(given)?, given.seed);
        shared.pieces(&ground, shape, given, &radii, placed)
    }
}
