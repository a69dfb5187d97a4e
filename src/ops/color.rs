//! `color`: the colour of a shape and its successors.

use crate::element::parse_color;
use crate::ops::declare::operation;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::Shape;
use crate::value::Value;
use std::sync::Arc;

operation! {
    /// Sets the colour: `"#rrggbb"`, `"#rrggbboo"` with an opacity, or red, green, blue and opacity from 0 to 1.
    /// ```cga
    /// Lot --> split(x) { ~1 : Strip("#d98c8c") | ~1 : Strip("#e8c66a") | ~1 : Strip("#8fb3d9") }
    /// Strip(colour) --> color(colour) Tulips.
    /// ```
    "color" (CityEngine, None) => pub struct Color {
        /// A text `"#rrggbb"`, or red, 0 to 1.
        color: Value,
        /// Green, 0 to 1.
        green: f64 = 0.0 => "0",
        /// Blue, 0 to 1.
        blue: f64 = 0.0 => "0",
        /// Opacity, 0 to 1.
        opacity: f64 = 1.0 => "1",
    }
}

impl Apply for Color {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let color = match (self.color.as_str(), self.color.as_float()) {
            (Some(text), _) => parse(text)?,
            (None, Some(red)) => [red, self.green, self.blue, self.opacity].map(|c| c.clamp(0.0, 1.0) as f32),
            _ => return Err(Problem::new(format!("`{}` is not a colour", self.color))),
        };
        Arc::make_mut(&mut shape.style).color = Some(color);
        Ok(Pieces::Changed)
    }
}

/// `"#rrggbb"` or `"#rrggbboo"`.
pub(super) fn parse(text: &str) -> Result<[f32; 4], Problem> {
    parse_color(text).ok_or_else(|| Problem::new(format!("`{text}` is not a colour")).hint("as in `\"#9bb86b\"`"))
}
