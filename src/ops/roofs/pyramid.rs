//! `roofPyramid` and `taper`: a triangle from every edge to one tip.

use crate::geometry::{Mesh, Polygon};
use crate::ops::declare::operation;
use crate::ops::roofs::{By, Steepness, cover, solid};
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::unit::Metres;
use glam::DVec2;

operation! {
    /// A pyramid roof: a triangle from every edge to the mean of the corners.
    ///
    /// An angle holds for the first edge; on outlines that are not regular the others are steeper or flatter. From the
    /// tip every edge must be seen: for other outlines there is `roofHip`.
    /// ```cga
    /// Lot      --> [ Lawn ] s(16, 0, 16) center(xz) primitiveDisk(8) Pavilion
    /// Pavilion --> set(material.name, "roof") extrude(3) roofPyramid(30) Roof.
    /// ```
    "roofPyramid" (CityEngine, None) => pub struct Pyramid {
        /// What the value says.
        kind: By = By::Angle => "byAngle",
        /// The slope over the first edge (degrees), or with `byHeight` the height of the tip (metres).
        value: f64,
    }
}

operation! {
    /// Tapers a flat shape to a tip over its centre of gravity; a negative height tapers downwards.
    ///
    /// On a prism the tip stands on its top. From the tip every edge must be seen.
    /// ```cga
    /// Lot   --> [ Gravel ] s(14, 0, 14) center(xz) primitiveDisk(12) Spire
    /// Spire --> set(material.name, "roof") taper(20) Roof.
    /// ```
    "taper" (CityEngine, None) => pub struct Taper {
        /// How high the tip stands (metres).
        height: Metres,
    }
}

impl Apply for Pyramid {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(steepness) = Steepness::of(self.kind, self.value)? else { return Ok(Pieces::Changed) };
        cover(shape, "roofPyramid", |part, walls| {
            let corners = part.outer();
            let tip = corners.iter().sum::<DVec2>() / corners.len() as f64;
            let run = part.edges().next().map_or(0.0, |edge| depth(tip, edge));
            tipped(part, "roofPyramid", (tip, steepness.slope(run) * run), walls)
        })
    }
}

impl Apply for Taper {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let height = self.height.0;
        if !height.is_finite() {
            return Err(Problem::new(format!("a tip {height} m high cannot be built")));
        }
        if height == 0.0 {
            return Ok(Pieces::Changed);
        }
        cover(shape, "taper", |part, walls| tipped(part, "taper", (part.centroid(), height), walls))
    }
}

/// How far a point lies inside of an edge; negative outside.
fn depth(point: DVec2, (a, b): (DVec2, DVec2)) -> f64 {
    (b - a).normalize_or_zero().perp_dot(point - a)
}

/// Triangles from every edge to a tip.
fn tipped(part: &Polygon, name: &str, (tip, height): (DVec2, f64), walls: f64) -> Result<Mesh, Problem> {
    let hint = "`roofHip` roofs any outline";
    if part.has_holes() {
        return Err(Problem::new(format!("`{name}` takes outlines without holes")).hint(hint));
    }
    if part.edges().any(|edge| depth(tip, edge) <= 0.0) {
        return Err(Problem::new(format!("the tip of `{name}` does not see every edge of the outline")).hint(hint));
    }
    if walls + height <= 0.0 && walls > 0.0 {
        return Err(Problem::new(format!("a tip {height} m high reaches through the bottom of the prism")));
    }
    let count = part.points().len() as u32;
    let nodes: Vec<_> = part.points().iter().map(|p| p.extend(0.0)).chain([tip.extend(height)]).collect();
    let faces: Vec<Vec<u32>> = (0..count).map(|a| vec![a, (a + 1) % count, count]).collect();
    let mut mesh = solid(part, &nodes, &faces, walls);
    if walls + height < 0.0 {
        mesh.turn_round();
    }
    Ok(mesh)
}
