//! `tag`, `deleteTags`, `setTagsFromEdgeAttrs`: names on faces, edges and vertices.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, Word};
use crate::shape::{Geometry, Part, Patch, Shape, Tag as Tagged};
use crate::value::Value;
use glam::DVec3;
use std::sync::Arc;

operation! {
    /// Tags the faces, edges or vertices of the shape.
    ///
    /// A name is divided by dots: `isTagged("bed")` finds `bed.roses`; `?` stands for any letter, `*` for any letters.
    /// Tags stay where they are: what is later split, set back or raised has those of the faces and edges it lies on.
    /// `auto` tags the faces of a surface, the edges of a line, the point of a point.
    /// ```cga
    /// Lot  --> comp(e) { 0 : tag("quay") Edge. } split(x) { ~1 : Half | ~1 : Half }
    /// Half --> tag("bed.roses") setback(3) { front : Meadow | remainder : Rest }
    /// Rest --> comp(f) { isTagged("bed") : Lawn | all : Gravel }
    /// ```
    "tag" (CityEngine, None) => pub struct Tag {
        /// The name.
        name: Word,
        /// What is tagged.
        parts: Parts = Parts::Auto => "auto",
    }
}

operation! {
    /// Removes tags: all, or those that answer to a query.
    /// ```cga
    /// Lot  --> tag("bed") split(x) { ~1 : Part | ~1 : deleteTags("bed") Part | ~1 : Part }
    /// Part --> comp(f) { isTagged("bed") : Bed | all : Lawn }
    /// ```
    "deleteTags" (CityEngine, None) => pub struct DeleteTags {
        /// Which tags, by name, with `?` and `*`.
        query: Word = Word("*".into()) => "*",
        /// Of which components.
        parts: Parts = Parts::Auto => "auto: of all",
    }
}

operation! {
    /// Tags the edges of the region by its attributes for edges: `edgeattr.name.value`.
    ///
    /// An attribute of the region that is a list has a value for each edge of its outline; see `edgeAttr.getFloat`.
    /// ```cga
    /// Lot  --> setTagsFromEdgeAttrs() Edge
    /// Edge --> setback(4) { isTagged("edgeattr.side.street") = Gravel | all = Hedge | remainder : Lawn }
    /// ```
    "setTagsFromEdgeAttrs" (CityEngine, None) => pub struct SetTagsFromEdgeAttrs {}
}

choice! {
    /// Components.
    pub enum Parts {
        /// Faces of surfaces, edges of lines, points.
        Auto = "auto",
        /// Faces.
        Faces = "faces",
        /// Edges.
        Edges = "edges",
        /// Vertices.
        Vertices = "vertices",
    }
}

/// Tags the faces of what has just been raised, upwards or (-1) downwards in its scope.
pub(super) fn extruded(shape: &mut Shape, sign: f64) {
    let way = match &shape.geometry {
        Geometry::Prism(plane, _, height) => plane.normal() * height.signum(),
        _ => shape.scope.frame.rotation.inverse() * DVec3::Y * sign,
    };
    let way = shape.scope.frame.rotation * way;
    let name = |patch: &Patch| match patch.normal().dot(way) {
        along if along > 0.99 => "extrude.top",
        along if along < -0.99 => "extrude.bottom",
        _ => "extrude.side",
    };
    let patches = shape.patches(Part::Faces).into_iter();
    let tags: Vec<Tagged> = patches.map(|patch| Tagged { name: name(&patch).into(), patch }).collect();
    shape.surface_mut().tags.extend(tags);
}

impl Parts {
    fn of(self, shape: &Shape) -> Part {
        match self {
            Parts::Auto => shape.main_part(),
            Parts::Faces => Part::Faces,
            Parts::Edges => Part::Edges,
            Parts::Vertices => Part::Vertices,
        }
    }
}

impl Apply for Tag {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let name = &self.name.0;
        if name.is_empty() || name.split('.').any(str::is_empty) || name.contains(['?', '*']) {
            let hint = "letters and digits, divided by dots";
            return Err(Problem::new(format!("`{name}` is not a name for a tag")).hint(hint));
        }
        shape.tag(name, self.parts.of(shape));
        Ok(Pieces::Changed)
    }
}

impl Apply for DeleteTags {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let meant = |tag: &Tagged| {
            let sort = match (self.parts, &tag.patch) {
                (Parts::Auto, _) => true,
                (Parts::Faces, patch) => matches!(patch, Patch::Face(_)),
                (Parts::Edges, patch) => matches!(patch, Patch::Edge(_)),
                (Parts::Vertices, patch) => matches!(patch, Patch::Vertex(_)),
            };
            sort && tag.answers(&self.query.0)
        };
        if shape.attached().is_some_and(|surface| surface.tags.iter().any(meant)) {
            shape.surface_mut().tags.retain(|tag| !meant(tag));
        }
        Ok(Pieces::Changed)
    }
}

impl Apply for SetTagsFromEdgeAttrs {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let ground = shape.scope.frame.origin.y;
        let edges: Vec<[DVec3; 2]> =
            given.outline.edges().map(|(a, b)| [a, b].map(|p| DVec3::new(p.x, ground, -p.y))).collect();
        let mut tags = Vec::new();
        for (name, values) in given.edge_attributes {
            for (index, ends) in edges.iter().enumerate().take(values.len()) {
                let value: Value = values.at(index);
                let name: Arc<str> = format!("edgeattr.{name}.{value}").into();
                tags.push(Tagged { name, patch: Patch::Edge(*ends) });
            }
        }
        if !tags.is_empty() {
            shape.surface_mut().tags.extend(tags);
        }
        Ok(Pieces::Changed)
    }
}
