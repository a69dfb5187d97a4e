//! Checked code as people read it: expressions in words, and where a body is written.

use crate::check::{Body, Code, Program, Step};
use crate::diag::Span;
use crate::syntax::ast::{BinaryOp, SizeMark};
use crate::value::Value;
use std::sync::Arc;

impl Program {
    /// An expression as it could be written, constants filled in, within a rule whose parameters have these names.
    pub fn words(&self, code: &Code, params: &[Arc<str>]) -> String {
        let inner = |code: &Code| match code {
            Code::Binary(..) | Code::And(..) | Code::Or(..) => format!("({})", self.words(code, params)),
            _ => self.words(code, params),
        };
        let pair = |pair: &(Code, Code), sign: &str| format!("{} {sign} {}", inner(&pair.0), inner(&pair.1));
        let call = |name: &str, args: &[Code]| {
            let args: Vec<String> = args.iter().map(|arg| self.words(arg, params)).collect();
            if args.is_empty() { name.to_string() } else { format!("{name}({})", args.join(", ")) }
        };
        match code {
            Code::Value(value) => literal(value),
            Code::Param(index) => params.get(*index as usize).map_or_else(|| "…".into(), ToString::to_string),
            Code::Attribute(slot) => self.attributes[*slot as usize].name.to_string(),
            Code::Function(index, args) => call(&self.functions[*index as usize].name, args),
            Code::Builtin(function, args, _) => call(function.name, args),
            Code::Sized(SizeMark::Relative, code, _) => format!("'{}", inner(code)),
            Code::Sized(SizeMark::Floating, code, _) => format!("~{}", inner(code)),
            Code::Negate(code, _) => format!("-{}", inner(code)),
            Code::Not(code, _) => format!("!{}", inner(code)),
            Code::And(codes, _) => pair(codes, "&&"),
            Code::Or(codes, _) => pair(codes, "||"),
            Code::Binary(op, codes, _) => pair(codes, sign(*op)),
            // Choices within expressions are long: their source shows them.
            _ => "…".into(),
        }
    }
}

impl Body {
    /// Where its first step is written; none where that is `NIL` or nothing.
    pub fn span(&self) -> Option<Span> {
        match self {
            Body::Steps(steps) => steps.iter().find_map(|step| match step {
                Step::Apply(application) => Some(application.span),
                Step::Successor(successor) => Some(successor.span),
                Step::Push(body) => body.span(),
                _ => None,
            }),
            Body::Case(.., span) | Body::Chance(.., span) => Some(*span),
            Body::With(_, body) => body.span(),
            Body::Alternatives(alternatives) => alternatives.first().map(|alternative| alternative.span),
        }
    }
}

/// A value as rules write it.
fn literal(value: &Value) -> String {
    match value {
        Value::Text(text) => format!("{text:?}"),
        other => other.to_string(),
    }
}

fn sign(op: BinaryOp) -> &'static str {
    match op {
        BinaryOp::Or => "||",
        BinaryOp::And => "&&",
        BinaryOp::Equal => "==",
        BinaryOp::NotEqual => "!=",
        BinaryOp::Less => "<",
        BinaryOp::LessEqual => "<=",
        BinaryOp::Greater => ">",
        BinaryOp::GreaterEqual => ">=",
        BinaryOp::Add => "+",
        BinaryOp::Subtract => "-",
        BinaryOp::Multiply => "*",
        BinaryOp::Divide => "/",
        BinaryOp::Remainder => "%",
    }
}
