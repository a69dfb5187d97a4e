//! The order in which attributes are evaluated: what another needs comes first.

use crate::check::Checker;
use crate::check::code::Code;
use crate::check::program::Program;
use crate::diag::Diagnostic;
use std::collections::{BTreeMap, BTreeSet};

impl Checker {
    /// The order in which attributes can be evaluated; a circle is an error.
    pub(super) fn order(&mut self) {
        let all: Vec<(u32, &Code)> =
            self.program.attributes.iter().enumerate().map(|(slot, a)| (slot as u32, &a.initial)).collect();
        let (order, circles) = ordered(&self.program, &all);
        for (slot, way) in circles {
            let attribute = &self.program.attributes[slot as usize];
            let message = format!("the value of `{}` needs itself", attribute.name);
            let names: Vec<String> = way
                .iter()
                .chain([&slot])
                .map(|slot| format!("`{}`", self.program.attributes[*slot as usize].name))
                .collect();
            let hint = match way.as_slice() {
                [_] => {
                    format!("a rule changes it with `set({0}, {0} + 1)`; here it needs a first value", attribute.name)
                }
                _ => format!("{}: one of them needs a value of its own", names.join(" needs ")),
            };
            self.diagnostics.push(Diagnostic::error("attribute-cycle", attribute.span, message).hint(hint));
        }
        self.program.order = order;
    }
}

/// Slots in the order in which their expressions need each other, and those in circles, each with the way round. Others that they need count as
/// given.
pub(super) fn ordered(program: &Program, all: &[(u32, &Code)]) -> (Vec<u32>, BTreeMap<u32, Vec<u32>>) {
    let states = all.iter().map(|(slot, code)| (*slot, (State::New, *code))).collect();
    let mut visit = Visit { states, circles: BTreeMap::new(), order: Vec::with_capacity(all.len()) };
    all.iter().for_each(|(slot, _)| visit.from(program, *slot));
    (visit.order, visit.circles)
}

/// Depth-first over what attributes need, without recursion: chains may be as long as files.
struct Visit<'a> {
    states: BTreeMap<u32, (State, &'a Code)>,
    circles: BTreeMap<u32, Vec<u32>>,
    order: Vec<u32>,
}

#[derive(Clone, Copy, PartialEq)]
enum State {
    New,
    /// What it needs is being visited.
    Open,
    Done,
}

impl Visit<'_> {
    fn from(&mut self, program: &Program, slot: u32) {
        let mut path: Vec<(u32, Vec<u32>)> = Vec::new();
        let mut next = Some(slot).filter(|slot| self.states.get(slot).is_some_and(|(state, _)| *state == State::New));
        loop {
            if let Some((slot, (state, code))) = next.take().and_then(|slot| Some((slot, self.states.get_mut(&slot)?)))
            {
                *state = State::Open;
                path.push((slot, needs(program, code)));
            }
            let Some((slot, open)) = path.last_mut() else { return };
            match open.pop() {
                Some(needed) => match self.states.get(&needed).map(|(state, _)| *state) {
                    Some(State::New) => next = Some(needed),
                    Some(State::Open) => {
                        let round = path.iter().map(|(slot, _)| *slot).skip_while(|slot| *slot != needed);
                        self.circles.entry(needed).or_insert_with(|| round.collect());
                    }
                    Some(State::Done) | None => {}
                },
                None => {
                    if let Some((state, _)) = self.states.get_mut(slot) {
                        *state = State::Done;
                    }
                    self.order.push(*slot);
                    path.pop();
                }
            }
        }
    }
}

/// The attributes that an expression needs, by itself or through functions.
fn needs(program: &Program, code: &Code) -> Vec<u32> {
    let (mut found, mut seen) = (Vec::new(), BTreeSet::new());
    let mut open = vec![code];
    while let Some(code) = open.pop() {
        found.extend(code.slot());
        match code {
            Code::Function(index, _) if seen.insert(*index) => {
                open.extend(program.functions.get(*index as usize).map(|function| &function.value));
            }
            _ => {}
        }
        open.extend(code.parts());
    }
    found
}
