//! `setbackPerEdge`: a setback whose distance is asked on every edge.

use crate::ops::declare::operation;
use crate::ops::spec::OnEdges;
use crate::ops::{Apply, Component, Given, Pieces, Problem, rim};
use crate::shape::Shape;

operation! {
    /// Moves each selected edge of a flat shape inwards by a distance of its own.
    ///
    /// The distance is evaluated with the edge as the current shape: `scope.sx` is its length, `comp.index` its number,
    /// `rand` draws anew. All else is as in `setback`.
    /// ```cga
    /// Lot --> setbackPerEdge(case scope.sx > 35 : 8 else : 3) { all : Bed | remainder : Lawn }
    /// ```
    "setbackPerEdge" (CityEngine, Selectors(&["remainder"])) => pub struct SetbackPerEdge {
        /// How far the edge moves (metres).
        distance: OnEdges,
        /// The set of texture coordinates that `uv.…` words look at.
        uv_set: u32 = 0 => "0",
    }
}

impl Apply for SetbackPerEdge {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let (plane, area) = rim::flat("setbackPerEdge", shape)?;
        rim::known_uv_set(self.uv_set)?;
        Ok(rim::components(shape, plane, area, self.uv_set))
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        rim::set_back(shape, given, |edge| self.distance.at(edge)).map(Pieces::Parts)
    }
}
