//! Cutting rings along one straight section: what lies strictly on the kept side, closed along the cut.
//!
//! In: rings of any vertex type, interior to the left, and a [`Section`] that says where a vertex lies. Out: closed
//! loops and the rings the section does not meet. Knows no polygons: flat areas and the faces of meshes share it.
//!
//! Where a ring leaves the kept side the boundary goes on along the cut to where a ring next comes back. Sorted along
//! the cut, the k-th place of leaving therefore belongs to the k-th place of coming back. Any other pairing would
//! give the same signed area, so rounding can never lose or invent area. Vertices on the cut count as outside, which
//! keeps parts that meet the cut in single points apart.

/// Places along a cut that are nearer than this (metres) are the same.
const SAME_PLACE: f64 = 1e-6;

/// Where vertices lie relative to a cut.
pub(super) trait Section {
    /// A vertex.
    type Point: Copy + PartialEq;
    /// Distance into the kept side; exactly zero on the cut.
    fn depth(&self, point: Self::Point) -> f64;
    /// Position along the cut; grows so that the kept side lies to the left.
    fn along(&self, point: Self::Point) -> f64;
    /// Where the edge between the two meets the cut; the same whichever is first, and an end that lies on the cut.
    fn crossing(&mut self, a: Self::Point, b: Self::Point) -> Self::Point;
}

/// What a cut leaves of the rings.
pub(super) struct Clipped<P> {
    /// Closed loops of vertices that follow the cut somewhere.
    pub loops: Vec<Vec<P>>,
    /// Indices of the rings that lie wholly on the kept side.
    pub whole: Vec<usize>,
    /// Whether rings touch in a point of the cut: the loops then wind around the right places in sum, but one may run
    /// through what another leaves out.
    pub touching: bool,
}

/// The kept side of the rings. Costs n log n in the number of crossings.
pub(super) fn clip<'a, S: Section>(rings: impl Iterator<Item = &'a [S::Point]>, section: &mut S) -> Clipped<S::Point>
where
    S::Point: 'a,
{
    let (mut chains, mut whole) = (Vec::new(), Vec::new());
    for (index, ring) in rings.enumerate() {
        if ring.iter().all(|p| section.depth(*p) > 0.0) {
            whole.push(index);
        } else {
            chains_of(ring, section, &mut chains);
        }
    }
    let (next, touching) = successors(&chains, section);
    Clipped { loops: joined(chains, &next), whole, touching }
}

/// The runs of kept vertices of one ring, each with the places on the cut where it begins and ends.
fn chains_of<S: Section>(ring: &[S::Point], section: &mut S, chains: &mut Vec<Vec<S::Point>>) {
    let count = ring.len();
    let Some(start) = (0..count).find(|i| section.depth(ring[*i]) <= 0.0) else { return };
    let mut open: Option<Vec<S::Point>> = None;
    let mut before = ring[start];
    for step in 1..=count {
        let vertex = ring[(start + step) % count];
        if section.depth(vertex) > 0.0 {
            open.get_or_insert_with(|| vec![section.crossing(before, vertex)]).push(vertex);
        } else if let Some(mut chain) = open.take() {
            chain.push(section.crossing(before, vertex));
            chains.push(chain);
        }
        before = vertex;
    }
}

/// Which chain comes after each along the cut, and whether two leave or come back in the same place.
fn successors<S: Section>(chains: &[Vec<S::Point>], section: &S) -> (Vec<usize>, bool) {
    let sorted = |end: fn(&[S::Point]) -> Option<&S::Point>| {
        let places = chains.iter().enumerate().filter_map(|(i, c)| Some((section.along(*end(c)?), i)));
        let mut places: Vec<(f64, usize)> = places.collect();
        places.sort_by(|a, b| a.0.total_cmp(&b.0));
        places
    };
    let (leaving, entering) = (sorted(<[_]>::last), sorted(<[_]>::first));
    let touch = |places: &[(f64, usize)]| places.windows(2).any(|w| w[1].0 - w[0].0 < SAME_PLACE);
    let mut next = vec![0; chains.len()];
    for (from, to) in leaving.iter().zip(&entering) {
        next[from.1] = to.1;
    }
    (next, touch(&leaving) || touch(&entering))
}

/// The chains joined into closed loops.
fn joined<P: Copy + PartialEq>(mut chains: Vec<Vec<P>>, next: &[usize]) -> Vec<Vec<P>> {
    let mut loops = Vec::new();
    for first in 0..chains.len() {
        let mut ring = std::mem::take(&mut chains[first]);
        let mut at = next[first];
        while !ring.is_empty() && at != first {
            ring.append(&mut chains[at]);
            at = next[at];
        }
        ring.dedup();
        while ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        if ring.len() >= 3 {
            loops.push(ring);
        }
    }
    loops
}
