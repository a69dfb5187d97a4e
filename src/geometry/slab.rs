//! How much of an area lies before a line that sweeps over it, and where the line stands when it has swept a share.
//!
//! Between two corners of the outline the width of the section changes linearly, so the area swept grows with a
//! square: places are found by its root, not by trial.

use crate::geometry::Area;
use glam::DVec2;

/// The area swept by a line, as a function of where it stands.
pub struct Sweep {
    slabs: Vec<Slab>,
}

/// Between two corners: where it begins, how long it is, the width of the section at both ends, what lies before.
struct Slab {
    from: f64,
    length: f64,
    widths: [f64; 2],
    before: f64,
}

impl Sweep {
    /// Sweeps along a unit direction. Quadratic in the edges at worst: each adds to every slab that it crosses.
    pub fn new(area: &Area, along: DVec2) -> Sweep {
        let mut places: Vec<f64> = area.edges().map(|(a, _)| a.dot(along)).collect();
        places.sort_by(f64::total_cmp);
        places.dedup();
        let mut widths = vec![[0.0; 2]; places.len().saturating_sub(1)];
        for (a, b) in area.edges() {
            add(&places, &mut widths, (a.dot(along), a.dot(along.perp())), (b.dot(along), b.dot(along.perp())));
        }
        let (mut slabs, mut before) = (Vec::with_capacity(widths.len()), 0.0);
        for (pair, widths) in places.windows(2).zip(widths) {
            let slab = Slab { from: pair[0], length: pair[1] - pair[0], widths, before };
            before += slab.area();
            slabs.push(slab);
        }
        Sweep { slabs }
    }

    /// The whole area in m².
    pub fn area(&self) -> f64 {
        self.slabs.last().map_or(0.0, |slab| slab.before + slab.area())
    }

    /// Where the line stands when it has swept so many m²: at the ends for nothing or less, and for all or more.
    /// Logarithmic.
    pub fn place(&self, swept: f64) -> f64 {
        let Some(first) = self.slabs.first() else { return 0.0 };
        let index = self.slabs.partition_point(|slab| slab.before < swept).saturating_sub(1);
        let slab = &self.slabs[index];
        if swept <= 0.0 { first.from } else { slab.from + slab.depth(swept - slab.before) }
    }
}

impl Slab {
    fn area(&self) -> f64 {
        0.5 * (self.widths[0] + self.widths[1]).max(0.0) * self.length
    }

    /// How far into the slab so much area lies.
    fn depth(&self, area: f64) -> f64 {
        let (width, growth) = (self.widths[0].max(0.0), (self.widths[1] - self.widths[0]) / self.length);
        let root = (width * width + 2.0 * growth * area).max(0.0).sqrt();
        let depth = if width + root > 0.0 { 2.0 * area / (width + root) } else { self.length };
        depth.clamp(0.0, self.length)
    }
}

/// Adds an edge to the widths of the slabs that it crosses. The inside lies to its left, so one that runs up takes off
/// what one that runs down adds.
fn add(places: &[f64], widths: &mut [[f64; 2]], from: (f64, f64), to: (f64, f64)) {
    let (sign, low, high) = if from.0 < to.0 { (-1.0, from, to) } else { (1.0, to, from) };
    let rise = high.0 - low.0;
    if rise <= 0.0 {
        return;
    }
    let across = |place: f64| low.1 + (high.1 - low.1) * ((place - low.0) / rise).clamp(0.0, 1.0);
    let first = places.partition_point(|place| *place < low.0);
    let crossed = places.windows(2).zip(widths).skip(first).take_while(|(pair, _)| pair[1] <= high.0);
    for (pair, widths) in crossed {
        widths[0] += sign * across(pair[0]);
        widths[1] += sign * across(pair[1]);
    }
}
