//! Union, difference and intersection of areas.
//!
//! Parts that nothing touches pass through untouched; the rest is computed on a grid of about a micrometre and loses
//! collinear vertices. Cost is about n log n in the number of edges.

use crate::geometry::cut::{Line, Ring, push_ring};
use crate::geometry::overlay::{Fill, Keep, enclosed, overlay};
use crate::geometry::{Area, Bounds, BoxGrid, Polygon, ring_area};
use glam::DVec2;

/// Convex polygons up to this size are intersected edge by edge.
const FEW_VERTICES: usize = 16;

/// What lies in either.
pub fn union(a: &Area, b: &Area) -> Area {
    union_all([a, b])
}

/// What lies in any of them. Areas that touch nothing else stay as they are.
pub fn union_all<'a>(areas: impl IntoIterator<Item = &'a Area>) -> Area {
    let parts: Vec<&Polygon> = areas.into_iter().flat_map(Area::polygons).collect();
    if parts.len() < 2 {
        return parts.into_iter().cloned().collect();
    }
    let bounds: Vec<Bounds> = parts.iter().map(|p| p.bounds().grown(1e-6)).collect();
    let grid = BoxGrid::new(&bounds);
    let touches = |i: usize| grid.touching(bounds[i]).any(|j| j != i && bounds[j].touches(bounds[i]));
    let (mut alone, mut together) = (Area::empty(), Vec::new());
    for (i, part) in parts.into_iter().enumerate() {
        if touches(i) { together.push(part) } else { alone.push(part.clone()) }
    }
    let merged = enclosed(together.iter().flat_map(|p| p.rings()), Fill::NonZero);
    alone.polygons().iter().chain(merged.polygons()).cloned().collect()
}

/// What lies in `a` but not in `b`.
pub fn difference(a: &Area, b: &Area) -> Area {
    let (touched, free) = split_by_bounds(a, b);
    if touched.is_empty() {
        return a.clone();
    }
    let near = split_by_bounds(b, a).0;
    let rest = overlay(&touched, &near, Keep::Difference);
    free.polygons().iter().chain(rest.polygons()).cloned().collect()
}

/// What lies in both.
pub fn intersection(a: &Area, b: &Area) -> Area {
    let (left, right) = (split_by_bounds(a, b).0, split_by_bounds(b, a).0);
    match (left.polygons(), right.polygons()) {
        ([], _) | (_, []) => Area::empty(),
        ([p], [q]) if is_simple(p) && is_simple(q) => {
            let mut common = Area::empty();
            push_ring(&common_convex(p, q), &mut common);
            common
        }
        _ => overlay(&left, &right, Keep::Intersect),
    }
}

/// Area in m² of what lies in both.
pub fn overlap_area(a: &Area, b: &Area) -> f64 {
    match (a.polygons(), b.polygons()) {
        ([p], [q]) if is_simple(p) && is_simple(q) => ring_area(&common_convex(p, q)),
        _ => intersection(a, b).area(),
    }
}

/// Whether the two have more than `least` m² in common; touching rims have nothing in common.
pub fn overlaps(a: &Area, b: &Area, least: f64) -> bool {
    let common = |p: &Polygon, q: &Polygon| {
        let (p, q) = (p.bounds(), q.bounds());
        (p.max.min(q.max) - p.min.max(q.min)).max(DVec2::ZERO).element_product()
    };
    let most: f64 = a.polygons().iter().flat_map(|p| b.polygons().iter().map(move |q| common(p, q))).sum();
    most > least && overlap_area(a, b) > least
}

/// The parts of `a` whose bounds touch those of a part of `b`, and the others.
fn split_by_bounds(a: &Area, b: &Area) -> (Area, Area) {
    let others: Vec<Bounds> = b.polygons().iter().map(Polygon::bounds).collect();
    let all = others.iter().copied().fold(Bounds::EMPTY, Bounds::union);
    let (mut touched, mut free) = (Area::empty(), Area::empty());
    for part in a.polygons() {
        let bounds = part.bounds();
        let near = bounds.touches(all) && others.iter().any(|o| o.touches(bounds));
        if near { touched.push(part.clone()) } else { free.push(part.clone()) }
    }
    (touched, free)
}

fn is_simple(polygon: &Polygon) -> bool {
    polygon.outer().len() <= FEW_VERTICES && polygon.is_convex()
}

/// What two convex polygons have in common: one cut by the lines of the other's edges.
fn common_convex(p: &Polygon, q: &Polygon) -> Ring {
    q.edges().fold(Ring::from_slice(p.outer()), |ring, (a, b)| match (b - a).try_normalize() {
        Some(along) => Line::new(along.perp(), a.dot(along.perp()), true).clip_convex(&ring),
        None => ring,
    })
}
