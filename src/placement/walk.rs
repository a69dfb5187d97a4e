//! Walking along a line in steps of a spacing that may vary.

use crate::geometry::Path;
use crate::placement::places::{few_enough, positive};
use crate::placement::{Field, PlacementError};
use glam::DVec2;

/// Where the spacing varies, it is looked at so many times a step, at its least.
const LOOKS: f64 = 8.0;

/// A line measured in steps.
pub(super) struct Walk {
    path: Path,
    /// Distance along the line, and steps up to there, both growing.
    stations: Vec<[f64; 2]>,
}

impl Walk {
    /// The line measured by a spacing in metres; refuses spacings that are not positive, and too many steps.
    pub fn new(path: Path, spacing: &Field) -> Result<Walk, PlacementError> {
        check_spacing(spacing)?;
        few_enough(path.length() / spacing.least())?;
        let pieces = match spacing {
            Field::Constant(_) => 1.0,
            Field::Grid(_) => (LOOKS * path.length() / spacing.least()).ceil().max(1.0),
        };
        let mut stations = vec![[0.0, 0.0]];
        let mut steps = 0.0;
        for i in 1..=pieces as usize {
            let (from, to) = (path.length() * (i - 1) as f64 / pieces, path.length() * i as f64 / pieces);
            steps += (to - from) / spacing.at(path.at(0.5 * (from + to)).0);
            stations.push([to, steps]);
        }
        Ok(Walk { path, stations })
    }

    /// How many steps long the line is.
    pub fn steps(&self) -> f64 {
        self.stations[self.stations.len() - 1][1]
    }

    /// The point after some steps, and the unit direction there.
    pub fn at(&self, steps: f64) -> (DVec2, DVec2) {
        let next = self.stations.partition_point(|s| s[1] <= steps).clamp(1, self.stations.len() - 1);
        let ([s, m], [t, n]) = (self.stations[next - 1], self.stations[next]);
        self.path.at(s + (t - s) * ((steps - m) / (n - m)))
    }
}

/// Refuses spacings that are not positive somewhere.
pub(super) fn check_spacing(spacing: &Field) -> Result<(), PlacementError> {
    positive("spacing", spacing.least())?;
    positive("spacing", spacing.most())
}
