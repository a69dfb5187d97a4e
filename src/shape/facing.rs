//! Which way the faces of a shape look, how steep they are, and whether they are flat.

use crate::geometry::{Face, Mesh};
use crate::shape::{Facing, Geometry, Shape};
use glam::DVec3;

impl Shape {
    /// The area of the faces that look one way, m².
    pub fn area_towards(&self, facing: Facing) -> f64 {
        let mesh = self.surface();
        mesh.faces().filter(|face| self.takes(facing, face)).map(|face| face.area()).sum()
    }

    /// Whether a face looks that way.
    pub fn looks(&self, facing: Facing) -> bool {
        self.surface().faces().any(|face| self.takes(facing, &face))
    }

    fn takes(&self, facing: Facing, face: &Face) -> bool {
        let outline = face.outline();
        let middle = face.positions(outline).sum::<DVec3>() / outline.len().max(1) as f64;
        facing.sides & self.side(facing.space, middle, face.normal()) != 0
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
