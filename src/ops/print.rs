//! `print`: a value for who writes the rule.

use crate::ops::declare::operation;
use crate::ops::{Apply, Effect, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::value::Value;

operation! {
    /// Shows a value after the run, with the rule that printed it.
    /// ```cga
    /// Lot --> split(x) { { ~8 : print(geometry.area) Bed | 2 : Gravel }* }
    /// ```
    "print" (CityEngine, None) => pub struct PrintValue {
        /// The value.
        value: Value,
    }
}

impl Apply for PrintValue {
    fn apply(self, _: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        Ok(Pieces::Told(Effect::Print(self.value)))
    }
}
