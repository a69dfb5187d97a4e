//! Arrays in expressions: literals, ranges, indices, operators element by element, and `comp` as a function.

use crate::check::Checker;
use crate::check::code::{Code, Kind, Measure};
use crate::check::program::Selector;
use crate::diag::{Diagnostic, Span};
use crate::ops::{self, Gather};
use crate::syntax::ast::{Arg, BinaryOp, Expr, ExprKind, Separator};
use crate::value::{Array, Value};
use std::sync::Arc;

impl Checker {
    /// `[a, b; c, d]`; one whose elements are known is put together here and now.
    pub(super) fn array(&mut self, rows: &[Vec<Expr>], span: Span) -> (Code, Kind) {
        let checked: Vec<Vec<(Code, Kind)>> =
            rows.iter().map(|row| row.iter().map(|element| self.value(element)).collect()).collect();
        let kind = self.one_kind(checked.iter().zip(rows).flat_map(|(row, exprs)| row.iter().map(|c| c.1).zip(exprs)));
        let codes: Box<[Box<[Code]>]> =
            checked.into_iter().map(|row| row.into_iter().map(|(code, _)| code).collect()).collect();
        let known: Option<Vec<Vec<Value>>> =
            codes.iter().map(|row| row.iter().map(|code| code.known().cloned()).collect()).collect();
        match known.map(|rows| Array::joined(&rows)) {
            Some(Ok(array)) => (Code::Value(Value::Array(Arc::new(array))), kind.array()),
            Some(Err(message)) => {
                // Elements of two kinds have been told already.
                if kind != Kind::Unknown {
                    self.tell(Diagnostic::error("array", span, format!("an array {message}")));
                }
                (Code::Array(codes, span), kind.array())
            }
            None => (Code::Array(codes, span), kind.array()),
        }
    }

    /// What all elements are, as far as it can be seen; two kinds are an error.
    fn one_kind<'e>(&mut self, elements: impl Iterator<Item = (Kind, &'e Expr)>) -> Kind {
        let (mut all, mut is_open) = (Kind::Unknown, false);
        for (kind, expr) in elements {
            match kind.element() {
                Kind::Unknown => is_open = true,
                kind if all == Kind::Unknown => all = kind,
                kind if kind != all => {
                    let message =
                        format!("an array holds values of one kind: found {} after {}", kind.words(), all.words());
                    self.tell(Diagnostic::error("kind", expr.span, message));
                    return Kind::Unknown;
                }
                _ => {}
            }
        }
        if is_open { Kind::Unknown } else { all }
    }

    /// `from : to`, `from : step : to`.
    pub(super) fn range(&mut self, from: &Expr, step: Option<&Expr>, to: &Expr, span: Span) -> (Code, Kind) {
        let (from, step, to) = (self.number(from), step.map(|step| self.number(step)), self.number(to));
        let number = |code: &Code| code.known().and_then(Value::as_float);
        let known = (number(&from), step.as_ref().map_or(Some(1.0), number), number(&to));
        if let (Some(from), Some(step), Some(to)) = known {
            match Array::range(from, step, to) {
                Ok(array) => return (Code::Value(Value::Array(Arc::new(array))), Kind::Numbers),
                Err(message) => self.tell(Diagnostic::error("array", span, format!("a range {message}"))),
            }
        }
        (Code::Range(Box::new((from, step, to)), span), Kind::Numbers)
    }

    /// `a[i]`, `a[row, column]`.
    pub(super) fn index(&mut self, array: &Expr, indices: &[Expr], span: Span) -> (Code, Kind) {
        let (code, kind) = self.value(array);
        if kind != Kind::Unknown && !kind.is_array() {
            let message = format!("only an array is indexed, found {}", kind.words());
            self.tell(Diagnostic::error("kind", array.span, message));
        }
        if indices.len() > 2 {
            let message = format!("an array is indexed with one or two indices, found {}", indices.len());
            self.tell(Diagnostic::error("kind", span, message));
        }
        let mut gives = kind.element();
        let codes = indices.iter().map(|index| {
            let (code, of) = self.value(index);
            match of {
                Kind::Number => {}
                Kind::Numbers | Kind::Truths => gives = gives.array(),
                Kind::Unknown => gives = Kind::Unknown,
                Kind::Truth | Kind::Text | Kind::Texts => {
                    let message = format!(
                        "an array is indexed with a number, or an array of numbers or truth values, found {}",
                        of.words()
                    );
                    self.tell(Diagnostic::error("kind", index.span, message));
                }
            }
            code
        });
        let codes = codes.collect();
        (Code::Index(Box::new(code), codes, span), gives)
    }

    /// `a .+ b`.
    pub(super) fn each(&mut self, op: BinaryOp, left: &Expr, right: &Expr, span: Span) -> (Code, Kind) {
        let ((a, a_kind), (b, b_kind)) = (self.value(left), self.value(right));
        let of = match op {
            BinaryOp::And | BinaryOp::Or => {
                for (kind, expr) in [(a_kind, left), (b_kind, right)] {
                    if !matches!(kind.element(), Kind::Truth | Kind::Unknown) {
                        let message = format!("truth values are wanted here, found {}", kind.words());
                        self.tell(Diagnostic::error("kind", expr.span, message));
                    }
                }
                Kind::Truth
            }
            _ => self.operands(op, (a_kind.element(), left.span), (b_kind.element(), right.span)),
        };
        let kind = match a_kind.is_array() || b_kind.is_array() {
            true => of.array(),
            false if a_kind == Kind::Unknown || b_kind == Kind::Unknown => Kind::Unknown,
            false => of,
        };
        (Code::Each(op, Box::new((a, b)), span), kind)
    }

    /// `comp(e) { front = 3 | all : 0 }`.
    pub(super) fn measure(&mut self, args: &[Arg], entries: &[(Expr, Separator, Expr)], span: Span) -> (Code, Kind) {
        let Some(operation) = ops::find("comp") else { return (Code::Value(Value::Float(0.0)), Kind::Unknown) };
        let (args, _) = self.arguments(operation.spec, args, span);
        let (mut selectors, mut values, mut kinds) = (Vec::new(), Vec::new(), Vec::new());
        for (key, separator, expr) in entries {
            let test = self.test(&[], key);
            let (value, kind) = self.value(expr);
            if let Some(test) = test {
                selectors.push(Selector { test, gather: self.gather(*separator, key.span) });
                values.push(value);
            }
            kinds.push((kind, expr));
        }
        for (kind, expr) in kinds.iter().filter(|(kind, _)| kind.is_array()) {
            let message = format!("each component has one value here, found {}", kind.words());
            self.tell(Diagnostic::error("kind", expr.span, message));
        }
        let kind = self.one_kind(kinds.into_iter());
        let (args, selectors, values) = (args.into(), selectors.into(), values.into());
        (Code::Comp(Box::new(Measure { operation, args, selectors, values, span })), kind.array())
    }

    /// How the components of an entry share a value.
    fn gather(&mut self, separator: Separator, span: Span) -> Gather {
        match separator {
            Separator::Each => Gather::Each,
            Separator::All => Gather::All,
            Separator::Connected => {
                let message = "`=:` cannot stand in the function `comp`";
                let hint = "`:` finds a value for each component, `=` one for all of them";
                self.tell(Diagnostic::error("block", span, message).hint(hint));
                Gather::All
            }
        }
    }

    /// A text that a choice is compared with must be one of its choices.
    pub(super) fn compared(&mut self, code: &Code, other: &Code, expr: &Expr) {
        let (Code::Attribute(slot), ExprKind::Text(text)) = (code, &expr.kind) else { return };
        let described = self.program.attributes.get(*slot as usize).or(self.loaded.attributes.get(*slot as usize));
        let Some(attribute) = described.filter(|a| !a.choices.is_empty() && !a.is_open) else { return };
        if other.known().is_none_or(|value| attribute.choices.contains(value)) {
            return;
        }
        let near = crate::text::nearest(text, attribute.choices.iter().filter_map(Value::as_str));
        let message = format!("`{text}` is none of the choices of `{}`", attribute.name);
        let all: Vec<String> = attribute.choices.iter().take(8).map(|choice| format!("`{choice}`")).collect();
        let more = attribute.choices.len().saturating_sub(8);
        let rest = if more > 0 { format!(" and {more} more") } else { String::new() };
        let diagnostic = Diagnostic::lint("choice", expr.span, message).did_you_mean(near);
        let diagnostic = diagnostic.hint(format!("its annotation has {}{rest}", all.join(", ")));
        self.tell(diagnostic);
    }
}
