//! Operations on the current shape: arguments in, pieces out, and what the lot remembers of them.

use crate::check::{Application, Block, Code};
use crate::derive::engine::{Current, Engine, Stop, Turn, record};
use crate::derive::evaluate::{self, Failure};
use crate::derive::frame::climb;
use crate::derive::position::{self, Varied};
use crate::derive::select;
use crate::diag::Span;
use crate::ops::{Component, Cut, Effect, Given, ParamKind, Part, Pieces};
use crate::placement::{Disk, Field};
use crate::seed::Seed;
use crate::shape::{Geometry, LeafOf, NodeId, Occluder, Print, Shape, on_plan};
use crate::value::{Array, Cells, Value};
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
            Block::Cuts(cuts) | Block::Perimeter { cuts, .. } => {
                select::cuts(cuts, &mut self.frame(turn, current)).map_err(|f| self.failed(f, turn))?
            }
            _ => Vec::new(),
        };
        let (mut values, mut fields) = (Values::new(), Fields::new());
        if application.ready.is_none() {
            self.arguments(application, turn, current, &mut values, &mut fields)?;
        }
        let mut chosen = match &application.block {
            Block::Selectors(selectors) | Block::Perimeter { rest: selectors, .. } => {
                let components = application.components(&mut values.clone(), &current.shape);
                let components = components.map_err(|p| self.problem(application, p, turn))?;
                self.on_edges(application, turn, current, &components, &mut values)?;
                let mut frame = self.frame(turn, current);
                let chosen = frame.with(|names, around| select::choose(selectors, &components, names, around));
                chosen.map_err(|f| self.failed(f, turn))?
            }
            _ => Vec::new(),
        };
        let depths = match &application.block {
            Block::Perimeter { depths, .. } => self.depths(application, depths, &cuts, &values, turn, current)?,
            _ => Vec::new(),
        };
        if let Block::Perimeter { depths, .. } = &application.block {
            // What bands leave goes to the bodies behind theirs.
            chosen.iter_mut().flatten().for_each(|choice| choice.entry += depths.len() as u16);
        }
        let seed = current.shape.seed.child(current.count);
        current.count += 1;
        let operands = match &application.block {
            Block::Operands => self.operands(application, seed, turn, current)?,
            _ => Vec::new(),
        };
        let (branches, branch) = (&self.branches, current.branch);
        let given = Given {
            cuts: &cuts,
            depths: &depths,
            chosen: &chosen,
            operands: &operands,
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
        let applied = self.recorder.is_some().then(|| record::applied(application, &values));
        let pieces = application.apply(&mut values, &mut current.shape, &given);
        let pieces = pieces.map_err(|p| self.problem(application, p, turn))?;
        let mark = self.mark();
        let goes_on = matches!(pieces, Pieces::Changed);
        self.happened(applied);
        self.deliver(application, pieces, seed, turn, current)?;
        // What an operation put beside the shape is not on the way of the shape itself.
        if !goes_on {
            self.release(mark);
        }
        Ok(())
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
            Pieces::Noted(parts, remarks) => {
                remarks.into_iter().for_each(|remark| self.remark(application, remark, turn));
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
                (_, ParamKind::OnEdges) => Ok(numbers(Vec::new())),
                (Some(value), _) => Ok(value.clone()),
                (None, ParamKind::Varying(_)) => self.varied(code, param.name, *span, turn, current, fields),
                (None, _) => self.frame(turn, current).with(|n, a| evaluate::evaluate(code, n, a)),
            });
            values.push(value.transpose().map_err(|f| self.failed(f, turn))?);
        }
        Ok(())
    }

    /// The depth of each section of a perimeter, evaluated with its own `split.index`.
    fn depths(
        &mut self,
        application: &Application,
        depths: &[(Code, Span)],
        cuts: &[Cut],
        values: &Values,
        turn: &Turn,
        current: &mut Current,
    ) -> Result<Vec<f64>, Stop> {
        let most = self.options.limits.children;
        let sections = application.sections(&mut values.clone(), &current.shape, cuts, most);
        let sections = sections.map_err(|p| self.problem(application, p, turn))?;
        let mut section = (*current.shape).clone();
        let mut frame = self.frame(turn, current);
        let mut depth = |(index, entry): (usize, &u16)| {
            section.ordinals.split = (index as u32, sections.len() as u32);
            let Some((code, span)) = depths.get(usize::from(*entry)) else { return Ok(0.0) };
            frame.on(&section, |n, a| evaluate::number(code, n, a, *span))
        };
        let found = sections.iter().enumerate().map(&mut depth).collect::<Result<Vec<f64>, Failure>>();
        found.map_err(|f| self.failed(f, turn))
    }

    /// The arguments that are asked on every component, as arrays.
    fn on_edges(
        &mut self,
        application: &Application,
        turn: &Turn,
        current: &mut Current,
        components: &[Component],
        values: &mut Values,
    ) -> Result<(), Stop> {
        let params = application.operation.spec.params.iter().enumerate();
        for (index, _) in params.filter(|(_, param)| param.kind == ParamKind::OnEdges) {
            let Some(code) = &application.args[index] else { continue };
            let span = application.arg_spans[index];
            let mut frame = self.frame(turn, current);
            let edges = components.iter().filter(|component| !component.is_rest());
            let asked = edges.map(|edge| frame.on(&edge.shape, |n, a| evaluate::number(code, n, a, span)));
            let found = asked.collect::<Result<Vec<f64>, Failure>>();
            values[index] = Some(numbers(found.map_err(|f| self.failed(f, turn))?));
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
        let total = parts.len();
        for (index, part) in parts.into_iter().enumerate() {
            let mut shape = part.shape;
            shape.seed = seed.child(index as u64);
            let Some(body) = application.bodies.get(part.entry as usize) else { continue };
            if self.program.asks_for_selectors && matches!(application.block, Block::Selectors(_)) {
                Arc::make_mut(&mut shape.style).selector = application.selector(part.entry);
            }
            let current = Current::new(shape, self.branch(branch));
            let mark = self.mark();
            self.took(application, part.entry, index, total, turn);
            match self.body(body, turn, current) {
                Err(Stop::Branch(diagnostic)) => self.outcome.diagnostics.push(*diagnostic),
                other => other?,
            }
            self.release(mark);
        }
        Ok(())
    }

    fn effect(&mut self, application: &Application, effect: Effect, turn: &Turn, current: &Current) {
        match effect {
            Effect::Remark(remark) => self.remark(application, remark, turn),
            Effect::Report(key, value) => self.outcome.reports.push((key, value)),
            Effect::Print(value) => {
                let symbol = self.outcome.nodes[turn.node.0 as usize].symbol;
                self.tell(symbol);
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
        if self.program.asks_for_solids && self.stays(&shape) && shape.is_closed() {
            self.intra.add(Occluder { label: None, layer: None, node: Some(branch), footprint: shape.footprint() });
        }
        self.built();
        self.outcome.leaves.push(LeafOf { node, shape });
    }
}

/// Numbers as a value.
fn numbers(numbers: Vec<f64>) -> Value {
    Value::Array(Arc::new(Array::row(Cells::Numbers(numbers))))
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
