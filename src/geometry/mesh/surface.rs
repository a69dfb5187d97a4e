//! What a mesh looks like to others: triangles, and its outline on the ground.

use crate::geometry::overlay::{Fill, enclosed};
use crate::geometry::triangulate::triangulate_rings;
use crate::geometry::{Area, Mesh};
use glam::DVec2;

impl Mesh {
    /// Triangles that cover the faces, counter-clockwise seen from outside, as vertex indices; face by face.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let mut triangles = Vec::with_capacity(self.corners.len());
        for face in self.faces() {
            let corners: Vec<u32> = face.rings().flatten().copied().collect();
            if let [a, b, c] = corners[..] {
                triangles.push([a, b, c]);
                continue;
            }
            let rings = face.flat_rings();
            let rings: Vec<&[DVec2]> = rings.iter().map(Vec::as_slice).collect();
            let convex = rings.len() == 1 && crate::geometry::cut::is_convex(rings[0]);
            let corner = |t: [u32; 3]| t.map(|i| corners[i as usize]);
            triangles.extend(triangulate_rings(&rings, convex).into_iter().map(corner));
        }
        triangles
    }

    /// The same surface in triangles. Collinear vertices may be left out of them.
    pub fn triangulated(&self) -> Mesh {
        let mut mesh = Mesh { positions: self.positions.clone(), ..Mesh::default() };
        self.triangles().into_iter().for_each(|t| mesh.push_face([t]));
        mesh
    }

    /// What the mesh covers of the ground in a y-up frame, in plan coordinates x and −z: the union of its faces seen
    /// from above. Upright faces cover nothing. On the grid of booleans, about a micrometre.
    pub fn footprint(&self) -> Area {
        let closed = self.is_closed();
        let mut rings: Vec<Vec<DVec2>> = Vec::new();
        for face in self.faces() {
            let up = face.normal().y;
            if up.abs() < 1e-9 || (closed && up < 0.0) {
                continue;
            }
            for ring in face.rings() {
                let mut ring: Vec<DVec2> = face.positions(ring).map(|p| DVec2::new(p.x, -p.z)).collect();
                if up < 0.0 {
                    ring.reverse();
                }
                rings.push(ring);
            }
        }
        enclosed(rings.iter().map(Vec::as_slice), Fill::NonZero)
    }
}
