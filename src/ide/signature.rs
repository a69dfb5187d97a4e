//! The call under the cursor: how it is written, and which of its parameters the cursor is at.

use crate::functions::Function;
use crate::ide::Desk;
use crate::ide::context::{Callee, Context, parameter_index};
use crate::ide::identity::Identity;
use crate::ide::page;
use crate::ops::Spec;
use std::ops::Range;

/// How something is called.
#[derive(Clone, Debug, PartialEq)]
pub struct Signature {
    /// On one line: `setback(distance) { … }`.
    pub label: String,
    /// What it does, in a sentence or a comment.
    pub docs: String,
    /// The stretch of the label that each parameter takes, and what it means.
    pub params: Vec<(Range<usize>, String)>,
    /// The parameter at the cursor.
    pub active: usize,
}

impl Desk<'_> {
    /// The call whose parentheses are open at a byte: one signature, or one for each overload.
    pub fn signatures(&self, path: &str, offset: usize) -> Vec<Signature> {
        let Some(document) = self.document(path) else { return Vec::new() };
        let Some(context) = Context::of(&document, offset) else { return Vec::new() };
        let Some((call, owner)) = context.call().and_then(|call| Some((call, call.owner?))) else { return Vec::new() };
        match self.callee(&document, owner) {
            Some(Callee::Operation(spec)) => vec![of_operation(spec, parameter_index(&document, spec, call))],
            Some(Callee::Builtin(function)) => vec![of_function(function, call.argument)],
            Some(Callee::Own(identity)) => self.of_own(&identity, call.argument),
            Some(Callee::Import(_)) | None => Vec::new(),
        }
    }

    fn of_own(&self, identity: &Identity, active: usize) -> Vec<Signature> {
        let Some(document) = self.document(identity.path()) else { return Vec::new() };
        let definitions = identity.definitions(&document).into_iter();
        let with_params = definitions.filter_map(|d| Some((d, d.params.as_ref().filter(|params| !params.is_empty())?)));
        let signature = |(definition, params): (&crate::ide::Definition, &Vec<String>)| {
            let label = format!("{}({})", definition.name, params.join(", "));
            let params = stretches(&label, params.iter().map(|param| (param.as_str(), String::new())));
            let docs = page::comment(&document, definition).unwrap_or_default();
            Signature { label, docs, params, active }
        };
        with_params.map(signature).collect()
    }
}

fn of_operation(spec: &Spec, active: usize) -> Signature {
    let label = spec.usage();
    let params = stretches(&label, spec.params.iter().map(|param| (param.name, page::parameter(param))));
    let docs = spec.docs.lines().map(str::trim).take_while(|line| !line.is_empty() && !line.starts_with("```"));
    Signature { docs: docs.collect::<Vec<_>>().join(" "), params, active, label }
}

fn of_function(function: &Function, active: usize) -> Signature {
    let label = format!("{}{}", function.name, function.signature);
    let inner = function.signature.trim_matches(['(', ')']);
    let names = inner.split(',').map(|name| name.trim_matches(|c: char| !c.is_alphanumeric() && c != '_'));
    let params = stretches(&label, names.filter(|name| !name.is_empty()).map(|name| (name, String::new())));
    Signature { docs: function.docs.into(), params, active, label }
}

/// Where each name stands in the parentheses of a label, one after the other.
fn stretches<'a>(label: &str, names: impl Iterator<Item = (&'a str, String)>) -> Vec<(Range<usize>, String)> {
    let mut at = label.find('(').unwrap_or(0);
    let mut found = Vec::new();
    for (name, docs) in names {
        let Some(start) = label[at..].find(name).map(|start| at + start) else { continue };
        at = start + name.len();
        found.push((start..at, docs));
    }
    found
}
