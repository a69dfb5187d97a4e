//! `I`: inserts an element by category, type and instance.

use crate::ops::declare::operation;
use crate::ops::insert::{not_found, place};
use crate::ops::{Apply, Given, Pieces, Problem, Word};
use crate::shape::Shape;
use glam::DVec3;

operation! {
    /// Inserts an element of the catalogue by category, type and instance.
    ///
    /// Ulmer et al. 2007, §2.2: each plant has three types by age (young, medium, adult) and several appearances of
    /// each, so `rand(7)` chooses one of the first seven. Plants stand with their own size about the middle of the
    /// scope; other elements fill a scope that has a size.
    /// ```cga
    /// Lot --> split(x) { ~1 : Row("young") | ~1 : Row("medium") | ~1 : Row("adult") }
    /// Row(type) --> [ split(z) { { ~10 : center(xz) I(birch, type, rand(7)) }* } ] Lawn
    /// ```
    "I" (Added, None) => pub struct Instance {
        /// What: a category, a species, an id.
        category: Word,
        /// The type: `young`, `medium`, `adult`, or a form.
        kind: Word,
        /// Which of the appearances, from 0; fractions are cut off.
        instance: f64 = 0.0 => "0",
    }
}

impl Apply for Instance {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let found = given.catalogue.find(&self.category.0, &self.kind.0).map_err(not_found)?;
        let appearance = found.entry.appearance(found.variant, self.instance.max(0.0).floor() as u32);
        let own = DVec3::from(found.variant.size) * DVec3::new(appearance.crown, appearance.height, appearance.crown);
        let plant = found.variant.plant.is_some();
        if plant {
            let middle = DVec3::new(shape.scope.size.x * 0.5, 0.0, shape.scope.size.z * 0.5);
            shape.scope.frame = shape.scope.frame.moved(middle);
            shape.scope.size = DVec3::ZERO;
        }
        place(shape, &found, appearance.index, own, plant);
        Ok(Pieces::Changed)
    }
}
