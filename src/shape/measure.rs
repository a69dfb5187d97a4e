//! Measures of a shape: areas, volume, counts.

use crate::geometry::{Area, Polygon};
use crate::shape::{Geometry, Shape};
use glam::DVec3;

/// What can be counted and measured of a shape's geometry.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Measure {
    /// Area of all faces, m².
    pub area: f64,
    /// Volume, m³; 0 where the geometry is not closed.
    pub volume: f64,
    /// Length of the outline or line, metres.
    pub boundary: f64,
    /// Vertices.
    pub vertices: usize,
    /// Edges.
    pub edges: usize,
    /// Faces.
    pub faces: usize,
    /// Holes.
    pub holes: usize,
    /// A face is concave.
    pub concave: bool,
}

impl Shape {
    /// All measures. Cost: linear in the vertices, n log n for meshes and several polygons.
    pub fn measure(&self) -> Measure {
        match &self.geometry {
            Geometry::Empty => Measure::default(),
            Geometry::Point => Measure { vertices: 1, ..Measure::default() },
            Geometry::Path(points) => Measure {
                boundary: points.windows(2).map(|w| w[0].distance(w[1])).sum(),
                vertices: points.len(),
                edges: points.len() - 1,
                ..Measure::default()
            },
            Geometry::Flat(_, area) => flat(area),
            Geometry::Prism(_, area, height) => prism(area, height.abs()),
            Geometry::Element(_) => boxed(self.scope.size),
            Geometry::Mesh(mesh) => Measure {
                area: mesh.area(),
                volume: if mesh.is_closed() { mesh.volume() } else { 0.0 },
                boundary: 0.0,
                vertices: mesh.positions.len(),
                edges: mesh.edges().len(),
                faces: mesh.faces.len(),
                holes: mesh.rings.len() - mesh.faces.len(),
                concave: false,
            },
        }
    }

    /// Whether a flat shape is one rectangle, its angles within a tolerance in degrees.
    pub fn is_rectangular(&self, tolerance: f64) -> bool {
        match &self.geometry {
            Geometry::Flat(_, area) | Geometry::Prism(_, area, _) => {
                matches!(area.polygons(), [polygon] if polygon.is_rectangle(tolerance))
            }
            _ => false,
        }
    }
}

fn flat(area: &Area) -> Measure {
    let polygons = area.polygons();
    let vertices = polygons.iter().map(|p| p.points().len()).sum();
    let is_second = |(index, twin): &(usize, Option<usize>)| twin.is_some_and(|twin| twin < *index);
    let shared = area.twins().into_iter().enumerate().filter(is_second).count();
    Measure {
        area: area.area(),
        volume: 0.0,
        boundary: area.perimeter(),
        vertices,
        edges: vertices - shared,
        faces: polygons.len(),
        holes: polygons.iter().map(|p| p.holes().count()).sum(),
        concave: !polygons.iter().all(Polygon::is_convex),
    }
}

fn prism(area: &Area, height: f64) -> Measure {
    let base = flat(area);
    Measure {
        area: 2.0 * base.area + base.boundary * height,
        volume: base.area * height,
        vertices: 2 * base.vertices,
        // Every part is a solid of its own: parts have no edges in common.
        edges: 3 * base.vertices,
        faces: 2 * base.faces + base.vertices,
        holes: 2 * base.holes,
        ..base
    }
}

fn boxed(size: DVec3) -> Measure {
    Measure {
        area: 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x),
        volume: size.element_product(),
        boundary: 2.0 * (size.x + size.z),
        vertices: 8,
        edges: 12,
        faces: 6,
        holes: 0,
        concave: false,
    }
}
