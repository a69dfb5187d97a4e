//! The medial axis of an area: the points with more than one nearest point on the rim, and how far the rim is.
//!
//! In: an area, and what to prune. Out: branches, polylines that run between ends and junctions, with the clearance of
//! every point. The axis of each part is connected and has a loop around each hole. (Choi, Choi and Moon 1997, which
//! Niese et al. 2022, §5.3 follow; here by way of the Voronoi cells of the edges.)
//!
//! What the Voronoi crate answers is checked: every point inside, every clearance the distance to the rim, connected,
//! as many loops as holes. Where it is not so, the outline is turned and tried again, and at last the axis is drawn
//! through a triangulation, coarser but always there.

mod check;
mod chordal;
mod outline;
mod skeleton;
mod voronoi;

use crate::geometry::{Area, Polygon};
use check::Rim;
use glam::DVec2;
use outline::Outline;
use skeleton::Skeleton;

/// Angles (radians) by which the outline is turned for each attempt: any that make no edge upright again would do.
const TURNS: [f64; 3] = [0.0, 0.5432, 1.2345];

/// The medial axis of an area.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct MedialAxis {
    branches: Vec<Branch>,
}

/// A piece of the axis without a junction inside it.
#[derive(Clone, Debug, PartialEq)]
pub struct Branch {
    /// From one end to the other, metres; the first again as the last where it is a loop, and a single point where the
    /// axis of a part is no more than that (a square's).
    pub points: Vec<DVec2>,
    /// The distance of each point to the rim, metres.
    pub clearances: Vec<f64>,
    /// The junctions or dead ends it runs between: branches that meet share a number, which no other part uses.
    pub nodes: [u32; 2],
    /// The index of its part in the area's polygons.
    pub part: u32,
}

/// What of the axis is left out. Loops around holes always stay.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Pruning {
    /// A branch that ends blindly is left out where it is shorter than this times the clearance at its junction.
    ///
    /// All such go at once, then again while there are any. 0 keeps every branch.
    pub branch: f64,
    /// The axis runs into corners that are sharper than this (degrees); 180 runs into all of them, 0 into none. It ends
    /// at the centre of the disk that touches three edges elsewhere.
    pub corner: f64,
}

impl Default for Pruning {
    /// Right angles, rounded or not, end no branch, nor do alcoves that are hardly deeper than wide; a gore does.
    fn default() -> Pruning {
        Pruning { branch: 1.5, corner: 30.0 }
    }
}

impl Branch {
    /// Whether it is a loop.
    pub fn is_closed(&self) -> bool {
        self.points.len() > 1 && self.nodes[0] == self.nodes[1]
    }

    /// Its length, metres.
    pub fn length(&self) -> f64 {
        self.points.windows(2).map(|w| w[0].distance(w[1])).sum()
    }
}

impl MedialAxis {
    /// The axis of an area, each part by itself.
    ///
    /// Points are true to 2 mm: vertices are rounded to a millimetre first (in parts wider than 500 km, to a share of
    /// the width), and rings thinner than that are neither parts nor holes. Curved pieces deviate from their parabolas
    /// by at most 5 mm. Costs n log n for n vertices.
    pub fn new(area: &Area, pruning: Pruning) -> MedialAxis {
        let mut branches = Vec::new();
        let mut nodes = 0;
        for (part, polygon) in area.polygons().iter().enumerate() {
            let skeleton = skeleton_of(polygon, pruning);
            let found = skeleton.branches(pruning.branch, part as u32, nodes);
            nodes += skeleton.nodes.len() as u32;
            branches.extend(found);
        }
        MedialAxis { branches }
    }

    /// Its branches, part by part.
    pub fn branches(&self) -> &[Branch] {
        &self.branches
    }

    /// Length of all branches, metres.
    pub fn length(&self) -> f64 {
        self.branches.iter().map(Branch::length).sum()
    }
}

/// The first attempt that passes its checks, or the chordal axis.
fn skeleton_of(polygon: &Polygon, pruning: Pruning) -> Skeleton {
    let rim = Rim::new(polygon);
    let attempt = |turn: &f64| {
        let outline = Outline::new(polygon, *turn)?;
        let skeleton = voronoi::skeleton(&outline, pruning.corner)?;
        rim.proves(&skeleton, &outline).then_some(skeleton)
    };
    TURNS.iter().find_map(attempt).unwrap_or_else(|| chordal::skeleton(polygon, &rim))
}
