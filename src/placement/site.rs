//! Where plants may stand: an area, what must be kept clear and by how much, and the disks that stand already.
//!
//! All distances are exact: offset polygons with their rounded corners decide nothing (they may be drawn). Everything
//! is in plan metres.

use crate::geometry::{Area, Bounds, nearest_on_segment};
use glam::DVec2;

/// Where plants may stand. Starts as an area and is narrowed.
#[derive(Clone, Debug, Default)]
pub struct Site {
    area: Area,
    kept: Vec<(Body, f64)>,
    standing: Vec<Disk>,
    seam: Option<Area>,
}

/// Something that plants keep away from.
#[derive(Clone, Debug, PartialEq)]
pub enum Body {
    /// A region: its inside and its rim.
    Area(Area),
    /// A line.
    Line(Vec<DVec2>),
    /// A point.
    Point(DVec2),
}

/// A place that is taken.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disk {
    /// Its centre.
    pub position: DVec2,
    /// Its radius, metres.
    pub radius: f64,
}

impl Site {
    /// The whole of an area, its rim included.
    pub fn new(area: Area) -> Site {
        Site { area, ..Site::default() }
    }

    /// The same, no centre nearer to `body` than `distance` metres, and none inside it. Distances below 0 are 0.
    pub fn clear_of(mut self, body: Body, distance: f64) -> Site {
        self.kept.push((body, distance.max(0.0)));
        self
    }

    /// The same, disks apart from those that stand.
    pub fn standing(mut self, disks: impl IntoIterator<Item = Disk>) -> Site {
        self.standing.extend(disks);
        self
    }

    /// The same, each disk wholly inside `lot`.
    pub fn within(mut self, lot: Area) -> Site {
        self.seam = Some(lot);
        self
    }

    /// Where centres may lie, before distances.
    pub fn area(&self) -> &Area {
        &self.area
    }

    /// The extent of its area.
    pub fn bounds(&self) -> Bounds {
        self.area.bounds()
    }

    /// What is kept clear, and by how many metres.
    pub fn kept(&self) -> &[(Body, f64)] {
        &self.kept
    }

    /// The disks that stand.
    pub fn taken(&self) -> &[Disk] {
        &self.standing
    }

    /// The lot that disks stay within.
    pub fn lot(&self) -> Option<&Area> {
        self.seam.as_ref()
    }

    /// Whether a disk may stand there. Costs the number of edges and disks.
    pub fn allows(&self, p: DVec2, radius: f64) -> bool {
        self.area.contains(p)
            && self.kept.iter().all(|(body, distance)| body.clear(p) >= *distance)
            && self.standing.iter().all(|disk| disk.position.distance(p) >= disk.radius + radius)
            && self.seam.as_ref().is_none_or(|lot| lot.contains(p) && lot.distance_to_edges(p) >= radius)
    }
}

impl Body {
    /// Metres to its nearest point; negative inside an area, by how deep the point lies.
    pub fn clear(&self, p: DVec2) -> f64 {
        match self {
            Body::Area(area) if area.contains(p) => -area.distance_to_edges(p),
            _ => self.distance(p),
        }
    }

    /// Metres to its nearest point; 0 inside an area.
    pub fn distance(&self, p: DVec2) -> f64 {
        match self {
            Body::Area(area) if area.contains(p) => 0.0,
            Body::Area(area) => area.distance_to_edges(p),
            Body::Line(points) => {
                let near = |w: &[DVec2]| nearest_on_segment(p, w[0], w[1]).distance(p);
                points.windows(2).map(near).fold(f64::INFINITY, f64::min)
            }
            Body::Point(q) => q.distance(p),
        }
    }
}
