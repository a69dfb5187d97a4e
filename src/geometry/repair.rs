//! Sound polygons out of dirty rings.
//!
//! In: one outline and its holes as data gives them: closed or open, in any orientation, with repeated or
//! self-crossing edges, spikes, numbers that are none. Out: the area they mean, and whether it had to be changed.

use crate::geometry::overlay::{Fill, Keep, enclosed, overlay};
use crate::geometry::{Area, Polygon};
use glam::DVec2;

/// The area inside the first ring and outside the others, and whether the data was unsound.
///
/// A ring that crosses itself encloses whatever it winds around, so a bow tie becomes two triangles and a loop is
/// filled. Holes may overlap; what of them lies outside the outline has no effect. Closing points, repeated points
/// and orientation are no faults; sound rings come back as they are, vertex for vertex.
pub fn repair(rings: &[Vec<DVec2>]) -> (Area, bool) {
    let finite: Vec<Vec<DVec2>> = rings.iter().map(|r| r.iter().copied().filter(|p| p.is_finite()).collect()).collect();
    let complete = finite.iter().zip(rings).all(|(a, b)| a.len() == b.len());
    let Some((outline, holes)) = finite.split_first() else { return (Area::empty(), false) };
    let filled = enclosed(std::iter::once(&outline[..]), Fill::NonZero);
    let pierced = holes.iter().map(|hole| enclosed(std::iter::once(&hole[..]), Fill::NonZero));
    let holed = pierced.fold(filled, |area, hole| overlay(&area, &hole, Keep::Difference));
    let as_given = Polygon::new(outline, holes).map(|p| without_repeats(&p));
    match as_given {
        Some(polygon) if complete && same(&polygon, holes.len(), &holed) => (polygon.into(), false),
        _ => (holed, true),
    }
}

/// Whether the rings as given enclose the repaired area: equal in area, in length (spikes) and in number of rings.
fn same(given: &Polygon, holes: usize, repaired: &Area) -> bool {
    let [only] = repaired.polygons() else { return false };
    let slack = 1e-4 + 1e-5 * given.perimeter();
    given.holes().count() == holes
        && only.holes().count() == holes
        && (only.area() - given.area()).abs() <= slack
        && (only.perimeter() - given.perimeter()).abs() <= slack
}

/// The polygon without vertices that lie within a micrometre of the one before.
fn without_repeats(polygon: &Polygon) -> Polygon {
    let thin = |ring: &[DVec2]| {
        let mut ring = ring.to_vec();
        ring.dedup_by(|b, a| a.distance_squared(*b) <= 1e-12);
        ring
    };
    let holes: Vec<Vec<DVec2>> = polygon.holes().map(thin).collect();
    Polygon::new(&thin(polygon.outer()), &holes).unwrap_or_else(|| polygon.clone())
}
