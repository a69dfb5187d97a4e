//! Primitives: a plain form that fills the scope, for proxies and studies.

use crate::geometry::{Area, Mesh, Polygon};
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Geometry, Plane, Shape};
use crate::unit::Metres;
use glam::{DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// A rectangle on the ground of the scope; negative sizes reach the other way.
    /// ```cga
    /// Lot  --> [ Lawn ] split(x) { { ~8 : Slab }* }
    /// Slab --> primitiveQuad(4, 12) center(xz) Paving
    /// ```
    "primitiveQuad" (CityEngine, None) => pub struct Quad {
        /// Along x (metres); 0 fills the scope.
        width: Metres = Metres(0.0) => "0",
        /// Along z (metres); 0 fills the scope.
        depth: Metres = Metres(0.0) => "0",
    }
}

operation! {
    /// A disk on the ground of the scope.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { ~1 : Basin(48) | ~1 : Basin(8) | ~1 : Basin(5) }
    /// Basin(sides) --> s(10, 0, 10) center(xz) primitiveDisk(sides) Water
    /// ```
    "primitiveDisk" (CityEngine, None) => pub struct Disk {
        /// How many corners stand for the circle.
        vertices: u32 = 32 => "32",
        /// Radius (metres); 0 fills the scope.
        radius: Metres = Metres(0.0) => "0",
    }
}

operation! {
    /// A box that fills the scope; negative sizes reach the other way.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { { ~10 : s(5, 1, 5) center(xz) primitiveCube() Stone }* }
    /// ```
    "primitiveCube" (CityEngine, None) => pub struct Cube {
        /// Along x (metres); 0 fills the scope.
        width: Metres = Metres(0.0) => "0",
        /// Along y (metres); 0 fills the scope.
        height: Metres = Metres(0.0) => "0",
        /// Along z (metres); 0 fills the scope.
        depth: Metres = Metres(0.0) => "0",
    }
}

operation! {
    /// An upright cylinder that fills the scope.
    /// ```cga
    /// Lot --> [ Gravel ] split(x) { { ~10 : s(6, 1, 6) center(xz) primitiveCylinder(24) Bed }* }
    /// ```
    "primitiveCylinder" (CityEngine, None) => pub struct Cylinder {
        /// How many corners stand for the circle.
        sides: u32 = 16 => "16",
        /// Radius (metres); 0 fills the scope.
        radius: Metres = Metres(0.0) => "0",
        /// Height (metres); 0 fills the scope.
        height: Metres = Metres(0.0) => "0",
    }
}

operation! {
    /// An upright cone that fills the scope.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { { ~10 : s(5, 6, 5) center(xz) primitiveCone(24) Topiary }* }
    /// ```
    "primitiveCone" (CityEngine, None) => pub struct Cone {
        /// How many corners stand for the circle.
        sides: u32 = 16 => "16",
        /// Radius (metres); 0 fills the scope.
        radius: Metres = Metres(0.0) => "0",
        /// Height (metres); 0 fills the scope.
        height: Metres = Metres(0.0) => "0",
    }
}

operation! {
    /// A ball that fills the scope.
    /// ```cga
    /// Lot --> [ Gravel ] split(x) { { ~10 : s(6, 6, 6) center(xz) primitiveSphere(24, 12) Topiary }* }
    /// ```
    "primitiveSphere" (CityEngine, None) => pub struct Sphere {
        /// Corners around.
        sides: u32 = 16 => "16",
        /// Bands from bottom to top.
        bands: u32 = 8 => "8",
        /// Radius (metres); 0 fills the scope.
        radius: Metres = Metres(0.0) => "0",
    }
}

/// Corners or bands beyond this do not show.
const MOST_SIDES: u32 = 1024;

impl Apply for Quad {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let size = signed(shape, [self.width.0, 0.0, self.depth.0])?;
        let polygon = Polygon::rectangle(DVec2::new(0.0, -size.z), DVec2::new(size.x, 0.0));
        fit::refit(shape, on_ground(polygon, 0.0));
        Ok(Pieces::Changed)
    }
}

impl Apply for Disk {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let size = sized(shape, [2.0 * self.radius.0, 0.0, 2.0 * self.radius.0])?;
        let round = Polygon::regular(DVec2::ZERO, 0.5, corners(self.vertices));
        let stretch = |p: DVec2| DVec2::new((p.x + 0.5) * size.x, (p.y - 0.5) * size.z);
        let polygon = round.filter(|_| size.x > 0.0 && size.z > 0.0).map(|round| round.mapped(stretch));
        fit::refit(shape, on_ground(polygon, 0.0));
        Ok(Pieces::Changed)
    }
}

impl Apply for Cube {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let size = signed(shape, [self.width.0, self.height.0, self.depth.0])?;
        let polygon = Polygon::rectangle(DVec2::new(0.0, -size.z), DVec2::new(size.x, 0.0));
        fit::refit(shape, on_ground(polygon, size.y));
        Ok(Pieces::Changed)
    }
}

impl Apply for Cylinder {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let size = sized(shape, [2.0 * self.radius.0, self.height.0, 2.0 * self.radius.0])?;
        fit::refit(shape, solid(Mesh::cylinder(size, corners(self.sides))));
        Ok(Pieces::Changed)
    }
}

impl Apply for Cone {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let size = sized(shape, [2.0 * self.radius.0, self.height.0, 2.0 * self.radius.0])?;
        fit::refit(shape, solid(Mesh::cone(size, corners(self.sides))));
        Ok(Pieces::Changed)
    }
}

impl Apply for Sphere {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let size = sized(shape, [2.0 * self.radius.0; 3])?;
        let bands = self.bands.clamp(2, MOST_SIDES) as usize;
        fit::refit(shape, solid(Mesh::sphere(size, corners(self.sides), bands)));
        Ok(Pieces::Changed)
    }
}

fn corners(count: u32) -> usize {
    count.clamp(3, MOST_SIDES) as usize
}

/// The given size where it is not 0, else the scope's.
fn sized(shape: &Shape, given: [f64; 3]) -> Result<DVec3, Problem> {
    if given.iter().any(|x| !x.is_finite() || *x < 0.0) {
        return Err(Problem::new(format!("a size of {} m cannot be made", given.into_iter().fold(0.0, f64::min))));
    }
    let given = DVec3::from(given);
    Ok(DVec3::select(given.cmpgt(DVec3::ZERO), given, shape.scope.size))
}

/// The same, where a negative size reaches the other way.
fn signed(shape: &Shape, given: [f64; 3]) -> Result<DVec3, Problem> {
    let size = sized(shape, given.map(f64::abs))?;
    Ok(DVec3::select(DVec3::from(given).cmplt(DVec3::ZERO), -size, size))
}

/// The polygon on the ground, with a height where it has one; empty where there is no polygon.
fn on_ground(polygon: Option<Polygon>, height: f64) -> Geometry {
    match polygon.map(Area::from) {
        Some(area) if height != 0.0 => Geometry::Prism(Plane::Ground, area, height),
        Some(area) => Geometry::Flat(Plane::Ground, area),
        None => Geometry::Empty,
    }
}

/// The mesh as geometry; empty where it has no faces.
fn solid(mesh: Mesh) -> Geometry {
    if mesh.faces.is_empty() { Geometry::Empty } else { Geometry::Mesh(Arc::new(mesh)) }
}
