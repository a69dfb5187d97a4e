//! How many disks will find a place, before any is placed: so that a spacing far too small is refused at once.

use crate::placement::poisson::Ground;
use crate::placement::poisson::ground::{Cuts, Square};
use crate::placement::{MOST_POINTS, PlacementError, Radii};
use glam::DVec2;

/// Disks of one radius on a large area: so many for each square of the radius. A jammed packing covers 0.547 of a
/// plane (Feder 1980), and 0.547 / π is this.
const JAMMED: f64 = 0.174;
/// Where radii vary, gaps fill with small ones: as many disks as of one radius so far on the way from the least to the
/// mean (measured, for deviations up to a quarter of the mean).
const TYPICAL: f64 = 0.35;
/// Squares that are looked at, at each level.
const MOST_SQUARES: usize = 100_000;
/// The share of the area that may stay undecided.
const UNDECIDED: f64 = 0.02;
/// Squares of so many least radii are small enough: where the limit is near, and where it is far, as in a garden.
const FINE: [f64; 2] = [0.25, 2.0];
/// Cells for each of the points that are allowed at most.
const CELLS_PER_POINT: f64 = 6.0;
/// Cells for each point of a count, so that two rarely want the same.
const CELLS_PER_WANTED: f64 = 16.0;

/// What a ground holds, about.
#[derive(Clone, Copy, Debug, Default)]
pub struct Capacity {
    /// The free area, m².
    area: f64,
    /// Disks when no more fit.
    points: f64,
}

impl Capacity {
    /// Looks at ever smaller squares until nearly all of the area is decided, or the squares are too many.
    pub fn of(ground: &Ground, radii: &Radii) -> Capacity {
        let (mut cuts, mut next) = (Cuts::default(), Cuts::default());
        let mut squares = vec![ground.root(&mut cuts)];
        let mut found = Capacity::default();
        let size = ground.bounds().size();
        let fine = size.max_element() / 64.0;
        let is_far = size.x * size.y < 0.1 * MOST_POINTS as f64 * radii.smallest() * radii.smallest();
        let least = FINE[usize::from(is_far)] * radii.smallest();
        loop {
            let side = squares.first().map_or(0.0, |square| square.side * 0.5);
            let mut smaller = Vec::new();
            next.clear();
            for square in &squares {
                for quarter in (0..4).filter_map(|index| ground.quarter(square, index, &cuts, radii, &mut next)) {
                    if quarter.run.is_empty() && (radii.mean.is_constant() || quarter.side <= fine) {
                        found.add(&quarter, radii, 1.0);
                    } else {
                        smaller.push(quarter);
                    }
                }
            }
            std::mem::swap(&mut cuts, &mut next);
            squares = smaller;
            let undecided = side * side * squares.len() as f64;
            let enough = undecided <= UNDECIDED * found.area || side <= least;
            if enough || squares.len() > MOST_SQUARES {
                squares.iter().for_each(|square| found.add(square, radii, 0.5));
                return found;
            }
        }
    }

    /// The free area, m².
    pub fn area(&self) -> f64 {
        self.area
    }

    fn add(&mut self, square: &Square, radii: &Radii, share: f64) {
        let area = square.side * square.side * share;
        let mean = radii.mean.at(square.centre());
        let low = radii.range(mean)[0];
        let typical = low + TYPICAL * (mean - low).max(0.0);
        self.area += area;
        self.points += JAMMED * area / (typical * typical);
    }

    /// The side of the cells to work with, or why not.
    pub fn grain(&self, radii: &Radii, wanted: Option<usize>) -> Result<f64, PlacementError> {
        // A little less than the side of a square with two least disks in opposite corners.
        let finest = radii.smallest() * std::f64::consts::SQRT_2 * (1.0 - 1e-6);
        if let Some(wanted) = wanted {
            let share = CELLS_PER_WANTED * wanted as f64 + 1024.0;
            return Ok(finest.max((self.area / share).sqrt()));
        }
        let limit = MOST_POINTS as f64;
        if self.points > limit {
            return Err(PlacementError::Crowded { estimate: self.points });
        }
        if self.area > CELLS_PER_POINT * limit * finest * finest {
            let allowed = "larger: gaps for radii so small would be looked for everywhere";
            return Err(PlacementError::Value { parameter: "radius_min", found: radii.smallest(), allowed });
        }
        Ok(finest)
    }
}

impl Ground {
    /// A square around everything, with all conditions.
    pub(super) fn root(&self, cuts: &mut Cuts) -> Square {
        let bounds = self.bounds();
        let side = bounds.size().max_element() * 1.001 + bounds.max.abs().max(bounds.min.abs()).max_element() * 1e-9;
        let min = bounds.centre() - side * 0.5;
        self.first(Square { min, side, run: Default::default() }, cuts)
    }

    /// A quarter of a square, unless a condition excludes it.
    pub(super) fn quarter(
        &self,
        square: &Square,
        index: u32,
        cuts: &Cuts,
        radii: &Radii,
        kept: &mut Cuts,
    ) -> Option<Square> {
        let (min, side) = (square.quarter(index), square.side * 0.5);
        let quarter = Square { min, side, run: Default::default() };
        if square.run.is_empty() {
            return Some(quarter);
        }
        let range = radii.span(min, min + DVec2::splat(side));
        let run = self.narrow((square.centre(), square.run, cuts), (quarter.centre(), quarter.half()), range, kept)?;
        Some(Square { run, ..quarter })
    }
}
