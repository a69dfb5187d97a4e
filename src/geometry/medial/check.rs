//! Whether a skeleton is what it says: inside, as far from the rim as it says, connected, a loop for each hole.

use crate::geometry::medial::outline::{Joined, Outline};
use crate::geometry::medial::skeleton::{Bead, Skeleton};
use crate::geometry::{Bounds, BoxGrid, Polygon, nearest_on_segment};
use glam::DVec2;

/// Clearances are true to this, metres.
const TRUE_TO: f64 = 0.002;

/// The edges of a polygon, found by place.
pub(super) struct Rim<'a> {
    polygon: &'a Polygon,
    edges: Vec<(DVec2, DVec2)>,
    grid: BoxGrid,
}

impl Rim<'_> {
    pub fn new(polygon: &Polygon) -> Rim<'_> {
        let edges: Vec<_> = polygon.edges().collect();
        let boxes: Vec<Bounds> = edges.iter().map(|(a, b)| Bounds::of([*a, *b])).collect();
        Rim { polygon, edges, grid: BoxGrid::new(&boxes) }
    }

    /// Whether the skeleton passes every check.
    pub fn proves(&self, skeleton: &Skeleton, outline: &Outline) -> bool {
        has_form(skeleton, outline.pieces, outline.loops)
            && skeleton.nodes.iter().chain(&skeleton.beads).all(|bead| self.clears(bead))
            && skeleton.nodes.first().is_some_and(|bead| self.polygon.contains(bead.point))
    }

    /// Whether the rim is as far as it says. A connected skeleton that nowhere crosses the rim is inside where one point
    /// is; only ends in corners come so near to the rim that their side does not matter.
    fn clears(&self, bead: &Bead) -> bool {
        (self.distance(bead.point, bead.clearance + TRUE_TO) - bead.clearance).abs() <= TRUE_TO
    }

    /// The distance to the rim, looked for within `reach`; infinite beyond.
    fn distance(&self, p: DVec2, reach: f64) -> f64 {
        let box_of = Bounds { min: p - reach, max: p + reach };
        let square = |i: usize| nearest_on_segment(p, self.edges[i].0, self.edges[i].1).distance_squared(p);
        self.grid.touching(box_of).map(square).fold(f64::INFINITY, f64::min).sqrt()
    }

    /// A point with its distance to the rim. Linear.
    pub fn bead(&self, point: DVec2) -> Bead {
        Bead { point, clearance: self.polygon.distance_to_edges(point) }
    }
}

/// Whether it has so many pieces and so many loops.
fn has_form(skeleton: &Skeleton, pieces: usize, loops: usize) -> bool {
    let mut joined = Joined::new(skeleton.nodes.len());
    let trees = skeleton.links.iter().filter(|link| joined.join(link.ends[0], link.ends[1])).count();
    skeleton.nodes.len() - trees == pieces && skeleton.links.len() - trees == loops
}
