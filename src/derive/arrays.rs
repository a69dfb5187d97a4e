//! Arrays in expressions: literals, ranges, indices, and operators that work element by element.

use crate::check::Code;
use crate::derive::evaluate::{Failure, Names, binary, evaluate, number};
use crate::diag::Span;
use crate::functions::Surroundings;
use crate::syntax::ast::BinaryOp;
use crate::value::{Array, Value};
use smallvec::SmallVec;
use std::sync::Arc;

/// `[a, b; c, d]`.
#[inline(never)]
pub(super) fn literal(
    rows: &[Box<[Code]>],
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let mut values = Vec::with_capacity(rows.len());
    for row in rows {
        values.push(row.iter().map(|code| evaluate(code, names, around)).collect::<Result<Vec<_>, _>>()?);
    }
    let array = Array::joined(&values).map_err(|message| Failure { span, message: format!("an array {message}") })?;
    Ok(Value::Array(Arc::new(array)))
}

/// `from : step : to`.
#[inline(never)]
pub(super) fn range(
    range: &(Code, Option<Code>, Code),
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let from = number(&range.0, names, around, span)?;
    let step = range.1.as_ref().map_or(Ok(1.0), |step| number(step, names, around, span))?;
    let to = number(&range.2, names, around, span)?;
    let array = Array::range(from, step, to).map_err(|message| Failure { span, message: format!("a range {message}") });
    Ok(Value::Array(Arc::new(array?)))
}

/// `a[i]`, `a[row, column]`.
#[inline(never)]
pub(super) fn index(
    array: &Code,
    indices: &[Code],
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let array = evaluate(array, names, around)?;
    let indices: SmallVec<[Value; 2]> =
        indices.iter().map(|index| evaluate(index, names, around)).collect::<Result<_, _>>()?;
    let picked = match &array {
        Value::Array(array) => array.pick(&indices).map_err(|message| format!("an array {message}")),
        other => Err(format!("only an array is indexed, found {} `{other}`", other.type_name())),
    };
    picked.map_err(|message| Failure { span, message })
}

/// `a .+ b`.
#[inline(never)]
pub(super) fn each(
    op: BinaryOp,
    pair: &(Code, Code),
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let (left, right) = (evaluate(&pair.0, names, around)?, evaluate(&pair.1, names, around)?);
    let act = |a: Value, b: Value| match (op, a.as_bool(), b.as_bool()) {
        (BinaryOp::And, Some(a), Some(b)) => Ok(Value::Bool(a && b)),
        (BinaryOp::Or, Some(a), Some(b)) => Ok(Value::Bool(a || b)),
        (BinaryOp::And | BinaryOp::Or, ..) => {
            Err(format!("truth values are wanted, found {} `{a}` and {} `{b}`", a.type_name(), b.type_name()))
        }
        _ => binary(op, a, b),
    };
    left.paired(&right, act).map_err(|message| Failure { span, message })
}

/// `-a`.
#[inline(never)]
pub(super) fn negated(value: &Value, span: Span) -> Result<Value, Failure> {
    let act = |value: Value| match value.as_float() {
        Some(number) => Ok(Value::Float(-number)),
        None => Err(format!("a number is wanted, found {} `{value}`", value.type_name())),
    };
    value.each(act).map_err(|message| Failure { span, message })
}

/// `!a`, `.!a`.
#[inline(never)]
pub(super) fn inverted(value: &Value, span: Span) -> Result<Value, Failure> {
    let act = |value: Value| match value.as_bool() {
        Some(truth) => Ok(Value::Bool(!truth)),
        None => Err(format!("a condition must be true or false, found {} `{value}`", value.type_name())),
    };
    value.each(act).map_err(|message| Failure { span, message })
}
