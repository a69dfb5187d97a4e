//! One lot: a work list of shapes, derived depth first in the order of the text.
//!
//! A rule runs from left to right on the current shape; each symbol met is a successor with the state of that moment,
//! queued behind the rule. Where a rule names no successor the current shape is what is built; points set on a shape
//! (by `scatter`, `Distr` and the placement strategies) do not use it up.

mod apply;
mod body;
mod fresh;
mod inside;
mod record;
mod report;

use crate::check::{Body, Program};
use crate::derive::beginning::Beginning;
use crate::derive::engine::record::Recorder;
use crate::derive::evaluate::{self, Names};
use crate::derive::frame::Frame;
use crate::derive::{Options, Progress, Run};
use crate::diag::{Diagnostic, Span};
use crate::files::Files;
use crate::functions::Initial;
use crate::geometry::Area;
use crate::layout::Georeference;
use crate::placement::Standing;
use crate::raster::Rasters;
use crate::seed::{Random, Seed};
use crate::shape::{Node, NodeId, Occluders, Outcome, Scope, Shape};
use crate::value::Value;
use std::cell::{Cell, RefCell};
use std::collections::BTreeSet;
use std::sync::Arc;
use std::time::Instant;

/// Between two looks at the clock.
const CLOCK: usize = 1024;

/// Arguments of a rule; most have none, and waiting shapes shall be small.
type Args = Box<[Value]>;

/// Derives the region number `index` by a rule, with the values that it has from its context.
pub(super) fn lot(run: &Run, index: usize, rule: u32, context: &[(usize, Value)]) -> Outcome {
    let Run { program, layout, options, rasters, files, names, progress, .. } = *run;
    let lot = Beginning::of(run, index, rule, program.looks_around);
    let told = RefCell::default();
    let given = lot.given(run, context);
    let (attributes, failures) = lot.attributes(run, &given, &told);
    let symbol = program.rules[rule as usize].symbol;
    let shape = Box::new(Shape { attributes, ..lot.shape });
    let mut engine = Engine {
        program,
        options,
        rasters,
        files,
        georeference: &layout.georeference,
        names,
        progress,
        told,
        spent: Cell::new(0),
        given,
        initial: lot.initial,
        intra: lot.intra,
        inter: lot.inter,
        beyond: lot.beyond,
        standing: lot.standing,
        outline: lot.region.polygon.clone().into(),
        lot: lot.region.id.clone(),
        seed: lot.seed,
        outcome: Outcome::default(),
        queue: Vec::new(),
        branches: vec![NodeId(0)],
        inside: 0,
        begun: Instant::now(),
        recorder: run.records.then(Box::default),
    };
    for failure in failures {
        let diagnostic = Diagnostic::error("value", failure.span, failure.message);
        engine.outcome.diagnostics.push(Diagnostic { lot: Some(engine.lot.clone()), ..diagnostic });
    }
    let (args, rule) = (Args::default(), Some(rule));
    engine.queue.push(Task { shape, parent: NodeId(0), branch: NodeId(0), symbol, rule, args, depth: 0 });
    engine.run();
    engine.outcome.record = engine.recorder.map(|recorder| Box::new(recorder.record));
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
    files: &'a Files<'a>,
    georeference: &'a Georeference,
    names: Option<&'a BTreeSet<Arc<str>>>,
    progress: &'a Progress,
    /// What `print` was given within expressions and is not among the outcome's prints yet.
    told: RefCell<Vec<Value>>,
    /// Calls of functions in the expression at hand.
    spent: Cell<u32>,
    /// The attributes that are given from outside, by slot: a dynamic import keeps them.
    given: Vec<(usize, Value)>,
    initial: Initial,
    intra: Occluders,
    inter: Occluders,
    /// The features around the lot.
    beyond: Occluders,
    /// The radii that plants keep for themselves so far.
    standing: Standing,
    /// The lot on the plan.
    outline: Area,
    lot: Arc<str>,
    /// The seed of the lot.
    seed: Seed,
    outcome: Outcome,
    queue: Vec<Task>,
    /// For occlusion a tree finer than that of the nodes, as each branch's parent: every piece of a block and every
    /// bracket is a branch of its own, so that siblings within a rule see each other.
    branches: Vec<NodeId>,
    /// How many operands are being derived inside each other.
    inside: usize,
    begun: Instant,
    /// The way to every shape, where it is asked for.
    recorder: Option<Box<Recorder>>,
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
    /// Its own numbers, from the first draw on.
    random: Option<Random>,
    /// The seed that they are drawn from.
    drawn: Seed,
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
    /// Those of a dynamic import.
    attributes: Option<Arc<[Value]>>,
    seed: Seed,
}

impl Current {
    fn new(shape: Box<Shape>, branch: NodeId) -> Current {
        let (around, drawn) = (shape.scope, shape.seed);
        Current { branch, around, shape, random: None, drawn, count: 0, used: false, deleted: false, heir: None }
    }

    /// Its own numbers: most shapes never draw one.
    fn random(&mut self) -> &mut Random {
        self.random.get_or_insert_with(|| self.drawn.draw("rand"))
    }

    /// After an operation: a new seed begins its numbers anew.
    fn changed(&mut self) {
        if self.shape.seed != self.drawn {
            (self.random, self.drawn) = (None, self.shape.seed);
        }
    }
}

impl Engine<'_> {
    fn run(&mut self) {
        if let Err(Stop::Branch(diagnostic) | Stop::Lot(diagnostic)) = self.work() {
            self.outcome.diagnostics.push(*diagnostic);
        }
        let found = std::mem::take(&mut self.outcome.diagnostics);
        self.outcome.diagnostics = report::gathered(found);
    }

    /// Derives what waits, until nothing does.
    fn work(&mut self) -> Result<(), Stop> {
        while let Some(task) = self.queue.pop() {
            match self.within_limits(&task).and_then(|()| self.task(task)) {
                Err(Stop::Branch(diagnostic)) => self.outcome.diagnostics.push(*diagnostic),
                done => done?,
            }
            if self.progress.stopped() {
                break;
            }
        }
        Ok(())
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
        self.arrived(&task);
        let branch = self.branch(task.branch);
        let Some(rule) = task.rule else {
            self.leaf(node, branch, task.shape);
            return Ok(());
        };
        let turn = Turn { node, args: task.args, depth: task.depth };
        let (program, waiting) = (self.program, self.queue.len());
        let done = self.body(&program.rules[rule as usize].body, &turn, Current::new(task.shape, branch));
        self.tell(task.symbol);
        if done.is_err() {
            self.queue.truncate(waiting);
            self.dropped(node);
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

    fn frame<'f>(&'f self, turn: &'f Turn, current: &'f mut Current) -> Frame<'f> {
        self.spent.set(0);
        Frame {
            names: Names {
                program: self.program,
                params: &turn.args,
                calls: self.options.limits.calls,
                room: evaluate::HIGHEST,
                spent: &self.spent,
            },
            shape: &current.shape,
            random: current.random.get_or_insert_with(|| current.drawn.draw("rand")),
            intra: &self.intra,
            inter: &self.inter,
            initial: &self.initial,
            catalogue: self.options.catalogue,
            rasters: self.rasters,
            files: self.files,
            georeference: self.georeference,
            nodes: &self.outcome.nodes,
            node: turn.node,
            told: &self.told,
            branches: &self.branches,
            branch: current.branch,
            at: None,
        }
    }
}
