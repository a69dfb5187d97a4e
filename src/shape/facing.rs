//! Which way the faces of a shape look, how steep they are, and whether they are flat.
//!
//! A face looks along the axis that its normal points along most: of the scope, of the object (the lot as it was at
//! first), or of the world, whose south is what `front` is elsewhere.

use crate::geometry::Mesh;
use crate::shape::{Geometry, Shape};
use glam::DVec3;

/// A direction for faces to look in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Facing {
    space: Space,
    /// The axis, twice, and one more for its far side; none for `side`: all level ones.
    side: Option<usize>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Space {
    Scope,
    Object,
    World,
}

const SIDES: [&str; 6] = ["right", "left", "top", "bottom", "front", "back"];
const COMPASS: [&str; 6] = ["east", "west", "up", "down", "south", "north"];

impl Facing {
    /// The words for it: `front`, `object.left`, `world.north`. None where it is no such word.
    pub fn of_word(word: &str) -> Option<Facing> {
        let (space, name) = match word.split_once('.') {
            None => (Space::Scope, word),
            // Without street edges `street.…` means the object's sides.
            Some(("object" | "street", name)) => (Space::Object, name),
            Some(("world", name)) => (Space::World, name),
            Some(_) => return None,
        };
        let names = if space == Space::World { COMPASS } else { SIDES };
        let side = names.iter().position(|side| *side == name);
        (side.is_some() || name == "side").then_some(Facing { space, side })
    }

    fn takes(self, normal: DVec3, shape: &Shape) -> bool {
        let world = || shape.scope.frame.rotation * normal;
        let direction = match self.space {
            Space::Scope => normal,
            Space::Object => shape.style.object.inverse() * world(),
            Space::World => world(),
        };
        let looks = side(direction);
        self.side.map_or(looks / 2 != 1, |wanted| wanted == looks)
    }
}

/// The axis along which a direction points most, twice, and one more where against it.
fn side(direction: DVec3) -> usize {
    let size = direction.abs();
    let axis = if size.y >= size.x && size.y >= size.z {
        1
    } else if size.z >= size.x {
        2
    } else {
        0
    };
    2 * axis + usize::from(direction[axis] < 0.0)
}

impl Shape {
    /// The area of the faces that look one way, m².
    pub fn area_towards(&self, facing: Facing) -> f64 {
        let mesh = self.surface();
        mesh.faces().filter(|face| facing.takes(face.normal(), self)).map(|face| face.area()).sum()
    }

    /// Whether a face looks that way.
    pub fn looks(&self, facing: Facing) -> bool {
        self.surface().faces().any(|face| facing.takes(face.normal(), self))
    }

    /// The steepest of its faces, or of its pieces where it is a line: degrees from level, and the way that it falls,
    /// degrees clockwise from north. Level ones fall to the north; points and nothing are level.
    pub fn steepest(&self) -> (f64, f64) {
        let turn = self.scope.frame.rotation;
        let found: Vec<(f64, DVec3)> = match &self.geometry {
            Geometry::Path(points) => {
                let pieces = points.windows(2).map(|ends| turn * (ends[1] - ends[0]).normalize_or_zero());
                pieces.map(|d| (libm::asin(d.y.abs().min(1.0)), d * -d.y.signum())).collect()
            }
            _ => {
                let mesh = self.surface();
                let normals = mesh.faces().map(|face| turn * face.normal());
                normals.map(|n| (libm::acos(n.y.abs().min(1.0)), if n.y < 0.0 { -n } else { n })).collect()
            }
        };
        let steeper = |a: (f64, DVec3), b: (f64, DVec3)| if b.0 > a.0 + 1e-9 { b } else { a };
        let (slope, falls) = found.into_iter().reduce(steeper).unwrap_or((0.0, DVec3::ZERO));
        let north = libm::atan2(falls.x, -falls.z).to_degrees();
        let is_level = DVec3::new(falls.x, 0.0, falls.z).length() < 1e-9;
        let azimuth = if north < 0.0 { north + 360.0 } else { north };
        (slope.to_degrees(), if is_level || azimuth >= 360.0 { 0.0 } else { azimuth })
    }

    /// Whether it has faces, and at each of their corners the normal is that of the face within a tolerance in degrees.
    pub fn is_planar(&self, tolerance: f64) -> bool {
        if let Geometry::Flat(..) | Geometry::Prism(..) | Geometry::Element(_) = &self.geometry {
            return true;
        }
        let mesh = self.surface();
        let limit = libm::cos(tolerance.clamp(0.0, 180.0).to_radians()) - 1e-12;
        let flat = |ring: &[u32], normal: DVec3| {
            let corners = (0..ring.len()).map(|i| {
                let at = |step: usize| mesh.positions[ring[(i + step) % ring.len()] as usize];
                (at(1) - at(0)).cross(at(2) - at(1)).normalize_or_zero()
            });
            // Corners that turn the other way have the normal reversed; straight ones have none.
            corners.into_iter().all(|corner| corner == DVec3::ZERO || corner.dot(normal).abs() >= limit)
        };
        mesh.face_count() > 0 && mesh.faces().all(|face| face.rings().all(|ring| flat(ring, face.normal())))
    }

    /// Its faces in the scope's coordinates; those of the scope where an element fills it.
    fn surface(&self) -> Mesh {
        match &self.geometry {
            Geometry::Element(_) => Mesh::cuboid(self.scope.size),
            _ => self.local_mesh().unwrap_or_default(),
        }
    }
}
