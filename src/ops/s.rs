//! `s`: sets the size of a scope; the geometry follows.

use crate::geometry::Area;
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, t};
use crate::shape::{Geometry, Plane, Shape};
use crate::value::Size;
use glam::{DAffine2, DAffine3, DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// Sets the size of the scope; the geometry is stretched with it. A point gets the box around nothing.
    ///
    /// The papers write `S(x, y, z)`.
    /// ```cga
    /// Lot --> [ Lawn ] [ s('0.5, 0, '1) Bed ] s('0.25, 0, '0.5) Gravel
    /// ```
    "s" (CityEngine, None) => pub struct Resize {
        /// Along x: metres, or with `'` a share of the scope.
        x: Size,
        /// Along y: metres, or with `'` a share of the scope.
        y: Size,
        /// Along z: metres, or with `'` a share of the scope.
        z: Size,
    }
}

impl Apply for Resize {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let old = shape.scope.size;
        let new = t::lengths([self.x, self.y, self.z], old)?;
        let factor = DVec3::select(old.cmpgt(DVec3::splat(1e-12)), new / old, DVec3::ONE);
        let old = std::mem::replace(&mut shape.geometry, Geometry::Empty);
        shape.geometry = match old {
            Geometry::Flat(..) | Geometry::Path(_) | Geometry::Prism(..) | Geometry::Mesh(_) if new == DVec3::ZERO => {
                Geometry::Point
            }
            old => stretched(old, factor),
        };
        shape.scope.size = new;
        shape.stretched(&DAffine3::from_scale(factor));
        Ok(Pieces::Changed)
    }
}

/// The geometry stretched along the scope's axes; what is flattened to nothing becomes empty.
fn stretched(geometry: Geometry, factor: DVec3) -> Geometry {
    if factor == DVec3::ONE {
        return geometry;
    }
    match geometry {
        Geometry::Empty | Geometry::Point | Geometry::Element(_) => geometry,
        Geometry::Path(points) => Geometry::Path(points.iter().map(|p| *p * factor).collect()),
        Geometry::Flat(plane, area) => match flat(&plane, &area, factor) {
            Some((plane, area)) => Geometry::Flat(plane, area),
            None => Geometry::Empty,
        },
        Geometry::Prism(plane, area, height) => prism(plane, area, height, factor),
        Geometry::Mesh(mesh) => Geometry::Mesh(Arc::new(mesh.transformed(&DAffine3::from_scale(factor)))),
    }
}

fn flat(plane: &Plane, area: &Area, factor: DVec3) -> Option<(Plane, Area)> {
    let (u, v) = plane.axes();
    let (su, sv) = (u * factor, v * factor);
    let x = su.try_normalize()?;
    let normal = su.cross(sv).try_normalize()?;
    let y = normal.cross(x);
    let map = DAffine2::from_cols(DVec2::new(su.dot(x), su.dot(y)), DVec2::new(sv.dot(x), sv.dot(y)), DVec2::ZERO);
    let area = area.transformed(&map);
    let plane = match plane {
        Plane::Ground | Plane::Face if factor.min_element() > 0.0 => plane.clone(),
        _ => Plane::Free(Arc::new([plane.at(DVec2::ZERO) * factor, x, y])),
    };
    (!area.is_empty()).then_some((plane, area))
}

fn prism(plane: Plane, area: Area, height: f64, factor: DVec3) -> Geometry {
    let sweep = plane.normal() * height * factor;
    let Some((flat_plane, flat_area)) = flat(&plane, &area, factor) else { return Geometry::Empty };
    let along = sweep.dot(flat_plane.normal());
    let straight = (sweep - flat_plane.normal() * along).length() < 1e-9 * sweep.length();
    match straight && along.abs() > 1e-12 {
        true => Geometry::Prism(flat_plane, flat_area, along),
        false if sweep.length() < 1e-12 => Geometry::Flat(flat_plane, flat_area),
        false => {
            let (low, high) = (height.min(0.0), height.max(0.0));
            let normal = plane.normal();
            let mesh = crate::geometry::Mesh::prism(&area, low, high, |p, h| (plane.at(p) + normal * h) * factor);
            Geometry::Mesh(Arc::new(mesh))
        }
    }
}
