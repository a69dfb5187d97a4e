//! Cutting meshes between parallel planes.
//!
//! Faces are cut ring by ring, so holes and concave faces come out right. Where the mesh was closed, the open edges
//! that a cut leaves lie in its plane; followed round they are the rim of the caps that close the parts again.

use crate::geometry::clip::{Section, clip};
use crate::geometry::{Mesh, ring_area};
use glam::{DVec2, DVec3};
use std::collections::BTreeMap;

/// Vertices nearer than this (metres) to a plane lie in it.
const IN_PLANE: f64 = 1e-9;

impl Mesh {
    /// The part with `from <= p · normal <= to`; the normal is a unit vector, bounds may be infinite. A closed mesh
    /// gives a closed part, an open one stays open. Empty where nothing is between.
    pub fn cut(&self, normal: DVec3, from: f64, to: f64) -> Mesh {
        if from < to { self.kept(normal, from).kept(-normal, -to) } else { Mesh::default() }
    }

    /// The parts between consecutive cuts, as many as there are cuts less one; the cuts must ascend. Same as
    /// [`Mesh::cut`] for each pair, but costs n log k instead of n k for k cuts.
    pub fn bands(&self, normal: DVec3, cuts: &[f64]) -> Vec<Mesh> {
        let mut parts = vec![Mesh::default(); cuts.len().saturating_sub(1)];
        if !parts.is_empty() && cuts.is_sorted() && !cuts.iter().any(|c| c.is_nan()) {
            halve(self.cut(normal, cuts[0], cuts[cuts.len() - 1]), normal, cuts, &mut parts);
        }
        parts
    }

    /// The part with `p · normal >= at`.
    fn kept(&self, normal: DVec3, at: f64) -> Mesh {
        let height = |p: &DVec3| Some(p.dot(normal) - at).filter(|h| h.abs() > IN_PLANE).unwrap_or(0.0);
        let heights: Vec<f64> = self.positions.iter().map(height).collect();
        if heights.iter().all(|h| *h >= 0.0) {
            return self.clone();
        }
        if heights.iter().all(|h| *h <= 0.0) {
            return Mesh::default();
        }
        let positions = self.positions.clone();
        let mut plane = Plane { normal, at, positions, heights, crossings: BTreeMap::new(), along: DVec3::ZERO };
        let mut part = Mesh::default();
        for face in self.faces() {
            plane.along = normal.cross(face.normal());
            let rings: Vec<&[u32]> = face.rings().collect();
            let clipped = clip(rings.iter().copied(), &mut plane);
            if clipped.whole.len() == rings.len() {
                part.push_face(rings);
                continue;
            }
            let (u, v) = face.axes();
            let whole = clipped.whole.iter().map(|i| rings[*i].to_vec());
            push_nested(&mut part, clipped.loops.into_iter().chain(whole).collect(), &plane.positions, u, v);
        }
        if let Some(place) = plane.twins() {
            part = part.merged(&place);
        }
        part.positions = plane.positions;
        if self.is_closed() {
            part.cap(normal);
        }
        part.without_unused()
    }

    /// Closes the open edges by faces that look against the normal.
    fn cap(&mut self, normal: DVec3) {
        let u = normal.any_orthonormal_vector();
        let v = u.cross(normal);
        let open = self.edges().into_iter().filter(|e| e.right.is_none()).map(|e| (e.to, e.from));
        let rims = rims(open.collect(), |p: u32| flat(self.positions[p as usize], u, v));
        let positions = std::mem::take(&mut self.positions);
        push_nested(self, rims, &positions, u, v);
        self.positions = positions;
    }

    /// The faces with each vertex replaced by another in the same place; edges that lose their length vanish, and
    /// with them rings that have no width left.
    fn merged(&self, place: &[u32]) -> Mesh {
        let mut mesh = Mesh::default();
        for face in self.faces() {
            let merged = face.rings().map(|ring| {
                let mut ring: Vec<u32> = ring.iter().map(|v| place[*v as usize]).collect();
                ring.dedup();
                while ring.len() > 1 && ring.first() == ring.last() {
                    ring.pop();
                }
                ring
            });
            let mut rings = merged.filter(|ring| ring.len() >= 3).peekable();
            if rings.peek().is_some() {
                mesh.push_face(rings);
            }
        }
        mesh
    }

    /// The same without vertices that no face uses.
    fn without_unused(mut self) -> Mesh {
        let mut place = vec![u32::MAX; self.positions.len()];
        let mut used = Vec::new();
        for corner in &mut self.corners {
            let new = &mut place[*corner as usize];
            if *new == u32::MAX {
                *new = used.len() as u32;
                used.push(self.positions[*corner as usize]);
            }
            *corner = *new;
        }
        Mesh { positions: used, ..self }
    }
}

/// A cutting plane and the vertices on it, shared by all faces.
struct Plane {
    normal: DVec3,
    at: f64,
    positions: Vec<DVec3>,
    heights: Vec<f64>,
    /// The vertex where the edge between two vertices meets the plane.
    crossings: BTreeMap<(u32, u32), u32>,
    /// Along the cut in the face at hand, the kept side to the left.
    along: DVec3,
}

impl Section for Plane {
    type Point = u32;

    fn depth(&self, vertex: u32) -> f64 {
        self.heights[vertex as usize]
    }

    fn along(&self, vertex: u32) -> f64 {
        self.positions[vertex as usize].dot(self.along)
    }

    fn crossing(&mut self, a: u32, b: u32) -> u32 {
        let (a, b) = (a.min(b), a.max(b));
        let (ha, hb) = (self.depth(a), self.depth(b));
        if ha == 0.0 || hb == 0.0 {
            return if ha == 0.0 { a } else { b };
        }
        *self.crossings.entry((a, b)).or_insert_with(|| {
            let met = self.positions[a as usize].lerp(self.positions[b as usize], ha / (ha - hb));
            self.positions.push(met + self.normal * (self.at - met.dot(self.normal)));
            self.heights.push(0.0);
            self.positions.len() as u32 - 1
        })
    }
}

impl Plane {
    /// For each vertex the first one in its place, where several of the plane coincide: rims that touch would leave
    /// caps without width between them, which no cap can close. `None` where all are apart, as mostly.
    fn twins(&self) -> Option<Vec<u32>> {
        let mut inside: Vec<u32> =
            (0..self.heights.len() as u32).filter(|v| self.heights[*v as usize] == 0.0).collect();
        // Askew, because vertices tend to share their height or their place in plan.
        let (u, v) = self.normal.any_orthonormal_pair();
        let u = u + v * 0.618;
        let along = |v: &u32| self.positions[*v as usize].dot(u);
        inside.sort_by(|a, b| along(a).total_cmp(&along(b)).then(a.cmp(b)));
        let mut place: Vec<u32> = (0..self.heights.len() as u32).collect();
        let mut merged = false;
        for (i, a) in inside.iter().enumerate() {
            for b in inside[i + 1..].iter().take_while(|b| along(b) - along(a) <= IN_PLANE) {
                if self.positions[*a as usize].distance(self.positions[*b as usize]) <= IN_PLANE {
                    place[*b as usize] = place[*a as usize];
                    merged = true;
                }
            }
        }
        merged.then_some(place)
    }
}

/// Adds faces from rings of one plane: counter-clockwise ones are outlines, the others holes of the one around them.
fn push_nested(mesh: &mut Mesh, rings: Vec<Vec<u32>>, positions: &[DVec3], u: DVec3, v: DVec3) {
    let Some(origin) = rings.first().map(|r| positions[r[0] as usize]) else { return };
    let planar =
        |ring: &Vec<u32>| -> Vec<DVec2> { ring.iter().map(|p| flat(positions[*p as usize] - origin, u, v)).collect() };
    let turned = rings.into_iter().map(|ring| (planar(&ring), ring));
    let (mut outlines, holes): (Vec<_>, Vec<_>) = turned.partition(|(flat, _)| ring_area(flat) > 0.0);
    outlines.sort_by(|a, b| ring_area(&a.0).total_cmp(&ring_area(&b.0)));
    let shared = |i: usize, hole: &[DVec2]| hole.iter().filter(|p| winds(&outlines[i].0, **p)).count();
    // The least of those that surround most of the hole, whose vertices may lie on a rim.
    let owner = |hole: &[DVec2]| (0..outlines.len()).rev().max_by_key(|i| shared(*i, hole));
    let owners: Vec<Option<usize>> = holes.iter().map(|(hole, _)| owner(hole)).collect();
    for (i, (_, outline)) in outlines.into_iter().enumerate() {
        let own = holes.iter().zip(&owners).filter(|(_, owner)| **owner == Some(i)).map(|((_, hole), _)| hole);
        mesh.push_face(std::iter::once(&outline).chain(own));
    }
}

/// Follows directed edges round into rings. Where several go on from a vertex, the one most to the left does, so that
/// rings which touch stay apart.
fn rims(edges: Vec<(u32, u32)>, flat: impl Fn(u32) -> DVec2) -> Vec<Vec<u32>> {
    let mut next: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
    edges.iter().for_each(|(a, b)| next.entry(*a).or_default().push(*b));
    let mut rims = Vec::new();
    for (start, second) in edges {
        let Some(list) = next.get_mut(&start) else { continue };
        let Some(place) = list.iter().position(|b| *b == second) else { continue };
        list.swap_remove(place);
        let (mut ring, mut before, mut here) = (vec![start], start, second);
        while here != start {
            let Some(list) = next.get_mut(&here).filter(|l| !l.is_empty()) else { break };
            let on = flat(here) - flat(before);
            let turn = |to: u32| {
                let out = flat(to) - flat(here);
                libm::atan2(on.perp_dot(out), on.dot(out))
            };
            let left = (0..list.len()).max_by(|a, b| turn(list[*a]).total_cmp(&turn(list[*b]))).unwrap_or(0);
            ring.push(here);
            (before, here) = (here, list.swap_remove(left));
        }
        if here == start && ring.len() >= 3 {
            rims.push(ring);
        }
    }
    rims
}

fn flat(p: DVec3, u: DVec3, v: DVec3) -> DVec2 {
    DVec2::new(p.dot(u), p.dot(v))
}

/// Whether a ring goes round a point.
fn winds(ring: &[DVec2], p: DVec2) -> bool {
    let edges = ring.iter().zip(ring.iter().cycle().skip(1));
    let crossed =
        edges.filter(|(a, b)| (a.y > p.y) != (b.y > p.y) && ((**b - **a).perp_dot(p - **a) > 0.0) == (b.y > a.y));
    crossed.count() % 2 == 1
}

/// Halves the mesh at the middle cut until every part lies in one band.
fn halve(mesh: Mesh, normal: DVec3, cuts: &[f64], parts: &mut [Mesh]) {
    if mesh.faces.is_empty() {
        return;
    }
    if let [part] = parts {
        *part = mesh;
        return;
    }
    let middle = parts.len() / 2;
    let (left, right) = parts.split_at_mut(middle);
    halve(mesh.kept(-normal, -cuts[middle]), normal, &cuts[..=middle], left);
    halve(mesh.kept(normal, cuts[middle]), normal, &cuts[middle..], right);
}
