//! `extrude`: gives a flat shape height, an edge a wall.

use crate::geometry::Mesh;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, fit, tag};
use crate::shape::{Geometry, Plane, Shape};
use crate::unit::Metres;
use glam::DVec3;
use std::sync::Arc;

operation! {
    /// Sweeps a flat shape along its normal, or straight up, into a solid; an edge becomes an upright face.
    ///
    /// Its faces are tagged `extrude.top`, `extrude.bottom` and `extrude.side` where rules ask for tags. The scope grows with it. A negative height sweeps the other way; 0 leaves the shape as it is.
    /// ```cga
    /// Lot    --> setback(3) { front : NIL | all = Clip | remainder : Lawn }
    /// Clip   --> set(material.name, "hedge") extrude(1.8) Yew.
    /// ```
    "extrude" (CityEngine, None) => pub struct Extrude {
        /// Which way.
        direction: Direction = Direction::Normal => "face.normal",
        /// How far (metres).
        height: Metres,
    }
}

choice! {
    /// Which way to sweep.
    pub enum Direction {
        /// Along the face's normal.
        Normal = "face.normal",
        /// The same: flat shapes have one normal.
        Vertices = "vertex.normal",
        /// Straight up.
        Up = "world.up",
        /// Straight up: flat shapes have flat tops.
        UpFlat = "world.up.flatTop",
        /// Straight up, as older rules write it.
        Y = "world.y",
    }
}

impl Apply for Extrude {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let height = self.height.0;
        if !height.is_finite() {
            return Err(Problem::new(format!("an extrusion of {height} m cannot be done")));
        }
        if height == 0.0 {
            return Ok(Pieces::Changed);
        }
        let up = shape.scope.frame.rotation.inverse() * DVec3::Y;
        let geometry = match std::mem::replace(&mut shape.geometry, Geometry::Empty) {
            Geometry::Flat(plane, area) => match self.sweep(&plane, up) {
                Some(sign) => Geometry::Prism(plane, area, height * sign),
                None => Geometry::Mesh(Arc::new(Mesh::prism(&area, 0.0, height, |p, h| plane.at(p) + up * h))),
            },
            Geometry::Path(points) => Geometry::Mesh(Arc::new(wall(&points, up * height))),
            Geometry::Empty => return Ok(Pieces::Changed),
            _ => {
                return Err(
                    Problem::new("`extrude` takes flat shapes and edges").hint("`comp(f)` takes a face of a solid")
                );
            }
        };
        fit::refit(shape, geometry);
        if given.tags {
            tag::extruded(shape, height.signum());
        }
        Ok(Pieces::Changed)
    }
}

impl Extrude {
    /// 1 where the sweep runs along the plane's normal, -1 where it runs against it; nothing where it runs askew.
    fn sweep(&self, plane: &Plane, up: DVec3) -> Option<f64> {
        if matches!(self.direction, Direction::Normal | Direction::Vertices) {
            return Some(1.0);
        }
        let along = plane.normal().dot(up);
        (along.abs() > 1.0 - 1e-9).then_some(along.signum())
    }
}

/// Upright faces along a line.
fn wall(points: &[DVec3], sweep: DVec3) -> Mesh {
    let mut mesh = Mesh::default();
    for pair in points.windows(2) {
        let first = mesh.positions.len() as u32;
        mesh.positions.extend([pair[0], pair[1], pair[1] + sweep, pair[0] + sweep]);
        mesh.push_face([[first, first + 1, first + 2, first + 3]]);
    }
    mesh
}
