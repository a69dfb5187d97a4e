//! The straight skeleton of a polygon (Aichholzer et al. 1995), weighted: the roof over an outline.
//!
//! Every edge moves inwards at its own speed, and what it sweeps is its face. In: a simple polygon with holes and a
//! speed for each edge. Out: nodes on the plan, each with the time at which the moving edges came there, and one face
//! for each edge. Heights are times the tangent of the slope; who makes roofs of it does not matter here.

mod faces;
mod wavefront;

use crate::geometry::Polygon;
use glam::{DVec2, DVec3};
use wavefront::Wavefront;

/// What the search of events may cost: corners² times concave corners.
const MOST_WORK: f64 = 4e8;

/// The faces that the edges of a polygon sweep.
#[derive(Clone, Debug, PartialEq)]
pub struct StraightSkeleton {
    /// On the plan, and as z the time: the corners of the polygon first, at 0.
    pub nodes: Vec<DVec3>,
    /// For each edge its face as nodes, counter-clockwise from the start of the edge. An edge that stands still has a
    /// face without area on the plan.
    pub faces: Vec<Vec<u32>>,
}

/// Why there is no skeleton.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Unskeletal {
    /// The outline has more corners than can be followed.
    TooLarge,
    /// The edges' speeds contradict each other, or the outline crosses itself.
    Contradiction,
}

impl StraightSkeleton {
    /// The skeleton of a polygon whose edges move at these speeds (metres per unit of time, 0 or more; 1 for missing
    /// ones). Cost: quadratic in the corners, times the concave ones.
    pub fn of(polygon: &Polygon, speeds: &[f64]) -> Result<StraightSkeleton, Unskeletal> {
        let corners = polygon.points().len() as f64;
        let concave = concave_corners(polygon) as f64;
        if corners * corners * (concave + 1.0) > MOST_WORK {
            return Err(Unskeletal::TooLarge);
        }
        let skeleton = Wavefront::new(polygon, speeds).run().and_then(faces::chained);
        skeleton.filter(|skeleton| skeleton.covers(polygon)).ok_or(Unskeletal::Contradiction)
    }

    /// The greatest time of a node.
    pub fn latest(&self) -> f64 {
        self.nodes.iter().map(|node| node.z).fold(0.0, f64::max)
    }

    /// Whether the faces cover the polygon once.
    fn covers(&self, polygon: &Polygon) -> bool {
        let area = |face: &Vec<u32>| {
            let ring: Vec<DVec2> = face.iter().map(|node| self.nodes[*node as usize].truncate()).collect();
            crate::geometry::ring_area(&ring)
        };
        let areas: Vec<f64> = self.faces.iter().map(area).collect();
        let slack = 1e-6 * (polygon.area() + polygon.perimeter());
        areas.iter().all(|area| *area > -slack) && (areas.iter().sum::<f64>() - polygon.area()).abs() <= slack
    }
}

fn concave_corners(polygon: &Polygon) -> usize {
    let concave = |ring: &[DVec2]| {
        let count = ring.len();
        (0..count)
            .filter(|i| {
                let (a, b, c) = (ring[(i + count - 1) % count], ring[*i], ring[(i + 1) % count]);
                (b - a).perp_dot(c - b) < 0.0
            })
            .count()
    };
    polygon.rings().map(concave).sum()
}
