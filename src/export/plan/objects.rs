//! Furniture and architectural objects, each with a small drawing of its own kind inside its footprint.

use crate::export::plan::drawing::{Group, Item, Layer, Shape};
use crate::export::plan::ink::{Ink, LIGHT};
use crate::export::plan::path::{Path, direction};
use crate::export::plan::sheet::Sheet;
use crate::geometry::{Area, Bounds};
use crate::scene::Object;
use crate::text::number;
use glam::DVec2;
use std::f64::consts::TAU;

/// Objects are drawn at least this large on paper, millimetres.
const LEAST: f64 = 0.7;

/// All objects of a scene.
pub fn layer(objects: &[Object], sheet: &Sheet) -> Layer {
    let items = objects.iter().filter_map(|object| draw(object, sheet)).collect();
    Layer { items, ..Layer::new("objects", "Objects") }
}

fn draw(object: &Object, sheet: &Sheet) -> Option<Item> {
    let at = sheet.frame.point(object.position);
    let size = DVec2::new(sheet.frame.length(object.size[0]), sheet.frame.length(object.size[2]));
    if !at.is_finite() || !size.is_finite() || !sheet.window.grown(size.length()).contains(at) {
        return None;
    }
    let piece = Piece::new(at, size, sheet.frame.turn(object.heading), Ink::of(object.color));
    let title = Some(format!("{}, height {} m", object.label, number(object.size[1], 1)));
    let items = piece.draw(&object.category, &sheet.frame.area(&object.footprint));
    Some(Group { class: format!("object {}", object.category), title, clip: None, items }.into())
}

/// An object's place, half size and direction on paper.
pub struct Piece {
    at: DVec2,
    half: DVec2,
    along: DVec2,
    ink: Ink,
}

impl Piece {
    /// A piece of `size` millimetres, turned clockwise on paper by so many degrees.
    pub fn new(at: DVec2, size: DVec2, turn: f64, ink: Ink) -> Piece {
        Piece { at, half: size.abs().max(DVec2::splat(LEAST)) / 2.0, along: direction(turn.to_radians()), ink }
    }

    /// The drawing for a category of the catalogue; others show their footprint.
    pub fn draw(&self, category: &str, footprint: &Area) -> Vec<Item> {
        let shapes = match category {
            "bench" => self.bench(),
            "fountain" | "jet" => self.fountain(),
            "statue" | "sculpture" => self.statue(),
            "vase" | "urn" | "lamp" => self.round(),
            "obelisk" | "pedestal" => self.obelisk(),
            "caisse" | "planter" | "planter-box" | "planter_box" => self.planter(),
            "boulder" | "rock" => self.boulder(),
            _ => self.other(footprint),
        };
        shapes.into_iter().map(Item::from).collect()
    }

    fn point(&self, x: f64, y: f64) -> DVec2 {
        self.at + self.along * (x * self.half.x) + self.along.perp() * (y * self.half.y)
    }

    fn box_of(&self, share: f64) -> Path {
        Path::ring(&[(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)].map(|(x, y)| self.point(x * share, y * share)))
    }

    fn radius(&self) -> f64 {
        self.half.min_element()
    }

    fn line(&self) -> Ink {
        Ink { alpha: 255, ..self.ink.darker(0.6) }
    }

    /// A seat of three slats.
    fn bench(&self) -> Vec<Shape> {
        let mut slats = Path::default();
        for y in [-0.33, 0.33] {
            slats.add_line(&[self.point(-1.0, y), self.point(1.0, y)], false);
        }
        vec![
            Shape::filled(self.box_of(1.0), self.ink).outlined(self.line(), 0.1),
            Shape::drawn(slats, self.line().faded(0.6), 0.06),
        ]
    }

    /// Rings on the water and drops around the jet.
    fn fountain(&self) -> Vec<Shape> {
        let (mut rings, mut drops) = (Path::default(), Path::default());
        [0.55, 1.0].iter().for_each(|share| rings.add_circle(self.at, self.radius() * share));
        for i in 0..12 {
            let towards = direction(TAU * f64::from(i) / 12.0) * self.radius();
            drops.add_line(&[self.at + towards * 0.3, self.at + towards * 0.46], false);
        }
        vec![
            Shape::filled(Path::circle(self.at, self.radius()), LIGHT.faded(0.35)),
            Shape::drawn(rings, self.line().faded(0.6), 0.08),
            Shape::drawn(drops, self.line().faded(0.8), 0.08),
            Shape::filled(Path::circle(self.at, (self.radius() * 0.14).max(0.12)), self.line()),
        ]
    }

    /// A plinth and the figure on it.
    fn statue(&self) -> Vec<Shape> {
        vec![
            Shape::filled(self.box_of(1.0), LIGHT).outlined(self.line(), 0.12),
            Shape::filled(Path::circle(self.at, self.radius() * 0.56), self.line()),
        ]
    }

    fn round(&self) -> Vec<Shape> {
        vec![
            Shape::filled(Path::circle(self.at, self.radius()), self.ink).outlined(self.line(), 0.1),
            Shape::filled(Path::circle(self.at, self.radius() * 0.35), self.line()),
        ]
    }

    /// A square with its diagonals.
    fn obelisk(&self) -> Vec<Shape> {
        let mut ridges = Path::line(&[self.point(-1.0, -1.0), self.point(1.0, 1.0)]);
        ridges.append(&Path::line(&[self.point(-1.0, 1.0), self.point(1.0, -1.0)]));
        vec![
            Shape::filled(self.box_of(1.0), self.ink).outlined(self.line(), 0.12),
            Shape::drawn(ridges, self.line(), 0.08),
        ]
    }

    /// A box with a round crown in it.
    fn planter(&self) -> Vec<Shape> {
        vec![
            Shape::filled(self.box_of(1.0), self.ink).outlined(self.line(), 0.1),
            Shape::drawn(Path::circle(self.at, self.radius() * 0.72), self.line().faded(0.7), 0.07),
        ]
    }

    fn boulder(&self) -> Vec<Shape> {
        let rim: [DVec2; 7] = std::array::from_fn(|i| {
            let corner = direction(TAU * i as f64 / 7.0) * if i % 2 == 0 { 1.0 } else { 0.82 };
            self.point(corner.x, corner.y)
        });
        vec![Shape::filled(Path::ring(&rim), self.ink).outlined(self.line(), 0.1)]
    }

    /// The footprint, or a box of the object's size where it has none that shows.
    fn other(&self, footprint: &Area) -> Vec<Shape> {
        let shows = Bounds::size(footprint.bounds()).min_element() >= LEAST * 0.6;
        let path = if shows { Path::area(footprint) } else { self.box_of(1.0) };
        vec![Shape::filled(path, self.ink).outlined(self.line(), 0.1)]
    }
}
