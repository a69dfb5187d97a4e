//! `setback`: moves chosen edges inwards and takes apart what they sweep from what remains.

use crate::ops::declare::operation;
use crate::ops::spec::PerEdge;
use crate::ops::{Apply, Component, Given, Pieces, Problem, rim};
use crate::shape::Shape;

operation! {
    /// Moves the selected edges of a flat shape inwards by a distance and takes the strips off.
    ///
    /// Edges that no selector takes stay where they are. Each strip of a `:` entry is a shape of its own whose x
    /// runs along its edge; `=` puts the strips of an entry together, `=:` those that hang together. `remainder` takes
    /// what is left, in the parent's frame. The parts sum to the whole.
    ///
    /// An array has a distance for each edge in their order, holes after the outline; edges beyond its end stay.
    /// ```cga
    /// Lot --> setback(4) { front : Hedge | side = Gravel | remainder : Lawn }
    /// ```
    "setback" (CityEngine, Selectors(&["remainder"])) => pub struct Setback {
        /// How far the edges move (metres), or an array with a distance for each edge.
        distance: PerEdge,
        /// The set of texture coordinates that `uv.…` words look at; where a shape has none they look along its plane.
        uv_set: u32 = 0 => "0",
    }
}

impl Apply for Setback {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let (plane, area) = rim::flat("setback", shape)?;
        rim::known_uv_set(self.uv_set)?;
        Ok(rim::components(shape, plane, area, self.uv_set))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        rim::set_back(shape, given, |edge| self.distance.at(edge)).map(Pieces::Parts)
    }
}
