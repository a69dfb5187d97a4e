//! `Distr(density, deviation)` of Ulmer et al. 2007, §2.2: points by density, spread evenly where the deviation is 0,
//! and gathered around the middle otherwise.

use crate::geometry::{Area, relax};
use crate::placement::scatter::{Tiles, within};
use crate::placement::{PlacementError, Scatter, count_at, gaussian};
use crate::seed::Seed;
use glam::DVec2;

/// Rounds of relaxation: enough that distances to the nearest neighbour vary by little, few enough that no lattice
/// forms.
const ROUNDS: usize = 6;

/// Points at a density (per m²) and a deviation.
///
/// With a deviation of 0 as [`homogeneous`]. Otherwise normally distributed around the centroid with a standard
/// deviation of `deviation` times half the area's width and half its height: at 1 most of the area is reached, at 0.3
/// the points gather in its middle.
pub fn distributed(area: &Area, per_area: f64, deviation: f64, seed: Seed) -> Result<Scatter, PlacementError> {
    if !deviation.is_finite() || deviation < 0.0 {
        return Err(PlacementError::Deviation(deviation));
    }
    if deviation == 0.0 {
        return Ok(Scatter { points: homogeneous(area, per_area, seed)?, missing: 0 });
    }
    let count = count_at(area, per_area)?;
    let centre = area.centroid().unwrap_or_default();
    gaussian(area, count, centre, area.bounds().size() * (0.5 * deviation), seed)
}

/// As many points as the density (per m²) means, spread evenly: neighbours are about equally far apart.
///
/// Costs n log n.
pub fn homogeneous(area: &Area, per_area: f64, seed: Seed) -> Result<Vec<DVec2>, PlacementError> {
    let count = count_at(area, per_area)?;
    Ok(relax(&stratified(area, count, seed), area, ROUNDS))
}

/// One point in each of `count` pieces of equal area, all small and compact.
fn stratified(area: &Area, count: usize, seed: Seed) -> Vec<DVec2> {
    let tiles = Tiles::of(area);
    let shift = seed.draw("strata").unit();
    // How many points lie before a place of the measure: all of them before its end, as the shift is below 1.
    let rank = |measure: f64| (measure / tiles.total() * count as f64 - shift).ceil() as usize;
    let mut points = Vec::with_capacity(count);
    for (triangle, [from, to]) in tiles.stretches() {
        strew(triangle, rank(from), rank(to), seed, &mut points);
    }
    points
}

/// Puts the points number `from` up to `to` into a triangle: one anywhere, more into its halves by turns.
fn strew([a, b, c]: [DVec2; 3], from: usize, to: usize, seed: Seed, points: &mut Vec<DVec2>) {
    if to <= from + 1 {
        let lone = (from..to).map(|index| within([a, b, c], &mut seed.child(index as u64).random()));
        points.extend(lone);
        return;
    }
    let middle = from + (to - from) / 2;
    let [left, right] = halves([a, b, c]);
    strew(left, from, middle, seed, points);
    strew(right, middle, to, seed, points);
}

/// A triangle cut from the middle of its longest side to the corner opposite.
fn halves([a, b, c]: [DVec2; 3]) -> [[DVec2; 3]; 2] {
    let [ab, bc, ca] = [a.distance_squared(b), b.distance_squared(c), c.distance_squared(a)];
    let [a, b, c] = if ab >= bc && ab >= ca {
        [a, b, c]
    } else if bc >= ca {
        [b, c, a]
    } else {
        [c, a, b]
    };
    let middle = (a + b) * 0.5;
    [[c, a, middle], [middle, b, c]]
}
