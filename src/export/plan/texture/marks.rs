//! Strewn marks: dots of gravel, tufts of grass, leaves and flowers, and plain hatching.

use crate::export::plan::drawing::{Item, Shape};
use crate::export::plan::field;
use crate::export::plan::ink::{Ink, LIGHT};
use crate::export::plan::path::{Path, direction};
use crate::export::plan::texture::Ground;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

/// The colours of flower beds: rose, straw, cream, lilac.
const PETALS: [Ink; 4] = [Ink::hex(0xc4737a), Ink::hex(0xdcb45a), Ink::hex(0xfaf3df), Ink::hex(0x9a86ad)];

/// Sparse dots in two sizes: gravel and sand.
pub fn stipple(ground: &Ground) -> Vec<Item> {
    let (mut fine, mut bold) = (Path::default(), Path::default());
    for (point, mut random) in field::strewn(ground.area, ground.window, 1.05, 0.2, ground.seed) {
        match random.unit() {
            x if x < 0.62 => fine.add_dot(point),
            x if x < 0.8 => bold.add_dot(point),
            _ => {}
        }
    }
    let ink = ground.line.darker(0.25);
    lines([(fine, ink.faded(0.42), 0.12), (bold, ink.faded(0.5), 0.17)])
}

/// Tufts of two or three strokes: meadow and rough grass.
pub fn strokes(ground: &Ground) -> Vec<Item> {
    let mut path = Path::default();
    for (foot, mut random) in field::strewn(ground.area, ground.window, 1.9, 0.35, ground.seed) {
        let blades = 2 + random.below(2);
        for blade in 0..blades {
            let lean = (blade as f64 - (blades - 1) as f64 / 2.0) * 0.42 + random.uniform(-0.12, 0.12);
            let tip = foot + direction(lean - FRAC_PI_2) * random.uniform(0.4, 0.72);
            path.add_line(&[foot + DVec2::new(lean * 0.25, 0.0), tip], false);
        }
    }
    lines([(path, ground.line.darker(0.1).faded(0.55), 0.09)])
}

/// Small leaves, dark and light: hedges and clipped masses.
pub fn foliage(ground: &Ground) -> Vec<Item> {
    let (mut dark, mut light) = (Path::default(), Path::default());
    for (point, mut random) in field::strewn(ground.area, ground.window, 0.62, 0.14, ground.seed) {
        let from = random.uniform(0.0, TAU);
        let radius = random.uniform(0.12, 0.2);
        match random.unit() < 0.68 {
            true => dark.add_arc(point, radius, from, from + 2.4),
            false => light.add_arc(point, radius * 0.8, from, from + 2.0),
        }
    }
    lines([(dark, ground.line.darker(0.25).faded(0.55), 0.09), (light, LIGHT.faded(0.4), 0.1)])
}

/// Tiny flowers between tiny leaves: beds.
pub fn flowers(ground: &Ground) -> Vec<Item> {
    let mut leaves = Path::default();
    let mut petals: [Path; 4] = Default::default();
    for (point, mut random) in field::strewn(ground.area, ground.window, 0.85, 0.2, ground.seed) {
        match random.choose(&[5.0, 3.0, 1.6, 1.4, 1.0]) {
            Some(kind @ 1..) => petals[kind - 1].add_dot(point),
            _ => leaves.add_arc(point, 0.14, point.x, point.x + 2.5),
        }
    }
    let mut items = lines([(leaves, Ink::hex(0x5d7048).faded(0.7), 0.1)]);
    for (path, ink) in petals.into_iter().zip(PETALS).filter(|(p, _)| !p.is_empty()) {
        items.push(Shape::drawn(path.coarse(), ink, 0.36).into());
    }
    items
}

/// Parallel lines at forty-five degrees.
pub fn hatch(ground: &Ground) -> Vec<Item> {
    let mut path = Path::default();
    for line in field::hatched(ground.area, direction(-FRAC_PI_4), 0.9, 0.0) {
        path.add_line(&line, false);
    }
    lines([(path, ground.line.faded(0.5), 0.08)])
}

fn lines<const N: usize>(paths: [(Path, Ink, f64); N]) -> Vec<Item> {
    let drawn = paths.into_iter().filter(|(path, ..)| !path.is_empty());
    drawn.map(|(path, ink, width)| Shape::drawn(path.coarse(), ink, width).into()).collect()
}
