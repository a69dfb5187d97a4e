//! Which faces hang together, and meshes of some of the faces.

use crate::geometry::Mesh;
use glam::DVec3;

impl Mesh {
    /// The faces in sets that hang together by common edges, each set and all sets in the order of the faces.
    /// Vertices within `tolerance` metres are the same. n log n for meshes that are not folded onto themselves.
    pub fn connected_faces(&self, tolerance: f64) -> Vec<Vec<usize>> {
        Mesh { corners: self.welded_corners(tolerance), ..self.clone() }.sets_of_faces(|_, _| true)
    }

    /// The faces in sets that hang together by the edges between two faces that shall be joined.
    pub(super) fn sets_of_faces(&self, joins: impl Fn(u32, u32) -> bool) -> Vec<Vec<usize>> {
        let mut sets = Sets::new(self.face_count());
        let edges = self.edges();
        let pairs = edges.iter().filter_map(|edge| Some((edge.left, edge.right?)));
        pairs.filter(|(a, b)| joins(*a, *b)).for_each(|(a, b)| sets.unite(a, b));
        sets.groups()
    }

    /// The same with only some of its faces, which must exist, and only the vertices that they use.
    pub fn only(&self, faces: &[usize]) -> Mesh {
        let mut number = vec![u32::MAX; self.positions.len()];
        let mut mesh = Mesh::default();
        for face in faces.iter().map(|face| self.face(*face)) {
            let rings: Vec<Vec<u32>> = face
                .rings()
                .map(|ring| ring.iter().map(|vertex| mesh.numbered(*vertex, &mut number, &self.positions)).collect())
                .collect();
            mesh.push_face(rings);
        }
        mesh
    }

    /// The number of another mesh's vertex in this one, which takes it in where it is new.
    fn numbered(&mut self, vertex: u32, number: &mut [u32], positions: &[DVec3]) -> u32 {
        let known = &mut number[vertex as usize];
        if *known == u32::MAX {
            *known = self.positions.len() as u32;
            self.positions.push(positions[vertex as usize]);
        }
        *known
    }

    /// The corners with vertices within `tolerance` metres of each other as one, the first of them.
    pub fn welded_corners(&self, tolerance: f64) -> Vec<u32> {
        let first = first_near(&self.positions, tolerance);
        self.corners.iter().map(|vertex| first[*vertex as usize]).collect()
    }
}

/// For each point the first that is within a distance of it, or of another that is so; swept along x.
fn first_near(points: &[DVec3], distance: f64) -> Vec<u32> {
    let mut order: Vec<u32> = (0..points.len() as u32).collect();
    order.sort_by(|a, b| points[*a as usize].x.total_cmp(&points[*b as usize].x).then(a.cmp(b)));
    let mut sets = Sets::new(points.len());
    let mut begin = 0;
    for (place, index) in order.iter().enumerate() {
        let point = points[*index as usize];
        while point.x - points[order[begin] as usize].x > distance {
            begin += 1;
        }
        let near = order[begin..place].iter().filter(|other| points[**other as usize].distance(point) <= distance);
        near.for_each(|other| sets.unite(*other, *index));
    }
    (0..points.len() as u32).map(|index| sets.root(index)).collect()
}

/// Numbers in sets; the least of a set stands for it.
struct Sets(Vec<u32>);

impl Sets {
    fn new(count: usize) -> Sets {
        Sets((0..count as u32).collect())
    }

    fn root(&mut self, of: u32) -> u32 {
        let mut at = of;
        while self.0[at as usize] != at {
            self.0[at as usize] = self.0[self.0[at as usize] as usize];
            at = self.0[at as usize];
        }
        at
    }

    fn unite(&mut self, a: u32, b: u32) {
        let (a, b) = (self.root(a), self.root(b));
        self.0[a.max(b) as usize] = a.min(b);
    }

    fn groups(mut self) -> Vec<Vec<usize>> {
        let count = self.0.len();
        let mut groups: Vec<Vec<usize>> = vec![Vec::new(); count];
        for index in 0..count {
            groups[self.root(index as u32) as usize].push(index);
        }
        groups.retain(|group| !group.is_empty());
        groups
    }
}
