//! The disks that stand in a lot: a set that grows as operations place, and is asked by later ones.

use crate::geometry::Bounds;
use crate::placement::Disk;
use glam::DVec2;
use std::cell::{Cell, RefCell};
use std::collections::HashMap;

/// Metres across a cell: about the spacing of street trees.
const CELL: f64 = 8.0;

/// So few are looked at one by one; cells are filled when there are more.
const FEW: usize = 256;

/// A growing set of disks.
///
/// Adding is cheap; the first question after it sorts what came into cells. A question costs the disks of the cells
/// it touches.
#[derive(Debug, Default)]
pub struct Standing {
    disks: Vec<Disk>,
    largest: f64,
    // Looked up by cell only, never walked: its order cannot show.
    cells: RefCell<HashMap<(i64, i64), Vec<u32>>>,
    sorted: Cell<usize>,
}

impl Standing {
    /// Takes one more in and gives its number; what has no radius takes no place and has none.
    pub fn add(&mut self, disk: Disk) -> Option<u32> {
        let sound = disk.position.is_finite() && disk.radius.is_finite() && disk.radius > 0.0;
        sound.then(|| {
            self.largest = self.largest.max(disk.radius);
            self.disks.push(disk);
            self.disks.len() as u32 - 1
        })
    }

    /// The disk of that number.
    pub fn get(&self, number: u32) -> Option<Disk> {
        self.disks.get(number as usize).copied()
    }

    /// The disks that may reach into a rectangle, in the order they came, without the one of the number `own`.
    pub fn near(&self, bounds: Bounds, own: Option<u32>) -> Vec<Disk> {
        let reach = bounds.grown(self.largest);
        let (low, high) = (cell_of(reach.min), cell_of(reach.max));
        // Cells without end saturate.
        let across = |low: i64, high: i64| high.saturating_sub(low).saturating_add(1);
        let wide = across(low.0, high.0).saturating_mul(across(low.1, high.1)) > self.disks.len() as i64;
        let reaches = |index: &u32| {
            let disk = self.disks[*index as usize];
            Some(*index) != own && bounds.grown(disk.radius).contains(disk.position)
        };
        let disk = |index: u32| self.disks[index as usize];
        if wide || self.disks.len() <= FEW {
            return (0..self.disks.len() as u32).filter(reaches).map(disk).collect();
        }
        self.sort();
        let cells = self.cells.borrow();
        let keys = (low.0..=high.0).flat_map(|x| (low.1..=high.1).map(move |y| (x, y)));
        let mut found: Vec<u32> = keys.filter_map(|key| cells.get(&key)).flatten().copied().collect();
        found.sort_unstable();
        found.into_iter().filter(reaches).map(disk).collect()
    }

    /// Puts what came since the last question into cells.
    fn sort(&self) {
        let mut cells = self.cells.borrow_mut();
        for index in self.sorted.get()..self.disks.len() {
            cells.entry(cell_of(self.disks[index].position)).or_default().push(index as u32);
        }
        self.sorted.set(self.disks.len());
    }
}

fn cell_of(point: DVec2) -> (i64, i64) {
    ((point.x / CELL).floor() as i64, (point.y / CELL).floor() as i64)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_reaches_into_a_rectangle_is_found_whenever_it_came() {
        let mut standing = Standing::default();
        let grid = |i: u32| DVec2::new(f64::from(i % 40) * 7.0, f64::from(i / 40) * 7.0);
        (0..1600).for_each(|i| _ = standing.add(Disk { position: grid(i), radius: 1.0 + f64::from(i % 5) }));
        let near = Bounds { min: DVec2::new(50.0, 50.0), max: DVec2::new(60.0, 55.0) };
        let expected = |standing: &Standing| -> Vec<Disk> {
            let reaches = |d: &&Disk| near.grown(d.radius).contains(d.position);
            standing.disks.iter().filter(reaches).copied().collect()
        };
        assert_eq!(standing.near(near, None), expected(&standing));
        standing.add(Disk { position: DVec2::new(90.0, 52.0), radius: 31.0 });
        assert_eq!(standing.near(near, None), expected(&standing));
        assert_eq!(standing.near(near, None).last().map(|d| d.radius), Some(31.0));
        assert_eq!(standing.near(near, Some(1600)).len() + 1, standing.near(near, None).len());
        let far = Bounds { min: DVec2::splat(1e12), max: DVec2::splat(2e12) };
        assert_eq!(standing.near(far, None), []);
        standing.add(Disk { position: DVec2::ZERO, radius: 1e300 });
        assert_eq!(standing.near(near, None), expected(&standing));
    }
}
