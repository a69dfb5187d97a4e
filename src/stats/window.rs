//! Where points may lie: a region with its rim, ready for questions.
//!
//! In: areas in plane metres. Out: what lies inside, how far the rim is, and which share of a circle is inside, which
//! is the edge correction of Ripley (1977) and exact for polygons with holes.

use crate::geometry::{Area, union_all};
use crate::stats::Segments;
use glam::DVec2;
use std::cmp::Ordering;

/// Points nearer than this (metres) to the rim lie on it: positions in files are rounded.
const ON_RIM: f64 = 1e-6;
/// No pair counts for more than so many: tiny shares of circles in corners would drown the others (as in spatstat).
const MOST_WEIGHT: f64 = 100.0;

/// A region in which a point pattern is observed.
#[derive(Clone, Debug)]
pub struct Window {
    area: Area,
    square_metres: f64,
    rim: Segments,
}

/// The part of the rim near a point, from the nearest edge outwards.
#[derive(Debug, Default)]
pub(super) struct Near {
    edges: Vec<(f64, DVec2, DVec2)>,
}

impl Window {
    /// The union of the areas; `None` where nothing is left.
    pub fn new<'a>(areas: impl IntoIterator<Item = &'a Area>) -> Option<Window> {
        let area = union_all(areas);
        let square_metres = area.area();
        let rim = Segments::new(area.edges().collect());
        (square_metres > 0.0 && square_metres.is_finite()).then_some(Window { area, square_metres, rim })
    }

    /// The region.
    pub fn region(&self) -> &Area {
        &self.area
    }

    /// Its area in m²; positive.
    pub fn area(&self) -> f64 {
        self.square_metres
    }

    /// Length of its rim in metres, that of holes included.
    pub fn perimeter(&self) -> f64 {
        self.area.perimeter()
    }

    /// Whether the point lies inside or on the rim (within a micrometre). About the root of the number of edges.
    pub fn contains(&self, p: DVec2) -> bool {
        p.is_finite()
            && (self.rim.crossings_right_of(p) % 2 == 1 || self.rim.within(p, ON_RIM).any(|(away, ..)| away <= ON_RIM))
    }

    /// Distance to the rim in metres, from inside or outside.
    pub fn distance_to_rim(&self, p: DVec2) -> f64 {
        self.rim.distance(p)
    }

    /// The same, everything times `factor`, which must be positive and finite.
    pub(super) fn scaled(&self, factor: f64) -> Window {
        let area: Area = self.area.polygons().iter().map(|part| part.mapped(|p| p * factor)).collect();
        let rim = Segments::new(area.edges().collect());
        Window { square_metres: area.area(), rim, area }
    }

    /// Fills `near` with the edges within `reach` metres of `p`.
    pub(super) fn look(&self, p: DVec2, reach: f64, near: &mut Near) {
        near.edges.clear();
        let within = self.rim.within(p, reach).filter(|(distance, ..)| *distance < reach);
        near.edges.extend(within.map(|(distance, a, b)| (distance, a - p, b - p)));
        near.edges.sort_unstable_by(|x, y| x.0.total_cmp(&y.0).then(order(x.1, y.1)).then(order(x.2, y.2)));
    }
}

impl Near {
    /// What a pair at `distance` metres counts for: one over the share of the circle through the one around the other
    /// that lies in the window. The circle must be within the reach that was looked at.
    pub(super) fn weight(&self, distance: f64) -> f64 {
        match self.edges.first() {
            Some((nearest, ..)) if *nearest < distance => (1.0 / self.share(distance)).clamp(1.0, MOST_WEIGHT),
            _ => 1.0,
        }
    }

    /// The share of the circle of `radius` metres that lies inside; all of it where no edge crosses it.
    ///
    /// The inside is left of every edge, so an edge that leaves the disk begins an arc of the inside and one that
    /// enters it ends one: the angles of the ends less those of the beginnings are the arcs, up to whole turns.
    fn share(&self, radius: f64) -> f64 {
        let square = radius * radius;
        let (mut sum, mut first, mut first_ends) = (0.0, f64::INFINITY, true);
        let mut cross = |at: DVec2, leaves: bool| {
            let angle = libm::atan2(at.y, at.x);
            sum += if leaves { -angle } else { angle };
            if angle < first {
                (first, first_ends) = (angle, !leaves);
            }
        };
        for (_, a, b) in self.edges.iter().take_while(|(nearest, ..)| *nearest < radius) {
            let (a_in, b_in) = (a.length_squared() < square, b.length_squared() < square);
            if a_in && b_in {
                continue;
            }
            let along = *b - *a;
            let length = along.length_squared();
            let middle = -a.dot(along) / length;
            let foot = *a + along * middle;
            let half = ((square - foot.length_squared()).max(0.0) / length).sqrt();
            if !a_in {
                cross(*a + along * (middle - half), false);
            }
            if !b_in {
                cross(*a + along * (middle + half), true);
            }
        }
        let turn = std::f64::consts::TAU;
        (sum + if first_ends { turn } else { 0.0 }) / turn
    }
}

/// Any order that depends on the numbers alone.
fn order(a: DVec2, b: DVec2) -> Ordering {
    a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y))
}
