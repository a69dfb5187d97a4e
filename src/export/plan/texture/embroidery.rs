//! Parterre de broderie: running scrolls of box on gravel, mirrored about the axes of the bed.
//!
//! The bed's box along its longest edge is cut by its axes into strips; each strip carries an undulating stem whose
//! every bend holds a volute, alternately turning left and right, with leaves along its back. Mirrored across both
//! axes this is the arabesque of Boyceau and Mollet, reduced to what a plan can show. A flower border runs round it.

use crate::export::plan::drawing::{Group, Item, Shape};
use crate::export::plan::ink::{Ink, LIGHT};
use crate::export::plan::path::{Path, Step, direction};
use crate::export::plan::texture::{Ground, marks};
use crate::geometry::{Bounds, Polygon, inset};
use glam::DVec2;
use std::f64::consts::{FRAC_PI_2, PI, TAU};

/// Strips narrower than this on paper (mm) show no scrolls.
const LEAST_STRIP: f64 = 1.6;
/// Volutes no higher than this many metres: box must be clipped from both sides.
const HIGHEST: f64 = 14.0;
/// The grass of the border.
const BORDER: Ink = Ink::hex(0xb9c495);

/// Gravel dots, a border, and the scrolls of every part of the region.
pub fn scrolls(ground: &Ground) -> Vec<Item> {
    let mut items = marks::stipple(ground);
    let short = ground.area.polygons().iter().map(|p| Bed::new(p).half.min_element()).fold(0.0, f64::max);
    let width = (1.6 * ground.metre).min(short * 0.12);
    if width > 0.35 {
        items.extend(border(ground, width * 0.45, width));
    }
    for polygon in inset(ground.area, width * 2.0).polygons() {
        let scrolls = arabesque(&Bed::new(polygon), ground.metre).items(ground.line);
        if !scrolls.is_empty() {
            let clip = Some(Path::area(&polygon.clone().into()));
            items.push(Group { clip, items: scrolls, ..Group::default() }.into());
        }
    }
    items
}

/// The band of grass and flowers along the edge.
fn border(ground: &Ground, from: f64, width: f64) -> Vec<Item> {
    let band = Path::band(&inset(ground.area, from), &inset(ground.area, from + width));
    let (mut dots, size) = (Path::default(), (width * 0.36).min(1.1));
    for (a, b) in inset(ground.area, from + width / 2.0).edges() {
        let count = (a.distance(b) / (size * 1.8)).floor().max(1.0);
        (0..count as usize).for_each(|i| dots.add_dot(a.lerp(b, (i as f64 + 0.5) / count)));
    }
    let flowers = Shape::drawn(dots.coarse(), ground.line.mixed(LIGHT, 0.15), size);
    vec![Shape::filled(band, BORDER).outlined(ground.line, 0.1).into(), flowers.into()]
}

/// The pieces of an arabesque, apart by how the pen draws them.
#[derive(Default)]
struct Scrolls {
    bold: Path,
    fine: Path,
    eyes: Path,
    leaves: Path,
    /// The width of the bold lines.
    weight: f64,
}

impl Scrolls {
    fn append(&mut self, other: &Scrolls, map: impl Fn(DVec2) -> DVec2 + Copy) {
        self.bold.append(&other.bold.mapped(map));
        self.fine.append(&other.fine.mapped(map));
        self.eyes.append(&other.eyes.mapped(map));
        self.leaves.append(&other.leaves.mapped(map));
    }

    fn items(&self, ink: Ink) -> Vec<Item> {
        if self.bold.is_empty() {
            return Vec::new();
        }
        let drawn = |path: &Path, width: f64| Shape::drawn(path.coarse(), ink, width * self.weight).into();
        let leaves = Shape::filled(self.leaves.coarse(), ink).into();
        vec![drawn(&self.bold, 1.0), drawn(&self.fine, 0.65), drawn(&self.eyes, 2.3), leaves]
    }
}

/// A bed's own frame: its middle, its long axis, and half its extent along and across.
struct Bed {
    middle: DVec2,
    along: DVec2,
    half: DVec2,
}

impl Bed {
    /// The box along the polygon's longest edge.
    fn new(polygon: &Polygon) -> Bed {
        let longest = polygon.edges().max_by(|e, f| e.0.distance(e.1).total_cmp(&f.0.distance(f.1)));
        let axis = longest.map_or(DVec2::X, |(a, b)| (b - a).normalize_or(DVec2::X));
        let turned = Bounds::of(polygon.outer().iter().map(|p| DVec2::new(p.dot(axis), p.dot(axis.perp()))));
        let (centre, half) = (turned.centre(), turned.size() / 2.0);
        let middle = axis * centre.x + axis.perp() * centre.y;
        match half.x >= half.y {
            true => Bed { middle, along: axis, half },
            false => Bed { middle, along: axis.perp(), half: DVec2::new(half.y, half.x) },
        }
    }

    fn point(&self, local: DVec2) -> DVec2 {
        self.middle + self.along * local.x + self.along.perp() * local.y
    }
}

/// All strips of a bed, mirrored about both axes.
fn arabesque(bed: &Bed, metre: f64) -> Scrolls {
    let rows = (bed.half.y / (HIGHEST * metre)).ceil().max(1.0);
    let height = bed.half.y / rows;
    let mut scrolls = Scrolls::default();
    if height < LEAST_STRIP {
        return scrolls;
    }
    for row in 0..rows as usize {
        let strip = strip(bed.half.x, height, row % 2 == 1);
        scrolls.weight = strip.weight;
        for (x, y) in [(1.0, 1.0), (-1.0, 1.0), (1.0, -1.0), (-1.0, -1.0)] {
            let lift = height * row as f64;
            scrolls.append(&strip, |p| bed.point(DVec2::new(p.x * x, (p.y + lift) * y)));
        }
    }
    let mut rosette = Scrolls::default();
    rosette.add_rosette(height * 0.26);
    scrolls.append(&rosette, |p| bed.point(p));
    scrolls
}

/// The running scroll of one strip: from the axis at x = 0 to `length`, y from 0 to `height`.
fn strip(length: f64, height: f64, flipped: bool) -> Scrolls {
    let count = (length / (height * 0.98)).round().max(1.0);
    let pitch = length / count;
    let radius = 0.43 * height.min(pitch);
    let mut scrolls = Scrolls { weight: 0.12 * radius, ..Scrolls::default() };
    for index in 0..count as usize {
        let centre = DVec2::new((index as f64 + 0.5) * pitch, height / 2.0);
        let side = if (index % 2 == 0) == flipped { -1.0 } else { 1.0 };
        scrolls.add_volute(centre, radius, side);
        if index + 1 < count as usize {
            scrolls.add_stem(centre, pitch, radius, side, 0.0);
        }
        // Leaves in the corners: between volutes they look at the stem, at the end of the strip away from the volute.
        for edge in [-1.0, 1.0] {
            let corner = DVec2::new(1.0, edge).normalize();
            match index + 1 < count as usize {
                true => scrolls.add_sprig(
                    centre + DVec2::new(pitch / 2.0, edge * radius),
                    DVec2::NEG_Y * edge,
                    radius * 0.54,
                ),
                false => scrolls.add_sprig(centre + corner * radius * 1.05, corner, radius * 0.4),
            }
        }
    }
    let first = DVec2::new(-0.5 * pitch, height / 2.0);
    scrolls.add_stem(first, pitch, radius, if flipped { 1.0 } else { -1.0 }, 0.5);
    scrolls.add_sprig(DVec2::new(0.0, height * 0.62), DVec2::Y, radius * 0.62);
    scrolls
}

impl Scrolls {
    /// A spiral that starts at the crown of its circle and winds in to an eye, with leaves along its inside.
    fn add_volute(&mut self, centre: DVec2, radius: f64, side: f64) {
        const TURNS: f64 = 1.9;
        let spiral = |t: f64| {
            let angle = side * (TAU * TURNS * t - FRAC_PI_2);
            centre + direction(angle) * radius * (1.0 - 0.85 * libm::pow(t, 1.08))
        };
        let points: Vec<DVec2> = (0..=36).map(|i| spiral(f64::from(i) / 36.0)).collect();
        self.bold.add_smooth(&points[..=20], false);
        self.fine.add_smooth(&points[20..], false);
        self.eyes.add_dot(spiral(1.0));
        for leaf in 1..=8 {
            let at = f64::from(leaf) * 0.078;
            let (foot, ahead) = (spiral(at), spiral(at + 0.02));
            let forward = (ahead - foot).normalize_or(DVec2::X);
            let inward = (centre - foot).normalize_or(DVec2::Y);
            self.add_leaf(foot, forward * 0.8 + inward * 0.8, radius * 0.4 * (1.0 - at));
        }
    }

    /// The stem's bend from one volute's crown to the next, from a share of it on.
    fn add_stem(&mut self, centre: DVec2, pitch: f64, radius: f64, side: f64, from: f64) {
        let wave = |t: f64| centre + DVec2::new(t * pitch, -side * radius * libm::cos(PI * t));
        let points: Vec<DVec2> = (0..=12).map(|i| wave(from + (1.0 - from) * f64::from(i) / 12.0)).collect();
        self.bold.add_smooth(&points, false);
    }

    /// Five leaves in the corner between two volutes.
    fn add_sprig(&mut self, foot: DVec2, towards: DVec2, size: f64) {
        for turn in [-1.3, -0.65, 0.0, 0.65, 1.3] {
            self.add_leaf(foot, towards.rotate(direction(turn)), size * (1.0 - 0.3 * f64::abs(turn)));
        }
    }

    /// Eight petals in a ring at the middle of the bed.
    fn add_rosette(&mut self, radius: f64) {
        for i in 0..8 {
            let towards = direction(TAU * f64::from(i) / 8.0);
            self.add_leaf(towards * radius * 0.22, towards, radius * 0.62);
        }
        self.fine.add_circle(DVec2::ZERO, radius);
        self.eyes.add_dot(DVec2::ZERO);
    }

    /// A pointed leaf from its foot in a direction.
    fn add_leaf(&mut self, foot: DVec2, towards: DVec2, size: f64) {
        let towards = towards.normalize_or(DVec2::X) * size;
        let side = towards.perp() * 0.3;
        let tip = foot + towards;
        self.leaves.steps.extend([
            Step::Move(foot),
            Step::Curve(foot + towards * 0.3 + side, foot + towards * 0.7 + side, tip),
            Step::Curve(foot + towards * 0.7 - side, foot + towards * 0.3 - side, foot),
            Step::Close,
        ]);
    }
}
