//! Polylines: points along them, pieces of them, the region along them.

use crate::geometry::overlay::{Corner, stroked};
use crate::geometry::{Area, Polygon, nearest_on_segment};
use glam::DVec2;

/// A polyline of at least two distinct points, metres, with its lengths added up.
#[derive(Clone, Debug, PartialEq)]
pub struct Path {
    points: Vec<DVec2>,
    /// Distance of each point from the start along the line.
    starts: Vec<f64>,
}

impl Path {
    /// The line through the points; repeated ones are dropped. `None` where fewer than two are left or a number is
    /// not finite.
    pub fn new(points: &[DVec2]) -> Option<Path> {
        let mut points = points.to_vec();
        points.dedup();
        if points.len() < 2 || points.iter().any(|p| !p.is_finite()) {
            return None;
        }
        let mut starts = vec![0.0];
        for pair in points.windows(2) {
            starts.push(starts[starts.len() - 1] + pair[0].distance(pair[1]));
        }
        Some(Path { points, starts })
    }

    /// The points.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// Length in metres.
    pub fn length(&self) -> f64 {
        self.starts[self.starts.len() - 1]
    }

    /// The point at a distance from the start along the line, and the unit direction there; distances beyond the
    /// ends give the ends. Logarithmic.
    pub fn at(&self, distance: f64) -> (DVec2, DVec2) {
        let segment = self.segment(distance);
        let (a, b) = (self.points[segment], self.points[segment + 1]);
        let length = self.starts[segment + 1] - self.starts[segment];
        let share = ((distance - self.starts[segment]) / length).clamp(0.0, 1.0);
        (a.lerp(b, share), (b - a).normalize())
    }

    /// The part between two distances along the line; `None` where nothing is between.
    pub fn piece(&self, from: f64, to: f64) -> Option<Path> {
        let (from, to) = (from.max(0.0), to.min(self.length()));
        (from < to).then_some(())?;
        let inner = self.points.iter().zip(&self.starts).filter(|(_, s)| **s > from && **s < to).map(|(p, _)| *p);
        let points: Vec<DVec2> =
            std::iter::once(self.at(from).0).chain(inner).chain(std::iter::once(self.at(to).0)).collect();
        Path::new(&points)
    }

    /// Evenly spaced points from end to end, at most `spacing` apart along the line; both ends where the spacing is
    /// not positive.
    pub fn resampled(&self, spacing: f64) -> Vec<DVec2> {
        let steps = if spacing > 0.0 { (self.length() / spacing - 1e-9).ceil().max(1.0) } else { 1.0 };
        (0..=steps as usize).map(|i| self.at(self.length() * i as f64 / steps).0).collect()
    }

    /// The nearest point of the line: its distance along the line, and the point.
    pub fn nearest(&self, p: DVec2) -> (f64, DVec2) {
        let feet = self.points.windows(2).enumerate().map(|(i, w)| (i, nearest_on_segment(p, w[0], w[1])));
        let nearest = feet.min_by(|a, b| a.1.distance_squared(p).total_cmp(&b.1.distance_squared(p)));
        let (segment, foot) = nearest.unwrap_or((0, self.points[0]));
        (self.starts[segment] + self.points[segment].distance(foot), foot)
    }

    /// Distance from a point to the line.
    pub fn distance_to(&self, p: DVec2) -> f64 {
        self.nearest(p).1.distance(p)
    }

    /// The segment a distance falls into.
    fn segment(&self, distance: f64) -> usize {
        self.starts.partition_point(|s| *s <= distance).clamp(1, self.points.len() - 1) - 1
    }
}

/// The region within half the width of a line, with mitred joins and flat ends; a line that ends where it began is
/// closed. Empty where the line has no length or the width is not positive.
pub fn stroke(line: &[DVec2], width: f64) -> Area {
    let mut points: Vec<DVec2> = line.iter().copied().filter(|p| p.is_finite()).collect();
    points.dedup();
    if !(width > 0.0 && width.is_finite()) {
        return Area::empty();
    }
    match points[..] {
        [] | [_] => Area::empty(),
        [a, b] => plank(a, b, width),
        [first, .., last] if first == last => stroked(&points[1..], width, Corner::Mitre, true),
        _ => stroked(&points, width, Corner::Mitre, false),
    }
}

/// A rectangle around a segment.
fn plank(a: DVec2, b: DVec2, width: f64) -> Area {
    let side = (b - a).normalize_or_zero().perp() * (width * 0.5);
    Polygon::new(&[a - side, b - side, b + side, a + side], &[]).into_iter().collect()
}
