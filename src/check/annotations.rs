//! What annotations say: ranges, choices and descriptions of attributes; start rules and zones of rules.

use crate::check::Checker;
use crate::check::code::{Code, Kind};
use crate::check::names::Written;
use crate::check::program::{Attribute, Zone};
use crate::diag::Diagnostic;
use crate::syntax::ast::{Annotation, Arg, Expr, ExprKind, UnaryOp};
use crate::value::Value;
use std::sync::Arc;

/// The widest usual context, metres (ξ in Niese et al. 2022, Table 1).
const WIDEST_CONTEXT: f64 = 300.0;

/// Reads `@Range`, `@Enum` and `@Description` into an attribute.
pub(super) fn describe(attribute: &mut Attribute, annotations: &[Annotation]) {
    for annotation in annotations {
        match &*annotation.name.text {
            "Description" => attribute.description = annotation.args.first().and_then(|a| text(&a.value)),
            "Range" | "Percent" => range(attribute, &annotation.args),
            "Enum" => {
                attribute.choices.extend(annotation.args.iter().filter(|a| a.name.is_none()).filter_map(value));
                attribute.is_open |= annotation.args.iter().any(is_unrestricted);
            }
            "Hidden" => attribute.public = attribute.public && !annotation.args.is_empty(),
            _ => {}
        }
    }
}

/// `@Range(0, 10)`, `@Range(min = 0, max = 10)`, and the old `@Range("a", "b")` that lists choices.
fn range(attribute: &mut Attribute, args: &[Arg]) {
    let texts: Vec<Value> = args.iter().filter(|a| text(&a.value).is_some()).filter_map(value).collect();
    if !texts.is_empty() {
        attribute.choices.extend(texts);
        return;
    }
    let named = |name: &str| args.iter().find(|a| a.name.as_ref().is_some_and(|n| &*n.text == name));
    let at = |index: usize| args.get(index).filter(|a| a.name.is_none());
    let low = named("min").or(at(0)).and_then(|a| number(&a.value));
    let high = named("max").or(at(1)).and_then(|a| number(&a.value));
    if let (Some(low), Some(high)) = (low, high) {
        attribute.range = Some((low, high));
    }
}

/// `restricted = false`: other values are meant to be possible.
fn is_unrestricted(arg: &Arg) -> bool {
    let named = arg.name.as_ref().is_some_and(|name| &*name.text == "restricted");
    named && arg.value.kind == ExprKind::Bool(false)
}

fn value(arg: &Arg) -> Option<Value> {
    match &arg.value.kind {
        ExprKind::Text(text) => Some(Value::Text(text.clone())),
        ExprKind::Bool(truth) => Some(Value::Bool(*truth)),
        _ => number(&arg.value).map(Value::Float),
    }
}

fn text(expr: &Expr) -> Option<Arc<str>> {
    match &expr.kind {
        ExprKind::Text(text) => Some(text.clone()),
        _ => None,
    }
}

fn number(expr: &Expr) -> Option<f64> {
    match &expr.kind {
        ExprKind::Number(number) => Some(*number),
        ExprKind::Unary(UnaryOp::Minus, inner) => number(inner).map(|n| -n),
        _ => None,
    }
}

/// A text or a bare word.
fn word(expr: &Expr) -> Option<Arc<str>> {
    match &expr.kind {
        ExprKind::Text(word) | ExprKind::Call(word, None) => Some(word.clone()),
        _ => None,
    }
}

/// What the annotations of an attribute allow.
fn allowed(attribute: &Attribute) -> String {
    match attribute.range {
        Some((low, high)) => format!("`@Range` allows {low} to {high}"),
        None => {
            let words: Vec<String> = attribute.choices.iter().map(|choice| format!("`{choice}`")).collect();
            format!("`@Enum` allows {}", words.join(", "))
        }
    }
}

impl Checker {
    /// `@StartRule` and `@Zone` of the main file's rules, and initial values outside their ranges.
    pub(super) fn annotations(&mut self, rules: &[Written]) {
        for (index, written) in rules.iter().enumerate().filter(|(_, w)| w.is_main()) {
            for annotation in written.annotations() {
                match &*annotation.name.text {
                    "StartRule" | "Startrule" => self.program.start = self.program.start.or(Some(index as u32)),
                    "Zone" => self.zone(index as u32, written, annotation),
                    _ => {}
                }
            }
        }
        self.ranges();
    }

    fn zone(&mut self, rule: u32, written: &Written, annotation: &Annotation) {
        let words: Vec<Arc<str>> = annotation.args.iter().filter_map(|a| word(&a.value)).collect();
        if written.rule().params.as_ref().is_some_and(|p| !p.is_empty()) {
            let message = format!("`{}` takes arguments, so no region can begin with it", written.rule().name.text);
            return self.tell(Diagnostic::error("zone", annotation.span, message));
        }
        match words.as_slice() {
            [kind] => self.program.zones.push(Zone { kind: kind.clone(), zone: None, rule }),
            [kind, zone] => self.program.zones.push(Zone { kind: kind.clone(), zone: Some(zone.clone()), rule }),
            _ => self.tell(
                Diagnostic::error("zone", annotation.span, "`@Zone` takes a kind and perhaps a zone")
                    .hint("as in `@Zone(lot, residential)`"),
            ),
        }
    }

    /// `@Context(radius)` of an attribute, metres.
    pub(super) fn context(&mut self, annotations: &[Annotation]) -> Option<f64> {
        let annotation = annotations.iter().find(|a| &*a.name.text == "Context")?;
        let radius = match annotation.args.as_slice() {
            [arg] => number(&arg.value).filter(|radius| radius.is_finite() && *radius >= 0.0),
            _ => None,
        };
        match radius {
            None => self.tell(
                Diagnostic::error("context", annotation.span, "`@Context` takes a radius in metres, from 0 up")
                    .hint("as in `@Context(180)`"),
            ),
            Some(radius) if radius > WIDEST_CONTEXT => {
                let message = format!("a context of {radius} m is beyond the usual 0 to {WIDEST_CONTEXT}");
                self.tell(Diagnostic::lint("usual", annotation.span, message));
            }
            Some(_) => {}
        }
        radius
    }

    fn ranges(&mut self) {
        let mut lints = Vec::new();
        for attribute in &self.program.attributes {
            if let Some((low, high)) = attribute.range.filter(|(low, high)| low > high) {
                let message =
                    format!("the range of `{}` runs from {low} to {high}: no number is in it", attribute.name);
                let hint = format!("as in `@Range(min = {high}, max = {low})`");
                lints.push(Diagnostic::lint("range", attribute.span, message).hint(hint));
                continue;
            }
            let Code::Value(value) = &attribute.initial else { continue };
            let outside = match (value.as_float(), attribute.range) {
                (Some(number), Some((low, high))) => number < low || number > high,
                _ => false,
            };
            let stranger = !attribute.choices.is_empty() && !attribute.choices.contains(value);
            if outside || (stranger && attribute.kind == Kind::Text) {
                let message =
                    format!("`{}` begins with `{value}`, which its annotation does not allow", attribute.name);
                lints.push(Diagnostic::lint("range", attribute.span, message).hint(allowed(attribute)));
            }
        }
        self.diagnostics.extend(lints);
    }
}
