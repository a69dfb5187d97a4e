//! Outlines and shades that several symbols share; all around the origin, millimetres.

use crate::export::plan::drawing::Shape;
use crate::export::plan::ink::LIGHT;
use crate::export::plan::path::{Path, Step, direction};
use crate::export::plan::symbol::Pencil;
use glam::DVec2;
use std::f64::consts::{FRAC_PI_4, TAU};

/// The direction shadows fall in on paper: south-east.
pub const LEE: f64 = FRAC_PI_4;

impl Pencil {
    /// A ring of `lobes` scallops; `depth` is how far the notches reach in, as a share of the radius.
    pub fn scalloped(&mut self, lobes: usize, depth: f64) -> Path {
        let start = self.random.uniform(0.0, TAU);
        let pitch = TAU / lobes as f64;
        let notches: Vec<(f64, f64)> = (0..lobes)
            .map(|i| {
                let angle = start + pitch * (i as f64 + self.random.uniform(-0.22, 0.22));
                (angle, self.radius * (1.0 - depth * self.random.uniform(0.6, 1.4)))
            })
            .collect();
        let mut path = Path::default();
        path.steps.push(Step::Move(notches[0].1 * direction(notches[0].0)));
        for i in 0..lobes {
            let ((from, low), (next, end)) = (notches[i], notches[(i + 1) % lobes]);
            let to = if i + 1 == lobes { next + TAU } else { next };
            let bulge = self.radius * self.random.uniform(0.99, 1.09) + (self.radius - low.min(end)) * 0.3;
            let handle = |share: f64| bulge * direction(from + (to - from) * share);
            path.steps.push(Step::Curve(handle(0.16), handle(0.84), end * direction(to)));
        }
        path.steps.push(Step::Close);
        path
    }

    /// The crescent of shade on the lee side of a round crown of `reach` times the radius.
    pub fn crescent(&self, reach: f64, strength: f64) -> Shape {
        let (radius, spread) = (self.radius * reach, 1.72);
        let along = direction(LEE);
        let handle = |side: f64| along * radius * 0.56 + along.perp() * side * radius * 0.72;
        let mut path = Path::default();
        path.add_arc(DVec2::ZERO, radius, LEE - spread, LEE + spread);
        path.steps.push(Step::Curve(handle(1.0), handle(-1.0), radius * direction(LEE - spread)));
        path.steps.push(Step::Close);
        Shape::filled(path, self.ink.darker(0.6).faded(strength))
    }

    /// The light on the windward side.
    pub fn gleam(&mut self, strength: f64) -> Shape {
        let centre = direction(LEE) * self.radius * -0.3;
        let points: Vec<DVec2> = (0..9)
            .map(|i| centre + direction(TAU * f64::from(i) / 9.0) * self.radius * self.random.uniform(0.4, 0.58))
            .collect();
        Shape::filled(Path::smooth_ring(&points), LIGHT.faded(strength))
    }

    /// The point where the trunk stands.
    pub fn trunk(&self) -> Shape {
        Shape::filled(Path::circle(DVec2::ZERO, (self.radius * 0.07).clamp(0.1, 0.32)), self.line())
    }

    /// Short arcs like clumps of leaves, thicker in the shade.
    pub fn leaves(&mut self, count: usize, size: f64) -> Shape {
        let mut path = Path::default();
        let lee = direction(LEE);
        let mut tries = count * 4;
        let mut left = count;
        while left > 0 && tries > 0 {
            tries -= 1;
            let (angle, reach) = (self.random.uniform(0.0, TAU), self.random.unit().sqrt() * 0.8);
            let at = direction(angle) * reach * self.radius;
            let shade = 0.55 + 0.45 * at.dot(lee) / self.radius;
            if self.random.unit() < shade {
                let towards = LEE + self.random.uniform(-0.7, 0.7);
                let radius = size * self.random.uniform(0.75, 1.25);
                path.add_arc(at - direction(towards) * radius, radius, towards - 0.95, towards + 0.95);
                left -= 1;
            }
        }
        Shape::drawn(path, self.line().faded(0.55), self.width() * 0.8)
    }
}
