//! Who sees whom: the features in and at each region, and the regions at each other's edges.

use crate::geometry::{Bounds, BoxGrid, Polygon, nearest_on_segment};
use crate::layout::{Layout, Region, Shapes};
use glam::DVec2;

/// What is nearer than this (metres) touches: survey data does not meet to the millimetre.
const REACH: f64 = 0.5;

/// The number of the item each region and feature came from: an item does not see itself.
#[derive(Default)]
pub(super) struct Origins {
    pub(super) regions: Vec<usize>,
    pub(super) features: Vec<usize>,
}

/// Fills in `features` and `neighbours` of every region.
///
/// Cost: the pairs whose bounds meet, found through grids, times their edges near each other.
pub(super) fn relate(layout: &mut Layout, origins: &Origins) {
    let features = features_of_all(layout, origins);
    let neighbours = neighbours_of_all(&layout.regions);
    for ((region, features), neighbours) in layout.regions.iter_mut().zip(features).zip(neighbours) {
        region.features = features;
        region.neighbours = neighbours;
    }
}

fn features_of_all(layout: &Layout, origins: &Origins) -> Vec<Vec<usize>> {
    let boxes: Vec<Bounds> = layout.features.iter().map(|f| bounds(&f.shapes)).collect();
    let grid = BoxGrid::new(&boxes);
    let seen = |(index, region): (usize, &Region)| {
        let candidates = grid.touching(region.polygon.bounds().grown(REACH));
        let is_seen = |f: &usize| {
            origins.features[*f] != origins.regions[index] && is_near(&region.polygon, &layout.features[*f].shapes)
        };
        let mut features: Vec<usize> = candidates.filter(is_seen).collect();
        features.sort_unstable();
        features
    };
    layout.regions.iter().enumerate().map(seen).collect()
}

fn neighbours_of_all(regions: &[Region]) -> Vec<Vec<usize>> {
    let boxes: Vec<Bounds> = regions.iter().map(|r| r.polygon.bounds()).collect();
    let grid = BoxGrid::new(&boxes);
    let mut neighbours = vec![Vec::new(); regions.len()];
    for (one, region) in regions.iter().enumerate() {
        for other in grid.touching(boxes[one].grown(REACH)).filter(|other| *other > one) {
            if polygons_are_near(&region.polygon, &regions[other].polygon) {
                neighbours[one].push(other);
                neighbours[other].push(one);
            }
        }
    }
    neighbours.iter_mut().for_each(|list| list.sort_unstable());
    neighbours
}

/// The rectangle around a feature, half a line's width included.
fn bounds(shapes: &Shapes) -> Bounds {
    match shapes {
        Shapes::Areas(polygons) => polygons.iter().map(Polygon::bounds).fold(Bounds::EMPTY, Bounds::union),
        Shapes::Lines(lines, width) => Bounds::of(lines.iter().flatten().copied()).grown(width / 2.0),
        Shapes::Points(points) => Bounds::of(points.iter().copied()),
    }
}

fn is_near(polygon: &Polygon, shapes: &Shapes) -> bool {
    match shapes {
        Shapes::Areas(areas) => areas.iter().any(|area| polygons_are_near(polygon, area)),
        Shapes::Lines(lines, width) => lines.iter().any(|line| line_is_near(polygon, line, REACH + width / 2.0)),
        Shapes::Points(points) => points.iter().any(|p| polygon.contains(*p) || polygon.distance_to_edges(*p) <= REACH),
    }
}

fn line_is_near(polygon: &Polygon, line: &[DVec2], reach: f64) -> bool {
    let edges = line.windows(2).map(|w| (w[0], w[1]));
    line.first().is_some_and(|p| polygon.contains(*p))
        || edges_are_near(polygon.edges(), edges, Bounds::of(line.iter().copied()), reach)
}

/// Whether two polygons overlap or come within reach. One inside the other's hole does not count as inside.
fn polygons_are_near(a: &Polygon, b: &Polygon) -> bool {
    a.bounds().grown(REACH).touches(b.bounds())
        && (a.contains(b.outer()[0])
            || b.contains(a.outer()[0])
            || edges_are_near(a.edges(), b.edges(), b.bounds(), REACH))
}

/// Whether any two segments come within reach of each other; `window` holds all of `b`.
fn edges_are_near(
    a: impl Iterator<Item = (DVec2, DVec2)>,
    b: impl Iterator<Item = (DVec2, DVec2)>,
    window: Bounds,
    reach: f64,
) -> bool {
    let box_of = |(from, to): (DVec2, DVec2)| Bounds { min: from.min(to), max: from.max(to) };
    let window = window.grown(reach);
    let a: Vec<_> = a.filter(|edge| box_of(*edge).touches(window)).collect();
    let near = a.iter().copied().map(box_of).fold(Bounds::EMPTY, Bounds::union).grown(reach);
    let mut b = b.filter(|edge| box_of(*edge).touches(near));
    b.any(|edge| {
        let around = box_of(edge).grown(reach);
        a.iter().any(|other| box_of(*other).touches(around) && segments_are_near(edge, *other, reach))
    })
}

fn segments_are_near((a, b): (DVec2, DVec2), (c, d): (DVec2, DVec2), reach: f64) -> bool {
    let is_near = |p: DVec2, from, to| nearest_on_segment(p, from, to).distance_squared(p) <= reach * reach;
    let side = |p: DVec2, from: DVec2, to: DVec2| (to - from).perp_dot(p - from) > 0.0;
    let cross = side(a, c, d) != side(b, c, d) && side(c, a, b) != side(d, a, b);
    cross || is_near(a, c, d) || is_near(b, c, d) || is_near(c, a, b) || is_near(d, a, b)
}
