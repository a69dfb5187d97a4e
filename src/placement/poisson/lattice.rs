//! Where the disks stand: cells so small that each holds one centre at most, in tiles that exist only where the ground
//! is.
//!
//! A tile keeps copies of the cells around it, as wide as two disks reach, so that a look around a place walks over one
//! flat buffer and asks no neighbour.

use crate::placement::poisson::Ground;
use crate::placement::poisson::equals::{self, Equals};
use crate::placement::poisson::ground::{Cuts, Run, Square};
use crate::placement::poisson::window::{Bits, Windows};
use crate::placement::{Disk, Radii};
use glam::DVec2;
use std::collections::BTreeMap;

/// No tile.
const NONE: u32 = u32::MAX;
/// The powers of two of cells that a tile has along its side.
const TILES: [u32; 2] = [2, 6];
/// Cells in tiles may be so many times those that are needed; where they are more, tiles are smaller.
const WASTE: f64 = 6.0;

/// Windows of so many sizes are kept ready.
const WINDOWS: usize = 24;

/// Tiles of cells.
#[derive(Clone)]
pub struct Lattice {
    /// The side of a cell, metres.
    pub cell: f64,
    /// The tiles, in an order along the plan.
    pub tiles: Vec<Tile>,
    /// What cuts the tiles.
    pub cuts: Cuts,
    disks: Vec<Disk>,
    /// The number of the disk in each cell that is taken.
    places: Vec<u32>,
    taken: Bits,
    /// Cells that one disk covers so far that the least radius fits nowhere in them.
    closed: Bits,
    windows: Windows,
    /// In place of the above where all radii are one.
    equals: Option<Equals>,
    /// The least radius anywhere, metres.
    pub least: f64,
    /// Cells along the side of a tile.
    cells: i64,
    /// Cells copied on each side.
    rim: i64,
    stride: i64,
}

/// A tile of the lattice.
#[derive(Clone)]
pub struct Tile {
    /// Its place and what cuts it.
    pub square: Square,
    /// The greatest radius that reaches into it.
    most: f64,
    around: [u32; 9],
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
        let count = found.tiles.len() * (stride * stride) as usize;
        let one = radii.smallest() == radii.largest() && rim <= equals::REACH;
        Lattice {
            cell,
            tiles: found.tiles,
            cuts: found.cuts,
            disks: Vec::new(),
            places: vec![0; count],
            taken: Bits::new(count),
            closed: Bits::new(count),
            windows: Windows::new(WINDOWS.min(2 * rim as usize), stride, cell, 2.0 * radii.largest()),
            equals: one.then(|| Equals::new(count, stride as usize, radii.smallest())),
            least: radii.smallest(),
            cells,
            rim,
            stride,
        }
    }

    /// The index of the cell of a place in a tile.
    pub fn at(&self, tile: u32, p: DVec2) -> u32 {
        let q = (p - self.tiles[tile as usize].square.min) / self.cell;
        let [column, row] = q.to_array().map(|c| (c as i64).clamp(0, self.cells - 1));
        self.index(tile, column, row) as u32
    }

    fn index(&self, tile: u32, column: i64, row: i64) -> usize {
        ((i64::from(tile) * self.stride + row + self.rim) * self.stride + column + self.rim) as usize
    }

    /// The column and the row of a cell in its tile.
    fn column_and_row(&self, tile: u32, at: u32) -> [i64; 2] {
        let at = i64::from(at) - i64::from(tile) * self.stride * self.stride;
        [at % self.stride - self.rim, at / self.stride - self.rim]
    }

    /// Whether the least radius is known to fit nowhere in a cell.
    pub fn is_closed(&self, at: u32) -> bool {
        self.closed.has(at as usize)
    }

    /// The greatest radius from `low` to `high` with which a disk fits at `p`, in the cell `at`; negative if none does.
    pub fn clearance(&self, tile: u32, at: u32, p: DVec2, [low, high]: [f64; 2]) -> f64 {
        if let Some(equals) = &self.equals {
            return if equals.is_free(at as usize, p) { high } else { -1.0 };
        }
        let mut room = high;
        let crowded = self.any(tile, at, high, |disk| {
            let square = disk.position.distance_squared(p);
            if square < (room + disk.radius) * (room + disk.radius) {
                room = square.sqrt() - disk.radius;
            }
            room < low
        });
        if crowded { -1.0 } else { room }
    }

    /// Which quarters of a square are each covered by one disk, so far that the least radius there fits nowhere: a bit
    /// for each quarter.
    pub fn covered(&self, tile: u32, at: u32, square: &Square, lows: [f64; 4]) -> u32 {
        let (p, half) = (square.centre(), square.side * 0.5 * (1.0 + 1e-12));
        let mut covered = 0;
        let mut all = |position: DVec2, radius: f64| {
            covered |= quarters(position - p, half, lows.map(|low| (radius + low) * (radius + low)));
            covered == 0b1111
        };
        // A quarter reaches to the centre, so that what covers it covers that.
        if let Some(equals) = &self.equals {
            equals.any_over(at as usize, p, |position| all(position, self.least));
        } else {
            let high = lows.into_iter().fold(0.0, f64::max);
            self.any(tile, at, high, |Disk { position, radius }| {
                position.distance_squared(p) < (radius + high) * (radius + high) && all(*position, *radius)
            });
        }
        covered
    }

    /// Whether a disk passes a test, of those that may come nearer than `reach` metres to a place in a cell.
    #[inline(always)]
    fn any(&self, tile: u32, at: u32, reach: f64, mut test: impl FnMut(&Disk) -> bool) -> bool {
        let packs = self.windows.of(reach + self.tiles[tile as usize].most);
        self.taken.any(at as usize, packs, |cell| test(&self.disks[self.places[cell] as usize]))
    }

    /// How many disks there are.
    pub fn count(&self) -> usize {
        self.disks.len()
    }

    /// Puts a disk into its cell, and into the copies of it.
    pub fn put(&mut self, tile: u32, at: u32, disk: Disk) {
        let [column, row] = self.column_and_row(tile, at);
        let number = self.disks.len() as u32;
        self.disks.push(disk);
        self.closed.set(at as usize);
        let around = self.tiles[tile as usize].around;
        let inner = self.rim..self.cells - self.rim;
        let sides = if inner.contains(&column) && inner.contains(&row) { 4..5 } else { 0..9 };
        for (side, other) in sides.map(|side| (side, around[side])).filter(|(_, other)| *other != NONE) {
            let (dx, dy) = (side as i64 % 3 - 1, side as i64 / 3 - 1);
            let (column, row) = (column - dx * self.cells, row - dy * self.cells);
            let covered = -self.rim..self.cells + self.rim;
            if covered.contains(&column) && covered.contains(&row) {
                let index = self.index(other, column, row);
                if let Some(equals) = &mut self.equals {
                    equals.put(index, disk.position);
                } else {
                    self.places[index] = number;
                    self.taken.set(index);
                }
                let most = &mut self.tiles[other as usize].most;
                *most = most.max(disk.radius);
                self.close(other, disk);
            }
        }
    }

    /// Closes the cells of a tile that a disk covers.
    fn close(&mut self, tile: u32, disk: Disk) {
        let p = (disk.position - self.tiles[tile as usize].square.min) / self.cell;
        // Rounding must not close what is free.
        let reach = (disk.radius + self.least) / self.cell * (1.0 - 1e-9) - p.abs().max_element() * 1e-12;
        let first = (p.y - reach).ceil().max(0.0) as i64;
        let end = ((p.y + reach).floor() as i64).min(self.cells);
        for row in first..end {
            let away = (row as f64 - p.y).abs().max((row as f64 + 1.0 - p.y).abs());
            let half = (reach * reach - away * away).max(0.0).sqrt();
            let from = (p.x - half).ceil().max(0.0) as i64;
            let to = ((p.x + half).floor() as i64).min(self.cells);
            (from..to).for_each(|column| self.closed.set(self.index(tile, column, row)));
        }
    }

    /// All disks, in the order they came.
    pub fn disks(self) -> Vec<Disk> {
        self.disks
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

/// Which quarters of a square around the origin lie wholly nearer to a place than the root of their limit.
#[inline(always)]
fn quarters(place: DVec2, half: f64, limits: [f64; 4]) -> u32 {
    let far = |x: f64| [x.abs().max((x + half).abs()), x.abs().max((x - half).abs())].map(|far| far * far);
    let (xs, ys) = (far(place.x), far(place.y));
    (0..4).fold(0, |bits, index| bits | u32::from(xs[index & 1] + ys[index >> 1] < limits[index]) << index)
}
