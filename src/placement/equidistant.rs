//! Plants at equal distances along the medial axis.
//!
//! Niese et al. 2022, §5.3, equidistant (δ): a row down the middle of a strip, a ring around a house.

use crate::geometry::{Branch, MedialAxis, Path};
use crate::placement::places::{Places, few_enough};
use crate::placement::walk::{Walk, check_spacing};
use crate::placement::{Amount, Field, Placed, PlacementError, Radii, Site};
use crate::seed::Seed;
use glam::DVec2;

/// Shorter than a whole step by less than this share of one still counts as whole.
const SLACK: f64 = 1e-9;

/// Places along an axis, `spacing` metres (δ) apart along it.
///
/// On each branch as many as there are whole steps, with equal rests of half a step or more at both ends, so that the
/// steps go on through junctions; at least one on each branch, and on a loop equally far apart all round. Where
/// branches meet so sharply that a place would be nearer than the spacing to one on another branch, the longer branch
/// keeps its own. The cluster of a spot is its branch.
pub fn equidistant(
    site: &Site,
    axis: &MedialAxis,
    spacing: &Field,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    check_spacing(spacing)?;
    let mut places = Places::new(site, radii, amount, [spacing.least(), spacing.most()], seed)?;
    few_enough(axis.length() / spacing.least())?;
    let mut order: Vec<(f64, usize)> = axis.branches().iter().map(Branch::length).zip(0..).collect();
    order.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    for (_, index) in order {
        let branch = &axis.branches()[index];
        let run = stops(branch, spacing)?;
        places.take_run(&run, branch.is_closed(), index as u32, |p| spacing.at(p) * (1.0 - SLACK));
    }
    places.finish(amount)
}

/// The places of one branch.
fn stops(branch: &Branch, spacing: &Field) -> Result<Vec<(DVec2, DVec2)>, PlacementError> {
    let Some(path) = Path::new(&branch.points) else {
        return Ok(branch.points.first().map(|p| (*p, DVec2::X)).into_iter().collect());
    };
    let walk = Walk::new(path, spacing)?;
    let count = (walk.steps() + SLACK).floor().max(1.0);
    let step = if branch.is_closed() || count > walk.steps() { walk.steps() / count } else { 1.0 };
    let rest = 0.5 * (walk.steps() - count * step);
    Ok((0..count as usize).map(|i| walk.at(rest + (i as f64 + 0.5) * step)).collect())
}
