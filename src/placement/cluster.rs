//! Plants in disks around random centres: the cluster strategy.
//!
//! Niese et al. 2022, §5.2 and §5.3; the radius is its κ, the greatest number of clusters its π.

use crate::geometry::{Area, Polygon, intersection, union_all};
use crate::placement::poisson::{Ground, alone};
use crate::placement::ready::Rim;
use crate::placement::semirandom::{place, turn};
use crate::placement::{Amount, Placed, PlacementError, Radii, Site};
use crate::seed::Seed;
use glam::DVec2;

/// More clusters than this in one area are refused.
const MOST_CLUSTERS: usize = 10_000;
/// Sides of the polygon that stands for a disk where its area is asked for.
const SIDES: usize = 64;

/// Plants at random, their centres no farther than `radius` metres from one of a number of centres.
///
/// The number is drawn evenly from the least and the greatest in `clusters`; the centres are drawn evenly from where a
/// plant may stand, and may be near each other. A spot's `cluster` is the number of its nearest centre. Otherwise as
/// [`semirandom`](crate::placement::semirandom); the active area is the part of the site in the disks.
pub fn clusters(
    site: &Site,
    radius: f64,
    clusters: [usize; 2],
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    if !(radius.is_finite() && radius >= 0.0) {
        let allowed = "a number of metres from 0 up";
        return Err(PlacementError::Value { parameter: "cluster_radius", found: radius, allowed });
    }
    let count = draw_count(clusters, seed)?;
    let ground = Ground::of(site);
    let centres: Vec<DVec2> = alone(&ground, radii, count, seed.named("centres"))?.iter().map(|d| d.position).collect();
    let disks: Vec<Area> = centres.iter().filter_map(|c| Polygon::regular(*c, radius, SIDES)).map(Area::from).collect();
    let active = intersection(site.area(), &union_all(&disks));
    let mut placed = place(&ground.around(&centres, radius), &active, radii, amount, seed)?;
    turn(&mut placed.spots, site.area());
    let near = Rim::of(centres.iter().map(|centre| (*centre, *centre)));
    for spot in &mut placed.spots {
        spot.cluster = near.nearest(spot.position).map_or(0, |near| near.edge) as u32;
    }
    Ok(placed)
}

fn draw_count([least, most]: [usize; 2], seed: Seed) -> Result<usize, PlacementError> {
    if most > MOST_CLUSTERS || least > most {
        let allowed = "from the least number of clusters to 10000";
        return Err(PlacementError::Value { parameter: "clusters", found: most as f64, allowed });
    }
    Ok(least + seed.draw("clusters").below((most - least + 1) as u64) as usize)
}
