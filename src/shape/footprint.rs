//! The shadow of a shape on the plan: what occlusion, scenes and statistics see of it.

use crate::geometry::{Area, Mesh, Polygon};
use crate::shape::{Geometry, Plane, Scope, Shape};
use glam::{DAffine2, DAffine3, DVec2, DVec3};

/// Sides of the polygon that stands for a round crown.
const CROWN_SIDES: usize = 16;

/// The plan of a shape with the heights between which it lies.
#[derive(Clone, Debug, PartialEq)]
pub struct Footprint {
    /// Its extent on the plan.
    pub extent: Extent,
    /// Height of its lowest point above the datum.
    pub low: f64,
    /// Height of its highest point; equal to `low` for flat shapes.
    pub high: f64,
    /// It encloses a volume.
    pub closed: bool,
}

/// The extent of a shape on the plan.
#[derive(Clone, Debug, PartialEq)]
pub enum Extent {
    /// Nothing.
    Nothing,
    /// A point.
    Point(DVec2),
    /// A line: also what is left of an upright face.
    Line(Vec<DVec2>),
    /// An area.
    Area(Area),
}

/// A world point on the plan: x east, y north.
pub fn on_plan(world: DVec3) -> DVec2 {
    DVec2::new(world.x, -world.z)
}

impl Shape {
    /// Its shadow on the plan. Cost: linear in the vertices; a union of faces for meshes.
    pub fn footprint(&self) -> Footprint {
        let frame = &self.scope.frame;
        let (low, high) = heights(&self.scope);
        let extent = match &self.geometry {
            Geometry::Empty => Extent::Nothing,
            Geometry::Point => Extent::Point(on_plan(frame.origin)),
            Geometry::Path(points) => Extent::Line(points.iter().map(|p| on_plan(frame.to_world(*p))).collect()),
            Geometry::Flat(plane, area) => self.flat(plane, area),
            Geometry::Prism(plane, area, _) if self.upright(plane) => self.flat(plane, area),
            Geometry::Element(placed) if placed.round => self.crown(),
            Geometry::Element(_) => Extent::Area(box_on_plan(&self.scope)),
            Geometry::Prism(..) | Geometry::Mesh(_) => match self.world_mesh() {
                Some(mesh) => shadow(&mesh),
                None => Extent::Nothing,
            },
        };
        Footprint { extent, low, high, closed: self.is_closed() }
    }

    /// Whether its geometry encloses a volume.
    pub fn is_closed(&self) -> bool {
        match &self.geometry {
            Geometry::Prism(..) | Geometry::Element(_) => true,
            Geometry::Mesh(mesh) => mesh.is_closed(),
            _ => false,
        }
    }

    /// Its faces in world coordinates; none for points, lines and elements.
    pub fn world_mesh(&self) -> Option<Mesh> {
        let frame = &self.scope.frame;
        let to_world = DAffine3::from_rotation_translation(frame.rotation, frame.origin);
        self.local_mesh().map(|mesh| mesh.transformed(&to_world))
    }

    /// Its faces in the scope's coordinates; none for points, lines and elements.
    pub fn local_mesh(&self) -> Option<Mesh> {
        match &self.geometry {
            Geometry::Flat(plane, area) => Some(Mesh::flat(area, |p| plane.at(p))),
            Geometry::Prism(plane, area, height) => {
                let normal = plane.normal();
                let (base, top) = if *height < 0.0 { (*height, 0.0) } else { (0.0, *height) };
                Some(Mesh::prism(area, base, top, |p, h| plane.at(p) + normal * h))
            }
            Geometry::Mesh(mesh) => Some((**mesh).clone()),
            _ => None,
        }
    }

    /// Whether a plane of its geometry lies level in the world.
    fn upright(&self, plane: &Plane) -> bool {
        (self.scope.frame.rotation * plane.normal()).y.abs() > 1.0 - 1e-9
    }

    fn flat(&self, plane: &Plane, area: &Area) -> Extent {
        let frame = &self.scope.frame;
        let (u, v) = plane.axes();
        let (u, v) = (on_plan(frame.rotation * u), on_plan(frame.rotation * v));
        let origin = on_plan(frame.to_world(plane.at(DVec2::ZERO)));
        if u.perp_dot(v).abs() < 1e-6 {
            let points = area.edges().map(|(a, _)| origin + u * a.x + v * a.y);
            return Extent::Line(ends(points));
        }
        let map = DAffine2::from_cols(u, v, origin);
        Extent::Area(area.transformed(&map))
    }

    fn crown(&self) -> Extent {
        let size = self.scope.size;
        let centre = on_plan(self.scope.frame.to_world(DVec3::new(size.x * 0.5, 0.0, size.z * 0.5)));
        let crown = Polygon::regular(centre, size.x.max(size.z) * 0.5, CROWN_SIDES);
        crown.map_or(Extent::Point(centre), |polygon| Extent::Area(polygon.into()))
    }
}

/// Lowest and highest point of a scope's box.
fn heights(scope: &Scope) -> (f64, f64) {
    let up = scope.frame.rotation.inverse() * DVec3::Y;
    let reach = up * scope.size;
    let low = reach.min(DVec3::ZERO).element_sum();
    let high = reach.max(DVec3::ZERO).element_sum();
    (scope.frame.origin.y + low, scope.frame.origin.y + high)
}

/// The shadow of faces: an area, or the line that upright faces leave.
fn shadow(mesh: &Mesh) -> Extent {
    let area = mesh.footprint();
    match area.is_empty() {
        true => Extent::Line(ends(mesh.positions.iter().map(|p| on_plan(*p)))),
        false => Extent::Area(area),
    }
}

/// The convex outline of a scope's box on the plan.
fn box_on_plan(scope: &Scope) -> Area {
    let corner = |i: usize| {
        let pick = DVec3::new((i & 1) as f64, (i >> 1 & 1) as f64, (i >> 2) as f64);
        on_plan(scope.frame.to_world(scope.size * pick))
    };
    let hull = crate::geometry::convex_hull(&(0..8).map(corner).collect::<Vec<_>>());
    Polygon::new(&hull, &[]).into_iter().collect()
}

/// The two ends of points on a line.
fn ends(points: impl Iterator<Item = DVec2>) -> Vec<DVec2> {
    let mut points: Vec<DVec2> = points.collect();
    points.sort_by(|a, b| (a.x, a.y).partial_cmp(&(b.x, b.y)).unwrap_or(std::cmp::Ordering::Equal));
    match (points.first(), points.last()) {
        (Some(first), Some(last)) => vec![*first, *last],
        _ => Vec::new(),
    }
}
