//! Shaped plants: what gardeners clip to circles, boxes and cones, and single flowers.

use crate::export::plan::drawing::Shape;
use crate::export::plan::ink::LIGHT;
use crate::export::plan::path::{Path, direction};
use crate::export::plan::symbol::outline::LEE;
use crate::export::plan::symbol::{BLOCK, Pencil};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, FRAC_PI_4, TAU};

impl Pencil {
    /// A tight, even outline.
    pub fn clipped(&mut self) -> Vec<Shape> {
        let outline = Path::circle(DVec2::ZERO, self.radius);
        let mut shapes = vec![Shape::filled(outline.clone(), self.wash())];
        shapes.extend(self.crescent(1.0, 0.24));
        if self.is_full() {
            shapes.extend(self.gleam(0.22));
            shapes.push(self.leaves());
        }
        if self.radius > 0.9 {
            let ring = Path::circle(DVec2::ZERO, self.radius * 0.8);
            shapes.push(Shape::drawn(ring, self.line().faded(0.35), self.width() * 0.6));
        }
        shapes.push(Shape::drawn(outline, self.line(), self.width()));
        if self.radius > 0.7 {
            shapes.push(self.trunk());
        }
        shapes
    }

    /// A square block with a bevelled rim, square to the plan.
    pub fn block(&mut self) -> Vec<Shape> {
        let corner = |i: u8, reach: f64| {
            direction(self.turn + FRAC_PI_4 + FRAC_PI_2 * f64::from(i)) * self.radius * reach * std::f64::consts::SQRT_2
        };
        let ring = |reach: f64| Path::ring(&std::array::from_fn::<_, 4, _>(|i| corner(i as u8, reach * BLOCK)));
        let mut shapes = vec![Shape::filled(ring(1.0), self.wash())];
        for side in 0..4u8 {
            let quad = [corner(side, BLOCK), corner(side + 1, BLOCK), corner(side + 1, 0.55), corner(side, 0.55)];
            shapes.push(self.facet(&quad));
        }
        shapes.push(Shape::drawn(ring(0.6), self.line().faded(0.45), self.width() * 0.7));
        shapes.push(Shape::drawn(ring(1.0), self.line(), self.width()));
        shapes
    }

    /// A cone from above: its facets turn from light to shade.
    pub fn cone(&mut self) -> Vec<Shape> {
        let count = if self.is_full() { 14 } else { 8 };
        let rim = |i: i32| direction(self.turn + TAU * f64::from(i) / f64::from(count)) * self.radius;
        let mut shapes = vec![Shape::filled(Path::circle(DVec2::ZERO, self.radius), self.wash())];
        shapes.extend((0..count).map(|i| self.facet(&[DVec2::ZERO, rim(i), rim(i + 1)])));
        let mut edges = Path::default();
        (0..count).for_each(|i| edges.add_line(&[rim(i) * 0.1, rim(i)], false));
        shapes.push(Shape::drawn(edges, self.line().faded(0.4), self.width() * 0.6));
        shapes.push(Shape::drawn(Path::circle(DVec2::ZERO, self.radius), self.line(), self.width()));
        shapes
    }

    /// A face as bright as its direction from the middle makes it.
    fn facet(&self, corners: &[DVec2]) -> Shape {
        let middle = corners.iter().sum::<DVec2>().normalize_or(DVec2::X);
        let shade = middle.dot(direction(LEE));
        let ink = if shade > 0.0 { self.ink.darker(0.6) } else { LIGHT };
        Shape::filled(Path::ring(corners), ink.faded(0.34 * shade.abs()))
    }

    /// Five petals.
    pub fn flower(&mut self) -> Vec<Shape> {
        let mut petals = Path::default();
        let start = self.random.uniform(0.0, TAU);
        for i in 0..5 {
            let towards = direction(start + TAU * f64::from(i) / 5.0);
            petals.add_circle(towards * self.radius * 0.55, self.radius * 0.45);
        }
        let heart = Path::circle(DVec2::ZERO, self.radius * 0.28);
        vec![
            Shape::filled(petals, self.ink).outlined(self.line().faded(0.5), self.width() * 0.5),
            Shape::filled(heart, self.ink.lighter(0.6)),
        ]
    }
}
