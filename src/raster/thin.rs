//! Rings with fewer vertices: what lies within a tolerance of a straight line goes (Douglas and Peucker 1973).

use glam::DVec2;

/// The ring, closed in itself, with every vertex it gives up within `tolerance` of what is left.
///
/// A ring that would not enclose anything afterwards stays as it is. Crossings can come of it where a ring passes
/// itself within the tolerance. Cost: n log n for ordinary rings, n² at worst.
pub fn thinned(ring: &[DVec2], tolerance: f64) -> Vec<DVec2> {
    let Some(first) = ring.first() else { return Vec::new() };
    let far = |(_, a): &(usize, &DVec2), (_, b): &(usize, &DVec2)| {
        a.distance_squared(*first).total_cmp(&b.distance_squared(*first))
    };
    // Two vertices that surely stay, so that there are lines to measure from.
    let opposite = ring.iter().enumerate().max_by(far).map_or(0, |(index, _)| index);
    let mut stays = vec![false; ring.len()];
    (stays[0], stays[opposite]) = (true, true);
    let mut open = vec![(0, opposite), (opposite, ring.len())];
    while let Some((from, to)) = open.pop() {
        if let Some(index) = farthest(ring, from, to, tolerance) {
            stays[index] = true;
            open.extend([(from, index), (index, to)]);
        }
    }
    let kept: Vec<DVec2> = ring.iter().zip(&stays).filter(|(_, stays)| **stays).map(|(p, _)| *p).collect();
    if kept.len() < 4 { ring.to_vec() } else { kept }
}

/// The vertex strictly between two that lies farthest from the line between them, where that is beyond the tolerance.
fn farthest(ring: &[DVec2], from: usize, to: usize, tolerance: f64) -> Option<usize> {
    let (a, b) = (ring[from], ring[to % ring.len()]);
    let distance = |i: usize| crate::geometry::nearest_on_segment(ring[i], a, b).distance_squared(ring[i]);
    let found = (from + 1..to).map(|i| (i, distance(i))).max_by(|x, y| x.1.total_cmp(&y.1))?;
    (found.1 > tolerance * tolerance).then_some(found.0)
}
