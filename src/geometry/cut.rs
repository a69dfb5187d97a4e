//! Cutting areas into bands between parallel lines.
//!
//! In: an area, a unit normal and positions along it. Out: the parts between, which sum to the whole; cut edges lie
//! exactly on their line where that is parallel to an axis. Convex polygons take a path of their own that needs one
//! allocation per part.

use crate::geometry::clip::{Section, clip};
use crate::geometry::overlay::{Fill, enclosed};
use crate::geometry::{Area, LEAST_AREA, Polygon, ring_area};
use glam::DVec2;
use smallvec::SmallVec;

/// Vertices nearer than this (metres) to a line lie on it.
const ON_LINE: f64 = 1e-9;

/// Convex rings up to this size are peeled band by band; larger ones are halved again and again.
const FEW_VERTICES: usize = 24;

/// A small ring on the stack.
pub(super) type Ring = SmallVec<[DVec2; 16]>;

/// The part of the area with `from <= p · normal <= to`; the normal is a unit vector, bounds may be infinite.
///
/// Empty where `to <= from` or a number is not a number.
pub fn band(area: &Area, normal: DVec2, from: f64, to: f64) -> Area {
    let mut parts = Area::empty();
    if from < to {
        area.polygons().iter().for_each(|p| band_of(p, normal, from, to, &mut parts));
    }
    parts
}

/// The areas between consecutive cuts: `cuts.len() - 1` of them, in order; the cuts must ascend, the first and the
/// last may be infinite. Same as [`band`] for each pair, but costs n log k instead of n k for k cuts.
pub fn bands(area: &Area, normal: DVec2, cuts: &[f64]) -> Vec<Area> {
    let mut parts: Vec<Area> = cuts.iter().skip(1).map(|_| Area::empty()).collect();
    if parts.is_empty() || !cuts.is_sorted() || cuts.iter().any(|c| c.is_nan()) {
        return parts;
    }
    for polygon in area.polygons() {
        if !polygon.has_holes() && polygon.outer().len() <= FEW_VERTICES && is_convex(polygon.outer()) {
            peel(polygon, normal, cuts, &mut parts);
        } else {
            let inside = band(&polygon.clone().into(), normal, cuts[0], cuts[cuts.len() - 1]);
            halve(inside, normal, cuts, &mut parts);
        }
    }
    parts
}

/// The straight line `p · normal = at`; what is kept lies on the side the normal points to, or on the other one.
#[derive(Clone, Copy)]
pub(super) struct Line {
    /// Unit normal.
    pub normal: DVec2,
    /// Distance from the origin.
    pub at: f64,
    /// 1 to keep the side of the normal, -1 to keep the other.
    pub keep: f64,
}

impl Section for Line {
    type Point = DVec2;

    fn depth(&self, point: DVec2) -> f64 {
        self.keep * self.height(point)
    }

    fn along(&self, point: DVec2) -> f64 {
        -self.keep * self.normal.perp_dot(point)
    }

    fn crossing(&mut self, a: DVec2, b: DVec2) -> DVec2 {
        match (self.height(a), self.height(b)) {
            (0.0, _) => a,
            (_, 0.0) => b,
            (ha, hb) => self.met((a, ha), (b, hb)),
        }
    }
}

impl Line {
    /// What lies at `at` and beyond, or before it.
    pub fn new(normal: DVec2, at: f64, beyond: bool) -> Line {
        Line { normal, at, keep: if beyond { 1.0 } else { -1.0 } }
    }

    /// Signed distance along the normal, exactly zero on the line.
    fn height(&self, point: DVec2) -> f64 {
        let height = point.dot(self.normal) - self.at;
        if height.abs() <= ON_LINE { 0.0 } else { height }
    }

    /// Where the segment between two points of known heights meets the line, the same for both directions.
    fn met(&self, (a, ha): (DVec2, f64), (b, hb): (DVec2, f64)) -> DVec2 {
        let (low, high, h, rise) = if ha < hb { (a, b, ha, hb - ha) } else { (b, a, hb, ha - hb) };
        self.snapped(low + (high - low) * (-h / rise))
    }

    /// A point next to the line moved onto it, exactly where the line is parallel to an axis.
    fn snapped(&self, point: DVec2) -> DVec2 {
        if self.normal.y == 0.0 {
            DVec2::new(self.at * self.normal.x, point.y)
        } else if self.normal.x == 0.0 {
            DVec2::new(point.x, self.at * self.normal.y)
        } else {
            point
        }
    }

    /// The kept part of a convex ring.
    pub fn clip_convex(&self, ring: &[DVec2]) -> Ring {
        let mut kept = Ring::new();
        let Some(mut before) = ring.last().map(|p| (*p, self.height(*p))) else { return kept };
        for vertex in ring.iter().map(|p| (*p, self.height(*p))) {
            if before.1 * vertex.1 < 0.0 {
                kept.push(self.met(before, vertex));
            }
            if self.keep * vertex.1 >= 0.0 {
                kept.push(vertex.0);
            }
            before = vertex;
        }
        kept
    }

    /// Puts the parts of a convex ring before and beyond the line into `below` and `above`.
    fn split_convex(&self, ring: &[DVec2], below: &mut Ring, above: &mut Ring) {
        below.clear();
        above.clear();
        let Some(mut before) = ring.last().map(|p| (*p, self.height(*p))) else { return };
        for vertex in ring.iter().map(|p| (*p, self.height(*p))) {
            if before.1 * vertex.1 < 0.0 {
                let met = self.met(before, vertex);
                below.push(met);
                above.push(met);
            }
            if vertex.1 <= 0.0 {
                below.push(vertex.0);
            }
            if vertex.1 >= 0.0 {
                above.push(vertex.0);
            }
            before = vertex;
        }
    }

    /// The kept part of a polygon, added to `parts`.
    pub fn clip_polygon(mut self, polygon: &Polygon, parts: &mut Area) {
        let (low, high) = extent(polygon.outer(), self.normal * self.keep);
        let at = self.at * self.keep;
        if low >= at - ON_LINE {
            return parts.push(polygon.clone());
        }
        if high <= at + ON_LINE {
            return;
        }
        if !polygon.has_holes() && is_convex(polygon.outer()) {
            return push_ring(&self.clip_convex(polygon.outer()), parts);
        }
        let rings: SmallVec<[&[DVec2]; 4]> = polygon.rings().collect();
        let clipped = clip(rings.iter().copied(), &mut self);
        if clipped.touching {
            let whole = clipped.whole.iter().map(|i| rings[*i]);
            let sorted_out = enclosed(clipped.loops.iter().map(Vec::as_slice).chain(whole), Fill::Positive);
            return sorted_out.polygons().iter().for_each(|p| parts.push(p.clone()));
        }
        let (outers, mut holes): (Vec<_>, Vec<_>) = clipped.loops.into_iter().partition(|r| ring_area(r) > 0.0);
        holes.extend(clipped.whole.into_iter().map(|i| rings[i].to_vec()));
        nest(outers, holes, parts);
    }
}

/// Polygons from outer rings and holes, each hole in the outer ring that surrounds it; added to `parts`.
///
/// A hole may touch its outer ring and stick out of it by a rounding, so the ring with most of its vertices has it.
pub(super) fn nest(outers: Vec<Vec<DVec2>>, holes: Vec<Vec<DVec2>>, parts: &mut Area) {
    let polygons: Vec<Polygon> = outers.iter().filter_map(|r| Polygon::new(r, &[])).collect();
    let mut inside: Vec<Vec<Vec<DVec2>>> = vec![Vec::new(); polygons.len()];
    for hole in holes {
        let shared = |i: &usize| hole.iter().filter(|v| polygons[*i].contains(**v)).count();
        let owner = if polygons.len() > 1 { (0..polygons.len()).max_by_key(shared) } else { Some(0) };
        if let Some(list) = owner.and_then(|i| inside.get_mut(i)) {
            list.push(hole);
        }
    }
    for (polygon, holes) in polygons.into_iter().zip(inside) {
        let holed = if holes.is_empty() { Some(polygon) } else { Polygon::new(polygon.outer(), &holes) };
        holed.into_iter().for_each(|p| parts.push(p));
    }
}

/// Least and greatest position of the points along a direction.
pub(super) fn extent(points: &[DVec2], direction: DVec2) -> (f64, f64) {
    let positions = points.iter().map(|p| p.dot(direction));
    positions.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), s| (low.min(s), high.max(s)))
}

/// Whether a counter-clockwise ring nowhere turns right. (A ring that only turns left but goes round twice is not
/// simple, and so not a ring of a polygon.)
#[inline]
pub(super) fn is_convex(ring: &[DVec2]) -> bool {
    let Some([mut a, mut b]) = ring.last_chunk::<2>().copied() else { return false };
    ring.iter().all(|c| {
        let left = (b - a).perp_dot(c - b) >= 0.0;
        (a, b) = (b, *c);
        left
    })
}

/// Adds a sound ring as a polygon; what has no area is left out.
pub(super) fn push_ring(ring: &[DVec2], parts: &mut Area) {
    if is_sound(ring) {
        parts.push(Polygon::from_ring(ring));
    }
}

/// Whether a ring has an area.
#[inline]
pub(super) fn is_sound(ring: &[DVec2]) -> bool {
    ring.len() >= 3 && ring_area(ring) >= LEAST_AREA
}

fn band_of(polygon: &Polygon, normal: DVec2, from: f64, to: f64, parts: &mut Area) {
    let (low, high) = extent(polygon.outer(), normal);
    let (cut_low, cut_high) = (low < from - ON_LINE, high > to + ON_LINE);
    if high <= from + ON_LINE || low >= to - ON_LINE {
        return;
    }
    if !cut_low && !cut_high {
        return parts.push(polygon.clone());
    }
    let (lower, upper) = (Line::new(normal, from, true), Line::new(normal, to, false));
    if !polygon.has_holes() && is_convex(polygon.outer()) {
        let above = if cut_low { lower.clip_convex(polygon.outer()) } else { polygon.outer().into() };
        let between = if cut_high { upper.clip_convex(&above) } else { above };
        return push_ring(&between, parts);
    }
    let mut above = Area::empty();
    lower.clip_polygon(polygon, &mut above);
    above.polygons().iter().for_each(|p| upper.clip_polygon(p, parts));
}

/// Takes band after band off a convex polygon.
fn peel(polygon: &Polygon, normal: DVec2, cuts: &[f64], parts: &mut [Area]) {
    let (low, high) = extent(polygon.outer(), normal);
    let first = cuts.partition_point(|c| *c <= low + ON_LINE).saturating_sub(1);
    let mut rest = Line::new(normal, cuts[first], true).clip_convex(polygon.outer());
    let (mut below, mut above) = (Ring::new(), Ring::new());
    for (part, cut) in parts.iter_mut().zip(&cuts[1..]).skip(first) {
        if *cut >= high - ON_LINE {
            return push_ring(&rest, part);
        }
        Line::new(normal, *cut, true).split_convex(&rest, &mut below, &mut above);
        push_ring(&below, part);
        std::mem::swap(&mut rest, &mut above);
    }
}

/// Halves the area at the middle cut until every part lies in one band.
fn halve(area: Area, normal: DVec2, cuts: &[f64], parts: &mut [Area]) {
    if area.is_empty() {
        return;
    }
    if let [part] = parts {
        area.polygons().iter().for_each(|p| part.push(p.clone()));
        return;
    }
    let middle = parts.len() / 2;
    let (mut below, mut above) = (Area::empty(), Area::empty());
    for polygon in area.polygons() {
        Line::new(normal, cuts[middle], false).clip_polygon(polygon, &mut below);
        Line::new(normal, cuts[middle], true).clip_polygon(polygon, &mut above);
    }
    let (left, right) = parts.split_at_mut(middle);
    halve(below, normal, &cuts[..=middle], left);
    halve(above, normal, &cuts[middle..], right);
}
