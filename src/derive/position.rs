//! Arguments that may vary over a shape: a number where they do not ask for the position, else a grid of numbers.

use crate::check::Code;
use crate::derive::evaluate::{Failure, evaluate, number};
use crate::derive::frame::Frame;
use crate::diag::Span;
use crate::functions::At;
use crate::geometry::Area;
use crate::ops::Ground;
use crate::placement::Grid;
use crate::value::Value;
use glam::DVec2;
use std::cell::Cell;

/// Metres between the nodes of a grid, where the shape is not too large for that.
const STEP: f64 = 0.5;
/// Nodes along one axis at most.
const MOST_NODES: usize = 400;

/// An argument on a shape.
pub(super) enum Varied {
    /// It is the same everywhere.
    Same(Value),
    /// It was sampled over the shape.
    Grid(Grid),
}

/// The value of an argument on the current shape of a lot with that outline.
pub(super) fn vary(code: &Code, span: Span, frame: &mut Frame, outline: &Area) -> Result<Varied, Failure> {
    let ground = Ground::of_path(frame.shape, outline).map_or_else(|| Ground::of(frame.shape), |(g, _)| Ok(g));
    let Ok(ground) = ground else {
        return frame.with(|names, around| evaluate(code, names, around)).map(Varied::Same);
    };
    let bounds = ground.area.bounds();
    let (value, asked) =
        at(frame, &ground, bounds.centre(), |frame| frame.with(|names, around| evaluate(code, names, around)));
    if !asked {
        return value.map(Varied::Same);
    }
    let nodes = |length: f64| ((length / STEP).ceil() as usize + 1).clamp(2, MOST_NODES);
    let size = [nodes(bounds.size().x), nodes(bounds.size().y)];
    let value = |p: DVec2| at(frame, &ground, p, |frame| frame.with(|n, a| number(code, n, a, span))).0;
    Grid::sample(bounds, size, value).map(Varied::Grid)
}

/// Does something at a place of the ground, and says whether it asked for the place.
fn at<T>(frame: &mut Frame, ground: &Ground, p: DVec2, act: impl FnOnce(&mut Frame) -> T) -> (T, bool) {
    let local = ground.local(p);
    let (local, size) = (DVec2::new(local.x, local.z), frame.shape.scope.size);
    let share = |x: f64, length: f64| if length > 0.0 { (x / length).clamp(0.0, 1.0) } else { 0.0 };
    let share = DVec2::new(share(local.x, size.x), share(local.y, size.z));
    let place = At { plan: p, local, share, area: &ground.area, asked: Cell::new(false) };
    let mut inner = Frame { at: Some(&place), ..frame.reborrow() };
    let result = act(&mut inner);
    (result, place.asked.get())
}
