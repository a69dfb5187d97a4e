//! One plant anywhere: the single strategy.
//!
//! Niese et al. 2022, §5.2.

use crate::placement::poisson::{Ground, fill};
use crate::placement::{Amount, Disk, Placed, PlacementError, Radii, Site, Spot};
use crate::seed::Seed;
use glam::DVec2;

/// One plant, everywhere it may stand with equal probability; missing where it has no place.
///
/// The count of `amount` is not asked for, its density is: with a share below a half, the plant is given up.
pub fn single(site: &Site, radii: &Radii, amount: &Amount, seed: Seed) -> Result<Placed, PlacementError> {
    amount.check()?;
    let found = fill(&Ground::of(site), radii, Some(1), seed)?;
    let spot = |d: &Disk| Spot { position: d.position, radius: d.radius, direction: DVec2::X, cluster: 0 };
    let mut spots: Vec<Spot> = found.iter().map(spot).collect();
    let missing = 1 - spots.len();
    amount.thin(&mut spots, seed);
    Ok(Placed { spots, missing })
}
