//! Where things lie in a polygon: inside or out, nearest edges, centroids, inner points, simple forms.
//!
//! Everything is linear in the number of vertices unless said otherwise. The rim belongs to the inside.

use crate::geometry::cut::is_convex;
use crate::geometry::{Area, Polygon};
use glam::DVec2;
use std::collections::BinaryHeap;

/// Points nearer than this (metres) to an edge lie on it.
const ON_EDGE: f64 = 1e-9;

/// The edge nearest to a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NearestEdge {
    /// Distance to it in metres.
    pub distance: f64,
    /// Its index in `edges()`.
    pub edge: usize,
    /// The nearest point on it.
    pub foot: DVec2,
}

/// The point of the segment from `a` to `b` that is nearest to `p`.
pub fn nearest_on_segment(p: DVec2, a: DVec2, b: DVec2) -> DVec2 {
    let along = b - a;
    let length = along.length_squared();
    if length == 0.0 { a } else { a + along * ((p - a).dot(along) / length).clamp(0.0, 1.0) }
}

impl Polygon {
    /// Whether the point lies inside or on the rim (within 1e-9 m).
    pub fn contains(&self, p: DVec2) -> bool {
        let mut inside = false;
        for (a, b) in self.edges() {
            if on_edge(p, a, b) {
                return true;
            }
            if (a.y > p.y) != (b.y > p.y) {
                inside ^= ((b - a).perp_dot(p - a) > 0.0) == (b.y > a.y);
            }
        }
        inside
    }

    /// The nearest edge; ties go to the first.
    pub fn nearest_edge(&self, p: DVec2) -> NearestEdge {
        nearest(self.edges(), p)
    }

    /// Distance to the rim, from inside or outside.
    pub fn distance_to_edges(&self, p: DVec2) -> f64 {
        self.nearest_edge(p).distance
    }

    /// Centre of gravity; may lie outside a concave polygon.
    pub fn centroid(&self) -> DVec2 {
        let (area, moment) = moments(self);
        self.outer()[0] + moment / area
    }

    /// A point well inside, where a label fits: about the centre of the largest disk, to a hundredth of the size.
    ///
    /// After the search for the pole of inaccessibility by Agafonkin (2016): cells that may hold a better point are
    /// split in four. The start is the middle of a chord, which is inside whatever the form.
    pub fn interior_point(&self) -> DVec2 {
        let bounds = self.bounds();
        let size = bounds.size();
        let half = size.min_element().max(size.max_element() / 64.0) * 0.5;
        let mut best = Cell::at(self, self.chord_middle(), 0.0);
        let mut heap = BinaryHeap::new();
        for i in 0..(size.x / (2.0 * half)).ceil() as usize {
            for j in 0..(size.y / (2.0 * half)).ceil() as usize {
                heap.push(Cell::at(self, bounds.min + half * DVec2::new((2 * i + 1) as f64, (2 * j + 1) as f64), half));
            }
        }
        while let Some(cell) = heap.pop() {
            if cell.reach <= best.depth + 0.01 * size.max_element() {
                break;
            }
            for corner in [DVec2::new(-1.0, -1.0), DVec2::new(1.0, -1.0), DVec2::new(-1.0, 1.0), DVec2::ONE] {
                heap.push(Cell::at(self, cell.centre + corner * cell.half * 0.5, cell.half * 0.5));
            }
            if cell.depth > best.depth {
                best = cell;
            }
        }
        best.centre
    }

    /// Whether it has no holes and nowhere turns inwards.
    pub fn is_convex(&self) -> bool {
        !self.has_holes() && is_convex(self.outer())
    }

    /// Whether it is a rectangle: four corners (vertices that turn by more than the tolerance), each a right angle
    /// within the tolerance.
    pub fn is_rectangle(&self, tolerance_degrees: f64) -> bool {
        let ring = self.outer();
        let limit = libm::sin(tolerance_degrees.to_radians());
        let turns = (0..ring.len()).map(|i| {
            let (a, b, c) = (ring[(i + ring.len() - 1) % ring.len()], ring[i], ring[(i + 1) % ring.len()]);
            ((b - a).normalize_or_zero(), (c - b).normalize_or_zero())
        });
        let corners: Vec<_> = turns.filter(|(u, v)| u.perp_dot(*v).abs() > limit || u.dot(*v) < 0.0).collect();
        !self.has_holes() && corners.len() == 4 && corners.iter().all(|(u, v)| u.dot(*v).abs() <= limit)
    }

    /// The middle of the longest piece of a level line inside.
    fn chord_middle(&self) -> DVec2 {
        let mut levels: Vec<f64> = self.points().iter().map(|p| p.y).collect();
        levels.sort_by(f64::total_cmp);
        let gap = levels.windows(2).map(|w| (w[1] - w[0], (w[0] + w[1]) * 0.5)).max_by(|a, b| a.0.total_cmp(&b.0));
        let y = gap.map_or(levels[0], |g| g.1);
        let mut xs: Vec<f64> = self
            .edges()
            .filter(|(a, b)| (a.y > y) != (b.y > y))
            .map(|(a, b)| a.x + (b.x - a.x) * ((y - a.y) / (b.y - a.y)))
            .collect();
        xs.sort_by(f64::total_cmp);
        let widest = xs.chunks_exact(2).max_by(|a, b| (a[1] - a[0]).total_cmp(&(b[1] - b[0])));
        widest.map_or(self.outer()[0], |w| DVec2::new((w[0] + w[1]) * 0.5, y))
    }
}

impl Area {
    /// Whether the point lies in a part or on its rim (within 1e-9 m).
    pub fn contains(&self, p: DVec2) -> bool {
        self.polygons().iter().any(|part| part.contains(p))
    }

    /// The nearest edge of all parts, counted as in `edges()`; `None` for the empty area.
    pub fn nearest_edge(&self, p: DVec2) -> Option<NearestEdge> {
        (!self.is_empty()).then(|| nearest(self.edges(), p))
    }

    /// Distance to the rim, from inside or outside; infinite for the empty area.
    pub fn distance_to_edges(&self, p: DVec2) -> f64 {
        self.nearest_edge(p).map_or(f64::INFINITY, |n| n.distance)
    }

    /// Centre of gravity of all parts; `None` for the empty area.
    pub fn centroid(&self) -> Option<DVec2> {
        let origin = self.polygons().first()?.outer()[0];
        let (area, moment) = self.polygons().iter().fold((0.0, DVec2::ZERO), |(area, sum), part| {
            let (a, m) = moments(part);
            (area + a, sum + m + a * (part.outer()[0] - origin))
        });
        Some(origin + moment / area)
    }

    /// A point well inside the largest part; `None` for the empty area.
    pub fn interior_point(&self) -> Option<DVec2> {
        self.largest().map(Polygon::interior_point)
    }

    /// The part with the largest area; `None` for the empty area.
    pub fn largest(&self) -> Option<&Polygon> {
        self.polygons().iter().max_by(|a, b| a.area().total_cmp(&b.area()))
    }
}

/// A square of the search for an inner point.
struct Cell {
    centre: DVec2,
    half: f64,
    /// Distance of the centre to the rim, negative outside.
    depth: f64,
    /// No point of the cell is deeper than this.
    reach: f64,
}

impl Cell {
    fn at(polygon: &Polygon, centre: DVec2, half: f64) -> Cell {
        let distance = polygon.distance_to_edges(centre);
        let depth = if polygon.contains(centre) { distance } else { -distance };
        Cell { centre, half, depth, reach: depth + half * std::f64::consts::SQRT_2 }
    }
}

impl PartialEq for Cell {
    fn eq(&self, other: &Cell) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Cell {}

impl PartialOrd for Cell {
    fn partial_cmp(&self, other: &Cell) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Cell {
    fn cmp(&self, other: &Cell) -> std::cmp::Ordering {
        let place = |c: &Cell| [c.reach, c.centre.x, c.centre.y];
        let (a, b) = (place(self), place(other));
        a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])).then(a[2].total_cmp(&b[2]))
    }
}

fn on_edge(p: DVec2, a: DVec2, b: DVec2) -> bool {
    let (low, high) = (a.min(b) - ON_EDGE, a.max(b) + ON_EDGE);
    low.cmple(p).all() && p.cmple(high).all() && nearest_on_segment(p, a, b).distance_squared(p) <= ON_EDGE * ON_EDGE
}

fn nearest(edges: impl Iterator<Item = (DVec2, DVec2)>, p: DVec2) -> NearestEdge {
    let start = NearestEdge { distance: f64::INFINITY, edge: 0, foot: p };
    let found = edges.enumerate().fold(start, |best, (edge, (a, b))| {
        let foot = nearest_on_segment(p, a, b);
        let distance = foot.distance_squared(p);
        if distance < best.distance { NearestEdge { distance, edge, foot } } else { best }
    });
    NearestEdge { distance: found.distance.sqrt(), ..found }
}

/// Area, and area times the centroid seen from the first vertex.
fn moments(polygon: &Polygon) -> (f64, DVec2) {
    let origin = polygon.outer()[0];
    polygon.edges().fold((0.0, DVec2::ZERO), |(area, moment), (a, b)| {
        let (a, b) = (a - origin, b - origin);
        let cross = a.perp_dot(b) * 0.5;
        (area + cross, moment + (a + b) * (cross / 3.0))
    })
}
