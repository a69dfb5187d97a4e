//! How the inside of a surface is drawn: marks on paper, the same size at every scale.
//!
//! In comes a region on paper, out come items that stay inside of it. The same region with the same seed shows the
//! same marks. Regions too small for marks stay plain.

mod embroidery;
mod marks;
mod water;

use crate::export::plan::drawing::Item;
use crate::export::plan::ink::Ink;
use crate::geometry::{Area, Bounds};
use crate::scene::{Material, Texture};
use crate::seed::Seed;

/// Regions below this many mm² on paper stay plain.
const LEAST_AREA: f64 = 1.5;

/// What a texture needs to know.
pub struct Ground<'a> {
    /// The region on paper.
    pub area: &'a Area,
    /// The plan's window: nothing outside of it is drawn.
    pub window: Bounds,
    /// Colour of the surface.
    pub fill: Ink,
    /// Colour of its lines.
    pub line: Ink,
    /// Millimetres on paper per metre.
    pub metre: f64,
    /// Where its random numbers come from.
    pub seed: Seed,
}

impl Ground<'_> {
    /// The surface of a region with a material's colours.
    pub fn new<'a>(area: &'a Area, window: Bounds, material: &Material, metre: f64, id: &str) -> Ground<'a> {
        let (fill, line) = (Ink::of(material.fill), Ink::of(material.line));
        Ground { area, window, fill, line, metre, seed: Seed(0).named("plan texture").named(id) }
    }
}

/// The marks of a texture.
pub fn draw(texture: Texture, ground: &Ground) -> Vec<Item> {
    if ground.area.area() < LEAST_AREA || !ground.area.bounds().touches(ground.window) {
        return Vec::new();
    }
    match texture {
        Texture::Plain => Vec::new(),
        Texture::Stipple => marks::stipple(ground),
        Texture::Strokes => marks::strokes(ground),
        Texture::Ripples => water::ripples(ground),
        Texture::Hatch => marks::hatch(ground),
        Texture::Foliage => marks::foliage(ground),
        Texture::Embroidery => embroidery::scrolls(ground),
        Texture::Flowers => marks::flowers(ground),
    }
}
