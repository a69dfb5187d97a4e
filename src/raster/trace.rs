//! Marching squares: the outlines of what reaches a threshold on a grid of numbers.
//!
//! In: heights above the threshold at the nodes of a grid; NaN where nothing is known. Out: closed rings between the
//! nodes, in steps of the grid, sorted into patches with their holes. Along an edge of the grid the outline lies
//! where the height, interpolated, is zero; halfway where one end is unknown, or beyond the rim. Where two corners of a
//! cell are in and the two others out, the mean of the four decides whether the two are joined. Lorensen and Cline
//! 1987, in the plane. Knows no pixels and no plan.

use glam::{DVec2, I64Vec2};
use std::collections::BTreeMap;

/// Rings come no nearer to a node than this, so that no two touch there.
const CLEARANCE: f64 = 1e-3;

/// A connected patch.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Patch {
    /// Its outline.
    pub outer: Vec<DVec2>,
    /// The outlines of its holes.
    pub holes: Vec<Vec<DVec2>>,
}

/// Heights above the threshold, row by row.
pub struct Heights {
    size: [usize; 2],
    values: Vec<f32>,
}

impl Heights {
    /// The heights of a grid of that many columns and rows.
    pub fn new(size: [usize; 2], values: Vec<f32>) -> Heights {
        debug_assert_eq!(values.len(), size[0] * size[1]);
        Heights { size, values }
    }

    /// The patches at or above zero, in the order of their first rows. Cost: linear in the nodes.
    pub fn patches(&self) -> Vec<Patch> {
        let mut pieces = self.pieces();
        let mut patches: BTreeMap<u32, Patch> = BTreeMap::new();
        let mut seen = vec![false; self.values.len()];
        for index in 0..self.values.len() {
            let node = self.node(index);
            if seen[index] || !self.is_in(node) || self.is_in(node + I64Vec2::X) {
                continue;
            }
            let ring = self.ring(node, &mut seen);
            let patch = patches.entry(pieces.of(index as u32)).or_default();
            // With y downwards, what has its inside to the left runs clockwise in the sense of the area.
            let is_outer = crate::geometry::ring_area(&ring) < 0.0;
            if is_outer { patch.outer = ring } else { patch.holes.push(ring) }
        }
        patches.into_values().filter(|patch| !patch.outer.is_empty()).collect()
    }

    fn node(&self, index: usize) -> I64Vec2 {
        I64Vec2::new((index % self.size[0]) as i64, (index / self.size[0]) as i64)
    }

    fn index(&self, node: I64Vec2) -> Option<usize> {
        let is_on = node.x >= 0 && node.y >= 0 && node.x < self.size[0] as i64 && node.y < self.size[1] as i64;
        is_on.then(|| node.y as usize * self.size[0] + node.x as usize)
    }

    /// The height of a node; NaN beyond the rim.
    fn height(&self, node: I64Vec2) -> f64 {
        self.index(node).map_or(f64::NAN, |index| self.values[index].into())
    }

    fn is_in(&self, node: I64Vec2) -> bool {
        self.height(node) >= 0.0
    }

    /// Whether the corners of a cell that are in hang together across it; it is named by its least corner.
    fn is_joined(&self, cell: I64Vec2) -> bool {
        let corners = [I64Vec2::ZERO, I64Vec2::X, I64Vec2::Y, I64Vec2::ONE];
        corners.iter().map(|corner| self.height(cell + *corner)).sum::<f64>() >= 0.0
    }

    /// The ring that passes between a node that is in and the next one to the right, its inside to the left of the
    /// way. Marks every such node on the way as seen.
    fn ring(&self, start: I64Vec2, seen: &mut [bool]) -> Vec<DVec2> {
        let mut ring = Vec::new();
        let (mut inner, mut outer) = (start, start + I64Vec2::X);
        loop {
            if let Some(index) = self.index(inner).filter(|_| outer - inner == I64Vec2::X) {
                seen[index] = true;
            }
            ring.push(self.crossing(inner, outer));
            (inner, outer) = self.next(inner, outer);
            if (inner, outer) == (start, start + I64Vec2::X) {
                return ring;
            }
        }
    }

    /// From between two nodes across the cell ahead: where the ring leaves it.
    fn next(&self, inner: I64Vec2, outer: I64Vec2) -> (I64Vec2, I64Vec2) {
        let across = outer - inner;
        let ahead = I64Vec2::new(across.y, -across.x);
        let (inner_ahead, outer_ahead) = (inner + ahead, outer + ahead);
        match (self.is_in(inner_ahead), self.is_in(outer_ahead)) {
            (true, false) => (inner_ahead, outer_ahead),
            (false, false) => (inner, inner_ahead),
            (true, true) => (outer_ahead, outer),
            (false, true) => match self.is_joined(inner.min(outer_ahead)) {
                true => (outer_ahead, outer),
                false => (inner, inner_ahead),
            },
        }
    }

    /// Where the height between a node that is in and one that is not is zero.
    fn crossing(&self, inner: I64Vec2, outer: I64Vec2) -> DVec2 {
        let (high, low) = (self.height(inner), self.height(outer));
        let share = if low.is_finite() && high.is_finite() { high / (high - low) } else { 0.5 };
        inner.as_dvec2() + (outer - inner).as_dvec2() * share.clamp(CLEARANCE, 1.0 - CLEARANCE)
    }

    /// Which nodes hang together.
    fn pieces(&self) -> Pieces {
        let mut pieces = Pieces((0..self.values.len() as u32).collect());
        for index in 0..self.values.len() {
            let node = self.node(index);
            let corners = [I64Vec2::ZERO, I64Vec2::X, I64Vec2::Y, I64Vec2::ONE].map(|corner| node + corner);
            let mut join = |a: usize, b: usize| {
                let ends = (self.index(corners[a]), self.index(corners[b]));
                if let (Some(from), Some(to)) = ends
                    && self.is_in(corners[a])
                    && self.is_in(corners[b])
                {
                    pieces.join(from as u32, to as u32);
                }
            };
            join(0, 1);
            join(0, 2);
            let [a, b, c, d] = corners.map(|corner| self.is_in(corner));
            if a == d && b == c && a != b && self.is_joined(node) {
                if a { join(0, 3) } else { join(1, 2) }
            }
        }
        pieces
    }
}

/// Sets of nodes that grow together.
struct Pieces(Vec<u32>);

impl Pieces {
    /// The name of the set of a node: its least member.
    fn of(&mut self, mut node: u32) -> u32 {
        while self.0[node as usize] != node {
            self.0[node as usize] = self.0[self.0[node as usize] as usize];
            node = self.0[node as usize];
        }
        node
    }

    fn join(&mut self, a: u32, b: u32) {
        let (a, b) = (self.of(a), self.of(b));
        self.0[a.max(b) as usize] = a.min(b);
    }
}
