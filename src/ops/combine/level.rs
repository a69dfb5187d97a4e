//! Areas and prisms over one plane as levels, and set operations on them: exact, layer by layer.
//!
//! A level is an area between two heights above the plane; a flat shape is a level without height. Between any two
//! heights at which something begins or ends the sets are plane areas, and there their operation is a plane one.

use crate::geometry::{self, Area};
use crate::ops::combine::stack::{Layer, stacked};
use crate::ops::fit;
use crate::shape::{Geometry, Plane, Shape};
use glam::{DAffine2, DVec2, DVec3};
use std::sync::Arc;

/// Heights nearer than this (metres) are the same.
const SAME: f64 = 1e-6;

/// What is kept of two sets.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Keep {
    /// What lies in either.
    Either,
    /// What lies in the first but not in the second.
    First,
    /// What lies in both.
    Common,
}

/// An area from a height to another above the plane.
#[derive(Clone, Debug)]
struct Level {
    area: Area,
    low: f64,
    high: f64,
}

/// Levels over a plane of a shape.
#[derive(Clone, Debug)]
pub struct Levels {
    plane: Plane,
    levels: Vec<Level>,
}

impl Levels {
    /// No level at all.
    pub fn none() -> Levels {
        Levels { plane: Plane::Ground, levels: Vec::new() }
    }

    /// The plane that shapes are measured over, in the coordinates of `base`: its own, or else the first shape's.
    pub fn plane(shapes: &[Shape], base: &Shape) -> Option<Plane> {
        if let Geometry::Flat(plane, _) | Geometry::Prism(plane, ..) = &base.geometry {
            return Some(plane.clone());
        }
        let first = shapes.first()?;
        let (Geometry::Flat(plane, _) | Geometry::Prism(plane, ..)) = &first.geometry else { return None };
        let local = |p: DVec3| base.scope.frame.to_local(first.scope.frame.to_world(p));
        let origin = local(plane.at(DVec2::ZERO));
        let axis = |along: DVec2| local(plane.at(along)) - origin;
        Some(Plane::Free(Arc::new([origin, axis(DVec2::X), axis(DVec2::Y)])))
    }

    /// The levels of shapes in the coordinates of `base`; `None` where one is neither flat nor a prism over the plane.
    pub fn of(shapes: &[Shape], base: &Shape) -> Option<Levels> {
        Levels::over(shapes, base, &Levels::plane(shapes, base)?)
    }

    /// The same over a given plane.
    pub fn over(shapes: &[Shape], base: &Shape, plane: &Plane) -> Option<Levels> {
        let levels = shapes.iter().map(|shape| level(shape, base, plane)).collect::<Option<_>>()?;
        Some(Levels { plane: plane.clone(), levels })
    }

    /// The areas side by side; `None` where they overlap or lie at different heights.
    pub fn beside(self) -> Option<Levels> {
        let first = self.levels.first()?.clone();
        let alike = |level: &Level| (level.low - first.low).abs() < SAME && (level.high - first.high).abs() < SAME;
        let areas: Vec<&Area> = self.levels.iter().map(|level| &level.area).collect();
        let sum: f64 = areas.iter().map(|area| area.area()).sum();
        let covered = geometry::union_all(areas.iter().copied()).area();
        if !self.levels.iter().all(alike) || sum - covered > SAME * (1.0 + sum) {
            return None;
        }
        let area = areas.into_iter().flat_map(Area::polygons).cloned().collect();
        Some(Levels { levels: vec![Level { area, ..first }], ..self })
    }

    /// A set operation; `None` where flat shapes at different heights, or flat ones and solids, cannot be put together.
    pub fn combined(&self, other: &Levels, keep: Keep) -> Option<Levels> {
        let flat = |levels: &Levels| levels.levels.iter().all(|level| level.high - level.low < SAME);
        let levels = match (flat(self), flat(other)) {
            (true, _) if keep != Keep::Either || flat(other) => self.flat(other, keep)?,
            (false, true) if keep == Keep::Common => other.flat(self, keep)?,
            (false, true) if keep == Keep::First || other.levels.is_empty() => self.layered(&Levels::none(), keep),
            (false, false) => self.layered(other, keep),
            (true, false) if self.levels.is_empty() => self.layered(other, keep),
            _ => return None,
        };
        Some(Levels { plane: self.plane.clone(), levels })
    }

    /// Flat levels, all at one height, with whatever stands there.
    fn flat(&self, other: &Levels, keep: Keep) -> Option<Vec<Level>> {
        let Some(height) = self.levels.first().map(|level| level.low) else {
            return Some(if keep == Keep::Either { other.layered(&Levels::none(), keep) } else { Vec::new() });
        };
        if self.levels.iter().any(|level| (level.low - height).abs() > SAME) {
            return None;
        }
        let there = |level: &&Level| level.low - SAME <= height && height <= level.high + SAME;
        if keep == Keep::Either && !other.levels.iter().all(|level| there(&level)) {
            return None;
        }
        let own = geometry::union_all(self.levels.iter().map(|level| &level.area));
        let others = geometry::union_all(other.levels.iter().filter(there).map(|level| &level.area));
        let area = kept(&own, &others, keep);
        Some(Vec::from_iter((!area.is_empty()).then_some(Level { area, low: height, high: height })))
    }

    /// Solids, layer by layer; neighbouring layers of one area are one.
    fn layered(&self, other: &Levels, keep: Keep) -> Vec<Level> {
        let mut heights: Vec<f64> = self.levels.iter().chain(&other.levels).flat_map(|l| [l.low, l.high]).collect();
        heights.sort_by(f64::total_cmp);
        heights.dedup_by(|a, b| (*a - *b).abs() < SAME);
        let mut layers: Vec<Level> = Vec::new();
        for pair in heights.windows(2) {
            let (low, high) = (pair[0], pair[1]);
            let area = kept(&self.between(low, high), &other.between(low, high), keep);
            match layers.last_mut() {
                _ if area.is_empty() => {}
                Some(last) if last.high == low && last.area == area => last.high = high,
                _ => layers.push(Level { area, low, high }),
            }
        }
        // Flat ones have no layer of their own.
        if heights.len() == 1 {
            let area = self.between(heights[0], heights[0]);
            layers.push(Level { area, low: heights[0], high: heights[0] });
        }
        layers
    }

    fn between(&self, low: f64, high: f64) -> Area {
        let middle = (low + high) * 0.5;
        let covers = |level: &&Level| level.low - SAME <= middle && middle <= level.high + SAME;
        geometry::union_all(self.levels.iter().filter(covers).map(|level| &level.area))
    }

    /// Makes the levels the geometry of the shape over whose plane they lie. Several, one above the other, are one solid.
    pub fn become_of(self, shape: &mut Shape) {
        let normal = self.plane.normal();
        let geometry = match self.levels.as_slice() {
            [] => Geometry::Empty,
            [level] => {
                let lift = if level.low.abs() < SAME { 0.0 } else { level.low };
                shape.scope.frame = shape.scope.frame.moved(normal * lift);
                match level.high - level.low {
                    height if height < SAME => Geometry::Flat(self.plane, level.area.clone()),
                    height => Geometry::Prism(self.plane, level.area.clone(), height),
                }
            }
            stack => {
                let layers: Vec<Layer> = stack.iter().map(|level| (&level.area, level.low, level.high)).collect();
                let at = |p: DVec2, height: f64| self.plane.at(p) + normal * height;
                Geometry::Mesh(Arc::new(stacked(&layers, SAME, at)))
            }
        };
        fit::refit(shape, geometry);
    }
}

fn kept(a: &Area, b: &Area, keep: Keep) -> Area {
    match keep {
        Keep::Either => geometry::union(a, b),
        Keep::First => geometry::difference(a, b),
        Keep::Common => geometry::intersection(a, b),
    }
}

/// A shape over a plane that is given in the coordinates of `base`.
fn level(shape: &Shape, base: &Shape, onto: &Plane) -> Option<Level> {
    let (plane, area, height) = match &shape.geometry {
        Geometry::Flat(plane, area) => (plane, area, 0.0),
        Geometry::Prism(plane, area, height) => (plane, area, *height),
        _ => return None,
    };
    let local = |p: DVec3| base.scope.frame.to_local(shape.scope.frame.to_world(p));
    let (origin, normal) = (local(plane.at(DVec2::ZERO)), onto.normal());
    let side = normal.dot(local(plane.at(DVec2::ZERO) + plane.normal()) - origin);
    if side.abs() < 1.0 - 1e-9 {
        return None;
    }
    let foot = |p: DVec2| onto.foot(local(plane.at(p)));
    let zero = foot(DVec2::ZERO);
    let map = DAffine2::from_cols(foot(DVec2::X) - zero, foot(DVec2::Y) - zero, zero);
    let from = normal.dot(origin - onto.at(DVec2::ZERO));
    let to = from + height * side.signum();
    let unmoved = map.matrix2.abs_diff_eq(glam::DMat2::IDENTITY, 0.0);
    let area = if unmoved { area.translated(zero) } else { area.transformed(&map) };
    Some(Level { area, low: from.min(to), high: from.max(to) })
}
