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
    pools: Vec<Cuts>,
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
    /// The cell of the lattice that it lies in.
    at: u32,
}

impl<'a> Darts<'a> {
    /// Nothing thrown yet.
    pub fn new(ground: &'a Ground, radii: &'a Radii, lattice: Lattice, seed: Seed) -> Darts<'a> {
        Darts { ground, radii, lattice, random: seed.draw("darts"), pools: Vec::new() }
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
            if level.cells.len() > MOST_SQUARES || self.lattice.count() >= most {
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
    fn gather(&mut self, tile: u32, level: &mut Level) {
        let square = self.lattice.tiles[tile as usize].square;
        let levels = (square.side / self.lattice.cell).round() as u64;
        self.pools.resize_with(levels.trailing_zeros() as usize + 1, Cuts::default);
        self.pools[0].clear();
        let run = self.pools[0].copy(square.run, &self.lattice.cuts);
        let lattice = &self.lattice;
        descend(self.ground, self.radii, &Square { run, ..square }, &mut self.pools, &mut |square, cuts| {
            let at = lattice.at(tile, square.centre());
            if !lattice.is_closed(at) {
                let run = level.cuts.copy(square.run, cuts);
                level.cells.push(Cell { square: Square { run, ..*square }, tile, at });
            }
        });
    }

    /// As many darts as squares. Those hit leave the range; what is left of it is given back.
    fn sweep(&mut self, level: &mut Level, range: Range<usize>, most: usize, strict: bool) -> Range<usize> {
        let mut left = range.clone();
        for _ in range {
            if left.is_empty() || self.lattice.count() >= most {
                break;
            }
            // Evenly but for a share of 1e-10, which none can tell.
            let index = left.start + ((u128::from(self.random.bits()) * left.len() as u128) >> 64) as usize;
            let cell = level.cells[index];
            if !self.lattice.is_closed(cell.at) {
                let position = cell.square.min + self.place() * cell.square.side;
                let Some(radius) = self.radius(&cell, position, &level.cuts, strict) else { continue };
                self.lattice.put(cell.tile, cell.at, Disk { position, radius });
            }
            left.end -= 1;
            level.cells.swap(index, left.end);
        }
        left
    }

    /// A place in a square of side 1, of a grid so fine that none can see it.
    fn place(&mut self) -> DVec2 {
        let bits = self.random.bits();
        DVec2::new((bits >> 32) as f64, f64::from(bits as u32)) * (1.0 / (1u64 << 32) as f64)
    }

    /// The radius of a disk at `p`, if one stays there: a strict dart brings its own, another takes one that fits.
    fn radius(&mut self, cell: &Cell, p: DVec2, cuts: &Cuts, strict: bool) -> Option<f64> {
        let mean = self.radii.mean.at(p);
        let range @ [low, _] = self.radii.range(mean);
        let mut room = self.lattice.clearance(cell.tile, cell.at, p, range);
        if room >= low && !cell.square.run.is_empty() {
            room = self.ground.room(p, cell.square.centre(), cell.square.run, cuts, room);
        }
        if room < low {
            return None;
        }
        let drawn = if strict { range } else { [low, room] };
        Some(self.radii.draw_within(mean, drawn, &mut self.random)).filter(|radius| *radius <= room)
    }

    /// The quarters of squares that neither a disk nor a condition excludes.
    fn split(&mut self, level: &Level, range: Range<usize>, next: &mut Level) {
        for cell in level.cells[range].iter().filter(|cell| !self.lattice.is_closed(cell.at)) {
            let Cell { square, tile, at } = cell;
            let covered = self.lattice.covered(*tile, *at, square, self.lows(square));
            for index in (0..4).filter(|index| covered >> index & 1 == 0) {
                let quarter = self.ground.quarter(square, index, &level.cuts, self.radii, &mut next.cuts);
                next.cells.extend(quarter.map(|square| Cell { square, ..*cell }));
            }
        }
    }

    /// The least radius in each quarter of a square.
    fn lows(&self, square: &Square) -> [f64; 4] {
        if self.radii.mean.is_constant() {
            return [self.lattice.least; 4];
        }
        std::array::from_fn(|index| {
            let min = square.quarter(index as u32);
            self.radii.lows(min, min + square.side * 0.5)[0]
        })
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
