//! `texture`, `setMaterial`, `resetMaterial`: what a surface looks like beyond its colour.
//!
//! It is kept for scenes; plans show the material's name and colour.

use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem, set};
use crate::shape::Shape;
use crate::value::{Array, Cells, Value};
use std::sync::Arc;

operation! {
    /// Sets the texture of the shape: `material.colormap`. Scenes carry it, plans do not show it.
    /// ```cga
    /// Lot --> setback(5) { all = texture("setts.jpg") color("#c9c2b2") Court. | remainder : Lawn }
    /// ```
    "texture" (CityEngine, None) => pub struct SetTexture {
        /// The picture's file.
        path: Value,
    }
}

operation! {
    /// Sets several attributes of the material: rows of a name and a value, as `getMaterial` gives them, or the name of
    /// a material.
    /// ```cga
    /// Lot --> split(x) { ~1 : setMaterial("gravel") Court. | ~1 : setMaterial("deck") Court. }
    /// ```
    "setMaterial" (CityEngine, None) => pub struct SetMaterial {
        /// An array of texts with two columns, or a name.
        material: Value,
    }
}

operation! {
    /// Takes colour, material and all textures back to what a shape begins with.
    /// ```cga
    /// Lot --> set(material.name, "gravel") [ s('0.5, 0, '1) resetMaterial() Lawn ] t('0.5, 0, 0) s('0.5, 0, '1) Court.
    /// ```
    "resetMaterial" (CityEngine, None) => pub struct ResetMaterial {}
}

impl Apply for SetTexture {
    const UNSEEN: bool = true;

    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        shape.surface_mut().put_material("colormap".into(), Value::text(self.path.to_string()));
        Ok(Pieces::Changed)
    }
}

impl Apply for SetMaterial {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        match &self.material {
            Value::Array(array) => rows(shape, array)?,
            name => set::built_in(shape, "material.name", name)?,
        }
        Ok(Pieces::Changed)
    }
}

impl Apply for ResetMaterial {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let style = Arc::make_mut(&mut shape.style);
        (style.color, style.material) = (None, None);
        if style.surface.as_ref().is_some_and(|surface| !surface.material.is_empty()) {
            shape.surface_mut().material.clear();
        }
        Ok(Pieces::Changed)
    }
}

/// A name and a value in each row; numbers and truth values are read back from their texts.
fn rows(shape: &mut Shape, array: &Array) -> Result<(), Problem> {
    let (Cells::Texts(texts), 2) = (array.cells(), array.columns()) else {
        let message = format!("a material has rows of a name and a value, found {}", array.type_name());
        return Err(Problem::new(message).hint("`getMaterial()` gives one"));
    };
    for pair in texts.chunks_exact(2) {
        let name = format!("material.{}", pair[0].trim_start_matches("material."));
        let value = match (pair[1].parse::<f64>(), &*pair[1]) {
            (Ok(number), _) => Value::Float(number),
            (_, "true" | "false") => Value::Bool(&*pair[1] == "true"),
            _ => Value::Text(pair[1].clone()),
        };
        set::built_in(shape, &name, &value)?;
    }
    Ok(())
}
