//! Convex hulls and the least rectangle around points.

use crate::geometry::{Area, Polygon};
use glam::{DVec2, Vec2Swizzles};

/// A rectangle at any angle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrientedBox {
    /// The middle.
    pub centre: DVec2,
    /// Unit vector along the longer side; the other axis is `axis.perp()`.
    pub axis: DVec2,
    /// Length along the axis, and across.
    pub size: DVec2,
}

/// The convex hull, counter-clockwise without collinear points; fewer than three points where all lie on a line.
///
/// Andrew's monotone chain, n log n. Points that are not finite are left out.
pub fn convex_hull(points: &[DVec2]) -> Vec<DVec2> {
    let mut sorted: Vec<DVec2> = points.iter().copied().filter(|p| p.is_finite()).collect();
    sorted.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    sorted.dedup();
    if sorted.len() < 3 {
        return sorted;
    }
    let mut hull = half_hull(sorted.iter().copied());
    hull.pop();
    hull.extend(half_hull(sorted.iter().rev().copied()));
    hull.pop();
    hull
}

impl OrientedBox {
    /// The rectangle of least area around the points; ties go to the side first met. `None` without a finite point.
    ///
    /// Quadratic in the corners of the hull, which are few.
    pub fn around(points: &[DVec2]) -> Option<OrientedBox> {
        let hull = convex_hull(points);
        let first = *hull.first()?;
        let edges = (0..hull.len()).map(|i| hull[(i + 1) % hull.len()] - hull[i]);
        let axes = edges.filter_map(DVec2::try_normalize);
        let boxes = axes.map(|axis| OrientedBox::along(&hull, axis));
        // A hair of slack, so that rounding does not choose among the sides of a rectangle.
        let least = boxes.reduce(|a, b| if b.area() < a.area() * (1.0 - 1e-9) { b } else { a });
        Some(least.unwrap_or(OrientedBox { centre: first, axis: DVec2::X, size: DVec2::ZERO }))
    }

    /// Area in m².
    pub fn area(&self) -> f64 {
        self.size.x * self.size.y
    }

    /// The four corners, counter-clockwise.
    pub fn corners(&self) -> [DVec2; 4] {
        let (u, v) = (self.axis * self.size.x * 0.5, self.axis.perp() * self.size.y * 0.5);
        [self.centre - u - v, self.centre + u - v, self.centre + u + v, self.centre - u + v]
    }

    fn along(points: &[DVec2], axis: DVec2) -> OrientedBox {
        let (left, right) = crate::geometry::cut::extent(points, axis);
        let (low, high) = crate::geometry::cut::extent(points, axis.perp());
        let centre = axis * (left + right) * 0.5 + axis.perp() * (low + high) * 0.5;
        let size = DVec2::new(right - left, high - low);
        if size.x >= size.y {
            OrientedBox { centre, axis, size }
        } else {
            OrientedBox { centre, axis: axis.perp(), size: size.yx() }
        }
    }
}

impl Polygon {
    /// The convex hull of the outer ring.
    pub fn hull(&self) -> Polygon {
        Polygon::new(&convex_hull(self.outer()), &[]).unwrap_or_else(|| self.clone())
    }

    /// The rectangle of least area around it.
    pub fn oriented_box(&self) -> Option<OrientedBox> {
        OrientedBox::around(self.outer())
    }
}

impl Area {
    /// The rectangle of least area around all parts; `None` for the empty area.
    pub fn oriented_box(&self) -> Option<OrientedBox> {
        let points: Vec<DVec2> = self.polygons().iter().flat_map(|p| p.outer().iter().copied()).collect();
        OrientedBox::around(&points)
    }
}

fn half_hull(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut chain: Vec<DVec2> = Vec::new();
    for p in points {
        while let [.., a, b] = chain[..] {
            if (b - a).perp_dot(p - b) > 0.0 {
                break;
            }
            chain.pop();
        }
        chain.push(p);
    }
    chain
}
