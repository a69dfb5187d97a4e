//! What is measured along: hedges and walls.

use crate::element::{Material, Texture};
use crate::geometry::{Area, Polygon};

/// A sort of solid that people measure in metres.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Strip {
    /// Clipped plants.
    Hedge,
    /// Walls, fences, treillage.
    Wall,
}

/// Parts of the names of materials that make walls.
const WALLS: [&str; 5] = ["wall", "fence", "treillage", "railing", "balustrade"];

impl Strip {
    /// Whether a solid of that material is measured along.
    pub fn of(material: &Material) -> Option<Strip> {
        if material.texture == Texture::Foliage {
            return Some(Strip::Hedge);
        }
        WALLS.iter().any(|wall| material.name.contains(wall)).then_some(Strip::Wall)
    }
}

/// The length of a strip of even width along its middle; of one that closes on itself, half its perimeter. Metres; a
/// square's side for a square. Bent strips are taken to have square ends.
pub fn strip_length(strip: &Area) -> f64 {
    strip.polygons().iter().map(polygon_length).sum()
}

fn polygon_length(strip: &Polygon) -> f64 {
    // A straight strip, mitred or square at its ends, is as long in the middle as its area over its width.
    if let (true, Some(around)) = (strip.is_convex() && !strip.has_holes(), strip.oriented_box()) {
        return strip.area() / around.size.min_element();
    }
    // Half the perimeter of a strip l long and w wide is l + w, its area l·w: l is the greater root.
    let half = strip.perimeter() / 2.0;
    if strip.has_holes() {
        return half;
    }
    (half + (half * half - 4.0 * strip.area()).max(0.0).sqrt()) / 2.0
}
