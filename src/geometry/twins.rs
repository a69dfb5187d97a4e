//! Edges that two polygons of an area have in common, as a shape and its band have them.

use crate::geometry::{Area, Mesh};
use std::collections::HashMap;

/// Corners nearer than this (metres) to each other are one.
const SAME: f64 = 1e-4;

impl Area {
    /// For each edge in the order of [`Area::edges`] the number of the edge that runs along it the other way, if there
    /// is one. Empty for a single polygon, which has no neighbour; n log n for others.
    pub fn twins(&self) -> Vec<Option<usize>> {
        if self.polygons().len() < 2 {
            return Vec::new();
        }
        let mesh = Mesh::flat(self, |p| p.extend(0.0));
        let corners = mesh.welded_corners(SAME);
        let mut ends: Vec<(u32, u32)> = Vec::with_capacity(corners.len());
        let mut first = 0;
        for ring in self.polygons().iter().flat_map(|polygon| polygon.rings()) {
            let ring = &corners[first..first + ring.len()];
            ends.extend(ring.iter().copied().zip(ring.iter().copied().cycle().skip(1)));
            first += ring.len();
        }
        let by_ends: HashMap<(u32, u32), usize> = ends.iter().copied().zip(0..).collect();
        ends.iter().map(|(from, to)| by_ends.get(&(*to, *from)).copied()).collect()
    }
}
