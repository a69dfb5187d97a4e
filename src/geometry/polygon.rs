//! A planar polygon with holes, and a set of them.
//!
//! Frame: any plane, metres, x right and y up. Outer rings run counter-clockwise, holes clockwise; rings are open
//! (the last vertex is not the first again). A polygon has at least three vertices and a positive area: what has
//! not, cannot be built. Buffers are shared: a copy costs two counters.

use crate::geometry::Bounds;
use glam::{DAffine2, DVec2};
use smallvec::SmallVec;
use std::sync::Arc;

/// Rings below this area (m²) are slivers and vanish.
pub const LEAST_AREA: f64 = 1e-9;

/// A polygon with holes.
#[derive(Clone, Debug, PartialEq)]
pub struct Polygon {
    points: Arc<[DVec2]>,
    /// Where each hole starts in `points`; the outer ring ends where the first hole starts.
    holes: Option<Arc<[u32]>>,
}

/// A plane region: disjoint polygons, mostly one.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Area(SmallVec<[Polygon; 1]>);

impl Polygon {
    /// A polygon from an outer ring and its holes, in either orientation, closed or open.
    ///
    /// `None` where fewer than three distinct vertices or no area is left, or a number is not finite. Holes without
    /// area vanish. Rings are trusted to be simple: repair data with [`crate::geometry::repair`] first.
    pub fn new(outer: &[DVec2], holes: &[Vec<DVec2>]) -> Option<Polygon> {
        let mut points = oriented(outer, true)?;
        let mut starts = Vec::new();
        for hole in holes {
            if let Some(ring) = oriented(hole, false) {
                starts.push(points.len() as u32);
                points.extend(ring);
            }
        }
        let holes = (!starts.is_empty()).then(|| starts.into());
        Some(Polygon { points: points.into(), holes })
    }

    /// A polygon without holes from a counter-clockwise ring that is known to be sound (checked in debug builds).
    pub fn from_ring(ring: &[DVec2]) -> Polygon {
        debug_assert!(ring.len() >= 3 && ring_area(ring) > 0.0, "not a counter-clockwise ring: {ring:?}");
        Polygon { points: ring.into(), holes: None }
    }

    /// The rectangle between two corners; `None` without extent.
    pub fn rectangle(a: DVec2, b: DVec2) -> Option<Polygon> {
        let (low, high) = (a.min(b), a.max(b));
        Polygon::new(&[low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)], &[])
    }

    /// A regular polygon of `sides` corners on a circle, the first to the right of the centre.
    pub fn regular(centre: DVec2, radius: f64, sides: usize) -> Option<Polygon> {
        let step = std::f64::consts::TAU / sides as f64;
        let corner = |i: usize| {
            let (sin, cos) = libm::sincos(step * i as f64);
            centre + radius * DVec2::new(cos, sin)
        };
        Polygon::new(&(0..sides).map(corner).collect::<Vec<_>>(), &[])
    }

    /// All vertices, the outer ring first.
    pub fn points(&self) -> &[DVec2] {
        &self.points
    }

    /// The outer ring, counter-clockwise.
    #[inline]
    pub fn outer(&self) -> &[DVec2] {
        let end = self.holes.as_ref().map_or(self.points.len(), |h| h[0] as usize);
        &self.points[..end]
    }

    /// The holes, clockwise.
    pub fn holes(&self) -> impl Iterator<Item = &[DVec2]> {
        self.rings().skip(1)
    }

    /// Whether it has holes.
    pub fn has_holes(&self) -> bool {
        self.holes.is_some()
    }

    /// The outer ring and then the holes.
    pub fn rings(&self) -> impl Iterator<Item = &[DVec2]> {
        let starts = self.holes.as_deref().unwrap_or(&[]);
        (0..=starts.len()).map(move |i| {
            let from = if i == 0 { 0 } else { starts[i - 1] as usize };
            let to = starts.get(i).map_or(self.points.len(), |s| *s as usize);
            &self.points[from..to]
        })
    }

    /// Every edge with its start and end, ring by ring; the inside lies to the left.
    pub fn edges(&self) -> impl Iterator<Item = (DVec2, DVec2)> {
        self.rings().flat_map(|ring| ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| (*a, *b)))
    }

    /// The edge with an index in [`Polygon::edges`], which must exist.
    pub fn edge(&self, index: usize) -> (DVec2, DVec2) {
        let starts = self.holes.as_deref().unwrap_or(&[]);
        let ring = starts.partition_point(|start| *start as usize <= index);
        let first = if ring == 0 { 0 } else { starts[ring - 1] as usize };
        let end = starts.get(ring).map_or(self.points.len(), |start| *start as usize);
        (self.points[index], if index + 1 == end { self.points[first] } else { self.points[index + 1] })
    }

    /// Area in m², holes taken off.
    pub fn area(&self) -> f64 {
        self.rings().map(ring_area).sum()
    }

    /// Length of all rings in metres.
    pub fn perimeter(&self) -> f64 {
        self.edges().map(|(a, b)| a.distance(b)).sum()
    }

    /// The least axis-parallel rectangle around it.
    #[inline]
    pub fn bounds(&self) -> Bounds {
        Bounds::of(self.outer().iter().copied())
    }

    /// The same moved by `offset`.
    pub fn translated(&self, offset: DVec2) -> Polygon {
        self.mapped(|p| p + offset)
    }

    /// Moves it by `offset`, in place where nobody shares the buffer.
    #[inline]
    fn translate(&mut self, offset: DVec2) {
        match Arc::get_mut(&mut self.points) {
            Some(points) => points.iter_mut().for_each(|p| *p += offset),
            None => self.points = self.points.iter().map(|p| *p + offset).collect(),
        }
    }

    /// The same with each vertex moved by `map`, which must keep rings simple and their orientation.
    pub fn mapped(&self, map: impl Fn(DVec2) -> DVec2) -> Polygon {
        Polygon { points: self.points.iter().map(|p| map(*p)).collect(), holes: self.holes.clone() }
    }

    /// The same under an affine map; a mirroring one turns the rings round again. `None` where it flattens.
    pub fn transformed(&self, map: &DAffine2) -> Option<Polygon> {
        let rings: Vec<Vec<DVec2>> =
            self.rings().map(|r| r.iter().map(|p| map.transform_point2(*p)).collect()).collect();
        Polygon::new(&rings[0], &rings[1..])
    }
}

impl Polygon {
    /// Says what is wrong with the rings, if anything is: numbers that are not finite, a vertex twice in a row, a
    /// ring turned the wrong way, holes larger than the outline. (Crossing rings are found by
    /// [`crate::geometry::repair`].)
    pub fn sanity_check(&self) -> Result<(), String> {
        for (i, ring) in self.rings().enumerate() {
            let area = ring_area(ring);
            if ring.iter().any(|p| !p.is_finite()) || ring.len() < 3 {
                return Err(format!("ring {i} is no ring: {ring:?}"));
            }
            if (i == 0) != (area > 0.0) {
                return Err(format!("ring {i} runs the wrong way round: {area} m²"));
            }
            if let Some(twice) = ring.iter().zip(ring.iter().cycle().skip(1)).position(|(a, b)| a == b) {
                return Err(format!("ring {i} has vertex {twice} twice"));
            }
        }
        if self.area() > 0.0 { Ok(()) } else { Err(format!("{} m²", self.area())) }
    }
}

impl Area {
    /// The empty region.
    pub fn empty() -> Area {
        Area::default()
    }

    /// Adds a part, which must not overlap the others.
    pub fn push(&mut self, polygon: Polygon) {
        self.0.push(polygon);
    }

    /// The parts.
    pub fn polygons(&self) -> &[Polygon] {
        &self.0
    }

    /// The parts, taken out.
    pub fn into_polygons(self) -> impl Iterator<Item = Polygon> {
        self.0.into_iter()
    }

    /// Whether there is nothing.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// Area in m².
    pub fn area(&self) -> f64 {
        self.0.iter().map(Polygon::area).sum()
    }

    /// Length of all rings in metres.
    pub fn perimeter(&self) -> f64 {
        self.0.iter().map(Polygon::perimeter).sum()
    }

    /// The least axis-parallel rectangle around it; empty bounds for nothing.
    #[inline]
    pub fn bounds(&self) -> Bounds {
        self.0.iter().map(Polygon::bounds).fold(Bounds::EMPTY, Bounds::union)
    }

    /// The same moved by `offset`.
    pub fn translated(&self, offset: DVec2) -> Area {
        self.0.iter().map(|p| p.translated(offset)).collect()
    }

    /// The same moved by `offset`, in place where nobody shares the buffers.
    #[inline]
    pub fn into_translated(mut self, offset: DVec2) -> Area {
        self.0.iter_mut().for_each(|polygon| polygon.translate(offset));
        self
    }

    /// One sound counter-clockwise ring in place of what it was, in its buffer where nobody shares that.
    pub(super) fn with_ring(mut self, ring: &[DVec2]) -> Area {
        match self.0.as_mut_slice() {
            [only] if only.holes.is_none() => match Arc::get_mut(&mut only.points) {
                Some(points) if points.len() == ring.len() => points.copy_from_slice(ring),
                _ => only.points = ring.into(),
            },
            _ => self = Polygon::from_ring(ring).into(),
        }
        self
    }

    /// The same under an affine map; parts that it flattens vanish.
    pub fn transformed(&self, map: &DAffine2) -> Area {
        self.0.iter().filter_map(|p| p.transformed(map)).collect()
    }

    /// Every edge of every part; the inside lies to the left.
    pub fn edges(&self) -> impl Iterator<Item = (DVec2, DVec2)> {
        self.0.iter().flat_map(Polygon::edges)
    }
}

impl From<Polygon> for Area {
    fn from(polygon: Polygon) -> Area {
        Area(SmallVec::from_buf([polygon]))
    }
}

impl FromIterator<Polygon> for Area {
    fn from_iter<I: IntoIterator<Item = Polygon>>(polygons: I) -> Area {
        Area(polygons.into_iter().collect())
    }
}

/// Signed area of a ring, positive counter-clockwise.
pub fn ring_area(ring: &[DVec2]) -> f64 {
    let Some(origin) = ring.first() else { return 0.0 };
    let fan = ring.windows(2).map(|w| (w[0] - *origin).perp_dot(w[1] - *origin));
    fan.sum::<f64>() * 0.5
}

/// The ring without repeated vertices, in the wanted orientation; `None` where nothing is left of it.
fn oriented(ring: &[DVec2], counter_clockwise: bool) -> Option<Vec<DVec2>> {
    if ring.iter().any(|p| !p.is_finite()) {
        return None;
    }
    let mut points: Vec<DVec2> = ring.to_vec();
    points.dedup();
    while points.len() > 1 && points.first() == points.last() {
        points.pop();
    }
    let area = ring_area(&points);
    if points.len() < 3 || area.abs() < LEAST_AREA {
        return None;
    }
    if (area > 0.0) != counter_clockwise {
        points[1..].reverse();
    }
    Some(points)
}
