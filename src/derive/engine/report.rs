//! What an engine tells: diagnostics with the lot and the rules on the way down, and the same ones gathered.

use crate::check::Application;
use crate::derive::engine::{Engine, Stop, Turn};
use crate::derive::evaluate::Failure;
use crate::diag::{self, Diagnostic, Severity, Span};
use crate::ops::{Problem, Remark};
use crate::shape::{Node, NodeId, Print};

impl Engine<'_> {
    pub(super) fn failed(&self, failure: Failure, turn: &Turn) -> Stop {
        Stop::Branch(Box::new(self.diagnostic("value", failure.span, failure.message, turn.node)))
    }

    pub(super) fn remark(&mut self, application: &Application, remark: Remark, turn: &Turn) {
        let span = remark.parameter.and_then(|name| application.argument_span(name)).unwrap_or(application.span);
        let diagnostic = self.diagnostic("placement", span, remark.message, turn.node);
        let severity = if remark.is_note { Severity::Note } else { Severity::Lint };
        self.outcome.diagnostics.push(Diagnostic { severity, ..diagnostic });
    }

    pub(super) fn problem(&self, application: &Application, problem: Problem, turn: &Turn) -> Stop {
        let span = problem.parameter.and_then(|name| application.argument_span(name)).unwrap_or(application.span);
        let diagnostic = self.diagnostic("geometry", span, problem.message, turn.node);
        Stop::Branch(Box::new(Diagnostic { hints: problem.hints, ..diagnostic }))
    }

    /// Brings what expressions printed among the prints of a rule, in their order.
    pub(super) fn tell(&mut self, symbol: u32) {
        self.outcome.prints.extend(self.told.get_mut().drain(..).map(|value| Print { symbol, value }));
    }

    /// An error with the lot and the rules on the way down.
    pub(super) fn diagnostic(&self, code: &'static str, span: Span, message: String, node: NodeId) -> Diagnostic {
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
pub(super) fn gathered(found: Vec<Diagnostic>) -> Vec<Diagnostic> {
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
