//! How far two patterns are from each other.
//!
//! In: two patterns, or two samples. Out: distances between their statistics, which tell one planting strategy from
//! another, and between the points themselves, which do not but are often reported.

use crate::stats::{Pattern, bandwidth, curves, default_reach, nearest_between, nearest_neighbours};
use glam::DVec2;

/// Steps of the curves that are compared.
const STEPS: usize = 128;

/// Two patterns compared.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Comparison {
    /// In metres.
    pub metres: Distances,
    /// Both brought to one point per unit of area first: a difference of density alone vanishes.
    pub scaled: Distances,
    /// Mean distance to the nearest point of the other pattern, once each way, added; metres.
    pub chamfer: f64,
    /// The largest distance to the nearest point of the other pattern, metres.
    pub hausdorff: f64,
}

/// Distances between the statistics of two patterns.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distances {
    /// Wasserstein-1 between the distances to nearest neighbours.
    pub nearest: f64,
    /// Wasserstein-1 between the distances to the rims.
    pub rim: f64,
    /// Root of the mean square difference of g, from the wider kernel's bandwidth to the nearer of the two reaches; no
    /// unit. `None` where a window is so narrow that nothing lies between.
    pub pair_correlation: Option<f64>,
    /// The largest difference of L.
    pub l: f64,
}

/// Compares two patterns, each in its own window. Costs four times the curves of one.
pub fn compare(a: &Pattern, b: &Pattern) -> Comparison {
    Comparison {
        metres: distances(a, b),
        scaled: distances(&a.at_unit_density(), &b.at_unit_density()),
        chamfer: chamfer(a.points(), b.points()),
        hausdorff: hausdorff(a.points(), b.points()),
    }
}

fn distances(a: &Pattern, b: &Pattern) -> Distances {
    let reach = default_reach(a).min(default_reach(b));
    let least = bandwidth(a).max(bandwidth(b));
    let (curves_a, curves_b) = (curves(a, reach, STEPS), curves(b, reach, STEPS));
    let differences = |x: &[f64], y: &[f64]| -> Vec<f64> { x.iter().zip(y).map(|(x, y)| (x - y).abs()).collect() };
    let above = curves_a.radius.iter().filter(|r| **r < least).count();
    let g = &differences(&curves_a.g, &curves_b.g)[above..];
    let squares: f64 = g.iter().map(|d| d * d).sum();
    Distances {
        nearest: wasserstein(&nearest_neighbours(a.points()), &nearest_neighbours(b.points())),
        rim: wasserstein(&a.distances_to_rim(), &b.distances_to_rim()),
        pair_correlation: (!g.is_empty()).then(|| (squares / g.len() as f64).sqrt()),
        l: differences(&curves_a.l_less_r(), &curves_b.l_less_r()).into_iter().fold(0.0, f64::max),
    }
}

/// Wasserstein-1 between two samples of numbers: the area between their distribution functions. Numbers that are not
/// finite are left out; infinite where one sample is empty and the other is not. n log n.
pub fn wasserstein(a: &[f64], b: &[f64]) -> f64 {
    let (a, b) = (sorted(a), sorted(b));
    if a.is_empty() || b.is_empty() {
        return if a.len() == b.len() { 0.0 } else { f64::INFINITY };
    }
    let (mut i, mut j, mut sum) = (0, 0, 0.0);
    let mut at = a[0].min(b[0]);
    while i < a.len() || j < b.len() {
        let next = a.get(i).copied().unwrap_or(f64::INFINITY).min(b.get(j).copied().unwrap_or(f64::INFINITY));
        sum += (i as f64 / a.len() as f64 - j as f64 / b.len() as f64).abs() * (next - at);
        at = next;
        i += usize::from(a.get(i) == Some(&next));
        j += usize::from(b.get(j) == Some(&next));
    }
    sum
}

/// Mean over `a` of the distance to the nearest of `b`, plus mean over `b` of the distance to the nearest of `a`
/// (exponent 1); infinite where one is empty and the other is not.
pub fn chamfer(a: &[DVec2], b: &[DVec2]) -> f64 {
    let mean = |distances: Vec<f64>| distances.iter().sum::<f64>() / distances.len().max(1) as f64;
    mean(nearest_between(a, b)) + mean(nearest_between(b, a))
}

/// The largest distance from a point of the one to the nearest of the other; infinite where one is empty and the other
/// is not.
pub fn hausdorff(a: &[DVec2], b: &[DVec2]) -> f64 {
    nearest_between(a, b).into_iter().chain(nearest_between(b, a)).fold(0.0, f64::max)
}

/// Where a model stands between the real and chance: 0 as near to the real as the real is to itself elsewhere, 1 no
/// better than random points. `None` where random points are no farther off than the real ones.
pub fn normalised_score(model_real: f64, random_real: f64, real_real: f64) -> Option<f64> {
    let room = random_real - real_real;
    (room > 0.0 && room.is_finite()).then(|| (model_real - real_real) / room)
}

fn sorted(sample: &[f64]) -> Vec<f64> {
    let mut sorted: Vec<f64> = sample.iter().copied().filter(|v| v.is_finite()).collect();
    sorted.sort_unstable_by(f64::total_cmp);
    sorted
}
