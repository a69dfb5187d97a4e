//! The one adapter to the overlay engine: booleans, outlines and strokes in whole numbers.
//!
//! Coordinates are rounded to a fixed global grid of 2⁻²⁰ m (about a micrometre), the same for every call, so a vertex
//! that two areas share stays shared and results are the same on every platform. The engine computes in 64 bit
//! integers with 128 bit products, which hold any place on earth at that step.

use crate::geometry::{Area, LEAST_AREA, Polygon, ring_area};
use glam::DVec2;
use i_overlay::core::overlay::{IntOverlayOptions, Overlay};
use i_overlay::i_float::int::angle::Angle;
use i_overlay::i_float::int::point::IntPoint;
use i_overlay::mesh::int::arc::ArcOptions;
use i_overlay::mesh::int::outline::offset::IntOutlineOffset;
use i_overlay::mesh::int::stroke::offset::IntStrokeOffset;
use i_overlay::mesh::int::style::{IntLineJoin, IntOutlineStyle, IntStrokeStyle};

/// Steps of the grid per metre.
const STEPS: f64 = (1u64 << 20) as f64;

/// Coordinates are held within this (metres), far beyond the earth.
const FARTHEST: f64 = 1e11;

/// Corners sharper than this are cut off instead of mitred out (radians).
const SHARPEST_MITRE: f64 = 0.35;

/// Corners flatter than this are cut off too (radians): their mitre is a matter of rounding, and the cut takes off
/// less than a fifty-thousandth of the distance.
const FLATTEST_MITRE: f64 = 0.01;

/// Arcs deviate from their circle by at most this (metres).
const ARC_ERROR: f64 = 0.005;

/// What to keep of two sets of rings.
pub(super) use i_overlay::core::overlay_rule::OverlayRule as Keep;

/// What counts as inside a set of rings.
pub(super) use i_overlay::core::fill_rule::FillRule as Fill;

type Point = IntPoint<i64>;
type Rings = Vec<Vec<Point>>;

/// How the corners of an offset are made.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Corner {
    /// Edges are prolonged to where they meet.
    Mitre,
    /// An arc around the corner.
    Round,
}

/// The overlay of two areas.
pub(super) fn overlay(a: &Area, b: &Area, keep: Keep) -> Area {
    let mut engine = Overlay::from_subj_and_clip_custom(&rings(a), &rings(b), options(), Default::default());
    area(engine.overlay(keep, Fill::NonZero))
}

/// The region that rings enclose.
pub(super) fn enclosed<'a>(paths: impl Iterator<Item = &'a [DVec2]>, fill: Fill) -> Area {
    let rings: Rings = paths.map(to_grid).collect();
    area(Overlay::from_subj_custom(&rings, options(), Default::default()).overlay(Keep::Subject, fill))
}

/// The area grown by a distance, or shrunk by a negative one.
pub(super) fn outline(whole: &Area, distance: f64, corner: Corner) -> Area {
    let mut style = IntOutlineStyle::new(steps(distance)).line_join(join(corner, distance.abs()));
    style.miter_min_turn = angle(FLATTEST_MITRE);
    let rings = rings(whole);
    if rings.validate_outline(&style).is_err() {
        return Area::empty();
    }
    rings.outline_custom(&style, options()).map_or_else(|_| Area::empty(), area)
}

/// The region within half the width of a line, flat at its ends.
pub(super) fn stroked(line: &[DVec2], width: f64, corner: Corner, closed: bool) -> Area {
    let mut style = IntStrokeStyle::new(steps(width));
    style.join = join(corner, width * 0.5);
    style.miter_min_turn = angle(FLATTEST_MITRE);
    let path = to_grid(line);
    if path.validate_stroke(&style).is_err() {
        return Area::empty();
    }
    path.stroke_custom(&style, closed, options()).map_or_else(|_| Area::empty(), area)
}

fn options() -> IntOverlayOptions<u128> {
    IntOverlayOptions::ogc()
}

fn join(corner: Corner, radius: f64) -> IntLineJoin {
    match corner {
        Corner::Mitre => IntLineJoin::Miter(angle(SHARPEST_MITRE)),
        Corner::Round => {
            let step = 2.0 * libm::acos((1.0 - ARC_ERROR / radius).clamp(0.0, 1.0));
            IntLineJoin::Round(ArcOptions { max_step: angle(step), ..ArcOptions::default() })
        }
    }
}

fn angle(radians: f64) -> Angle {
    Angle::from_radians(radians).unwrap_or(ArcOptions::MAX_STEP)
}

fn steps(length: f64) -> i64 {
    (length.clamp(-FARTHEST, FARTHEST) * STEPS).round() as i64
}

fn to_grid(ring: &[DVec2]) -> Vec<Point> {
    ring.iter().map(|p| IntPoint::new(steps(p.x), steps(p.y))).collect()
}

fn rings(area: &Area) -> Rings {
    area.polygons().iter().flat_map(Polygon::rings).map(to_grid).collect()
}

/// Back to metres. Parts and holes no wider than a few steps of the grid are traces of rounding and vanish.
fn area(shapes: Vec<Rings>) -> Area {
    let metres =
        |ring: &Vec<Point>| -> Vec<DVec2> { ring.iter().map(|p| DVec2::new(p.x as f64, p.y as f64) / STEPS).collect() };
    let polygon = |shape: &Rings| {
        let holes: Vec<Vec<DVec2>> = shape.iter().skip(1).map(metres).filter(|h| is_wide(h)).collect();
        Polygon::new(&metres(shape.first()?), &holes).filter(|p| is_wide(p.outer()))
    };
    shapes.iter().filter_map(polygon).collect()
}

fn is_wide(ring: &[DVec2]) -> bool {
    let around = ring.iter().zip(ring.iter().cycle().skip(1)).map(|(a, b)| a.distance(*b));
    ring_area(ring).abs() > LEAST_AREA + around.sum::<f64>() * (2.0 / STEPS)
}
