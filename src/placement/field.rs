//! A number that may vary over the plan: density, spacing, radius.
//!
//! In: one number, or numbers on a grid (an expression sampled, a gradient, a raster). Out: the number at a place, and
//! bounds of it over a box, which samplers need to be exact.

use crate::geometry::Bounds;
use glam::DVec2;
use std::sync::Arc;

/// A number that may vary over the plan.
#[derive(Clone, Debug, PartialEq)]
pub enum Field {
    /// The same everywhere.
    Constant(f64),
    /// Between the nodes of a grid, bilinear; beyond its rim as on the rim.
    Grid(Arc<Grid>),
}

/// Numbers at the nodes of a grid in plan coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Grid {
    bounds: Bounds,
    columns: usize,
    rows: usize,
    values: Vec<f64>,
}

impl Grid {
    /// Samples `value` at `columns` × `rows` nodes (at least two each), the corners of `bounds` among them.
    pub fn sample<E>(
        bounds: Bounds,
        [columns, rows]: [usize; 2],
        mut value: impl FnMut(DVec2) -> Result<f64, E>,
    ) -> Result<Grid, E> {
        let (columns, rows) = (columns.max(2), rows.max(2));
        let step = bounds.size() / DVec2::new((columns - 1) as f64, (rows - 1) as f64);
        let node = |index: usize| DVec2::new((index % columns) as f64, (index / columns) as f64);
        let values = (0..columns * rows).map(|i| value(bounds.min + step * node(i))).collect::<Result<_, E>>()?;
        Ok(Grid { bounds, columns, rows, values })
    }

    /// The value at a place.
    pub fn at(&self, p: DVec2) -> f64 {
        self.between(self.cell_of(p))
    }

    /// The mean of its nodes.
    pub fn mean(&self) -> f64 {
        self.values.iter().sum::<f64>() / self.values.len() as f64
    }

    /// The least and the greatest value over a box.
    pub fn extremes_in(&self, bounds: Bounds) -> [f64; 2] {
        // Within a mesh the value is greatest and least at corners: of the box, of the mesh, or where their sides cross.
        let (low, high) = (self.cell_of(bounds.min), self.cell_of(bounds.max));
        let lines = |low: f64, high: f64| {
            let inner = (low as usize + 1..).map(|line| line as f64).take_while(move |line| *line < high);
            std::iter::once(low).chain(inner).chain(std::iter::once(high))
        };
        let corners = lines(low.y, high.y).flat_map(|y| lines(low.x, high.x).map(move |x| DVec2::new(x, y)));
        corners.map(|q| self.between(q)).fold([f64::INFINITY, f64::NEG_INFINITY], |[a, b], v| [a.min(v), b.max(v)])
    }

    /// The value at a place in steps of the grid.
    fn between(&self, q: DVec2) -> f64 {
        let (column, row) = (self.below(q.x, self.columns), self.below(q.y, self.rows));
        let (fx, fy) = (q.x - column as f64, q.y - row as f64);
        let value = |c: usize, r: usize| self.values[r * self.columns + c];
        let low = value(column, row) * (1.0 - fx) + value(column + 1, row) * fx;
        let high = value(column, row + 1) * (1.0 - fx) + value(column + 1, row + 1) * fx;
        low * (1.0 - fy) + high * fy
    }

    /// A place in steps of the grid, held within it.
    fn cell_of(&self, p: DVec2) -> DVec2 {
        let last = DVec2::new((self.columns - 1) as f64, (self.rows - 1) as f64);
        let share = (p - self.bounds.min) / self.bounds.size().max(DVec2::splat(1e-9));
        (share * last).clamp(DVec2::ZERO, last)
    }

    /// The node before a coordinate, never the last.
    fn below(&self, x: f64, count: usize) -> usize {
        (x as usize).min(count - 2)
    }

    fn extremes(&self) -> (f64, f64) {
        self.values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(*v), b.max(*v)))
    }
}

impl Field {
    /// The value at a place.
    pub fn at(&self, p: DVec2) -> f64 {
        match self {
            Field::Constant(value) => *value,
            Field::Grid(grid) => grid.at(p),
        }
    }

    /// The least and the greatest value over a box.
    pub fn extremes_in(&self, bounds: Bounds) -> [f64; 2] {
        match self {
            Field::Constant(value) => [*value; 2],
            Field::Grid(grid) => grid.extremes_in(bounds),
        }
    }

    /// The least value over a box.
    pub fn least_in(&self, bounds: Bounds) -> f64 {
        self.extremes_in(bounds)[0]
    }

    /// The greatest value over a box.
    pub fn most_in(&self, bounds: Bounds) -> f64 {
        self.extremes_in(bounds)[1]
    }

    /// Whether it is one number everywhere.
    pub fn is_constant(&self) -> bool {
        matches!(self, Field::Constant(_))
    }

    /// The least value anywhere.
    pub fn least(&self) -> f64 {
        match self {
            Field::Constant(value) => *value,
            Field::Grid(grid) => grid.extremes().0,
        }
    }

    /// The greatest value anywhere.
    pub fn most(&self) -> f64 {
        match self {
            Field::Constant(value) => *value,
            Field::Grid(grid) => grid.extremes().1,
        }
    }
}

impl Field {
    /// The same, times a factor.
    pub fn scaled(&self, factor: f64) -> Field {
        match self {
            Field::Constant(value) => Field::Constant(value * factor),
            Field::Grid(grid) => {
                let values = grid.values.iter().map(|value| value * factor).collect();
                Field::Grid(Arc::new(Grid { values, ..Grid::clone(grid) }))
            }
        }
    }
}

impl From<f64> for Field {
    fn from(value: f64) -> Field {
        Field::Constant(value)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn between_nodes_it_is_bilinear_and_beyond_the_rim_as_on_it() {
        let bounds = Bounds { min: DVec2::ZERO, max: DVec2::new(4.0, 2.0) };
        let plane = |p: DVec2| Ok::<f64, ()>(1.0 + 2.0 * p.x - p.y);
        let grid = Grid::sample(bounds, [5, 3], plane).unwrap();
        for p in [DVec2::new(0.3, 1.7), DVec2::new(4.0, 2.0), DVec2::new(2.5, 0.0)] {
            assert!((grid.at(p) - plane(p).unwrap()).abs() < 1e-12);
        }
        assert_eq!(grid.at(DVec2::new(-9.0, 9.0)), grid.at(DVec2::new(0.0, 2.0)));
        let field = Field::Grid(Arc::new(grid));
        assert_eq!((field.least(), field.most()), (-1.0, 9.0));
    }
}
