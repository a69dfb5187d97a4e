//! What a shape is made of: an enum whose common cases stay small and flat.
//!
//! Coordinates are local to the shape's scope, metres. Buffers are shared.

use crate::geometry::{Area, Mesh};
use glam::{DVec2, DVec3};
use std::sync::Arc;

/// The geometry of a shape.
#[derive(Clone, Debug, PartialEq)]
pub enum Geometry {
    /// Nothing.
    Empty,
    /// The origin of the scope.
    Point,
    /// A polyline of at least two points.
    Path(Arc<[DVec3]>),
    /// A planar region.
    Flat(Plane, Area),
    /// A planar region swept along the plane's normal by a height, which may be negative but not zero.
    Prism(Plane, Area, f64),
    /// Polygonal faces in space.
    Mesh(Arc<Mesh>),
    /// An element of the catalogue that fills the scope.
    Element(Arc<Placed>),
}

/// A plane in local coordinates with an origin and right-handed axes u, v and normal.
#[derive(Clone, Debug, PartialEq)]
pub enum Plane {
    /// u = x, v = −z, normal = y: the ground, seen from above.
    Ground,
    /// u = x, v = y, normal = z: a face seen from outside.
    Face,
    /// Any other: origin, u and v (unit, perpendicular).
    Free(Arc<[DVec3; 3]>),
}

/// An inserted element: which one, and the choices that were made for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Placed {
    /// The unique id of the catalogue entry.
    pub entry: Arc<str>,
    /// The type within the category: an age class, a form.
    pub kind: Arc<str>,
    /// Which of the appearances.
    pub appearance: u32,
    /// Age in years; 0 where the element has none.
    pub age: f64,
    /// It is a plant: round on the plan.
    pub round: bool,
    /// What growth says of it; none where the type's own figures hold. Its height and crown are the scope's.
    pub grown: Option<Grown>,
}

/// What is known of a plant of some age beside its height and crown.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grown {
    /// Diameter of the trunk at breast height, metres.
    pub trunk_diameter: f64,
    /// From the lowest leaves to the top, metres.
    pub crown_height: f64,
    /// One side of all leaves, m²; 0 where unknown.
    pub leaf_area: f64,
    /// What pruning left of the crown's volume, 0 to 1 (γ).
    pub pruning: f64,
    /// Its sizes follow curves fitted to measured trees.
    pub measured: bool,
}

impl Plane {
    /// A local point from plane coordinates.
    pub fn at(&self, p: DVec2) -> DVec3 {
        match self {
            Plane::Ground => DVec3::new(p.x, 0.0, -p.y),
            Plane::Face => DVec3::new(p.x, p.y, 0.0),
            Plane::Free(axes) => axes[0] + axes[1] * p.x + axes[2] * p.y,
        }
    }

    /// Plane coordinates of the foot of a local point.
    pub fn foot(&self, p: DVec3) -> DVec2 {
        match self {
            Plane::Ground => DVec2::new(p.x, -p.z),
            Plane::Face => DVec2::new(p.x, p.y),
            Plane::Free(axes) => DVec2::new((p - axes[0]).dot(axes[1]), (p - axes[0]).dot(axes[2])),
        }
    }

    /// The local unit normal.
    pub fn normal(&self) -> DVec3 {
        match self {
            Plane::Ground => DVec3::Y,
            Plane::Face => DVec3::Z,
            Plane::Free(axes) => axes[1].cross(axes[2]),
        }
    }

    /// The plane's axes u and v in local coordinates.
    pub fn axes(&self) -> (DVec3, DVec3) {
        match self {
            Plane::Ground => (DVec3::X, DVec3::NEG_Z),
            Plane::Face => (DVec3::X, DVec3::Y),
            Plane::Free(axes) => (axes[1], axes[2]),
        }
    }
}
