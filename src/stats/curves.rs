//! Functions of distance: Ripley's K, Besag's L, the pair correlation g.
//!
//! In: a pattern and distances. Out: the three at each distance, with Ripley's isotropic edge correction: a pair counts
//! for one over the share of the circle through the one around the other that lies in the window (Ripley 1977; exact
//! for polygons with holes). Costs the pairs within reach, and near the rim the edges within reach besides.

use crate::geometry::PointGrid;
use crate::stats::window::Near;
use crate::stats::{CHUNK, Pattern};
use glam::DVec2;
use rayon::prelude::*;
use std::f64::consts::PI;

/// Half the width of the kernel of g, in mean spacings 1/√λ (Stoyan and Stoyan 1994).
const STOYAN: f64 = 0.15;
/// Points within reach, in the mean: what lies farther adds little and costs much (as in spatstat).
const MOST_WITHIN: f64 = 1000.0;

/// Functions of distance at the distances of `radius`.
#[derive(Clone, Debug, PartialEq)]
pub struct Curves {
    /// Distances in metres, ascending, evenly spaced, the first one step above zero.
    pub radius: Vec<f64>,
    /// Half the width of the kernel of g, metres.
    pub bandwidth: f64,
    /// Ripley's K, m²: πr² where points are independent.
    pub k: Vec<f64>,
    /// The pair correlation: 1 where points are independent, above where they gather, below where they keep apart.
    ///
    /// Epanechnikov kernel, not corrected at zero: below the bandwidth it is too low.
    pub g: Vec<f64>,
}

impl Curves {
    /// Besag's L less the distance, metres: 0 where points are independent.
    pub fn l_less_r(&self) -> Vec<f64> {
        self.k.iter().zip(&self.radius).map(|(k, r)| (k / PI).sqrt() - r).collect()
    }
}

/// How far curves reach unless told: a quarter of the window's shorter side, and no more than makes a thousand points
/// lie within reach; metres.
pub fn default_reach(pattern: &Pattern) -> f64 {
    let side = pattern.window().region().bounds().size().min_element();
    (0.25 * side).min((MOST_WITHIN / (PI * pattern.density())).sqrt())
}

/// Half the width of the Epanechnikov kernel of g: 0.15 mean spacings, metres.
pub fn bandwidth(pattern: &Pattern) -> f64 {
    STOYAN / pattern.density().sqrt()
}

/// K and g of a pattern at `steps` distances up to `reach` metres; empty where there is no distance.
pub fn curves(pattern: &Pattern, reach: f64, steps: usize) -> Curves {
    let steps = if reach.is_finite() && reach > 0.0 { steps } else { 0 };
    let radius: Vec<f64> = (1..=steps).map(|i| reach * i as f64 / steps as f64).collect();
    let bandwidth = bandwidth(pattern);
    let Some(farthest) = radius.last().map(|last| last + bandwidth) else {
        return Curves { radius, bandwidth, k: Vec::new(), g: Vec::new() };
    };
    let walk =
        Walk { pattern, grid: PointGrid::new(pattern.points(), farthest * 0.5), farthest, bandwidth, reach, steps };
    let chunks: Vec<Sums> = pattern.points().par_chunks(CHUNK).enumerate().map(|(i, c)| walk.chunk(i, c)).collect();
    let sums = chunks.iter().fold(Sums::new(steps), Sums::plus);
    let count = pattern.points().len() as f64;
    let per_pair = pattern.window().area() / (count * (count - 1.0));
    let mut within = 0.0;
    let k = sums.pairs.iter().map(|weight| {
        within += weight;
        within * per_pair
    });
    let k = k.collect();
    let g = sums.kernel.iter().zip(&radius).map(|(sum, r)| sum * per_pair / (2.0 * PI * r)).collect();
    Curves { radius, bandwidth, k, g }
}

/// Weights of pairs, sorted by distance.
struct Sums {
    /// Of pairs whose distance lies above the distance before, up to this one.
    pairs: Vec<f64>,
    /// Times the kernel around each distance.
    kernel: Vec<f64>,
}

impl Sums {
    fn new(steps: usize) -> Sums {
        Sums { pairs: vec![0.0; steps], kernel: vec![0.0; steps] }
    }

    fn plus(mut self, other: &Sums) -> Sums {
        self.pairs.iter_mut().zip(&other.pairs).for_each(|(a, b)| *a += b);
        self.kernel.iter_mut().zip(&other.kernel).for_each(|(a, b)| *a += b);
        self
    }
}

/// A walk over all pairs within reach.
struct Walk<'p> {
    pattern: &'p Pattern,
    grid: PointGrid,
    farthest: f64,
    bandwidth: f64,
    reach: f64,
    steps: usize,
}

impl Walk<'_> {
    fn chunk(&self, number: usize, points: &[DVec2]) -> Sums {
        let mut sums = Sums::new(self.steps);
        let mut near = Near::default();
        for (offset, p) in points.iter().enumerate() {
            let index = number * CHUNK + offset;
            self.pattern.window().look(*p, self.farthest, &mut near);
            for other in self.grid.within(*p, self.farthest).filter(|other| *other != index) {
                let distance = self.pattern.points()[other].distance(*p);
                self.add(distance, near.weight(distance), &mut sums);
            }
        }
        sums
    }

    fn add(&self, distance: f64, weight: f64, sums: &mut Sums) {
        let per_metre = self.steps as f64 / self.reach;
        // A distance just on a step belongs to it, whatever the rounding of the division.
        let bin = ((distance * per_metre - 1e-9).ceil().max(1.0) as usize) - 1;
        if let Some(sum) = sums.pairs.get_mut(bin) {
            *sum += weight;
        }
        let low = ((distance - self.bandwidth) * per_metre).ceil().max(1.0) as usize;
        let high = (((distance + self.bandwidth) * per_metre).floor().max(0.0) as usize).min(self.steps);
        for step in low..=high {
            let away = (step as f64 / per_metre - distance) / self.bandwidth;
            sums.kernel[step - 1] += weight * 0.75 * (1.0 - away * away).max(0.0) / self.bandwidth;
        }
    }
}
