//! Points in polygons: where plants stand. Knows polygons and seeds and no language.
//!
//! In: an area in plane metres, a count or a density, a seed. Out: points inside, in an order that means nothing but
//! stays the same. Point number `n` of a scatter is the same whatever the count: asking for one more plant moves none.

mod even;
mod field;
mod radii;
mod scatter;
mod site;
mod spot;
mod standing;

pub use even::{distributed, homogeneous};
pub use field::{Field, Grid};
pub use radii::Radii;
pub use scatter::{Scatter, gaussian, uniform};
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

// STUBS until the strategies are merged.
pub fn semirandom(site: &Site, radii: &Radii, amount: &Amount, seed: Seed) -> Result<Placed, PlacementError> {
    let _ = amount;
    let mut spots: Vec<Spot> = Vec::new();
    let b = site.bounds();
    let mut r = seed.random();
    for _ in 0..4000 {
        let p = glam::DVec2::new(r.uniform(b.min.x, b.max.x), r.uniform(b.min.y, b.max.y));
        let q = radii.draw(p, &mut r);
        if site.allows(p, q) && spots.iter().all(|s| s.position.distance(p) >= s.radius + q) {
            spots.push(Spot { position: p, radius: q, direction: glam::DVec2::X, cluster: 0 });
        }
    }
    amount.thin(&mut spots, seed);
    Ok(Placed { spots, missing: 0 })
}
pub fn boundary(
    site: &Site,
    rim: &Area,
    width: f64,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    let mut p = semirandom(site, radii, amount, seed)?;
    p.spots.retain(|s| rim.distance_to_edges(s.position) <= width);
    Ok(p)
}
pub fn clusters(
    site: &Site,
    _r: f64,
    _c: [usize; 2],
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    semirandom(site, radii, amount, seed)
}
pub fn single(site: &Site, radii: &Radii, amount: &Amount, seed: Seed) -> Result<Placed, PlacementError> {
    semirandom(site, radii, amount, seed)
}
/// A line to place on.
pub struct Line {
    pub points: Vec<glam::DVec2>,
    pub closed: bool,
}
use crate::seed::Seed;
