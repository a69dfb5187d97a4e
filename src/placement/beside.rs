//! Lines moved aside: what of each edge lies at a distance from all edges, joined into runs.
//!
//! In: lines, a distance, the turn that makes a corner. Out: runs, each a polyline. Every edge is moved by itself and
//! cut to where the corridor of no other edge covers it; so nothing loops, whatever the lines do.

use crate::geometry::{Bounds, BoxGrid};
use crate::placement::Line;
use glam::DVec2;

/// Corridors are narrower than the distance by this (metres), so that what only touches stays.
const TOUCH: f64 = 1e-7;

/// Moved edges whose ends are nearer than this (metres) meet.
const MEET: f64 = 1e-4;

/// Moved edges are prolonged around a vertex by at most this many times the distance.
const LONGEST_MITRE: f64 = 2.0;

/// A stretch between two corners.
#[derive(Clone, Debug)]
pub(super) struct Run {
    pub points: Vec<DVec2>,
    pub closed: bool,
}

/// An edge of a line, to be moved.
#[derive(Clone, Copy)]
struct Edge {
    from: DVec2,
    along: DVec2,
    length: f64,
    /// Which line it belongs to.
    line: u32,
    /// The edges before and after it in the line.
    beside: [Option<u32>; 2],
}

/// A part of a moved edge.
struct Piece {
    edge: u32,
    ends: [DVec2; 2],
}

/// The runs of all lines moved left by a distance (metres; right where it is negative), in their order. Points that are
/// no numbers are left out.
pub(super) fn runs(lines: &[Line], distance: f64, turn: f64) -> Vec<Run> {
    let edges = edges(lines);
    let boxes: Vec<Bounds> = edges.iter().map(|e| Bounds::of([e.from, e.to()])).collect();
    let grid = BoxGrid::new(&boxes);
    let mut pieces = Vec::new();
    let mut cuts = Vec::new();
    for (index, edge) in edges.iter().enumerate() {
        let [start, end] = edge.reach(&edges, distance);
        let moved = |t: f64| edge.from + edge.along * t + edge.along.perp() * distance;
        cuts.clear();
        if distance != 0.0 && start < end {
            let near = Bounds::of([moved(start), moved(end)]).grown(distance.abs());
            let beside = |i: usize| i == index || edge.beside.contains(&Some(i as u32));
            let others = grid.touching(near).filter(|i| !beside(*i));
            cuts.extend(others.filter_map(|i| edges[i].covers(edge, moved(0.0), distance.abs() - TOUCH)));
        }
        for [s, t] in left_over([start, end], &mut cuts) {
            pieces.push(Piece { edge: index as u32, ends: [moved(s), moved(t)] });
        }
    }
    joined(&pieces, &edges, libm::cos(turn.to_radians()))
}

fn edges(lines: &[Line]) -> Vec<Edge> {
    let mut edges: Vec<Edge> = Vec::new();
    for (line, each) in lines.iter().enumerate() {
        let mut points: Vec<DVec2> = each.points.iter().copied().filter(|p| p.is_finite()).collect();
        points.dedup();
        while each.closed && points.len() > 1 && points.first() == points.last() {
            points.pop();
        }
        let count = if each.closed && points.len() > 2 { points.len() } else { points.len().saturating_sub(1) };
        let (first, closed) = (edges.len() as u32, count == points.len());
        for i in 0..count {
            let (from, to) = (points[i], points[(i + 1) % points.len()]);
            let before = if i > 0 { Some(i - 1) } else { closed.then_some(count - 1) };
            let after = if i + 1 < count { Some(i + 1) } else { closed.then_some(0) };
            edges.push(Edge {
                from,
                along: (to - from).normalize_or(DVec2::X),
                length: from.distance(to),
                line: line as u32,
                beside: [before, after].map(|i| i.map(|i| first + i as u32)),
            });
        }
    }
    edges
}

impl Edge {
    fn to(&self) -> DVec2 {
        self.from + self.along * self.length
    }

    /// From where to where the moved edge goes before others cut it: to where it meets its moved neighbours.
    fn reach(&self, edges: &[Edge], distance: f64) -> [f64; 2] {
        let neighbour = |side: usize| self.beside[side].map(|i| edges[i as usize].along);
        let before = neighbour(0).map_or(0.0, |along| mitre(along, self.along, distance));
        let after = neighbour(1).map_or(0.0, |along| mitre(self.along, along, distance));
        [before, self.length - after]
    }

    /// Where along the moved line of another edge, `origin` its start, it is nearer than `radius`.
    fn covers(&self, other: &Edge, origin: DVec2, radius: f64) -> Option<[f64; 2]> {
        let disk = |centre: DVec2| {
            let (t, away) = (other.along.dot(centre - origin), other.along.perp_dot(centre - origin));
            let half = (radius * radius - away * away).max(0.0).sqrt();
            (away.abs() < radius).then_some([t - half, t + half])
        };
        // What is near is convex: one stretch from the first to the last of its parts.
        let parts = [disk(self.from), disk(self.to()), self.slab(other, origin, radius)];
        parts.into_iter().flatten().reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])])
    }

    /// Where the line passes through the rectangle of twice the radius around the edge.
    fn slab(&self, other: &Edge, origin: DVec2, radius: f64) -> Option<[f64; 2]> {
        let (at, step) = (origin - self.from, other.along);
        let within = |at: f64, step: f64, low: f64, high: f64| {
            let ends = [(low - at) / step, (high - at) / step];
            if step == 0.0 {
                return (low < at && at < high).then_some([f64::NEG_INFINITY, f64::INFINITY]);
            }
            Some([ends[0].min(ends[1]), ends[0].max(ends[1])])
        };
        let a = within(self.along.dot(at), self.along.dot(step), 0.0, self.length)?;
        let b = within(self.along.perp_dot(at), self.along.perp_dot(step), -radius, radius)?;
        let both = [a[0].max(b[0]), a[1].min(b[1])];
        (both[0] < both[1]).then_some(both)
    }
}

/// By how much a moved edge is shortened at a vertex to meet its moved neighbour; less than nothing where it is
/// prolonged.
fn mitre(before: DVec2, after: DVec2, distance: f64) -> f64 {
    // The tangent of half the turn.
    let tangent = before.perp_dot(after) / (1.0 + before.dot(after)).max(1e-12);
    (tangent * distance).max(-LONGEST_MITRE * distance.abs())
}

/// A stretch without those that are cut out, in order.
fn left_over([start, end]: [f64; 2], cuts: &mut [[f64; 2]]) -> impl Iterator<Item = [f64; 2]> {
    cuts.sort_unstable_by(|a, b| a[0].total_cmp(&b[0]));
    let mut from = start;
    let last = [end, f64::INFINITY];
    let gaps = cuts.iter().copied().chain([last]).filter_map(move |cut| {
        let gap = [from, cut[0].min(end)];
        from = from.max(cut[1]);
        (gap[0] < gap[1]).then_some(gap)
    });
    gaps.collect::<Vec<_>>().into_iter()
}

/// Pieces joined where they meet without a corner.
fn joined(pieces: &[Piece], edges: &[Edge], straight: f64) -> Vec<Run> {
    let meets = |a: &Piece, b: &Piece| {
        let (from, to) = (&edges[a.edge as usize], &edges[b.edge as usize]);
        a.edge != b.edge
            && from.line == to.line
            && a.ends[1].distance_squared(b.ends[0]) <= MEET * MEET
            && from.along.dot(to.along) >= straight
    };
    let mut runs = Vec::new();
    for line in pieces.chunk_by(|a, b| edges[a.edge as usize].line == edges[b.edge as usize].line) {
        let start = runs.len();
        for stretch in line.chunk_by(meets) {
            let mut points = vec![stretch[0].ends[0]];
            points.extend(stretch.iter().map(|piece| piece.ends[1]));
            runs.push(Run { points, closed: false });
        }
        if line.len() > 1 && meets(&line[line.len() - 1], &line[0]) {
            close(&mut runs, start);
        }
    }
    runs
}

/// Joins the last run to the one at `start`, or with itself.
fn close(runs: &mut Vec<Run>, start: usize) {
    if runs.len() == start + 1 {
        runs[start].closed = true;
    } else if let Some(mut last) = runs.pop() {
        last.points.extend_from_slice(&runs[start].points[1..]);
        runs[start] = last;
    }
}
