//! `alignScopeToGeometry` and `alignScopeToGeometryBBox`: turn the scope along a face and an edge, or the least rectangle.

use crate::geometry::{Mesh, OrientedBox};
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, ParamKind, Parameter, Pieces, Problem, align_scope_to_axes};
use crate::shape::{Geometry, Shape};
use crate::value::Value;
use glam::{DMat3, DQuat, DVec2, DVec3};

operation! {
    /// Turns the scope along a face and one of its edges and fits it again; the geometry stays where it is.
    ///
    /// x runs along the edge, y or z along the face's normal. Faces and edges have a number, from the end where it is
    /// negative, or are chosen: the lowest, the largest face, the longest edge, any. A single choice is the edge's.
    /// ```cga
    /// Lot --> split(x) { ~1 : alignScopeToGeometry(yUp, 0, 1) Beds | 2 : Gravel | ~1 : Beds }
    /// Beds --> split(x) { 3 : Bed | ~1 : Lawn }
    /// ```
    "alignScopeToGeometry" (CityEngine, None) => pub struct AlignScopeToGeometry {
        /// The axis along the face's normal.
        up: Up,
        /// The face; the edge where nothing follows.
        face: Chosen,
        /// The edge.
        edge: Option<Chosen> = None => "the choice before, on the largest face",
    }
}

operation! {
    /// Turns the scope along the rectangle of least area around the geometry, seen along the normal of its largest face.
    ///
    /// The first axis runs along the longer side, the second along the shorter one.
    /// ```cga
    /// Lot --> setback(6) { all : Meadow | remainder : alignScopeToGeometryBBox(zx) split(z) { ~4 : Lawn | 2 : Gravel }* }
    /// ```
    "alignScopeToGeometryBBox" (CityEngine, None) => pub struct AlignToBox {
        /// The axes along the longer and the shorter side.
        axes: Sides,
    }
}

choice! {
    /// The axis along the face's normal.
    pub enum Up {
        /// y
        Y = "yUp",
        /// z
        Z = "zUp",
    }
}

choice! {
    /// Two axes.
    pub enum Sides {
        /// x and y
        Xy = "xy",
        /// x and z
        Xz = "xz",
        /// y and x
        Yx = "yx",
        /// y and z
        Yz = "yz",
        /// z and x
        Zx = "zx",
        /// z and y
        Zy = "zy",
    }
}

/// Which face or edge.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Chosen {
    /// By its number.
    Index(f64),
    /// The one whose middle is lowest in the world.
    Lowest,
    /// The one of greatest area or length.
    Largest,
    /// Any: the first.
    Any,
}

impl Parameter for Chosen {
    const KIND: ParamKind = ParamKind::Index(&["world.lowest", "largest", "longest", "any", "auto"]);
    fn from_value(value: &Value) -> Option<Self> {
        match (value.as_float(), value.as_str()) {
            (Some(number), _) if number.is_finite() => Some(Chosen::Index(number)),
            (_, Some("world.lowest" | "auto")) => Some(Chosen::Lowest),
            (_, Some("largest" | "longest")) => Some(Chosen::Largest),
            (_, Some("any")) => Some(Chosen::Any),
            _ => None,
        }
    }
}

impl Chosen {
    /// The number among `total`, by what each measures and how high it lies.
    fn among(self, total: usize, size: impl Fn(usize) -> f64, height: impl Fn(usize) -> f64) -> usize {
        let indices = 0..total;
        match self {
            Chosen::Index(number) => (number.round() as i64).rem_euclid(total as i64) as usize,
            Chosen::Any => 0,
            Chosen::Largest => indices.max_by(|a, b| size(*a).total_cmp(&size(*b)).then(b.cmp(a))).unwrap_or(0),
            Chosen::Lowest => indices.min_by(|a, b| height(*a).total_cmp(&height(*b))).unwrap_or(0),
        }
    }
}

impl Apply for AlignScopeToGeometry {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let (face, edge) = match self.edge {
            Some(edge) => (self.face, edge),
            None => (Chosen::Largest, self.face),
        };
        let Some(mesh) = faces(shape) else { return Ok(Pieces::Changed) };
        let up = shape.scope.frame.rotation.inverse() * DVec3::Y;
        let middle = |points: &[DVec3]| points.iter().sum::<DVec3>().dot(up) / points.len() as f64;
        let outline = |index: usize| -> Vec<DVec3> {
            let face = mesh.face(index);
            face.positions(face.outline()).collect()
        };
        let face = face.among(mesh.face_count(), |i| mesh.face(i).area(), |i| middle(&outline(i)));
        let ring = outline(face);
        let ends = |i: usize| [ring[i], ring[(i + 1) % ring.len()]];
        let length = |i: usize| ends(i)[0].distance(ends(i)[1]);
        let [a, b] = ends(edge.among(ring.len(), length, |i| middle(&ends(i))));
        let normal = mesh.face(face).normal();
        let Some(x) = (b - a).reject_from(normal).try_normalize() else { return Ok(Pieces::Changed) };
        let axes = match self.up {
            Up::Y => DMat3::from_cols(x, normal, x.cross(normal)),
            Up::Z => DMat3::from_cols(x, normal.cross(x), normal),
        };
        turn(shape, axes);
        Ok(Pieces::Changed)
    }
}

impl Apply for AlignToBox {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(mesh) = faces(shape) else { return Ok(Pieces::Changed) };
        let largest = mesh.faces().max_by(|a, b| a.area().total_cmp(&b.area()));
        let Some(face) = largest else { return Ok(Pieces::Changed) };
        let (normal, (u, v)) = (face.normal(), face.axes());
        let flat: Vec<DVec2> = mesh.positions.iter().map(|p| DVec2::new(p.dot(u), p.dot(v))).collect();
        let Some(around) = OrientedBox::around(&flat) else { return Ok(Pieces::Changed) };
        let longer = u * around.axis.x + v * around.axis.y;
        let (first, second, third, is_even) = match self.axes {
            Sides::Xy => (0, 1, 2, true),
            Sides::Yz => (1, 2, 0, true),
            Sides::Zx => (2, 0, 1, true),
            Sides::Yx => (1, 0, 2, false),
            Sides::Zy => (2, 1, 0, false),
            Sides::Xz => (0, 2, 1, false),
        };
        let mut axes = DMat3::IDENTITY;
        *axes.col_mut(first) = longer;
        *axes.col_mut(second) = if is_even { normal.cross(longer) } else { longer.cross(normal) };
        *axes.col_mut(third) = normal;
        turn(shape, axes);
        Ok(Pieces::Changed)
    }
}

/// The faces of a shape that has any.
fn faces(shape: &Shape) -> Option<Mesh> {
    let mesh = if let Geometry::Element(_) = shape.geometry { None } else { shape.local_mesh() };
    mesh.filter(|mesh| mesh.face_count() > 0)
}

/// Turns the scope to axes given in its own coordinates.
fn turn(shape: &mut Shape, axes: DMat3) {
    let rotation = shape.scope.frame.rotation * DQuat::from_mat3(&axes);
    align_scope_to_axes::turn(shape, rotation.normalize());
}
