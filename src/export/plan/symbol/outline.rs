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

    /// The crescent of shade on the lee side of a round crown of `reach` times the radius; large ones fade softly.
    pub fn crescent(&self, reach: f64, strength: f64) -> Vec<Shape> {
        let (steps, strength) = self.soft(strength);
        let ink = self.ink.darker(0.6).faded(strength);
        let moon = |share: f64| self.moon(self.radius * reach * (1.05 - 0.13 * share), 0.3 + 0.52 * share);
        steps.into_iter().map(|share| Shape::filled(moon(share), ink)).collect()
    }

    /// Steps from 0 to 1 for a soft edge, more for larger crowns, and the opacity of each that adds up to `strength`.
    fn soft(&self, strength: f64) -> (Vec<f64>, f64) {
        let count = (self.radius * 0.9).clamp(1.0, 9.0).floor();
        let steps = (0..count as usize).map(|i| (i as f64 + 0.5) / count).collect();
        (steps, 1.0 - libm::pow(1.0 - strength, 1.4 / (count + 0.4)))
    }

    /// A moon open to the light: `depth` says how far its inner rim is bent out.
    fn moon(&self, radius: f64, depth: f64) -> Path {
        let (along, spread) = (direction(LEE), 1.72);
        let handle = |side: f64| along * radius * depth + along.perp() * side * radius * 0.72;
        let mut path = Path::default();
        path.add_arc(DVec2::ZERO, radius, LEE - spread, LEE + spread);
        path.steps.push(Step::Curve(handle(1.0), handle(-1.0), radius * direction(LEE - spread)));
        path.steps.push(Step::Close);
        path
    }

    /// The light on the windward side; on large crowns it fades outwards.
    pub fn gleam(&mut self, strength: f64) -> Vec<Shape> {
        let (steps, strength) = self.soft(strength);
        let centre = direction(LEE) * self.radius * -0.32;
        let reaches: Vec<f64> = (0..11).map(|_| self.radius * self.random.uniform(0.5, 0.66)).collect();
        let blob = |share: f64| {
            let rim = reaches.iter().enumerate();
            let points =
                rim.map(|(i, reach)| centre + direction(TAU * i as f64 / 11.0) * *reach * (1.15 - share * 0.8));
            Shape::filled(Path::smooth_ring(&points.collect::<Vec<_>>()), LIGHT.faded(strength))
        };
        steps.into_iter().map(blob).collect()
    }

    /// The point where the trunk stands.
    pub fn trunk(&self) -> Shape {
        Shape::filled(Path::circle(DVec2::ZERO, (self.radius * 0.07).clamp(0.1, 0.32)), self.line())
    }

    /// Short arcs like clumps of leaves, thicker in the shade; as many as the crown's area on paper holds.
    pub fn leaves(&mut self) -> Shape {
        let count = (self.radius * self.radius * 2.4).clamp(8.0, 900.0) as usize;
        let size = (self.radius * 0.1).clamp(0.22, 1.0);
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
