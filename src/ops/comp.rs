//! `comp`: takes a shape apart into faces, edges, vertices, groups, materials or holes.

mod edges;
mod faces;
mod join;

pub(super) use edges::edge;
pub use join::joined;

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Component, Gather, Given, Part, Pieces, Problem, fit, gather};
use crate::shape::{Frame, Geometry, Plane, Scope, Shape};
use glam::{DMat3, DQuat, DVec2, DVec3};
use std::collections::BTreeMap;
use std::sync::Arc;

operation! {
    /// Takes the shape apart into its faces, edges, vertices, groups, materials or holes.
    ///
    /// A face's scope has z along its normal and x along its first edge; an edge's has x along the edge and z
    /// outwards; a vertex is a point. Selectors take components from left to right: what one has taken the next does
    /// not get. After `:` stands what becomes of each component, after `=` of all taken ones in one shape, after `=:`
    /// of each set that hangs together: faces by common edges, edges as a line. `comp.index` and `comp.total` count
    /// the shapes that a selector has made; conditions in selectors, which come before, see the number among all
    /// components. `comp.sel` is the word that took one.
    ///
    /// A group is what hangs together, and so far a shape has one material. A hole becomes the face that fills it.
    ///
    /// The papers write `Comp(e) { B }` (Ulmer et al. 2007, §2.1).
    /// ```cga
    /// Lot   --> setback(5) { all = Gravel | remainder : Green }
    /// Green --> [ comp(e) { left : Row | right : Row | all : NIL } ] [ comp(v) { all : i("urn") } ] comp(f) { all : Lawn }
    /// Row   --> along(spacing = 5) { plant("lime") } NIL
    /// ```
    "comp" (CityEngine, Selectors(&[])) => pub struct Comp {
        /// What to take the shape apart into: faces, edges, edges of each face, vertices …
        component: Kind,
        /// Whether the components' scopes follow them or stay as the shape's is turned.
        scope: Align = Align::ZUp => "zUp",
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
        /// Vertices of each face.
        FaceVertices = "fv",
        /// Parts that hang together.
        Groups = "g",
        /// Parts of one material.
        Materials = "m",
        /// Holes of faces.
        Holes = "h",
    }
}

choice! {
    /// How components are turned.
    pub enum Align {
        /// z along a face's normal, out of an edge.
        ZUp = "zUp",
        /// As the shape.
        NoAlign = "noAlign",
    }
}

impl Apply for Comp {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let mut found = match (self.component, &shape.geometry) {
            (_, Geometry::Element(_)) => return Err(Problem::new("an inserted element has no components")),
            (_, Geometry::Empty) => Vec::new(),
            (Kind::Groups, _) => faces::groups(shape),
            (Kind::Materials, _) => faces::material(shape),
            (_, Geometry::Point) => Vec::new(),
            (Kind::Faces, _) => faces::faces(shape),
            (Kind::Holes, _) => faces::holes(shape),
            (Kind::Edges, _) => edges::edges(shape),
            (Kind::FaceEdges, _) => edges::face_edges(shape),
            (Kind::Vertices, _) => edges::vertices(shape),
            (Kind::FaceVertices, _) => edges::face_vertices(shape),
        };
        if self.scope == Align::NoAlign {
            found.iter_mut().for_each(|component| component.shape = unturned(shape, &component.shape));
        }
        numbered(&mut found);
        Ok(found)
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let components = self.components(shape)?;
        let mut parts: Vec<Part> = Vec::new();
        let mut waiting: BTreeMap<u16, (Gather, Vec<Shape>)> = BTreeMap::new();
        for (component, chosen) in components.into_iter().zip(given.chosen) {
            match chosen {
                Some(choice) if choice.gather == Gather::Each => {
                    parts.push(Part::new(choice.entry, component.shape));
                }
                Some(choice) => {
                    waiting.entry(choice.entry).or_insert((choice.gather, Vec::new())).1.push(component.shape);
                }
                None => {}
            }
        }
        for (entry, (gather, shapes)) in waiting {
            let joined = joined(shape, &shapes, gather)?;
            parts.extend(joined.into_iter().map(|shape| Part::new(entry, shape)));
        }
        gather::count(parts.iter_mut().map(|part| (part.entry, &mut *part.shape)));
        Ok(Pieces::Parts(parts))
    }
}

/// Gives components the numbers that selectors see; what is left over has none.
pub(super) fn numbered(components: &mut [Component]) {
    let total = components.len() as u32;
    for (index, component) in components.iter_mut().enumerate() {
        component.shape.ordinals.comp = (index as u32, total);
    }
}

/// `parent` with its scope moved to a local point and turned to local axes.
fn framed(parent: &Shape, at: DVec3, x: DVec3, y: DVec3, z: DVec3) -> Shape {
    let rotation = DQuat::from_mat3(&DMat3::from_cols(x, y, z));
    let frame: Frame = parent.scope.frame.moved(at).turned(rotation);
    Shape { scope: Scope { frame, size: DVec3::ZERO }, ..parent.clone() }
}

/// A component with its scope turned back to the parent's.
fn unturned(parent: &Shape, child: &Shape) -> Shape {
    let turn = parent.scope.frame.rotation.inverse() * child.scope.frame.rotation;
    let at = parent.scope.frame.to_local(child.scope.frame.origin);
    let back = |p: DVec3| at + turn * p;
    let geometry = match &child.geometry {
        Geometry::Flat(plane, area) => {
            let (u, v) = plane.axes();
            let origin = back(plane.at(DVec2::ZERO));
            Geometry::Flat(Plane::Free(Arc::new([origin, turn * u, turn * v])), area.clone())
        }
        Geometry::Path(points) => Geometry::Path(points.iter().map(|p| back(*p)).collect()),
        Geometry::Point => return Shape { ordinals: child.ordinals, ..fit::point(parent, at) },
        _ => return child.clone(),
    };
    fit::fitted(parent, geometry).unwrap_or_else(|| child.clone())
}
