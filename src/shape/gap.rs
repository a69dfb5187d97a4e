//! How far shapes are from each other: exact, from outline to outline on the plan and from height to height.

use crate::geometry::nearest_on_segment;
use crate::shape::{Extent, Footprint};
use glam::DVec2;

type Segment = (DVec2, DVec2);

impl Footprint {
    /// Distance to another in metres, 0 where they meet; infinite where one of them is nothing. Cost: the product of
    /// their edges.
    pub fn distance(&self, other: &Footprint) -> f64 {
        let above = (other.low - self.high).max(self.low - other.high).max(0.0);
        libm::hypot(self.extent.distance(&other.extent), above)
    }
}

impl Extent {
    /// Distance on the plan in metres, 0 where they overlap or touch; infinite where one of them is nothing.
    pub fn distance(&self, other: &Extent) -> f64 {
        let (own, others) = (self.segments(), other.segments());
        let holds = |area: &Extent, segments: &[Segment]| match (area, segments.first()) {
            (Extent::Area(area), Some((point, _))) => area.contains(*point),
            _ => false,
        };
        if holds(self, &others) || holds(other, &own) {
            return 0.0;
        }
        let apart = own.iter().flat_map(|a| others.iter().map(|b| segment_distance(*a, *b)));
        apart.fold(f64::INFINITY, f64::min)
    }

    /// Area in m²; 0 for lines and points.
    pub fn area(&self) -> f64 {
        match self {
            Extent::Area(area) => area.area(),
            _ => 0.0,
        }
    }

    fn segments(&self) -> Vec<Segment> {
        match self {
            Extent::Nothing => Vec::new(),
            Extent::Point(point) => vec![(*point, *point)],
            Extent::Line(points) => points.windows(2).map(|w| (w[0], w[1])).collect(),
            Extent::Area(area) => area.edges().collect(),
        }
    }
}

fn segment_distance((a, b): Segment, (c, d): Segment) -> f64 {
    let sides = |p: DVec2, q: DVec2, r: DVec2, s: DVec2| (q - p).perp_dot(r - p) * (q - p).perp_dot(s - p) < 0.0;
    if sides(a, b, c, d) && sides(c, d, a, b) {
        return 0.0;
    }
    let foot = |p: DVec2, q: DVec2, r: DVec2| nearest_on_segment(p, q, r).distance(p);
    foot(a, c, d).min(foot(b, c, d)).min(foot(c, a, b)).min(foot(d, a, b))
}
