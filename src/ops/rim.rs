//! The edges of flat shapes: as components that selectors choose among, and moved inwards. What the setbacks share.

use crate::geometry::{self, Area, Bounds, Polygon};
use crate::ops::gather::Gathered;
use crate::ops::{Component, Given, Part, Problem, RoofEdge, Selectors, comp};
use crate::shape::{Geometry, Plane, Shape};
use glam::{DVec2, DVec3};

/// Edges nearer than this (metres) to a side of the bounds lie on it.
const ON_SIDE: f64 = 1e-6;

/// What is tilted by less than this sine against level or upright is no slope.
pub const LEAST_SLOPE: f64 = 0.02;

/// Whether a face with that height of its unit normal is a slope: it looks up and is neither level nor upright.
pub fn is_slope(rise: f64) -> bool {
    rise > LEAST_SLOPE && rise * rise < 1.0 - LEAST_SLOPE * LEAST_SLOPE
}

/// The plane and region of a flat shape; `name` is the operation that asks.
pub fn flat<'s>(name: &str, shape: &'s Shape) -> Result<(&'s Plane, &'s Area), Problem> {
    match &shape.geometry {
        Geometry::Flat(plane, area) => Ok((plane, area)),
        _ => {
            Err(Problem::new(format!("`{name}` takes flat shapes"))
                .hint("`comp(f) { top : … }` takes a face of a solid"))
        }
    }
}

/// Whether there can be a set of texture coordinates of that number.
pub fn known_uv_set(number: u32) -> Result<(), Problem> {
    match number {
        0..=9 => Ok(()),
        _ => Err(Problem::new(format!("there is no set {number} of texture coordinates")).hint("they are 0 to 9")),
    }
}

/// Every edge as a component, polygon by polygon, and then what they leave, under `remainder`.
pub fn components(shape: &Shape, plane: &Plane, area: &Area, uv_set: u32) -> Vec<Component> {
    let mut found = along(shape, plane, area, &area.twins(), uv_set);
    found.push(Component { shape: shape.clone(), selectors: Selectors::none(), words: &["remainder"] });
    found
}

/// Every edge of every polygon as a component, counted in `comp.index`. One without length is a point, so that edges
/// keep their numbers.
pub fn edges(shape: &Shape, plane: &Plane, area: &Area) -> Vec<Component> {
    along(shape, plane, area, &area.twins(), 0)
}

/// The same with what two polygons have in common once.
pub fn edges_once(shape: &Shape, plane: &Plane, area: &Area) -> Vec<Component> {
    let twins = area.twins();
    let is_second = |index: usize| twins.get(index).copied().flatten().is_some_and(|twin| twin < index);
    let found = (0..).zip(along(shape, plane, area, &twins, 0));
    found.filter(|(index, _)| !is_second(*index)).map(|(_, component)| component).collect()
}

fn along(shape: &Shape, plane: &Plane, area: &Area, twins: &[Option<usize>], uv_set: u32) -> Vec<Component> {
    let normal = plane.normal();
    let chart = shape.attached().and_then(|surface| surface.chart(uv_set));
    let uv = |p: DVec2| chart.map_or(p, |chart| chart.uv(shape.scope.frame.to_world(plane.at(p))));
    let bounds = chart.map_or_else(|| area.bounds(), |_| Bounds::of(area.edges().map(|(a, _)| uv(a))));
    let tilted = is_slope((shape.scope.frame.rotation * normal).y);
    let mut found = Vec::new();
    for polygon in area.polygons() {
        let outer = polygon.outer().len();
        for (index, (a, b)) in polygon.edges().enumerate() {
            let (from, to) = (plane.at(a), plane.at(b));
            let mut component = comp::edge(shape, from, to, (to - from).cross(normal));
            let is_shared = twins.get(found.len()).is_some_and(Option::is_some);
            component.selectors = match index < outer && !is_shared {
                true => component.selectors.border(),
                false => component.selectors.inside(),
            };
            component.selectors = with_uv(component.selectors, uv(a), uv(b), bounds);
            if tilted && is_eave(shape, from, to, normal) {
                component.selectors = component.selectors.roof(RoofEdge::Eave);
            }
            found.push(component);
        }
    }
    comp::numbered(&mut found);
    found
}

/// Whether an edge is the level lower end of a tilted plane.
fn is_eave(shape: &Shape, from: DVec3, to: DVec3, normal: DVec3) -> bool {
    let turn = shape.scope.frame.rotation;
    let along = (turn * (to - from)).normalize_or_zero();
    along.y.abs() < LEAST_SLOPE && (turn * (to - from).cross(normal)).y < 0.0
}

/// The `uv.…` words of an edge: without texture coordinates u and v are those of the plane.
fn with_uv(selectors: Selectors, a: DVec2, b: DVec2, bounds: Bounds) -> Selectors {
    let out = -(b - a).perp();
    let looks = match out.x.abs() >= out.y.abs() {
        true => usize::from(out.x > 0.0),
        false => 2 + usize::from(out.y > 0.0),
    };
    let on = |from: f64, to: f64, side: f64| (from - side).abs() < ON_SIDE && (to - side).abs() < ON_SIDE;
    let sides = [
        on(a.x, b.x, bounds.min.x),
        on(a.x, b.x, bounds.max.x),
        on(a.y, b.y, bounds.min.y),
        on(a.y, b.y, bounds.max.y),
    ];
    (0..4).filter(|side| sides[*side]).fold(selectors.uv(looks), |words, side| words.uv(4 + side))
}

/// The strips of the chosen edges, each as far as its distance says, and what remains, for the entries that chose them.
///
/// Distances are metres by edge over all polygons; those of edges that no selector took do not count.
pub fn set_back(shape: &Shape, given: &Given, distance: impl Fn(usize) -> f64) -> Result<Vec<Part>, Problem> {
    let (plane, area) = flat("setback", shape)?;
    let (mut first, mut gathered) = (0, Gathered::new(shape, plane));
    let mut remainder = Area::empty();
    for polygon in area.polygons() {
        let count = polygon.points().len();
        let chosen = &given.chosen[first..first + count];
        let moved = moved(polygon, |edge| if chosen[edge].is_some() { distance(first + edge) } else { 0.0 })?;
        for strip in moved.strips {
            let (a, b) = polygon.edge(strip.edge);
            chosen[strip.edge].into_iter().for_each(|choice| gathered.add(choice, strip.area.clone(), Some(b - a)));
        }
        moved.remainder.polygons().iter().for_each(|p| remainder.push(p.clone()));
        first += count;
    }
    if let Some(Some(choice)) = given.chosen.last() {
        gathered.rest(*choice, remainder);
    }
    Ok(gathered.parts())
}

/// The setback of one polygon, after a look at the distances.
fn moved(polygon: &Polygon, distance: impl Fn(usize) -> f64) -> Result<geometry::Setback, Problem> {
    let count = polygon.points().len();
    match (0..count).map(&distance).find(|metres| !(metres.is_finite() && *metres >= 0.0)) {
        Some(metres) => {
            Err(Problem::new(format!("a setback of {metres} m cannot be done")).hint("`offset` grows a shape"))
        }
        None => Ok(geometry::setback(polygon, distance)),
    }
}
