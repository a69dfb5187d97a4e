//! Where the centre of a plant may lie, as conditions on squares: the part of the sampler that knows polygons.
//!
//! In: the conditions of a site and a strategy, each a set of edges and a rule on the signed distance to them. Out: for
//! a square the conditions that still cut it, or that one of them excludes it wholly. A signed distance changes by no
//! more than the way walked, so its value at the centre of a square bounds it over the square. Squares are split from
//! the top, and a smaller square looks only at the edges its parent left it: what a place costs depends on the edges
//! near it, never on how many there are or on the extent of the whole.

use crate::geometry::{Area, Bounds, nearest_on_segment};
use crate::placement::{Body, Site};
use glam::DVec2;

/// A strip that is no wider than this (metres) is none.
const NARROWEST: f64 = 1e-3;
/// In squares of this half diagonal (metres) and smaller ones such strips are looked for.
const PINCHED: f64 = 0.1;

/// Conditions on the centre and radius of a plant.
#[derive(Clone, Debug)]
pub struct Ground {
    terms: Vec<Term>,
    edges: Vec<[DVec2; 2]>,
    bounds: Bounds,
}

/// A condition.
#[derive(Clone, Copy, Debug)]
struct Term {
    rule: Rule,
    first: u32,
    end: u32,
}

/// What a condition asks of the distance to its edges, metres.
#[derive(Clone, Copy, Debug)]
enum Rule {
    /// Inside.
    Inside,
    /// Outside, and no nearer than this.
    Outside(f64),
    /// No nearer than this.
    Away(f64),
    /// Inside, and no nearer than the radius.
    Within,
    /// No nearer than this and the radius.
    Apart(f64),
    /// Inside, and no farther than this.
    Band(f64),
    /// No farther than this.
    Near(f64),
}

/// A condition that cuts a square, with the edges that may decide it and the side its centre lies on.
#[derive(Clone, Copy, Debug)]
struct Cut {
    term: u32,
    inside: bool,
    from: u32,
    to: u32,
}

/// The conditions that cut squares, in two flat buffers.
#[derive(Clone, Debug, Default)]
pub struct Cuts {
    cuts: Vec<Cut>,
    edges: Vec<u32>,
}

/// A run of [`Cuts`]: the conditions that cut one square.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Run {
    from: u32,
    to: u32,
}

/// A square of the plan and what cuts it.
#[derive(Clone, Copy, Debug)]
pub struct Square {
    /// Its corner with the least coordinates.
    pub min: DVec2,
    /// Its side, metres.
    pub side: f64,
    /// What cuts it.
    pub run: Run,
}

impl Ground {
    /// The conditions of a site.
    pub fn of(site: &Site) -> Ground {
        let mut ground = Ground { terms: Vec::new(), edges: Vec::new(), bounds: site.bounds() };
        ground.add(Rule::Inside, site.area().edges());
        for (body, distance) in site.kept() {
            match body {
                Body::Area(area) => ground.add(Rule::Outside(*distance), area.edges()),
                Body::Line(points) => ground.add(Rule::Away(*distance), points.windows(2).map(|w| (w[0], w[1]))),
                Body::Point(p) => ground.add(Rule::Away(*distance), [(*p, *p)]),
            }
        }
        for disk in site.taken() {
            ground.add(Rule::Apart(disk.radius), [(disk.position, disk.position)]);
        }
        if let Some(lot) = site.lot() {
            ground.add(Rule::Within, lot.edges());
        }
        ground
    }

    /// The same, centres inside `rim` and within `width` metres of its edges.
    pub fn along(mut self, rim: &Area, width: f64) -> Ground {
        self.add(Rule::Band(width), rim.edges());
        self
    }

    /// The same, centres within `radius` metres of one of the points.
    pub fn around(mut self, points: &[DVec2], radius: f64) -> Ground {
        self.add(Rule::Near(radius), points.iter().map(|p| (*p, *p)));
        let disks = Bounds::of(points.iter().copied()).grown(radius);
        self.bounds = Bounds { min: self.bounds.min.max(disks.min), max: self.bounds.max.min(disks.max) };
        self
    }

    fn add(&mut self, rule: Rule, edges: impl IntoIterator<Item = (DVec2, DVec2)>) {
        let first = self.edges.len() as u32;
        self.edges.extend(edges.into_iter().map(|(a, b)| [a, b]));
        let end = self.edges.len() as u32;
        // Nothing is inside of nothing, and everything is away from it.
        if first < end || !matches!(rule, Rule::Outside(_) | Rule::Away(_)) {
            self.terms.push(Term { rule, first, end });
        }
    }

    /// The extent of where anything may stand; empty where nothing may.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// A square with all conditions, on whatever side of them its centre lies.
    pub fn first(&self, square: Square, cuts: &mut Cuts) -> Square {
        cuts.clear();
        let centre = square.centre();
        for (term, Term { rule, first, end }) in self.terms.iter().enumerate() {
            let edges = &self.edges[*first as usize..*end as usize];
            // No edge lies as far down as the start of the way, so the start is outside.
            let below = edges.iter().fold(centre.y, |y, [a, b]| y.min(a.y).min(b.y)) - 1.0;
            let start = DVec2::new(centre.x, below);
            let odd = |inside: bool, [a, b]: &[DVec2; 2]| inside ^ crosses(start, centre, *a, *b);
            let inside = rule.sided() && edges.iter().fold(false, odd);
            let from = cuts.edges.len() as u32;
            cuts.edges.extend(*first..*end);
            cuts.cuts.push(Cut { term: term as u32, inside, from, to: cuts.edges.len() as u32 });
        }
        Square { run: Run { from: 0, to: cuts.cuts.len() as u32 }, ..square }
    }

    /// What of `run`, which cuts a square around `seen`, still cuts a smaller square in it, written to the end of
    /// `kept`; `None` if a condition excludes the square for all radii in the range.
    pub fn narrow(
        &self,
        (seen, run, cuts): (DVec2, Run, &Cuts),
        (centre, half): (DVec2, f64),
        range: [f64; 2],
        kept: &mut Cuts,
    ) -> Option<Run> {
        let mark = kept.mark();
        for cut in &cuts.cuts[run.from as usize..run.to as usize] {
            let edges = &cuts.edges[cut.from as usize..cut.to as usize];
            let rule = self.terms[cut.term as usize].rule;
            let start = kept.edges.len() as u32;
            let (inside, nearest) = self.look(rule, (seen, cut.inside), centre, edges, rule.reach(range) + half, kept);
            let [least, most] = rule.margin(inside, nearest, range);
            if least < -half {
                kept.truncate(mark);
                return None;
            }
            if most >= half {
                kept.edges.truncate(start as usize);
            } else {
                kept.cuts.push(Cut { term: cut.term, inside, from: start, to: kept.edges.len() as u32 });
            }
        }
        if self.is_pinched(centre, half, &kept.cuts[mark[0]..], &kept.edges) {
            kept.truncate(mark);
            return None;
        }
        Some(Run { from: mark[0] as u32, to: kept.cuts.len() as u32 })
    }

    /// Whether one condition asks to be so near and another so far that what lies between, in a small square, is
    /// narrower than [`NARROWEST`]. Without this a band as wide as the clearance from the same line would be searched
    /// all along for places in a strip without width.
    fn is_pinched(&self, centre: DVec2, half: f64, cuts: &[Cut], edges: &[u32]) -> bool {
        if half > PINCHED || cuts.len() < 2 {
            return false;
        }
        let rule = |cut: &Cut| self.terms[cut.term as usize].rule;
        let way = |edge: u32| {
            let [a, b] = self.edges[edge as usize];
            centre - nearest_on_segment(centre, a, b)
        };
        let own = |cut: &Cut| &edges[cut.from as usize..cut.to as usize];
        cuts.iter().any(|near| {
            let (Some(most), &[edge]) = (rule(near).farthest(), own(near)) else { return false };
            let from = way(edge);
            cuts.iter().any(|far| {
                let Some(least) = rule(far).nearest() else { return false };
                own(far).iter().map(|edge| way(*edge)).any(|to| {
                    // Over the square the two distances differ by no more than at its centre, and by what their
                    // directions turn apart, and bend.
                    let (a, b) = (from.length(), to.length());
                    let turn = (from / a - to / b).length() + half / a.min(b);
                    most - a + b - least + turn * half < NARROWEST
                })
            })
        })
    }

    /// The side `centre` lies on and its distance to the edges; those within `reach` of it are kept.
    fn look(
        &self,
        rule: Rule,
        (seen, side): (DVec2, bool),
        centre: DVec2,
        edges: &[u32],
        reach: f64,
        kept: &mut Cuts,
    ) -> (bool, f64) {
        let (mut inside, mut nearest) = (side, f64::INFINITY);
        for edge in edges {
            let [a, b] = self.edges[*edge as usize];
            inside ^= rule.sided() && crosses(seen, centre, a, b);
            let distance = nearest_on_segment(centre, a, b).distance_squared(centre);
            nearest = nearest.min(distance);
            if distance <= reach * reach {
                kept.edges.push(*edge);
            }
        }
        (inside, nearest.sqrt())
    }

    /// The greatest radius up to `most` with which a plant may stand at `p`, in a square around `seen` that `run` cuts;
    /// negative if none may.
    pub fn room(&self, p: DVec2, seen: DVec2, run: Run, cuts: &Cuts, most: f64) -> f64 {
        let mut room = most;
        for cut in &cuts.cuts[run.from as usize..run.to as usize] {
            let rule = self.terms[cut.term as usize].rule;
            let (mut inside, mut nearest) = (cut.inside, f64::INFINITY);
            for edge in &cuts.edges[cut.from as usize..cut.to as usize] {
                let [a, b] = self.edges[*edge as usize];
                inside ^= rule.sided() && crosses(seen, p, a, b);
                nearest = nearest.min(nearest_on_segment(p, a, b).distance_squared(p));
            }
            room = room.min(rule.room(inside, nearest.sqrt()));
            if room < 0.0 {
                return room;
            }
        }
        room
    }
}

impl Rule {
    /// Whether it asks on which side of the edges a point lies.
    fn sided(self) -> bool {
        matches!(self, Rule::Inside | Rule::Outside(_) | Rule::Within | Rule::Band(_))
    }

    /// Edges farther than this decide nothing.
    fn reach(self, [_, high]: [f64; 2]) -> f64 {
        match self {
            Rule::Inside => 0.0,
            Rule::Within => high,
            Rule::Apart(distance) => distance + high,
            Rule::Outside(distance) | Rule::Away(distance) | Rule::Band(distance) | Rule::Near(distance) => distance,
        }
    }

    /// How far from its edges it lets a plant stand.
    fn farthest(self) -> Option<f64> {
        match self {
            Rule::Band(distance) | Rule::Near(distance) => Some(distance),
            _ => None,
        }
    }

    /// How near to its edges it lets any plant stand.
    fn nearest(self) -> Option<f64> {
        match self {
            Rule::Outside(distance) | Rule::Away(distance) | Rule::Apart(distance) => Some(distance),
            _ => None,
        }
    }

    /// By how many metres the condition holds (negative: fails), for the least radius and for the greatest.
    fn margin(self, inside: bool, nearest: f64, [low, high]: [f64; 2]) -> [f64; 2] {
        let depth = if inside { nearest } else { -nearest };
        match self {
            Rule::Inside => [depth; 2],
            Rule::Outside(distance) => [-depth - distance; 2],
            Rule::Away(distance) => [nearest - distance; 2],
            Rule::Within => [depth - low, depth - high],
            Rule::Apart(distance) => [nearest - distance - low, nearest - distance - high],
            Rule::Band(width) => [depth.min(width - nearest); 2],
            Rule::Near(distance) => [distance - nearest; 2],
        }
    }

    /// The greatest radius it admits.
    fn room(self, inside: bool, nearest: f64) -> f64 {
        let free = match self {
            Rule::Within if inside => return nearest,
            Rule::Apart(distance) => return nearest - distance,
            Rule::Inside => inside,
            Rule::Within => false,
            Rule::Outside(distance) => !inside && nearest >= distance,
            Rule::Away(distance) => nearest >= distance,
            Rule::Band(width) => inside && nearest <= width,
            Rule::Near(distance) => nearest <= distance,
        };
        if free { f64::INFINITY } else { -1.0 }
    }
}

impl Cuts {
    /// Forgets everything.
    pub fn clear(&mut self) {
        self.truncate([0, 0]);
    }

    /// How much there is, to come back to.
    fn mark(&self) -> [usize; 2] {
        [self.cuts.len(), self.edges.len()]
    }

    /// Forgets what came after a mark.
    fn truncate(&mut self, [cuts, edges]: [usize; 2]) {
        self.cuts.truncate(cuts);
        self.edges.truncate(edges);
    }

    /// Writes a run of another buffer to the end of this one.
    pub fn copy(&mut self, run: Run, other: &Cuts) -> Run {
        let from = self.cuts.len() as u32;
        for cut in &other.cuts[run.from as usize..run.to as usize] {
            let start = self.edges.len() as u32;
            self.edges.extend_from_slice(&other.edges[cut.from as usize..cut.to as usize]);
            self.cuts.push(Cut { from: start, to: self.edges.len() as u32, ..*cut });
        }
        Run { from, to: self.cuts.len() as u32 }
    }
}

impl Run {
    /// Whether nothing cuts the square.
    pub fn is_empty(self) -> bool {
        self.from == self.to
    }
}

impl Square {
    /// Its centre.
    pub fn centre(&self) -> DVec2 {
        self.min + self.side * 0.5
    }

    /// Half its diagonal, and a little more, so that rounding cannot exclude what is free.
    pub fn half(&self) -> f64 {
        half_diagonal(self.min, self.side)
    }

    /// The corner of a quarter.
    pub fn quarter(&self, index: u32) -> DVec2 {
        self.min + DVec2::new(f64::from(index & 1), f64::from(index >> 1)) * (0.5 * self.side)
    }
}

/// Half the diagonal of a square and what rounding may add at its place.
fn half_diagonal(min: DVec2, side: f64) -> f64 {
    side * std::f64::consts::FRAC_1_SQRT_2 * (1.0 + 1e-12) + min.abs().max_element() * 1e-15
}

/// Whether the way from `p` to `q`, first along y and then along x, crosses an edge.
///
/// By the half-open rule an edge contains its lower end and not its upper one, so that a way past a vertex crosses
/// both edges or neither, and only edges near the way count.
fn crosses(p: DVec2, q: DVec2, a: DVec2, b: DVec2) -> bool {
    let along_y = (a.x > p.x) != (b.x > p.x) && left(p, a, b) != left(DVec2::new(p.x, q.y), a, b);
    let along_x = (a.y > q.y) != (b.y > q.y) && left(DVec2::new(p.x, q.y), a, b) != left(q, a, b);
    along_y != along_x
}

fn left(p: DVec2, a: DVec2, b: DVec2) -> bool {
    (b - a).perp_dot(p - a) > 0.0
}
