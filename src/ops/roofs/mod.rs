//! Roofs: what a roof stands on, how steep it is, and the closed solid that it becomes.
//!
//! A roof goes on every part of a flat shape, along its normal, or on the top of a prism, whose walls it keeps. Its
//! builder works upright: plan coordinates u and v of the shape's plane become x and −z, heights are y, and the eaves
//! lie at the height of the walls. Faces come in one order: the bottom, the walls by their edges, the roof.

mod planes;
mod pyramid;
mod slopes;

pub use planes::{Ridge, Shed};
pub use pyramid::{Pyramid, Taper};
pub use slopes::{Gable, Hip};

use crate::geometry::{Mesh, Polygon};
use crate::ops::spec::choice;
use crate::ops::{Pieces, Problem, fit};
use crate::shape::{Geometry, Plane, Shape};
use glam::{DAffine3, DMat3, DQuat, DVec2, DVec3};
use std::sync::Arc;

choice! {
    /// What the value of a roof says.
    pub enum By {
        /// How steep it is, in degrees.
        Angle = "byAngle",
        /// How high it rises above the eaves, in metres.
        Height = "byHeight",
    }
}

/// How steep a roof is.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Steepness {
    /// Rise by run.
    Slope(f64),
    /// Metres from the eaves to the top.
    Rise(f64),
}

impl Steepness {
    /// `None` for a flat roof, which leaves a shape as it is.
    fn of(by: By, value: f64) -> Result<Option<Steepness>, Problem> {
        match by {
            _ if value == 0.0 => Ok(None),
            By::Angle if value > 0.0 && value < 90.0 => Ok(Some(Steepness::Slope(libm::tan(value.to_radians())))),
            By::Height if value > 0.0 && value.is_finite() => Ok(Some(Steepness::Rise(value))),
            By::Angle => Err(Problem::new(format!("a roof of {value} degrees cannot be built"))
                .hint("angles lie between 0 and 90 degrees")),
            By::Height => Err(Problem::new(format!("a roof of {value} m cannot be built"))),
        }
    }

    /// Rise by run, where the roof is so wide from its eaves to its top.
    fn slope(self, run: f64) -> f64 {
        match self {
            Steepness::Slope(slope) => slope,
            Steepness::Rise(rise) => rise / run.max(f64::MIN_POSITIVE),
        }
    }
}

/// Puts a roof on every part of a shape: `build` takes a part and the height of its walls.
fn cover(
    shape: &mut Shape,
    name: &str,
    build: impl Fn(&Polygon, f64) -> Result<Mesh, Problem>,
) -> Result<Pieces, Problem> {
    let (plane, area, height) = match &shape.geometry {
        Geometry::Flat(plane, area) => (plane.clone(), area, 0.0),
        Geometry::Prism(plane, area, height) => (plane.clone(), area, *height),
        Geometry::Empty => return Ok(Pieces::Changed),
        _ => {
            let hint = format!("`comp(f) {{ top : {name}(…) }}` puts a roof on the top of a solid");
            return Err(Problem::new(format!("`{name}` takes flat shapes and prisms")).hint(hint));
        }
    };
    let mut mesh = Mesh::default();
    for part in area.polygons() {
        mesh.append(&build(part, height.abs())?);
    }
    stand(shape, &plane, height.min(0.0), &mesh);
    Ok(Pieces::left_of(shape))
}

/// Makes an upright mesh over a plane of the shape its geometry. Its y becomes the plane's normal; x stays as near as
/// it can.
fn stand(shape: &mut Shape, plane: &Plane, foot: f64, mesh: &Mesh) {
    let (normal, (u, v)) = (plane.normal(), plane.axes());
    let x = DVec3::X.reject_from_normalized(normal).try_normalize().unwrap_or(u);
    let turn = DMat3::from_cols(x, normal, x.cross(normal));
    let onto = DAffine3::from_mat3_translation(DMat3::from_cols(u, normal, -v), plane.at(DVec2::ZERO) + normal * foot);
    let upright = DAffine3::from_mat3(turn.transpose()) * onto;
    if *plane != Plane::Ground {
        shape.scope.frame = shape.scope.frame.turned(DQuat::from_mat3(&turn));
    }
    let geometry = match mesh.faces.is_empty() {
        true => Geometry::Empty,
        false => Geometry::Mesh(Arc::new(mesh.transformed(&upright))),
    };
    fit::refit(shape, geometry);
}

/// A closed solid: a bottom, walls where they have a height, and faces above. Nodes are on the plan with heights as z,
/// the corners of the polygon first; faces run counter-clockwise seen from above.
fn solid(polygon: &Polygon, nodes: &[DVec3], faces: &[Vec<u32>], walls: f64) -> Mesh {
    let upright = |p: DVec3, lift: f64| DVec3::new(p.x, p.z + lift, -p.y);
    let mut mesh = Mesh::default();
    let corners = polygon.points().len() as u32;
    let mut above = 0;
    if walls > 0.0 {
        above = corners;
        mesh.positions.extend(nodes[..corners as usize].iter().map(|p| upright(*p, 0.0)));
    }
    mesh.positions.extend(nodes.iter().map(|p| upright(*p, walls)));
    let rings = rings(polygon);
    mesh.push_face(rings.iter().map(|ring| ring.iter().rev().copied().collect::<Vec<_>>()));
    if walls > 0.0 {
        for ring in &rings {
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                mesh.push_face([[*a, *b, b + above, a + above]]);
            }
        }
    }
    for face in faces {
        mesh.push_face([face.iter().map(|node| node + above).collect::<Vec<_>>()]);
    }
    mesh
}

/// The indices of each ring's corners.
fn rings(polygon: &Polygon) -> Vec<Vec<u32>> {
    let mut next = 0;
    let indices = |ring: &[DVec2]| {
        let ring = next..next + ring.len() as u32;
        next = ring.end;
        ring.collect()
    };
    polygon.rings().map(indices).collect()
}
