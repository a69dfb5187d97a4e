//! Tidier meshes: vertices welded, faces without area or twice there dropped, faces of one plane joined.

use crate::geometry::Mesh;
use glam::DVec3;
use std::collections::{BTreeMap, BTreeSet};

impl Mesh {
    /// The mesh with vertices within `distance` metres as one; rings that collapse vanish. n log n.
    pub fn welded(&self, distance: f64) -> Mesh {
        let corners = self.welded_corners(distance);
        self.rebuilt(|ring| {
            let mut ring: Vec<u32> = ring.iter().map(|place| corners[*place]).collect();
            ring.dedup();
            while ring.len() > 1 && ring.first() == ring.last() {
                ring.pop();
            }
            ring
        })
    }

    /// The mesh without faces of at most `area` m² and without faces that are there twice.
    pub fn without_trifles(&self, area: f64) -> Mesh {
        let mut seen = BTreeSet::new();
        let kept = |index: &usize| {
            let face = self.face(*index);
            let mut corners: Vec<u32> = face.rings().flatten().copied().collect();
            corners.sort_unstable();
            face.area() > area && seen.insert(corners)
        };
        let kept: Vec<usize> = (0..self.face_count()).filter(kept).collect();
        self.only(&kept)
    }

    /// The mesh without vertices where every face that has them goes on straight, within `angle` radians.
    pub fn without_straight_corners(&self, angle: f64) -> Mesh {
        let sine = libm::sin(angle).max(1e-9);
        let mut bends = vec![false; self.positions.len()];
        for face in self.faces() {
            for ring in face.rings() {
                let at = |i: usize| self.positions[ring[i % ring.len()] as usize];
                for i in 0..ring.len() {
                    let before = (at(i) - at(i + ring.len() - 1)).normalize_or_zero();
                    let after = (at(i + 1) - at(i)).normalize_or_zero();
                    bends[ring[i] as usize] |= before.cross(after).length() > sine || before.dot(after) <= 0.0;
                }
            }
        }
        self.rebuilt(|ring| {
            let corners = ring.iter().map(|place| self.corners[*place]);
            corners.filter(|vertex| bends[*vertex as usize]).collect()
        })
    }

    /// The mesh with faces joined that lie side by side in one plane, their normals within `angle` radians. Sets of
    /// faces whose outline touches itself, or that would not be flat, stay apart.
    pub fn with_planes_joined(&self, angle: f64) -> Mesh {
        let normals: Vec<DVec3> = self.faces().map(|face| face.normal()).collect();
        let cosine = libm::cos(angle).min(1.0 - 1e-12);
        let flat = |a: u32, b: u32| normals[a as usize].dot(normals[b as usize]) >= cosine;
        let sets = self.sets_of_faces(flat);
        let mut mesh = Mesh { positions: self.positions.clone(), ..Mesh::default() };
        for set in sets {
            match self.outline_of(&set) {
                Some(rings) => mesh.push_face(rings),
                None => set.iter().for_each(|face| mesh.push_face(self.face(*face).rings())),
            }
        }
        mesh.only(&(0..mesh.face_count()).collect::<Vec<_>>())
    }

    /// The rings around a set of faces, the outline first; `None` for one face, or where they do not make one.
    fn outline_of(&self, set: &[usize]) -> Option<Vec<Vec<u32>>> {
        if set.len() < 2 {
            return None;
        }
        let mut halves: BTreeSet<(u32, u32)> = BTreeSet::new();
        for ring in set.iter().flat_map(|face| self.face(*face).rings()) {
            for (a, b) in ring.iter().zip(ring.iter().cycle().skip(1)) {
                if !halves.remove(&(*b, *a)) {
                    halves.insert((*a, *b));
                }
            }
        }
        let mut next: BTreeMap<u32, u32> = BTreeMap::new();
        for (from, to) in &halves {
            if next.insert(*from, *to).is_some() {
                return None;
            }
        }
        let mut rings = Vec::new();
        while let Some((first, mut at)) = next.pop_first() {
            let mut ring = vec![first];
            while at != first {
                ring.push(at);
                at = next.remove(&at)?;
            }
            rings.push(ring);
        }
        self.ordered(rings, self.face(set[0]).normal())
    }

    /// Rings of one face with the outline first; `None` where they are not of one, or it is not flat.
    fn ordered(&self, rings: Vec<Vec<u32>>, normal: DVec3) -> Option<Vec<Vec<u32>>> {
        let at = |vertex: u32| self.positions[vertex as usize] - self.positions[rings[0][0] as usize];
        let alone = |ring: &Vec<u32>| {
            let sides = ring.iter().zip(ring.iter().cycle().skip(1));
            sides.map(|(a, b)| at(*a).cross(at(*b))).sum::<DVec3>().dot(normal)
        };
        let (outlines, holes): (Vec<&Vec<u32>>, Vec<_>) = rings.iter().partition(|ring| alone(ring) > 0.0);
        let points = || rings.iter().flatten().map(|vertex| at(*vertex));
        let size = points().map(|p| p.length()).fold(1.0, f64::max);
        let flat = outlines.len() == 1 && points().all(|p| p.dot(normal).abs() <= 1e-6 * size);
        flat.then(|| outlines.into_iter().chain(holes).cloned().collect())
    }

    /// The mesh with each ring made anew from the places of its corners; those of fewer than three vanish, and a face
    /// with its outline. Vertices that nothing uses go.
    fn rebuilt(&self, ring_of: impl Fn(&[usize]) -> Vec<u32>) -> Mesh {
        let mut mesh = Mesh { positions: self.positions.clone(), ..Mesh::default() };
        let mut place = 0;
        for face in self.faces() {
            let mut rings: Vec<Vec<u32>> = Vec::new();
            for ring in face.rings() {
                let places: Vec<usize> = (place..place + ring.len()).collect();
                place += ring.len();
                rings.push(ring_of(&places));
            }
            if rings.first().is_some_and(|outline| outline.len() >= 3) {
                mesh.push_face(rings.into_iter().filter(|ring| ring.len() >= 3));
            }
        }
        mesh.only(&(0..mesh.face_count()).collect::<Vec<_>>())
    }
}
