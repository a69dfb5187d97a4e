//! `comp`: takes a shape apart into faces, edges or vertices.

use crate::geometry::{Area, Mesh, Polygon};
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Component, Given, Part, Pieces, Problem, Selectors, fit};
use crate::shape::{Frame, Geometry, Plane, Scope, Shape};
use glam::{DMat3, DQuat, DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// Takes the shape apart into its faces, edges or vertices.
    ///
    /// A face's scope has z along its normal and x along its first edge; an edge's has x along the edge and z
    /// outwards; a vertex is a point. Selectors take components from left to right: what one has taken the next does
    /// not get. After `:` stands what becomes of each component, after `=` of all taken ones in one shape.
    /// `comp.index` and `comp.total` count the components.
    ///
    /// The papers write `Comp(e) { B }` (Ulmer et al. 2007, §2.1).
    /// ```cga
    /// Hedge --> extrude(1.5) comp(f) { top : Clipped | side = Leaves }
    /// ```
    "comp" (CityEngine, Selectors(&[])) => pub struct Comp {
        /// What to take the shape apart into: faces, edges, edges of each face, vertices.
        component: Kind,
    }
}

choice! {
    /// A sort of component.
    pub enum Kind {
        /// Faces.
        Faces = "f",
        /// Edges, each once.
        Edges = "e",
        /// Edges of each face, the face to the left.
        FaceEdges = "fe",
        /// Vertices, each once.
        Vertices = "v",
    }
}

/// Parts nearer than this (metres) to each other meet.
const ALONG: f64 = 1e-4;

impl Apply for Comp {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let mut found = match (self.component, &shape.geometry) {
            (_, Geometry::Element(_)) => return Err(Problem::new("an inserted element has no components")),
            (_, Geometry::Empty | Geometry::Point) => Vec::new(),
            (Kind::Faces, _) => faces(shape),
            (Kind::Edges | Kind::FaceEdges, Geometry::Path(points)) => path_edges(shape, points),
            (Kind::Edges | Kind::FaceEdges, Geometry::Flat(plane, area)) => flat_edges(shape, plane, area),
            (Kind::Edges, _) => solid_edges(shape),
            (Kind::FaceEdges, _) => face_edges(shape),
            (Kind::Vertices, _) => vertices(shape),
        };
        let total = found.len() as u32;
        for (index, component) in found.iter_mut().enumerate() {
            component.shape.ordinals.comp = (index as u32, total);
        }
        Ok(found)
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let components = self.components(shape)?;
        let mut parts: Vec<Part> = Vec::new();
        let mut together: std::collections::BTreeMap<u16, Vec<Shape>> = std::collections::BTreeMap::new();
        for (component, chosen) in components.into_iter().zip(given.chosen) {
            match chosen {
                Some(choice) if choice.together => together.entry(choice.entry).or_default().push(component.shape),
                Some(choice) => parts.push(Part::new(choice.entry, component.shape)),
                None => {}
            }
        }
        for (entry, shapes) in together {
            parts.push(Part::new(entry, joined(shape, shapes)?));
        }
        Ok(Pieces::Parts(parts))
    }
}

/// All taken faces as one shape in the parent's frame.
pub fn joined(parent: &Shape, shapes: Vec<Shape>) -> Result<Shape, Problem> {
    let inverse = parent.scope.frame.rotation.inverse();
    let origin = parent.scope.frame.origin;
    let to_parent = glam::DAffine3::from_rotation_translation(inverse, inverse * -origin);
    let mut mesh = Mesh::default();
    for shape in &shapes {
        let Some(face) = shape.world_mesh() else {
            let hint = "`:` gives one shape for each";
            return Err(Problem::new("edges and vertices cannot be put together with `=`").hint(hint));
        };
        mesh.append(&face.transformed(&to_parent));
    }
    fit::fitted(parent, Geometry::Mesh(Arc::new(mesh))).ok_or_else(|| Problem::new("nothing was taken"))
}

fn faces(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let found = mesh.faces().enumerate().filter_map(|(index, face)| {
        let normal = face.normal();
        let rings: Vec<Vec<DVec3>> = face.rings().map(|ring| face.positions(ring).collect()).collect();
        let child = face_shape(shape, &rings, normal)?;
        let selectors = Selectors::of_normal(normal, shape);
        let selectors = match &shape.geometry {
            Geometry::Flat(_, area) if is_surrounded(area, index) => selectors.inside(),
            Geometry::Flat(..) => selectors.border(),
            _ => selectors,
        };
        Some(Component { selectors, shape: child, words: &[] })
    });
    found.collect()
}

/// Whether the outline of a part runs along other parts all around: what `offset` leaves inside its band. Cost: the
/// vertices of the part times those of all others.
fn is_surrounded(area: &Area, index: usize) -> bool {
    let polygons = area.polygons();
    let others: Area = (0..polygons.len()).filter(|i| *i != index).map(|i| polygons[i].clone()).collect();
    !others.is_empty() && polygons[index].outer().iter().all(|p| others.distance_to_edges(*p) < ALONG)
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

/// `parent` with its scope moved to a local point and turned to local axes.
fn framed(parent: &Shape, at: DVec3, x: DVec3, y: DVec3, z: DVec3) -> Shape {
    let rotation = DQuat::from_mat3(&DMat3::from_cols(x, y, z));
    let frame: Frame = parent.scope.frame.moved(at).turned(rotation);
    Shape { scope: Scope { frame, size: DVec3::ZERO }, ..parent.clone() }
}

/// An edge as a shape: x along it, z outwards.
fn edge(parent: &Shape, from: DVec3, to: DVec3, outward: DVec3) -> Option<Component> {
    let length = from.distance(to);
    let x = (to - from).try_normalize()?;
    let z = outward.reject_from(x).try_normalize()?;
    let mut shape = framed(parent, from, x, z.cross(x), z);
    shape.scope.size = DVec3::new(length, 0.0, 0.0);
    shape.geometry = Geometry::Path([DVec3::ZERO, DVec3::new(length, 0.0, 0.0)].into());
    Some(Component { selectors: Selectors::of_normal(z, parent), shape, words: &[] })
}

fn path_edges(shape: &Shape, points: &[DVec3]) -> Vec<Component> {
    let up = shape.scope.frame.rotation.inverse() * DVec3::Y;
    let outward = |a: DVec3, b: DVec3| (b - a).cross(up).try_normalize().unwrap_or(DVec3::Z);
    points.windows(2).filter_map(|w| edge(shape, w[0], w[1], outward(w[0], w[1]))).collect()
}

fn flat_edges(shape: &Shape, plane: &Plane, area: &Area) -> Vec<Component> {
    let normal = plane.normal();
    let mut found = Vec::new();
    for polygon in area.polygons() {
        for (number, ring) in polygon.rings().enumerate() {
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                let (from, to) = (plane.at(*a), plane.at(*b));
                let Some(mut component) = edge(shape, from, to, (to - from).cross(normal)) else { continue };
                let selectors = component.selectors;
                component.selectors = if number == 0 { selectors.border() } else { selectors.inside() };
                found.push(component);
            }
        }
    }
    found
}

fn solid_edges(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let normals: Vec<DVec3> = mesh.faces().map(|face| face.normal()).collect();
    let at = |index: u32| mesh.positions[index as usize];
    let outward = |left: u32, right: Option<u32>| {
        normals[left as usize] + right.map_or(DVec3::ZERO, |face| normals[face as usize])
    };
    let edges = mesh.edges();
    edges.iter().filter_map(|e| edge(shape, at(e.from), at(e.to), outward(e.left, e.right))).collect()
}

fn face_edges(shape: &Shape) -> Vec<Component> {
    let mesh = shape.local_mesh().unwrap_or_default();
    let mut found = Vec::new();
    for face in mesh.faces() {
        let normal = face.normal();
        for ring in face.rings() {
            let points: Vec<DVec3> = face.positions(ring).collect();
            let pairs = points.iter().zip(points.iter().cycle().skip(1));
            found.extend(pairs.filter_map(|(a, b)| edge(shape, *a, *b, (*b - *a).cross(normal))));
        }
    }
    found
}

fn vertices(shape: &Shape) -> Vec<Component> {
    let points: Vec<DVec3> = match &shape.geometry {
        Geometry::Path(points) => points.to_vec(),
        Geometry::Flat(plane, area) => area.edges().map(|(a, _)| plane.at(a)).collect(),
        _ => shape.local_mesh().map(|mesh| mesh.positions).unwrap_or_default(),
    };
    let component = |p: DVec3| Component { shape: fit::point(shape, p), selectors: Selectors::all(), words: &[] };
    points.into_iter().map(component).collect()
}
