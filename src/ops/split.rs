//! `split`: cuts a shape along an axis of its scope.

use crate::geometry::{self, Area};
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Part, Pieces, Problem, fit, split_uv};
use crate::shape::{Axis, Geometry, Plane, Shape, Way};
use crate::value::Size;
use glam::{DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// Cuts the shape along an axis of its scope, or along its texture coordinates, into parts of given sizes.
    ///
    /// A size is absolute (`3` metres), relative (`'0.3` of the scope) or floating (`~3`, a weight in what is left;
    /// the papers write `3r`). A `*` after the block repeats it as often as fits best: with floating sizes the parts
    /// are stretched so that nothing is cut, with absolute ones the last part is cut. A block in the block,
    /// `{ 1 : A | { ~3 : B }* | 1 : C }`, repeats between fixed parts. Real geometry is cut: polygons with holes,
    /// prisms, edges. `split.index` and `split.total` count the parts over the whole split.
    ///
    /// `split(u, unitSpace, 0)` cuts along a street and `split(v, unitSpace, 0)` across it, in metres, however it winds:
    /// what is level and at least twice as long as wide has u along its middle line, all else by its scope's axes.
    /// Lanes are offset curves, metres are measured in the middle of what is cut, and the parts' x runs along u. With
    /// `uvSpace` sizes are in u and v themselves: 0 to 1 in set 0, metres from the start in set 1 and from the end in
    /// set 2 for u.
    ///
    /// The papers write `Subdiv(x, 7, 2, 5) { A | B | A }` and `Repeat(x, 2) { A }` (Ulmer et al. 2007, §2.1).
    /// ```cga
    /// Lot --> split(x) { 4 : Hedge | { ~6 : Bed | 1.5 : Gravel }* | 4 : Hedge }
    /// ```
    "split" (CityEngine, Cuts) => pub struct Split {
        /// The axis to cut along.
        axis: Along,
        /// `adjust` fits the parts' scopes to their geometry, `noAdjust` keeps the parent's extent across the axis;
        /// along u and v: `unitSpace` takes sizes in metres, `uvSpace` in u and v.
        scope: Adjust = Adjust::Fitted => "adjust",
        /// Which set of texture coordinates, for u and v.
        uv_set: u32 = 0 => "0",
    }
}

choice! {
    /// An axis of the scope.
    pub enum Along {
        /// x
        X = "x",
        /// y
        Y = "y",
        /// z
        Z = "z",
        /// Along texture coordinates.
        U = "u",
        /// Across them.
        V = "v",
    }
}

choice! {
    /// What becomes of the scopes of parts.
    pub enum Adjust {
        /// Fitted to the geometry.
        Fitted = "adjust",
        /// The parent's extent across the axis.
        Kept = "noAdjust",
        /// Sizes in metres along texture coordinates.
        UnitSpace = "unitSpace",
        /// Sizes in texture coordinates.
        UvSpace = "uvSpace",
    }
}

/// An entry of a split block with its size.
#[derive(Clone, Debug, PartialEq)]
pub enum Cut {
    /// A part, and the entry of the block it goes to.
    Piece(Size, u16),
    /// `{ … }*`: as often as fits best.
    Repeat(Vec<Cut>),
    /// `{ … }`: once.
    Group(Vec<Cut>),
}

/// A part's place along the axis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Interval {
    /// Where it begins.
    pub from: f64,
    /// Where it ends.
    pub to: f64,
    /// The entry of the block it goes to.
    pub entry: u16,
}

impl Apply for Split {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let axis = match self.axis {
            Along::X => Axis::X,
            Along::Y => Axis::Y,
            Along::Z => Axis::Z,
            Along::U => return split_uv::split(shape, Way::U, self.scope == Adjust::UvSpace, self.uv_set, given),
            Along::V => return split_uv::split(shape, Way::V, self.scope == Adjust::UvSpace, self.uv_set, given),
        };
        let length = shape.scope.size[axis.index()];
        let intervals = intervals(given.cuts, length, given.most)?;
        parts(shape, axis, self.scope, &intervals)
    }
}

/// The shape's parts between places on an axis.
pub(super) fn parts(shape: &Shape, axis: Axis, scope: Adjust, intervals: &[Interval]) -> Result<Pieces, Problem> {
    let total = intervals.len() as u32;
    let pieces = cut(shape, axis, intervals)?;
    let mut parts = Vec::with_capacity(pieces.len());
    for (index, (interval, geometry)) in (0..).zip(intervals.iter().zip(pieces)) {
        let child = match scope {
            _ if geometry == Geometry::Empty => None,
            Adjust::Fitted | Adjust::UnitSpace | Adjust::UvSpace => fit::fitted(shape, geometry),
            Adjust::Kept => Some(unadjusted(shape, axis, interval, geometry)),
        };
        if let Some(mut child) = child {
            child.ordinals.split = (index, total);
            parts.push(Part::new(interval.entry, child));
        }
    }
    Ok(Pieces::Parts(parts))
}

fn unadjusted(shape: &Shape, axis: Axis, interval: &Interval, geometry: Geometry) -> Shape {
    let mut size = shape.scope.size;
    size[axis.index()] = interval.to - interval.from;
    fit::boxed(shape, geometry, axis.direction() * interval.from, size)
}

/// The geometry of each interval, in the shape's coordinates.
fn cut(shape: &Shape, axis: Axis, intervals: &[Interval]) -> Result<Vec<Geometry>, Problem> {
    let direction = axis.direction();
    Ok(match &shape.geometry {
        Geometry::Empty | Geometry::Point => first_gets_all(shape, intervals),
        Geometry::Path(points) => intervals.iter().map(|i| stretch(points, direction, i)).collect(),
        Geometry::Flat(plane, area) => match across(plane, area, direction, intervals) {
            Some(areas) => areas.into_iter().map(|a| flat(plane, a)).collect(),
            None => first_gets_all(shape, intervals),
        },
        Geometry::Prism(plane, area, height) => prism(shape, plane, area, *height, direction, intervals),
        Geometry::Mesh(mesh) => intervals.iter().map(|i| solid(mesh.cut(direction, i.from, i.to))).collect(),
        Geometry::Element(_) => {
            return Err(Problem::new("an inserted element cannot be split").hint("split the shape before `i`"));
        }
    })
}

fn flat(plane: &Plane, area: Area) -> Geometry {
    if area.is_empty() { Geometry::Empty } else { Geometry::Flat(plane.clone(), area) }
}

pub(super) fn solid(mesh: geometry::Mesh) -> Geometry {
    if mesh.faces.is_empty() { Geometry::Empty } else { Geometry::Mesh(Arc::new(mesh)) }
}

/// A shape without extent along the axis goes to the first part whole.
fn first_gets_all(shape: &Shape, intervals: &[Interval]) -> Vec<Geometry> {
    let first = intervals.iter().take(1).map(|_| shape.geometry.clone());
    first.chain(intervals.iter().skip(1).map(|_| Geometry::Empty)).collect()
}

/// The bands of a planar region; `None` where the plane lies across the axis.
fn across(plane: &Plane, area: &Area, direction: DVec3, intervals: &[Interval]) -> Option<Vec<Area>> {
    let (u, v) = plane.axes();
    let slope = DVec2::new(direction.dot(u), direction.dot(v));
    let steepness = slope.length();
    if steepness < 1e-9 {
        return None;
    }
    let (normal, start) = (slope / steepness, direction.dot(plane.at(DVec2::ZERO)));
    let at = |x: f64| (x - start) / steepness;
    if let [only] = intervals {
        return Some(vec![geometry::band(area, normal, at(only.from), at(only.to))]);
    }
    let cuts: Vec<f64> = intervals.iter().map(|i| at(i.from)).chain(intervals.last().map(|i| at(i.to))).collect();
    Some(geometry::bands(area, normal, &cuts))
}

fn prism(
    shape: &Shape,
    plane: &Plane,
    area: &Area,
    height: f64,
    direction: DVec3,
    intervals: &[Interval],
) -> Vec<Geometry> {
    let along = direction.dot(plane.normal());
    if along.abs() > 1.0 - 1e-9 {
        let foot = direction.dot(plane.at(DVec2::ZERO));
        return intervals.iter().map(|i| slice(plane, area, (foot, foot + height * along), direction, i)).collect();
    }
    if along.abs() < 1e-9 {
        let areas = across(plane, area, direction, intervals).unwrap_or_default();
        let swept = |a: Area| if a.is_empty() { Geometry::Empty } else { Geometry::Prism(plane.clone(), a, height) };
        return areas.into_iter().map(swept).collect();
    }
    let mesh = shape.local_mesh().unwrap_or_default();
    intervals.iter().map(|i| solid(mesh.cut(direction, i.from, i.to))).collect()
}

/// The part of a prism between two heights along its sweep, which runs between `reach`.
fn slice(plane: &Plane, area: &Area, reach: (f64, f64), direction: DVec3, interval: &Interval) -> Geometry {
    let (low, high) = (reach.0.min(reach.1), reach.0.max(reach.1));
    let (from, to) = (interval.from.max(low), interval.to.min(high));
    if to - from <= 1e-12 {
        return Geometry::Empty;
    }
    let (u, v) = plane.axes();
    let foot = plane.at(DVec2::ZERO);
    let origin = foot + direction * (from - direction.dot(foot));
    let plane = Plane::Free(Arc::new([origin, u, v]));
    let sign = direction.dot(plane.normal());
    Geometry::Prism(plane, area.clone(), (to - from) * sign)
}

/// The part of a polyline between two coordinates.
fn stretch(points: &[DVec3], direction: DVec3, interval: &Interval) -> Geometry {
    let mut kept: Vec<DVec3> = Vec::new();
    for pair in points.windows(2) {
        let (a, b) = (pair[0], pair[1]);
        let (ta, tb) = (direction.dot(a), direction.dot(b));
        let share = |x: f64| if (tb - ta).abs() < 1e-12 { 0.0 } else { ((x - ta) / (tb - ta)).clamp(0.0, 1.0) };
        let (low, high) = (interval.from.max(ta.min(tb)), interval.to.min(ta.max(tb)));
        if low > high {
            continue;
        }
        let (first, second) = if ta <= tb { (share(low), share(high)) } else { (share(high), share(low)) };
        let (first, second) = if (tb - ta).abs() < 1e-12 { (0.0, 1.0) } else { (first, second) };
        kept.extend([a.lerp(b, first), a.lerp(b, second)]);
    }
    kept.dedup();
    if kept.len() < 2 { Geometry::Empty } else { Geometry::Path(kept.into()) }
}

/// A size with its entry, before floating sizes are known.
#[derive(Clone, Copy)]
enum Length {
    Fixed(f64),
    Floating(f64),
}

/// Where each part begins and ends.
pub(super) fn intervals(cuts: &[Cut], length: f64, most: usize) -> Result<Vec<Interval>, Problem> {
    if !length.is_finite() {
        return Err(Problem::new("the scope has no finite size along the axis"));
    }
    let mut list = Vec::new();
    expand(cuts, length, length, most, &mut list)?;
    let fixed: f64 = list.iter().map(|(l, _)| if let Length::Fixed(x) = l { *x } else { 0.0 }).sum();
    let weights: f64 = list.iter().map(|(l, _)| if let Length::Floating(x) = l { *x } else { 0.0 }).sum();
    let unit = if weights > 0.0 { (length - fixed).max(0.0) / weights } else { 0.0 };
    let mut at = 0.0;
    let mut intervals = Vec::with_capacity(list.len());
    for (size, entry) in list {
        let size = match size {
            Length::Fixed(size) => size,
            Length::Floating(weight) => weight * unit,
        };
        let to = if (at + size - length).abs() < 1e-9 * length.max(1.0) { length } else { (at + size).min(length) };
        if to > at || (length == 0.0 && intervals.is_empty()) {
            intervals.push(Interval { from: at, to, entry });
        }
        at = to;
    }
    Ok(intervals)
}

/// Writes repeats out. `room` is the length for these cuts, `scope` what relative sizes refer to.
fn expand(cuts: &[Cut], room: f64, scope: f64, most: usize, list: &mut Vec<(Length, u16)>) -> Result<(), Problem> {
    let natural: f64 = cuts.iter().filter(|c| !matches!(c, Cut::Repeat(_))).map(|c| extent(c, scope).1).sum();
    let periods: f64 = cuts.iter().filter(|c| matches!(c, Cut::Repeat(_))).map(|c| extent(c, scope).1).sum();
    for cut in cuts {
        match cut {
            Cut::Piece(size, entry) => list.push((sized(*size, scope)?, *entry)),
            Cut::Group(inner) => expand(inner, room, scope, most, list)?,
            Cut::Repeat(inner) => {
                let (stretches, period) = extent(cut, scope);
                let share = if periods > 0.0 { (room - natural).max(0.0) * period / periods } else { 0.0 };
                repeat(inner, stretches, period, share, scope, most, list)?;
            }
        }
    }
    if list.len() > most {
        return Err(too_many(list.len(), most));
    }
    Ok(())
}

/// Writes a repeated block out over a length: stretched where it can be, cut at the end where it cannot.
fn repeat(
    inner: &[Cut],
    stretches: bool,
    period: f64,
    room: f64,
    scope: f64,
    most: usize,
    list: &mut Vec<(Length, u16)>,
) -> Result<(), Problem> {
    if period <= 0.0 {
        return Err(Problem::new("a repeated part has no size").hint("a size above 0 ends the repeat"));
    }
    let times = room / period;
    let count = if stretches { times.round().max(1.0) } else { (times - 1e-9).ceil().max(0.0) };
    if count > most as f64 {
        return Err(too_many(count as usize, most));
    }
    let begin = list.len();
    for _ in 0..count as usize {
        expand(inner, period, scope, most, list)?;
    }
    if !stretches {
        clip(list, begin, room);
    }
    Ok(())
}

/// Cuts fixed parts from `begin` on at a length.
fn clip(list: &mut Vec<(Length, u16)>, begin: usize, room: f64) {
    let mut left = room;
    for (size, _) in &mut list[begin..] {
        if let Length::Fixed(metres) = size {
            *metres = metres.min(left).max(0.0);
            left -= *metres;
        }
    }
    while list.len() > begin && matches!(list.last(), Some((Length::Fixed(x), _)) if *x <= 0.0) {
        list.pop();
    }
}

/// Whether a cut can stretch, and its natural length.
fn extent(cut: &Cut, scope: f64) -> (bool, f64) {
    match cut {
        Cut::Piece(Size::Absolute(metres), _) => (false, metres.max(0.0)),
        Cut::Piece(Size::Relative(share), _) => (false, (share * scope).max(0.0)),
        Cut::Piece(Size::Floating(weight), _) => (true, weight.max(0.0)),
        Cut::Repeat(inner) | Cut::Group(inner) => {
            let parts = inner.iter().map(|c| extent(c, scope));
            parts.fold((false, 0.0), |(any, sum), (stretches, length)| (any || stretches, sum + length))
        }
    }
}

fn sized(size: Size, scope: f64) -> Result<Length, Problem> {
    let (length, number) = match size {
        Size::Absolute(metres) => (Length::Fixed(metres.max(0.0)), metres),
        Size::Relative(share) => (Length::Fixed((share * scope).max(0.0)), share),
        Size::Floating(weight) => (Length::Floating(weight.max(0.0)), weight),
    };
    match number.is_finite() {
        true => Ok(length),
        false => Err(Problem::new(format!("a part has the size {number}"))),
    }
}

fn too_many(count: usize, most: usize) -> Problem {
    let message = format!("the split makes {count} parts, more than the limit `children` of {most}");
    Problem::new(message).hint("larger sizes make fewer parts")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn lengths(cuts: &[Cut], length: f64) -> Vec<(f64, u16)> {
        let found = intervals(cuts, length, 1000).unwrap();
        found.iter().map(|i| (((i.to - i.from) * 1e6).round() / 1e6, i.entry)).collect()
    }

    fn piece(size: Size, entry: u16) -> Cut {
        Cut::Piece(size, entry)
    }

    use Size::{Absolute, Floating, Relative};

    #[test]
    fn papers_example_shares_the_rest() {
        // Ulmer et al. 2007, §2.1: Subdiv(y, 1r, 2, 4r): the middle is 2, the others share the rest 1:4.
        let cuts = [piece(Floating(1.0), 0), piece(Absolute(2.0), 1), piece(Floating(4.0), 2)];
        assert_eq!(lengths(&cuts, 12.0), [(2.0, 0), (2.0, 1), (8.0, 2)]);
    }

    #[test]
    fn repeats_stretch_or_cut() {
        let floating = [Cut::Repeat(vec![piece(Floating(3.0), 0)])];
        assert_eq!(lengths(&floating, 10.0), [(3.333333, 0); 3]);
        let absolute = [Cut::Repeat(vec![piece(Absolute(3.0), 0)])];
        assert_eq!(lengths(&absolute, 10.0), [(3.0, 0), (3.0, 0), (3.0, 0), (1.0, 0)]);
    }

    #[test]
    fn repeats_stand_between_fixed_parts() {
        let inner = vec![piece(Floating(3.0), 1), piece(Absolute(1.0), 2)];
        let cuts = [piece(Absolute(2.0), 0), Cut::Repeat(inner), piece(Relative(0.1), 3)];
        assert_eq!(
            lengths(&cuts, 20.0),
            [(2.0, 0), (3.0, 1), (1.0, 2), (3.0, 1), (1.0, 2), (3.0, 1), (1.0, 2), (3.0, 1), (1.0, 2), (2.0, 3)]
        );
    }

    #[test]
    fn what_does_not_fit_is_cut_and_the_rest_not_made() {
        let cuts = [piece(Absolute(6.0), 0), piece(Absolute(6.0), 1), piece(Absolute(6.0), 2)];
        assert_eq!(lengths(&cuts, 10.0), [(6.0, 0), (4.0, 1)]);
    }
}
