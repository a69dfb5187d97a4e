//! Darts into squares, level by level, until no square is left.

use crate::placement::poisson::Ground;
use crate::placement::poisson::ground::{Cuts, Square};
use crate::placement::poisson::lattice::{Lattice, descend};
use crate::placement::{Disk, Radii};
use crate::seed::{Random, Seed};
use glam::DVec2;
use std::ops::Range;

/// Squares are split until they are this many times smaller than the least radius, or [`FINEST`]. Where two conditions
/// leave a free strip without width between them (a band as wide as the clearance that it meets) there is no end else.
const FINENESS: f64 = 1024.0;
/// A gap that is no wider than this (metres) is none.
const FINEST: f64 = 1e-3;
/// More squares at once would only come from a gap in the reasoning above; they are then given up.
const MOST_SQUARES: usize = 200_000_000;

/// A round of sampling.
pub struct Darts<'a> {
    ground: &'a Ground,
    radii: &'a Radii,
    lattice: Lattice,
    random: Random,
    found: usize,
    near: Vec<[f64; 3]>,
}

/// Squares of one size, or of one for each place where the radius varies over the plan, tile by tile.
#[derive(Default)]
struct Level {
    cells: Vec<Cell>,
    cuts: Cuts,
}

/// A square that may still be free.
#[derive(Clone, Copy)]
struct Cell {
    square: Square,
    tile: u32,
}

impl<'a> Darts<'a> {
    /// Nothing thrown yet.
    pub fn new(ground: &'a Ground, radii: &'a Radii, lattice: Lattice, seed: Seed) -> Darts<'a> {
        Darts { ground, radii, lattice, random: seed.draw("darts"), found: 0, near: Vec::new() }
    }

    /// Throws until there are as many disks as wanted, or no place is left.
    ///
    /// Without a count tile by tile, which nobody can tell from a random order afterwards and memory likes better; for
    /// a count all over the ground at once, so that what stands at the end stands everywhere.
    pub fn throw(mut self, wanted: Option<usize>) -> Vec<Disk> {
        let most = wanted.unwrap_or(usize::MAX);
        let tiles = self.lattice.tiles.len() as u32;
        let step = if wanted.is_some() { tiles.max(1) } else { 1 };
        let (mut level, mut next, mut first) = (Level::default(), Level::default(), Level::default());
        for from in (0..tiles).step_by(step as usize) {
            first.clear();
            (from..(from + step).min(tiles)).for_each(|tile| self.gather(tile, &mut first));
            let whole = 0..first.cells.len();
            let left = self.sweep(&mut first, whole, most, true);
            self.split(&first, left, &mut level);
        }
        let finest = FINEST.min(self.radii.smallest() / FINENESS);
        while level.cells.first().is_some_and(|cell| cell.square.side > finest) {
            if level.cells.len() > MOST_SQUARES || self.found >= most {
                break;
            }
            next.clear();
            let mut from = 0;
            while from < level.cells.len() {
                let to = if wanted.is_some() { level.cells.len() } else { level.end_of_tile(from) };
                let left = self.sweep(&mut level, from..to, most, false);
                self.split(&level, left, &mut next);
                from = to;
            }
            std::mem::swap(&mut level, &mut next);
        }
        self.lattice.disks()
    }

    /// The squares of a tile: as large as two least disks at a place allow, where no condition excludes them.
    fn gather(&self, tile: u32, level: &mut Level) {
        let square = self.lattice.tiles[tile as usize].square;
        let levels = (square.side / self.lattice.cell).round() as u64;
        let mut pools = vec![Cuts::default(); levels.trailing_zeros() as usize + 1];
        pools[0].copy(square.run, &self.lattice.cuts);
        let run = pools[0].everything();
        descend(self.ground, self.radii, &Square { run, ..square }, &mut pools, &mut |square, cuts| {
            let run = level.cuts.copy(square.run, cuts);
            level.cells.push(Cell { square: Square { run, ..*square }, tile });
        });
    }

    /// As many darts as squares. Those hit leave the range; what is left of it is given back.
    fn sweep(&mut self, level: &mut Level, range: Range<usize>, most: usize, strict: bool) -> Range<usize> {
        let mut left = range.clone();
        for _ in range {
            if left.is_empty() || self.found >= most {
                break;
            }
            let index = left.start + self.random.below(left.len() as u64) as usize;
            let cell = level.cells[index];
            let p = cell.square.min + DVec2::new(self.random.unit(), self.random.unit()) * cell.square.side;
            if let Some(radius) = self.radius(&cell, p, &level.cuts, strict) {
                self.lattice.put(cell.tile, p, radius);
                self.found += 1;
                left.end -= 1;
                level.cells.swap(index, left.end);
            }
        }
        left
    }

    /// The radius of a disk at `p`, if one stays there: a strict dart brings its own, another takes one that fits.
    fn radius(&mut self, cell: &Cell, p: DVec2, cuts: &Cuts, strict: bool) -> Option<f64> {
        let mean = self.radii.mean.at(p);
        let range = self.radii.range(mean);
        let own = if strict { self.radii.draw_within(mean, range, &mut self.random) } else { range[0] };
        let most = if strict { own } else { range[1] };
        let at = self.lattice.at(cell.tile, p);
        let mut room = self.lattice.clearance(cell.tile, at, p, [own, most]);
        if room >= own && !cell.square.run.is_empty() {
            room = self.ground.room(p, cell.square.centre(), cell.square.run, cuts, room);
        }
        match room {
            room if room < own => None,
            _ if strict => Some(own),
            room => Some(self.radii.draw_within(mean, [own, room], &mut self.random)),
        }
    }

    /// The quarters of squares that neither a disk nor a condition excludes.
    fn split(&mut self, level: &Level, range: Range<usize>, next: &mut Level) {
        for cell in &level.cells[range] {
            let square = &cell.square;
            let lows = self.radii.lows(square.min, square.min + DVec2::splat(square.side));
            if !self.lattice.near(cell.tile, square, lows, &mut self.near) {
                continue;
            }
            for index in 0..4 {
                let (min, side) = (square.quarter(index), square.side * 0.5);
                let [low, _] = self.radii.lows(min, min + DVec2::splat(side));
                if covered(min, side, low, &self.near) {
                    continue;
                }
                if square.run.is_empty() {
                    next.cells.push(Cell { square: Square { min, side, run: Default::default() }, tile: cell.tile });
                } else if let Some(square) = self.ground.quarter(square, index, &level.cuts, self.radii, &mut next.cuts)
                {
                    next.cells.push(Cell { square, tile: cell.tile });
                }
            }
        }
    }
}

impl Level {
    fn clear(&mut self) {
        self.cells.clear();
        self.cuts.clear();
    }

    /// Where the squares of a tile end.
    fn end_of_tile(&self, from: usize) -> usize {
        let tile = self.cells[from].tile;
        from + self.cells[from..].iter().take_while(|cell| cell.tile == tile).count()
    }
}

/// Whether one disk leaves no place in a square for the least radius.
fn covered(min: DVec2, side: f64, low: f64, near: &[[f64; 3]]) -> bool {
    let (centre, half) = (min + side * 0.5, side * 0.5 * (1.0 + 1e-12));
    near.iter().any(|[x, y, radius]| {
        let far = DVec2::new((x - centre.x).abs() + half, (y - centre.y).abs() + half);
        far.length_squared() < (radius + low) * (radius + low)
    })
}
