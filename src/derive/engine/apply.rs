//! Operations on the current shape: arguments in, pieces out, and what the lot remembers of them.

use crate::check::{Application, Block, Code};
use crate::derive::engine::{Current, Engine, Stop, Turn};
use crate::derive::evaluate::{self, Failure};
use crate::derive::frame::climb;
use crate::derive::position::{self, Varied};
use crate::derive::select;
use crate::diag::Span;
use crate::ops::{Effect, Given, ParamKind, Part, Pieces};
use crate::placement::{Disk, Field};
use crate::seed::Seed;
use crate::shape::{Geometry, LeafOf, NodeId, Occluder, Print, Shape, on_plan};
use crate::value::Value;
use glam::DVec3;
use smallvec::SmallVec;
use std::sync::Arc;

/// Arguments of an operation, in the order of its parameters.
type Values = SmallVec<[Option<Value>; 6]>;

/// Arguments that vary over the shape, by parameter.
type Fields = Vec<(&'static str, Field)>;

impl Engine<'_> {
    pub(super) fn application(
        &mut self,
        application: &Application,
        turn: &Turn,
        current: &mut Current,
    ) -> Result<(), Stop> {
        let cuts = match &application.block {
            Block::Cuts(cuts) => {
                select::cuts(cuts, &mut self.frame(turn, current)).map_err(|f| self.failed(f, turn))?
            }
            _ => Vec::new(),
        };
        let (mut values, mut fields) = (Values::new(), Fields::new());
        self.arguments(application, turn, current, &mut values, &mut fields)?;
        let chosen = match &application.block {
            Block::Selectors(selectors) => {
                let components = application.operation.components(&mut values.clone(), &current.shape);
                let components = components.map_err(|p| self.problem(application, p, turn))?;
                let mut frame = self.frame(turn, current);
                select::choose(selectors, &components, &mut frame).map_err(|f| self.failed(f, turn))?
            }
            _ => Vec::new(),
        };
        let seed = current.shape.seed.child(current.count);
        current.count += 1;
        let (branches, branch) = (&self.branches, current.branch);
        let given = Given {
            cuts: &cuts,
            chosen: &chosen,
            seed,
            lot: self.seed,
            run: self.options.seed,
            around: &current.around,
            fields: &fields,
            outline: &self.outline,
            edge_attributes: &self.initial.edge_attributes,
            tags: self.program.asks_for_tags,
            standing: &self.standing,
            intra: &self.intra,
            inter: &self.inter,
            beyond: &self.beyond,
            names: self.names,
            is_ancestor: &|other| climb(branches, branch).any(|own| own == other),
            catalogue: self.options.catalogue,
            world: self.options.world,
            rasters: self.rasters,
            most: self.options.limits.children,
        };
        let pieces = application.operation.apply(&mut values, &mut current.shape, &given);
        let pieces = pieces.map_err(|p| self.problem(application, p, turn))?;
        self.deliver(application, pieces, seed, turn, current)
    }

    /// Passes on what an operation made.
    fn deliver(
        &mut self,
        application: &Application,
        pieces: Pieces,
        seed: Seed,
        turn: &Turn,
        current: &mut Current,
    ) -> Result<(), Stop> {
        match pieces {
            Pieces::Changed => current.changed(),
            Pieces::Vanished => current.deleted = true,
            Pieces::Told(effect) => self.effect(application, effect, turn, current),
            Pieces::Parts(parts) => {
                current.used = true;
                self.parts(application, parts, (seed, current.branch), turn)?;
            }
            Pieces::Beside(parts) => self.parts(application, parts, (seed, current.branch), turn)?,
            Pieces::Placed(mut parts, remarks) => {
                remarks.into_iter().for_each(|remark| self.remark(application, remark, turn));
                // What is placed on the plan stands from now on, whatever becomes of it and when.
                for shape in parts.iter_mut().map(|part| &mut part.shape).filter(|shape| is_upright(shape)) {
                    shape.ordinals.place.disk = self.standing.add(disk(shape, shape.ordinals.place.radius));
                }
                self.parts(application, parts, (seed, current.branch), turn)?;
            }
        }
        Ok(())
    }

    fn arguments(
        &mut self,
        application: &Application,
        turn: &Turn,
        current: &mut Current,
        values: &mut Values,
        fields: &mut Fields,
    ) -> Result<(), Stop> {
        let params = application.operation.spec.params.iter().zip(&application.arg_spans);
        for (arg, (param, span)) in application.args.iter().zip(params) {
            let value = arg.as_ref().map(|code| match (code.known(), param.kind) {
                (Some(value), _) => Ok(value.clone()),
                (None, ParamKind::Varying(_)) => self.varied(code, param.name, *span, turn, current, fields),
                (None, _) => self.frame(turn, current).with(|n, a| evaluate::evaluate(code, n, a)),
            });
            values.push(value.transpose().map_err(|f| self.failed(f, turn))?);
        }
        Ok(())
    }

    /// The value of an argument that may vary; where it does, its mean, and the whole among the fields.
    fn varied(
        &self,
        code: &Code,
        name: &'static str,
        span: Span,
        turn: &Turn,
        current: &mut Current,
        fields: &mut Fields,
    ) -> Result<Value, Failure> {
        match position::vary(code, span, &mut self.frame(turn, current), &self.outline)? {
            Varied::Same(value) => Ok(value),
            Varied::Grid(grid) => {
                let mean = grid.mean();
                fields.push((name, Field::Grid(Arc::new(grid))));
                Ok(Value::Float(mean))
            }
        }
    }

    /// Runs the block's bodies on the pieces; a piece that fails is left out and the others go on.
    fn parts(
        &mut self,
        application: &Application,
        parts: Vec<Part>,
        (seed, branch): (Seed, NodeId),
        turn: &Turn,
    ) -> Result<(), Stop> {
        if self.outcome.nodes.len() + self.queue.len() + parts.len() > self.options.limits.shapes {
            let message = format!("the lot has more shapes than the limit `shapes` of {}", self.options.limits.shapes);
            return Err(Stop::Lot(Box::new(self.diagnostic("limit", application.span, message, turn.node))));
        }
        for (index, part) in parts.into_iter().enumerate() {
            let mut shape = Box::new(part.shape);
            shape.seed = seed.child(index as u64);
            let Some(body) = application.bodies.get(part.entry as usize) else { continue };
            let current = Current::new(shape, self.branch(branch));
            match self.body(body, turn, current) {
                Err(Stop::Branch(diagnostic)) => self.outcome.diagnostics.push(*diagnostic),
                other => other?,
            }
        }
        Ok(())
    }

    fn effect(&mut self, application: &Application, effect: Effect, turn: &Turn, current: &Current) {
        match effect {
            Effect::Remark(remark) => self.remark(application, remark, turn),
            Effect::Report(key, value) => self.outcome.reports.push((key, value)),
            Effect::Print(value) => {
                let symbol = self.outcome.nodes[turn.node.0 as usize].symbol;
                self.outcome.prints.push(Print { symbol, value });
            }
            Effect::Label(label) if self.program.looks_around => {
                let footprint = current.shape.footprint();
                self.intra.add(Occluder { label: Some(label), layer: None, node: Some(current.branch), footprint });
            }
            Effect::Label(_) => {}
        }
    }

    /// A plant stands with its crown, unless it is the one for which a placement has reserved a place.
    fn stand(&mut self, plant: &Shape) {
        let size = plant.scope.size;
        let crown = disk(plant, 0.5 * size.x.max(size.z));
        let reserved = plant.ordinals.place.disk.and_then(|number| self.standing.get(number));
        if reserved.is_none_or(|own| own.position.distance(crown.position) > own.radius) {
            self.standing.add(crown);
        }
    }

    pub(super) fn leaf(&mut self, node: NodeId, branch: NodeId, shape: Box<Shape>) {
        if self.program.looks_around && is_plant(&shape) && is_upright(&shape) {
            self.stand(&shape);
        }
        if self.program.asks_for_solids && shape.is_closed() {
            self.intra.add(Occluder { label: None, layer: None, node: Some(branch), footprint: shape.footprint() });
        }
        self.outcome.leaves.push(LeafOf { node, shape });
    }
}

/// Whether its y points up: what is set on walls takes no place on the plan.
fn is_upright(shape: &Shape) -> bool {
    (shape.scope.frame.rotation * DVec3::Y).y > 0.999
}

/// A plant that is built.
fn is_plant(shape: &Shape) -> bool {
    matches!(&shape.geometry, Geometry::Element(placed) if placed.round)
}

/// The middle of a shape on the plan, with a radius about it.
fn disk(shape: &Shape, radius: f64) -> Disk {
    let size = shape.scope.size;
    let middle = shape.scope.frame.to_world(DVec3::new(size.x * 0.5, 0.0, size.z * 0.5));
    Disk { position: on_plan(middle), radius }
}
