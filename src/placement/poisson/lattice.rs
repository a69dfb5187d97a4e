//! Where the disks stand: cells so small that each holds one centre at most, in tiles that exist only where the ground
//! is.
//!
//! A tile keeps copies of the cells around it, as wide as two disks reach, so that a look around a place walks over one
//! flat buffer and asks no neighbour.

use crate::placement::poisson::Ground;
use crate::placement::poisson::ground::{Cuts, Run, Square};
use crate::placement::{Disk, Radii};
use glam::DVec2;
use std::collections::BTreeMap;

/// A cell without a disk: infinitely far.
const EMPTY: [f64; 3] = [f64::INFINITY, f64::INFINITY, 0.0];
/// No tile.
const NONE: u32 = u32::MAX;
/// The powers of two of cells that a tile has along its side.
const TILES: [u32; 2] = [2, 6];
/// Cells in tiles may be so many times those that are needed; where they are more, tiles are smaller.
const WASTE: f64 = 6.0;

/// Tiles of cells.
pub struct Lattice {
    /// The side of a cell, metres.
    pub cell: f64,
    /// The tiles, in an order along the plan.
    pub tiles: Vec<Tile>,
    /// What cuts the tiles.
    pub cuts: Cuts,
    places: Vec<[f64; 3]>,
    window: Vec<Step>,
    /// Cells along the side of a tile.
    cells: i64,
    /// Cells copied on each side.
    rim: i64,
    stride: i64,
}

/// A tile of the lattice.
pub struct Tile {
    /// Its place and what cuts it.
    pub square: Square,
    /// The greatest radius that reaches into it.
    most: f64,
    around: [u32; 9],
}

/// A cell of the window around a cell.
#[derive(Clone, Copy)]
struct Step {
    offset: i32,
    /// No points of the two cells are nearer, metres.
    gap: f64,
}

impl Lattice {
    /// An empty lattice over the ground, of which `area` m² are free, with cells of side `cell`.
    pub fn new(ground: &Ground, radii: &Radii, area: f64, cell: f64) -> Lattice {
        let rim = (2.0 * radii.largest() / cell).ceil() as i64;
        let least = u64::BITS - (rim as u64 - 1).leading_zeros();
        let mut power = TILES[1].max(least);
        let mut found = tiles(ground, radii, cell, power);
        let wasteful = |count: usize, power: u32| {
            count as f64 * f64::from(1 << (2 * power)) > WASTE * (area / (cell * cell) + 64.0)
        };
        while power > TILES[0].max(least) && wasteful(found.tiles.len(), power) {
            power -= 1;
            found = tiles(ground, radii, cell, power);
        }
        let cells = 1i64 << power;
        let stride = cells + 2 * rim;
        let places = vec![EMPTY; found.tiles.len() * (stride * stride) as usize];
        let window = window(rim, stride, cell, 2.0 * radii.largest());
        Lattice { cell, tiles: found.tiles, cuts: found.cuts, places, window, cells, rim, stride }
    }

    /// The index of the cell of a place in a tile.
    pub fn at(&self, tile: u32, p: DVec2) -> usize {
        let [column, row] = self.cell_of(tile, p);
        self.index(tile, column, row)
    }

    fn cell_of(&self, tile: u32, p: DVec2) -> [i64; 2] {
        let q = (p - self.tiles[tile as usize].square.min) / self.cell;
        [(q.x as i64).clamp(0, self.cells - 1), (q.y as i64).clamp(0, self.cells - 1)]
    }

    fn index(&self, tile: u32, column: i64, row: i64) -> usize {
        ((i64::from(tile) * self.stride + row + self.rim) * self.stride + column + self.rim) as usize
    }

    /// The greatest radius from `low` to `high` with which a disk fits at `p`, in the cell `at`; negative if none does.
    pub fn clearance(&self, tile: u32, at: usize, p: DVec2, [low, high]: [f64; 2]) -> f64 {
        if self.places[at][0] < f64::INFINITY {
            return -1.0;
        }
        let most = self.tiles[tile as usize].most;
        let mut room = high;
        for step in &self.window {
            if step.gap >= room + most {
                break;
            }
            let [x, y, radius] = self.places[(at as i64 + i64::from(step.offset)) as usize];
            let square = (x - p.x) * (x - p.x) + (y - p.y) * (y - p.y);
            if square < (room + radius) * (room + radius) {
                room = square.sqrt() - radius;
                if room < low {
                    return -1.0;
                }
            }
        }
        room
    }

    /// The disks that may cover part of a square with a least radius from `low` to `high` in it; false where one of them
    /// covers the whole.
    pub fn near(&self, tile: u32, square: &Square, [low, high]: [f64; 2], found: &mut Vec<[f64; 3]>) -> bool {
        found.clear();
        let (p, half) = (square.centre(), square.side * 0.5 * (1.0 + 1e-12));
        let (at, most) = (self.at(tile, p), self.tiles[tile as usize].most);
        for step in &self.window {
            if step.gap >= high + most {
                break;
            }
            let [x, y, radius] = self.places[(at as i64 + i64::from(step.offset)) as usize];
            let (dx, dy) = ((x - p.x).abs(), (y - p.y).abs());
            if dx * dx + dy * dy < (radius + high) * (radius + high) {
                let far = (dx + half) * (dx + half) + (dy + half) * (dy + half);
                if far < (radius + low) * (radius + low) {
                    return false;
                }
                found.push([x, y, radius]);
            }
        }
        true
    }

    /// Puts a disk into its cell, and into the copies of it.
    pub fn put(&mut self, tile: u32, p: DVec2, radius: f64) {
        let [column, row] = self.cell_of(tile, p);
        let around = self.tiles[tile as usize].around;
        for (side, other) in around.into_iter().enumerate().filter(|(_, other)| *other != NONE) {
            let (dx, dy) = (side as i64 % 3 - 1, side as i64 / 3 - 1);
            let (column, row) = (column - dx * self.cells, row - dy * self.cells);
            let covered = -self.rim..self.cells + self.rim;
            if covered.contains(&column) && covered.contains(&row) {
                let index = self.index(other, column, row);
                self.places[index] = [p.x, p.y, radius];
                let most = &mut self.tiles[other as usize].most;
                *most = most.max(radius);
            }
        }
    }

    /// All disks, tile by tile.
    pub fn disks(self) -> Vec<Disk> {
        let mut disks = Vec::new();
        for tile in 0..self.tiles.len() as u32 {
            for row in 0..self.cells {
                let from = self.index(tile, 0, row);
                let row = &self.places[from..from + self.cells as usize];
                let full = row.iter().filter(|place| place[0] < f64::INFINITY);
                disks.extend(full.map(|[x, y, radius]| Disk { position: DVec2::new(*x, *y), radius: *radius }));
            }
        }
        disks
    }
}

/// Tiles and what cuts them.
struct Found {
    tiles: Vec<Tile>,
    cuts: Cuts,
}

/// All tiles with 2^`power` cells along their sides on which something may stand.
fn tiles(ground: &Ground, radii: &Radii, cell: f64, power: u32) -> Found {
    let side = cell * f64::from(1u32 << power);
    let bounds = ground.bounds();
    let across = (bounds.size().max_element() / side).ceil() + 1.0;
    let depth = (across as u64).next_power_of_two().trailing_zeros() as usize;
    let span = side * (1u64 << depth) as f64;
    // The root's corner lies a little off, so that edges on round coordinates do not run along tiles.
    let min = bounds.min - DVec2::new(0.37, 0.41) * cell;
    let mut pools = vec![Cuts::default(); depth + 1];
    let root = ground.first(Square { min, side: span, run: Run::default() }, &mut pools[0]);
    let mut kept = Cuts::default();
    let mut squares = Vec::new();
    descend(ground, radii, &root, &mut pools, &mut |square, cuts| {
        squares.push(Square { run: kept.copy(square.run, cuts), ..*square });
    });
    let place = |square: &Square| ((square.min - min) / side).round().as_i64vec2().to_array();
    let index: BTreeMap<[i64; 2], u32> = squares.iter().enumerate().map(|(i, s)| (place(s), i as u32)).collect();
    let around = |square: &Square| {
        let [column, row] = place(square);
        std::array::from_fn(|i| {
            let there = [column + i as i64 % 3 - 1, row + i as i64 / 3 - 1];
            index.get(&there).copied().unwrap_or(NONE)
        })
    };
    let tiles: Vec<Tile> = squares.iter().map(|s| Tile { square: *s, most: 0.0, around: around(s) }).collect();
    Found { tiles, cuts: kept }
}

/// Visits the squares, as many levels below a square as there are pools for, that no condition excludes.
pub fn descend(
    ground: &Ground,
    radii: &Radii,
    square: &Square,
    pools: &mut [Cuts],
    visit: &mut impl FnMut(&Square, &Cuts),
) {
    let Some((cuts, below)) = pools.split_first_mut() else { return };
    if below.is_empty() {
        return visit(square, cuts);
    }
    for index in 0..4 {
        below[0].clear();
        if let Some(quarter) = ground.quarter(square, index, cuts, radii, &mut below[0]) {
            descend(ground, radii, &quarter, below, visit);
        }
    }
}

/// The cells around a cell that a disk of `reach` can come from, near ones first.
fn window(rim: i64, stride: i64, cell: f64, reach: f64) -> Vec<Step> {
    let between = |d: i64| (d.abs() - 1).max(0) as f64;
    let mut steps: Vec<(f64, i64, i64, i64)> = (-rim..=rim)
        .flat_map(|dy| (-rim..=rim).map(move |dx| (dx, dy)))
        // Rounding may put a centre into the cell beside its own.
        .map(|(dx, dy)| {
            (DVec2::new(between(dx), between(dy)).length() * cell * (1.0 - 1e-9), dx * dx + dy * dy, dy, dx)
        })
        .filter(|(gap, ..)| *gap < reach)
        .collect();
    steps.sort_by(|a, b| a.0.total_cmp(&b.0).then((a.1, a.2, a.3).cmp(&(b.1, b.2, b.3))));
    steps.into_iter().map(|(gap, _, dy, dx)| Step { offset: (dy * stride + dx) as i32, gap }).collect()
}
