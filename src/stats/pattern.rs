//! A point pattern: points and the window they were observed in.
//!
//! In: points and a window in plane metres. Out: the points that lie inside, and how many do not.

use crate::placement::{PlacementError, uniform};
use crate::seed::Seed;
use crate::stats::Window;
use glam::DVec2;

/// Points in a window, at least two.
#[derive(Clone, Debug)]
pub struct Pattern {
    points: Vec<DVec2>,
    window: Window,
    outside: usize,
}

/// Why there is nothing to measure.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PatternError {
    /// Fewer than two points in the window.
    #[error("{inside} of {} lie in the window: two are needed", crate::text::counted(*all, "point"))]
    TooFew {
        /// How many lie inside.
        inside: usize,
        /// How many there are.
        all: usize,
    },
}

impl Pattern {
    /// The points that lie in the window, rim included, in their order. Those outside, or that are not finite, are left
    /// out and counted.
    pub fn new(points: &[DVec2], window: Window) -> Result<Pattern, PatternError> {
        let inside: Vec<DVec2> = points.iter().copied().filter(|p| window.contains(*p)).collect();
        if inside.len() < 2 {
            return Err(PatternError::TooFew { inside: inside.len(), all: points.len() });
        }
        Ok(Pattern { outside: points.len() - inside.len(), points: inside, window })
    }

    /// As many points anywhere in the same window: complete spatial randomness, the baseline of every statistic.
    pub fn random(&self, seed: Seed) -> Result<Pattern, PlacementError> {
        let points = uniform(self.window.region(), self.points.len(), seed)?;
        Ok(Pattern { points, window: self.window.clone(), outside: 0 })
    }

    /// The points.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The window.
    pub fn window(&self) -> &Window {
        &self.window
    }

    /// How many points were left out.
    pub fn outside(&self) -> usize {
        self.outside
    }

    /// Points per m².
    pub fn density(&self) -> f64 {
        self.points.len() as f64 / self.window.area()
    }

    /// Distance of each point to the rim of the window, metres.
    pub fn distances_to_rim(&self) -> Vec<f64> {
        self.points.iter().map(|p| self.window.distance_to_rim(*p)).collect()
    }

    /// The same, points and window times the root of the density: one point per unit of area, so that what is left to
    /// compare is the arrangement.
    pub fn at_unit_density(&self) -> Pattern {
        let factor = self.density().sqrt();
        let points = self.points.iter().map(|p| *p * factor).collect();
        Pattern { points, window: self.window.scaled(factor), outside: self.outside }
    }
}
