//! Free crowns: broadleaf trees, fine-leaved trees, conifers, palms and shrubs.

use crate::export::plan::drawing::Shape;
use crate::export::plan::path::{Path, Step, direction};
use crate::export::plan::symbol::Pencil;
use glam::DVec2;
use std::f64::consts::TAU;

impl Pencil {
    /// A softly lobed crown.
    pub fn broadleaf(&mut self) -> Vec<Shape> {
        let lobes = self.teeth(2.8, 8, 56) + self.random.below(3) as usize;
        let outline = self.scalloped(lobes, 0.62 / lobes as f64);
        let mut shapes = vec![Shape::filled(outline.clone(), self.wash())];
        shapes.extend(self.crescent(0.93, if self.is_full() { 0.2 } else { 0.24 }));
        if self.is_full() {
            shapes.extend(self.gleam(0.26));
            shapes.push(self.leaves());
        }
        shapes.push(Shape::drawn(outline, self.line(), self.width()));
        if self.radius > 0.9 {
            shapes.push(self.trunk());
        }
        shapes
    }

    /// A thin, open crown whose branches show.
    pub fn feathery(&mut self) -> Vec<Shape> {
        let outline = self.scalloped(self.teeth(1.1, 12, 60), 0.05);
        let mut shapes = vec![Shape::filled(outline.clone(), self.wash().faded(0.85))];
        shapes.extend(self.crescent(0.93, 0.15));
        if self.is_full() {
            shapes.extend(self.gleam(0.22));
        }
        let branches = self.branches(if self.is_full() { 8 } else { 5 });
        shapes.push(Shape::drawn(branches, self.line().faded(0.7), self.width() * 0.75));
        shapes.push(Shape::drawn(outline, self.line().faded(0.8), self.width() * 0.8));
        shapes
    }

    /// Branches from the trunk, forking towards the rim.
    fn branches(&mut self, count: usize) -> Path {
        let (mut path, start) = (Path::default(), self.random.uniform(0.0, TAU));
        for i in 0..count {
            let angle = start + TAU * (i as f64 + self.random.uniform(-0.2, 0.2)) / count as f64;
            let end = direction(angle) * self.radius * self.random.uniform(0.8, 0.94);
            path.add_line(&[DVec2::ZERO, end], false);
            for (share, side) in [(0.38, 0.75), (0.52, -0.7), (0.7, 0.6)] {
                if self.is_full() {
                    let foot = end * share;
                    path.add_line(&[foot, foot + direction(angle + side) * self.radius * (0.98 - share) * 0.6], false);
                }
            }
        }
        path
    }

    /// A star of needles.
    pub fn conifer(&mut self) -> Vec<Shape> {
        let points = self.teeth(1.6, 9, 40) as u32;
        let start = self.random.uniform(0.0, TAU);
        let (mut ring, mut needles) = (Vec::new(), Path::default());
        for i in 0..points {
            let angle = start + TAU * (f64::from(i) + self.random.uniform(-0.15, 0.15)) / f64::from(points);
            let tip = direction(angle) * self.radius * self.random.uniform(0.94, 1.04);
            ring.extend([tip, direction(angle + TAU * 0.5 / f64::from(points)) * self.radius * 0.78]);
            needles.add_line(&[tip * 0.12, tip * 0.9], false);
        }
        let outline = Path::ring(&ring);
        let mut shapes = vec![Shape::filled(outline.clone(), self.wash())];
        shapes.extend(self.crescent(0.84, 0.26));
        if self.is_full() {
            shapes.extend(self.gleam(0.16));
            let inner = ring.iter().map(|p| *p * 0.56).collect::<Vec<_>>();
            shapes.push(Shape::drawn(Path::ring(&inner), self.line().faded(0.4), self.width() * 0.7));
        }
        shapes.push(Shape::drawn(needles, self.line().faded(0.6), self.width() * 0.7));
        shapes.push(Shape::drawn(outline, self.line(), self.width() * 0.9));
        shapes
    }

    /// A wheel of fronds.
    pub fn palm(&mut self) -> Vec<Shape> {
        let count = if self.is_full() { 11 } else { 7 };
        let start = self.random.uniform(0.0, TAU);
        let (mut fronds, mut ribs) = (Path::default(), Path::default());
        for i in 0..count {
            let angle = start + TAU * (f64::from(i) + self.random.uniform(-0.12, 0.12)) / f64::from(count);
            let tip = direction(angle) * self.radius * self.random.uniform(0.92, 1.04);
            let side = tip.perp() * if self.is_full() { 0.17 } else { 0.2 };
            let bend = tip.perp() * self.random.uniform(-0.1, 0.1);
            fronds.steps.extend([
                Step::Move(tip * 0.04),
                Step::Curve(tip * 0.35 + side + bend, tip * 0.75 + side * 0.9 + bend, tip),
                Step::Curve(tip * 0.75 - side * 0.9 + bend, tip * 0.35 - side + bend, tip * 0.04),
                Step::Close,
            ]);
            ribs.steps.extend([Step::Move(DVec2::ZERO), Step::Curve(tip * 0.35 + bend, tip * 0.7 + bend, tip * 0.95)]);
        }
        let fronds = Shape::filled(fronds, self.wash()).outlined(self.line(), self.width() * 0.8);
        vec![fronds, Shape::drawn(ribs, self.line().faded(0.55), self.width() * 0.6), self.trunk()]
    }

    /// A small ring.
    pub fn shrub(&mut self) -> Vec<Shape> {
        let outline = self.scalloped(self.teeth(2.2, 6, 30), 0.08);
        let mut shapes = vec![Shape::filled(outline.clone(), self.wash())];
        shapes.extend(self.crescent(0.9, 0.2));
        if self.is_full() {
            shapes.extend(self.gleam(0.2));
            shapes.push(self.leaves());
        } else if self.radius > 0.7 {
            let ring = Path::circle(DVec2::ZERO, self.radius * 0.42);
            shapes.push(Shape::drawn(ring, self.line().faded(0.5), self.width() * 0.8));
        }
        shapes.push(Shape::drawn(outline, self.line(), self.width() * 0.9));
        shapes
    }
}
