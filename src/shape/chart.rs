//! Charts: what gives the points of a shape their texture coordinates u and v.
//!
//! A chart lies in the world, so parts of a shape share their parent's; operations that move a shape move its charts
//! ([`crate::shape::Surface::carried`]). On the ground a strip gets a chart that runs along it, a face one by its axes.

use crate::geometry::{Area, Bounds, Polygon, Ribbon, band};
use crate::shape::{Frame, Geometry, Plane, Shape};
use glam::{DAffine2, DAffine3, DMat2, DMat3, DVec2, DVec3};
use std::sync::Arc;

/// Beyond the extent of a shape (metres) its parts at the ends reach, so that rounding leaves no slivers.
const MARGIN: f64 = 0.05;

/// How points of the world get u and v: into a plane, there along and across, and then scaled.
#[derive(Clone, Debug, PartialEq)]
pub struct Chart {
    /// The world → the chart's plane, metres: x and y in it, z off it.
    pub plane: DAffine3,
    /// The plane → metres along and across.
    pub course: Course,
    /// Metres along and across → u and v.
    pub scale: DAffine2,
}

/// Where along and across lead.
#[derive(Clone, Debug, PartialEq)]
pub enum Course {
    /// Along x, across y.
    Straight,
    /// Along a line.
    Along(Arc<Ribbon>),
}

/// One of the two coordinates.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Way {
    /// u
    U,
    /// v
    V,
}

impl Way {
    /// Its index in a vector.
    pub fn index(self) -> usize {
        self as usize
    }
}

impl Chart {
    /// u and v of a point of the world. Linear in the segments of the chart's line.
    pub fn uv(&self, world: DVec3) -> DVec2 {
        let flat = self.plane.transform_point3(world).truncate();
        self.scale.transform_point2(match &self.course {
            Course::Straight => flat,
            Course::Along(ribbon) => ribbon.find(flat),
        })
    }

    /// The least and greatest u and v of a shape; empty for what has no surface. Along a line that is scaled askew, at
    /// least those.
    pub fn extent(&self, shape: &Shape) -> Bounds {
        let scaled = |p: DVec2| self.scale.transform_point2(p);
        match self.course {
            Course::Straight => Bounds::of(self.flat(shape).into_iter().map(scaled)),
            Course::Along(_) => match self.places(shape) {
                places if places.is_empty() => Bounds::EMPTY,
                places => Bounds::of(corners(places).map(scaled)),
            },
        }
    }

    /// Metres between two values of u (or v) in the middle of a shape whose places are these: along a line they are
    /// measured on the offset curve that runs through that middle.
    pub fn metres(&self, way: Way, from: f64, to: f64, places: Bounds) -> f64 {
        let metres = match self.lengthwise(way, places) {
            Some(line) => line.ribbon.distance(line.along(from), line.along(to), line.across),
            None => (to - from) * self.unit(way),
        };
        metres.abs()
    }

    /// The u (or v) that lies so many metres further on than another, measured as by [`Chart::metres`].
    pub fn advanced(&self, way: Way, from: f64, metres: f64, places: Bounds) -> f64 {
        match self.lengthwise(way, places) {
            Some(line) => from + line.advance(line.along(from), metres) * line.per_metre,
            None => from + metres / self.unit(way),
        }
    }

    /// Least and greatest metres along and across of a shape; empty for what has no surface.
    pub fn places(&self, shape: &Shape) -> Bounds {
        match (&self.course, &shape.geometry) {
            (Course::Along(ribbon), Geometry::Flat(plane, area) | Geometry::Prism(plane, area, _)) => {
                ribbon.extent(&area.transformed(&self.onto(shape, plane)))
            }
            (Course::Along(ribbon), _) => Bounds::of(self.flat(shape).into_iter().map(|p| ribbon.find(p))),
            (Course::Straight, _) => Bounds::of(self.flat(shape)),
        }
    }

    /// The vertices of a shape in the chart's plane.
    fn flat(&self, shape: &Shape) -> Vec<DVec2> {
        if let Geometry::Flat(plane, area) = &shape.geometry {
            let map = self.onto(shape, plane);
            return area.edges().map(|(a, _)| map.transform_point2(a)).collect();
        }
        let positions = shape.world_mesh().map(|mesh| mesh.positions).unwrap_or_default();
        positions.into_iter().map(|p| self.plane.transform_point3(p).truncate()).collect()
    }

    /// What lies between two values of u (or v) within a box of places, in the chart's plane; the box may be open
    /// where the values are infinite.
    pub fn region(&self, way: Way, from: f64, to: f64, places: Bounds) -> Option<Polygon> {
        let slope = self.slope(way);
        let (normal, offset) = (slope.normalize_or_zero(), self.scale.translation[way.index()]);
        let at = |value: f64| (value - offset) / slope.length();
        let around = places.grown(MARGIN);
        let around = Area::from(Polygon::rectangle(around.min, around.max)?);
        let piece = band(&around, normal, at(from), at(to));
        let ring = piece.polygons().first()?.outer().to_vec();
        match &self.course {
            Course::Straight => Polygon::new(&ring, &[]),
            Course::Along(ribbon) => Polygon::new(&ribbon.outline(&ring), &[]),
        }
    }

    /// The world's point at a place along and across, on the chart's plane.
    pub fn at(&self, place: DVec2) -> DVec3 {
        let flat = match &self.course {
            Course::Straight => place,
            Course::Along(ribbon) => ribbon.at(place),
        };
        self.plane.inverse().transform_point3(flat.extend(0.0))
    }

    /// The plane of a geometry → the chart's plane.
    pub fn onto(&self, shape: &Shape, plane: &Plane) -> DAffine2 {
        let frame = &shape.scope.frame;
        let flat = |p: DVec2| self.plane.transform_point3(frame.to_world(plane.at(p))).truncate();
        let origin = flat(DVec2::ZERO);
        DAffine2::from_cols(flat(DVec2::X) - origin, flat(DVec2::Y) - origin, origin)
    }

    /// How u (or v) grows per metre along and per metre across.
    pub fn slope(&self, way: Way) -> DVec2 {
        self.scale.matrix2.row(way.index())
    }

    /// The chart's scale followed by another map of u and v.
    pub fn rescaled(&mut self, map: DAffine2) {
        self.scale = map * self.scale;
    }

    /// Metres for each unit where the other coordinate stays.
    fn unit(&self, way: Way) -> f64 {
        let inverse = self.scale.matrix2.inverse();
        let length = inverse.col(way.index()).length();
        if length.is_finite() { length } else { 0.0 }
    }

    /// For a coordinate that grows along a line alone: how it does in the middle of a shape.
    fn lengthwise(&self, way: Way, places: Bounds) -> Option<Lengthwise<'_>> {
        let (slope, offset) = (self.slope(way), self.scale.translation[way.index()]);
        let Course::Along(ribbon) = &self.course else { return None };
        let across = places.centre().y;
        (slope.y.abs() < 1e-9 * slope.x.abs()).then_some(Lengthwise { ribbon, per_metre: slope.x, offset, across })
    }
}

/// A coordinate on an offset curve of a line.
struct Lengthwise<'a> {
    ribbon: &'a Ribbon,
    per_metre: f64,
    offset: f64,
    across: f64,
}

impl Lengthwise<'_> {
    /// How far along the line a value lies.
    fn along(&self, value: f64) -> f64 {
        (value - self.offset) / self.per_metre
    }

    /// How far along one gets in so many metres on the curve, forwards where the coordinate grows along the line.
    fn advance(&self, from: f64, metres: f64) -> f64 {
        match self.per_metre > 0.0 {
            true => self.ribbon.advanced(from, metres, self.across) - from,
            false => {
                let (back, length) = (self.ribbon.reversed(), self.ribbon.length());
                (length - from) - back.advanced(length - from, metres, -self.across)
            }
        }
    }
}

/// The three charts that a surface has when nothing else gave it any, as streets have them: set 0 from 0 to 1 along
/// and across; set 1 in metres from the start, set 2 in metres from the end, both from 0 to 1 across.
///
/// What is level and at least twice as long as wide gets its line, all else its axes.
pub(super) fn native(shape: &Shape) -> Option<[Chart; 3]> {
    let straight = || straight(shape);
    let (plane, course) = along(shape).or_else(straight)?;
    let chart = Chart { plane, course, scale: DAffine2::IDENTITY };
    let places = chart.places(shape);
    let size = places.size().max(DVec2::splat(1e-9));
    let scaled = |along: f64, across: f64, from: DVec2| {
        let matrix = DMat2::from_diagonal(DVec2::new(along, across));
        Chart { scale: DAffine2 { matrix2: matrix, translation: -(matrix * from) }, ..chart.clone() }
    };
    Some([
        scaled(1.0 / size.x, 1.0 / size.y, places.min),
        scaled(1.0, 1.0 / size.y, places.min),
        scaled(-1.0, -1.0 / size.y, places.max),
    ])
}

/// Along the line of a level strip.
fn along(shape: &Shape) -> Option<(DAffine3, Course)> {
    let (Geometry::Flat(plane, area) | Geometry::Prism(plane, area, _)) = &shape.geometry else { return None };
    let space = plane_space(&shape.scope.frame, plane);
    let up = shape.scope.frame.rotation * plane.normal();
    if up.y.abs() < 0.7 {
        return None;
    }
    let ribbon = Ribbon::along(area)?;
    let [a, b] = [area.largest()?.outer()[0], area.largest()?.outer()[1]];
    let ribbon = if runs_against(&ribbon, a, b) { ribbon.reversed() } else { ribbon };
    Some((space, Course::Along(Arc::new(ribbon))))
}

/// The first edge decides which way a line runs: with it where it lies beside the line, away from it where it is an end.
fn runs_against(ribbon: &Ribbon, a: DVec2, b: DVec2) -> bool {
    let middle = ribbon.find((a + b) * 0.5);
    let along = ribbon.at(middle + DVec2::X * 0.01) - ribbon.at(middle);
    let (edge, along) = ((b - a).normalize_or_zero(), along.normalize_or_zero());
    match edge.dot(along) {
        with if with.abs() > 0.7 => with < 0.0,
        _ => middle.x > ribbon.length() * 0.5,
    }
}

/// By the axes: of the plane, or of the scope where there is no single plane.
fn straight(shape: &Shape) -> Option<(DAffine3, Course)> {
    let frame = &shape.scope.frame;
    let space = match &shape.geometry {
        Geometry::Flat(plane, _) | Geometry::Prism(plane, ..) => plane_space(frame, plane),
        Geometry::Mesh(_) => match shape.scope.size {
            size if size.y > 1e-9 => plane_space(frame, &Plane::Face),
            _ => plane_space(frame, &Plane::Ground),
        },
        _ => return None,
    };
    Some((space, Course::Straight))
}

/// The world → the coordinates of a plane in a frame, and the distance from it.
pub(super) fn plane_space(frame: &Frame, plane: &Plane) -> DAffine3 {
    let (u, v) = plane.axes();
    let turn = frame.rotation;
    let axes = DMat3::from_cols(turn * u, turn * v, turn * u.cross(v));
    DAffine3 { matrix3: axes, translation: frame.to_world(plane.at(DVec2::ZERO)) }.inverse()
}

fn corners(bounds: Bounds) -> [DVec2; 4] {
    let (low, high) = (bounds.min, bounds.max);
    [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)]
}
