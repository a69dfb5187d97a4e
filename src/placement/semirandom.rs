//! Plants all over an area, as near as their radii allow and in no order: the semi-random strategy.
//!
//! Niese et al. 2022, §5.2 and §5.3.

use crate::geometry::Area;
use crate::placement::poisson::{Ground, fill};
use crate::placement::ready::Rim;
use crate::placement::{Amount, Disk, Placed, PlacementError, Radii, Site, Spot};
use crate::seed::Seed;
use glam::DVec2;

/// Plants at random over the whole site, each with its own radius, none overlapping another, turned along the nearest
/// edge.
///
/// Saturated, no place is left where the least radius fits. Gaps that take small disks only are filled with small
/// disks, so that the mean of the radii stays below that of the distribution: for a mean of 2 m, a deviation of 0.5 m
/// and radii from 1 to 3 m it is 1.40 m. (Two or four strict darts for each place instead of one would make it 1.41 or
/// 1.42 m, and cost 7 or 29 % more time.) With a count the radii keep the distribution until room gets scarce.
/// An empty site gets nothing. Costs time in proportion to the area measured in least radii.
pub fn semirandom(site: &Site, radii: &Radii, amount: &Amount, seed: Seed) -> Result<Placed, PlacementError> {
    let mut placed = place(&Ground::of(site), site.area(), radii, amount, seed)?;
    turn(&mut placed.spots, site.area());
    Ok(placed)
}

/// Turns each spot along the edge of an area that is nearest to it.
pub(super) fn turn(spots: &mut [Spot], area: &Area) {
    let edges: Vec<_> = area.edges().collect();
    let rim = Rim::of(edges.iter().copied());
    for spot in spots {
        if let Some(near) = rim.nearest(spot.position) {
            let (a, b) = edges[near.edge];
            spot.direction = (b - a).normalize_or(spot.direction);
        }
    }
}

/// Fills a ground; a count for each m² is of the `active` area.
pub(super) fn place(
    ground: &Ground,
    active: &Area,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    amount.check()?;
    let wanted = amount.wanted(active)?;
    let disks = fill(ground, radii, wanted, seed)?;
    let missing = wanted.map_or(0, |wanted| wanted - disks.len());
    let mut spots: Vec<Spot> = disks.iter().map(spot).collect();
    amount.thin(&mut spots, seed);
    Ok(Placed { spots, missing })
}

/// A place that nobody has turned yet.
pub(super) fn spot(disk: &Disk) -> Spot {
    Spot { position: disk.position, radius: disk.radius, direction: DVec2::X, cluster: 0 }
}
