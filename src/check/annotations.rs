//! What annotations say: ranges, choices and descriptions of attributes; start rules and zones of rules.

use crate::check::Checker;
use crate::check::names::Written;
use crate::check::program::{Attribute, Code, Kind, Zone};
use crate::diag::Diagnostic;
use crate::syntax::ast::{Annotation, Arg, Expr, ExprKind, UnaryOp};
use crate::value::Value;
use std::collections::BTreeSet;
use std::sync::Arc;

/// Reads `@Range`, `@Enum` and `@Description` into an attribute.
pub(super) fn describe(attribute: &mut Attribute, annotations: &[Annotation]) {
    for annotation in annotations {
        match &*annotation.name.text {
            "Description" => attribute.description = annotation.args.first().and_then(|a| text(&a.value)),
            "Range" | "Percent" => range(attribute, &annotation.args),
            "Enum" => attribute.choices.extend(annotation.args.iter().filter(|a| a.name.is_none()).filter_map(value)),
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

impl Checker {
    /// `@StartRule` and `@Zone` of the main file's rules, and initial values outside their ranges.
    pub(super) fn annotations(&mut self, rules: &[Written]) {
        for (index, written) in rules.iter().enumerate().filter(|(_, w)| w.module == 0) {
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

    fn ranges(&mut self) {
        let mut lints = Vec::new();
        for attribute in &self.program.attributes {
            let Code::Value(value) = &attribute.initial else { continue };
            let outside = match (value.as_float(), attribute.range) {
                (Some(number), Some((low, high))) => number < low || number > high,
                _ => false,
            };
            let stranger = !attribute.choices.is_empty() && !attribute.choices.contains(value);
            if outside || (stranger && attribute.kind == Kind::Text) {
                let message =
                    format!("`{}` begins with `{value}`, which its annotation does not allow", attribute.name);
                lints.push(Diagnostic::lint("range", attribute.span, message));
            }
        }
        self.diagnostics.extend(lints);
    }

    /// The order in which attributes can be evaluated; a circle is an error.
    pub(super) fn order(&mut self) {
        let mut visit = Visit { done: BTreeSet::new(), path: Vec::new(), order: Vec::new(), circle: None };
        for slot in 0..self.program.attributes.len() {
            visit.slot(&self.program, slot as u16);
            if let Some(slot) = visit.circle.take() {
                let attribute = &self.program.attributes[slot as usize];
                let message = format!("the value of `{}` needs itself", attribute.name);
                let diagnostic = Diagnostic::error("attribute-cycle", attribute.span, message);
                self.diagnostics.push(diagnostic);
            }
        }
        self.program.order = visit.order;
    }
}

/// Depth-first over what attributes need.
struct Visit {
    done: BTreeSet<u16>,
    path: Vec<u16>,
    order: Vec<u16>,
    circle: Option<u16>,
}

impl Visit {
    fn slot(&mut self, program: &crate::check::Program, slot: u16) {
        if self.path.contains(&slot) {
            self.circle = Some(slot);
            return;
        }
        if self.done.contains(&slot) {
            return;
        }
        self.path.push(slot);
        self.code(program, &program.attributes[slot as usize].initial, &mut BTreeSet::new());
        self.done.insert(slot);
        self.path.pop();
        self.order.push(slot);
    }

    fn code(&mut self, program: &crate::check::Program, code: &Code, seen: &mut BTreeSet<u32>) {
        match code {
            Code::Attribute(slot) => self.slot(program, *slot),
            Code::Function(index, _) if seen.insert(*index) => {
                if let Some(function) = program.functions.get(*index as usize) {
                    self.code(program, &function.value, seen);
                }
            }
            _ => {}
        }
        for part in code.parts() {
            self.code(program, part, seen);
        }
    }
}
