//! `mirror` and `reverseNormals`: the other way round.

use crate::geometry::{Area, Mesh};
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Geometry, Plane, Shape};
use glam::{DAffine3, DMat3, DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// Mirrors a shape within its scope along any of the scope's axes.
    ///
    /// The scope stays where it is, and faces still look outwards; a flat shape stays as it is along its normal.
    /// ```cga
    /// Lot --> split(x) { ~1 : Half(false) | ~1 : Half(true) }
    /// Half(turned) --> [ Lawn ] shapeL(12, 5) { shape : mirror(turned, false, false) Bed | remainder : NIL }
    /// ```
    "mirror" (CityEngine, None) => pub struct Mirror {
        /// Whether left and right change places.
        x: bool,
        /// Whether bottom and top change places.
        y: bool,
        /// Whether front and back change places.
        z: bool,
    }
}

operation! {
    /// Turns the faces of a shape round: what looked up looks down, the outside of a solid becomes its inside.
    ///
    /// On a plan nothing changes; `comp(f)` finds the faces under the opposite words.
    /// ```cga
    /// Lot  --> split(x) { ~1 : Half | 2 : Gravel | ~1 : reverseNormals() Half }
    /// Half --> comp(f) { top : Lawn | bottom : Bed }
    /// ```
    "reverseNormals" (CityEngine, None) => pub struct ReverseNormals {}
}

impl Apply for Mirror {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let signs = DVec3::from([self.x, self.y, self.z].map(|mirrored| if mirrored { -1.0 } else { 1.0 }));
        let shift = (DVec3::ONE - signs) * 0.5 * shape.scope.size;
        let map = DAffine3 { matrix3: DMat3::from_diagonal(signs), translation: shift };
        shape.geometry = match &shape.geometry {
            Geometry::Flat(plane, area) => {
                let (plane, area) = flat(plane, area, signs, shift);
                Geometry::Flat(plane, area)
            }
            Geometry::Prism(plane, area, height) => {
                let (plane, area) = flat(plane, area, signs, shift);
                Geometry::Prism(plane, area, *height)
            }
            Geometry::Mesh(mesh) => Geometry::Mesh(Arc::new(mesh.transformed(&map))),
            Geometry::Path(points) => Geometry::Path(points.iter().map(|p| map.transform_point3(*p)).collect()),
            Geometry::Element(_) => {
                return Err(Problem::new("an inserted element cannot be mirrored").hint("mirror the shape before `i`"));
            }
            Geometry::Empty | Geometry::Point => return Ok(Pieces::Changed),
        };
        shape.stretched(&map);
        Ok(Pieces::Changed)
    }
}

/// A region mirrored together with its plane. On the ground and on faces only within the plane: across it the sides
/// of the box are the shape's own.
fn flat(plane: &Plane, area: &Area, signs: DVec3, shift: DVec3) -> (Plane, Area) {
    let turned = |signs: DVec2, shift: DVec2| -> Area {
        let polygons = area.polygons().iter();
        let rings = |polygon: &crate::geometry::Polygon| {
            polygon.transformed(&glam::DAffine2::from_scale_angle_translation(signs, 0.0, shift))
        };
        polygons.filter_map(rings).collect()
    };
    match plane {
        Plane::Ground => (Plane::Ground, turned(DVec2::new(signs.x, signs.z), DVec2::new(shift.x, -shift.z))),
        Plane::Face => (Plane::Face, turned(signs.truncate(), shift.truncate())),
        Plane::Free(axes) => {
            let [origin, u, v] = **axes;
            // With one or three axes mirrored the plane would look the other way.
            let sign = signs.element_product();
            let axes = [origin * signs + shift, u * signs, v * signs * sign];
            (Plane::Free(Arc::new(axes)), turned(DVec2::new(1.0, sign), DVec2::ZERO))
        }
    }
}

impl Apply for ReverseNormals {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let round = |mesh: Mesh| {
            let mut mesh = mesh;
            mesh.turn_round();
            Geometry::Mesh(Arc::new(mesh))
        };
        shape.geometry = match &shape.geometry {
            Geometry::Flat(plane, area) => {
                let (u, v) = plane.axes();
                let axes = [plane.at(DVec2::ZERO), u, -v];
                let flipped = glam::DAffine2::from_scale(DVec2::new(1.0, -1.0));
                Geometry::Flat(Plane::Free(Arc::new(axes)), area.transformed(&flipped))
            }
            Geometry::Prism(..) | Geometry::Mesh(_) => round(shape.local_mesh().unwrap_or_default()),
            other => other.clone(),
        };
        Ok(Pieces::Changed)
    }
}
