//! What stands between a selector and its successor: `:`, `=` or `=:`, and the areas and faces that it puts together.

use crate::geometry::{self, Area};
use crate::ops::{Choice, Part, fit};
use crate::shape::{Geometry, Plane, Shape};
use glam::DVec2;
use std::collections::BTreeMap;

/// Which components of an entry become one shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Gather {
    /// `:`: each is a shape of its own.
    Each,
    /// `=`: all in one shape.
    All,
    /// `=:`: what hangs together is one shape.
    Connected,
}

/// Gives the shapes that entries have taken their `comp.index` and `comp.total`: each entry counts its own.
pub fn count<'s>(taken: impl Iterator<Item = (u16, &'s mut Shape)>) {
    let mut entries: BTreeMap<u16, Vec<&mut Shape>> = BTreeMap::new();
    taken.for_each(|(entry, shape)| entries.entry(entry).or_default().push(shape));
    for shapes in entries.into_values() {
        let total = shapes.len() as u32;
        (0..).zip(shapes).for_each(|(index, shape)| shape.ordinals.comp = (index, total));
    }
}

/// Regions of one plane on their way to the entries that chose them.
pub struct Gathered<'s> {
    parent: &'s Shape,
    plane: &'s Plane,
    parts: Vec<Part>,
    waiting: BTreeMap<u16, (Gather, Vec<Area>)>,
    rest: Vec<Part>,
}

impl<'s> Gathered<'s> {
    /// Nothing yet, on a plane of `parent`.
    pub fn new(parent: &'s Shape, plane: &'s Plane) -> Gathered<'s> {
        Gathered { parent, plane, parts: Vec::new(), waiting: BTreeMap::new(), rest: Vec::new() }
    }

    /// A region for an entry; alone its x runs along a direction of the plane, or as the parent's without one.
    pub fn add(&mut self, choice: Choice, area: Area, along: Option<DVec2>) {
        if choice.gather != Gather::Each {
            return self.waiting.entry(choice.entry).or_insert((choice.gather, Vec::new())).1.push(area);
        }
        let shape = match along {
            Some(along) => fit::aligned(self.parent, self.plane, &area, along),
            None => self.fitted(area),
        };
        self.parts.extend(shape.map(|shape| Part::new(choice.entry, shape)));
    }

    /// What is left over, in the parent's frame: it comes last. Its polygons are each a shape unless `=` joins them.
    pub fn rest(&mut self, choice: Choice, area: Area) {
        let shapes: Vec<Shape> = match choice.gather {
            Gather::All => self.fitted(area).into_iter().collect(),
            _ => area.polygons().iter().filter_map(|part| self.fitted(part.clone().into())).collect(),
        };
        self.rest.extend(shapes.into_iter().map(|shape| Part::new(choice.entry, shape)));
    }

    /// All parts, those of their own first; `comp.index` and `comp.total` count those of each entry.
    pub fn parts(mut self) -> Vec<Part> {
        for (entry, (gather, areas)) in std::mem::take(&mut self.waiting) {
            let whole = geometry::union_all(&areas);
            let sets: Vec<Area> = match gather {
                Gather::Connected => whole.polygons().iter().map(|part| Area::from(part.clone())).collect(),
                _ => vec![whole],
            };
            let shapes: Vec<Part> =
                sets.into_iter().filter_map(|set| Some(Part::new(entry, self.fitted(set)?))).collect();
            self.parts.extend(shapes);
        }
        self.parts.append(&mut self.rest);
        count(self.parts.iter_mut().map(|part| (part.entry, &mut *part.shape)));
        self.parts
    }

    fn fitted(&self, area: Area) -> Option<Shape> {
        fit::fitted(self.parent, Geometry::Flat(self.plane.clone(), area))
    }
}
