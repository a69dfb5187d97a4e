//! What strategies share: how many plants are wanted, and what comes out.

use crate::geometry::Area;
use crate::placement::{Disk, Field, PlacementError};
use crate::seed::Seed;
use glam::DVec2;

/// A place for a plant.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spot {
    /// Its centre in the plan.
    pub position: DVec2,
    /// The radius it reserves, metres.
    pub radius: f64,
    /// The unit direction of its x axis: along the nearest edge, the axis, the row.
    pub direction: DVec2,
    /// Which cluster, branch, row or edge it belongs to; 0 where there is one.
    pub cluster: u32,
}

/// When a strategy ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Stop {
    /// When no place is left where the least radius still fits.
    #[default]
    Saturated,
    /// After so many plants.
    Count(usize),
    /// After so many plants per m² of where the strategy places, before clearances are taken off.
    PerArea(f64),
}

/// How many plants are wanted.
#[derive(Clone, Debug, PartialEq)]
pub struct Amount {
    /// When to end.
    pub stop: Stop,
    /// The share of the places that is kept (τ): may vary over the plan.
    pub density: Field,
}

/// What a strategy found.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Placed {
    /// The places, in an order that means nothing but stays the same.
    pub spots: Vec<Spot>,
    /// How many of a count that was asked for found no place.
    pub missing: usize,
}

impl Default for Amount {
    fn default() -> Amount {
        Amount { stop: Stop::Saturated, density: Field::Constant(1.0) }
    }
}

impl Amount {
    /// How many places to look for in an area before some are given up again; `None` without a bound.
    pub fn wanted(&self, area: &Area) -> Result<Option<usize>, PlacementError> {
        match self.stop {
            Stop::Saturated => Ok(None),
            Stop::Count(count) => Ok(Some(crate::placement::allowed(count)?)),
            Stop::PerArea(per_area) => Ok(Some(crate::placement::count_at(area, per_area)?)),
        }
    }

    /// Refuses shares that are not from 0 to 1.
    pub fn check(&self) -> Result<(), PlacementError> {
        for share in [self.density.least(), self.density.most()] {
            if !(0.0..=1.0).contains(&share) {
                let allowed = "a share from 0 to 1";
                return Err(PlacementError::Value { parameter: "density", found: share, allowed });
            }
        }
        Ok(())
    }

    /// Gives places up at random until the share τ is left: of a constant density that very share, rounded. A greater
    /// density keeps what a smaller one kept.
    pub fn thin(&self, spots: &mut Vec<Spot>, seed: Seed) {
        let rank = |index: usize| seed.named("density").child(index as u64).random().unit();
        match &self.density {
            Field::Constant(share) if *share >= 1.0 => {}
            Field::Constant(share) => {
                let kept = (*share * spots.len() as f64).round() as usize;
                let mut ranks: Vec<(f64, usize)> = (0..spots.len()).map(|index| (rank(index), index)).collect();
                if kept < ranks.len() {
                    ranks.select_nth_unstable_by(kept, |a, b| a.partial_cmp(b).unwrap_or(std::cmp::Ordering::Equal));
                    ranks.truncate(kept);
                }
                let mut kept: Vec<usize> = ranks.into_iter().map(|(_, index)| index).collect();
                kept.sort_unstable();
                *spots = kept.into_iter().map(|index| spots[index]).collect();
            }
            Field::Grid(grid) => {
                let mut index = 0;
                spots.retain(|spot| {
                    index += 1;
                    rank(index - 1) < grid.at(spot.position)
                });
            }
        }
    }
}

impl Spot {
    /// The disk it reserves.
    pub fn disk(&self) -> Disk {
        Disk { position: self.position, radius: self.radius }
    }
}
