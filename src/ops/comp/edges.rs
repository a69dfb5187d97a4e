//! Edges and vertices as components, and what an edge of a roof is.

use crate::geometry::{Edge, Mesh};
use crate::ops::comp::framed;
use crate::ops::{Component, RoofEdge, Selectors, fit, rim};
use crate::shape::{Geometry, Shape};
use glam::DVec3;

/// An edge as a shape: x along it, z outwards. Without length it is a point.
pub(in crate::ops) fn edge(parent: &Shape, from: DVec3, to: DVec3, outward: DVec3) -> Component {
    let axes = (to - from).try_normalize().and_then(|x| Some((x, outward.reject_from(x).try_normalize()?)));
    let Some((x, z)) = axes else {
        return Component { shape: fit::point(parent, from), selectors: Selectors::all(), words: &[] };
    };
    let mut shape = framed(parent, from, x, z.cross(x), z);
    let end = DVec3::new(from.distance(to), 0.0, 0.0);
    shape.scope.size = end;
    shape.geometry = Geometry::Path([DVec3::ZERO, end].into());
    Component { selectors: Selectors::of((from + to) * 0.5, z, parent), shape, words: &[] }
}

/// Every edge once.
pub(super) fn edges(shape: &Shape) -> Vec<Component> {
    let found = match &shape.geometry {
        Geometry::Path(points) => path_edges(shape, points),
        Geometry::Flat(plane, area) => rim::edges_once(shape, plane, area),
        _ => solid_edges(shape),
    };
    with_length(found)
}

/// Every edge of every face.
pub(super) fn face_edges(shape: &Shape) -> Vec<Component> {
    let found = match &shape.geometry {
        Geometry::Path(points) => path_edges(shape, points),
        Geometry::Flat(plane, area) => rim::edges(shape, plane, area),
        _ => solid_face_edges(shape),
    };
    with_length(found)
}

/// Every vertex once, as a point turned as the shape is.
pub(super) fn vertices(shape: &Shape) -> Vec<Component> {
    let points: Vec<DVec3> = match &shape.geometry {
        Geometry::Path(points) => points.to_vec(),
        Geometry::Flat(plane, area) => area.edges().map(|(a, _)| plane.at(a)).collect(),
        _ => shape.local_mesh().map(|mesh| mesh.positions).unwrap_or_default(),
    };
    let component = |p: DVec3| Component { shape: fit::point(shape, p), selectors: Selectors::all(), words: &[] };
    points.into_iter().map(component).collect()
}

/// The vertices of every face: the points where its edges begin, turned as they are.
pub(super) fn face_vertices(shape: &Shape) -> Vec<Component> {
    let point = |component: Component| {
        let mut shape = component.shape;
        (shape.geometry, shape.scope.size) = (Geometry::Point, DVec3::ZERO);
        Component { shape, ..component }
    };
    face_edges(shape).into_iter().map(point).collect()
}

fn with_length(mut found: Vec<Component>) -> Vec<Component> {
    found.retain(|component| component.shape.geometry != Geometry::Point);
    found
}

fn path_edges(shape: &Shape, points: &[DVec3]) -> Vec<Component> {
    let up = shape.scope.frame.rotation.inverse() * DVec3::Y;
    let outward = |a: DVec3, b: DVec3| (b - a).cross(up).try_normalize().unwrap_or(DVec3::Z);
    points.windows(2).map(|w| edge(shape, w[0], w[1], outward(w[0], w[1]))).collect()
}

fn solid_face_edges(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let mut found = Vec::new();
    for face in mesh.faces() {
        let normal = face.normal();
        for ring in face.rings() {
            let points: Vec<DVec3> = face.positions(ring).collect();
            let pairs = points.iter().zip(points.iter().cycle().skip(1));
            found.extend(pairs.map(|(a, b)| edge(shape, *a, *b, (*b - *a).cross(normal))));
        }
    }
    found
}

fn solid_edges(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let roof = Roof::of(shape, &mesh);
    let at = |index: u32| mesh.positions[index as usize];
    let component = |e: &Edge| {
        let kind = roof.kind(e);
        let outward = roof.normals[e.left as usize] + e.right.map_or(DVec3::ZERO, |face| roof.normals[face as usize]);
        // Edges between slopes run upwards.
        let falls = kind.is_some_and(|kind| kind != RoofEdge::Eave) && roof.rise(e) < 0.0;
        let (from, to) = if falls { (at(e.to), at(e.from)) } else { (at(e.from), at(e.to)) };
        let component = edge(shape, from, to, outward);
        let selectors = component.selectors;
        let selectors = if e.right.is_none() { selectors.border() } else { selectors.inside() };
        Component { selectors: kind.map_or(selectors, |kind| selectors.roof(kind)), ..component }
    };
    roof.edges.iter().map(component).collect()
}

/// A mesh seen as a roof: which of its faces are slopes, and where their feet are.
struct Roof<'m> {
    mesh: &'m Mesh,
    edges: Vec<Edge>,
    /// By face, in the scope.
    normals: Vec<DVec3>,
    /// Up, in the scope.
    up: DVec3,
    /// By vertex: an eave begins or ends there.
    at_eave: Vec<bool>,
}

impl<'m> Roof<'m> {
    fn of(shape: &Shape, mesh: &'m Mesh) -> Roof<'m> {
        let normals = mesh.faces().map(|face| face.normal()).collect();
        let up = shape.scope.frame.rotation.inverse() * DVec3::Y;
        let mut roof = Roof { mesh, edges: mesh.edges(), normals, up, at_eave: vec![false; mesh.positions.len()] };
        let eaves: Vec<Edge> = roof.edges.iter().filter(|edge| roof.is_eave(edge)).copied().collect();
        eaves.iter().flat_map(|edge| [edge.from, edge.to]).for_each(|vertex| roof.at_eave[vertex as usize] = true);
        roof
    }

    fn kind(&self, edge: &Edge) -> Option<RoofEdge> {
        if self.is_eave(edge) {
            return Some(RoofEdge::Eave);
        }
        let right = edge.right.filter(|right| self.is_slope(*right) && self.is_slope(edge.left))?;
        let bend = self.normals[edge.left as usize].cross(self.normals[right as usize]);
        let touches_eave = self.at_eave[edge.from as usize] || self.at_eave[edge.to as usize];
        match bend.dot(self.along(edge)) {
            _ if bend.length() < 1e-6 => None,
            hollow if hollow < 0.0 => Some(RoofEdge::Valley),
            _ if touches_eave => Some(RoofEdge::Hip),
            _ => Some(RoofEdge::Ridge),
        }
    }

    /// Whether it is the level foot of a slope with no other slope beyond.
    fn is_eave(&self, edge: &Edge) -> bool {
        let along = self.along(edge);
        let level = along.dot(self.up).abs() < rim::LEAST_SLOPE * along.length();
        let foot = |face: u32, along: DVec3| {
            self.is_slope(face) && along.cross(self.normals[face as usize]).dot(self.up) < 0.0
        };
        match (level, edge.right) {
            (false, _) => false,
            (true, None) => foot(edge.left, along),
            (true, Some(right)) => {
                self.is_slope(edge.left) != self.is_slope(right) && (foot(edge.left, along) || foot(right, -along))
            }
        }
    }

    fn is_slope(&self, face: u32) -> bool {
        rim::is_slope(self.normals[face as usize].dot(self.up))
    }

    fn along(&self, edge: &Edge) -> DVec3 {
        self.mesh.positions[edge.to as usize] - self.mesh.positions[edge.from as usize]
    }

    fn rise(&self, edge: &Edge) -> f64 {
        self.along(edge).dot(self.up)
    }
}
