//! Distances to nearest neighbours.
//!
//! In: points in plane metres. Out: a distance for each, in their order. About linear for points that are spread; where
//! nearly all lie in a few spots of a wide plane, up to quadratic.

use crate::geometry::{Bounds, PointGrid};
use crate::stats::CHUNK;
use glam::DVec2;
use rayon::prelude::*;

/// Distance of each point to the nearest other one, metres; 0 where two coincide, infinite for a point alone.
pub fn nearest_neighbours(points: &[DVec2]) -> Vec<f64> {
    let near = Nearest::new(points);
    near.each(points, |index, other| index != other)
}

/// Distance of each point of `from` to the nearest of `to`, metres; infinite where there is none.
pub fn nearest_between(from: &[DVec2], to: &[DVec2]) -> Vec<f64> {
    Nearest::new(to).each(from, |_, _| true)
}

/// Points that are asked for the nearest.
struct Nearest<'p> {
    points: &'p [DVec2],
    grid: PointGrid,
    bounds: Bounds,
    /// About the distance of neighbours.
    spacing: f64,
}

impl Nearest<'_> {
    fn new(points: &[DVec2]) -> Nearest<'_> {
        let bounds = Bounds::of(points.iter().copied().filter(|p| p.is_finite()));
        let size = bounds.size();
        let count = points.len().max(1) as f64;
        let spacing = (size.element_product() / count).sqrt().max(size.max_element() / count);
        let spacing = if spacing > 0.0 { spacing } else { 1.0 };
        Nearest { points, grid: PointGrid::new(points, spacing), bounds, spacing }
    }

    fn each(&self, from: &[DVec2], counts: impl Fn(usize, usize) -> bool + Sync) -> Vec<f64> {
        let distance = |(index, p): (usize, &DVec2)| self.distance(*p, |other| counts(index, other));
        from.par_iter().enumerate().with_min_len(CHUNK).map(distance).collect()
    }

    /// Looks in a disk that doubles until it holds an answer.
    fn distance(&self, p: DVec2, counts: impl Fn(usize) -> bool) -> f64 {
        if self.bounds.is_empty() || !p.is_finite() {
            return f64::INFINITY;
        }
        let away = (p - p.clamp(self.bounds.min, self.bounds.max)).length();
        let farthest = away + self.bounds.size().length();
        let mut reach = away + self.spacing;
        loop {
            let mut best = f64::INFINITY;
            for other in self.grid.within(p, reach).filter(|other| counts(*other)) {
                best = best.min(self.points[other].distance_squared(p));
                if best == 0.0 {
                    break;
                }
            }
            if best.is_finite() || reach >= 2.0 * farthest {
                return best.sqrt();
            }
            reach *= 2.0;
        }
    }
}
