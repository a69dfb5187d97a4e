//! Triangles of polygons, for meshes and export.

use crate::geometry::{Area, Polygon};
use earcut::Earcut;
use glam::DVec2;

/// Counter-clockwise triangles that cover the polygon, as indices into `points()`.
///
/// Ear clipping; convex rings become a fan. Collinear vertices may be left out.
pub fn triangulate(polygon: &Polygon) -> Vec<[u32; 3]> {
    let rings: Vec<&[DVec2]> = polygon.rings().collect();
    triangulate_rings(&rings, polygon.is_convex())
}

impl Area {
    /// Counter-clockwise triangles that cover the area.
    pub fn triangles(&self) -> Vec<[DVec2; 3]> {
        let corners = |p: &Polygon| triangulate(p).into_iter().map(|t| t.map(|i| p.points()[i as usize])).collect();
        self.polygons().iter().flat_map(|p| -> Vec<[DVec2; 3]> { corners(p) }).collect()
    }
}

/// Triangles of an outer ring and its holes, as indices into all their vertices in order.
pub(super) fn triangulate_rings(rings: &[&[DVec2]], convex: bool) -> Vec<[u32; 3]> {
    let Some(origin) = rings.first().and_then(|r| r.first()).copied() else { return Vec::new() };
    if convex && rings[0].len() <= 4 {
        return fan(rings[0]);
    }
    let mut starts = Vec::new();
    let mut count = 0;
    for ring in rings {
        starts.push(count as u32);
        count += ring.len();
    }
    // Near the origin, where doubles are densest.
    let points = rings.iter().flat_map(|r| r.iter()).map(|p| (*p - origin).to_array());
    let mut corners: Vec<u32> = Vec::new();
    Earcut::new().earcut(points, &starts[1..], &mut corners);
    let vertices: Vec<DVec2> = rings.iter().flat_map(|r| r.iter().copied()).collect();
    corners.chunks_exact(3).map(|t| turned_left([t[0], t[1], t[2]], &vertices)).collect()
}

/// Triangles around the corner that gives the fattest split, so that no collinear corner makes an empty one.
fn fan(ring: &[DVec2]) -> Vec<[u32; 3]> {
    let flat = |i: usize| {
        let (a, b, c) = (ring[(i + ring.len() - 1) % ring.len()], ring[i], ring[(i + 1) % ring.len()]);
        (b - a).perp_dot(c - b)
    };
    let count = ring.len() as u32;
    let tip = if count == 4 && flat(0).min(flat(2)) > flat(1).min(flat(3)) { 1 } else { 0 };
    (1..count - 1).map(|i| [tip, (tip + i) % count, (tip + i + 1) % count]).collect()
}

fn turned_left(t: [u32; 3], vertices: &[DVec2]) -> [u32; 3] {
    let [a, b, c] = t.map(|i| vertices[i as usize]);
    if (b - a).perp_dot(c - a) < 0.0 { [t[0], t[2], t[1]] } else { t }
}
