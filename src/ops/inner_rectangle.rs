//! `innerRectangle` and `innerRect`: the largest rectangle inside.

use crate::geometry::{self, Area, Bounds, Polygon};
use crate::ops::declare::operation;
use crate::ops::gather::Gathered;
use crate::ops::shape_luo::shape_and_rest;
use crate::ops::spec::choice;
use crate::ops::{Apply, Component, Given, Pieces, Problem, fit, rim};
use crate::shape::{Geometry, Plane, Shape};
use glam::{DVec2, DVec3};

operation! {
    /// Finds the largest rectangle inside each part of a flat shape.
    ///
    /// `scope` looks for one along the scope's axes, `edge` for one along any edge that is longer than a quarter of the
    /// longest of its outline or hole. `shape` takes the rectangle, `remainder` what is around it. It is exact in
    /// convex shapes and to a millimetre in others; no side of it can be moved outwards.
    /// ```cga
    /// Lot   --> s(36, 0, 28) center(xz) primitiveDisk(48) Round
    /// Round --> innerRectangle(scope) { shape : Lawn | remainder : Bed }
    /// ```
    "innerRectangle" (CityEngine, Selectors(&["shape", "remainder"])) => pub struct InnerRectangle {
        /// What its sides run along.
        alignment: Alignment,
    }
}

operation! {
    /// Replaces a flat shape by the largest rectangle inside along the scope's axes.
    ///
    /// Older rules write it; `innerRectangle` keeps the rest as well. Where nothing fits the shape is deleted.
    /// ```cga
    /// Lot --> shapeL(16, 14) { shape : Meadow innerRect Lawn | remainder : Gravel }
    /// ```
    "innerRect" (CityEngine, None) => pub struct InnerRect {}
}

choice! {
    /// What the sides of an inner rectangle run along.
    pub enum Alignment {
        /// The scope's axes.
        Scope = "scope",
        /// An edge.
        Edge = "edge",
    }
}

/// Edges that turn by less than this sine from another run along it, or across it.
const SAME_WAY: f64 = 1e-6;

impl Apply for InnerRectangle {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        Ok(shape_and_rest(shape))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (plane, area) = rim::flat("innerRectangle", shape)?;
        let mut gathered = Gathered::new(shape, plane);
        for polygon in area.polygons() {
            let ways = match self.alignment {
                Alignment::Scope => vec![across(plane)],
                Alignment::Edge => ways(polygon),
            };
            let (found, along) = largest(polygon, &ways);
            let rest = geometry::difference(&polygon.clone().into(), &found);
            let turned = (self.alignment == Alignment::Edge).then_some(along);
            given.chosen[0].into_iter().for_each(|choice| gathered.add(choice, found.clone(), turned));
            given.chosen[1].into_iter().for_each(|choice| gathered.rest(choice, rest.clone()));
        }
        Ok(Pieces::Parts(gathered.parts()))
    }
}

impl Apply for InnerRect {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let (plane, area) = rim::flat("innerRect", shape)?;
        let found = area.polygons().iter().flat_map(|polygon| largest(polygon, &[across(plane)]).0.into_polygons());
        let geometry = Geometry::Flat(plane.clone(), found.collect());
        fit::refit(shape, geometry);
        Ok(Pieces::left_of(shape))
    }
}

/// The scope's x, or what comes next to it, in a plane.
fn across(plane: &Plane) -> DVec2 {
    let (u, v) = plane.axes();
    let seen = |axis: DVec3| DVec2::new(axis.dot(u), axis.dot(v));
    let x = seen(DVec3::X);
    if x.length() > 0.1 { x.normalize() } else { seen(DVec3::Z).normalize_or(DVec2::X) }
}

/// The ways that the longer edges of each ring run, without those along or across one before.
fn ways(polygon: &Polygon) -> Vec<DVec2> {
    let mut ways: Vec<DVec2> = Vec::new();
    for ring in polygon.rings() {
        let edges: Vec<DVec2> = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| *b - *a).collect();
        let longest = edges.iter().map(|edge| edge.length()).fold(0.0, f64::max);
        for way in edges.iter().filter(|edge| edge.length() > 0.25 * longest).filter_map(|edge| edge.try_normalize()) {
            let known = |old: &DVec2| old.perp_dot(way).abs() < SAME_WAY || old.dot(way).abs() < SAME_WAY;
            if !ways.iter().any(known) {
                ways.push(way);
            }
        }
    }
    ways
}

/// The largest rectangle along any of the ways, and its way; the first where several are as large.
fn largest(polygon: &Polygon, ways: &[DVec2]) -> (Area, DVec2) {
    let mut best: Option<(f64, DVec2, Bounds)> = None;
    for way in ways {
        let turned = polygon.mapped(|p| DVec2::new(way.dot(p), way.perp_dot(p)));
        let Some(found) = geometry::inner_rectangle(&turned) else { continue };
        let area = found.size().element_product();
        if best.is_none_or(|(largest, ..)| area > largest * (1.0 + 1e-9)) {
            best = Some((area, *way, found));
        }
    }
    let Some((_, way, found)) = best else { return (Area::empty(), DVec2::X) };
    let back = |p: DVec2| way * p.x + way.perp() * p.y;
    let rectangle = Polygon::rectangle(found.min, found.max).map(|rectangle| rectangle.mapped(back));
    (rectangle.into_iter().collect(), way)
}
