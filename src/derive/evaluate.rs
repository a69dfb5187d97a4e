//! Expressions on a shape → values.

use crate::check::{Code, Program};
use crate::diag::Span;
use crate::functions::Surroundings;
use crate::syntax::ast::{BinaryOp, SizeMark};
use crate::value::{Size, Value};
use std::sync::Arc;

/// Why an expression has no value.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Failure {
    /// Where.
    pub span: Span,
    /// What was found and what would do.
    pub message: String,
}

/// What names stand for.
pub(super) struct Names<'a> {
    /// The program.
    pub program: &'a Program,
    /// Parameters of the rule or function.
    pub params: &'a [Value],
    /// How many function calls may still be nested.
    pub calls: usize,
    /// How much higher the tree of calls may grow, so that the stack holds.
    pub room: usize,
}

/// The highest tree of expressions within function calls: some 400 bytes a level, far below a thread's stack.
pub(super) const HIGHEST: usize = 2_000;

/// The value of an expression on the shape of `around`.
pub(super) fn evaluate(code: &Code, names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    match code {
        Code::Value(value) => Ok(value.clone()),
        Code::Param(index) => Ok(names.params[*index as usize].clone()),
        Code::Attribute(slot) => Ok(around.shape.attributes[*slot as usize].clone()),
        Code::Function(index, args) => call(*index, args, names, around),
        Code::Builtin(function, args, span) => {
            let values: smallvec::SmallVec<[Value; 4]> =
                args.iter().map(|arg| evaluate(arg, names, around)).collect::<Result<_, _>>()?;
            (function.call)(&values, around)
                .map_err(|message| Failure { span: *span, message: format!("`{}` {message}", function.name) })
        }
        Code::Sized(mark, inner, span) => {
            let number = number(inner, names, around, *span)?;
            Ok(Value::Size(match mark {
                SizeMark::Relative => Size::Relative(number),
                SizeMark::Floating => Size::Floating(number),
            }))
        }
        Code::Negate(inner, span) => Ok(Value::Float(-number(inner, names, around, *span)?)),
        Code::Not(inner, span) => Ok(Value::Bool(!truth(inner, names, around, *span)?)),
        Code::And(pair, span) => {
            Ok(Value::Bool(truth(&pair.0, names, around, *span)? && truth(&pair.1, names, around, *span)?))
        }
        Code::Or(pair, span) => {
            Ok(Value::Bool(truth(&pair.0, names, around, *span)? || truth(&pair.1, names, around, *span)?))
        }
        Code::Binary(op, pair, span) => {
            let (left, right) = (evaluate(&pair.0, names, around)?, evaluate(&pair.1, names, around)?);
            binary(*op, left, right).map_err(|message| Failure { span: *span, message })
        }
        Code::Case(arms, otherwise, span) => {
            for (test, value) in arms {
                if truth(test, names, around, *span)? {
                    return evaluate(value, names, around);
                }
            }
            evaluate(otherwise, names, around)
        }
        Code::Chance(arms, otherwise, span) => {
            let mut left = around.random.uniform(0.0, 100.0);
            for (percent, value) in arms {
                left -= number(percent, names, around, *span)?;
                if left < 0.0 {
                    return evaluate(value, names, around);
                }
            }
            evaluate(otherwise, names, around)
        }
    }
}

/// An expression that must give true or false.
pub(super) fn truth(code: &Code, names: &Names, around: &mut Surroundings, span: Span) -> Result<bool, Failure> {
    let value = evaluate(code, names, around)?;
    value.as_bool().ok_or_else(|| Failure {
        span,
        message: format!("a condition must be true or false, found {} `{value}`", value.type_name()),
    })
}

/// An expression that must give a number.
pub(super) fn number(code: &Code, names: &Names, around: &mut Surroundings, span: Span) -> Result<f64, Failure> {
    let value = evaluate(code, names, around)?;
    value
        .as_float()
        .ok_or_else(|| Failure { span, message: format!("a number is wanted, found {} `{value}`", value.type_name()) })
}

fn call(index: u32, args: &[Code], names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    let function = &names.program.functions[index as usize];
    let left = names.calls.checked_sub(1).zip(names.room.checked_sub(function.height));
    let Some((calls, room)) = left else {
        let message = format!("`{}` is called too deep within itself or others: the limit is `calls`", function.name);
        return Err(Failure { span: function.span, message });
    };
    let params: smallvec::SmallVec<[Value; 4]> =
        args.iter().map(|arg| evaluate(arg, names, around)).collect::<Result<_, _>>()?;
    evaluate(&function.value, &Names { program: names.program, params: &params, calls, room }, around)
}

fn binary(op: BinaryOp, left: Value, right: Value) -> Result<Value, String> {
    use BinaryOp as B;
    if let (Some(a), Some(b)) = (left.as_float(), right.as_float()) {
        return Ok(match op {
            B::Add => Value::Float(a + b),
            B::Subtract => Value::Float(a - b),
            B::Multiply => Value::Float(a * b),
            B::Divide => Value::Float(a / b),
            B::Remainder => Value::Float(a % b),
            B::Less => Value::Bool(a < b),
            B::LessEqual => Value::Bool(a <= b),
            B::Greater => Value::Bool(a > b),
            B::GreaterEqual => Value::Bool(a >= b),
            B::NotEqual => Value::Bool(a != b),
            B::Equal | B::And | B::Or => Value::Bool(a == b),
        });
    }
    match (op, left.as_str(), right.as_str()) {
        (B::Equal, ..) => Ok(Value::Bool(same(&left, &right))),
        (B::NotEqual, ..) => Ok(Value::Bool(!same(&left, &right))),
        (B::Add, Some(_), _) | (B::Add, _, Some(_)) => Ok(Value::Text(format!("{left}{right}").into())),
        (B::Less, Some(a), Some(b)) => Ok(Value::Bool(a < b)),
        (B::LessEqual, Some(a), Some(b)) => Ok(Value::Bool(a <= b)),
        (B::Greater, Some(a), Some(b)) => Ok(Value::Bool(a > b)),
        (B::GreaterEqual, Some(a), Some(b)) => Ok(Value::Bool(a >= b)),
        _ => Err(format!("cannot be done with {} `{left}` and {} `{right}`", left.type_name(), right.type_name())),
    }
}

/// Texts and bare words of the same letters are the same.
fn same(left: &Value, right: &Value) -> bool {
    match (left.as_str(), right.as_str()) {
        (Some(a), Some(b)) => a == b,
        _ => left == right,
    }
}

/// The value of every attribute on the initial shape: given ones first, then the layout's by name, then the file's.
pub(super) fn attributes(
    program: &Program,
    given: impl Fn(usize) -> Option<Value>,
    around: &mut Surroundings,
    calls: usize,
) -> (Arc<[Value]>, Vec<Failure>) {
    let mut shape = around.shape.clone();
    shape.attributes = vec![Value::Float(0.0); program.attributes.len()].into();
    let mut failures = Vec::new();
    for slot in program.order.iter().map(|slot| *slot as usize) {
        let attribute = &program.attributes[slot];
        let mut random = shape.seed.named(&attribute.name).random();
        let mut around = Surroundings { shape: &shape, random: &mut random, ..reborrow(around) };
        let value = match given(slot) {
            Some(value) => Ok(value),
            None => evaluate(&attribute.initial, &Names { program, params: &[], calls, room: HIGHEST }, &mut around),
        };
        match value {
            Ok(value) => Arc::make_mut(&mut shape.attributes)[slot] = value,
            Err(failure) => failures.push(failure),
        }
    }
    (shape.attributes, failures)
}

/// The same surroundings for a shorter time.
fn reborrow<'s>(around: &'s mut Surroundings<'_>) -> Surroundings<'s> {
    Surroundings {
        shape: around.shape,
        random: around.random,
        intra: around.intra,
        inter: around.inter,
        is_ancestor: around.is_ancestor,
        initial: around.initial,
    }
}
