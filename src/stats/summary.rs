//! A pattern in a few numbers: density, nearest neighbours, the index of Clark and Evans, distances to the rim.
//!
//! In: a pattern, or a sample of distances. Out: numbers in metres.

use crate::stats::{Pattern, nearest_neighbours};

/// A sample of distances in a few numbers, all in metres.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Mean.
    pub mean: f64,
    /// Standard deviation, of the sample (n − 1); 0 for one.
    pub deviation: f64,
    /// The quantiles 0, 10, 25, 50, 75, 90 and 100 %, between neighbours in proportion.
    pub quantiles: [f64; 7],
}

/// The index of aggregation of Clark and Evans (1954): the mean distance to the nearest neighbour over what it would be
/// at random. 1 at random, below where points gather, 2.149 at most (a triangular lattice).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ClarkEvans {
    /// Without edge correction: too large by a few percent in small windows.
    pub naive: f64,
    /// With Donnelly's (1978) correction, by the length of the rim; made for rectangles, and near the truth for any
    /// window that is not all rim.
    pub donnelly: f64,
}

/// A pattern in a few numbers.
#[derive(Clone, Debug, PartialEq)]
pub struct Summary {
    /// Points in the window.
    pub count: usize,
    /// Area of the window, m².
    pub area: f64,
    /// Points per m².
    pub density: f64,
    /// Distances to nearest neighbours.
    pub nearest: Spread,
    /// How they compare with chance.
    pub clark_evans: ClarkEvans,
    /// Distances to the rim of the window.
    pub rim: Spread,
}

/// The summary of a pattern.
pub fn summary(pattern: &Pattern) -> Summary {
    let nearest = nearest_neighbours(pattern.points());
    Summary {
        count: pattern.points().len(),
        area: pattern.window().area(),
        density: pattern.density(),
        nearest: Spread::of(&nearest),
        clark_evans: clark_evans(pattern, &nearest),
        rim: Spread::of(&pattern.distances_to_rim()),
    }
}

/// The index of a pattern whose distances to nearest neighbours are known.
pub fn clark_evans(pattern: &Pattern, nearest: &[f64]) -> ClarkEvans {
    let mean = nearest.iter().sum::<f64>() / nearest.len() as f64;
    let expected = 0.5 / pattern.density().sqrt();
    let count = pattern.points().len() as f64;
    let edge = (0.0514 + 0.0412 / count.sqrt()) * pattern.window().perimeter() / count;
    ClarkEvans { naive: mean / expected, donnelly: mean / (expected + edge) }
}

impl Spread {
    /// The numbers of a sample; zeros for an empty one. n log n.
    pub fn of(sample: &[f64]) -> Spread {
        if sample.is_empty() {
            return Spread::default();
        }
        let mut sorted = sample.to_vec();
        sorted.sort_unstable_by(f64::total_cmp);
        let count = sorted.len() as f64;
        let mean = sorted.iter().sum::<f64>() / count;
        let squares: f64 = sorted.iter().map(|v| (v - mean) * (v - mean)).sum();
        let deviation = (squares / (count - 1.0).max(1.0)).sqrt();
        Spread { mean, deviation, quantiles: [0.0, 0.1, 0.25, 0.5, 0.75, 0.9, 1.0].map(|q| quantile(&sorted, q)) }
    }
}

/// The distribution of a sample: which share of it is not above each of the radii, which must ascend. Zeros for an empty
/// sample. n log n.
pub fn shares_within(sample: &[f64], radii: &[f64]) -> Vec<f64> {
    let mut sorted = sample.to_vec();
    sorted.sort_unstable_by(f64::total_cmp);
    let count = sorted.len().max(1) as f64;
    radii.iter().map(|radius| sorted.partition_point(|v| v <= radius) as f64 / count).collect()
}

fn quantile(sorted: &[f64], share: f64) -> f64 {
    let place = share * (sorted.len() - 1) as f64;
    let (low, high) = (sorted[place.floor() as usize], sorted[place.ceil() as usize]);
    low + (high - low) * place.fract()
}
