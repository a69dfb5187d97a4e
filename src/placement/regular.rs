//! Plants in the cells of a lattice over the lot's box, more or less in their middles.
//!
//! Niese et al. 2022, §5.3, regular (ω, ψ, η).

use crate::geometry::Bounds;
use crate::placement::places::{Place, Places, few_enough, positive};
use crate::placement::scan::Grid;
use crate::placement::{Amount, Placed, PlacementError, Radii, Site};
use crate::seed::Seed;
use glam::DVec2;

/// How often a place is looked for in a cell.
const TRIES: u64 = 8;

/// Cells this near (in steps) count as touched.
const TOUCH: f64 = 1e-7;

/// A lattice over a lot.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// Where the lot's frame has its origin, in the plan.
    pub origin: DVec2,
    /// Unit x axis of the lot's frame.
    pub direction: DVec2,
    /// The lot's box in that frame.
    pub bounds: Bounds,
    /// Side of a cell (ω), metres.
    pub cell: f64,
    /// Turn of the lattice against the lot's frame (η), degrees.
    pub orientation: f64,
    /// How far plants leave the middles of their cells (ψ): 0 not at all, 1 anywhere in the cell.
    pub jitter: f64,
}

/// A plant in each cell that allows it, the cluster of a spot being its row.
///
/// As many whole cells as fit the box around the lot's box that is turned like the lattice (one at least), with equal
/// rests at both sides. A jittered place that the site forbids, or where a disk would overlap another, is looked for a
/// few times more before the cell stays empty. Costs the cells that touch the area.
pub fn regular(
    site: &Site,
    lattice: &Lattice,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    lattice.check()?;
    let mut places = Places::new(site, radii, amount, [lattice.cell; 2], seed)?;
    if lattice.bounds.is_empty() {
        return places.finish(amount);
    }
    let grid = lattice.grid()?;
    let reach = DVec2::splat(0.5 * lattice.jitter + TOUCH);
    for [row, column] in grid.cells(site.area(), reach)? {
        let number = (row as u64) << 32 | u64::from(column as u32);
        let middle = Place { number, position: grid.place(row, column), direction: grid.axis, cluster: row as u32 };
        if lattice.jitter == 0.0 {
            places.take(middle);
        } else {
            lattice.take_near(middle, &grid, seed, &mut places);
        }
    }
    places.finish(amount)
}

impl Lattice {
    fn check(&self) -> Result<(), PlacementError> {
        positive("cell", self.cell)?;
        if !self.orientation.is_finite() {
            let allowed = "a number of degrees";
            return Err(PlacementError::Value { parameter: "orientation", found: self.orientation, allowed });
        }
        if !(0.0..=1.0).contains(&self.jitter) {
            let allowed = "a share from 0 to 1";
            return Err(PlacementError::Value { parameter: "jitter", found: self.jitter, allowed });
        }
        Ok(())
    }

    /// The middles of its cells.
    fn grid(&self) -> Result<Grid, PlacementError> {
        let (sin, cos) = libm::sincos(self.orientation.to_radians());
        let turn = DVec2::new(cos, sin);
        let half = self.bounds.size() * 0.5;
        let extent = 2.0 * DVec2::new(half.x * cos.abs() + half.y * sin.abs(), half.x * sin.abs() + half.y * cos.abs());
        let count = (extent / self.cell + 1e-9).floor().max(DVec2::ONE);
        few_enough(count.max_element())?;
        let first = -0.5 * self.cell * (count - 1.0);
        let direction = self.direction.normalize_or(DVec2::X);
        Ok(Grid {
            origin: self.origin + direction.rotate(self.bounds.centre() + turn.rotate(first)),
            axis: direction.rotate(turn),
            step: DVec2::splat(self.cell),
            count: [count.x as usize, count.y as usize],
            stagger: 0.0,
        })
    }

    /// Takes the first of some places in a cell that is free.
    fn take_near(&self, middle: Place, grid: &Grid, seed: Seed, places: &mut Places) {
        let mut random = seed.named("jitter").child(middle.number).random();
        for _ in 0..TRIES {
            let away = DVec2::new(random.unit() - 0.5, random.unit() - 0.5) * self.jitter * self.cell;
            let place = Place { position: middle.position + grid.axis.rotate(away), ..middle };
            if places.take_apart(place, f64::INFINITY, 0.0) {
                return;
            }
        }
    }
}
