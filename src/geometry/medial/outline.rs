//! A polygon's outline in whole numbers, as the Voronoi crate takes it.
//!
//! In: a polygon and a turn. Out: its vertices on a millimetre grid around its middle, or nothing where rounding has
//! made edges cross or touch, which the crate must never see.

use crate::geometry::{Bounds, BoxGrid, Polygon};
use glam::DVec2;

/// Steps of the grid per metre.
const STEPS: f64 = 1000.0;

/// No coordinate is larger than this many steps, so that products fit 64 bits: in wider parts the steps grow.
const FARTHEST: f64 = 2.5e8;

/// Rings of whole numbers, edges from each vertex to its `next`; the inside lies to the left.
pub(super) struct Outline {
    pub points: Vec<[i32; 2]>,
    /// The vertex after each in its ring.
    pub next: Vec<u32>,
    /// Whether the inside has more than a half turn at each vertex.
    pub reflex: Vec<bool>,
    /// Whether the rim comes by each vertex more than once.
    pub shared: Vec<bool>,
    /// How many separate pieces the axis must have: 1, unless the rim touches itself.
    pub pieces: usize,
    /// How many loops the axis must have: one for each hole.
    pub loops: usize,
    frame: Frame,
}

/// The way to the grid and back.
struct Frame {
    centre: DVec2,
    /// Unit vector of the grid's x axis.
    axis: DVec2,
    steps: f64,
}

impl Outline {
    /// The polygon turned by an angle (radians) and rounded; rings that rounding flattens are left out. `None` where
    /// nothing is left or edges meet between their ends.
    pub fn new(polygon: &Polygon, turn: f64) -> Option<Outline> {
        let frame = Frame::new(polygon.bounds(), turn)?;
        let mut outline =
            Outline { points: vec![], next: vec![], reflex: vec![], shared: vec![], pieces: 1, loops: 0, frame };
        for (i, ring) in polygon.rings().enumerate() {
            if !outline.push(ring) && i == 0 {
                return None;
            }
        }
        outline.mark_reflex();
        outline.count_holes();
        outline.is_sound().then_some(outline)
    }

    /// The edge that starts at a vertex.
    pub fn edge(&self, start: usize) -> [[i32; 2]; 2] {
        [self.points[start], self.points[self.next[start] as usize]]
    }

    /// Whether a place on the grid is inside. Linear.
    pub fn contains(&self, p: DVec2) -> bool {
        let crosses = |i: &usize| {
            let [a, b] = self.edge(*i).map(|q| DVec2::new(f64::from(q[0]), f64::from(q[1])));
            (a.y > p.y) != (b.y > p.y) && ((b - a).perp_dot(p - a) > 0.0) == (b.y > a.y)
        };
        (0..self.points.len()).filter(crosses).count() % 2 == 1
    }

    /// A place on the grid in the plan.
    pub fn to_plan(&self, q: DVec2) -> DVec2 {
        self.frame.centre + self.frame.axis.rotate(q / self.frame.steps)
    }

    /// A length on the grid in metres.
    pub fn metres(&self, length: f64) -> f64 {
        length / self.frame.steps
    }

    /// A length in metres on the grid.
    pub fn steps(&self, length: f64) -> f64 {
        length * self.frame.steps
    }

    /// Adds a ring, unless rounding has flattened it.
    fn push(&mut self, ring: &[DVec2]) -> bool {
        let first = self.points.len();
        self.points.extend(ring.iter().map(|p| self.frame.grid(*p)));
        let mut kept = first;
        for i in first..self.points.len() {
            if kept == first || self.points[i] != self.points[kept - 1] {
                self.points[kept] = self.points[i];
                kept += 1;
            }
        }
        while kept > first + 1 && self.points[kept - 1] == self.points[first] {
            kept -= 1;
        }
        self.points.truncate(kept);
        if kept < first + 3 || !has_area(&self.points[first..]) {
            self.points.truncate(first);
            return false;
        }
        self.next.extend((first..kept).map(|i| if i + 1 < kept { i as u32 + 1 } else { first as u32 }));
        true
    }

    fn mark_reflex(&mut self) {
        self.reflex = vec![false; self.points.len()];
        for i in 0..self.points.len() {
            let here = self.next[i] as usize;
            let beyond = self.points[self.next[here] as usize];
            self.reflex[here] = turn(self.points[i], self.points[here], beyond) < 0;
        }
    }

    /// By Euler's formula on the graph of vertices and edges, since rings may share vertices.
    fn count_holes(&mut self) {
        let mut order: Vec<u32> = (0..self.points.len() as u32).collect();
        order.sort_unstable_by_key(|i| (self.points[*i as usize], *i));
        let mut joined = Joined::new(self.points.len());
        let mut clusters = self.points.len();
        let mut shared = 0;
        self.shared = vec![false; self.points.len()];
        for i in 0..self.points.len() {
            clusters -= usize::from(joined.join(i as u32, self.next[i]));
        }
        let rings = clusters;
        for pair in order.windows(2).filter(|w| self.points[w[0] as usize] == self.points[w[1] as usize]) {
            shared += 1;
            pair.iter().for_each(|i| self.shared[*i as usize] = true);
            clusters -= usize::from(joined.join(pair[0], pair[1]));
        }
        self.loops = clusters - 1;
        self.pieces = (shared + clusters + 1).saturating_sub(rings);
    }

    /// Whether edges meet at their ends only.
    fn is_sound(&self) -> bool {
        let corner = |p: [i32; 2]| DVec2::new(f64::from(p[0]), f64::from(p[1]));
        let bounds = |i: usize| Bounds::of(self.edge(i).map(corner));
        let boxes: Vec<Bounds> = (0..self.points.len()).map(bounds).collect();
        let grid = BoxGrid::new(&boxes);
        (0..boxes.len()).all(|i| grid.touching(boxes[i]).all(|j| j <= i || !collide(self.edge(i), self.edge(j))))
    }
}

impl Frame {
    fn new(bounds: Bounds, turn: f64) -> Option<Frame> {
        let reach = bounds.size().length() * 0.5;
        let steps = STEPS.min(FARTHEST / reach);
        let (sin, cos) = libm::sincos(turn);
        (reach.is_finite() && steps > 0.0).then_some(Frame {
            centre: bounds.centre(),
            axis: DVec2::new(cos, sin),
            steps,
        })
    }

    fn grid(&self, p: DVec2) -> [i32; 2] {
        let q = DVec2::new(self.axis.x, -self.axis.y).rotate(p - self.centre) * self.steps;
        [q.x.round() as i32, q.y.round() as i32]
    }
}

/// Which of some things hang together.
pub(super) struct Joined(Vec<u32>);

impl Joined {
    /// `count` things, each by itself.
    pub fn new(count: usize) -> Joined {
        Joined((0..count as u32).collect())
    }

    /// Joins what two belong to; whether they were apart.
    pub fn join(&mut self, a: u32, b: u32) -> bool {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
        a != b
    }

    fn root(&mut self, mut i: u32) -> u32 {
        while self.0[i as usize] != i {
            self.0[i as usize] = self.0[self.0[i as usize] as usize];
            i = self.0[i as usize];
        }
        i
    }
}

/// Twice the area of a triangle, in steps, positive counter-clockwise.
fn turn(a: [i32; 2], b: [i32; 2], c: [i32; 2]) -> i64 {
    let from = |p: [i32; 2]| [i64::from(p[0]) - i64::from(a[0]), i64::from(p[1]) - i64::from(a[1])];
    let (b, c) = (from(b), from(c));
    b[0] * c[1] - b[1] * c[0]
}

fn has_area(ring: &[[i32; 2]]) -> bool {
    ring.windows(2).map(|w| i128::from(turn(ring[0], w[0], w[1]))).sum::<i128>() != 0
}

/// Whether two edges share more than an end of both.
fn collide([a, b]: [[i32; 2]; 2], [c, d]: [[i32; 2]; 2]) -> bool {
    let sides = [turn(a, b, c), turn(a, b, d), turn(c, d, a), turn(c, d, b)].map(i64::signum);
    let touches = |side: i64, p: [i32; 2], ends: [[i32; 2]; 2]| {
        let between = (0..2).all(|k| ends[0][k].min(ends[1][k]) <= p[k] && p[k] <= ends[0][k].max(ends[1][k]));
        side == 0 && between && p != ends[0] && p != ends[1]
    };
    let crossing = sides[0] * sides[1] < 0 && sides[2] * sides[3] < 0;
    let same = (a == c && b == d) || (a == d && b == c);
    crossing
        || same
        || touches(sides[0], c, [a, b])
        || touches(sides[1], d, [a, b])
        || touches(sides[2], a, [c, d])
        || touches(sides[3], b, [c, d])
}
