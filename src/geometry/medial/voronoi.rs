//! From the Voronoi diagram of an outline's edges to the skeleton of its inside.
//!
//! In: an outline of whole numbers. Out: the edges of the diagram that lie inside and part two different pieces of the
//! rim, straight between edges and between corners, parabolic between an edge and a corner.

use crate::geometry::medial::outline::Outline;
use crate::geometry::medial::skeleton::{Bead, Link, Skeleton};
use boostvoronoi::prelude::{Builder, Cell, Diagram, Edge, SourceCategory};
use glam::DVec2;

/// Parabolas are drawn to this (metres).
const ARC_ERROR: f64 = 0.005;

/// A parabola is drawn with at most this many chords.
const MOST_CHORDS: f64 = 1000.0;

/// The skeleton, running into corners sharper than `corner` degrees; `None` where the crate fails.
pub(super) fn skeleton(outline: &Outline, corner: f64) -> Option<Skeleton> {
    let segments: Vec<[i32; 4]> = (0..outline.points.len())
        .map(|i| {
            let [a, b] = outline.edge(i);
            [a[0], a[1], b[0], b[1]]
        })
        .collect();
    let diagram = Builder::<i32>::default().with_segments(segments.iter()).ok()?.build().ok()?;
    let sharpest = libm::sin((corner.clamp(0.0, 180.0) * 0.5).to_radians());
    let mut reader = Reader {
        outline,
        diagram: &diagram,
        sharpest,
        numbers: vec![u32::MAX; diagram.vertices().len()],
        skeleton: Skeleton::default(),
    };
    diagram.edges().iter().try_for_each(|edge| reader.read(edge))?;
    Some(reader.skeleton)
}

/// What owns a cell of the diagram, on the grid.
#[derive(Clone, Copy)]
enum Site {
    /// A vertex, by its number.
    Corner(usize, DVec2),
    /// An edge.
    Edge([DVec2; 2]),
}

impl Site {
    /// Whether it is a corner where rings touch.
    fn is_shared(self, outline: &Outline) -> bool {
        matches!(self, Site::Corner(index, _) if outline.shared[index])
    }
}

struct Reader<'a> {
    outline: &'a Outline,
    diagram: &'a Diagram,
    /// Sine of half the angle of corners that the axis runs into.
    sharpest: f64,
    /// The node of each vertex that has one.
    numbers: Vec<u32>,
    skeleton: Skeleton,
}

impl Reader<'_> {
    /// Adds an edge of the diagram if it belongs to the axis; `None` where the diagram is broken.
    fn read(&mut self, edge: &Edge) -> Option<()> {
        let twin = &self.diagram.edges()[edge.twin().ok()?.usize()];
        let (Some(from), Some(to)) = (edge.vertex0(), twin.vertex0()) else { return Some(()) };
        if edge.is_secondary() || twin.id().usize() < edge.id().usize() {
            return Some(());
        }
        let [left, right] = [self.site(edge)?, self.site(twin)?];
        let [a, b] = [self.place(from.usize()), self.place(to.usize())];
        if !(a.is_finite() && b.is_finite() && self.is_inside(left, right, a, b)) {
            return Some(());
        }
        match self.corner_of(left, right, a, b) {
            Some(Run::In) | None => {
                let ends = [self.node(from.usize(), left), self.node(to.usize(), left)];
                self.link(ends, [left, right], [a, b]);
            }
            Some(Run::Stop(far)) => {
                let vertex = if far == 0 { from } else { to };
                self.node(vertex.usize(), left);
            }
        }
        Some(())
    }

    fn site(&self, edge: &Edge) -> Option<Site> {
        let cell: &Cell = self.diagram.cells().get(edge.cell().ok()?.usize())?;
        let start = cell.source_index().usize();
        let end = self.outline.next[start] as usize;
        Some(match cell.source_category() {
            SourceCategory::Segment => Site::Edge([self.vertex(start), self.vertex(end)]),
            SourceCategory::SegmentEnd => Site::Corner(end, self.vertex(end)),
            SourceCategory::SegmentStart | SourceCategory::SinglePoint => Site::Corner(start, self.vertex(start)),
        })
    }

    fn vertex(&self, index: usize) -> DVec2 {
        let [x, y] = self.outline.points[index];
        DVec2::new(f64::from(x), f64::from(y))
    }

    fn place(&self, vertex: usize) -> DVec2 {
        let vertex = &self.diagram.vertices()[vertex];
        DVec2::new(vertex.x(), vertex.y())
    }

    /// Cells lie wholly on one side of the rim, and the side of an edge or the turn of a corner says on which.
    fn is_inside(&self, left: Site, right: Site, a: DVec2, b: DVec2) -> bool {
        let side = |site: Site| match site {
            Site::Corner(index, _) => Err(self.outline.reflex[index]),
            Site::Edge([from, to]) => {
                let (p, q) = ((to - from).perp_dot(a - from), (to - from).perp_dot(b - from));
                Ok(if p.abs() > q.abs() { p > 0.0 } else { q > 0.0 })
            }
        };
        match (side(left), side(right)) {
            (Ok(inside), _) | (_, Ok(inside)) => inside,
            // Where rings touch, a corner has several sides.
            _ if [left, right].iter().any(|site| site.is_shared(self.outline)) => self.outline.contains((a + b) * 0.5),
            (Err(left), Err(right)) => left && right,
        }
    }

    /// What to do with an edge that starts in a corner of the rim; `None` where it does not.
    fn corner_of(&self, left: Site, right: Site, a: DVec2, b: DVec2) -> Option<Run> {
        let (Site::Edge([start, end]), Site::Edge([begin, other])) = (left, right) else { return None };
        let corner = match () {
            () if start == other || start == begin => start,
            () if end == other || end == begin => end,
            () => return None,
        };
        let far = usize::from(a.distance_squared(corner) < b.distance_squared(corner));
        let [near, away] = if far == 1 { [a, b] } else { [b, a] };
        if near.distance_squared(corner) > 1.0 {
            return None;
        }
        let sharp = clearance(left, away) < self.sharpest * away.distance(corner);
        Some(if sharp { Run::In } else { Run::Stop(far) })
    }

    fn node(&mut self, vertex: usize, site: Site) -> u32 {
        if self.numbers[vertex] == u32::MAX {
            self.numbers[vertex] = self.skeleton.nodes.len() as u32;
            let bead = self.bead(self.place(vertex), site);
            self.skeleton.nodes.push(bead);
        }
        self.numbers[vertex]
    }

    fn bead(&self, p: DVec2, site: Site) -> Bead {
        Bead { point: self.outline.to_plan(p), clearance: self.outline.metres(clearance(site, p)) }
    }

    fn link(&mut self, ends: [u32; 2], sites: [Site; 2], [a, b]: [DVec2; 2]) {
        let first = self.skeleton.beads.len() as u32;
        if let [Site::Corner(_, focus), Site::Edge(directrix)] | [Site::Edge(directrix), Site::Corner(_, focus)] = sites
        {
            self.arc(focus, directrix, [a, b]);
        }
        self.skeleton.links.push(Link { ends, inner: [first, self.skeleton.beads.len() as u32] });
    }

    /// Adds points of the parabola between two of its points, spaced so that chords stay near it: evenly in the inverse
    /// hyperbolic sine of the way along the edge, since it is flatter the farther from its corner.
    fn arc(&mut self, focus: DVec2, [from, to]: [DVec2; 2], ends: [DVec2; 2]) {
        let along = (to - from).normalize_or_zero();
        let height = along.perp_dot(focus - from);
        let foot = focus - along.perp() * height;
        if height.abs() < 1e-6 {
            return;
        }
        let [s, t] = ends.map(|p| libm::asinh((p - foot).dot(along) / height.abs()));
        let widest = ends.map(|p| (p - foot).length()).into_iter().fold(height.abs(), f64::max);
        let error = self.outline.steps(ARC_ERROR);
        let chords = ((t - s).abs() * (widest / (8.0 * error)).sqrt()).ceil().clamp(1.0, MOST_CHORDS);
        for k in 1..chords as u32 {
            let x = libm::sinh(s + (t - s) * (f64::from(k) / chords)) * height.abs();
            let y = (x * x / height + height) * 0.5;
            let bead = Bead {
                point: self.outline.to_plan(foot + along * x + along.perp() * y),
                clearance: self.outline.metres(y.abs()),
            };
            self.skeleton.beads.push(bead);
        }
    }
}

/// Whether the axis runs into a corner, or stops at the edge's first or second vertex.
enum Run {
    In,
    Stop(usize),
}

fn clearance(site: Site, p: DVec2) -> f64 {
    match site {
        Site::Corner(_, q) => p.distance(q),
        Site::Edge([from, to]) => ((to - from).perp_dot(p - from) / from.distance(to)).abs(),
    }
}
