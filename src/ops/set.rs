//! `set`: changes an attribute of a shape and its successors.

use crate::element::color_bytes;
use crate::ops::declare::operation;
use crate::ops::{Apply, AttributeName, Given, Pieces, Problem};
use crate::seed::Seed;
use crate::shape::Shape;
use crate::value::Value;
use std::sync::Arc;

operation! {
    /// Sets an attribute of the rule file, or one of the shape, for this shape and its successors.
    ///
    /// `set(material.name, "gravel")` says what a leaf is made of: a ground cover of the catalogue (`bosquet ops
    /// covers` lists them), or a word of your own.
    /// ```cga
    /// Lot  --> split(x) { ~1 : Court("gravel") | ~1 : Court("paving") | ~1 : Court("deck") }
    /// Court(word) --> set(material.name, word) Paved.
    /// ```
    "set" (CityEngine, None) => pub struct Set {
        /// The attribute.
        attribute: AttributeName,
        /// Its new value.
        value: Value,
    }
}

impl Apply for Set {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        match &self.attribute {
            AttributeName::Slot(slot) => match Arc::make_mut(&mut shape.attributes).get_mut(*slot) {
                Some(place) => *place = self.value,
                None => return Err(Problem::new("there is no such attribute")),
            },
            AttributeName::Shape(name) => built_in(shape, name, &self.value)?,
        }
        Ok(Pieces::Changed)
    }
}

/// Sets a shape attribute by its name.
pub(super) fn built_in(shape: &mut Shape, name: &str, value: &Value) -> Result<(), Problem> {
    let number = || value.as_float().ok_or_else(|| Problem::new(format!("`{name}` takes a number, found `{value}`")));
    if name == "seedian" {
        shape.seed = Seed(0).child(number()?.to_bits());
        return Ok(());
    }
    let style = Arc::make_mut(&mut shape.style);
    match name {
        "material.name" => style.material = Some(value.to_string().into()),
        "envelope.walls" => style.envelope.walls = number()?,
        "envelope.paving" => style.envelope.paving = number()?,
        "envelope.openings" => style.envelope.openings = number()?,
        "envelope.water" => style.envelope.water = number()?,
        "envelope.seams" => style.envelope.seams = truth(name, value)?,
        "trim.horizontal" => shape.surface_mut().trim[0] = Some(truth(name, value)?),
        "trim.vertical" => shape.surface_mut().trim[1] = Some(truth(name, value)?),
        "material.color.rgb" => style.color = Some(recoloured(style.color, &value.to_string())?),
        _ => {
            let channel = ["material.color.r", "material.color.g", "material.color.b", "material.opacity"];
            match (channel.iter().position(|c| *c == name), name.strip_prefix("material.")) {
                (Some(index), _) => style.color.get_or_insert([1.0; 4])[index] = number()?.clamp(0.0, 1.0) as f32,
                (_, Some(own)) => shape.surface_mut().put_material(own.into(), plain(value)),
                _ => return Err(Problem::new(format!("`{name}` cannot be set"))),
            }
        }
    }
    Ok(())
}

/// The colour of a text, with the opacity that there was where the text has none.
fn recoloured(old: Option<[f32; 4]>, text: &str) -> Result<[f32; 4], Problem> {
    let [r, g, b, said] = super::color::parse(text)?;
    let keeps = color_bytes(text).is_some_and(|bytes| bytes.len() == 3);
    let opacity = old.filter(|_| keeps).map_or(said, |[.., opacity]| opacity);
    Ok([r, g, b, opacity])
}

/// A bare word is a text by now.
fn plain(value: &Value) -> Value {
    if let Value::Word(word) = value { Value::Text(word.clone()) } else { value.clone() }
}

fn truth(name: &str, value: &Value) -> Result<bool, Problem> {
    value.as_bool().ok_or_else(|| Problem::new(format!("`{name}` takes `true` or `false`, found `{value}`")))
}
