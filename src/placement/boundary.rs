//! Plants in a band along the edges of an area: the boundary strategy.
//!
//! Niese et al. 2022, §5.2 and §5.3; the width is its β.

use crate::geometry::{Area, difference, inset};
use crate::placement::poisson::Ground;
use crate::placement::semirandom::{place, turn};
use crate::placement::{Amount, Placed, PlacementError, Radii, Site};
use crate::seed::Seed;

/// Plants at random, their centres inside `rim` and no farther than `width` metres from its edges.
///
/// Each is turned along the nearest edge of `rim`. Otherwise as [`semirandom`](crate::placement::semirandom); the active area
/// is the part of the site in the band.
pub fn boundary(
    site: &Site,
    rim: &Area,
    width: f64,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    if !(width.is_finite() && width >= 0.0) {
        let allowed = "a number of metres from 0 up";
        return Err(PlacementError::Value { parameter: "width", found: width, allowed });
    }
    let active = difference(site.area(), &inset(rim, width));
    if width == 0.0 {
        // A line has no place for a dart, however long one looks for it.
        radii.check()?;
        amount.check()?;
        return Ok(Placed { spots: Vec::new(), missing: amount.wanted(&active)?.unwrap_or(0) });
    }
    let mut placed = place(&Ground::of(site).along(rim, width), &active, radii, amount, seed)?;
    turn(&mut placed.spots, rim);
    Ok(placed)
}
