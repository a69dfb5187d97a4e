//! The radii of plants' envelopes: a normal distribution, cut off on both sides.
//!
//! Niese et al. 2022, §5.3: r(y) ~ N(μ, σ). The paper calls σ the variance; `deviation` here is its root.

use crate::geometry::Bounds;
use crate::placement::{Field, PlacementError};
use crate::seed::Random;
use glam::DVec2;

/// Draws from the bell before one is taken evenly; the chance to need more is below 1e-9.
const TRIES: usize = 64;

/// The distribution of radii, metres.
#[derive(Clone, Debug, PartialEq)]
pub struct Radii {
    /// The mean (μ); may vary over the plan.
    pub mean: Field,
    /// The standard deviation (√σ).
    pub deviation: f64,
    /// No radius is below this; where it is not given, below half the mean.
    pub least: Option<f64>,
}

impl Radii {
    /// The same radius everywhere.
    pub fn constant(radius: f64) -> Radii {
        Radii { mean: Field::Constant(radius), deviation: 0.0, least: None }
    }

    /// Refuses what is not positive and finite.
    pub fn check(&self) -> Result<(), PlacementError> {
        let positive = "a number of metres above 0";
        for mean in [self.mean.least(), self.mean.most()] {
            if !(mean.is_finite() && mean > 0.0) {
                return Err(PlacementError::Value { parameter: "radius", found: mean, allowed: positive });
            }
        }
        if !(self.deviation.is_finite() && self.deviation >= 0.0) {
            let allowed = "a number of metres from 0 up";
            return Err(PlacementError::Value { parameter: "radius_sd", found: self.deviation, allowed });
        }
        match self.least {
            Some(least) if !(least.is_finite() && least > 0.0) => {
                Err(PlacementError::Value { parameter: "radius_min", found: least, allowed: positive })
            }
            _ => Ok(()),
        }
    }

    /// The least and greatest radius where the mean is `mean`: two deviations around it, never below half of it or
    /// the least that was given.
    pub fn range(&self, mean: f64) -> [f64; 2] {
        let floor = self.least.unwrap_or(0.5 * mean);
        let low = (mean - 2.0 * self.deviation).max(floor);
        [low, (mean + 2.0 * self.deviation).max(low)]
    }

    /// The least radius and the greatest in a box, or a wider range.
    pub fn span(&self, min: DVec2, max: DVec2) -> [f64; 2] {
        let [least, most] = self.mean.extremes_in(Bounds { min, max });
        [self.range(least)[0], self.range(most)[1]]
    }

    /// Where in a box the least radius is least, and where it is greatest: both of them.
    pub fn lows(&self, min: DVec2, max: DVec2) -> [f64; 2] {
        self.mean.extremes_in(Bounds { min, max }).map(|mean| self.range(mean)[0])
    }

    /// The least radius anywhere.
    pub fn smallest(&self) -> f64 {
        self.range(self.mean.least())[0]
    }

    /// The greatest radius anywhere.
    pub fn largest(&self) -> f64 {
        self.range(self.mean.most())[1]
    }

    /// A radius for a plant at `p`.
    pub fn draw(&self, p: DVec2, random: &mut Random) -> f64 {
        let mean = self.mean.at(p);
        let range = self.range(mean);
        self.draw_within(mean, range, random)
    }

    /// A radius from the part of the distribution between two bounds.
    pub fn draw_within(&self, mean: f64, [low, high]: [f64; 2], random: &mut Random) -> f64 {
        if self.deviation == 0.0 || high <= low {
            return mean.clamp(low, high.max(low));
        }
        // Evenly between the bounds, refused by the height of the bell. Bounds lie within two deviations of the mean,
        // so that even in the tail every other draw or so is kept.
        let [from, to] = [(low - mean) / self.deviation, (high - mean) / self.deviation];
        let peak = 0.0f64.clamp(from, to);
        for _ in 0..TRIES {
            let z = random.uniform(from, to);
            if random.unit() < libm::exp(0.5 * (peak * peak - z * z)) {
                return (mean + self.deviation * z).clamp(low, high);
            }
        }
        random.uniform(low, high)
    }
}
