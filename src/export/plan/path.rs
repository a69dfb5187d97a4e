//! Paths on paper: straight and curved steps in millimetres, x right and y down.
//!
//! What comes in are points; what goes out are steps both backends understand. A path knows neither colour nor width.

use crate::geometry::Area;
use glam::DVec2;
use std::f64::consts::{PI, TAU};

/// One step of the pen.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Step {
    /// Lifts the pen and starts anew.
    Move(DVec2),
    /// A straight line.
    Line(DVec2),
    /// A cubic Bézier curve: two handles and the end.
    Curve(DVec2, DVec2, DVec2),
    /// Back to where the pen was last set down.
    Close,
}

/// A path of one or several strokes or rings.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Path {
    /// The steps; each stroke starts with a move.
    pub steps: Vec<Step>,
}

impl Path {
    /// A line through the points; empty for fewer than two.
    pub fn line(points: &[DVec2]) -> Path {
        let mut path = Path::default();
        path.add_line(points, false);
        path
    }

    /// A closed ring of straight edges.
    pub fn ring(points: &[DVec2]) -> Path {
        let mut path = Path::default();
        path.add_line(points, true);
        path
    }

    /// A closed smooth ring through the points (Catmull–Rom).
    pub fn smooth_ring(points: &[DVec2]) -> Path {
        let mut path = Path::default();
        path.add_smooth(points, true);
        path
    }

    /// All rings of a region that is already in paper coordinates.
    pub fn area(area: &Area) -> Path {
        let mut path = Path::default();
        for ring in area.polygons().iter().flat_map(|p| p.rings()) {
            path.add_line(ring, true);
        }
        path
    }

    /// What lies in the outer region and not in the inner one, which must be part of it.
    pub fn band(outer: &Area, inner: &Area) -> Path {
        let mut path = Path::area(outer);
        for ring in inner.polygons().iter().flat_map(|p| p.rings()) {
            path.add_line(&ring.iter().rev().copied().collect::<Vec<_>>(), true);
        }
        path
    }

    /// A rectangle from its upper left corner.
    pub fn rectangle(at: DVec2, size: DVec2) -> Path {
        let corner = |x: f64, y: f64| at + DVec2::new(x, y) * size;
        Path::ring(&[corner(0.0, 0.0), corner(1.0, 0.0), corner(1.0, 1.0), corner(0.0, 1.0)])
    }

    /// A circle.
    pub fn circle(centre: DVec2, radius: f64) -> Path {
        let mut path = Path::default();
        path.add_circle(centre, radius);
        path
    }

    /// Adds a line through the points, closed to a ring if wanted.
    pub fn add_line(&mut self, points: &[DVec2], closed: bool) {
        let [first, rest @ ..] = points else { return };
        if rest.is_empty() {
            return;
        }
        self.steps.push(Step::Move(*first));
        self.steps.extend(rest.iter().map(|p| Step::Line(*p)));
        if closed {
            self.steps.push(Step::Close);
        }
    }

    /// Adds a smooth curve through the points, closed to a ring if wanted.
    pub fn add_smooth(&mut self, points: &[DVec2], closed: bool) {
        let count = points.len();
        if count < 3 {
            return self.add_line(points, false);
        }
        let at = |i: isize| match closed {
            true => points[i.rem_euclid(count as isize) as usize],
            false => points[i.clamp(0, count as isize - 1) as usize],
        };
        self.steps.push(Step::Move(points[0]));
        for i in 0..(if closed { count } else { count - 1 }) as isize {
            let (before, from, to, after) = (at(i - 1), at(i), at(i + 1), at(i + 2));
            self.steps.push(Step::Curve(from + (to - before) / 6.0, to - (after - from) / 6.0, to));
        }
        if closed {
            self.steps.push(Step::Close);
        }
    }

    /// Adds a circle.
    pub fn add_circle(&mut self, centre: DVec2, radius: f64) {
        self.add_arc(centre, radius, 0.0, TAU);
        self.steps.push(Step::Close);
    }

    /// Adds an arc from one angle to another, radians, clockwise on paper where `to` is the greater.
    pub fn add_arc(&mut self, centre: DVec2, radius: f64, from: f64, to: f64) {
        self.steps.push(Step::Move(centre + radius * direction(from)));
        self.continue_arc(centre, radius, from, to);
    }

    /// The same without lifting the pen, which must stand at the arc's start.
    pub fn continue_arc(&mut self, centre: DVec2, radius: f64, from: f64, to: f64) {
        let pieces = ((to - from).abs() / (PI / 2.0)).ceil().max(1.0);
        let step = (to - from) / pieces;
        let handle = radius * 4.0 / 3.0 * libm::tan(step / 4.0);
        for piece in 0..pieces as usize {
            let (a, b) = (direction(from + step * piece as f64), direction(from + step * (piece + 1) as f64));
            let (start, end) = (centre + radius * a, centre + radius * b);
            self.steps.push(Step::Curve(start + handle * a.perp(), end - handle * b.perp(), end));
        }
    }

    /// Adds a mark so short that its round ends make it a dot.
    pub fn add_dot(&mut self, at: DVec2) {
        self.steps.extend([Step::Move(at), Step::Line(at + DVec2::new(0.01, 0.0))]);
    }

    /// Takes in the steps of another path.
    pub fn append(&mut self, other: &Path) {
        self.steps.extend_from_slice(&other.steps);
    }

    /// Whether there is nothing to draw.
    pub fn is_empty(&self) -> bool {
        self.steps.is_empty()
    }

    /// The same with every point moved by `map`.
    pub fn mapped(&self, map: impl Fn(DVec2) -> DVec2) -> Path {
        let step = |step: &Step| match *step {
            Step::Move(p) => Step::Move(map(p)),
            Step::Line(p) => Step::Line(map(p)),
            Step::Curve(a, b, p) => Step::Curve(map(a), map(b), map(p)),
            Step::Close => Step::Close,
        };
        Path { steps: self.steps.iter().map(step).collect() }
    }

    /// The same with points on a grid of a fiftieth of a millimetre: marks that carry no measure need no more.
    pub fn coarse(&self) -> Path {
        self.coarse_to(0.02)
    }

    /// The same with points on a grid of `step` millimetres.
    pub fn coarse_to(&self, step: f64) -> Path {
        self.mapped(|p| (p / step).round() * step)
    }
}

/// The unit vector at an angle in radians, clockwise on paper from the right.
pub fn direction(angle: f64) -> DVec2 {
    let (sin, cos) = libm::sincos(angle);
    DVec2::new(cos, sin)
}
