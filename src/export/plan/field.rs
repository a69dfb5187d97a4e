//! Evenly strewn marks and parallel lines inside a region on paper.
//!
//! Everything is in millimetres on paper, so a texture looks the same at every scale. Points come from a jittered
//! grid, chosen inside by parity against the edges near their row: linear in rows × edges per row, never in
//! points × edges. The number of marks is bounded: a huge region gets wider cells, not more marks.

use crate::geometry::{Area, Bounds};
use crate::seed::{Random, Seed};
use glam::DVec2;

/// The most marks in one region.
const MOST_MARKS: f64 = 24_000.0;

/// Points about `cell` apart, inside the region and the window, at least `margin` from the edges.
pub fn strewn(area: &Area, window: Bounds, cell: f64, margin: f64, seed: Seed) -> Vec<(DVec2, Random)> {
    let bounds = meet(area.bounds(), window);
    if bounds.is_empty() {
        return Vec::new();
    }
    let size = bounds.size();
    let cell = cell.max((size.x * size.y / MOST_MARKS).sqrt());
    // The grid is anchored to the region, not to the window, so that another cut-out shows the same marks.
    let origin = area.bounds().min;
    let index = |value: f64| (value / cell).floor() as i64;
    let (low, high) = (bounds.min - origin, bounds.max - origin);
    let mut points = Vec::new();
    for row in index(low.y)..=index(high.y) {
        let top = origin.y + row as f64 * cell;
        let edges = edges_between(area, top - margin, top + cell + margin);
        for column in index(low.x)..=index(high.x) {
            let mut random = seed.child(row as u64).child(column as u64).random();
            let jitter = DVec2::new(random.uniform(0.1, 0.9), random.uniform(0.1, 0.9));
            let point = DVec2::new(origin.x + (column as f64 + jitter.x) * cell, top + jitter.y * cell);
            if is_inside(&edges, point, margin) {
                points.push((point, random));
            }
        }
    }
    points
}

/// The stretches of parallel lines inside the region: `spacing` apart, along the unit vector `along`.
pub fn hatched(area: &Area, along: DVec2, spacing: f64, offset: f64) -> Vec<[DVec2; 2]> {
    let across = along.perp();
    let reach = Bounds::of(area.edges().map(|(a, _)| DVec2::new(a.dot(along), a.dot(across))));
    if reach.is_empty() {
        return Vec::new();
    }
    let spacing = spacing.max(reach.size().y / 2_000.0);
    let first = ((reach.min.y - offset) / spacing).ceil() as i64;
    let last = ((reach.max.y - offset) / spacing).floor() as i64;
    let mut lines = Vec::new();
    for number in first..=last {
        let level = offset + number as f64 * spacing;
        let crossings = crossings(area, along, across, level);
        lines.extend(crossings.chunks_exact(2).map(|c| [along * c[0] + across * level, along * c[1] + across * level]));
    }
    lines
}

/// The part of `a` inside of `b`.
pub fn meet(a: Bounds, b: Bounds) -> Bounds {
    Bounds { min: a.min.max(b.min), max: a.max.min(b.max) }
}

fn crossings(area: &Area, along: DVec2, across: DVec2, level: f64) -> Vec<f64> {
    let mut found: Vec<f64> = area
        .edges()
        .filter_map(|(a, b)| {
            let (from, to) = (a.dot(across), b.dot(across));
            ((from > level) != (to > level)).then(|| a.lerp(b, (level - from) / (to - from)).dot(along))
        })
        .collect();
    found.sort_by(f64::total_cmp);
    found
}

fn edges_between(area: &Area, top: f64, bottom: f64) -> Vec<(DVec2, DVec2)> {
    area.edges().filter(|(a, b)| a.y.min(b.y) <= bottom && a.y.max(b.y) >= top).collect()
}

/// Whether the point is inside by parity, and no edge nearer than `margin`.
fn is_inside(edges: &[(DVec2, DVec2)], point: DVec2, margin: f64) -> bool {
    let mut inside = false;
    for (a, b) in edges {
        if (a.y > point.y) != (b.y > point.y) && point.x < a.x + (point.y - a.y) / (b.y - a.y) * (b.x - a.x) {
            inside = !inside;
        }
        if margin > 0.0 && distance(point, *a, *b) < margin {
            return false;
        }
    }
    inside
}

fn distance(point: DVec2, a: DVec2, b: DVec2) -> f64 {
    let edge = b - a;
    let share = ((point - a).dot(edge) / edge.length_squared()).clamp(0.0, 1.0);
    point.distance(a + edge * share)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;

    /// A ring: a square of ten with a hole of four.
    fn frame() -> Area {
        let square = |low: f64, high: f64| [(low, low), (high, low), (high, high), (low, high)].map(DVec2::from);
        Polygon::new(&square(0.0, 10.0), &[square(3.0, 7.0).to_vec()]).map(Area::from).unwrap_or_default()
    }

    #[test]
    fn marks_keep_their_distance_from_edges() {
        let area = frame();
        let marks = strewn(&area, area.bounds(), 0.5, 0.3, Seed(1));
        assert!(marks.len() > 150, "{}", marks.len());
        assert!(marks.iter().all(|(p, _)| area.contains(*p) && area.distance_to_edges(*p) >= 0.3 - 1e-12));
    }

    #[test]
    fn a_window_shows_the_same_marks() {
        let area = frame();
        let window = Bounds { min: DVec2::new(1.0, 1.0), max: DVec2::new(9.0, 4.0) };
        let all: Vec<DVec2> = strewn(&area, area.bounds(), 0.5, 0.0, Seed(1)).into_iter().map(|m| m.0).collect();
        let part = strewn(&area, window, 0.5, 0.0, Seed(1));
        assert!(!part.is_empty() && part.iter().all(|(p, _)| all.contains(p)));
    }

    #[test]
    fn hatching_leaves_holes_free() {
        let length = |lines: &[[DVec2; 2]]| lines.iter().map(|[a, b]| a.distance(*b)).sum::<f64>();
        let lines = hatched(&frame(), DVec2::X, 0.1, 0.05);
        assert!((length(&lines) * 0.1 - frame().area()).abs() < 1e-6, "lines as wide as their spacing fill the region");
    }
}
