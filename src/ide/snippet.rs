//! Snippets: what is inserted for an operation, function or rule, with a stop at everything that has to be given.

use crate::functions::Function;
use crate::ops::{BlockKind, Param, ParamKind, Spec};

/// A text that is inserted as it is.
pub(super) fn literal(text: &str) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        if matches!(c, '$' | '}' | '\\') {
            escaped.push('\\');
        }
        escaped.push(c);
    }
    escaped
}

/// An operation with what must be given, and its block.
pub(super) fn operation(spec: &Spec) -> String {
    let needed: Vec<&Param> = spec.params.iter().filter(|param| param.default.is_none()).collect();
    let stops: Vec<String> = needed.iter().enumerate().map(|(index, param)| stop(index + 1, param)).collect();
    let block = block(spec.block, stops.len() + 1);
    let optional = spec.params.len() > needed.len() && needed.is_empty();
    let inside = if optional { "$1".to_string() } else { stops.join(", ") };
    format!("{}({inside}){block}", spec.name)
}

/// A block with stops from a number on.
fn block(kind: BlockKind, next: usize) -> String {
    let (second, third, fourth) = (next + 1, next + 2, next + 3);
    match kind {
        BlockKind::None => String::new(),
        BlockKind::Cuts => format!(" {{ ~${{{next}:1}} : ${{{second}:A}} \\}}"),
        BlockKind::Perimeter => {
            format!(" {{ ~${{{next}:6}} : ${{{second}:3}} : ${{{third}:A}} \\}} {{ remainder : ${{{fourth}:B}} \\}}")
        }
        BlockKind::Selectors(_) => format!(" {{ ${{{next}:all}} : ${{{second}:A}} \\}}"),
        BlockKind::Body | BlockKind::Operands(1) => format!(" {{ ${{{next}:A}} \\}}"),
        BlockKind::Operands(_) => format!(" {{ ${{{next}:A}} | ${{{second}:B}} \\}}"),
    }
}

fn stop(index: usize, param: &Param) -> String {
    match param.kind {
        ParamKind::Choice(words) => format!("${{{index}|{}|}}", words.join(",")),
        ParamKind::Text => format!("\"${{{index}:{}}}\"", param.name),
        _ => format!("${{{index}:{}}}", param.name),
    }
}

/// A function with a stop for its arguments; an attribute as it is.
pub(super) fn function(function: &Function) -> String {
    match function.arity.1 {
        0 if function.signature.is_empty() => literal(function.name),
        0 => format!("{}()", literal(function.name)),
        _ => format!("{}($1)", literal(function.name)),
    }
}

/// A rule or function of a file with a stop for each parameter.
pub(super) fn own(name: &str, params: Option<&[String]>) -> String {
    let Some(params) = params.filter(|params| !params.is_empty()) else { return literal(name) };
    let stops = params.iter().enumerate().map(|(index, param)| format!("${{{}:{}}}", index + 1, literal(param)));
    format!("{}({})", literal(name), stops.collect::<Vec<_>>().join(", "))
}
