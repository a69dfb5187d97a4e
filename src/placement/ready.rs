//! A site made ready for many questions: the same answers as [`Site::allows`], at the cost of what is near.
//!
//! In: a site, or an area. Out: whether a disk may stand at a place, how far the rim is. Edges, bodies and disks lie in
//! grids by their boxes; what a grid leaves out is too far to decide.

use crate::geometry::{Area, Bounds, BoxGrid, NearestEdge, nearest_on_segment};
use crate::placement::{Body, Disk, Site};
use glam::DVec2;

/// Boxes are larger than what they hold by this (metres), so that rounding leaves nothing out.
const SLACK: f64 = 1e-6;

/// The edges of an area in a grid.
#[derive(Clone, Debug)]
pub(super) struct Rim {
    edges: Vec<(DVec2, DVec2)>,
    grid: BoxGrid,
    bounds: Bounds,
    /// About from edge to edge, metres.
    step: f64,
}

/// A site with everything of it in grids.
pub(super) struct Ready<'a> {
    site: &'a Site,
    rim: Rim,
    lot: Option<Rim>,
    bodies: BoxGrid,
    /// Bodies that are kept clear over no finite distance.
    endless: Vec<usize>,
    disks: BoxGrid,
}

impl Rim {
    /// Edges in their order; a point is an edge from itself to itself.
    pub fn of(edges: impl IntoIterator<Item = (DVec2, DVec2)>) -> Rim {
        let edges: Vec<_> = edges.into_iter().collect();
        let boxes: Vec<Bounds> = edges.iter().map(|(a, b)| Bounds::of([*a, *b]).grown(SLACK)).collect();
        let bounds = boxes.iter().fold(Bounds::EMPTY, |all, each| all.union(*each));
        let step = bounds.size().max_element() / (edges.len().max(1) as f64).sqrt();
        Rim { grid: BoxGrid::new(&boxes), edges, bounds, step }
    }

    /// The nearest edge, counted as in `edges()`; ties go to the first. `None` where there are no edges.
    pub fn nearest(&self, p: DVec2) -> Option<NearestEdge> {
        if self.edges.is_empty() || !p.is_finite() {
            return None;
        }
        let outside = (self.bounds.min - p).max(p - self.bounds.max).max(DVec2::ZERO).length();
        let mut reach = outside + self.step;
        loop {
            let found = self.nearest_within(p, reach);
            if found.is_some() || reach > outside + 4.0 * (self.bounds.size().length() + 1.0) {
                return found;
            }
            reach *= 2.0;
        }
    }

    /// The same, if it is no farther than `reach` metres.
    fn nearest_within(&self, p: DVec2, reach: f64) -> Option<NearestEdge> {
        let mut best = (reach * reach, usize::MAX, p);
        for edge in self.grid.touching(Bounds { min: p - reach, max: p + reach }) {
            let (a, b) = self.edges[edge];
            let foot = nearest_on_segment(p, a, b);
            let square = foot.distance_squared(p);
            if square < best.0 || square == best.0 && edge < best.1 {
                best = (square, edge, foot);
            }
        }
        (best.1 != usize::MAX).then(|| NearestEdge { distance: best.0.sqrt(), edge: best.1, foot: best.2 })
    }

    /// Whether no edge is nearer than `distance` metres.
    pub fn is_far(&self, p: DVec2, distance: f64) -> bool {
        let near = self.grid.touching(Bounds { min: p - distance, max: p + distance });
        let mut away = near.map(|edge| nearest_on_segment(p, self.edges[edge].0, self.edges[edge].1).distance(p));
        away.all(|away| away >= distance)
    }

    /// Whether the area, whose edges these are, contains a place.
    pub fn contains(&self, area: &Area, p: DVec2) -> bool {
        if !self.bounds.contains(p) {
            return false;
        }
        if !self.is_far(p, SLACK) {
            // What lies on the rim is the area's own to say.
            return area.contains(p);
        }
        let way = Bounds { min: p, max: DVec2::new(self.bounds.max.x, p.y) };
        let crossed = |edge: usize| {
            let (a, b) = self.edges[edge];
            (a.y > p.y) != (b.y > p.y) && ((b - a).perp_dot(p - a) > 0.0) == (b.y > a.y)
        };
        self.grid.touching(way).filter(|edge| crossed(*edge)).count() % 2 == 1
    }
}

impl<'a> Ready<'a> {
    /// Puts a site into grids.
    pub fn of(site: &'a Site) -> Ready<'a> {
        let boxes: Vec<Bounds> =
            site.kept().iter().map(|(body, distance)| extent(body).grown(distance + SLACK)).collect();
        let endless = |i: &usize| !(boxes[*i].min.is_finite() && boxes[*i].max.is_finite());
        let disk = |disk: &Disk| Bounds::of([disk.position]).grown(disk.radius + SLACK);
        Ready {
            site,
            rim: Rim::of(site.area().edges()),
            lot: site.lot().map(|lot| Rim::of(lot.edges())),
            endless: (0..boxes.len()).filter(endless).collect(),
            bodies: BoxGrid::new(&boxes),
            disks: BoxGrid::new(&site.taken().iter().map(disk).collect::<Vec<_>>()),
        }
    }

    /// Whether a disk may stand there.
    pub fn allows(&self, p: DVec2, radius: f64) -> bool {
        let clear = |body: usize| {
            let (body, distance) = &self.site.kept()[body];
            body.clear(p) >= *distance
        };
        let apart = |disk: usize| {
            let disk = self.site.taken()[disk];
            disk.position.distance(p) >= disk.radius + radius
        };
        let (here, reach) = (Bounds { min: p, max: p }, Bounds { min: p - radius, max: p + radius });
        self.rim.contains(self.site.area(), p)
            && self.bodies.touching(here).all(clear)
            && self.endless.iter().all(|body| clear(*body))
            && self.disks.touching(reach).all(apart)
            && self.within_lot(p, radius)
    }

    /// Whether the rim of the site's area is no nearer than `distance` metres.
    pub fn is_inset(&self, p: DVec2, distance: f64) -> bool {
        self.rim.is_far(p, distance)
    }

    fn within_lot(&self, p: DVec2, radius: f64) -> bool {
        let within = |(lot, rim): (&Area, &Rim)| rim.contains(lot, p) && rim.is_far(p, radius);
        self.site.lot().zip(self.lot.as_ref()).is_none_or(within)
    }
}

/// The box around a body.
fn extent(body: &Body) -> Bounds {
    match body {
        Body::Area(area) => area.bounds(),
        Body::Line(points) => Bounds::of(points.iter().copied()),
        Body::Point(p) => Bounds::of([*p]),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Polygon;
    use crate::seed::Seed;

    #[test]
    fn a_ready_site_answers_as_the_site_does() {
        let mut random = Seed(5).random();
        let mut ring = |centre: DVec2, count: usize, low: f64, high: f64| -> Vec<DVec2> {
            let turn = |i: usize| DVec2::from_angle(std::f64::consts::TAU * i as f64 / count as f64);
            (0..count).map(|i| (centre + turn(i) * random.uniform(low, high)).round()).collect()
        };
        let holes = [ring(DVec2::new(9.0, 3.0), 7, 3.0, 6.0)];
        let area: Area = Polygon::new(&ring(DVec2::ZERO, 60, 25.0, 50.0), &holes).into_iter().collect();
        let lot: Area = Polygon::new(&ring(DVec2::ZERO, 9, 35.0, 45.0), &[]).into_iter().collect();
        let house = Polygon::new(&ring(DVec2::new(-15.0, 5.0), 6, 3.0, 7.0), &[]).expect("a house");
        let path = ring(DVec2::ZERO, 5, 10.0, 40.0);
        let site = Site::new(area.clone())
            .clear_of(Body::Area(house.into()), 0.0)
            .clear_of(Body::Line(path), 1.0)
            .clear_of(Body::Point(DVec2::new(0.0, -9.0)), 4.0)
            .standing((0..9).map(|i| Disk { position: DVec2::new(4.0 * f64::from(i), -20.0), radius: 1.0 }))
            .within(lot);
        let ready = Ready::of(&site);
        // Places on whole and half metres lie on rims and vertices by the hundred.
        let places = (0..40_000).map(|i| DVec2::new(f64::from(i % 200) - 100.0, f64::from(i / 200) - 100.0) * 0.5);
        for p in places {
            assert_eq!(ready.allows(p, 0.5), site.allows(p, 0.5), "{p}");
            assert_eq!(ready.is_inset(p, 2.0), area.distance_to_edges(p) >= 2.0, "{p}");
            assert_eq!(ready.rim.nearest(p), area.nearest_edge(p), "{p}");
        }
    }
}
