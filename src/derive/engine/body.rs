//! The steps of a rule's body on the current shape: choices, brackets, successors.

use crate::check::{Alternative, Body, Step, Successor};
use crate::derive::engine::{Current, Engine, Heir, Stop, Task, Turn};
use crate::derive::evaluate;
use crate::shape::{NodeId, Shape};
use smallvec::SmallVec;

impl Engine<'_> {
    pub(super) fn steps(&mut self, body: &Body, turn: &Turn, current: &mut Current) -> Result<(), Stop> {
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
                for (number, (test, body)) in arms.iter().enumerate() {
                    if self
                        .frame(turn, current)
                        .with(|n, a| evaluate::truth(test, n, a, *span))
                        .map_err(|f| self.failed(f, turn))?
                    {
                        self.chose(&arms[..number], Some((test, body)), *span, turn, current);
                        return self.steps(body, turn, current);
                    }
                }
                self.chose(arms, None, *span, turn, current);
                self.steps(otherwise, turn, current)
            }
            Body::Chance(arms, otherwise, span) => {
                let drawn = current.random().uniform(0.0, 100.0);
                let mut left = drawn;
                for (percent, body) in arms {
                    let before = left;
                    left -= self
                        .frame(turn, current)
                        .with(|n, a| evaluate::number(percent, n, a, *span))
                        .map_err(|f| self.failed(f, turn))?;
                    if left < 0.0 {
                        self.drew(drawn, (drawn - before, drawn - left), 100.0, body.span().unwrap_or(*span));
                        return self.steps(body, turn, current);
                    }
                }
                self.drew(drawn, (drawn - left, 100.0), 100.0, otherwise.span().unwrap_or(*span));
                self.steps(otherwise, turn, current)
            }
            Body::With(locals, body) => {
                let args = self.frame(turn, current).with(|n, a| evaluate::extended(locals, n, a));
                let args = args.map_err(|f| self.failed(f, turn))?;
                self.steps(body, &Turn { args, ..*turn }, current)
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
        let mut open: SmallVec<[(&Alternative, Option<f64>); 4]> = SmallVec::new();
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
                open.push((alternative, weight.transpose().map_err(|f| self.failed(f, turn))?));
            }
        }
        if open.iter().all(|(_, weight)| weight.is_none()) {
            let first = open.first().map(|(alternative, _)| *alternative);
            self.followed(alternatives, first, turn, current);
            return Ok(first.map(|alternative| &alternative.body));
        }
        // What has no probability of its own shares what the others leave of 1.
        let given: f64 = open.iter().filter_map(|(_, weight)| *weight).sum();
        let silent = open.iter().filter(|(_, weight)| weight.is_none()).count().max(1) as f64;
        let rest = (1.0 - given).max(0.0) / silent;
        let weights: SmallVec<[f64; 4]> = open.iter().map(|(_, weight)| weight.unwrap_or(rest)).collect();
        let before = self.recorder.is_some().then(|| current.random().clone());
        let Some(index) = current.random().choose(&weights) else { return Ok(None) };
        let chosen = open[index].0;
        self.followed(alternatives, Some(chosen), turn, current);
        self.weighed(before, &weights, index, chosen.span);
        Ok(Some(&chosen.body))
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
        let mark = self.mark();
        match self.steps(body, turn, &mut inner) {
            Err(Stop::Branch(diagnostic)) => {
                self.outcome.diagnostics.push(*diagnostic);
                current.used = true;
                self.release(mark);
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
        self.release(mark);
        Ok(())
    }

    /// A new branch that grows from another.
    pub(super) fn branch(&mut self, parent: NodeId) -> NodeId {
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
        let attributes = successor.fresh.as_ref().map(|fresh| self.fresh(fresh, seed, turn, current)).transpose()?;
        let (symbol, rule, args) = (successor.symbol, successor.rule, args.into());
        current.heir = Some(Heir { symbol, rule, args, attributes, seed });
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

    pub(super) fn succeed(&mut self, heir: Heir, mut shape: Box<Shape>, branch: NodeId, turn: &Turn) {
        let Heir { symbol, rule, args, attributes, seed } = heir;
        shape.seed = seed;
        if let Some(attributes) = attributes {
            shape.attributes = attributes;
        }
        self.queued(turn.node);
        self.queue.push(Task { shape, parent: turn.node, branch, symbol, rule, args, depth: turn.depth + 1 });
    }
}
