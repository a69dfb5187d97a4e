//! Items → regions and features in plan metres.

use crate::geometry::{Polygon, repair, stroke};
use crate::layout::geojson::document::{Flaw, Item, Parts, Place, are_degrees};
use crate::layout::geojson::order::Order;
use crate::layout::geojson::properties::{Properties, Words};
use crate::layout::geojson::report::Report;
use crate::layout::nearby::Origins;
use crate::layout::{Crs, Feature, Georeference, Kind, Layout, Region, Shapes};
use glam::DVec2;
use std::collections::HashMap;
use std::sync::Arc;

/// Farther from the plan's origin than this (metres), lengths of a plan are off by more than 1 in 10,000.
const FAR: f64 = 90_000.0;

/// Farther than this (metres) there is no place: more than twice around the earth.
const FARTHEST: f64 = 1e8;

/// The layout under construction.
pub struct Builder {
    layout: Layout,
    origins: Origins,
    region_ids: Ids,
    feature_ids: Ids,
    words: Words,
    items: usize,
}

/// The geometry of an item in the plan.
#[derive(Default)]
struct Placed {
    polygons: Vec<Polygon>,
    /// For each polygon where its edges come from.
    orders: Vec<Order>,
    lines: Vec<Vec<DVec2>>,
    points: Vec<DVec2>,
    is_repaired: bool,
    is_far: bool,
}

impl Builder {
    /// An empty layout with its way back to the world.
    pub fn new(georeference: Georeference) -> Builder {
        Builder {
            layout: Layout { georeference, ..Layout::default() },
            origins: Origins::default(),
            region_ids: Ids::default(),
            feature_ids: Ids::default(),
            words: Words::default(),
            items: 0,
        }
    }

    /// The layout, its relations still open.
    pub fn finish(self) -> (Layout, Origins) {
        (self.layout, self.origins)
    }

    /// Adds one item, or reports why not.
    pub fn add(&mut self, item: Item, report: &mut Report) {
        self.items += 1;
        let parts = match item.parts {
            Ok(parts) => parts,
            Err(flaw) => return report.leave_out(&item.id, &flaw),
        };
        let Some(placed) = self.place(&item.id, &parts, report) else { return };
        let mut properties = Properties::of(&item.properties, &mut self.words);
        report.note_properties(&item.id, &properties);
        let kind = properties.kind.take().unwrap_or_else(|| report.guessed(guess(&placed, &properties)));
        let elevation = properties.elevation.unwrap_or_else(|| mean_height(&parts));
        let facts = Facts { id: item.id, kind, elevation, properties };
        let has_region = self.add_regions(&facts, &placed, report);
        if !has_region && facts.kind.needs_area() {
            report.without_area.add(&facts.id);
        }
        self.add_features(&facts, placed, report);
    }

    /// The item's parts in the plan; nothing where none is usable.
    fn place(&self, id: &str, parts: &Parts, report: &mut Report) -> Option<Placed> {
        let mut placed = Placed::default();
        let mut flaws = Vec::new();
        for rings in &parts.polygons {
            match self.polygons(rings, &mut placed.is_repaired) {
                Ok(polygons) => {
                    let ring = self.outline(&rings[0]);
                    placed.orders.extend(polygons.iter().map(|polygon| Order::of(&ring, polygon)));
                    placed.polygons.extend(polygons);
                }
                Err(flaw) => flaws.push(flaw),
            }
        }
        for line in &parts.lines {
            match self.line(line) {
                Ok(line) => placed.lines.push(line),
                Err(flaw) => flaws.push(flaw),
            }
        }
        for point in &parts.points {
            match self.point(point) {
                Ok(point) => placed.points.push(point),
                Err(flaw) => flaws.push(flaw),
            }
        }
        let Some(first) = placed.first() else {
            flaws.first().into_iter().for_each(|flaw| report.leave_out(id, flaw));
            return None;
        };
        flaws.iter().for_each(|flaw| report.leave_out_part(id, flaw));
        placed.is_far = first.length() > FAR;
        report.note_placing(id, placed.is_repaired, placed.is_far);
        Some(placed)
    }

    /// The sound polygons that an outline with holes stands for.
    fn polygons(&self, rings: &[Vec<Place>], is_repaired: &mut bool) -> Result<Vec<Polygon>, Flaw> {
        let mut plan = Vec::with_capacity(rings.len());
        for ring in rings {
            let (ring, is_sound) = open(ring.iter().map(|p| self.point(p)).collect::<Result<_, _>>()?);
            *is_repaired |= !is_sound;
            plan.push(ring);
        }
        if plan.first().is_none_or(|outline| outline.len() < 3) {
            return Err(Flaw::TooFew(3));
        }
        let (area, was_unsound) = repair(&plan);
        *is_repaired |= was_unsound;
        if area.is_empty() { Err(Flaw::NoArea) } else { Ok(area.polygons().to_vec()) }
    }

    /// The outline as the file has it, without its closing point.
    fn outline(&self, ring: &[Place]) -> Vec<DVec2> {
        let mut ring: Vec<DVec2> = ring.iter().filter_map(|place| self.point(place).ok()).collect();
        if ring.len() > 1 && ring.first() == ring.last() {
            ring.pop();
        }
        ring
    }

    fn line(&self, line: &[Place]) -> Result<Vec<DVec2>, Flaw> {
        let mut points: Vec<DVec2> = line.iter().map(|p| self.point(p)).collect::<Result<_, _>>()?;
        points.dedup();
        if points.len() < 2 { Err(Flaw::TooFew(2)) } else { Ok(points) }
    }

    fn point(&self, (world, _): &Place) -> Result<DVec2, Flaw> {
        let georeference = &self.layout.georeference;
        if georeference.crs == Crs::Wgs84 && !are_degrees(*world) {
            return Err(Flaw::OffTheGlobe);
        }
        let plan = georeference.to_plan(*world);
        if plan.is_finite() && plan.abs().max_element() < FARTHEST { Ok(plan) } else { Err(Flaw::Unplaceable) }
    }

    /// The regions an item makes, of its areas and of its lines with a width; whether there are any.
    fn add_regions(&mut self, facts: &Facts, placed: &Placed, report: &mut Report) -> bool {
        if !facts.kind.is_region() {
            return false;
        }
        let width = facts.properties.width;
        let strokes = placed.lines.iter().filter(|_| width > 0.0 && facts.kind.is_drawn_by_lines());
        let strokes = strokes.flat_map(|line| stroke(line, width).polygons().to_vec());
        let polygons: Vec<Polygon> = placed.polygons.iter().cloned().chain(strokes).collect();
        if polygons.is_empty() {
            return false;
        }
        let base = self.region_ids.claim(&facts.id, report);
        let is_one = polygons.len() == 1;
        for (index, polygon) in polygons.into_iter().enumerate() {
            let part = || format!("{base}/{}", index + 1);
            let id = if is_one { base.clone() } else { self.region_ids.claim(&part(), report) };
            let mut region = facts.region(id, polygon);
            if placed.orders.get(index).is_some_and(|order| !order.settle(&mut region.attributes)) {
                report.unsettled.add(&facts.id);
            }
            self.layout.regions.push(region);
            self.origins.regions.push(self.items);
        }
        true
    }

    /// The features an item makes: one each for its areas, lines and points.
    fn add_features(&mut self, facts: &Facts, placed: Placed, report: &mut Report) {
        let areas = !placed.polygons.is_empty() && facts.kind.is_feature();
        let shapes = [
            (areas, "areas", Shapes::Areas(placed.polygons)),
            (!placed.lines.is_empty(), "lines", Shapes::Lines(placed.lines, facts.properties.width)),
            (!placed.points.is_empty(), "points", Shapes::Points(placed.points)),
        ];
        let mut base: Option<Arc<str>> = None;
        for (_, word, shapes) in shapes.into_iter().filter(|(is_there, ..)| *is_there) {
            let id = match &base {
                None => self.feature_ids.claim(&facts.id, report),
                Some(base) => self.feature_ids.claim(&format!("{base}/{word}"), report),
            };
            base.get_or_insert_with(|| id.clone());
            self.layout.features.push(facts.feature(id, shapes));
            self.origins.features.push(self.items);
        }
    }
}

impl Placed {
    /// Where it begins; nothing where there is nothing.
    fn first(&self) -> Option<DVec2> {
        let outlines = self.polygons.iter().flat_map(|p| p.points());
        outlines.chain(self.lines.iter().flatten()).chain(&self.points).next().copied()
    }
}

/// What all regions and features of an item share.
struct Facts {
    id: Arc<str>,
    kind: Kind,
    elevation: f64,
    properties: Properties,
}

impl Facts {
    fn region(&self, id: Arc<str>, polygon: Polygon) -> Region {
        Region {
            name: self.properties.name.clone().unwrap_or_else(|| id.clone()),
            id,
            kind: self.kind.clone(),
            zone: self.properties.zone.clone(),
            polygon,
            elevation: self.elevation,
            start: self.properties.start.clone(),
            seed: self.properties.seed,
            attributes: self.properties.attributes.clone(),
            features: Vec::new(),
            neighbours: Vec::new(),
        }
    }

    fn feature(&self, id: Arc<str>, shapes: Shapes) -> Feature {
        Feature {
            name: self.properties.name.clone().unwrap_or_else(|| id.clone()),
            id,
            kind: self.kind.clone(),
            shapes,
            elevation: self.elevation,
            height: self.properties.height,
            attributes: self.properties.attributes.clone(),
        }
    }
}

/// Ids given so far, with the number of the next suffix of each.
#[derive(Default)]
struct Ids(HashMap<Arc<str>, usize>);

impl Ids {
    /// The id, or the id with the first suffix `-2`, `-3` … that is free.
    fn claim(&mut self, wanted: &str, report: &mut Report) -> Arc<str> {
        let mut id: Arc<str> = wanted.into();
        if self.0.contains_key(&id) {
            report.renamed.add(wanted);
        }
        while self.0.contains_key(&id) {
            let suffix = self.0.entry(wanted.into()).or_insert(1);
            *suffix += 1;
            id = format!("{wanted}-{suffix}").into();
        }
        self.0.insert(id.clone(), 1);
        id
    }
}

/// What an item without a kind is taken for.
fn guess(placed: &Placed, properties: &Properties) -> Kind {
    if !placed.polygons.is_empty() {
        Kind::Lot
    } else if !placed.lines.is_empty() {
        Kind::Other("line".into())
    } else if properties.attributes.contains_key("species") {
        Kind::Tree
    } else {
        Kind::Marker("point".into())
    }
}

/// The mean of the heights of an item's positions; 0 where there are none.
fn mean_height(parts: &Parts) -> f64 {
    let heights = parts.positions().filter_map(|(_, height)| *height).filter(|h| h.abs() < FARTHEST);
    let (count, sum) = heights.fold((0usize, 0.0), |(count, sum), h| (count + 1, sum + h));
    if count == 0 { 0.0 } else { sum / count as f64 }
}

/// The ring without its closing and repeated points, and whether it was closed and had none repeated.
fn open(mut ring: Vec<DVec2>) -> (Vec<DVec2>, bool) {
    let is_closed = ring.len() > 1 && ring.first() == ring.last();
    if is_closed {
        ring.pop();
    }
    let count = ring.len();
    ring.dedup();
    let is_sound = is_closed && ring.len() == count;
    (ring, is_sound)
}
