//! `shapeL`, `shapeU` and `shapeO`: wings along the sides of a shape.

use crate::geometry::{self, Area};
use crate::ops::declare::operation;
use crate::ops::gather::Gathered;
use crate::ops::{Apply, Component, Given, Pieces, Problem, Selectors, rim};
use crate::shape::Shape;
use crate::unit::Metres;

operation! {
    /// Takes an L off a flat shape: wings along its front and its left side.
    ///
    /// `shape` takes the wings, `remainder` what they leave; the two sum to the whole. The sides are those of the scope,
    /// and only the outline counts, not holes. A wing of 0 is none.
    /// ```cga
    /// Lot   --> shapeL(12, 10) { shape : Wing | remainder : Lawn }
    /// Wing --> set(material.name, "building") extrude(6) roofHip(35) House.
    /// ```
    "shapeL" (CityEngine, Selectors(&["shape", "remainder"])) => pub struct ShapeL {
        /// Depth of the front wing (metres).
        front: Metres,
        /// Depth of the left wing (metres).
        left: Metres,
    }
}

operation! {
    /// Takes a U off a flat shape: wings along its front and both sides.
    ///
    /// All else is as in `shapeL`.
    /// ```cga
    /// Lot --> shapeU(8, 6, 6) { shape : Bed | remainder : Lawn }
    /// ```
    "shapeU" (CityEngine, Selectors(&["shape", "remainder"])) => pub struct ShapeU {
        /// Depth of the front wing (metres).
        front: Metres,
        /// Depth of the right wing (metres).
        right: Metres,
        /// Depth of the left wing (metres).
        left: Metres,
    }
}

operation! {
    /// Takes a ring off a flat shape: wings along all four sides.
    ///
    /// All else is as in `shapeL`.
    /// ```cga
    /// Lot --> shapeO(3, 5, 3, 5) { shape : Gravel | remainder : Court }
    /// Court --> shapeO(1, 1, 1, 1) { shape : Hedge | remainder : Lawn }
    /// ```
    "shapeO" (CityEngine, Selectors(&["shape", "remainder"])) => pub struct ShapeO {
        /// Depth of the front wing (metres).
        front: Metres,
        /// Depth of the right wing (metres).
        right: Metres,
        /// Depth of the back wing (metres).
        back: Metres,
        /// Depth of the left wing (metres).
        left: Metres,
    }
}

impl Apply for ShapeL {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        Ok(shape_and_rest(shape))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        wings("shapeL", shape, given, [("front", self.front), ("left", self.left)])
    }
}

impl Apply for ShapeU {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        Ok(shape_and_rest(shape))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        wings("shapeU", shape, given, [("front", self.front), ("right", self.right), ("left", self.left)])
    }
}

impl Apply for ShapeO {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        Ok(shape_and_rest(shape))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let sides = [("front", self.front), ("right", self.right), ("back", self.back), ("left", self.left)];
        wings("shapeO", shape, given, sides)
    }
}

/// What an operation finds and what it leaves, under `shape` and `remainder`.
pub(super) fn shape_and_rest(shape: &Shape) -> Vec<Component> {
    let component = |words| Component { shape: shape.clone(), selectors: Selectors::none(), words };
    vec![component(&["shape"]), component(&["remainder"])]
}

fn wings<const N: usize>(
    name: &str,
    shape: &Shape,
    given: &Given,
    sides: [(&str, Metres); N],
) -> Result<Pieces, Problem> {
    if let Some((side, depth)) = sides.iter().find(|(_, depth)| !(depth.0.is_finite() && depth.0 >= 0.0)) {
        let message = format!("a wing of {} m on the {side} cannot be made", depth.0);
        return Err(Problem::new(message).hint("0 makes none"));
    }
    let (plane, area) = rim::flat(name, shape)?;
    let edges = rim::edges(shape, plane, area);
    let (mut first, mut gathered) = (0, Gathered::new(shape, plane));
    for polygon in area.polygons() {
        let outer = polygon.outer().len();
        let looks = |edge: usize, side: &str| {
            // On an upright face the front lies at the bottom and the back at the top.
            let upright = match side {
                "front" => "bottom",
                "back" => "top",
                side => side,
            };
            let mut words = [side, upright].into_iter().filter_map(Selectors::of_word);
            words.any(|word| edges[first + edge].selectors.meets(word))
        };
        let depth = |edge: usize| {
            let side = sides.iter().filter(|_| edge < outer).find(|(side, _)| looks(edge, side));
            side.map_or(0.0, |(_, depth)| depth.0)
        };
        let moved = geometry::setback(polygon, depth);
        let strips: Vec<Area> = moved.strips.into_iter().map(|strip| strip.area).collect();
        if let Some(choice) = given.chosen[0] {
            gathered.add(choice, geometry::union_all(&strips), None);
        }
        if let Some(choice) = given.chosen[1] {
            gathered.rest(choice, moved.remainder);
        }
        first += polygon.points().len();
    }
    Ok(Pieces::Parts(gathered.parts()))
}
