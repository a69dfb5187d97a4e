//! `deleteHoles`: fills the holes of faces.

use crate::geometry::{self, Area, Mesh, Polygon};
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Geometry, Shape};
use std::sync::Arc;

operation! {
    /// Fills the holes of every face.
    ///
    /// What stands in a hole of a flat shape is swallowed. The walls of a solid's holes stay, so a prism loses its shafts
    /// wholly and another solid is open there.
    /// ```cga
    /// Lot --> split(x) { ~1 : offset(-5, border) Bed | 2 : Gravel | ~1 : offset(-5, border) deleteHoles() Bed }
    /// ```
    "deleteHoles" (CityEngine, None) => pub struct DeleteHoles {}
}

impl Apply for DeleteHoles {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        shape.geometry = match &shape.geometry {
            Geometry::Flat(plane, area) => Geometry::Flat(plane.clone(), filled(area)),
            Geometry::Prism(plane, area, height) => Geometry::Prism(plane.clone(), filled(area), *height),
            Geometry::Mesh(mesh) => {
                let mut whole = Mesh { positions: mesh.positions.clone(), ..Mesh::default() };
                mesh.faces().for_each(|face| whole.push_face([face.outline()]));
                Geometry::Mesh(Arc::new(whole))
            }
            other => other.clone(),
        };
        Ok(Pieces::Changed)
    }
}

/// The outlines; those within others merge with them.
fn filled(area: &Area) -> Area {
    let outlines: Vec<Area> =
        area.polygons().iter().map(|polygon| Polygon::from_ring(polygon.outer()).into()).collect();
    let held = area.polygons().len() > 1 && area.polygons().iter().any(Polygon::has_holes);
    if held { geometry::union_all(&outlines) } else { outlines.into_iter().flat_map(Area::into_polygons).collect() }
}
