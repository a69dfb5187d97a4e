//! The edges of a mesh, and whether it is closed.

use crate::geometry::Mesh;

/// An edge with the faces on its two sides.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Edge {
    /// Where it starts as seen from its left face.
    pub from: u32,
    /// Where it ends.
    pub to: u32,
    /// The face that runs along it from `from` to `to`.
    pub left: u32,
    /// The face that runs along it the other way; none at the border of an open mesh.
    pub right: Option<u32>,
}

impl Mesh {
    /// Every edge once, in the order of its vertices; n log n.
    ///
    /// Where more than two faces meet, they are paired in their order.
    pub fn edges(&self) -> Vec<Edge> {
        let mut halves = self.half_edges();
        halves.sort_unstable();
        let mut edges = Vec::with_capacity(halves.len() / 2);
        let same = |a: &Half, b: &Half| (a.low, a.high) == (b.low, b.high);
        for group in halves.chunk_by(same) {
            let (down, up) = group.split_at(group.partition_point(|h| !h.upward));
            let shared = down.len().min(up.len());
            let pair = |(u, d): (&Half, &Half)| u.edge(Some(d.face));
            edges.extend(up.iter().zip(down).map(pair));
            edges.extend(up[shared..].iter().chain(&down[shared..]).map(|h| h.edge(None)));
        }
        edges
    }

    /// Whether it encloses a volume: every edge has a face on both sides. An empty mesh does not.
    pub fn is_closed(&self) -> bool {
        !self.faces.is_empty() && self.edges().iter().all(|e| e.right.is_some())
    }

    fn half_edges(&self) -> Vec<Half> {
        let mut halves = Vec::with_capacity(self.corners.len());
        for (face, rings) in self.faces().enumerate() {
            for ring in rings.rings() {
                let ends = ring.iter().zip(ring.iter().cycle().skip(1));
                halves.extend(ends.map(|(a, b)| Half {
                    low: *a.min(b),
                    high: *a.max(b),
                    upward: a < b,
                    face: face as u32,
                }));
            }
        }
        halves
    }
}

/// One side of an edge.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Half {
    low: u32,
    high: u32,
    upward: bool,
    face: u32,
}

impl Half {
    fn edge(&self, right: Option<u32>) -> Edge {
        let (from, to) = if self.upward { (self.low, self.high) } else { (self.high, self.low) };
        Edge { from, to, left: self.face, right }
    }
}
