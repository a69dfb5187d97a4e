//! What a rule reaches: the attributes that it and all that can come of it read.

use crate::check::code::Code;
use crate::check::program::{Application, Block, Body, Cut, Fresh, Program, Renewed, Selector, Step};
use crate::ops::ParamKind;
use std::collections::BTreeSet;

/// The slots of all attributes that are read on the way down from a rule. Cost: linear in the rules it reaches.
pub(super) fn attributes_of(program: &Program, rule: u32) -> BTreeSet<u32> {
    let mut reach =
        Reach { program, open: vec![rule], rules: BTreeSet::new(), functions: BTreeSet::new(), slots: BTreeSet::new() };
    while let Some(rule) = reach.open.pop() {
        if let Some(rule) = program.rules.get(rule as usize).filter(|_| reach.rules.insert(rule)) {
            reach.body(&rule.body);
        }
    }
    reach.slots
}

struct Reach<'a> {
    program: &'a Program,
    open: Vec<u32>,
    rules: BTreeSet<u32>,
    functions: BTreeSet<u32>,
    slots: BTreeSet<u32>,
}

impl Reach<'_> {
    fn body(&mut self, body: &Body) {
        match body {
            Body::Steps(steps) => steps.iter().for_each(|step| self.step(step)),
            Body::Case(arms, otherwise, _) | Body::Chance(arms, otherwise, _) => {
                arms.iter().for_each(|(code, body)| {
                    self.code(code);
                    self.body(body);
                });
                self.body(otherwise);
            }
            Body::With(locals, body) => {
                locals.iter().for_each(|code| self.code(code));
                self.body(body);
            }
            Body::Alternatives(alternatives) => alternatives.iter().for_each(|alternative| {
                alternative.condition.iter().chain(&alternative.probability).for_each(|code| self.code(code));
                self.body(&alternative.body);
            }),
        }
    }

    fn step(&mut self, step: &Step) {
        match step {
            Step::Apply(application) => self.application(application),
            Step::Successor(successor) => {
                self.open.extend(successor.rule);
                successor.args.iter().for_each(|code| self.code(code));
                successor.fresh.iter().for_each(|fresh| self.fresh(fresh));
            }
            Step::Push(body) => self.body(body),
            Step::Delete => {}
        }
    }

    fn application(&mut self, application: &Application) {
        let params = application.operation.spec.params.iter().zip(&application.args);
        // An attribute that is set is named, not read.
        let read = params.filter(|(param, _)| param.kind != ParamKind::Attribute).filter_map(|(_, arg)| arg.as_ref());
        read.for_each(|code| self.code(code));
        match &application.block {
            Block::Cuts(cuts) => self.cuts(cuts),
            Block::Perimeter { cuts, depths, rest } => {
                self.cuts(cuts);
                depths.iter().for_each(|(code, _)| self.code(code));
                self.selectors(rest);
            }
            Block::Selectors(selectors) => self.selectors(selectors),
            Block::None | Block::Body | Block::Operands => {}
        }
        application.bodies.iter().for_each(|body| self.body(body));
    }

    /// What a dynamic import finds anew reads more than its own attributes.
    fn fresh(&mut self, fresh: &Fresh) {
        fresh.given.iter().for_each(|(_, code)| self.code(code));
        for (slot, renewed) in &fresh.anew {
            match renewed {
                Renewed::Initial => self.code(&self.program.attributes[*slot as usize].initial),
                Renewed::Protected(code) => self.code(code),
            }
        }
    }

    fn selectors(&mut self, selectors: &[Selector]) {
        selectors.iter().filter_map(|selector| selector.test.code()).for_each(|code| self.code(code));
    }

    fn cuts(&mut self, cuts: &[Cut]) {
        cuts.iter().for_each(|cut| match cut {
            Cut::Piece(code, ..) => self.code(code),
            Cut::Repeat(inner) | Cut::Group(inner) => self.cuts(inner),
        });
    }

    /// An expression, with what functions and attributes in it read themselves.
    fn code(&mut self, code: &Code) {
        let program = self.program;
        let mut open = vec![code];
        while let Some(code) = open.pop() {
            match code {
                Code::Attribute(slot) | Code::Listed(slot, _) if self.slots.insert(*slot) => {
                    open.extend(program.attributes.get(*slot as usize).map(|attribute| &attribute.initial));
                }
                Code::Function(index, _) if self.functions.insert(*index) => {
                    open.extend(program.functions.get(*index as usize).map(|function| &function.value));
                }
                _ => {}
            }
            open.extend(code.parts());
        }
    }
}
