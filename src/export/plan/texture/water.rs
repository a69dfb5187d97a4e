//! Water: lines that follow the shore and fade towards the middle, as engravers draw them.

use crate::export::plan::drawing::{Item, Shape};
use crate::export::plan::ink::LIGHT;
use crate::export::plan::path::Path;
use crate::export::plan::texture::Ground;
use crate::geometry::{Area, inset};

/// Distances from the shore in millimetres, each with its line's width and opacity.
const SHORE: [(f64, f64, f64); 7] = [
    (0.35, 0.11, 0.75),
    (0.8, 0.10, 0.6),
    (1.4, 0.09, 0.48),
    (2.2, 0.08, 0.38),
    (3.3, 0.07, 0.3),
    (4.8, 0.07, 0.22),
    (6.8, 0.06, 0.16),
];

/// A darker rim, shore lines, and a light middle.
pub fn ripples(ground: &Ground) -> Vec<Item> {
    let mut items = Vec::new();
    for depth in [1.0, 2.4, 5.0] {
        let middle = inset(ground.area, depth);
        if !middle.is_empty() {
            items.push(Shape::filled(Path::area(&middle), LIGHT.faded(0.12)).into());
        }
    }
    for (distance, width, opacity) in SHORE {
        let line: Area = inset(ground.area, distance);
        if line.is_empty() {
            break;
        }
        items.push(Shape::drawn(Path::area(&line), ground.line.faded(opacity), width).into());
    }
    items
}
