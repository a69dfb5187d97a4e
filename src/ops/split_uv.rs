//! `split(u)` and `split(v)`: cuts a shape along its texture coordinates.
//!
//! In: a shape, a way and sizes. Out: parts whose scopes lie along u where they are. Flat shapes and prisms are cut by
//! the regions of their chart, other surfaces by planes where the chart is straight.

use crate::geometry::{self, Area, Bounds};
use crate::ops::split::{Interval, intervals, solid};
use crate::ops::{Given, Part, Pieces, Problem, fit};
use crate::shape::{Chart, Course, Geometry, Plane, Shape, Way};
use glam::{DAffine2, DVec2, DVec3};

/// What is told of shapes that have no texture coordinates.
const NO_SURFACE: &str = "`split` along u and v takes surfaces";

/// A split along one coordinate.
struct Cutter<'a> {
    chart: &'a Chart,
    way: Way,
    /// Least and greatest metres along and across.
    places: Bounds,
    /// The ends of each interval in u (or v), the first and last a little beyond the shape.
    ends: Vec<(f64, f64)>,
}

/// The parts of a shape; from now on it has charts, which its parts share.
pub(super) fn split(shape: &mut Shape, way: Way, is_uv: bool, set: u32, given: &Given) -> Result<Pieces, Problem> {
    if shape.geometry == Geometry::Empty {
        return Ok(Pieces::Parts(Vec::new()));
    }
    let mut owner = shape.clone();
    owner.charted();
    let hint = "`split(x)` cuts lines, `comp(f)` takes the faces of a solid";
    let chart = owner.chart(set).ok_or_else(|| Problem::new(NO_SURFACE).hint(hint))?;
    let (places, extent) = (chart.places(shape), chart.extent(shape));
    let (low, high) = (extent.min[way.index()], extent.max[way.index()]);
    let length = if is_uv { high - low } else { chart.metres(way, low, high, places) };
    let intervals = intervals(given.cuts, length, given.most)?;
    let value = |at: f64| if is_uv { low + at } else { chart.advanced(way, low, at, places) };
    let beyond = (high - low) * 0.01;
    let ends = intervals.iter().map(|i| {
        let from = if i.from == 0.0 { low - beyond } else { value(i.from) };
        (from, if i.to == length { high + beyond } else { value(i.to) })
    });
    let cutter = Cutter { chart: &chart, way, places, ends: ends.collect() };
    Ok(Pieces::Parts(cutter.parts(&owner, &intervals)?))
}

impl Cutter<'_> {
    fn parts(&self, shape: &Shape, intervals: &[Interval]) -> Result<Vec<Part>, Problem> {
        let children = match &shape.geometry {
            Geometry::Flat(plane, area) => self.flat(shape, plane, area, None)?,
            Geometry::Prism(plane, area, height) => self.flat(shape, plane, area, Some(*height))?,
            Geometry::Mesh(mesh) if self.chart.course == Course::Straight => {
                let (normal, cuts) = self.planes(shape);
                let pieces = mesh.bands(normal, &cuts).into_iter();
                pieces.map(|piece| fit::fitted(shape, solid(piece))).collect()
            }
            Geometry::Mesh(_) => {
                let hint = "`comp(f)` takes its faces, `alignScopeToAxes` and `split(x)` cut it straight";
                return Err(Problem::new("a solid cannot be cut along a curve").hint(hint));
            }
            _ => return Err(Problem::new(NO_SURFACE)),
        };
        let total = intervals.len() as u32;
        let parts = (0..).zip(intervals).zip(children).filter_map(|((index, interval), child)| {
            let mut shape = child?;
            shape.ordinals.split = (index, total);
            Some(Part::new(interval.entry, shape))
        });
        Ok(parts.collect())
    }

    /// The parts of a region of a plane, raised again where it was.
    fn flat(
        &self,
        shape: &Shape,
        plane: &Plane,
        area: &Area,
        height: Option<f64>,
    ) -> Result<Vec<Option<Shape>>, Problem> {
        let map = self.chart.onto(shape, plane);
        if map.matrix2.determinant().abs() < 1e-6 {
            let message = "the texture coordinates lie across the shape";
            return Err(Problem::new(message).hint("`deleteUV` gives it its own again"));
        }
        let areas = match self.chart.course {
            Course::Straight => self.straight(area, &map),
            Course::Along(_) => self.winding(area, &map.inverse()),
        };
        let child = |(index, area): (usize, Area)| {
            let along = map.inverse().transform_vector2(self.direction(index));
            let mut child = fit::aligned(shape, plane, &area, along)?;
            if let (Some(height), Geometry::Flat(plane, area)) = (height, child.geometry.clone()) {
                fit::refit(&mut child, Geometry::Prism(plane, area, height));
            }
            Some(child)
        };
        Ok(areas.into_iter().enumerate().map(child).collect())
    }

    /// Bands of an area whose plane leads to the chart's by `map`.
    fn straight(&self, area: &Area, map: &DAffine2) -> Vec<Area> {
        let slope = map.matrix2.transpose() * self.chart.slope(self.way);
        let start = self.chart.slope(self.way).dot(map.translation) + self.chart.scale.translation[self.way.index()];
        let at = |value: f64| (value - start) / slope.length();
        geometry::bands(area, slope.normalize_or_zero(), &self.cuts().map(at).collect::<Vec<_>>())
    }

    /// What the chart's regions take of an area whose plane is reached by `back`.
    fn winding(&self, area: &Area, back: &DAffine2) -> Vec<Area> {
        let mut found = Vec::with_capacity(self.ends.len());
        self.halve(area, back, 0, self.ends.len(), &mut found);
        found
    }

    /// The parts of some intervals, by halves: so each cut sees only what is near it.
    fn halve(&self, area: &Area, back: &DAffine2, first: usize, end: usize, found: &mut Vec<Area>) {
        if first >= end || area.is_empty() {
            return found.resize(end.max(first), Area::empty());
        }
        let region = self.chart.region(self.way, self.ends[first].0, self.ends[end - 1].1, self.places);
        let taken = region.map(|region| geometry::intersection(area, &Area::from(region).transformed(back)));
        let taken = taken.unwrap_or_default();
        if end - first == 1 {
            return found.push(taken);
        }
        let middle = (first + end) / 2;
        self.halve(&taken, back, first, middle, found);
        self.halve(&taken, back, middle, end, found);
    }

    /// In the shape's coordinates: how the coordinate grows, and where the cuts lie.
    fn planes(&self, shape: &Shape) -> (DVec3, Vec<f64>) {
        let (frame, index) = (&shape.scope.frame, self.way.index());
        let value = |p: DVec3| self.chart.uv(frame.to_world(p))[index];
        let start = value(DVec3::ZERO);
        let slope = DVec3::new(value(DVec3::X), value(DVec3::Y), value(DVec3::Z)) - start;
        let cuts = self.cuts().map(|cut| (cut - start) / slope.length());
        (slope.normalize_or_zero(), cuts.collect())
    }

    fn cuts(&self) -> impl Iterator<Item = f64> {
        self.ends.iter().map(|(from, _)| *from).chain(self.ends.last().map(|(_, to)| *to))
    }

    /// The direction of u in the chart's plane: over the whole of a part, from its first to its last place.
    fn direction(&self, index: usize) -> DVec2 {
        let mut places = self.places;
        let (slope, along) = (self.chart.slope(self.way), self.chart.slope(Way::U));
        let axis = usize::from(slope.y.abs() > slope.x.abs());
        let at = |value: f64| (value - self.chart.scale.translation[self.way.index()]) / slope[axis];
        let (from, to) = (at(self.ends[index].0), at(self.ends[index].1));
        (places.min[axis], places.max[axis]) = (from.min(to).max(places.min[axis]), from.max(to).min(places.max[axis]));
        let reach = along.normalize_or_zero() * along.normalize_or_zero().abs().dot(places.size()) * 0.5;
        let flat = |place: DVec2| self.chart.plane.transform_point3(self.chart.at(place)).truncate();
        let direction = flat(places.centre() + reach) - flat(places.centre() - reach);
        direction.try_normalize().unwrap_or(DVec2::X)
    }
}
