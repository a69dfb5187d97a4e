//! Uniform grids over points and boxes, for neighbourhood queries.
//!
//! Built by counting, in time linear in what they hold; answers come in an order that depends on the input alone.

use crate::geometry::Bounds;
use glam::{DVec2, UVec2};

/// Cells per entry at most, so that a few far-flung entries cannot ask for endless memory.
const CELLS_PER_ENTRY: f64 = 4.0;

/// Points in the cells of a grid.
#[derive(Clone, Debug)]
pub struct PointGrid {
    cells: Cells,
    lists: Lists,
    points: Vec<DVec2>,
}

/// Boxes in the cells of a grid.
#[derive(Clone, Debug)]
pub struct BoxGrid {
    cells: Cells,
    lists: Lists,
    boxes: Vec<Bounds>,
}

impl PointGrid {
    /// A grid whose cells are about `cell` metres wide: best near the radius of the queries. Points that are not
    /// finite are never found.
    pub fn new(points: &[DVec2], cell: f64) -> PointGrid {
        let finite = || points.iter().enumerate().filter(|(_, p)| p.is_finite());
        let cells = Cells::new(Bounds::of(finite().map(|(_, p)| *p)), DVec2::splat(cell), points.len());
        let lists = Lists::new(cells.count(), |put| finite().for_each(|(i, p)| put(cells.index(cells.of(*p)), i)));
        PointGrid { cells, lists, points: points.to_vec() }
    }

    /// Indices of the points within `radius` of `centre`, rim included.
    pub fn within(&self, centre: DVec2, radius: f64) -> impl Iterator<Item = usize> {
        let box_of = Bounds { min: centre - radius, max: centre + radius };
        let near = self.cells.covered(box_of).flat_map(|cell| self.lists.of(self.cells.index(cell)));
        near.filter(move |i| self.points[*i].distance_squared(centre) <= radius * radius)
    }
}

impl BoxGrid {
    /// A grid over boxes. Empty boxes and such that are not finite are never found.
    pub fn new(boxes: &[Bounds]) -> BoxGrid {
        let sound = |b: &Bounds| !b.is_empty() && b.min.is_finite() && b.max.is_finite();
        let finite = || boxes.iter().enumerate().filter(|(_, b)| sound(b));
        let whole = finite().fold(Bounds::EMPTY, |all, (_, b)| all.union(*b));
        let mean = finite().map(|(_, b)| b.size()).sum::<DVec2>() / (finite().count().max(1) as f64);
        let cells = Cells::new(whole, mean * 1.5, boxes.len());
        let lists = Lists::new(cells.count(), |put| {
            finite().for_each(|(i, b)| cells.covered(*b).for_each(|cell| put(cells.index(cell), i)));
        });
        BoxGrid { cells, lists, boxes: boxes.to_vec() }
    }

    /// Indices of the boxes that share a point with `query`, each once.
    pub fn touching(&self, query: Bounds) -> impl Iterator<Item = usize> {
        let cells = if query.is_empty() { None } else { Some(self.cells.covered(query)) };
        cells.into_iter().flatten().flat_map(move |cell| {
            // A box is found in every cell it shares with the query; the lowest of them reports it.
            let lowest = move |b: &Bounds| self.cells.of(b.min.max(query.min)) == cell;
            let list = self.lists.of(self.cells.index(cell));
            list.filter(move |i| self.boxes[*i].touches(query) && lowest(&self.boxes[*i]))
        })
    }
}

/// The arrangement of cells.
#[derive(Clone, Copy, Debug)]
struct Cells {
    origin: DVec2,
    /// Cells per metre.
    density: DVec2,
    size: UVec2,
}

impl Cells {
    fn new(bounds: Bounds, cell: DVec2, entries: usize) -> Cells {
        if bounds.is_empty() {
            return Cells { origin: DVec2::ZERO, density: DVec2::ONE, size: UVec2::ONE };
        }
        let extent = bounds.size();
        let wanted = DVec2::select(cell.cmpgt(DVec2::ZERO), extent / cell, DVec2::INFINITY);
        let most = CELLS_PER_ENTRY * entries.max(4) as f64;
        let each = wanted.clamp(DVec2::ONE, DVec2::splat(most));
        let shrink = (most / each.element_product()).min(1.0).sqrt();
        let size = (each * shrink).floor().clamp(DVec2::ONE, DVec2::splat(most));
        let density = DVec2::select(extent.cmpgt(DVec2::ZERO), size / extent, DVec2::ZERO);
        Cells { origin: bounds.min, density, size: size.as_uvec2() }
    }

    fn count(&self) -> usize {
        self.size.x as usize * self.size.y as usize
    }

    /// The cell of a point, or the nearest one.
    fn of(&self, p: DVec2) -> UVec2 {
        // The conversion saturates, which is what clamps from below.
        ((p - self.origin) * self.density).as_uvec2().min(self.size - 1)
    }

    fn index(&self, cell: UVec2) -> usize {
        cell.y as usize * self.size.x as usize + cell.x as usize
    }

    /// The cells that a box touches, row by row.
    fn covered(&self, bounds: Bounds) -> impl Iterator<Item = UVec2> + use<> {
        let (low, high) = (self.of(bounds.min), self.of(bounds.max));
        (low.y..=high.y).flat_map(move |y| (low.x..=high.x).map(move |x| UVec2::new(x, y)))
    }
}

/// A list of entries per cell, in one buffer.
#[derive(Clone, Debug)]
struct Lists {
    /// Where each cell's list starts; one more for the end.
    starts: Vec<u32>,
    entries: Vec<u32>,
}

impl Lists {
    /// Sorts what `fill` puts by counting; `fill` runs twice and must put the same both times.
    fn new(cells: usize, fill: impl Fn(&mut dyn FnMut(usize, usize))) -> Lists {
        let mut starts = vec![0u32; cells + 1];
        fill(&mut |cell, _| starts[cell + 1] += 1);
        for i in 0..cells {
            starts[i + 1] += starts[i];
        }
        let mut entries = vec![0u32; starts[cells] as usize];
        let mut next = starts.clone();
        fill(&mut |cell, entry| {
            entries[next[cell] as usize] = entry as u32;
            next[cell] += 1;
        });
        Lists { starts, entries }
    }

    fn of(&self, cell: usize) -> impl Iterator<Item = usize> {
        self.entries[self.starts[cell] as usize..self.starts[cell + 1] as usize].iter().map(|i| *i as usize)
    }
}
