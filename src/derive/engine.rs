//! One lot: a work list of shapes, derived depth first in the order of the text.
//!
//! A rule runs from left to right on the current shape; each symbol met is a successor with the state of that moment,
//! queued behind the rule. Where a rule names no successor the current shape is what is built; points set on a shape
//! (`scatter`, `Distr`) do not use it up.

use crate::check::{Alternative, Application, Block, Body, Program, Step, Successor};
use crate::derive::evaluate::{self, Failure, Names};
use crate::derive::frame::Frame;
use crate::derive::{Options, Progress, initial, select};
use crate::diag::{self, Diagnostic, Span};
use crate::functions::{Initial, Surroundings};
use crate::layout::Layout;
use crate::ops::{Effect, Given, Part, Pieces, Problem};
use crate::raster::Rasters;
use crate::seed::{Random, Seed};
use crate::shape::{LeafOf, Node, NodeId, Occluder, Occluders, Outcome, Print, Scope, Shape};
use crate::value::Value;
use smallvec::SmallVec;
use std::sync::Arc;
use std::time::Instant;

/// Between two looks at the clock.
const CLOCK: usize = 1024;

/// Arguments of a rule; most have none, and waiting shapes shall be small.
type Args = Box<[Value]>;

/// Arguments of an operation, in the order of its parameters.
type Values = SmallVec<[Option<Value>; 6]>;

/// Derives one region.
pub(super) fn lot(
    program: &Program,
    layout: &Layout,
    index: usize,
    rule: u32,
    options: &Options,
    rasters: &Rasters,
    progress: &Progress,
) -> Outcome {
    let region = &layout.regions[index];
    let symbol = program.rules[rule as usize].symbol;
    let start = program.symbols[symbol as usize].clone();
    let seed = initial::seed(region, options.seed);
    let mut shape = Box::new(initial::shape(region, seed));
    let looking = program.looks_around;
    let mut engine = Engine {
        program,
        options,
        rasters,
        progress,
        initial: initial::facts(region, start),
        intra: if looking { initial::intra(layout, region) } else { Occluders::default() },
        inter: if looking { initial::inter(layout, region) } else { Occluders::default() },
        lot: region.id.clone(),
        seed,
        outcome: Outcome::default(),
        queue: Vec::new(),
        branches: vec![NodeId(0)],
        begun: Instant::now(),
    };
    engine.attributes(&mut shape, region);
    let (args, rule) = (Args::default(), Some(rule));
    engine.queue.push(Task { shape, parent: NodeId(0), branch: NodeId(0), symbol, rule, args, depth: 0 });
    engine.run();
    engine.outcome
}

/// A shape that waits for its rule. Shapes are large and pass through many hands, so they stay in their box from the
/// operation that made them to the leaf.
struct Task {
    shape: Box<Shape>,
    parent: NodeId,
    /// The branch that it came from.
    branch: NodeId,
    symbol: u32,
    rule: Option<u32>,
    args: Args,
    depth: u32,
}

/// Why a rule ends early.
enum Stop {
    /// This shape is left out.
    Branch(Box<Diagnostic>),
    /// A limit: the lot ends here.
    Lot(Box<Diagnostic>),
}

struct Engine<'a> {
    program: &'a Program,
    options: &'a Options<'a>,
    rasters: &'a Rasters<'a>,
    progress: &'a Progress,
    initial: Initial,
    intra: Occluders,
    inter: Occluders,
    lot: Arc<str>,
    /// The seed of the lot.
    seed: Seed,
    outcome: Outcome,
    queue: Vec<Task>,
    /// For occlusion a tree finer than that of the nodes, as each branch's parent: every piece of a block and every
    /// bracket is a branch of its own, so that siblings within a rule see each other.
    branches: Vec<NodeId>,
    begun: Instant,
}

/// A rule at work on a node.
struct Turn {
    node: NodeId,
    args: Args,
    depth: u32,
}

/// The current shape and what became of it so far.
struct Current {
    shape: Box<Shape>,
    random: Random,
    /// Its branch.
    branch: NodeId,
    /// The scope when the rule, piece or bracket began: what `center` centres in.
    around: Scope,
    /// Successors and operations so far: the seeds' index.
    count: u64,
    /// It has successors, so it is not built itself.
    used: bool,
    /// `NIL`.
    deleted: bool,
    /// The last successor: it takes the shape over where nothing follows, so that most shapes are never copied.
    heir: Option<Heir>,
}

/// A successor that waits for its shape.
struct Heir {
    symbol: u32,
    rule: Option<u32>,
    args: Args,
    seed: Seed,
}

impl Current {
    fn new(shape: Box<Shape>, branch: NodeId) -> Current {
        let random = shape.seed.draw("rand");
        Current { branch, around: shape.scope, shape, random, count: 0, used: false, deleted: false, heir: None }
    }

    /// After an operation: a new seed begins its numbers anew.
    fn changed(&mut self, seed: Seed) {
        if self.shape.seed != seed {
            self.random = self.shape.seed.draw("rand");
        }
    }
}

impl Engine<'_> {
    /// The attributes on the initial shape.
    fn attributes(&mut self, shape: &mut Shape, region: &crate::layout::Region) {
        let attributes = &self.program.attributes;
        let given = |slot: usize| {
            let set = self.options.set.iter().rev().find(|(s, _)| *s == slot).map(|(_, value)| value.clone());
            let attribute = &attributes[slot];
            set.or_else(|| {
                attribute.names().find_map(|name| region.attributes.get(name)).filter(|_| attribute.public).cloned()
            })
        };
        let mut random = shape.seed.random();
        let mut around = Surroundings {
            shape,
            random: &mut random,
            intra: &self.intra,
            inter: &self.inter,
            is_ancestor: &|_| false,
            initial: &self.initial,
        };
        let calls = self.options.limits.calls;
        let (values, failures) = evaluate::attributes(self.program, given, &mut around, calls);
        shape.attributes = values;
        for failure in failures {
            let diagnostic = Diagnostic::error("value", failure.span, failure.message);
            self.outcome.diagnostics.push(Diagnostic { lot: Some(self.lot.clone()), ..diagnostic });
        }
    }

    fn run(&mut self) {
        while let Some(task) = self.queue.pop() {
            if let Err(stop) = self.within_limits(&task).and_then(|()| self.task(task)) {
                match stop {
                    Stop::Branch(diagnostic) => self.outcome.diagnostics.push(*diagnostic),
                    Stop::Lot(diagnostic) => {
                        self.outcome.diagnostics.push(*diagnostic);
                        break;
                    }
                }
            }
            if self.progress.stopped() {
                break;
            }
        }
        let found = std::mem::take(&mut self.outcome.diagnostics);
        self.outcome.diagnostics = gathered(found);
    }

    fn within_limits(&self, task: &Task) -> Result<(), Stop> {
        let limits = &self.options.limits;
        let shapes = self.outcome.nodes.len();
        let message = if task.depth as usize > limits.depth {
            format!("rules are nested deeper than the limit `depth` of {}", limits.depth)
        } else if shapes + self.queue.len() >= limits.shapes {
            format!("the lot has more shapes than the limit `shapes` of {}", limits.shapes)
        } else if shapes.is_multiple_of(CLOCK) && self.begun.elapsed() > limits.time {
            format!("the lot takes longer than the limit `time` of {} s", limits.time.as_secs())
        } else {
            return Ok(());
        };
        let span = task.rule.map_or(Span::default(), |r| self.program.rules[r as usize].span);
        let hint = "a rule that comes back to itself needs a `case` that ends it";
        Err(Stop::Lot(Box::new(self.diagnostic("limit", span, message, task.parent).hint(hint))))
    }

    fn task(&mut self, task: Task) -> Result<(), Stop> {
        let node = NodeId(self.outcome.nodes.len() as u32);
        let parent = if node.0 == 0 { node } else { task.parent };
        self.outcome.nodes.push(Node { parent, symbol: task.symbol, rule: task.rule });
        let branch = self.branch(task.branch);
        let Some(rule) = task.rule else {
            self.leaf(node, branch, task.shape);
            return Ok(());
        };
        let turn = Turn { node, args: task.args, depth: task.depth };
        let (program, waiting) = (self.program, self.queue.len());
        let done = self.body(&program.rules[rule as usize].body, &turn, Current::new(task.shape, branch));
        if done.is_err() {
            self.queue.truncate(waiting);
        }
        // The first successor is the next to be derived.
        self.queue[waiting..].reverse();
        done
    }

    /// Runs a body on a shape of its own; what names no successor is built.
    fn body(&mut self, body: &Body, turn: &Turn, mut current: Current) -> Result<(), Stop> {
        self.steps(body, turn, &mut current)?;
        match current.heir {
            Some(heir) => self.succeed(heir, current.shape, current.branch, turn),
            None if !current.used && !current.deleted => self.leaf(turn.node, current.branch, current.shape),
            None => {}
        }
        Ok(())
    }

    fn steps(&mut self, body: &Body, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
        match body {
            Body::Steps(steps) => {
                for step in steps {
                    self.settle(turn, current);
                    self.step(step, turn, current)?;
                    if current.deleted {
                        break;
                    }
                }
                Ok(())
            }
            Body::Case(arms, otherwise, span) => {
                for (test, body) in arms {
                    if self
                        .frame(turn, current)
                        .with(|n, a| evaluate::truth(test, n, a, *span))
                        .map_err(|f| self.failed(f, turn))?
                    {
                        return self.steps(body, turn, current);
                    }
                }
                self.steps(otherwise, turn, current)
            }
            Body::Chance(arms, otherwise, span) => {
                let mut left = current.random.uniform(0.0, 100.0);
                for (percent, body) in arms {
                    left -= self
                        .frame(turn, current)
                        .with(|n, a| evaluate::number(percent, n, a, *span))
                        .map_err(|f| self.failed(f, turn))?;
                    if left < 0.0 {
                        return self.steps(body, turn, current);
                    }
                }
                self.steps(otherwise, turn, current)
            }
            Body::Alternatives(alternatives) => match self.alternative(alternatives, turn, current)? {
                Some(body) => self.steps(body, turn, current),
                None => Ok(()),
            },
        }
    }

    /// Of the alternatives whose condition holds one by probability, or the first where none has one.
    fn alternative<'p>(
        &mut self,
        alternatives: &'p [Alternative],
        turn: &Turn,
        current: &mut Current,
    ) -> Result<Option<&'p Body>, Stop> {
        let mut open: SmallVec<[(&Body, Option<f64>); 4]> = SmallVec::new();
        for alternative in alternatives {
            let span = alternative.span;
            let mut frame = self.frame(turn, current);
            let holds =
                alternative.condition.as_ref().map_or(Ok(true), |c| frame.with(|n, a| evaluate::truth(c, n, a, span)));
            if holds.map_err(|f| self.failed(f, turn))? {
                let weight = alternative
                    .probability
                    .as_ref()
                    .map(|p| self.frame(turn, current).with(|n, a| evaluate::number(p, n, a, span)));
                open.push((&alternative.body, weight.transpose().map_err(|f| self.failed(f, turn))?));
            }
        }
        if open.iter().all(|(_, weight)| weight.is_none()) {
            return Ok(open.first().map(|(body, _)| *body));
        }
        // What has no probability of its own shares what the others leave of 1.
        let given: f64 = open.iter().filter_map(|(_, weight)| *weight).sum();
        let silent = open.iter().filter(|(_, weight)| weight.is_none()).count().max(1) as f64;
        let rest = (1.0 - given).max(0.0) / silent;
        let weights: SmallVec<[f64; 4]> = open.iter().map(|(_, weight)| weight.unwrap_or(rest)).collect();
        Ok(current.random.choose(&weights).map(|index| open[index].0))
    }

    fn step(&mut self, step: &Step, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
        match step {
            Step::Delete => current.deleted = true,
            Step::Successor(successor) => self.successor(successor, turn, current)?,
            Step::Apply(application) => self.application(application, turn, current)?,
            Step::Push(body) => self.bracket(body, turn, current)?,
        }
        Ok(())
    }

    /// Runs a bracket on a copy of the shape. What it inserts or raises without naming a successor is built, as in
    /// the papers; what fails in it is left out, and the rule goes on.
    fn bracket(&mut self, body: &Body, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
        let mut shape = current.shape.clone();
        shape.seed = current.shape.seed.child(current.count);
        current.count += 1;
        let before = std::mem::discriminant(&shape.geometry);
        let mut inner = Current::new(shape, self.branch(current.branch));
        match self.steps(body, turn, &mut inner) {
            Err(Stop::Branch(diagnostic)) => {
                self.outcome.diagnostics.push(*diagnostic);
                current.used = true;
                return Ok(());
            }
            other => other?,
        }
        let made = inner.shape.is_closed() && std::mem::discriminant(&inner.shape.geometry) != before;
        let built = made && !inner.used && !inner.deleted;
        current.used |= inner.used || built;
        match inner.heir {
            Some(heir) => self.succeed(heir, inner.shape, inner.branch, turn),
            None if built => self.leaf(turn.node, inner.branch, inner.shape),
            None => {}
        }
        Ok(())
    }

    /// A new branch that grows from another.
    fn branch(&mut self, parent: NodeId) -> NodeId {
        if !self.program.looks_around {
            return parent;
        }
        self.branches.push(parent);
        NodeId(self.branches.len() as u32 - 1)
    }

    fn successor(&mut self, successor: &Successor, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
        let mut args = Vec::with_capacity(successor.args.len());
        for arg in &successor.args {
            let value = self.frame(turn, current).with(|n, a| evaluate::evaluate(arg, n, a));
            args.push(value.map_err(|f| self.failed(f, turn))?);
        }
        let seed = current.shape.seed.child(current.count);
        current.heir = Some(Heir { symbol: successor.symbol, rule: successor.rule, args: args.into(), seed });
        current.count += 1;
        current.used = true;
        Ok(())
    }

    /// A step follows, so the last successor gets a copy.
    fn settle(&mut self, turn: &Turn, current: &mut Current) {
        if let Some(heir) = current.heir.take() {
            self.succeed(heir, current.shape.clone(), current.branch, turn);
        }
    }

    fn succeed(&mut self, heir: Heir, mut shape: Box<Shape>, branch: NodeId, turn: &Turn) {
        let Heir { symbol, rule, args, seed } = heir;
        shape.seed = seed;
        self.queue.push(Task { shape, parent: turn.node, branch, symbol, rule, args, depth: turn.depth + 1 });
    }

    fn application(&mut self, application: &Application, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
        let cuts = match &application.block {
            Block::Cuts(cuts) => {
                select::cuts(cuts, &mut self.frame(turn, current)).map_err(|f| self.failed(f, turn))?
            }
            _ => Vec::new(),
        };
        let mut values = Values::new();
        self.arguments(application, turn, current, &mut values)?;
        let chosen = match &application.block {
            Block::Selectors(selectors) => {
                let components = application.operation.components(&mut values.clone(), &current.shape);
                let components = components.map_err(|p| self.problem(application, p, turn))?;
                let mut frame = self.frame(turn, current);
                select::choose(selectors, &components, &mut frame).map_err(|f| self.failed(f, turn))?
            }
            _ => Vec::new(),
        };
        let (own_seed, seed) = (current.shape.seed, current.shape.seed.child(current.count));
        current.count += 1;
        let given = Given {
            cuts: &cuts,
            chosen: &chosen,
            seed,
            lot: self.seed,
            run: self.options.seed,
            around: &current.around,
            intra: &self.intra,
            inter: &self.inter,
            catalogue: self.options.catalogue,
            world: self.options.world,
            rasters: self.rasters,
            most: self.options.limits.children,
        };
        let pieces = application.operation.apply(&mut values, &mut current.shape, &given);
        match pieces.map_err(|p| self.problem(application, p, turn))? {
            Pieces::Changed => current.changed(own_seed),
            Pieces::Vanished => current.deleted = true,
            Pieces::Told(effect) => self.effect(effect, turn, current),
            Pieces::Parts(parts) => {
                current.used = true;
                self.parts(application, parts, (seed, current.branch), turn)?;
            }
            Pieces::Beside(parts) => self.parts(application, parts, (seed, current.branch), turn)?,
        }
        Ok(())
    }

    fn arguments(
        &mut self,
        application: &Application,
        turn: &Turn,
        current: &mut Current,
        values: &mut Values,
    ) -> Result<(), Stop> {
        for arg in &application.args {
            let value = arg.as_ref().map(|code| match code.known() {
                Some(value) => Ok(value.clone()),
                None => self.frame(turn, current).with(|n, a| evaluate::evaluate(code, n, a)),
            });
            values.push(value.transpose().map_err(|f| self.failed(f, turn))?);
        }
        Ok(())
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

    fn effect(&mut self, effect: Effect, turn: &Turn, current: &Current) {
        match effect {
            Effect::Report(key, value) => self.outcome.reports.push((key, value)),
            Effect::Print(value) => {
                let symbol = self.outcome.nodes[turn.node.0 as usize].symbol;
                self.outcome.prints.push(Print { symbol, value });
            }
            Effect::Label(label) if self.program.looks_around => {
                let footprint = current.shape.footprint();
                self.intra.add(Occluder { label: Some(label), node: Some(current.branch), footprint });
            }
            Effect::Label(_) => {}
        }
    }

    fn leaf(&mut self, node: NodeId, branch: NodeId, shape: Box<Shape>) {
        if self.program.looks_around && shape.is_closed() {
            self.intra.add(Occluder { label: None, node: Some(branch), footprint: shape.footprint() });
        }
        self.outcome.leaves.push(LeafOf { node, shape });
    }

    fn frame<'f>(&'f self, turn: &'f Turn, current: &'f mut Current) -> Frame<'f> {
        Frame {
            names: Names {
                program: self.program,
                params: &turn.args,
                calls: self.options.limits.calls,
                room: evaluate::HIGHEST,
            },
            shape: &current.shape,
            random: &mut current.random,
            intra: &self.intra,
            inter: &self.inter,
            initial: &self.initial,
            branches: &self.branches,
            branch: current.branch,
        }
    }

    fn failed(&self, failure: Failure, turn: &Turn) -> Stop {
        Stop::Branch(Box::new(self.diagnostic("value", failure.span, failure.message, turn.node)))
    }

    fn problem(&self, application: &Application, problem: Problem, turn: &Turn) -> Stop {
        let span = problem.parameter.and_then(|name| application.argument_span(name)).unwrap_or(application.span);
        let diagnostic = self.diagnostic("geometry", span, problem.message, turn.node);
        Stop::Branch(Box::new(Diagnostic { hints: problem.hints, ..diagnostic }))
    }

    /// An error with the lot and the rules on the way down.
    fn diagnostic(&self, code: &'static str, span: Span, message: String, node: NodeId) -> Diagnostic {
        let mut diagnostic = Diagnostic::error(code, span, message);
        diagnostic.lot = Some(self.lot.clone());
        diagnostic.trace = ancestors(&self.outcome.nodes, node)
            .filter_map(|id| self.outcome.nodes.get(id.0 as usize)?.rule)
            .take(DEEPEST_TRACE)
            .map(|rule| self.program.rule_step(rule))
            .collect();
        diagnostic
    }
}

/// Rules that a trace shows, from the innermost.
const DEEPEST_TRACE: usize = 8;

/// A node and its ancestors, upwards.
fn ancestors(nodes: &[Node], node: NodeId) -> impl Iterator<Item = NodeId> {
    std::iter::successors(Some(node), |id| {
        let parent = nodes.get(id.0 as usize)?.parent;
        (parent != *id).then_some(parent)
    })
}

/// One diagnostic for each place and kind, with how often it came.
fn gathered(found: Vec<Diagnostic>) -> Vec<Diagnostic> {
    let mut kept: Vec<(Diagnostic, usize)> = Vec::new();
    let mut index: std::collections::BTreeMap<(String, &'static str), usize> = std::collections::BTreeMap::new();
    for diagnostic in found {
        let place = match &diagnostic.place {
            diag::Place::Rule(span) => format!("{}:{}:{}", span.file, span.start, span.end),
            other => format!("{other:?}"),
        };
        match index.get(&(place.clone(), diagnostic.code)) {
            Some(at) => kept[*at].1 += 1,
            None => {
                index.insert((place, diagnostic.code), kept.len());
                kept.push((diagnostic, 1));
            }
        }
    }
    kept.into_iter()
        .map(|(mut diagnostic, times)| {
            if times > 1 {
                diagnostic.message.push_str(&format!(" ({times} times in this lot)"));
            }
            diagnostic
        })
        .collect()
}
