//! One plant anywhere: the single strategy.
//!
//! Niese et al. 2022, §5.2.

use crate::placement::poisson::{Ground, fill};
use crate::placement::semirandom::{spot, turn};
use crate::placement::{Amount, Placed, PlacementError, Radii, Site, Spot};
use crate::seed::Seed;

/// One plant, everywhere it may stand with equal probability, turned along the nearest edge; missing where it has no
/// place.
///
/// The count of `amount` is not asked for, and its density is the probability that the plant is kept.
pub fn single(site: &Site, radii: &Radii, amount: &Amount, seed: Seed) -> Result<Placed, PlacementError> {
    amount.check()?;
    let found = fill(&Ground::of(site), radii, Some(1), seed)?;
    let mut spots: Vec<Spot> = found.iter().map(spot).collect();
    let missing = 1 - spots.len();
    spots.retain(|spot| seed.draw("density").unit() < amount.density.at(spot.position));
    turn(&mut spots, site.area());
    Ok(Placed { spots, missing })
}
