//! The moving edges of a polygon, event by event.
//!
//! The edges' ends form rings of vertices. An edge that shrinks to nothing takes its two vertices together; a concave
//! vertex that runs into an edge joins the ring there differently, which splits a ring or, from a hole, merges two;
//! two edges that meet along their length leave a ridge at once. What a vertex has run along is an arc between the
//! faces of its two edges.

use crate::geometry::Polygon;
use glam::{DVec2, DVec3};

/// Lengths below this (metres) are none.
const NEAR: f64 = 1e-7;
/// Edges whose directions differ by less (sine of the angle) are parallel.
const PARALLEL: f64 = 1e-9;

/// An edge of the polygon.
struct Edge {
    along: DVec2,
    /// Inwards, the way it moves.
    normal: DVec2,
    /// Where it starts: distance along the normal.
    at: f64,
    speed: f64,
}

/// A corner of the moving outline.
#[derive(Clone, Debug)]
struct Vertex {
    /// The edge that ends here, and the one that begins.
    edges: [usize; 2],
    previous: usize,
    next: usize,
    /// The node where it began.
    node: u32,
    position: DVec2,
    time: f64,
    motion: Motion,
    alive: bool,
}

/// How a vertex moves.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Motion {
    /// By this velocity.
    Along(DVec2),
    /// Its edges lie upon each other: a ridge runs from it at once.
    Ridge,
}

/// A piece of the skeleton: seen from its start, the faces of which edges lie left and right.
pub(super) struct Arc {
    pub from: u32,
    pub to: u32,
    pub left: usize,
    pub right: usize,
}

/// What a run leaves: nodes, arcs, and the rings of the polygon's corners.
pub(super) struct Traces {
    pub nodes: Vec<DVec3>,
    pub arcs: Vec<Arc>,
    /// For each edge the nodes at its ends.
    pub ends: Vec<[u32; 2]>,
}

/// What happens next.
enum Event {
    /// The edge behind this vertex is gone.
    Collapse(usize),
    /// The vertex runs into the edge behind another vertex.
    Split(usize, usize),
}

/// The outline on its way.
pub(super) struct Wavefront {
    edges: Vec<Edge>,
    vertices: Vec<Vertex>,
    traces: Traces,
    now: f64,
    sound: bool,
}

impl Wavefront {
    pub fn new(polygon: &Polygon, speeds: &[f64]) -> Wavefront {
        let edge = |(index, (a, b)): (usize, (DVec2, DVec2))| {
            let along = (b - a).normalize_or_zero();
            Edge { along, normal: along.perp(), at: along.perp().dot(a), speed: *speeds.get(index).unwrap_or(&1.0) }
        };
        let edges: Vec<Edge> = polygon.edges().enumerate().map(edge).collect();
        let nodes = polygon.points().iter().map(|p| p.extend(0.0)).collect();
        let traces = Traces { nodes, arcs: Vec::new(), ends: Vec::with_capacity(edges.len()) };
        let mut front = Wavefront { edges, vertices: Vec::new(), traces, now: 0.0, sound: true };
        for ring in polygon.rings() {
            front.ring(ring);
        }
        front
    }

    fn ring(&mut self, ring: &[DVec2]) {
        let (first, count) = (self.vertices.len(), ring.len());
        for (i, position) in ring.iter().enumerate() {
            let (before, after) = (first + (i + count - 1) % count, first + i);
            let links = [before, first + (i + 1) % count];
            self.traces.ends.push([after as u32, links[1] as u32]);
            self.add([before, after], links, (after as u32, *position));
        }
    }

    /// Runs until nothing moves; `None` where it finds no end.
    pub fn run(mut self) -> Option<Traces> {
        let most = 16 * self.vertices.len() + 64;
        for _ in 0..most {
            if !self.sound {
                return None;
            }
            if let Some(ridge) = self.vertices.iter().position(|v| v.alive && v.motion == Motion::Ridge) {
                self.ridge(ridge);
                continue;
            }
            let Some((time, event)) = self.earliest() else {
                return self.vertices.iter().all(|v| !v.alive).then_some(self.traces);
            };
            self.now = time;
            match event {
                Event::Collapse(vertex) => self.collapse(vertex),
                Event::Split(vertex, before) => self.split(vertex, before),
            }
        }
        None
    }

    fn earliest(&self) -> Option<(f64, Event)> {
        let alive = || (0..self.vertices.len()).filter(|v| self.vertices[*v].alive);
        let mut first: Option<(f64, Event)> = None;
        let mut consider = |time: f64, event: Event| {
            if first.as_ref().is_none_or(|(earliest, _)| time < *earliest) {
                first = Some((time, event));
            }
        };
        for vertex in alive() {
            if let Some(time) = self.collapse_time(vertex) {
                consider(time, Event::Collapse(vertex));
            }
        }
        for vertex in alive().filter(|v| self.is_concave(*v)) {
            for before in alive() {
                if let Some(time) = self.split_time(vertex, before) {
                    consider(time, Event::Split(vertex, before));
                }
            }
        }
        first
    }

    fn at(&self, vertex: usize, time: f64) -> DVec2 {
        let vertex = &self.vertices[vertex];
        match vertex.motion {
            Motion::Along(velocity) => vertex.position + velocity * (time - vertex.time),
            Motion::Ridge => vertex.position,
        }
    }

    fn velocity(&self, vertex: usize) -> DVec2 {
        match self.vertices[vertex].motion {
            Motion::Along(velocity) => velocity,
            Motion::Ridge => DVec2::ZERO,
        }
    }

    fn is_concave(&self, vertex: usize) -> bool {
        let [before, after] = self.vertices[vertex].edges;
        self.edges[before].along.perp_dot(self.edges[after].along) < -PARALLEL
    }

    /// When the edge behind a vertex has shrunk to nothing.
    fn collapse_time(&self, vertex: usize) -> Option<f64> {
        let next = self.vertices[vertex].next;
        let along = self.edges[self.vertices[vertex].edges[1]].along;
        let length = along.dot(self.at(next, self.now) - self.at(vertex, self.now));
        let shrinks = -along.dot(self.velocity(next) - self.velocity(vertex));
        if length <= NEAR && shrinks > -PARALLEL {
            return Some(self.now);
        }
        (shrinks > PARALLEL).then(|| self.now + length.max(0.0) / shrinks)
    }

    /// When a concave vertex runs into the edge behind another.
    fn split_time(&self, vertex: usize, before: usize) -> Option<f64> {
        let hit = &self.edges[self.vertices[before].edges[1]];
        let next = self.vertices[before].next;
        if vertex == before || vertex == next {
            return None;
        }
        let gap = hit.normal.dot(self.at(vertex, self.now)) - hit.at - hit.speed * self.now;
        let closes = hit.speed - hit.normal.dot(self.velocity(vertex));
        if gap < -NEAR || closes <= PARALLEL {
            return None;
        }
        let time = self.now + gap.max(0.0) / closes;
        let place = hit.along.dot(self.at(vertex, time));
        let within = hit.along.dot(self.at(before, time)) - NEAR..=hit.along.dot(self.at(next, time)) + NEAR;
        within.contains(&place).then_some(time)
    }

    /// The two ends of an edge have met.
    fn collapse(&mut self, vertex: usize) {
        let next = self.vertices[vertex].next;
        let place = (self.at(vertex, self.now) + self.at(next, self.now)) * 0.5;
        let node = self.node(place);
        let edges = [self.vertices[vertex].edges[0], self.vertices[next].edges[1]];
        let links = [self.vertices[vertex].previous, self.vertices[next].next];
        self.finish(vertex, node);
        self.finish(next, node);
        // Of a ring of two nothing is left.
        if links[0] != next {
            self.join(edges, links, (node, place));
        }
    }

    /// A concave vertex has met the edge behind another.
    fn split(&mut self, vertex: usize, before: usize) {
        let place = self.at(vertex, self.now);
        let node = self.node(place);
        let [arriving, leaving] = self.vertices[vertex].edges;
        let hit = self.vertices[before].edges[1];
        let (previous, next) = (self.vertices[vertex].previous, self.vertices[vertex].next);
        let after = self.vertices[before].next;
        self.finish(vertex, node);
        self.join([arriving, hit], [previous, after], (node, place));
        self.join([hit, leaving], [before, next], (node, place));
    }

    /// Two edges lie upon each other from this vertex to the nearer of its neighbours: that is a ridge.
    fn ridge(&mut self, vertex: usize) {
        let Vertex { previous, next, node: from, position, edges, .. } = self.vertices[vertex].clone();
        let distance = |other: usize| self.at(other, self.now).distance_squared(position);
        let forward = distance(next) <= distance(previous);
        let other = if forward { next } else { previous };
        let place = self.at(other, self.now);
        let node = self.node(place);
        self.arc(from, node, edges);
        self.vertices[vertex].alive = false;
        self.finish(other, node);
        let other = self.vertices[other].clone();
        let (edges, links) = match forward {
            true => ([edges[0], other.edges[1]], [previous, other.next]),
            false => ([other.edges[0], edges[1]], [other.previous, next]),
        };
        if previous != next {
            self.join(edges, links, (node, place));
        }
    }

    /// A new vertex between two others.
    fn join(&mut self, edges: [usize; 2], links: [usize; 2], at: (u32, DVec2)) {
        let new = self.vertices.len();
        self.vertices[links[0]].next = new;
        self.vertices[links[1]].previous = new;
        self.add(edges, links, at);
    }

    fn add(&mut self, edges: [usize; 2], [previous, next]: [usize; 2], (node, position): (u32, DVec2)) {
        let motion = self.motion(&self.edges[edges[0]], &self.edges[edges[1]]);
        self.sound &= motion.is_some() && self.vertices.len() < u32::MAX as usize;
        let motion = motion.unwrap_or(Motion::Ridge);
        let time = self.now;
        self.vertices.push(Vertex { edges, previous, next, node, position, time, motion, alive: true });
    }

    /// How the corner between two edges moves; `None` where one edge would have to be in two places.
    fn motion(&self, before: &Edge, after: &Edge) -> Option<Motion> {
        let turn = before.normal.perp_dot(after.normal);
        if turn.abs() > PARALLEL {
            // n · v is the speed, for both normals.
            let velocity = (before.normal * after.speed - after.normal * before.speed).perp() / turn;
            return velocity.is_finite().then_some(Motion::Along(velocity));
        }
        if before.normal.dot(after.normal) < 0.0 {
            return Some(Motion::Ridge);
        }
        let same = (before.speed - after.speed).abs() < PARALLEL;
        same.then_some(Motion::Along(before.normal * before.speed))
    }

    /// The vertex has come to its end.
    fn finish(&mut self, vertex: usize, node: u32) {
        let Vertex { node: from, edges, .. } = self.vertices[vertex];
        self.vertices[vertex].alive = false;
        self.arc(from, node, edges);
    }

    fn arc(&mut self, from: u32, to: u32, [left, right]: [usize; 2]) {
        if from != to && left != right {
            self.traces.arcs.push(Arc { from, to, left, right });
        }
    }

    /// The node at a place and the present time.
    fn node(&mut self, place: DVec2) -> u32 {
        let new = place.extend(self.now);
        let found = self.traces.nodes.iter().position(|node| node.distance_squared(new) < NEAR * NEAR * 4.0);
        found.unwrap_or_else(|| {
            self.traces.nodes.push(new);
            self.traces.nodes.len() - 1
        }) as u32
    }
}
