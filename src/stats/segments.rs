//! Line segments in a grid: the edges of a window, of buildings, the axes of streets.
//!
//! In: segments in plane metres. Out: distances to the nearest, those within reach, crossings of a level line.

use crate::geometry::{Bounds, BoxGrid, nearest_on_segment};
use glam::DVec2;

/// Segments that are asked for what is near.
#[derive(Clone, Debug)]
pub struct Segments {
    ends: Vec<(DVec2, DVec2)>,
    grid: BoxGrid,
    bounds: Bounds,
}

impl Segments {
    /// Segments by their ends. Such that are not finite are never found.
    pub fn new(ends: Vec<(DVec2, DVec2)>) -> Segments {
        let boxes: Vec<Bounds> = ends.iter().map(|(a, b)| Bounds::of([*a, *b])).collect();
        let finite = boxes.iter().filter(|b| b.min.is_finite() && b.max.is_finite());
        let bounds = finite.copied().fold(Bounds::EMPTY, Bounds::union);
        Segments { grid: BoxGrid::new(&boxes), ends, bounds }
    }

    /// Distance to the nearest, metres; infinite where there is none.
    ///
    /// Looks in a square that doubles until it holds an answer: about constant for points among the segments.
    pub fn distance(&self, p: DVec2) -> f64 {
        if self.bounds.is_empty() || !p.is_finite() {
            return f64::INFINITY;
        }
        let away = (p - p.clamp(self.bounds.min, self.bounds.max)).length();
        let size = self.bounds.size();
        let mut reach = away + size.length() / (self.ends.len() as f64).sqrt() + f64::MIN_POSITIVE;
        loop {
            let found = self.within(p, reach).map(|(near, ..)| near).fold(f64::INFINITY, f64::min);
            if found <= reach || reach >= 2.0 * (away + size.length()) {
                return found;
            }
            reach *= 2.0;
        }
    }

    /// Every segment near the square around `p` that reaches `reach` metres far: its distance from `p`, and its ends.
    pub(super) fn within(&self, p: DVec2, reach: f64) -> impl Iterator<Item = (f64, DVec2, DVec2)> {
        let square = Bounds { min: p - reach, max: p + reach };
        self.grid.touching(square).map(move |index| {
            let (a, b) = self.ends[index];
            (nearest_on_segment(p, a, b).distance(p), a, b)
        })
    }

    /// How many segments the ray from `p` to the right crosses; an upper end counts, a lower one does not.
    pub(super) fn crossings_right_of(&self, p: DVec2) -> usize {
        let ray = Bounds { min: p, max: DVec2::new(self.bounds.max.x.max(p.x), p.y) };
        let crosses = |index: &usize| {
            let (a, b) = self.ends[*index];
            (a.y > p.y) != (b.y > p.y) && ((b - a).perp_dot(p - a) > 0.0) == (b.y > a.y)
        };
        self.grid.touching(ray).filter(crosses).count()
    }
}
