//! Successors: operations in a row, and choices.

use super::{Builder, next_if};
use crate::diag::{Diagnostic, Span};
use crate::syntax::ast::{Arg, Body, Call, Expr, ExprKind, Name, Op, Override, Spelling};
use crate::syntax::grammar::{Pair, Rule};
use crate::syntax::paper;
use pest::iterators::Pairs;

impl<'t> Builder<'t> {
    pub(super) fn body(&self, pair: Pair<'t>) -> Option<Body> {
        let mut inner = pair.into_inner();
        let Some(first) = inner.peek() else { return Some(Body::Ops(Vec::new())) };
        match first.as_rule() {
            Rule::condition => self.cases(inner),
            Rule::percentage => {
                let share = self.percentage(inner.next()?)?;
                self.chances(share, inner.next()?)
            }
            _ => {
                let op = self.op(inner.next()?)?;
                match next_if(&mut inner, Rule::chances) {
                    Some(chances) => self.chances(self.share_of(op), chances),
                    None => self.ops(op, inner),
                }
            }
        }
    }

    fn ops(&self, first: Op, rest: Pairs<'t, Rule>) -> Option<Body> {
        let mut ops = Vec::with_capacity(1 + rest.len());
        ops.push(first);
        for op in rest {
            ops.push(self.op(op)?);
        }
        Some(Body::Ops(ops))
    }

    fn cases(&self, mut inner: Pairs<'t, Rule>) -> Option<Body> {
        let mut arms = Vec::new();
        while let Some(condition) = next_if(&mut inner, Rule::condition) {
            arms.push((self.expression(condition)?, self.body(inner.next()?)?));
        }
        let otherwise = Box::new(self.body(inner.next()?)?);
        Some(Body::Case { arms, otherwise })
    }

    /// `first % : body … else : body`. Where a percentage is missing, the last symbol of the body before it is the one.
    fn chances(&self, first: Expr, pair: Pair<'t>) -> Option<Body> {
        let mut arms: Vec<(Expr, Body)> = Vec::new();
        let (mut share, mut inner) = (Some(first), pair.into_inner());
        loop {
            let next = inner.next()?;
            match next.as_rule() {
                Rule::percentage => share = Some(self.percentage(next)?),
                _ if inner.peek().is_none() => {
                    let otherwise = Box::new(self.body(next)?);
                    return Some(Body::Chance { arms, otherwise });
                }
                _ => {
                    let chance = match share.take() {
                        Some(chance) => chance,
                        None => self.share_of(arms.last_mut().and_then(|(_, body)| last_op(body))?),
                    };
                    arms.push((chance, self.body(next)?));
                }
            }
        }
    }

    fn percentage(&self, pair: Pair<'t>) -> Option<Expr> {
        let inner = pair.into_inner().next()?;
        let span = self.span(&inner);
        match inner.as_rule() {
            Rule::number => Some(Expr { kind: ExprKind::Number(self.number(inner.as_str(), span)), span }),
            _ => self.paren(inner),
        }
    }

    /// A name or call before `% :`, which read like an operation.
    fn share_of(&self, op: Op) -> Expr {
        match op {
            Op::Call(Call { name, args, blocks, leaf: false, span, .. }) if blocks.is_empty() => {
                let args = (span.end > name.span.end).then_some(args);
                Expr { kind: ExprKind::Call(name.text, args), span }
            }
            other => {
                let span = span_of(&other);
                let message = "before `% :` stands a percentage: a number, a name, a call or something in parentheses";
                self.report(Diagnostic::error("syntax-chance", span, message));
                Expr { kind: ExprKind::Number(0.0), span }
            }
        }
    }

    pub(super) fn op(&self, pair: Pair<'t>) -> Option<Op> {
        match pair.as_rule() {
            Rule::step => self.step(pair),
            Rule::push => {
                let span = self.span(&pair);
                Some(Op::Push(self.body(pair.into_inner().next()?)?, span))
            }
            Rule::inline => self.inline(pair),
            Rule::perimeter => self.perimeter(pair),
            _ => None,
        }
    }

    fn inline(&self, pair: Pair<'t>) -> Option<Op> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let mode = match next_if(&mut inner, Rule::args) {
            Some(args) => self.args(args)?,
            None => Vec::new(),
        };
        Some(Op::Inline { mode, target: inner.map(|op| self.op(op)).collect::<Option<_>>()?, span })
    }

    /// `name(args).member(args) { block }`
    fn step(&self, pair: Pair<'t>) -> Option<Op> {
        let span = self.span(&pair);
        let mut inner = pair.into_inner();
        let name = self.name(&inner.next()?);
        let args = self.next_args(&mut inner)?;
        let leaf = next_if(&mut inner, Rule::leaf).is_some();
        let (spelling, blocks) = (Spelling::Cga, Vec::new());
        let mut call = Call { name, args, blocks, leaf, spelling, span };
        let import = match next_if(&mut inner, Rule::member) {
            Some(member) => {
                let name = self.name(&member.into_inner().next()?);
                let start = name.span;
                let own = Call { name, args: Vec::new(), blocks: Vec::new(), leaf, spelling, span: start.to(span) };
                Some(std::mem::replace(&mut call, own))
            }
            None => None,
        };
        call.args.extend(self.next_args(&mut inner)?);
        call.blocks = self.blocks(inner)?;
        match import {
            Some(import) => Some(self.dynamic(import, call)),
            None => Some(Op::Call(self.checked(paper::lowered(self, call)))),
        }
    }

    fn next_args(&self, inner: &mut Pairs<'t, Rule>) -> Option<Vec<Arg>> {
        match next_if(inner, Rule::args) {
            Some(args) => self.args(args),
            None => Some(Vec::new()),
        }
    }

    /// `imp(h = 3).Rule(2)`; a bare name protects, as in the parentheses of an import.
    fn dynamic(&self, import: Call, call: Call) -> Op {
        let mut overrides = Vec::with_capacity(import.args.len());
        for arg in import.args {
            match (arg.name, arg.value.kind) {
                (Some(name), kind) => overrides.push(Override::Attribute(name, Expr { kind, span: arg.value.span })),
                (None, ExprKind::Call(text, None)) => {
                    overrides.push(Override::Protect(Name { text, span: arg.value.span }));
                }
                (None, _) => {
                    let message = format!("an attribute given to the import `{}` needs its name", import.name.text);
                    let hint = format!("write `{}(name = value).{}`", import.name.text, call.name.text);
                    self.report(Diagnostic::error("syntax-arguments", arg.value.span, message).hint(hint));
                }
            }
        }
        Op::Dynamic { import: import.name, overrides, call }
    }
}

/// Takes the last symbol away from the end of a body.
fn last_op(body: &mut Body) -> Option<Op> {
    match body {
        Body::Ops(ops) => ops.pop(),
        Body::Case { otherwise, .. } | Body::Chance { otherwise, .. } => last_op(otherwise),
    }
}

fn span_of(op: &Op) -> Span {
    match op {
        Op::Call(call) => call.span,
        Op::Dynamic { import, call, .. } => import.span.to(call.span),
        Op::Push(_, span) | Op::Inline { span, .. } => *span,
    }
}
