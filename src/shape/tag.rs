//! Tags: names on faces, edges and vertices, as patches that lie in the world.
//!
//! A component has a tag where the patch covers it. So tags survive splits, setbacks and extrusions: what is left of a
//! tagged edge still lies on it, and what is left of a tagged face within it.

use crate::geometry::{Area, Polygon};
use crate::pattern::glob;
use crate::shape::{Geometry, Shape};
use glam::{DAffine3, DVec2, DVec3};
use std::sync::Arc;

/// Points nearer than this (metres) to a patch lie on it.
const ON: f64 = 1e-3;

/// A name on a part of a surface.
#[derive(Clone, Debug, PartialEq)]
pub struct Tag {
    /// Its name; parts are divided by dots.
    pub name: Arc<str>,
    /// Where.
    pub patch: Patch,
}

/// Where a tag lies.
#[derive(Clone, Debug, PartialEq)]
pub enum Patch {
    /// Within a plane ring with holes: of each the corners, counter-clockwise seen from outside.
    Face(Arc<[Vec<DVec3>]>),
    /// Between two points.
    Edge([DVec3; 2]),
    /// At a point.
    Vertex(DVec3),
}

/// What of a shape can be tagged.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Part {
    /// Faces.
    Faces,
    /// Edges.
    Edges,
    /// Vertices.
    Vertices,
}

impl Tag {
    /// Moves it with what it lies on.
    pub fn carried(&mut self, motion: &DAffine3) {
        let moved = |p: &DVec3| motion.transform_point3(*p);
        self.patch = match &self.patch {
            Patch::Face(rings) => Patch::Face(rings.iter().map(|ring| ring.iter().map(moved).collect()).collect()),
            Patch::Edge(ends) => Patch::Edge([moved(&ends[0]), moved(&ends[1])]),
            Patch::Vertex(at) => Patch::Vertex(moved(at)),
        };
    }

    /// Whether its name is asked for: by itself or one of its beginnings up to a dot, with `?` for any letter and `*`
    /// for any letters.
    pub fn answers(&self, query: &str) -> bool {
        let ends = self.name.match_indices('.').map(|(end, _)| end).chain([self.name.len()]);
        ends.into_iter().any(|end| glob(query, &self.name[..end]))
    }
}

impl Patch {
    /// The way a face looks, a unit vector; zero for edges and vertices.
    pub fn normal(&self) -> DVec3 {
        match self {
            Patch::Face(rings) => rings.first().map_or(DVec3::ZERO, |ring| normal(ring)),
            Patch::Edge(_) | Patch::Vertex(_) => DVec3::ZERO,
        }
    }

    /// Whether it covers another patch of its own sort.
    pub fn covers(&self, other: &Patch) -> bool {
        match (self, other) {
            (Patch::Face(own), Patch::Face(rings)) => covers_face(own, rings),
            (Patch::Edge(own), Patch::Edge(ends)) => ends.iter().all(|p| distance(*p, own) < ON),
            (Patch::Vertex(own), Patch::Vertex(at)) => own.distance(*at) < ON,
            _ => false,
        }
    }
}

impl Shape {
    /// What it is tagged by where nothing else is said: a surface by its faces, a line by its edges, a point by itself.
    pub fn main_part(&self) -> Part {
        match self.geometry {
            Geometry::Path(_) => Part::Edges,
            Geometry::Point | Geometry::Empty => Part::Vertices,
            _ => Part::Faces,
        }
    }

    /// Its faces, edges or vertices as patches of the world. Linear in its vertices.
    pub fn patches(&self, part: Part) -> Vec<Patch> {
        let world = |p: &DVec3| self.scope.frame.to_world(*p);
        match &self.geometry {
            Geometry::Empty | Geometry::Element(_) => return Vec::new(),
            Geometry::Point => {
                return (part == Part::Vertices)
                    .then_some(Patch::Vertex(self.scope.frame.origin))
                    .into_iter()
                    .collect();
            }
            Geometry::Path(points) => {
                let points: Vec<DVec3> = points.iter().map(world).collect();
                return match part {
                    Part::Faces => Vec::new(),
                    Part::Edges => points.windows(2).map(|w| Patch::Edge([w[0], w[1]])).collect(),
                    Part::Vertices => points.into_iter().map(Patch::Vertex).collect(),
                };
            }
            _ => {}
        }
        let mesh = self.world_mesh().unwrap_or_default();
        match part {
            Part::Faces => mesh
                .faces()
                .map(|face| Patch::Face(face.rings().map(|ring| face.positions(ring).collect()).collect()))
                .collect(),
            Part::Edges => {
                let at = |index: u32| mesh.positions[index as usize];
                mesh.edges().iter().map(|e| Patch::Edge([at(e.from), at(e.to)])).collect()
            }
            Part::Vertices => mesh.positions.into_iter().map(Patch::Vertex).collect(),
        }
    }

    /// Tags every face, edge or vertex.
    pub fn tag(&mut self, name: &Arc<str>, part: Part) {
        let tags = self.patches(part).into_iter().map(|patch| Tag { name: name.clone(), patch });
        let tags: Vec<Tag> = tags.collect();
        if !tags.is_empty() {
            self.surface_mut().tags.extend(tags);
        }
    }

    /// Whether a face, edge or vertex of it has a tag that answers to a query. Cost: tags times components.
    pub fn is_tagged(&self, query: &str, part: Part) -> bool {
        let tags = self.attached().map_or(&[][..], |surface| &surface.tags);
        let mut asked = tags.iter().filter(|tag| tag.answers(query)).peekable();
        if asked.peek().is_none() {
            return false;
        }
        let patches = self.patches(part);
        asked.any(|tag| patches.iter().any(|patch| tag.patch.covers(patch)))
    }

    /// The names of all tags on its components of a sort, each once, in alphabetical order.
    pub fn tags(&self, part: Part) -> Vec<Arc<str>> {
        let tags = self.attached().map_or(&[][..], |surface| &surface.tags);
        let patches = if tags.is_empty() { Vec::new() } else { self.patches(part) };
        let held = tags.iter().filter(|tag| patches.iter().any(|patch| tag.patch.covers(patch)));
        let names: std::collections::BTreeSet<Arc<str>> = held.map(|tag| tag.name.clone()).collect();
        names.into_iter().collect()
    }
}

/// Whether the corners of a face and its middle lie in another.
fn covers_face(own: &[Vec<DVec3>], rings: &[Vec<DVec3>]) -> bool {
    let (Some(outline), Some(other)) = (own.first(), rings.first()) else { return false };
    let normal = normal(outline);
    let aligned = normal.dot(self::normal(other)) > 1.0 - 1e-6;
    if !aligned || other.iter().any(|p| normal.dot(*p - outline[0]).abs() > ON) {
        return false;
    }
    let along = (outline[1] - outline[0]).normalize_or_zero();
    let across = normal.cross(along);
    let flat = |ring: &Vec<DVec3>| -> Vec<DVec2> {
        ring.iter().map(|p| DVec2::new((*p - outline[0]).dot(along), (*p - outline[0]).dot(across))).collect()
    };
    let holes: Vec<Vec<DVec2>> = own[1..].iter().map(flat).collect();
    let Some(whole) = Polygon::new(&flat(outline), &holes).map(Area::from) else { return false };
    flat(other).into_iter().all(|p| whole.contains(p) || whole.distance_to_edges(p) < ON)
}

/// The unit normal of a ring, counter-clockwise seen from its tip (Newell's sum).
fn normal(ring: &[DVec3]) -> DVec3 {
    let pairs = ring.iter().zip(ring.iter().cycle().skip(1));
    pairs.map(|(a, b)| (*a - ring[0]).cross(*b - ring[0])).sum::<DVec3>().normalize_or_zero()
}

fn distance(p: DVec3, [a, b]: &[DVec3; 2]) -> f64 {
    let along = *b - *a;
    let length = along.length_squared();
    let share = if length > 0.0 { ((p - *a).dot(along) / length).clamp(0.0, 1.0) } else { 0.0 };
    p.distance(*a + along * share)
}
