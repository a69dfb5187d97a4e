//! How plans draw things: the materials of surfaces and solids, and the symbols of plants.
//!
//! The catalogue names them by their words; scenes carry them; drawings read them.

use crate::element::words::words;
use std::sync::Arc;

/// What a surface or solid is made of, as the catalogue describes it.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// The catalogue's word (`gravel`, `lawn`, `water`, `hedge`, `building` …) or the user's own.
    pub name: Arc<str>,
    /// The name people read in legends.
    pub label: Arc<str>,
    /// Fill colour, sRGB and opacity in 0 to 1.
    pub fill: [f32; 4],
    /// Outline colour.
    pub line: [f32; 4],
    /// Outline width in millimetres on paper; 0 draws none.
    pub line_width: f32,
    /// How a plan draws its inside.
    pub texture: Texture,
}

/// How a plan draws the inside of a surface.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Texture {
    /// Plain colour.
    #[default]
    Plain,
    /// Sparse dots: gravel, sand.
    Stipple,
    /// Short strokes: meadow, rough grass.
    Strokes,
    /// Lines parallel to the shore: water.
    Ripples,
    /// Hatched: roofs.
    Hatch,
    /// Small leaves: hedges, clipped masses.
    Foliage,
    /// Arabesques: embroidery of box on gravel.
    Embroidery,
    /// Tiny flowers: beds.
    Flowers,
}

words!(Texture {
    Plain = "plain",
    Stipple = "stipple",
    Strokes = "strokes",
    Ripples = "ripples",
    Hatch = "hatch",
    Foliage = "foliage",
    Embroidery = "embroidery",
    Flowers = "flowers",
});

/// How a plan draws a plant.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum PlantSymbol {
    /// A softly lobed crown.
    #[default]
    Broadleaf,
    /// A crown of fine branches.
    Feathery,
    /// A star of needles.
    Conifer,
    /// A wheel of fronds.
    Palm,
    /// A tight, even outline: clipped trees.
    Clipped,
    /// A square block: trees clipped to boxes.
    Box,
    /// A pyramid from above: a cone with its edges.
    Cone,
    /// A small ring.
    Shrub,
    /// A dot.
    Flower,
}

words!(PlantSymbol {
    Broadleaf = "broadleaf",
    Feathery = "feathery",
    Conifer = "conifer",
    Palm = "palm",
    Clipped = "clipped",
    Box = "box",
    Cone = "cone",
    Shrub = "shrub",
    Flower = "flower",
});
