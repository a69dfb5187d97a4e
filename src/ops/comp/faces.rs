//! Faces, holes, groups and materials as components.

use crate::geometry::{Area, Bounds, BoxGrid, Mesh, Polygon, nearest_on_segment};
use crate::ops::comp::framed;
use crate::ops::{Component, Selectors, fit};
use crate::shape::{Geometry, Plane, Shape};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// Parts nearer than this (metres) to each other meet.
pub(super) const ALONG: f64 = 1e-4;

/// Every face, z along its normal.
pub(super) fn faces(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let inside = match &shape.geometry {
        Geometry::Flat(_, area) => surrounded(area),
        Geometry::Mesh(_) => open_faces(&mesh).into_iter().map(|open| !open).collect(),
        // Prisms are closed.
        _ => vec![true; mesh.face_count()],
    };
    let found = mesh.faces().enumerate().filter_map(|(index, face)| {
        let normal = face.normal();
        let rings: Vec<Vec<DVec3>> = face.rings().map(|ring| face.positions(ring).collect()).collect();
        let child = face_shape(shape, &rings, normal)?;
        let selectors = Selectors::of(middle(&rings[0]), normal, shape);
        let selectors = if inside[index] { selectors.inside() } else { selectors.border() };
        Some(Component { selectors, shape: child, words: &[] })
    });
    found.collect()
}

/// Every hole of every face as the face that fills it.
pub(super) fn holes(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let mut found = Vec::new();
    for face in mesh.faces() {
        let normal = face.normal();
        for ring in face.rings().skip(1) {
            let mut ring: Vec<DVec3> = face.positions(ring).collect();
            ring.reverse();
            let selectors = Selectors::of(middle(&ring), normal, shape).inside();
            let child = face_shape(shape, &[ring], normal);
            found.extend(child.map(|child| Component { selectors, shape: child, words: &[] }));
        }
    }
    found
}

/// The whole shape, for its one material; it answers to the words of all its faces.
pub(super) fn material(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let selectors = words_of(shape, &mesh, &(0..mesh.face_count()).collect::<Vec<_>>());
    vec![Component { selectors, shape: shape.clone(), words: &[] }]
}

/// Every part that hangs together; it answers to the words of all its faces.
pub(super) fn groups(shape: &Shape) -> Vec<Component> {
    let component = |geometry: Geometry| {
        let child = fit::fitted(shape, geometry.clone())?;
        let whole = Shape { geometry, ..shape.clone() };
        Some(Component { selectors: material(&whole)[0].selectors, shape: child, words: &[] })
    };
    let parts_of = |area: &Area| -> Vec<Area> {
        let sets = Mesh::flat(area, |p| p.extend(0.0)).connected_faces(ALONG);
        sets.iter().map(|set| set.iter().map(|face| area.polygons()[*face].clone()).collect()).collect()
    };
    let geometries: Vec<Geometry> = match &shape.geometry {
        Geometry::Flat(plane, area) => {
            parts_of(area).into_iter().map(|part| Geometry::Flat(plane.clone(), part)).collect()
        }
        Geometry::Prism(plane, area, height) => {
            parts_of(area).into_iter().map(|part| Geometry::Prism(plane.clone(), part, *height)).collect()
        }
        Geometry::Mesh(mesh) => {
            let sets = mesh.connected_faces(ALONG);
            sets.iter().map(|set| Geometry::Mesh(Arc::new(mesh.only(set)))).collect()
        }
        other => vec![other.clone()],
    };
    geometries.into_iter().filter_map(component).collect()
}

/// The words of any of some faces.
fn words_of(shape: &Shape, mesh: &Mesh, faces: &[usize]) -> Selectors {
    let of_face = |index: &usize| {
        let face = mesh.face(*index);
        let outline: Vec<DVec3> = face.positions(face.outline()).collect();
        Selectors::of(middle(&outline), face.normal(), shape)
    };
    faces.iter().map(of_face).fold(Selectors::all(), Selectors::or)
}

/// For each face whether one of its edges belongs to no other.
fn open_faces(mesh: &Mesh) -> Vec<bool> {
    let mut open = vec![false; mesh.face_count()];
    mesh.edges().iter().filter(|edge| edge.right.is_none()).for_each(|edge| open[edge.left as usize] = true);
    open
}

/// For each part whether its outline runs along other parts all around: what `offset` leaves inside its band. About
/// linear in the vertices.
fn surrounded(area: &Area) -> Vec<bool> {
    let polygons = area.polygons();
    if polygons.len() < 2 {
        return vec![false; polygons.len()];
    }
    let edges: Vec<(usize, (DVec2, DVec2))> =
        polygons.iter().enumerate().flat_map(|(part, p)| p.edges().map(move |edge| (part, edge))).collect();
    let boxes: Vec<Bounds> = edges.iter().map(|(_, (a, b))| Bounds::of([*a, *b]).grown(ALONG)).collect();
    let grid = BoxGrid::new(&boxes);
    let meets_other = |part: usize, p: DVec2| {
        grid.touching(Bounds::of([p])).any(|index| {
            let (other, (a, b)) = edges[index];
            other != part && nearest_on_segment(p, a, b).distance(p) < ALONG
        })
    };
    (0..).zip(polygons).map(|(part, polygon)| polygon.outer().iter().all(|p| meets_other(part, *p))).collect()
}

/// A face as a shape: z along the normal, x along the first edge.
fn face_shape(parent: &Shape, rings: &[Vec<DVec3>], normal: DVec3) -> Option<Shape> {
    let outline = rings.first()?;
    let x = (*outline.get(1)? - outline[0]).try_normalize()?;
    let y = normal.cross(x).try_normalize()?;
    let on_face = |p: &DVec3| DVec2::new((*p - outline[0]).dot(x), (*p - outline[0]).dot(y));
    let flat: Vec<Vec<DVec2>> = rings.iter().map(|ring| ring.iter().map(on_face).collect()).collect();
    let polygon = Polygon::new(&flat[0], &flat[1..])?;
    let turned = framed(parent, outline[0], x, y, normal);
    fit::fitted(&turned, Geometry::Flat(Plane::Face, polygon.into()))
}

/// The mean of the corners.
fn middle(ring: &[DVec3]) -> DVec3 {
    ring.iter().sum::<DVec3>() / ring.len().max(1) as f64
}
