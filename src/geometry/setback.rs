//! Setbacks: every edge moves inwards by its own distance, and what it sweeps is its strip.
//!
//! In: a polygon and a distance per edge. Out: what remains, and a strip per moved edge; together they are the polygon
//! and do not overlap. A point belongs to the edge that reaches it first when all edges move at the same time, each
//! as fast as its distance is large: between two neighbours that is the mitre line. Where neighbours go almost
//! straight on but move differently, the mitre would run away along them, so their strips end square instead.

use crate::geometry::cut::{Line, Ring, extent, push_ring};
use crate::geometry::{Area, Polygon, difference, intersection, nearest_on_segment};
use glam::DVec2;

/// Neighbours that turn by less than this sine go straight on.
const STRAIGHT: f64 = 0.17;

/// Strips reach around a corner that turns inwards by at most this many times the larger distance.
const LONGEST_MITRE: f64 = 3.0;

/// A polygon after its setbacks.
#[derive(Clone, Debug, PartialEq)]
pub struct Setback {
    /// What no moved edge has reached.
    pub remainder: Area,
    /// One strip per moved edge, in the order of the edges; empty where others were always faster.
    pub strips: Vec<Strip>,
}

/// What one edge sweeps.
#[derive(Clone, Debug, PartialEq)]
pub struct Strip {
    /// The edge's index in `edges()`.
    pub edge: usize,
    /// The region.
    pub area: Area,
}

/// Moves each edge inwards by its own distance in metres; edges with zero (or less, or no number) stay.
///
/// Exact for convex polygons, quadratic in their moved edges; other polygons go through booleans on their grid of
/// about a micrometre.
pub fn setback(polygon: &Polygon, distances: impl Fn(usize) -> f64) -> Setback {
    let fronts = fronts(polygon, distances);
    if fronts.is_empty() {
        return Setback { remainder: polygon.clone().into(), strips: Vec::new() };
    }
    if polygon.is_convex() && !fronts.iter().any(|f| f.before.steps(f) || f.after.steps(f)) {
        convex(polygon.outer(), &fronts)
    } else {
        general(polygon, &fronts)
    }
}

/// What [`setback`] leaves, without its strips.
pub fn set_in(polygon: &Polygon, distances: impl Fn(usize) -> f64) -> Area {
    let fronts = fronts(polygon, distances);
    let whole: Area = polygon.clone().into();
    if fronts.is_empty() {
        return whole;
    }
    if !polygon.is_convex() || fronts.iter().any(|f| f.before.steps(f) || f.after.steps(f)) {
        return difference(
            &whole,
            &reaches(polygon, &whole, &fronts).into_iter().flat_map(Area::into_polygons).collect(),
        );
    }
    let rest = fronts.iter().fold(Ring::from_slice(polygon.outer()), |rest, f| f.goal(true).clip_convex(&rest));
    let mut remainder = Area::empty();
    push_ring(&rest, &mut remainder);
    remainder
}

/// A moving edge.
struct Front {
    edge: usize,
    from: DVec2,
    to: DVec2,
    /// Unit direction; the inside lies to the left.
    along: DVec2,
    distance: f64,
    before: Neighbour,
    after: Neighbour,
}

/// The edge next to a moving one.
struct Neighbour {
    along: DVec2,
    distance: f64,
    /// Sine of the turn between the two in the order of the ring: positive at a corner that points outwards.
    turn: f64,
}

impl Neighbour {
    /// Whether it goes on straight but moves differently.
    fn steps(&self, front: &Front) -> bool {
        self.is_straight(front) && self.distance != front.distance
    }

    fn is_straight(&self, front: &Front) -> bool {
        self.turn.abs() < STRAIGHT && self.along.dot(front.along) > 0.0
    }
}

impl Front {
    fn normal(&self) -> DVec2 {
        self.along.perp()
    }

    fn at(&self) -> f64 {
        self.from.dot(self.normal())
    }

    /// The line the edge moves to, keeping what lies behind it or before it.
    fn goal(&self, beyond: bool) -> Line {
        Line::new(self.normal(), self.at() + self.distance, beyond)
    }

    /// What the edge could sweep if only its neighbours hindered it: a convex ring.
    fn reach(&self, farthest: f64) -> Ring {
        let (back, on) = (self.from - self.along * farthest, self.to + self.along * farthest);
        let in_depth = self.normal() * self.distance;
        let slab = Ring::from_slice(&[back, on, on + in_depth, back + in_depth]);
        let ring = self.end(&self.before, self.from, 1.0).clip_convex(&slab);
        let ring = self.end(&self.after, self.to, -1.0).clip_convex(&ring);
        let ring = self.limit(&self.before, self.from, ring);
        self.limit(&self.after, self.to, ring)
    }

    /// The mitre line at an end; `ahead` is 1 where the edge goes on along its direction from there, else -1.
    fn end(&self, other: &Neighbour, corner: DVec2, ahead: f64) -> Line {
        let across = self.normal() * other.distance - other.along.perp() * self.distance;
        if other.is_straight(self) {
            let along = (self.along + other.along).normalize() * ahead;
            return Line::new(along, corner.dot(along), true);
        }
        let Some(normal) = across.try_normalize() else {
            return Line::new(self.along * ahead, corner.dot(self.along * ahead), true);
        };
        Line::new(normal, corner.dot(normal), other.turn < 0.0)
    }

    /// Cuts off the far end of a mitre at a corner that turns inwards.
    fn limit(&self, other: &Neighbour, corner: DVec2, ring: Ring) -> Ring {
        if other.turn >= 0.0 || other.is_straight(self) {
            return ring;
        }
        let out = (other.along * other.turn.signum() - self.along * other.turn.signum()).normalize_or_zero();
        let farthest = LONGEST_MITRE * self.distance.max(other.distance);
        let outward = if out.dot(self.normal()) >= 0.0 { out } else { -out };
        Line::new(outward, corner.dot(outward) + farthest, false).clip_convex(&ring)
    }

    /// Whether a piece of the edge is part of the polygon's rim.
    fn borders(&self, polygon: &Polygon) -> bool {
        let near = |p: DVec2| nearest_on_segment(p, self.from, self.to).distance_squared(p) < 1e-10;
        polygon.edges().any(|(a, b)| near(a) && near(b) && a.distance_squared(b) > 1e-10)
    }
}

fn fronts(polygon: &Polygon, distances: impl Fn(usize) -> f64) -> Vec<Front> {
    let mut fronts = Vec::new();
    let mut first = 0;
    for ring in polygon.rings() {
        let count = ring.len();
        let along = |i: usize| (ring[(i + 1) % count] - ring[i % count]).normalize_or(DVec2::X);
        let distance =
            |i: usize| Some(distances(first + i % count)).filter(|d| d.is_finite()).map_or(0.0, |d| d.max(0.0));
        for i in (0..count).filter(|i| distance(*i) > 0.0) {
            let (here, back, next) = (along(i), along(i + count - 1), along(i + 1));
            fronts.push(Front {
                edge: first + i,
                from: ring[i],
                to: ring[(i + 1) % count],
                along: here,
                distance: distance(i),
                before: Neighbour { along: back, distance: distance(i + count - 1), turn: back.perp_dot(here) },
                after: Neighbour { along: next, distance: distance(i + 1), turn: here.perp_dot(next) },
            });
        }
        first += count;
    }
    fronts
}

/// Which of two fronts reaches a point first.
enum Race {
    /// The first one before the line, the other beyond.
    Divided(Line),
    /// Always the one with this place.
    Always(usize),
}

/// The race between the fronts `i < j`; parallel fronts of the same speed never meet.
fn race(fronts: &[Front], i: usize, j: usize) -> Race {
    let (a, b) = (&fronts[i], &fronts[j]);
    let across = a.normal() * b.distance - b.normal() * a.distance;
    let at = a.at() * b.distance - b.at() * a.distance;
    let length = across.length();
    if length > 1e-9 * (a.distance + b.distance) {
        Race::Divided(Line::new(across / length, at / length, false))
    } else {
        Race::Always(if at >= 0.0 { i } else { j })
    }
}

fn convex(ring: &[DVec2], fronts: &[Front]) -> Setback {
    let mut rest = Ring::from_slice(ring);
    let mut strips = Vec::with_capacity(fronts.len());
    for (i, front) in fronts.iter().enumerate() {
        let mut swept = front.goal(false).clip_convex(ring);
        for j in (0..fronts.len()).filter(|j| *j != i) {
            swept = match race(fronts, i.min(j), i.max(j)) {
                Race::Divided(line) if i < j => line.clip_convex(&swept),
                Race::Divided(line) => Line { keep: 1.0, ..line }.clip_convex(&swept),
                Race::Always(winner) if winner == i => swept,
                Race::Always(_) => Ring::new(),
            };
        }
        let mut area = Area::empty();
        push_ring(&swept, &mut area);
        strips.push(Strip { edge: front.edge, area });
        rest = front.goal(true).clip_convex(&rest);
    }
    let mut remainder = Area::empty();
    push_ring(&rest, &mut remainder);
    Setback { remainder, strips }
}

/// Every front's reach within the polygon, less what others reach first.
fn general(polygon: &Polygon, fronts: &[Front]) -> Setback {
    let whole: Area = polygon.clone().into();
    let reaches = reaches(polygon, &whole, fronts);
    let strips = (0..fronts.len())
        .map(|i| Strip { edge: fronts[i].edge, area: difference(&reaches[i], &lost(fronts, &reaches, i)) });
    let strips = strips.collect();
    let swept: Area = reaches.iter().flat_map(|r| r.polygons().iter().cloned()).collect();
    Setback { remainder: difference(&whole, &swept), strips }
}

/// How far each front reaches.
fn reaches(polygon: &Polygon, whole: &Area, fronts: &[Front]) -> Vec<Area> {
    let (left, right) = extent(polygon.outer(), DVec2::X);
    let (low, high) = extent(polygon.outer(), DVec2::Y);
    fronts.iter().map(|f| reach_within(f, whole, right - left + high - low)).collect()
}

/// The reach inside the polygon, without what lies beyond something that is not part of it.
fn reach_within(front: &Front, whole: &Area, farthest: f64) -> Area {
    let mut reach = Area::empty();
    push_ring(&front.reach(farthest), &mut reach);
    let inside = intersection(&reach, whole);
    inside.polygons().iter().filter(|p| front.borders(p)).cloned().collect()
}

/// What other fronts reach before the `i`-th does.
fn lost(fronts: &[Front], reaches: &[Area], i: usize) -> Area {
    let bounds = reaches[i].bounds();
    let mut lost = Area::empty();
    for (j, reach) in reaches.iter().enumerate() {
        if j == i || !reach.bounds().touches(bounds) {
            continue;
        }
        let line = match race(fronts, i.min(j), i.max(j)) {
            Race::Always(winner) if winner == i => continue,
            Race::Always(_) => None,
            Race::Divided(line) => Some(if i < j { Line { keep: 1.0, ..line } } else { line }),
        };
        for part in reach.polygons() {
            match line {
                Some(line) => line.clip_polygon(part, &mut lost),
                None => lost.push(part.clone()),
            }
        }
    }
    lost
}
