//! `report`: a value for the report.

use crate::ops::declare::operation;
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Word};
use crate::shape::Shape;
use crate::value::Value;

operation! {
    /// Adds a value to the report under a key: numbers are summed and counted, texts counted.
    /// ```cga
    /// Lot --> split(x) { ~1 : Lawn | ~1 : report("bed area", geometry.area) Bed | ~1 : Lawn }
    /// ```
    "report" (CityEngine, None) => pub struct ReportValue {
        /// The key.
        key: Word,
        /// The value.
        value: Value,
    }
}

impl Apply for ReportValue {
    fn apply(self, _: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        Ok(Pieces::Told(Effect::Report(self.key.0, self.value)))
    }
}
