//! Arcs of the skeleton → the face of each edge, followed round.

use super::StraightSkeleton;
use super::wavefront::Traces;

/// The skeleton with its faces; `None` where the arcs around a face do not close.
pub(super) fn chained(traces: Traces) -> Option<StraightSkeleton> {
    let mut sides: Vec<Vec<[u32; 2]>> = vec![Vec::new(); traces.ends.len()];
    for arc in &traces.arcs {
        sides[arc.left].push([arc.from, arc.to]);
        sides[arc.right].push([arc.to, arc.from]);
    }
    let faces = traces.ends.iter().zip(sides).map(|(ends, sides)| face(*ends, sides)).collect::<Option<_>>()?;
    Some(StraightSkeleton { nodes: traces.nodes, faces })
}

/// From the start of the edge along it and then along the arcs back to its start.
fn face([start, end]: [u32; 2], mut sides: Vec<[u32; 2]>) -> Option<Vec<u32>> {
    let mut face = vec![start, end];
    let mut at = end;
    while at != start {
        let next = sides.iter().position(|side| side[0] == at)?;
        at = sides.swap_remove(next)[1];
        if at != start {
            face.push(at);
        }
    }
    // What is left runs there and back: a ridge inside the face encloses nothing.
    (face.len() >= 3).then_some(face)
}
