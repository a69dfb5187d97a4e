//! What can occlude: features of the lot, labelled shapes and closed leaves, found by a grid on the plan.

use crate::geometry::{self, Area, Bounds};
use crate::shape::{Extent, Footprint, NodeId};
use glam::DVec2;
use std::collections::HashMap;
use std::sync::Arc;

/// Overlaps below this area (m²) are touches.
const LEAST_OVERLAP: f64 = 1e-6;
/// Shapes nearer than this (m) touch.
const TOUCH: f64 = 1e-3;
/// So few are looked at one by one; cells are filled when there are more.
const FEW: usize = 24;
/// Cells a wide occluder may stand in before it is looked at in every query instead.
const MOST_CELLS: i64 = 4096;
/// Nothing is looked for beyond this (m).
const FARTHEST: f64 = 1e8;

/// How one shape lies to another.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Relation {
    /// Wholly inside it.
    Inside,
    /// They share an inner part.
    Overlaps,
    /// They meet, without sharing an inner part.
    Touches,
}

/// One thing that can occlude.
#[derive(Clone, Debug)]
pub struct Occluder {
    /// The name it is found by; unlabelled ones are found when they are closed.
    pub label: Option<Arc<str>>,
    /// The layer a feature belongs to, where it says so.
    pub layer: Option<Arc<str>>,
    /// The branch of the derivation it stands on; none for features and neighbours.
    pub node: Option<NodeId>,
    /// Its plan and heights.
    pub footprint: Footprint,
}

/// A growing set of occluders. Cost of a query: the occluders in the cells it touches.
#[derive(Clone, Debug)]
pub struct Occluders {
    items: Vec<(Bounds, Occluder)>,
    cell: f64,
    // Looked up by cell only, never walked: its order cannot show.
    cells: HashMap<(i64, i64), Vec<u32>>,
    wide: Vec<u32>,
}

impl Default for Occluders {
    fn default() -> Occluders {
        Occluders::new(Bounds::EMPTY)
    }
}

impl Occluders {
    /// An empty set for a region of this extent.
    pub fn new(extent: Bounds) -> Occluders {
        let cell = (extent.size().max_element() / 64.0).clamp(1.0, 100.0);
        Occluders { items: Vec::new(), cell, cells: HashMap::new(), wide: Vec::new() }
    }

    /// Takes one more in; what has no extent cannot occlude.
    pub fn add(&mut self, occluder: Occluder) {
        let bounds = occluder.footprint.extent.bounds();
        if bounds.is_empty() {
            return;
        }
        self.items.push((bounds, occluder));
        let count = self.items.len();
        let missing = if count == FEW + 1 { 0 } else { count - 1 };
        (missing..count).filter(|_| count > FEW).for_each(|index| self.sort(index as u32));
    }

    /// Puts one into the cells that it touches.
    fn sort(&mut self, index: u32) {
        let bounds = self.items[index as usize].0;
        let (low, high) = (self.cell_of(bounds.min), self.cell_of(bounds.max));
        if cells(low, high) > MOST_CELLS {
            self.wide.push(index);
            return;
        }
        for x in low.0..=high.0 {
            (low.1..=high.1).for_each(|y| self.cells.entry((x, y)).or_default().push(index));
        }
    }

    /// Whether any occluder of that label lies so to the shape; ancestors do not count.
    pub fn any(
        &self,
        shape: &Footprint,
        label: Option<&str>,
        relation: Relation,
        is_ancestor: &dyn Fn(NodeId) -> bool,
    ) -> bool {
        let bounds = shape.extent.bounds();
        !bounds.is_empty()
            && self.near(bounds.grown(TOUCH)).any(|occluder| {
                occluder.answers_to(label)
                    && !occluder.node.is_some_and(is_ancestor)
                    && levels_meet(shape, &occluder.footprint)
                    && relates(&shape.extent, &occluder.footprint.extent, relation)
            })
    }

    /// The areas under a label near a place, ancestors included, grown by a margin.
    pub fn areas(&self, near: Bounds, label: &str, margin: f64) -> Vec<Area> {
        let found = self.near(near.grown(margin)).filter(|o| o.answers_to(Some(label)));
        found.filter_map(|o| o.footprint.extent.grown(margin)).collect()
    }

    /// Whether anything answers to the label.
    pub fn has(&self, label: &str) -> bool {
        self.items.iter().any(|(_, occluder)| occluder.answers_to(Some(label)))
    }

    /// Everything under a label, in the order it came.
    pub fn labelled<'a>(&'a self, label: &'a str) -> impl Iterator<Item = &'a Occluder> {
        self.items.iter().map(|(_, occluder)| occluder).filter(move |occluder| occluder.answers_to(Some(label)))
    }

    /// Distance to the nearest under a label; ancestors do not count. `None` where there is none.
    ///
    /// Looks in a reach that grows until it is sure of what it found.
    pub fn nearest(&self, shape: &Footprint, label: &str, is_ancestor: &dyn Fn(NodeId) -> bool) -> Option<f64> {
        let bounds = shape.extent.bounds();
        let mut reach = self.cell;
        while !bounds.is_empty() && reach <= FARTHEST {
            let near = self.near(bounds.grown(reach));
            let found = near.filter(|o| o.answers_to(Some(label)) && !o.node.is_some_and(is_ancestor));
            match found.map(|o| shape.distance(&o.footprint)).reduce(f64::min) {
                Some(distance) if distance <= reach => return Some(distance),
                Some(distance) => reach = distance,
                None => reach *= 8.0,
            }
        }
        None
    }

    /// What may touch a rectangle, in the order it came.
    pub fn near(&self, bounds: Bounds) -> impl Iterator<Item = &Occluder> {
        let (low, high) = (self.cell_of(bounds.min), self.cell_of(bounds.max));
        let mut found: Vec<u32> = if self.items.len() <= FEW || cells(low, high) > MOST_CELLS {
            (0..self.items.len() as u32).collect()
        } else {
            let cells = (low.0..=high.0).flat_map(|x| (low.1..=high.1).map(move |y| (x, y)));
            let inside = cells.filter_map(|cell| self.cells.get(&cell)).flatten();
            inside.chain(&self.wide).copied().collect()
        };
        found.sort_unstable();
        found.dedup();
        found.into_iter().map(|i| &self.items[i as usize]).filter(move |(b, _)| b.touches(bounds)).map(|(_, o)| o)
    }

    fn cell_of(&self, point: DVec2) -> (i64, i64) {
        ((point.x / self.cell).floor() as i64, (point.y / self.cell).floor() as i64)
    }
}

/// How many cells lie between two, both included; margins may be absurd.
fn cells(low: (i64, i64), high: (i64, i64)) -> i64 {
    let along = |from: i64, to: i64| to.saturating_sub(from).saturating_add(1);
    along(low.0, high.0).saturating_mul(along(low.1, high.1))
}

impl Occluder {
    fn answers_to(&self, label: Option<&str>) -> bool {
        match label {
            Some(label) => self.label.as_deref() == Some(label),
            None => self.footprint.closed,
        }
    }
}

impl Extent {
    /// The least rectangle around it.
    pub fn bounds(&self) -> Bounds {
        match self {
            Extent::Nothing => Bounds::EMPTY,
            Extent::Point(point) => Bounds::of([*point]),
            Extent::Line(points) => Bounds::of(points.iter().copied()),
            Extent::Area(area) => area.bounds(),
        }
    }

    /// The area within a margin of it; none for nothing, and for points and lines without a margin.
    pub fn grown(&self, margin: f64) -> Option<Area> {
        match self {
            Extent::Area(area) if margin > 0.0 => Some(geometry::buffered(area, margin)),
            Extent::Area(area) => Some(area.clone()),
            Extent::Point(point) if margin > 0.0 => {
                crate::geometry::Polygon::regular(*point, margin, 24).map(Area::from)
            }
            Extent::Line(points) if margin > 0.0 => Some(geometry::stroke(points, 2.0 * margin)),
            _ => None,
        }
    }
}

/// Flat shapes stand for all heights; solids must share a level.
fn levels_meet(a: &Footprint, b: &Footprint) -> bool {
    !a.closed || !b.closed || (a.low < b.high && b.low < a.high)
}

fn relates(shape: &Extent, other: &Extent, relation: Relation) -> bool {
    match relation {
        Relation::Inside => inside(shape, other),
        Relation::Overlaps => overlaps(shape, other),
        Relation::Touches => !overlaps(shape, other) && meets(shape, other),
    }
}

fn inside(shape: &Extent, other: &Extent) -> bool {
    match (shape, other) {
        (Extent::Point(point), Extent::Area(area)) => area.contains(*point),
        (Extent::Line(points), Extent::Area(area)) => along(points).all(|p| area.contains(p)),
        (Extent::Area(a), Extent::Area(b)) => geometry::overlap_area(a, b) >= a.area() - LEAST_OVERLAP,
        _ => false,
    }
}

fn overlaps(shape: &Extent, other: &Extent) -> bool {
    match (shape, other) {
        (Extent::Area(a), Extent::Area(b)) => geometry::overlaps(a, b, LEAST_OVERLAP),
        (Extent::Point(point), Extent::Area(area)) | (Extent::Area(area), Extent::Point(point)) => {
            area.contains(*point)
        }
        (Extent::Line(points), Extent::Area(area)) | (Extent::Area(area), Extent::Line(points)) => {
            along(points).any(|p| area.contains(p))
        }
        _ => false,
    }
}

fn meets(shape: &Extent, other: &Extent) -> bool {
    let near = |points: Vec<DVec2>, area: &Area| points.into_iter().any(|p| area.distance_to_edges(p) <= TOUCH);
    match (shape, other) {
        (Extent::Area(a), Extent::Area(b)) => near(corners(a), b) || near(corners(b), a),
        (Extent::Point(point), Extent::Area(area)) | (Extent::Area(area), Extent::Point(point)) => {
            near(vec![*point], area)
        }
        (Extent::Line(points), Extent::Area(area)) | (Extent::Area(area), Extent::Line(points)) => {
            near(along(points).collect(), area)
        }
        (Extent::Point(a), Extent::Point(b)) => a.distance(*b) <= TOUCH,
        (Extent::Line(a), Extent::Line(b)) => {
            let near = |p: DVec2, line: &[DVec2]| {
                line.windows(2).any(|w| geometry::nearest_on_segment(p, w[0], w[1]).distance(p) <= TOUCH)
            };
            a.iter().any(|p| near(*p, b)) || b.iter().any(|p| near(*p, a))
        }
        (Extent::Point(p), Extent::Line(line)) | (Extent::Line(line), Extent::Point(p)) => {
            line.windows(2).any(|w| geometry::nearest_on_segment(*p, w[0], w[1]).distance(*p) <= TOUCH)
        }
        _ => false,
    }
}

fn corners(area: &Area) -> Vec<DVec2> {
    area.edges().map(|(a, _)| a).collect()
}

/// Points along a line, no further than a quarter of a metre apart where that takes fewer than a thousand.
fn along(points: &[DVec2]) -> impl Iterator<Item = DVec2> {
    points.windows(2).flat_map(|w| {
        let steps = ((w[0].distance(w[1]) / 0.25).ceil() as usize).clamp(1, 1000);
        let (a, b) = (w[0], w[1]);
        (0..=steps).map(move |i| a.lerp(b, i as f64 / steps as f64))
    })
}
