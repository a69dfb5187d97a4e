//! Growing and shrinking areas by a distance.
//!
//! Convex polygons are computed exactly in doubles with one allocation; everything else goes through the overlay
//! engine on its grid of about a micrometre.

use crate::geometry::cut::{Line, Ring, is_convex, is_sound, push_ring};
use crate::geometry::overlay::{Corner, outline};
use crate::geometry::{Area, Polygon};
use glam::DVec2;

/// The area shrunk by `distance`: every point at least that far from the lines of the edges around it.
///
/// Corners stay sharp. Parts that are too narrow vanish, others may fall apart. A negative distance grows.
pub fn inset(area: &Area, distance: f64) -> Area {
    offset(area, -distance)
}

/// The area grown by `distance` with mitred corners (very sharp ones cut off), or shrunk by a negative one.
pub fn offset(area: &Area, distance: f64) -> Area {
    if distance == 0.0 || !distance.is_finite() || area.is_empty() {
        return area.clone();
    }
    if distance < 0.0 {
        let mut parts = Area::empty();
        area.polygons().iter().for_each(|p| shrink(p, -distance, &mut parts));
        return parts;
    }
    outline(area, distance, Corner::Mitre)
}

/// All points within `distance` of the area; for a negative distance all points of it that are farther than that
/// from its rim. Round corners, drawn to 5 mm.
pub fn buffered(area: &Area, distance: f64) -> Area {
    if distance == 0.0 || !distance.is_finite() {
        return area.clone();
    }
    outline(area, distance, Corner::Round)
}

/// The same as [`offset`] of an area that is given up: a convex polygon keeps its buffer.
pub fn into_offset(area: Area, distance: f64) -> Area {
    match area.polygons() {
        [only] if distance < 0.0 && distance.is_finite() && !only.has_holes() && is_convex(only.outer()) => {
            match moved_corners(only.outer(), -distance) {
                Some(ring) if is_sound(&ring) => area.with_ring(&ring),
                _ => offset(&area, distance),
            }
        }
        _ => offset(&area, distance),
    }
}

fn shrink(polygon: &Polygon, distance: f64, parts: &mut Area) {
    if !polygon.has_holes() && is_convex(polygon.outer()) {
        return shrink_convex(polygon.outer(), distance, parts);
    }
    let inner = outline(&polygon.clone().into(), -distance, Corner::Mitre);
    inner.polygons().iter().for_each(|p| parts.push(p.clone()));
}

fn shrink_convex(ring: &[DVec2], distance: f64, parts: &mut Area) {
    match moved_corners(ring, distance) {
        Some(moved) => push_ring(&moved, parts),
        None => push_ring(&half_planes(ring, distance), parts),
    }
}

/// Every corner moved to where the moved edges meet; `None` where an edge would turn round, so that others take its
/// place. The result has the edges of the ring in the same order and direction, so it is the inset itself.
fn moved_corners(ring: &[DVec2], distance: f64) -> Option<Ring> {
    let mut moved = Ring::new();
    let mut before = (*ring.first()? - *ring.last()?).try_normalize()?;
    for (corner, side) in ring.iter().zip(sides(ring)) {
        let along = side.try_normalize()?;
        moved.push(*corner + mitre(before, along) * distance);
        before = along;
    }
    let forward = sides(&moved).zip(sides(ring)).all(|(after, side)| after.dot(side) > 0.0);
    forward.then_some(moved)
}

/// From each corner to the next, round the ring.
fn sides(ring: &[DVec2]) -> impl Iterator<Item = DVec2> {
    ring.iter().zip(ring.iter().skip(1).chain(ring.first())).map(|(a, b)| *b - *a)
}

/// Where a convex corner between two unit directions goes when both edges move left by one.
fn mitre(before: DVec2, along: DVec2) -> DVec2 {
    let sum = before.perp() + along.perp();
    sum * (2.0 / sum.length_squared().max(1e-12))
}

/// What lies behind every edge moved inwards; quadratic, but only for rings that lose edges.
fn half_planes(ring: &[DVec2], distance: f64) -> Ring {
    let mut inner = Ring::from_slice(ring);
    for (i, a) in ring.iter().enumerate() {
        let Some(along) = (ring[(i + 1) % ring.len()] - *a).try_normalize() else { continue };
        inner = Line::new(along.perp(), a.dot(along.perp()) + distance, true).clip_convex(&inner);
    }
    inner
}
