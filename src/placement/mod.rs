//! Points in polygons: where plants stand. Knows polygons and seeds and no language.
//!
//! In: a site in plane metres (an area, what is kept clear, what stands), radii, an amount, a seed. Out: places with a
//! radius each, in an order that means nothing but stays the same (Niese et al. 2022, §5.2–5.3). Beside the strategies
//! stand plain points without spacing: point number `n` of a scatter is the same whatever the count.

mod along;
mod beside;
mod boundary;
mod cluster;
mod equidistant;
mod even;
mod field;
mod places;
mod poisson;
mod radii;
mod ready;
mod regular;
mod rows;
mod scan;
mod scatter;
mod semirandom;
mod single;
mod site;
mod spot;
mod standing;
mod walk;

pub use along::{Along, Line, along};
pub use boundary::boundary;
pub use cluster::clusters;
pub use equidistant::equidistant;
pub use even::{distributed, homogeneous};
pub use field::{Field, Grid};
pub use radii::Radii;
pub use regular::{Lattice, regular};
pub use rows::{Rows, rows};
pub use scatter::{Scatter, gaussian, uniform};
pub use semirandom::semirandom;
pub use single::single;
pub use site::{Body, Disk, Site};
pub use spot::{Amount, Placed, Spot, Stop};
pub use standing::Standing;

use crate::geometry::Area;

/// More points than this in one area are refused: all trees of a large city have no place in one lot.
pub const MOST_POINTS: usize = 10_000_000;

/// Why no points were placed.
#[derive(Clone, Copy, Debug, PartialEq, thiserror::Error)]
pub enum PlacementError {
    /// More than [`MOST_POINTS`].
    #[error("{} points are more than the limit of {} in one shape", whole(*.0), crate::text::thousands(MOST_POINTS))]
    TooMany(f64),
    /// A density that is negative or no number.
    #[error("a density must be a number of points per square metre from 0 up, not {}", crate::text::number(*.0, 6))]
    Density(f64),
    /// A deviation that is negative or no number.
    #[error("a deviation must be a number from 0 up, not {}", crate::text::number(*.0, 6))]
    Deviation(f64),
    /// A radius with which more than [`MOST_POINTS`] would find a place.
    #[error("`radius` is so small that about {} points would find a place, more than the limit of {} in one shape", whole(*.estimate), crate::text::thousands(MOST_POINTS))]
    Crowded {
        /// About how many points would find a place.
        estimate: f64,
    },
    /// A parameter of a strategy is not what it may be.
    #[error("`{parameter}` must be {allowed}, not {}", crate::text::number(*.found, 6))]
    Value {
        /// The parameter.
        parameter: &'static str,
        /// What was given.
        found: f64,
        /// What may be given, in words.
        allowed: &'static str,
    },
}

impl PlacementError {
    /// The parameter that it is about.
    pub fn parameter(&self) -> Option<&'static str> {
        match self {
            PlacementError::Value { parameter, .. } => Some(parameter),
            PlacementError::Crowded { .. } => Some("radius"),
            _ => None,
        }
    }
}

/// How many points a density (per m²) means in an area: rounded to the nearest.
pub fn count_at(area: &Area, per_area: f64) -> Result<usize, PlacementError> {
    if !per_area.is_finite() || per_area < 0.0 {
        return Err(PlacementError::Density(per_area));
    }
    let count = (area.area() * per_area).round();
    if count <= MOST_POINTS as f64 { Ok(count as usize) } else { Err(PlacementError::TooMany(count)) }
}

/// The count, if it is allowed.
fn allowed(count: usize) -> Result<usize, PlacementError> {
    if count <= MOST_POINTS { Ok(count) } else { Err(PlacementError::TooMany(count as f64)) }
}

fn whole(count: f64) -> String {
    // Saturates: what matters is that it is far too many.
    crate::text::thousands(count as usize)
}
