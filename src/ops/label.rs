//! `label`: gives a shape a name that occlusion queries find it by.

use crate::ops::declare::operation;
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Word};
use crate::shape::Shape;
use std::sync::Arc;

operation! {
    /// From here on `inside`, `overlaps` and `touches` find the shape, as it is now, under this name.
    /// ```cga
    /// Lot  --> [ s(16, 0, 16) center(xz) primitiveDisk(48) label("open") Gravel ] Rest
    /// Rest --> semirandom(radius = 2.5, avoid = "open") { plant("lime") } without("open") Lawn
    /// ```
    "label" (CityEngine, None) => pub struct Label {
        /// The name.
        name: Word,
    }
}

impl Apply for Label {
    const LABELS: bool = true;

    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        Arc::make_mut(&mut shape.style).label = Some(self.name.0.clone());
        Ok(Pieces::Told(Effect::Label(self.name.0)))
    }
}
