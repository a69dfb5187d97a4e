//! Polygonal faces in space, flat buffers: what a mesh is, its faces, edges and measures.
//!
//! Frame: right-handed, metres. Faces are planar and run counter-clockwise seen from outside; holes run the other way
//! round. A closed mesh shares the vertices of neighbouring faces.

mod connected;
mod edges;
mod section;
mod solid;
mod surface;
mod tidy;

pub use edges::Edge;

use glam::{DAffine3, DVec2, DVec3};

/// A mesh of planar polygonal faces with holes, metres. Faces run counter-clockwise seen from outside.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Mesh {
    /// Vertices.
    pub positions: Vec<DVec3>,
    /// Vertex indices of all rings, one after the other.
    pub corners: Vec<u32>,
    /// Where each ring ends in `corners`; a face's first ring is its outline, the others its holes.
    pub rings: Vec<u32>,
    /// Where each face ends in `rings`.
    pub faces: Vec<u32>,
}

/// A face of a mesh.
#[derive(Clone, Copy, Debug)]
pub struct Face<'a> {
    mesh: &'a Mesh,
    first_ring: usize,
    end_ring: usize,
}

impl Mesh {
    /// How many faces there are.
    pub fn face_count(&self) -> usize {
        self.faces.len()
    }

    /// The `index`-th face, which must exist.
    pub fn face(&self, index: usize) -> Face<'_> {
        let first_ring = if index == 0 { 0 } else { self.faces[index - 1] as usize };
        Face { mesh: self, first_ring, end_ring: self.faces[index] as usize }
    }

    /// All faces.
    pub fn faces(&self) -> impl ExactSizeIterator<Item = Face<'_>> {
        (0..self.faces.len()).map(|i| self.face(i))
    }

    /// Adds a face from the vertex indices of its outline and its holes.
    pub fn push_face<R: AsRef<[u32]>>(&mut self, rings: impl IntoIterator<Item = R>) {
        for ring in rings {
            self.corners.extend_from_slice(ring.as_ref());
            self.rings.push(self.corners.len() as u32);
        }
        self.faces.push(self.rings.len() as u32);
    }

    /// Adds all faces of another mesh.
    pub fn append(&mut self, other: &Mesh) {
        let vertices = self.positions.len() as u32;
        self.positions.extend_from_slice(&other.positions);
        for face in other.faces() {
            self.push_face(face.rings().map(|ring| ring.iter().map(|v| v + vertices).collect::<Vec<_>>()));
        }
    }

    /// Least and greatest coordinates; `None` without vertices.
    pub fn bounds(&self) -> Option<(DVec3, DVec3)> {
        let first = *self.positions.first()?;
        Some(self.positions.iter().fold((first, first), |(low, high), p| (low.min(*p), high.max(*p))))
    }

    /// Surface in m².
    pub fn area(&self) -> f64 {
        self.faces().map(|f| f.area()).sum()
    }

    /// Volume in m³ where it is closed; what an open mesh gives depends on its place.
    pub fn volume(&self) -> f64 {
        let Some((low, high)) = self.bounds() else { return 0.0 };
        let centre = (low + high) * 0.5;
        self.faces().map(|f| (f.first() - centre).dot(f.area_vector())).sum::<f64>() / 3.0
    }

    /// The same under an affine map; a mirroring one turns the faces round so that they still look outwards.
    pub fn transformed(&self, map: &DAffine3) -> Mesh {
        let mut mesh = self.clone();
        mesh.positions.iter_mut().for_each(|p| *p = map.transform_point3(*p));
        if map.matrix3.determinant() < 0.0 {
            mesh.turn_round();
        }
        mesh
    }

    /// Turns every face round: the inside becomes the outside.
    pub fn turn_round(&mut self) {
        let mut from = 0;
        for end in &self.rings {
            self.corners[from..*end as usize].reverse();
            from = *end as usize;
        }
    }

    /// Says what is wrong with the buffers or the faces, if anything is: indices out of range, rings of fewer than
    /// three vertices or with a vertex twice in a row, numbers that are not finite, faces that are not flat.
    pub fn sanity_check(&self) -> Result<(), String> {
        let ends = |list: &[u32], total: usize| list.is_sorted() && list.last().map_or(0, |e| *e as usize) == total;
        if !ends(&self.rings, self.corners.len()) || !ends(&self.faces, self.rings.len()) {
            return Err("the ends of rings or faces do not fit their buffers".into());
        }
        if let Some(vertex) = self.corners.iter().find(|c| **c as usize >= self.positions.len()) {
            return Err(format!("corner names vertex {vertex} of {}", self.positions.len()));
        }
        if let Some(p) = self.positions.iter().find(|p| !p.is_finite()) {
            return Err(format!("vertex at {p}"));
        }
        self.faces().enumerate().try_for_each(|(i, face)| face.check().map_err(|e| format!("face {i}: {e}")))
    }
}

impl<'a> Face<'a> {
    /// The outline, then the holes, as vertex indices.
    pub fn rings(&self) -> impl ExactSizeIterator<Item = &'a [u32]> + use<'a> {
        let mesh = self.mesh;
        (self.first_ring..self.end_ring).map(move |ring| {
            let from = if ring == 0 { 0 } else { mesh.rings[ring - 1] as usize };
            &mesh.corners[from..mesh.rings[ring] as usize]
        })
    }

    /// The vertex indices of the outline.
    pub fn outline(&self) -> &'a [u32] {
        self.rings().next().unwrap_or(&[])
    }

    /// The positions of a ring.
    pub fn positions(&self, ring: &[u32]) -> impl Iterator<Item = DVec3> {
        ring.iter().map(|v| self.mesh.positions[*v as usize])
    }

    /// Normal times area in m², holes taken off (Newell).
    pub fn area_vector(&self) -> DVec3 {
        let origin = self.first();
        let at = |v: u32| self.mesh.positions[v as usize] - origin;
        let of_ring = |ring: &[u32]| -> DVec3 {
            (0..ring.len()).map(|i| at(ring[i]).cross(at(ring[(i + 1) % ring.len()]))).sum()
        };
        self.rings().map(of_ring).sum::<DVec3>() * 0.5
    }

    /// Area in m².
    pub fn area(&self) -> f64 {
        self.area_vector().length()
    }

    /// Unit normal, outwards; zero for a face without area.
    pub fn normal(&self) -> DVec3 {
        self.area_vector().normalize_or_zero()
    }

    /// Right-handed unit axes in the plane of the face: u along its first edge, and v.
    pub fn axes(&self) -> (DVec3, DVec3) {
        let (outline, normal) = (self.outline(), self.normal());
        let edges = outline.windows(2).map(|w| self.mesh.positions[w[1] as usize] - self.mesh.positions[w[0] as usize]);
        let along = edges.filter_map(|e| e.reject_from(normal).try_normalize()).next();
        let u = along.unwrap_or_else(|| if normal == DVec3::ZERO { DVec3::X } else { normal.any_orthonormal_vector() });
        (u, normal.cross(u))
    }

    /// The first corner, from which planar coordinates are best counted.
    pub fn first(&self) -> DVec3 {
        self.outline().first().map_or(DVec3::ZERO, |v| self.mesh.positions[*v as usize])
    }

    /// The rings in the plane of the face, seen from outside, counted from [`Face::first`] along [`Face::axes`].
    pub fn flat_rings(&self) -> Vec<Vec<DVec2>> {
        let (origin, (u, v)) = (self.first(), self.axes());
        let flat = |p: DVec3| DVec2::new((p - origin).dot(u), (p - origin).dot(v));
        self.rings().map(|ring| self.positions(ring).map(flat).collect()).collect()
    }

    fn check(&self) -> Result<(), String> {
        if self.rings().len() == 0 {
            return Err("no outline".into());
        }
        for ring in self.rings() {
            if ring.len() < 3 {
                return Err(format!("a ring of {} vertices", ring.len()));
            }
            if (0..ring.len()).any(|i| ring[i] == ring[(i + 1) % ring.len()]) {
                return Err("a vertex twice in a row".into());
            }
        }
        let (origin, normal) = (self.first(), self.normal());
        let points = || self.rings().flat_map(|ring| self.positions(ring));
        let size = points().map(|p| p.distance(origin)).fold(0.0, f64::max);
        let lift = points().map(|p| (p - origin).dot(normal).abs()).fold(0.0, f64::max);
        if lift > 1e-6 * size.max(1.0) { Err(format!("{lift} m out of its plane")) } else { Ok(()) }
    }
}
