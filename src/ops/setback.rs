//! `setback`: moves chosen edges inwards and takes apart what they sweep from what remains.

use crate::geometry::{self, Area, Polygon};
use crate::ops::declare::operation;
use crate::ops::{Apply, Component, Given, Part, Pieces, Problem, Selectors, fit};
use crate::shape::{Geometry, Plane, Shape};
use crate::unit::Metres;
use glam::DVec2;
use std::collections::BTreeMap;

operation! {
    /// Moves the selected edges of a flat shape inwards by a distance and takes the strips off.
    ///
    /// Edges that no selector takes stay where they are. Each strip of a `:` entry is a shape of its own whose x
    /// runs along its edge; `=` puts the strips of an entry together. `remainder` takes what is left, in the
    /// parent's frame. The parts sum to the whole.
    /// ```cga
    /// Garden --> setback(1.5) { front : Hedge | remainder : Lawn }
    /// ```
    "setback" (CityEngine, Selectors(&["remainder"])) => pub struct Setback {
        /// How far the edges move (metres).
        distance: Metres,
    }
}

impl Apply for Setback {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let (plane, area) = flat(shape)?;
        let normal = plane.normal();
        let mut found = Vec::new();
        for polygon in area.polygons() {
            let outer = polygon.outer().len();
            for (index, (a, b)) in polygon.edges().enumerate() {
                let outward = (plane.at(b) - plane.at(a)).cross(normal).normalize_or_zero();
                let selectors = Selectors::of_normal(outward, shape);
                let selectors = if index < outer { selectors.border() } else { selectors.inside() };
                let mut child = fit::point(shape, plane.at(a));
                child.scope.size.x = a.distance(b);
                found.push(Component { shape: child, selectors, words: &[] });
            }
        }
        found.push(Component { shape: shape.clone(), selectors: Selectors::none(), words: &["remainder"] });
        Ok(found)
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (plane, area) = flat(shape)?;
        let distance = self.distance.0;
        if !(distance.is_finite() && distance >= 0.0) {
            return Err(
                Problem::new(format!("a setback of {distance} m cannot be done")).hint("`offset` grows a shape")
            );
        }
        let (mut first, mut parts) = (0, Vec::new());
        let mut together: BTreeMap<u16, Vec<Area>> = BTreeMap::new();
        let mut remainder = Area::empty();
        for polygon in area.polygons() {
            let edges: Vec<(DVec2, DVec2)> = polygon.edges().collect();
            let chosen = &given.chosen[first..first + edges.len()];
            let moved = self::moved(polygon, chosen, distance);
            for strip in moved.strips {
                let Some(choice) = chosen[strip.edge] else { continue };
                let (a, b) = edges[strip.edge];
                match choice.together {
                    true => together.entry(choice.entry).or_default().push(strip.area),
                    false => {
                        parts.extend(fit::aligned(shape, plane, &strip.area, b - a).map(|s| Part::new(choice.entry, s)))
                    }
                }
            }
            moved.remainder.polygons().iter().for_each(|p| remainder.push(p.clone()));
            first += edges.len();
        }
        for (entry, areas) in together {
            let whole = Geometry::Flat(plane.clone(), geometry::union_all(&areas));
            parts.extend(fit::fitted(shape, whole).map(|shape| Part::new(entry, shape)));
        }
        if let Some(Some(choice)) = given.chosen.last() {
            let rest = fit::fitted(shape, Geometry::Flat(plane.clone(), remainder));
            parts.extend(rest.map(|shape| Part::new(choice.entry, shape)));
        }
        let total = parts.len() as u32;
        (0..).zip(&mut parts).for_each(|(index, part)| part.shape.ordinals.comp = (index, total));
        Ok(Pieces::Parts(parts))
    }
}

fn moved(polygon: &Polygon, chosen: &[Option<crate::ops::Choice>], distance: f64) -> geometry::Setback {
    geometry::setback(polygon, |edge| if chosen[edge].is_some() { distance } else { 0.0 })
}

fn flat(shape: &Shape) -> Result<(&Plane, &Area), Problem> {
    match &shape.geometry {
        Geometry::Flat(plane, area) => Ok((plane, area)),
        _ => Err(Problem::new("`setback` takes flat shapes").hint("`comp(f) { top : … }` takes a face of a solid")),
    }
}
