//! Which sides of a lot lie on a street: what `street.front` and its like ask.
//!
//! In: the outline of a region and the width of the street along each of its edges (CityEngine's `streetWidth`), on
//! the plan. Out: for a component of any shape of the lot, by the middle of it and the way it looks, its street side.

use crate::geometry::{Polygon, nearest_on_segment};
use glam::DVec2;

/// Components nearer than this (metres) to an edge of the outline, and along it, are that edge.
const ON_EDGE: f64 = 1e-3;

/// A component looks the way of a street where the cosine between the two is at least this: within 45°.
const SAME_WAY: f64 = std::f64::consts::FRAC_1_SQRT_2 - 1e-9;

/// The edges of a lot and which of them have a street.
#[derive(Clone, Debug, PartialEq)]
pub struct Streets {
    edges: Vec<(DVec2, DVec2)>,
    /// Whether each edge has a street.
    open: Vec<bool>,
    /// The outward direction of the edge with the widest street.
    front: DVec2,
}

/// Where a component lies as seen from the widest street.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum StreetSide {
    /// On a street.
    Front,
    /// Away from it.
    Back,
    /// To the left of one who stands on the street and looks at the lot.
    Left,
    /// To the right.
    Right,
}

impl Streets {
    /// The streets of a lot, one width for each edge of its outline in their order; missing ones are 0, and 0 (or less)
    /// is no street. `None` without a street.
    pub fn new(outline: &Polygon, widths: &[f64]) -> Option<Streets> {
        let edges: Vec<(DVec2, DVec2)> = outline.edges().take(outline.outer().len()).collect();
        let open: Vec<bool> = (0..edges.len()).map(|i| widths.get(i).is_some_and(|w| *w > 0.0)).collect();
        let wider = |best: usize, i: usize| if widths[i] > widths[best] { i } else { best };
        let widest = (0..edges.len()).filter(|i| open[*i]).reduce(wider)?;
        let front = outward(edges[widest])?;
        Some(Streets { edges, open, front })
    }

    /// The street side of a component with its middle there and looking that way, both on the plan. Linear in the
    /// edges.
    ///
    /// What lies along the outline is on a street where its edge has one; what lies within the lot where it looks the
    /// way of such an edge. `None` where it looks nowhere: up or down.
    pub fn side(&self, middle: DVec2, towards: DVec2) -> Option<StreetSide> {
        let towards = towards.try_normalize()?;
        if self.faces_street(middle, towards) {
            return Some(StreetSide::Front);
        }
        Some(if towards.dot(self.front) <= -SAME_WAY {
            StreetSide::Back
        } else if self.front.perp_dot(towards) > 0.0 {
            StreetSide::Right
        } else {
            StreetSide::Left
        })
    }

    fn faces_street(&self, middle: DVec2, towards: DVec2) -> bool {
        let along = |(edge, _): &(&(DVec2, DVec2), &bool)| {
            let near = nearest_on_segment(middle, edge.0, edge.1).distance(middle) < ON_EDGE;
            near && outward(**edge).is_some_and(|way| way.dot(towards) > 1.0 - 1e-6)
        };
        let edges = || self.edges.iter().zip(&self.open);
        match edges().find(along) {
            Some((_, open)) => *open,
            None => edges().any(|(edge, open)| *open && outward(*edge).is_some_and(|w| w.dot(towards) >= SAME_WAY)),
        }
    }
}

/// The way an edge of an outline looks; the inside lies to its left.
fn outward((a, b): (DVec2, DVec2)) -> Option<DVec2> {
    Some(-(b - a).try_normalize()?.perp())
}
