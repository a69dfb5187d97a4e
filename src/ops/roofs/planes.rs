//! `roofShed` and `roofRidge`: one plane over the whole outline, or two that meet in a ridge.
//!
//! Both are the walls prolonged upwards and cut by the planes, so that any outline with any holes gets its roof.

use crate::geometry::{Mesh, Polygon};
use crate::ops::declare::operation;
use crate::ops::roofs::{By, Steepness, cover};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Geometry, Plane, Shape};
use glam::{DVec2, DVec3};

operation! {
    /// A shed roof: one plane that rises from an edge.
    ///
    /// Where the outline reaches behind that edge, the plane begins at its farthest corner there.
    /// ```cga
    /// Lot   --> split(z) { 8 : Store | ~1 : Lawn }
    /// Store --> set(material.name, "roof") extrude(3) roofShed(8, 2) Roof.
    /// ```
    "roofShed" (CityEngine, None) => pub struct Shed {
        /// What the value says.
        kind: By = By::Angle => "byAngle",
        /// The slope (degrees), or with `byHeight` the height of its upper end (metres).
        value: f64,
        /// The edge from which it rises, from 0; negative ones count from the end.
        index: f64 = 0.0 => "0",
    }
}

operation! {
    /// A roof of two planes that meet in one ridge along the scope's x, whatever the outline.
    ///
    /// The ridge lies in the middle of the shape's depth. Where the outline is not a rectangle, the eaves rise and
    /// fall with it.
    /// ```cga
    /// Lot  --> [ Lawn ] s(30, 0, 16) center(xz) Barn
    /// Barn --> set(material.name, "roof") extrude(3) roofRidge(byHeight, 3) Roof.
    /// ```
    "roofRidge" (CityEngine, None) => pub struct Ridge {
        /// What the value says.
        kind: By = By::Angle => "byAngle",
        /// The slope (degrees), or with `byHeight` the height of the ridge (metres).
        value: f64,
    }
}

impl Apply for Shed {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(steepness) = Steepness::of(self.kind, self.value)? else { return Ok(Pieces::Changed) };
        if !self.index.is_finite() {
            return Err(Problem::new(format!("there is no edge {}", self.index)));
        }
        cover(shape, "roofShed", |part, walls| {
            let edge = self.index.round().rem_euclid(part.points().len() as f64) as usize;
            let along = part.edges().nth(edge).map_or(DVec2::X, |(a, b)| (b - a).normalize_or(DVec2::X));
            let (low, high) = extent(part, along.perp());
            let slope = steepness.slope(high - low);
            let walled = walled(part, walls + (high - low) * slope);
            Ok(below(&walled, along.perp(), slope, walls - low * slope))
        })
    }
}

impl Apply for Ridge {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(steepness) = Steepness::of(self.kind, self.value)? else { return Ok(Pieces::Changed) };
        let across = match &shape.geometry {
            Geometry::Flat(plane, _) | Geometry::Prism(plane, ..) => along_x(plane).perp(),
            _ => DVec2::Y,
        };
        cover(shape, "roofRidge", |part, walls| {
            let (low, high) = extent(part, across);
            let slope = steepness.slope((high - low) * 0.5);
            let walled = walled(part, walls + (high - low) * 0.5 * slope);
            let one = below(&walled, across, slope, walls - low * slope);
            Ok(below(&one, -across, slope, walls + high * slope))
        })
    }
}

/// The scope's x on a plane; the plane's own u where x stands upright on it.
fn along_x(plane: &Plane) -> DVec2 {
    let (u, v) = plane.axes();
    DVec2::new(DVec3::X.dot(u), DVec3::X.dot(v)).try_normalize().unwrap_or(DVec2::X)
}

fn walled(part: &Polygon, height: f64) -> Mesh {
    Mesh::prism(&part.clone().into(), 0.0, height, |p, height| DVec3::new(p.x, height, -p.y))
}

/// The least and the greatest of the corners' distances along a direction.
fn extent(part: &Polygon, along: DVec2) -> (f64, f64) {
    let distances = part.points().iter().map(|p| p.dot(along));
    distances.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), d| (low.min(d), high.max(d)))
}

/// What lies below a plane that rises along a direction of the plan, and has a height above the origin.
fn below(mesh: &Mesh, along: DVec2, slope: f64, height: f64) -> Mesh {
    let length = libm::sqrt(1.0 + slope * slope);
    let normal = DVec3::new(-slope * along.x, 1.0, slope * along.y) / length;
    mesh.cut(normal, f64::NEG_INFINITY, height / length)
}
