//! The way to every shape, kept where it was asked for: what the rule at work has done so far is a trail, and each
//! successor and leaf takes a copy of it. A run that keeps none pays for a look at a null pointer.

use crate::check::{Alternative, Application, Block, Body, Code, Cut, Test};
use crate::derive::engine::{Current, Engine, Task, Turn};
use crate::derive::evaluate;
use crate::derive::frame::Frame;
use crate::diag::Span;
use crate::seed::Random;
use crate::shape::{Deed, Event, NodeId, Passage, Record};
use crate::value::Value;
use std::collections::{BTreeMap, VecDeque};

/// A record in the making.
#[derive(Default)]
pub(super) struct Recorder {
    /// What is known so far.
    pub record: Record,
    /// What the rule at work did on the way to its current shape.
    trail: Vec<Event>,
    /// The trails of successors that wait, by the node whose rule named them, in the order of the text.
    waiting: BTreeMap<u32, VecDeque<Vec<Event>>>,
}

/// What a rule has recorded when it turns to an operand: its trail, and the trails of its successors that wait.
pub(super) struct Aside {
    trail: Vec<Event>,
    waiting: Option<VecDeque<Vec<Event>>>,
}

impl Engine<'_> {
    /// How long the trail is: [`Engine::release`] leads back to it.
    pub(super) fn mark(&self) -> usize {
        self.recorder.as_ref().map_or(0, |recorder| recorder.trail.len())
    }

    pub(super) fn release(&mut self, mark: usize) {
        if let Some(recorder) = &mut self.recorder {
            recorder.trail.truncate(mark);
        }
    }

    /// A successor waits.
    pub(super) fn queued(&mut self, parent: NodeId) {
        if let Some(recorder) = &mut self.recorder {
            recorder.waiting.entry(parent.0).or_default().push_back(recorder.trail.clone());
        }
    }

    /// The successors of a node are not derived after all.
    pub(super) fn dropped(&mut self, node: NodeId) {
        if let Some(recorder) = &mut self.recorder {
            recorder.waiting.remove(&node.0);
        }
    }

    /// The rule at a node turns to an operand, whose way begins with that of the rule.
    pub(super) fn set_aside(&mut self, node: NodeId) -> Option<Aside> {
        let recorder = self.recorder.as_mut()?;
        Some(Aside { trail: recorder.trail.clone(), waiting: recorder.waiting.remove(&node.0) })
    }

    /// The operand is derived, or failed with successors that will not be: the rule goes on where it was.
    pub(super) fn taken_up(&mut self, node: NodeId, aside: Option<Aside>) {
        let Some((recorder, Aside { trail, waiting })) = self.recorder.as_mut().zip(aside) else { return };
        recorder.trail = trail;
        recorder.waiting.remove(&node.0);
        if let Some(waiting) = waiting {
            recorder.waiting.insert(node.0, waiting);
        }
    }

    /// Some of the leaves from the `first`-th on are none after all.
    pub(super) fn unbuilt(&mut self, first: usize, gone: impl Iterator<Item = bool>) {
        if let Some(recorder) = &mut self.recorder {
            let trails = recorder.record.leaves.split_off(first);
            let kept = trails.into_iter().zip(gone).filter(|(_, gone)| !gone);
            recorder.record.leaves.extend(kept.map(|(trail, _)| trail));
        }
    }

    /// A shape has become a node.
    pub(super) fn arrived(&mut self, task: &Task) {
        if let Some(recorder) = &mut self.recorder {
            recorder.trail.clear();
            let trail = recorder.waiting.get_mut(&task.parent.0).and_then(VecDeque::pop_front).unwrap_or_default();
            recorder.record.shapes.push(Passage { shape: (*task.shape).clone(), args: task.args.clone(), trail });
        }
    }

    /// A leaf is built.
    pub(super) fn built(&mut self) {
        if let Some(recorder) = &mut self.recorder {
            recorder.record.leaves.push(recorder.trail.clone());
        }
    }

    pub(super) fn happened(&mut self, event: Option<Event>) {
        if let Some((recorder, event)) = self.recorder.as_mut().zip(event) {
            recorder.trail.push(event);
        }
    }

    /// The way goes on with a piece.
    pub(super) fn took(&mut self, application: &Application, entry: u16, index: usize, total: usize, turn: &Turn) {
        if self.recorder.is_some() {
            let (entry, span) = self.entry(application, entry, turn);
            self.happened(Some(Event { span, deed: Deed::Took { entry, index, total } }));
        }
    }

    /// The first condition that holds is followed, or `else`.
    pub(super) fn chose(
        &mut self,
        failed: &[(Code, Body)],
        held: Option<(&Code, &Body)>,
        span: Span,
        turn: &Turn,
        current: &mut Current,
    ) {
        if self.recorder.is_some() {
            let failed: Vec<&Code> = failed.iter().map(|(test, _)| test).collect();
            let span = held.and_then(|(_, body)| body.span()).unwrap_or(span);
            self.decided(&failed, held.map(|(test, _)| test), span, turn, current);
        }
    }

    /// An alternative of the papers' is followed, whose condition holds.
    pub(super) fn followed(
        &mut self,
        all: &[Alternative],
        chosen: Option<&Alternative>,
        turn: &Turn,
        current: &mut Current,
    ) {
        let Some(chosen) = chosen.filter(|_| self.recorder.is_some()) else { return };
        if let Some(condition) = &chosen.condition {
            let before = all.iter().take_while(|other| !std::ptr::eq(*other, chosen));
            let failed: Vec<&Code> = before.filter_map(|other| other.condition.as_ref()).collect();
            // With probabilities earlier ones may hold as well.
            let failed = if chosen.probability.is_some() { Vec::new() } else { failed };
            self.decided(&failed, Some(condition), chosen.span, turn, current);
        }
    }

    fn decided(&mut self, failed: &[&Code], held: Option<&Code>, span: Span, turn: &Turn, current: &mut Current) {
        let names = self.names_of(turn);
        let reads = self.reads(failed.iter().copied().chain(held), turn, current);
        let words = |code: &Code| self.program.words(code, names);
        let failed = failed.iter().map(|code| words(code)).collect();
        let deed = Deed::Chose { condition: held.map(words), failed, reads };
        self.happened(Some(Event { span, deed }));
    }

    /// A number was drawn, and what its part belongs to is followed.
    pub(super) fn drew(&mut self, number: f64, part: (f64, f64), of: f64, span: Span) {
        if self.recorder.is_some() {
            self.happened(Some(Event { span, deed: Deed::Drew { number, part, of } }));
        }
    }

    /// One of some weights was drawn from numbers that stood like `random` before, where that was kept.
    pub(super) fn weighed(&mut self, random: Option<Random>, weights: &[f64], index: usize, span: Span) {
        if let Some(mut random) = random {
            let positive = |some: &[f64]| some.iter().filter(|weight| **weight > 0.0).sum::<f64>();
            let (of, from) = (positive(weights), positive(&weights[..index]));
            self.drew(random.unit() * of, (from, from + weights[index]), of, span);
        }
    }

    /// What an entry of a block says, and where it is written.
    fn entry(&self, application: &Application, entry: u16, turn: &Turn) -> (String, Span) {
        let names = self.names_of(turn);
        let body = application.bodies.get(usize::from(entry)).and_then(Body::span);
        let span = body.unwrap_or(application.span);
        match &application.block {
            Block::Perimeter { cuts, .. } => match piece(cuts, entry) {
                Some((size, span)) => (self.program.words(size, names), span),
                None => ("remainder".into(), span),
            },
            Block::Cuts(cuts) => match piece(cuts, entry) {
                Some((size, span)) => (self.program.words(size, names), span),
                None => (String::new(), span),
            },
            Block::Selectors(selectors) => {
                let words = selectors.get(usize::from(entry)).map(|selector| match &selector.test {
                    Test::Word(word) => word.to_string(),
                    Test::Remainder => "remainder".into(),
                    Test::Index(code) | Test::Condition(code) => self.program.words(code, names),
                });
                (words.unwrap_or_default(), span)
            }
            Block::None | Block::Body | Block::Operands => (String::new(), span),
        }
    }

    /// What the conditions read, with its values now; what would draw a number is left out, since it would draw another.
    fn reads<'c>(
        &self,
        codes: impl Iterator<Item = &'c Code>,
        turn: &Turn,
        current: &mut Current,
    ) -> Vec<(String, Value)> {
        let names = self.names_of(turn);
        let mut reads: Vec<(String, Value)> = Vec::new();
        let mut open: Vec<&Code> = codes.collect();
        open.reverse();
        while let Some(code) = open.pop() {
            if !matches!(code, Code::Param(_) | Code::Attribute(_) | Code::Builtin(..)) {
                open.extend(code.parts().into_iter().rev());
                continue;
            }
            let words = self.program.words(code, names);
            let known = reads.iter().any(|(name, _)| *name == words);
            if let Some(value) = self.value(code, turn, current).filter(|_| !known) {
                reads.push((words, value));
            }
        }
        reads
    }

    /// The value of an expression that draws no number; the shape's own numbers stay as they are.
    fn value(&self, code: &Code, turn: &Turn, current: &mut Current) -> Option<Value> {
        let mut before = current.random().clone();
        let mut spare = before.clone();
        let frame = self.frame(turn, current);
        let value = Frame { random: &mut spare, ..frame }.with(|n, a| evaluate::evaluate(code, n, a)).ok()?;
        (spare.bits() == before.bits()).then_some(value)
    }

    fn names_of(&self, turn: &Turn) -> &[std::sync::Arc<str>] {
        let rule = self.outcome.nodes.get(turn.node.0 as usize).and_then(|node| node.rule);
        rule.map_or(&[], |rule| &self.program.rules[rule as usize].names)
    }
}

/// An operation with the arguments that it was given.
pub(super) fn applied(application: &Application, values: &[Option<Value>]) -> Event {
    let known = |index: usize| application.args.get(index)?.as_ref()?.known().cloned();
    let params = application.operation.spec.params.iter().enumerate();
    // Arguments that are known before derivation may have been decoded before it as well: then there are no values.
    let value = |index: usize| values.get(index).map_or_else(|| known(index), Clone::clone);
    let args = params.filter_map(|(index, param)| Some((param.name, value(index)?))).collect();
    Event { span: application.span, deed: Deed::Applied(application.operation.spec.name, args) }
}

/// The size that leads to an entry, wherever it is nested.
fn piece(cuts: &[Cut], entry: u16) -> Option<(&Code, Span)> {
    cuts.iter().find_map(|cut| match cut {
        Cut::Piece(size, own, span) => (*own == entry).then_some((size, *span)),
        Cut::Repeat(inner) | Cut::Group(inner) => piece(inner, entry),
    })
}
