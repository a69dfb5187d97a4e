//! Concave polygons taken apart into convex ones.
//!
//! From a corner that turns inwards one of its edges is prolonged to where it meets the outline again; that always
//! mends the corner and adds none. Of some such corners the shortest cut is made first, which keeps wings whole.

use crate::geometry::cut::{Line, nest};
use crate::geometry::{Area, Polygon};
use glam::DVec2;

/// A corner that turns inwards by less than this sine is straight.
const STRAIGHT: f64 = 1e-9;

/// So many corners are compared for the shortest cut.
const COMPARED: usize = 16;

/// The polygon as convex parts that sum to it; cuts longer than `longest` metres are not made, so parts may stay
/// concave. At holes a cut goes on to the other side. Quadratic in the vertices.
pub fn convexify(polygon: &Polygon, longest: f64) -> Area {
    let (mut open, mut parts) = (vec![polygon.clone()], Area::empty());
    // Every cut mends a corner; the count is a guard against rounding.
    let mut left = 2 * polygon.points().len();
    while let Some(part) = open.pop() {
        match cut(&part, longest).filter(|_| left > 0) {
            Some(cut) => {
                left -= 1;
                open.extend(cut.apply(&part));
            }
            None => parts.push(part),
        }
    }
    parts
}

/// A cut from a corner along one of its edges.
struct Cut {
    from: DVec2,
    along: DVec2,
    length: f64,
    /// The corner in the outline and the edge of the outline that is met; none where a hole has a part in it.
    across: Option<(usize, usize)>,
}

/// The shortest cut that mends a corner.
fn cut(polygon: &Polygon, longest: f64) -> Option<Cut> {
    let mut first = 0;
    let mut cuts: Vec<Cut> = Vec::new();
    for ring in polygon.rings() {
        let corners = (0..ring.len()).filter_map(|i| Some((i, inward(ring, i)?))).take(COMPARED);
        for (corner, ways) in corners {
            cuts.extend(
                ways.into_iter().filter_map(|way| met(polygon, ring[corner], way, (first == 0).then_some(corner))),
            );
        }
        first += ring.len();
    }
    let short = cuts.into_iter().filter(|cut| cut.length <= longest);
    short.min_by(|a, b| a.length.total_cmp(&b.length))
}

/// Where the edges of a corner go on to; `None` where it does not turn inwards.
fn inward(ring: &[DVec2], corner: usize) -> Option<[DVec2; 2]> {
    let count = ring.len();
    let before = (ring[corner] - ring[(corner + count - 1) % count]).try_normalize()?;
    let after = (ring[(corner + 1) % count] - ring[corner]).try_normalize()?;
    (before.perp_dot(after) < -STRAIGHT).then_some([before, -after])
}

/// The cut from a corner to the nearest edge on its way.
fn met(polygon: &Polygon, from: DVec2, along: DVec2, corner: Option<usize>) -> Option<Cut> {
    let outer = polygon.outer().len();
    let reach = |(edge, (a, b)): (usize, (DVec2, DVec2))| {
        let side = b - a;
        let across = along.perp_dot(side);
        // Edges that begin or end in the corner, or run along the cut, do not end it.
        if a == from || b == from || across.abs() < STRAIGHT * side.length() {
            return None;
        }
        let (length, share) = ((a - from).perp_dot(side) / across, (a - from).perp_dot(along) / across);
        let slack = 1e-9 / side.length();
        (length > 1e-9 && (-slack..=1.0 + slack).contains(&share)).then_some((length, edge))
    };
    let (length, edge) = polygon.edges().enumerate().filter_map(reach).min_by(|a, b| a.0.total_cmp(&b.0))?;
    let across = corner.filter(|_| edge < outer).map(|corner| (corner, edge));
    Some(Cut { from, along, length, across })
}

impl Cut {
    fn apply(&self, polygon: &Polygon) -> Vec<Polygon> {
        let mut parts = Area::empty();
        match self.across {
            Some((corner, edge)) => {
                let holes = polygon.holes().map(<[DVec2]>::to_vec).collect();
                nest(self.halves(polygon.outer(), corner, edge), holes, &mut parts);
            }
            None => {
                let normal = self.along.perp();
                for beyond in [false, true] {
                    Line::new(normal, self.from.dot(normal), beyond).clip_polygon(polygon, &mut parts);
                }
            }
        }
        parts.into_polygons().collect()
    }

    /// The outline in two, from the corner to a point of an edge.
    fn halves(&self, ring: &[DVec2], corner: usize, edge: usize) -> Vec<Vec<DVec2>> {
        let count = ring.len();
        let met = self.from + self.along * self.length;
        let steps = (edge + count - corner) % count;
        let mut first: Vec<DVec2> = (0..=steps).map(|i| ring[(corner + i) % count]).collect();
        first.push(met);
        let mut second: Vec<DVec2> = (steps + 1..=count).map(|i| ring[(corner + i) % count]).collect();
        second.push(met);
        vec![first, second]
    }
}
