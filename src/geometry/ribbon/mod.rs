//! A ribbon: a line with its offset curves, and the coordinates they give to the plane around it.
//!
//! In: a line and how far to its sides it is wanted. Out: for every point there the metres along the line and across
//! it, left positive, and the way back. Offset curves have mitred corners, so that across a segment the coordinates are
//! those of a trapezium: what is as far along lies on a straight line, what is as far across runs parallel to the
//! segment. The line is thinned until no curve folds, so the coordinates are one to one.

mod middle;

use crate::geometry::{Area, Bounds};
use glam::DVec2;

/// Offset curves keep at least this share of their segment's length.
const LEAST_SHARE: f64 = 0.05;

/// The ends go on straight this many times as far as the ribbon reaches to its sides.
const BEYOND: f64 = 2.0;

/// A line with coordinates along and across.
#[derive(Clone, Debug, PartialEq)]
pub struct Ribbon {
    /// The vertices; the first and the last only lead on straight beyond the ends.
    points: Vec<DVec2>,
    /// How a vertex moves for each metre that its offset curve is to the left.
    mitres: Vec<DVec2>,
    /// Metres along at each vertex: 0 where the line begins, after the vertex that leads there.
    starts: Vec<f64>,
}

/// One segment with its offset curves.
#[derive(Clone, Copy)]
struct Cell {
    from: DVec2,
    mitre: DVec2,
    along: DVec2,
    length: f64,
    start: f64,
    /// How much longer its offset curve is for each metre to the left.
    growth: f64,
}

impl Ribbon {
    /// The ribbon about a line that is wanted as far as `reach` metres to both sides; corners that would fold there are
    /// left out. `None` where the line has no length. Quadratic in the corners that fold, else linear.
    pub fn new(line: &[DVec2], reach: f64) -> Option<Ribbon> {
        let mut line: Vec<DVec2> = line.iter().copied().filter(|p| p.is_finite()).collect();
        let reach = reach.abs().max(1e-3);
        loop {
            line.dedup_by(|a, b| a.distance_squared(*b) < 1e-12);
            if line.len() < 2 || !reach.is_finite() {
                return None;
            }
            let ribbon = Ribbon::through(&line, reach * BEYOND);
            let Some(fold) = ribbon.fold(reach) else { return Some(ribbon) };
            // The first and last vertices of the line stay; in the ribbon all are counted from one further on.
            line.remove(fold.clamp(1, line.len() - 2));
        }
    }

    /// Length of the line, metres.
    pub fn length(&self) -> f64 {
        self.starts[self.starts.len() - 2]
    }

    /// The same ribbon from the other end.
    pub fn reversed(&self) -> Ribbon {
        let length = self.length();
        Ribbon {
            points: self.points.iter().rev().copied().collect(),
            mitres: self.mitres.iter().rev().map(|m| -*m).collect(),
            starts: self.starts.iter().rev().map(|s| length - s).collect(),
        }
    }

    /// The point so far along and across.
    pub fn at(&self, place: DVec2) -> DVec2 {
        let cell = self.cell(self.index(place.x));
        cell.foot(place.y) + cell.along * ((place.x - cell.start) * cell.share(place.y))
    }

    /// How far along and across a point lies; beyond the reach of the ribbon the nearest place that can be said.
    /// Linear in the segments.
    pub fn find(&self, point: DVec2) -> DVec2 {
        let cells = (0..self.points.len() - 1).map(|i| self.cell(i));
        let last = self.points.len() - 2;
        let places = cells.enumerate().map(|(index, cell)| {
            let across = (point - cell.from).dot(cell.along.perp());
            let along = (point - cell.foot(across)).dot(cell.along) / cell.share(across).max(1e-9);
            let inside = along.clamp(0.0, cell.length);
            // Beyond its ends the ribbon goes on, but what another segment has is not theirs.
            let leads_on = (index == 0 && along < inside) || (index == last && along > inside);
            let place = DVec2::new(cell.start + if leads_on { along } else { inside }, across);
            ((along - inside).abs(), place)
        });
        let nearest = places.min_by(|(a, p), (b, q)| a.total_cmp(b).then(p.y.abs().total_cmp(&q.y.abs())));
        nearest.map_or(DVec2::ZERO, |(_, place)| place)
    }

    /// A ring of places along and across as one in the plane: its edges get a vertex wherever the line has one.
    pub fn outline(&self, ring: &[DVec2]) -> Vec<DVec2> {
        let mut outline = Vec::with_capacity(ring.len() + self.points.len());
        for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
            outline.push(self.at(*a));
            let between = |s: &f64| *s > a.x.min(b.x) && *s < a.x.max(b.x);
            let crossed = self.starts.iter().copied().filter(between);
            let at = |s: f64| self.at(a.lerp(*b, (s - a.x) / (b.x - a.x)));
            match a.x < b.x {
                true => outline.extend(crossed.map(at)),
                false => outline.extend(crossed.rev().map(at)),
            }
        }
        outline
    }

    /// The least and greatest places along and across of an area. Cost: its vertices times the segments.
    pub fn extent(&self, area: &Area) -> Bounds {
        let mut places = Vec::new();
        for (a, b) in area.edges() {
            let (from, to) = (self.find(a), self.find(b));
            places.push(from);
            let between = |i: &usize| self.starts[*i] > from.x.min(to.x) && self.starts[*i] < from.x.max(to.x);
            places.extend((0..self.points.len()).filter(between).filter_map(|i| self.crossing(i, a, b)));
        }
        Bounds::of(places)
    }

    /// The length of the offset curve so far across, between two places along; negative backwards.
    pub fn distance(&self, from: f64, to: f64, across: f64) -> f64 {
        if to < from {
            return -self.distance(to, from, across);
        }
        let (first, last) = (self.index(from), self.index(to));
        let lengths = (first..=last).map(|index| {
            let cell = self.cell(index);
            let low = if index == first { from } else { cell.start };
            let high = if index == last { to } else { cell.start + cell.length };
            (high - low) * cell.share(across)
        });
        lengths.sum()
    }

    /// How far along one is after so many metres on the offset curve so far across.
    pub fn advanced(&self, from: f64, metres: f64, across: f64) -> f64 {
        let (mut at, mut left, mut index) = (from, metres, self.index(from));
        loop {
            let cell = self.cell(index);
            let share = cell.share(across).max(1e-9);
            let room = (cell.start + cell.length - at) * share;
            if left <= room || index + 2 == self.points.len() {
                return at + left / share;
            }
            (at, left, index) = (cell.start + cell.length, left - room, index + 1);
        }
    }

    /// The ribbon through all vertices, its ends led on by so many metres.
    fn through(line: &[DVec2], beyond: f64) -> Ribbon {
        let last = line.len() - 1;
        let first = line[0] - (line[1] - line[0]).normalize() * beyond;
        let end = line[last] + (line[last] - line[last - 1]).normalize() * beyond;
        let points: Vec<DVec2> = [first].into_iter().chain(line.iter().copied()).chain([end]).collect();
        let along: Vec<DVec2> = points.windows(2).map(|w| (w[1] - w[0]).normalize()).collect();
        let mitre = |i: usize| {
            let (before, after) = (along[i.saturating_sub(1)].perp(), along[i.min(along.len() - 1)].perp());
            let sum = before + after;
            // Where the line turns right round there is no mitre; such a corner counts as a fold.
            sum * (2.0 / sum.length_squared().max(1e-6))
        };
        let mitres = (0..points.len()).map(mitre).collect();
        let mut starts = vec![-beyond];
        for pair in points.windows(2) {
            starts.push(starts[starts.len() - 1] + pair[0].distance(pair[1]));
        }
        let offset = starts[1];
        starts.iter_mut().for_each(|s| *s -= offset);
        Ribbon { points, mitres, starts }
    }

    /// The vertex of the line to leave out where a curve folds; of the two at a segment the one that turns more.
    fn fold(&self, reach: f64) -> Option<usize> {
        let inner = 2..self.points.len() - 2;
        let folds = |i: usize| {
            let cell = self.cell(i);
            1.0 - reach * cell.growth.abs() < LEAST_SHARE
        };
        let segment = (1..self.points.len() - 2).filter(|_| !inner.is_empty()).find(|i| folds(*i))?;
        let turn = |i: usize| if inner.contains(&i) { self.mitres[i].length_squared() } else { 0.0 };
        Some(if turn(segment) >= turn(segment + 1) { segment - 1 } else { segment })
    }

    fn index(&self, along: f64) -> usize {
        self.starts.partition_point(|s| *s <= along).clamp(1, self.points.len() - 1) - 1
    }

    fn cell(&self, index: usize) -> Cell {
        let (from, to) = (self.points[index], self.points[index + 1]);
        let length = from.distance(to);
        let along = (to - from) / length;
        let growth = (self.mitres[index + 1] - self.mitres[index]).dot(along) / length;
        Cell { from, mitre: self.mitres[index], along, length, start: self.starts[index], growth }
    }

    /// Where an edge crosses the line on which a vertex and its offsets lie.
    fn crossing(&self, vertex: usize, a: DVec2, b: DVec2) -> Option<DVec2> {
        let (at, mitre) = (self.points[vertex], self.mitres[vertex]);
        let (low, high) = (mitre.perp_dot(a - at), mitre.perp_dot(b - at));
        let share = low / (low - high);
        let across = (a.lerp(b, share) - at).dot(mitre) / mitre.length_squared();
        (0.0..=1.0).contains(&share).then_some(DVec2::new(self.starts[vertex], across))
    }
}

impl Cell {
    /// Where its offset curve begins.
    fn foot(&self, across: f64) -> DVec2 {
        self.from + self.mitre * across
    }

    /// How long its offset curve is beside its own length.
    fn share(&self, across: f64) -> f64 {
        1.0 + self.growth * across
    }
}
