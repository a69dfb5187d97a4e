//! Evenly spread points: Lloyd's relaxation in an area.
//!
//! In: points and an area. Out: as many points, each moved towards the centre of the part of the area that is nearest
//! to it. (Lloyd, Least squares quantization in PCM, 1982.)

use crate::geometry::cut::{Line, Ring, push_ring};
use crate::geometry::{Area, Bounds, BoxGrid, Polygon};
use glam::DVec2;
use spade::{DelaunayTriangulation, Point2, Triangulation};

/// The golden angle, radians: turns that never repeat.
const GOLDEN_ANGLE: f64 = 2.399_963_229_728_653;

/// The points after some rounds of relaxation; points inside stay inside, and the order is kept.
///
/// Points that coincide are moved apart first. A point whose cell has no share in the area stays where it is. Costs
/// n log n a round for n points well inside, plus the edges of the area for each cell on its rim.
pub fn relax(points: &[DVec2], area: &Area, iterations: usize) -> Vec<DVec2> {
    let mut points = points.to_vec();
    if area.is_empty() {
        return points;
    }
    let rim: Vec<Bounds> = area.edges().map(|(a, b)| Bounds::of([a, b])).collect();
    let field = Field { area, bounds: area.bounds(), rim: BoxGrid::new(&rim) };
    for _ in 0..iterations {
        field.separate(&mut points);
        points = field.relaxed(&points);
    }
    points
}

/// The area with what the rounds need again and again.
struct Field<'a> {
    area: &'a Area,
    bounds: Bounds,
    rim: BoxGrid,
}

impl Field<'_> {
    /// Moves points that coincide with an earlier one, or are no numbers, a little aside.
    fn separate(&self, points: &mut [DVec2]) {
        let step = 1e-3 * self.bounds.size().max_element() / (points.len() as f64).sqrt();
        let mut order: Vec<usize> = (0..points.len()).collect();
        order.sort_by(|a, b| {
            let (p, q) = (points[*a], points[*b]);
            p.x.total_cmp(&q.x).then(p.y.total_cmp(&q.y)).then(a.cmp(b))
        });
        for i in 0..order.len() {
            let twin = i > 0 && points[order[i - 1]].distance_squared(points[order[i]]) < step * step * 1e-6;
            if twin || !points[order[i]].is_finite() {
                let (sin, cos) = libm::sincos(GOLDEN_ANGLE * order[i] as f64);
                let moved = points[order[i]] + step * DVec2::new(cos, sin);
                points[order[i]] = if moved.is_finite() { moved } else { self.bounds.centre() };
            }
        }
    }

    fn relaxed(&self, points: &[DVec2]) -> Vec<DVec2> {
        let neighbours = neighbours(points);
        let moved = |i: usize| self.centre(&self.cell(points, i, &neighbours[i])).unwrap_or(points[i]);
        (0..points.len()).map(moved).collect()
    }

    /// The points of the bounds that are nearest to the `i`-th point.
    fn cell(&self, points: &[DVec2], i: usize, neighbours: &[usize]) -> Cell {
        let here = points[i];
        let lines: Vec<Line> = neighbours
            .iter()
            .filter_map(|j| {
                let normal = (points[*j] - here).try_normalize()?;
                Some(Line::new(normal, ((points[*j] + here) * 0.5).dot(normal), false))
            })
            .collect();
        let b = self.bounds;
        let all = Ring::from_slice(&[b.min, DVec2::new(b.max.x, b.min.y), b.max, DVec2::new(b.min.x, b.max.y)]);
        let ring = lines.iter().fold(all, |ring, line| line.clip_convex(&ring));
        Cell { site: here, ring, lines }
    }

    /// The centre of the cell's share in the area, moved inside where it is outside.
    fn centre(&self, cell: &Cell) -> Option<DVec2> {
        let mut whole = Area::empty();
        push_ring(&cell.ring, &mut whole);
        let ring = whole.polygons().first()?;
        if self.rim.touching(ring.bounds()).next().is_none() {
            return self.area.contains(ring.centroid()).then(|| ring.centroid());
        }
        let share = self.share(cell);
        let centre = share.centroid()?;
        if share.contains(centre) {
            return Some(centre);
        }
        let own = share.polygons().iter().find(|p| p.contains(cell.site)).or(share.largest())?;
        Some(if own.contains(own.centroid()) { own.centroid() } else { own.interior_point() })
    }

    /// The part of the area inside the cell.
    fn share(&self, cell: &Cell) -> Area {
        cell.lines.iter().fold(self.area.clone(), |area, line| {
            let mut kept = Area::empty();
            area.polygons().iter().for_each(|p: &Polygon| line.clip_polygon(p, &mut kept));
            kept
        })
    }
}

/// What lies nearer to one point than to all others.
struct Cell {
    site: DVec2,
    /// Within the bounds of the area.
    ring: Ring,
    /// Half way to each neighbour.
    lines: Vec<Line>,
}

/// For each point, those that its cell may touch: its neighbours in the Delaunay triangulation.
fn neighbours(points: &[DVec2]) -> Vec<Vec<usize>> {
    let sites: Vec<Point2<f64>> = points.iter().map(|p| Point2::new(p.x, p.y)).collect();
    match DelaunayTriangulation::<Point2<f64>>::bulk_load_stable(sites) {
        Ok(mesh) if mesh.num_vertices() == points.len() => {
            mesh.vertices().map(|v| v.out_edges().map(|e| e.to().index()).collect()).collect()
        }
        // Points beyond the range of the triangulation: everyone is a neighbour of everyone.
        _ => (0..points.len()).map(|i| (0..points.len()).filter(|j| *j != i).collect()).collect(),
    }
}
