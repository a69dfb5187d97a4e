//! The largest rectangle in a polygon whose sides run along given axes.
//!
//! In a convex polygon the area of the best rectangle between two sides of a strip is the product of two concave
//! functions, so two golden sections one in the other find it. In others, holes included, strips are searched from the
//! best bound down: within a strip the highest free gap is exact, a narrower strip can only have a higher one, and a
//! range of strips is given up when even its widest with the gap of its narrowest is no larger than what is known.

use crate::geometry::{Bounds, Polygon};
use glam::DVec2;
use std::collections::BinaryHeap;

/// The search in concave polygons ends when no rectangle can be larger by more than its sides times this (metres).
const CLOSE: f64 = 1e-3;

/// … or when it has looked at so many ranges of strips.
const MOST_RANGES: usize = 20_000;

/// Steps of a golden section: to the last digits.
const STEPS: usize = 60;

/// The largest rectangle of the polygon with its sides along x and y, metres; `None` where not even a sliver fits.
///
/// Exact for convex polygons, for others to a millimetre on a side; no side can be moved outwards. For n edges a
/// convex polygon costs some 4000 n steps, another up to 20 000 n log n, mostly far fewer.
pub fn inner_rectangle(polygon: &Polygon) -> Option<Bounds> {
    let found = if polygon.is_convex() { convex(polygon) } else { searched(polygon) };
    Some(Field::new(polygon).grown(found?)).filter(|found| found.size().min_element() > 0.0)
}

/// The edges of a polygon, seen along both axes.
struct Field {
    edges: Vec<(DVec2, DVec2)>,
    turned: Vec<(DVec2, DVec2)>,
}

/// A strip between two places on x, and the highest free gap in it.
#[derive(Clone, Copy)]
struct Found {
    area: f64,
    bounds: Bounds,
}

impl Field {
    fn new(polygon: &Polygon) -> Field {
        let edges: Vec<(DVec2, DVec2)> = polygon.edges().collect();
        let turned = edges.iter().map(|(a, b)| (swapped(*b), swapped(*a))).collect();
        Field { edges, turned }
    }

    /// The largest rectangle across a whole strip.
    fn across(&self, left: f64, right: f64) -> Option<Found> {
        let gaps = gaps(&self.edges, left, right);
        let (low, high) = gaps.into_iter().max_by(|a, b| (a.1 - a.0).total_cmp(&(b.1 - b.0)))?;
        let bounds = Bounds { min: DVec2::new(left, low), max: DVec2::new(right, high) };
        Some(Found { area: (right - left) * (high - low), bounds })
    }

    /// The rectangle with every side moved outwards as far as it goes.
    fn grown(&self, found: Bounds) -> Bounds {
        let middle = found.centre();
        let around = |gaps: Vec<(f64, f64)>, at: f64| gaps.into_iter().find(|(low, high)| *low <= at && at <= *high);
        let rows = around(gaps(&self.edges, found.min.x, found.max.x), middle.y);
        let (low, high) = rows.unwrap_or((found.min.y, found.max.y));
        let columns = around(gaps(&self.turned, low, high), middle.x);
        let (left, right) = columns.unwrap_or((found.min.x, found.max.x));
        Bounds { min: DVec2::new(left, low), max: DVec2::new(right, high) }
    }
}

/// The heights of an edge within a strip.
struct Span {
    low: f64,
    high: f64,
    /// Whether the inside lies above it; upright edges cannot tell.
    floor: Option<bool>,
}

/// The gaps of the inside that no edge enters between two places on x, from bottom to top.
fn gaps(edges: &[(DVec2, DVec2)], left: f64, right: f64) -> Vec<(f64, f64)> {
    let mut spans: Vec<Span> = edges.iter().filter_map(|(a, b)| span(*a, *b, left, right)).collect();
    spans.sort_by(|a, b| a.low.total_cmp(&b.low));
    let mut found = Vec::new();
    // Of what has come so far the edge that reaches highest bounds the gap above.
    let (mut top, mut floor) = (f64::INFINITY, None);
    for span in spans {
        if span.low > top && floor == Some(true) {
            found.push((top, span.low));
        }
        if top == f64::INFINITY || span.high > top || span.high == top && span.floor.is_some() {
            (top, floor) = (span.high, span.floor);
        }
    }
    found
}

/// An edge within a strip; `None` where it does not enter.
fn span(a: DVec2, b: DVec2, left: f64, right: f64) -> Option<Span> {
    let (from, to) = if a.x < b.x { (a, b) } else { (b, a) };
    if to.x <= left || from.x >= right {
        return None;
    }
    let upright = to.x <= from.x;
    let within = |x: f64| height(a, b, x);
    let (one, other) = if upright { (a.y, b.y) } else { (within(left.max(from.x)), within(right.min(to.x))) };
    Some(Span { low: one.min(other), high: one.max(other), floor: (!upright).then_some(a.x < b.x) })
}

/// The height of an edge, or of its line, at a place on x; the same from both ends.
fn height(a: DVec2, b: DVec2, x: f64) -> f64 {
    let (from, to) = if a.x < b.x { (a, b) } else { (b, a) };
    let share = (x - from.x) / (to.x - from.x);
    if share == 1.0 { to.y } else { from.y + (to.y - from.y) * share }
}

fn swapped(p: DVec2) -> DVec2 {
    DVec2::new(p.y, p.x)
}

/// The largest rectangle of a convex polygon: the best right side for each left one, and the best left one of all.
fn convex(polygon: &Polygon) -> Option<Bounds> {
    let bounds = polygon.bounds();
    let sides = || polygon.edges().filter(|(a, b)| a.x != b.x);
    let chord = |x: f64| {
        let floors = sides().filter(|(a, b)| a.x < b.x).map(|(a, b)| height(a, b, x));
        let ceilings = sides().filter(|(a, b)| a.x > b.x).map(|(a, b)| height(a, b, x));
        (floors.fold(f64::NEG_INFINITY, f64::max), ceilings.fold(f64::INFINITY, f64::min))
    };
    let between = |left: f64, right: f64| {
        let ((low_a, high_a), (low_b, high_b)) = (chord(left), chord(right));
        (low_a.max(low_b), high_a.min(high_b))
    };
    let area = |left: f64, right: f64| {
        let (low, high) = between(left, right);
        (right - left) * (high - low)
    };
    let best_right = |left: f64| highest(left, bounds.max.x, |right| area(left, right));
    let left = highest(bounds.min.x, bounds.max.x, |left| area(left, best_right(left)));
    let right = best_right(left);
    let (low, high) = between(left, right);
    (low < high).then_some(Bounds { min: DVec2::new(left, low), max: DVec2::new(right, high) })
}

/// Where a function with one hill is highest between two places (golden section).
fn highest(mut from: f64, mut to: f64, f: impl Fn(f64) -> f64) -> f64 {
    const GOLDEN: f64 = 0.618_033_988_749_894_8;
    let (mut a, mut b) = (to - GOLDEN * (to - from), from + GOLDEN * (to - from));
    let (mut fa, mut fb) = (f(a), f(b));
    let ends = [from, to];
    for _ in 0..STEPS {
        if fa >= fb {
            (to, b, fb) = (b, a, fa);
            a = to - GOLDEN * (to - from);
            fa = f(a);
        } else {
            (from, a, fa) = (a, b, fb);
            b = from + GOLDEN * (to - from);
            fb = f(b);
        }
    }
    let middle = 0.5 * (from + to);
    // At an end the section only comes near.
    ends.into_iter().rfind(|end| f(*end) >= f(middle)).unwrap_or(middle)
}

/// A range of strips: those that begin in the one interval and end in the other.
struct Range {
    left: (f64, f64),
    right: (f64, f64),
    /// No rectangle of theirs is larger.
    bound: f64,
}

/// The largest rectangle of any polygon, by branch and bound over strips.
fn searched(polygon: &Polygon) -> Option<Bounds> {
    let field = Field::new(polygon);
    let mut places: Vec<f64> = polygon.points().iter().map(|p| p.x).collect();
    places.sort_by(f64::total_cmp);
    places.dedup();
    let whole = (*places.first()?, *places.last()?);
    let mut open = BinaryHeap::from([Range { left: whole, right: whole, bound: polygon.area() }]);
    let mut best: Option<Found> = None;
    let mut looked = 0;
    while let Some(range) = open.pop() {
        let known = best.map_or(0.0, |found| found.area + CLOSE * found.bounds.size().element_sum());
        if range.bound <= known || looked >= MOST_RANGES {
            break;
        }
        looked += 1;
        for half in range.halves(&places) {
            let middle = |side: (f64, f64)| 0.5 * (side.0 + side.1);
            let tried = [(half.left.0, half.right.1), (middle(half.left), middle(half.right))];
            for found in tried.into_iter().filter(|(a, b)| a < b).filter_map(|(a, b)| field.across(a, b)) {
                if best.is_none_or(|best| found.area > best.area) {
                    best = Some(found);
                }
            }
            open.extend(half.bounded(&field, polygon));
        }
    }
    best.map(|found| found.bounds)
}

impl Range {
    /// The range in two along its wider side, at the corner of the polygon nearest to the middle if there is one.
    fn halves(&self, places: &[f64]) -> [Range; 2] {
        let cut = |side: (f64, f64)| {
            let middle = 0.5 * (side.0 + side.1);
            let after = places.partition_point(|place| *place < middle);
            let near = [after.checked_sub(1), Some(after)].into_iter().flatten().filter_map(|i| places.get(i));
            let inner = near.filter(|place| **place > side.0 && **place < side.1);
            inner.min_by(|a, b| (*a - middle).abs().total_cmp(&(*b - middle).abs())).copied().unwrap_or(middle)
        };
        let Range { left, right, bound } = *self;
        if left.1 - left.0 >= right.1 - right.0 {
            let at = cut(left);
            [Range { left: (left.0, at), right, bound }, Range { left: (at, left.1), right, bound }]
        } else {
            let at = cut(right);
            [Range { left, right: (right.0, at), bound }, Range { left, right: (at, right.1), bound }]
        }
    }

    /// The range with its bound; `None` where it has no strip.
    fn bounded(self, field: &Field, polygon: &Polygon) -> Option<Range> {
        let widest = self.right.1 - self.left.0;
        if widest <= 0.0 {
            return None;
        }
        let narrowest = (self.left.1, self.right.0);
        let bound = match narrowest.0 < narrowest.1 {
            true => widest * field.across(narrowest.0, narrowest.1).map_or(0.0, |found| found.bounds.size().y),
            false => widest * polygon.bounds().size().y,
        };
        Some(Range { bound: bound.min(self.bound), ..self })
    }
}

impl PartialEq for Range {
    fn eq(&self, other: &Range) -> bool {
        self.cmp(other).is_eq()
    }
}

impl Eq for Range {}

impl PartialOrd for Range {
    fn partial_cmp(&self, other: &Range) -> Option<std::cmp::Ordering> {
        Some(self.cmp(other))
    }
}

impl Ord for Range {
    fn cmp(&self, other: &Range) -> std::cmp::Ordering {
        let place = |r: &Range| [r.bound, r.left.0, r.right.0, r.left.1];
        let pairs = place(self).into_iter().zip(place(other));
        pairs.map(|(a, b)| a.total_cmp(&b)).find(|order| order.is_ne()).unwrap_or(std::cmp::Ordering::Equal)
    }
}
