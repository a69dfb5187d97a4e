//! The way from the start rule to one thing of a scene: each rule with its place, arguments and shape, and what it did
//! on the way to the next.
//!
//! In: a lot that was derived with its record, and the thing. Out: plain values, for text and JSON.

use crate::check::Program;
use crate::diag::Span;
use crate::scene::{Plant, Scene};
use crate::shape::{Derivation, Event, Lot, NodeId, Passage, Record};
use crate::trace::words::{deed, plain, thing_words};
use crate::trace::{Thing, shape_words};
use serde::Serialize;
use std::collections::BTreeMap;

/// Other plants that are named.
const MOST_NEAR: usize = 3;
/// How far (metres) other plants are looked for.
const FAR: f64 = 30.0;

/// Why something is there.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Explanation {
    /// `plant`, `object`, `solid`, `line` or `ground`.
    pub class: &'static str,
    /// Its stable id.
    pub id: String,
    /// What it is, in words.
    pub what: String,
    /// The lot; empty for what the layout brought.
    pub lot: String,
    /// The lot's seed, in hexadecimal.
    pub seed: String,
    /// The values of the attributes that the lot's rules may read, as the lot began.
    pub attributes: BTreeMap<String, String>,
    /// The rules from the start to it.
    pub steps: Vec<Step>,
    /// For plants: the radius that is kept clear of others, metres.
    pub reserved: Option<f64>,
    /// For plants: the nearest others.
    pub near: Vec<Neighbour>,
}

/// One rule on the way.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Step {
    /// Its name, or the symbol of a leaf.
    pub rule: String,
    /// `file:line` of the rule; empty for leaves.
    pub place: String,
    /// The line.
    pub source: String,
    /// Its arguments by name.
    pub arguments: Vec<(String, String)>,
    /// The shape that came to it, in words.
    pub shape: String,
    /// Attributes that were set since the rule before, with their new values.
    pub set: Vec<(String, String)>,
    /// What it did on the way to the next.
    pub did: Vec<Happened>,
}

/// One thing that a rule did.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Happened {
    /// What, in words.
    pub what: String,
    /// `file:line`.
    pub place: String,
    /// The line.
    pub source: String,
}

/// Another plant.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Neighbour {
    /// Its id.
    pub id: String,
    /// Its species, or its category.
    pub species: String,
    /// Metres from trunk to trunk.
    pub distance: f64,
    /// The radius that is kept clear around it, metres.
    pub reserved: f64,
}

/// Why a thing is there; without steps where the derivation has no record of its lot, or the layout brought it.
///
/// Cost: linear in the leaves of the lot and the plants of the scene.
pub fn explain(program: &Program, derivation: &Derivation, scene: &Scene, thing: Thing) -> Explanation {
    let origin = thing.origin();
    let plant = if let Thing::Plant(plant) = thing { Some(plant) } else { None };
    let mut explanation = Explanation {
        class: thing.class(),
        id: origin.id.to_string(),
        what: thing_words(thing),
        lot: origin.lot.to_string(),
        seed: String::new(),
        attributes: BTreeMap::new(),
        steps: Vec::new(),
        reserved: plant.map(|plant| plant.spacing_radius),
        near: plant.map_or_else(Vec::new, |plant| near(scene, plant)),
    };
    let lot = derivation.lots.iter().find(|lot| lot.id == origin.lot && !origin.lot.is_empty());
    let Some((lot, record)) = lot.and_then(|lot| Some((lot, lot.outcome.record.as_deref()?))) else {
        return explanation;
    };
    if let Some(first) = record.shapes.first() {
        explanation.seed = format!("{:016x}", first.shape.seed.0);
        let value = |slot: usize| first.shape.attributes.get(slot).map(plain).unwrap_or_default();
        explanation.attributes = program.public_attributes().map(|(s, a)| (a.name.to_string(), value(s))).collect();
    }
    explanation.steps = Chain { program, derivation, lot, record }.steps(&origin.id, &origin.rule);
    explanation
}

/// A lot on which a way is looked for.
struct Chain<'a> {
    program: &'a Program,
    derivation: &'a Derivation,
    lot: &'a Lot,
    record: &'a Record,
}

impl Chain<'_> {
    /// The way to the leaf with that seed and symbol; nothing where there is none.
    fn steps(&self, id: &str, symbol: &str) -> Vec<Step> {
        let Some(at) = self.leaf(id, symbol) else { return Vec::new() };
        let leaf = &self.lot.outcome.leaves[at];
        let mut way: Vec<NodeId> = vec![leaf.node];
        while let Some(parent) = self.parent(way[way.len() - 1]) {
            way.push(parent);
        }
        way.reverse();
        let trails = way.iter().skip(1).filter_map(|node| Some(&self.passage(*node)?.trail));
        let trails = trails.chain(self.record.leaves.get(at));
        let steps = way.iter().zip(trails);
        let mut steps: Vec<Step> = steps.filter_map(|(node, trail)| self.step(*node, trail)).collect();
        if let Some(last) = steps.last_mut().filter(|last| last.place.is_empty()) {
            last.shape = shape_words(&leaf.shape);
        }
        steps
    }

    fn leaf(&self, id: &str, symbol: &str) -> Option<usize> {
        let seed = u64::from_str_radix(id, 16).ok()?;
        let outcome = &self.lot.outcome;
        let name = |node: NodeId| &self.derivation.symbols[outcome.nodes[node.0 as usize].symbol as usize];
        outcome.leaves.iter().position(|leaf| leaf.shape.seed.0 == seed && &**name(leaf.node) == symbol)
    }

    fn parent(&self, node: NodeId) -> Option<NodeId> {
        let parent = self.lot.outcome.nodes[node.0 as usize].parent;
        (parent != node).then_some(parent)
    }

    fn passage(&self, node: NodeId) -> Option<&Passage> {
        self.record.shapes.get(node.0 as usize)
    }

    fn step(&self, id: NodeId, trail: &[Event]) -> Option<Step> {
        let (node, passage) = (self.lot.outcome.nodes[id.0 as usize], self.passage(id)?);
        let rule = node.rule.map(|rule| &self.program.rules[rule as usize]);
        let (place, source) = rule.map(|rule| self.written(rule.span)).unwrap_or_default();
        let names = rule.map_or(&[][..], |rule| &rule.names);
        let name = |index: usize| names.get(index).map_or_else(|| index.to_string(), ToString::to_string);
        Some(Step {
            rule: self.derivation.symbols[node.symbol as usize].to_string(),
            place,
            source,
            arguments: passage.args.iter().enumerate().map(|(i, value)| (name(i), plain(value))).collect(),
            shape: shape_words(&passage.shape),
            set: self.parent(id).map(|parent| self.set(parent, passage)).unwrap_or_default(),
            did: trail.iter().map(|event| self.happened(event)).collect(),
        })
    }

    fn set(&self, parent: NodeId, passage: &Passage) -> Vec<(String, String)> {
        let before = self.passage(parent).map(|parent| &parent.shape.attributes);
        let attributes = self.program.attributes.iter().enumerate();
        let changed = attributes.filter_map(|(slot, attribute)| {
            let (old, new) = (before?.get(slot)?, passage.shape.attributes.get(slot)?);
            (old != new).then(|| (attribute.name.to_string(), plain(new)))
        });
        changed.collect()
    }

    fn happened(&self, event: &Event) -> Happened {
        let (place, source) = self.written(event.span);
        Happened { what: deed(&event.deed), place, source }
    }

    /// `file:line`, and the line.
    fn written(&self, span: Span) -> (String, String) {
        let Some(source) = self.program.sources.get(span.file as usize) else { return Default::default() };
        let (line, _) = source.line_column(span.start);
        let text = source.text().lines().nth(line.saturating_sub(1)).unwrap_or_default();
        (format!("{}:{line}", source.path()), text.trim().to_string())
    }
}

fn near(scene: &Scene, plant: &Plant) -> Vec<Neighbour> {
    let others = scene.plants.iter().filter(|other| !std::ptr::eq(*other, plant));
    let distances = others.map(|other| (other.position.distance(plant.position), other));
    let mut others: Vec<(f64, &Plant)> = distances.filter(|(distance, _)| *distance <= FAR).collect();
    others.sort_by(|(a, _), (b, _)| a.total_cmp(b));
    let neighbour = |(distance, other): &(f64, &Plant)| Neighbour {
        id: other.origin.id.to_string(),
        species: if other.species.is_empty() { other.category.to_string() } else { other.species.to_string() },
        distance: (distance * 1e3).round() / 1e3,
        reserved: other.spacing_radius,
    };
    others.iter().take(MOST_NEAR).map(neighbour).collect()
}
