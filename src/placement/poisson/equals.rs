//! Where the disks stand that all have one radius: a look around a place without a branch.
//!
//! In: cells that hold one centre each at most and are so large that a disk reaches two cells far. Out: whether a place
//! is free, and which disks cover it. Where a look takes in more than it must, it sees true distances all the same.

use glam::DVec2;

/// How many cells far a disk reaches.
pub const REACH: i64 = 2;
/// Cells looked at in a row: five, and one more to make pairs.
const LANES: usize = 6;
/// Rows looked at first: most places that are not free show it there.
const NEAR_ROWS: [isize; 3] = [0, -1, 1];
/// Rows looked at then.
const FAR_ROWS: [isize; 2] = [-2, 2];
/// Rows looked at in all.
const ROWS: usize = 5;

/// The centres in the cells of a buffer, infinitely far where there is none.
#[derive(Clone)]
pub struct Equals {
    xs: Vec<f64>,
    ys: Vec<f64>,
    stride: usize,
    /// Cells before the first, so that looks stay in the buffer.
    before: usize,
    /// The square of the least distance of two centres.
    apart: f64,
}

impl Equals {
    /// Room for `count` cells in rows of `stride`.
    pub fn new(count: usize, stride: usize, radius: f64) -> Equals {
        let before = 2 * stride + LANES;
        let empty = vec![f64::INFINITY; count + 2 * before];
        Equals { xs: empty.clone(), ys: empty, stride, before, apart: 4.0 * radius * radius }
    }

    /// Puts a centre into a cell.
    pub fn put(&mut self, index: usize, p: DVec2) {
        self.xs[self.before + index] = p.x;
        self.ys[self.before + index] = p.y;
    }

    /// Whether a disk at a place in a cell overlaps none.
    pub fn is_free(&self, at: usize, p: DVec2) -> bool {
        self.nearest(at, NEAR_ROWS, p) >= self.apart && self.nearest(at, FAR_ROWS, p) >= self.apart
    }

    /// Whether one of the centres that keep a place in a cell from being another passes a test.
    #[inline(always)]
    pub fn any_over(&self, at: usize, p: DVec2, mut test: impl FnMut(DVec2) -> bool) -> bool {
        let mut bits = 0u32;
        for row in 0..ROWS {
            let squares = self.distances(at, row as isize - REACH as isize, p);
            for (lane, square) in squares.into_iter().enumerate() {
                bits |= u32::from(square < self.apart) << (row * LANES + lane);
            }
        }
        while bits != 0 {
            let bit = bits.trailing_zeros() as usize;
            let index = self.start(at, (bit / LANES) as isize - REACH as isize) + bit % LANES;
            if test(DVec2::new(self.xs[index], self.ys[index])) {
                return true;
            }
            bits &= bits - 1;
        }
        false
    }

    /// The square of the distance to the nearest centre in some rows of cells.
    #[inline(always)]
    fn nearest<const N: usize>(&self, at: usize, rows: [isize; N], p: DVec2) -> f64 {
        let mut nearest = f64::INFINITY;
        for row in rows {
            for square in self.distances(at, row, p) {
                // Unlike `f64::min` one instruction: there is nothing here that is not a number.
                nearest = if square < nearest { square } else { nearest };
            }
        }
        nearest
    }

    /// The squares of the distances to what is in a row of cells.
    #[inline(always)]
    fn distances(&self, at: usize, row: isize, p: DVec2) -> [f64; LANES] {
        let start = self.start(at, row);
        let (xs, ys) = (&self.xs[start..start + LANES], &self.ys[start..start + LANES]);
        std::array::from_fn(|lane| (xs[lane] - p.x) * (xs[lane] - p.x) + (ys[lane] - p.y) * (ys[lane] - p.y))
    }

    #[inline(always)]
    fn start(&self, at: usize, row: isize) -> usize {
        (self.before + at - 2).wrapping_add_signed(row * self.stride as isize)
    }
}
