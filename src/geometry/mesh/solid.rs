//! Building meshes: sweeps of planar regions and the simple solids.
//!
//! The solids stand on the ground of a y-up frame and fill the box from the origin to their size.

use crate::geometry::{Area, Mesh, Polygon};
use glam::{DVec2, DVec3};

impl Mesh {
    /// The faces of a region, one a part, mapped into space. The map must be affine and keep orientation.
    pub fn flat(area: &Area, map: impl Fn(DVec2) -> DVec3) -> Mesh {
        let mut mesh = Mesh::default();
        for part in area.polygons() {
            let first = mesh.positions.len() as u32;
            mesh.positions.extend(part.points().iter().map(|p| map(*p)));
            mesh.push_face(ring_indices(part, first));
        }
        mesh
    }

    /// A region swept from one height to another: a closed mesh, one solid a part; empty where the heights are equal.
    ///
    /// `map` takes a point of the region and a height into space; it must be affine. Faces look outwards whatever
    /// the orientation of the map and the order of the heights.
    pub fn prism(area: &Area, base: f64, top: f64, map: impl Fn(DVec2, f64) -> DVec3) -> Mesh {
        let mut mesh = Mesh::default();
        if base == top {
            return mesh;
        }
        for part in area.polygons() {
            let (low, count) = (mesh.positions.len() as u32, part.points().len() as u32);
            mesh.positions.extend(part.points().iter().map(|p| map(*p, base)));
            mesh.positions.extend(part.points().iter().map(|p| map(*p, top)));
            let rings = ring_indices(part, low);
            mesh.push_face(rings.iter().map(|r| r.iter().rev().copied().collect::<Vec<_>>()));
            mesh.push_face(rings.iter().map(|r| r.iter().map(|v| v + count).collect::<Vec<_>>()));
            for ring in &rings {
                for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                    mesh.push_face([[*a, *b, b + count, a + count]]);
                }
            }
        }
        if mesh.volume() < 0.0 {
            mesh.turn_round();
        }
        mesh
    }

    /// A box; empty where a side is not positive.
    pub fn cuboid(size: DVec3) -> Mesh {
        let square = Polygon::rectangle(DVec2::ZERO, DVec2::ONE);
        Mesh::upright(square, size)
    }

    /// An upright cylinder with at least three sides.
    pub fn cylinder(size: DVec3, sides: usize) -> Mesh {
        Mesh::upright(round(sides), size)
    }

    /// An upright cone, or pyramid, with at least three sides.
    pub fn cone(size: DVec3, sides: usize) -> Mesh {
        let Some(base) = round(sides).filter(|_| size.min_element() > 0.0) else { return Mesh::default() };
        let ground = |p: &DVec2| DVec3::new(p.x, 0.0, 1.0 - p.y) * size;
        let mut mesh = Mesh { positions: base.points().iter().map(ground).collect(), ..Mesh::default() };
        let tip = mesh.positions.len() as u32;
        mesh.positions.push(DVec3::new(0.5, 1.0, 0.5) * size);
        mesh.push_face([(0..tip).rev().collect::<Vec<_>>()]);
        (0..tip).for_each(|a| mesh.push_face([[a, (a + 1) % tip, tip]]));
        mesh
    }

    /// An ellipsoid of at least three meridians and two bands.
    pub fn sphere(size: DVec3, sides: usize, bands: usize) -> Mesh {
        let (sides, bands) = (sides.clamp(3, 4096), bands.clamp(2, 4096));
        let Some(circle) = round(sides).filter(|_| size.min_element() > 0.0) else { return Mesh::default() };
        let mut mesh = Mesh::default();
        for band in 1..bands {
            let (sin, cos) = libm::sincos(std::f64::consts::PI * band as f64 / bands as f64);
            let level = |p: &DVec2| {
                let p = (*p - 0.5) * sin + 0.5;
                DVec3::new(p.x, 0.5 - 0.5 * cos, 1.0 - p.y) * size
            };
            mesh.positions.extend(circle.points().iter().map(level));
        }
        let (n, south, north) = (sides as u32, mesh.positions.len() as u32, mesh.positions.len() as u32 + 1);
        mesh.positions.extend([DVec3::new(0.5, 0.0, 0.5) * size, DVec3::new(0.5, 1.0, 0.5) * size]);
        for a in 0..n {
            let b = (a + 1) % n;
            mesh.push_face([[b, a, south]]);
            for low in (0..bands as u32 - 2).map(|band| band * n) {
                mesh.push_face([[low + a, low + b, low + n + b, low + n + a]]);
            }
            mesh.push_face([[south - n + a, south - n + b, north]]);
        }
        mesh
    }

    /// A flat disk on the ground, facing up, with at least three sides.
    pub fn disk(size: DVec2, sides: usize) -> Mesh {
        Mesh::lying(round(sides), size)
    }

    /// A rectangle on the ground, facing up.
    pub fn quad(size: DVec2) -> Mesh {
        Mesh::lying(Polygon::rectangle(DVec2::ZERO, DVec2::ONE), size)
    }

    /// A figure of the unit square as the base of a prism.
    fn upright(base: Option<Polygon>, size: DVec3) -> Mesh {
        let area: Area = base.into_iter().filter(|_| size.min_element() > 0.0).collect();
        Mesh::prism(&area, 0.0, size.y, |p, height| DVec3::new(p.x * size.x, height, (1.0 - p.y) * size.z))
    }

    /// A figure of the unit square on the ground.
    fn lying(base: Option<Polygon>, size: DVec2) -> Mesh {
        let area: Area = base.into_iter().filter(|_| size.min_element() > 0.0).collect();
        Mesh::flat(&area, |p| DVec3::new(p.x * size.x, 0.0, (1.0 - p.y) * size.y))
    }
}

/// A regular polygon on the circle in the unit square.
fn round(sides: usize) -> Option<Polygon> {
    Polygon::regular(DVec2::splat(0.5), 0.5, sides.clamp(3, 4096))
}

/// The vertex indices of each ring where the first vertex has the index `first`.
fn ring_indices(polygon: &Polygon, first: u32) -> Vec<Vec<u32>> {
    let mut next = first;
    let indices = |ring: &[DVec2]| {
        let ring = next..next + ring.len() as u32;
        next = ring.end;
        ring.collect()
    };
    polygon.rings().map(indices).collect()
}
