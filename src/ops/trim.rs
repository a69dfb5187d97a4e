//! `trim`: accepted, and said to change nothing.
//!
//! CityEngine gives faces planes along the edges that they share, and cuts what is built on them there. Faces here carry
//! no such planes: what is built on a wall is not cut at the corner, on the plan as in the scene.

use crate::ops::declare::operation;
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Remark};
use crate::shape::Shape;

operation! {
    /// Cuts along the trim planes that faces have in CityEngine; here it changes nothing, and a note says so.
    ///
    /// `setback` mitres strips at their corners by itself, and `subtract` takes one shape off another.
    /// ```cga
    /// Lot --> [ Lawn ] s('0.5, 4, '0.5) center(xz) set(material.name, "building") primitiveCube trim Pavilion.
    /// ```
    "trim" (CityEngine, None) => pub struct Trim {}
}

impl Apply for Trim {
    fn apply(self, _: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let message = "`trim` changes nothing: faces have no trim planes here".to_string();
        Ok(Pieces::Told(Effect::Remark(Remark { message, parameter: None, is_note: true })))
    }
}
