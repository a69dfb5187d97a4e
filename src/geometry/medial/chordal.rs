//! The chordal axis: what is drawn where the Voronoi diagram cannot be had.
//!
//! In: a polygon. Out: a skeleton through the triangles of a constrained triangulation of its densely set rim, from the
//! middle of one inner edge to the next. Always inside; away from the true axis by a share of the step of the rim.

use crate::geometry::Polygon;
use crate::geometry::medial::check::Rim;
use crate::geometry::medial::skeleton::{Link, Skeleton};
use glam::DVec2;
use smallvec::SmallVec;
use spade::handles::FixedVertexHandle;
use spade::{ConstrainedDelaunayTriangulation, Point2, Triangulation};

/// Metres between points of the rim at most, unless there would be more than [`MOST_STEPS`].
const STEP: f64 = 0.5;

/// Points on the rim at most, corners not counted.
const MOST_STEPS: f64 = 4000.0;

/// Triangles whose centres are nearer than this (metres) to the rim come from rounding, on either side of it.
const SLIVER: f64 = 1e-6;

type Mesh = ConstrainedDelaunayTriangulation<Point2<f64>>;

/// The skeleton; without nodes where nothing can be triangulated. Costs vertices times triangles.
pub(super) fn skeleton(polygon: &Polygon, rim: &Rim) -> Skeleton {
    let mesh = triangulated(polygon);
    let mut numbers = vec![u32::MAX; mesh.num_all_faces()];
    let mut skeleton = Skeleton::default();
    for face in mesh.inner_faces() {
        let centre = rim.bead(plan(face.center()));
        if centre.clearance > SLIVER && polygon.contains(centre.point) {
            numbers[face.fix().index()] = skeleton.nodes.len() as u32;
            let inner: SmallVec<[DVec2; 3]> = face
                .adjacent_edges()
                .iter()
                .filter(|e| !e.is_constraint_edge())
                .map(|e| middle(e.positions()))
                .collect();
            // Between two inner edges the axis goes straight on.
            let node = if let [a, b] = inner[..] { rim.bead((a + b) * 0.5) } else { centre };
            skeleton.nodes.push(node);
        }
    }
    for edge in mesh.undirected_edges().filter(|edge| !edge.is_constraint_edge()) {
        let sides = [edge.as_directed().face(), edge.as_directed().rev().face()];
        let ends = sides.map(|face| numbers[face.fix().index()]);
        if ends.contains(&u32::MAX) {
            continue;
        }
        let first = skeleton.beads.len() as u32;
        skeleton.beads.push(rim.bead(middle(edge.positions())));
        skeleton.links.push(Link { ends, inner: [first, first + 1] });
    }
    skeleton
}

fn plan(p: Point2<f64>) -> DVec2 {
    DVec2::new(p.x, p.y)
}

fn middle([a, b]: [Point2<f64>; 2]) -> DVec2 {
    (plan(a) + plan(b)) * 0.5
}

fn triangulated(polygon: &Polygon) -> Mesh {
    let mut mesh = Mesh::new();
    let step = STEP.max(polygon.perimeter() / MOST_STEPS);
    for ring in polygon.rings() {
        let corners: Vec<_> = ring.iter().map(|p| insert(&mut mesh, *p)).collect();
        for i in 0..ring.len() {
            let (a, b) = (ring[i], ring[(i + 1) % ring.len()]);
            let count = (a.distance(b) / step).ceil().clamp(1.0, MOST_STEPS) as u32;
            let mut last = corners[i];
            for k in 1..=count {
                let next = if k == count {
                    corners[(i + 1) % ring.len()]
                } else {
                    insert(&mut mesh, a.lerp(b, f64::from(k) / f64::from(count)))
                };
                join(&mut mesh, last, next);
                last = next;
            }
        }
    }
    mesh
}

/// Adds a point, unless it is beyond the range of the triangulation.
fn insert(mesh: &mut Mesh, p: DVec2) -> Option<FixedVertexHandle> {
    mesh.insert(Point2::new(p.x, p.y)).ok()
}

fn join(mesh: &mut Mesh, from: Option<FixedVertexHandle>, to: Option<FixedVertexHandle>) {
    if let (Some(from), Some(to)) = (from, to)
        && from != to
        && mesh.can_add_constraint(from, to)
    {
        mesh.add_constraint(from, to);
    }
}
