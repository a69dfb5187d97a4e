//! Tidier outlines: without vertices that say nothing, with right angles where they are almost right.

use crate::geometry::{Area, Polygon, repair};
use glam::DVec2;

/// The polygon without vertices nearer than `distance` metres to the one before and without those where it turns by
/// no more than `angle` radians; `None` where nothing is left.
pub fn thinned(polygon: &Polygon, distance: f64, angle: f64) -> Option<Polygon> {
    let rings: Vec<Vec<DVec2>> = polygon.rings().map(|ring| thin(ring, distance, angle)).collect();
    Polygon::new(&rings[0], &rings[1..])
}

fn thin(ring: &[DVec2], distance: f64, angle: f64) -> Vec<DVec2> {
    let near = |a: DVec2, b: DVec2| a.distance(b) <= distance.max(1e-9);
    let mut kept: Vec<DVec2> = Vec::with_capacity(ring.len());
    for point in ring {
        if kept.last().is_none_or(|last| !near(*last, *point)) {
            kept.push(*point);
        }
    }
    while kept.len() > 1 && near(kept[0], kept[kept.len() - 1]) {
        kept.pop();
    }
    let sine = libm::sin(angle.min(std::f64::consts::FRAC_PI_2)).max(1e-9);
    let mut at = 0;
    while at < kept.len() && kept.len() > 3 {
        let count = kept.len();
        let (a, b, c) = (kept[(at + count - 1) % count], kept[at], kept[(at + 1) % count]);
        let (before, after) = ((b - a).normalize_or_zero(), (c - b).normalize_or_zero());
        if before.perp_dot(after).abs() <= sine && before.dot(after) > 0.0 { _ = kept.remove(at) } else { at += 1 }
    }
    kept
}

/// Which way an edge is made to run.
#[derive(Clone, Copy, PartialEq)]
enum Way {
    Along,
    Across,
    Free,
}

/// The area with all edges that run within `angle` radians along or across the longest one made to run so exactly.
/// Edges turn about their middles. A part that would cross itself stays as it was.
pub fn rectified(area: &Area, angle: f64) -> Area {
    let lengths = area.edges().map(|(a, b)| b - a);
    let Some(main) = lengths.reduce(|a, b| if b.length() > a.length() * (1.0 + 1e-9) { b } else { a }) else {
        return Area::empty();
    };
    let main = main.normalize_or(DVec2::X);
    let turned = |p: DVec2| DVec2::new(main.dot(p), main.perp_dot(p));
    let back = |p: DVec2| main * p.x + main.perp() * p.y;
    let straight = |polygon: &Polygon| {
        let rings: Option<Vec<Vec<DVec2>>> = polygon.mapped(turned).rings().map(|ring| squared(ring, angle)).collect();
        let rings = rings?;
        let (sound, _) = repair(&rings);
        let made = Polygon::new(&rings[0], &rings[1..])?;
        let same = matches!(sound.polygons(), [only] if (only.area() - made.area()).abs() < 1e-4 * made.perimeter());
        (same && made.holes().count() == polygon.holes().count()).then(|| made.mapped(back))
    };
    area.polygons().iter().map(|polygon| straight(polygon).unwrap_or_else(|| polygon.clone())).collect()
}

/// A ring with its almost straight edges straight; `None` where a corner would run away.
fn squared(ring: &[DVec2], angle: f64) -> Option<Vec<DVec2>> {
    let count = ring.len();
    let sides: Vec<Side> = (0..count).map(|i| Side::new(ring[i], ring[(i + 1) % count], angle)).collect();
    let sides = merged(sides);
    let count = sides.len();
    let mut made = Vec::with_capacity(count + 4);
    for i in 0..count {
        made.extend(sides[(i + count - 1) % count].corner(&sides[i])?);
    }
    Some(made)
}

/// An edge and the way it is made to run.
#[derive(Clone, Copy)]
struct Side {
    from: DVec2,
    to: DVec2,
    way: Way,
    /// Its place across its way, weighted by its length, and that length.
    place: (f64, f64),
}

impl Side {
    fn new(from: DVec2, to: DVec2, angle: f64) -> Side {
        let (side, sine) = (to - from, libm::sin(angle));
        let length = side.length();
        let (way, place) = if side.y.abs() <= sine * length {
            (Way::Along, 0.5 * (from.y + to.y))
        } else if side.x.abs() <= sine * length {
            (Way::Across, 0.5 * (from.x + to.x))
        } else {
            (Way::Free, 0.0)
        };
        Side { from, to, way, place: (place * length, length) }
    }

    fn at(&self) -> f64 {
        if self.place.1 > 0.0 { self.place.0 / self.place.1 } else { 0.0 }
    }

    /// Whether another goes on the same way.
    fn goes_on(&self, next: &Side) -> bool {
        self.way == next.way && self.way != Way::Free && (self.to - self.from).dot(next.to - next.from) > 0.0
    }

    /// The corner between this side and the next; two where they run back along each other.
    fn corner(&self, next: &Side) -> Option<Vec<DVec2>> {
        let old = next.from;
        let made = match (self.way, next.way) {
            (Way::Along, Way::Across) => vec![DVec2::new(next.at(), self.at())],
            (Way::Across, Way::Along) => vec![DVec2::new(self.at(), next.at())],
            (Way::Along, Way::Along) => vec![DVec2::new(old.x, self.at()), DVec2::new(old.x, next.at())],
            (Way::Across, Way::Across) => vec![DVec2::new(self.at(), old.y), DVec2::new(next.at(), old.y)],
            (Way::Free, Way::Free) => vec![old],
            (Way::Free, _) => vec![next.meets(self)],
            (_, Way::Free) => vec![self.meets(next)],
        };
        let near = self.place.1.min(next.place.1);
        made.iter().all(|p| p.distance(old) <= near).then_some(made)
    }

    /// Where a straight side meets a free one.
    fn meets(&self, free: &Side) -> DVec2 {
        let along = free.to - free.from;
        match self.way {
            Way::Along => free.from + along * ((self.at() - free.from.y) / along.y),
            _ => free.from + along * ((self.at() - free.from.x) / along.x),
        }
    }
}

/// Sides that go on the same way as one.
fn merged(sides: Vec<Side>) -> Vec<Side> {
    let mut merged: Vec<Side> = Vec::with_capacity(sides.len());
    for side in sides {
        match merged.last_mut().filter(|last| last.goes_on(&side)) {
            Some(last) => last.join(&side),
            None => merged.push(side),
        }
    }
    while merged.len() > 3 && merged[merged.len() - 1].goes_on(&merged[0]) {
        let first = merged.remove(0);
        merged.last_mut().into_iter().for_each(|last| last.join(&first));
    }
    merged
}

impl Side {
    fn join(&mut self, next: &Side) {
        self.to = next.to;
        self.place = (self.place.0 + next.place.0, self.place.1 + next.place.1);
    }
}
