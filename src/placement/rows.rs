//! Parallel rows over an area: orchards, groves in the quincunx, beds.

use crate::geometry::Bounds;
use crate::placement::places::{Place, Places, few_enough, from_zero, positive};
use crate::placement::scan::Grid;
use crate::placement::{Amount, Placed, PlacementError, Radii, Site};
use crate::seed::Seed;
use glam::DVec2;

/// Lengths that miss by less than this (metres) are not missed.
const SLACK: f64 = 1e-9;

/// Cells this near (in steps) count as touched.
const TOUCH: f64 = 1e-7;

/// How rows are planted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rows {
    /// From plant to plant in a row, metres.
    pub spacing: f64,
    /// From row to row, metres.
    pub distance: f64,
    /// How far plants stay from the rim, metres.
    pub inset: f64,
    /// By which share of the spacing each second row is shifted.
    pub stagger: f64,
}

impl Rows {
    /// The quincunx: every plant in the middle of six at the same distance, in metres.
    pub fn quincunx(spacing: f64, inset: f64) -> Rows {
        Rows { spacing, distance: spacing * (0.5 * 3f64.sqrt()), inset, stagger: 0.5 }
    }

    fn check(&self) -> Result<(), PlacementError> {
        positive("spacing", self.spacing)?;
        positive("distance", self.distance)?;
        from_zero("inset", self.inset)?;
        if !(0.0..=1.0).contains(&self.stagger) {
            let allowed = "a share from 0 to 1";
            return Err(PlacementError::Value { parameter: "stagger", found: self.stagger, allowed });
        }
        Ok(())
    }

    /// The least distance between two of the lattice's places.
    pub fn apart(&self) -> f64 {
        let aside = self.stagger.min(1.0 - self.stagger) * self.spacing;
        let next = (aside * aside + self.distance * self.distance).sqrt();
        self.spacing.min(next).min(2.0 * self.distance)
    }

    /// As many rows and columns as fit the area's extent along and across the rows, in its middle.
    fn grid(&self, site: &Site, axis: DVec2) -> Result<Grid, PlacementError> {
        let own = |p: DVec2| DVec2::new(axis.dot(p), axis.perp_dot(p));
        let extent = Bounds::of(site.area().edges().map(|(p, _)| own(p)));
        let step = DVec2::new(self.spacing, self.distance);
        let free = (extent.size() - 2.0 * self.inset + SLACK).max(DVec2::ZERO);
        let gaps = (free / step).floor();
        few_enough(gaps.max_element())?;
        Ok(Grid {
            origin: axis.rotate(extent.centre() - 0.5 * gaps * step),
            axis,
            step,
            count: [gaps.x as usize + 1, gaps.y as usize + 1],
            stagger: self.stagger,
        })
    }
}

/// Plants in parallel rows, the cluster of a spot being its row, its direction that of the rows.
///
/// The rows lie in the middle of the area's extent with equal rests at both sides, and so do the plants of the first,
/// third and every odd row; the others are shifted. Concavities and holes cut rows without moving a plant, so that the
/// lattice stays one. A direction without length is the x axis. Costs the plants, the edges, and what of them is near
/// each plant.
pub fn rows(
    site: &Site,
    direction: DVec2,
    rows: &Rows,
    radii: &Radii,
    amount: &Amount,
    seed: Seed,
) -> Result<Placed, PlacementError> {
    rows.check()?;
    let mut places = Places::new(site, radii, amount, [rows.apart(); 2], seed)?;
    if site.area().is_empty() {
        return places.finish(amount);
    }
    let grid = rows.grid(site, direction.normalize_or(DVec2::X))?;
    for [row, column] in grid.cells(site.area(), DVec2::splat(TOUCH))? {
        let position = grid.place(row, column);
        if rows.inset == 0.0 || places.is_inset(position, rows.inset - SLACK) {
            let number = (row as u64) << 32 | u64::from(column as u32);
            places.take(Place { number, position, direction: grid.axis, cluster: row as u32 });
        }
    }
    places.finish(amount)
}
