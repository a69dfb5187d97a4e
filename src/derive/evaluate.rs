//! Expressions on a shape → values.

use crate::check::{Code, Program};
use crate::derive::{arrays, measure};
use crate::diag::Span;
use crate::functions::{Function, Surroundings};
use crate::syntax::ast::{BinaryOp, SizeMark};
use crate::value::{Size, Value};
use smallvec::SmallVec;
use std::cell::Cell;
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
#[derive(Clone, Copy)]
pub(super) struct Names<'a> {
    /// The program.
    pub program: &'a Program,
    /// Parameters of the rule or function.
    pub params: &'a [Value],
    /// How many function calls may still be nested.
    pub calls: usize,
    /// How much higher the tree of calls may grow, so that the stack holds.
    pub room: usize,
    /// How many calls there were in this expression.
    pub spent: &'a Cell<u32>,
}

/// The highest tree of expressions within function calls: some 400 bytes a level, far below a thread's stack.
pub(super) const HIGHEST: usize = 2_000;

/// The most calls of functions in one expression, some tenths of a second: one that calls itself twice goes nowhere deep
/// and yet without end.
const MOST_CALLS: u32 = 3_000_000;

/// The value of an expression on the shape of `around`.
///
/// Recursive: what an arm needs room for stands in a function of its own, so that a level takes little of the stack.
pub(super) fn evaluate(code: &Code, names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    match code {
        Code::Value(value) => Ok(value.clone()),
        // Programs with errors may name what is not there; they are not meant to be derived, but must not panic.
        Code::Param(index) => Ok(names.params.get(*index as usize).cloned().unwrap_or(Value::Float(0.0))),
        Code::Attribute(slot) => Ok(around.shape.attributes[*slot as usize].clone()),
        Code::Function(index, args) => call(*index, args, names, around),
        Code::Builtin(function, args, span) => builtin(function, args, *span, names, around),
        Code::Sized(mark, inner, span) => number(inner, names, around, *span).map(|n| sized(*mark, n)),
        Code::Negate(inner, span) => arrays::negated(inner, *span, names, around),
        Code::Not(inner, span) => arrays::inverted(inner, *span, names, around),
        Code::And(pair, span) => both(pair, *span, false, names, around),
        Code::Or(pair, span) => both(pair, *span, true, names, around),
        Code::Binary(op, pair, span) => operation(*op, pair, *span, names, around),
        Code::Case(arms, otherwise, span) => case(arms, otherwise, *span, names, around),
        Code::Chance(arms, otherwise, span) => chance(arms, otherwise, *span, names, around),
        Code::Array(rows, span) => arrays::literal(rows, *span, names, around),
        Code::Range(range, span) => arrays::range(range, *span, names, around),
        Code::Index(array, indices, span) => arrays::index(array, indices, *span, names, around),
        Code::Each(op, pair, span) => arrays::each(*op, pair, *span, names, around),
        Code::Comp(comp) => measure::measure(comp, names, around),
        Code::With(locals, value) => with(locals, value, names, around),
        Code::Listed(slot, otherwise) => listed(*slot, otherwise, names, around),
    }
}

/// `with`: locals in order, each beside the parameters and the locals before it.
#[inline(never)]
fn with(locals: &[Code], value: &Code, names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    let params = extended(locals, names, around)?;
    evaluate(value, &Names { params: &params, ..*names }, around)
}

/// The parameters, and the values of locals after them.
pub(super) fn extended(locals: &[Code], names: &Names, around: &mut Surroundings) -> Result<Box<[Value]>, Failure> {
    let mut params = Vec::with_capacity(names.params.len() + locals.len());
    params.extend_from_slice(names.params);
    for local in locals {
        let value = evaluate(local, &Names { params: &params, ..*names }, around)?;
        params.push(value);
    }
    Ok(params.into())
}

/// `attr name(index)`: from the list that the lot has under that name, or one value for all; else from the expression.
#[inline(never)]
fn listed(slot: u32, otherwise: &Code, names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    match &around.shape.attributes[slot as usize] {
        Value::Array(list) if list.is_empty() => evaluate(otherwise, names, around),
        Value::Array(list) => {
            let index = names.params.first().and_then(Value::as_float).filter(|index| *index >= 0.0);
            Ok(list.at(index.map_or(usize::MAX, |index| index as usize)))
        }
        single => Ok(single.clone()),
    }
}

#[inline(never)]
fn builtin(
    function: &Function,
    args: &[Code],
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let values: Result<SmallVec<[Value; 4]>, Failure> = args.iter().map(|arg| evaluate(arg, names, around)).collect();
    around.source = span.file;
    (function.call)(&values?, around)
        .map_err(|message| Failure { span, message: format!("`{}` {message}", function.name) })
}

fn sized(mark: SizeMark, number: f64) -> Value {
    Value::Size(match mark {
        SizeMark::Relative => Size::Relative(number),
        SizeMark::Floating => Size::Floating(number),
    })
}

/// `&&` and `||`: where the left side is `enough`, the right one is not evaluated.
#[inline(never)]
fn both(
    pair: &(Code, Code),
    span: Span,
    enough: bool,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    if truth(&pair.0, names, around, span)? == enough {
        return Ok(Value::Bool(enough));
    }
    truth(&pair.1, names, around, span).map(Value::Bool)
}

#[inline(never)]
fn operation(
    op: BinaryOp,
    pair: &(Code, Code),
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let (left, right) = (evaluate(&pair.0, names, around)?, evaluate(&pair.1, names, around)?);
    binary(op, left, right).map_err(|message| Failure { span, message })
}

#[inline(never)]
fn case(
    arms: &[(Code, Code)],
    otherwise: &Code,
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    for (test, value) in arms {
        if truth(test, names, around, span)? {
            return evaluate(value, names, around);
        }
    }
    evaluate(otherwise, names, around)
}

#[inline(never)]
fn chance(
    arms: &[(Code, Code)],
    otherwise: &Code,
    span: Span,
    names: &Names,
    around: &mut Surroundings,
) -> Result<Value, Failure> {
    let mut left = around.random.uniform(0.0, 100.0);
    for (percent, value) in arms {
        left -= number(percent, names, around, span)?;
        if left < 0.0 {
            return evaluate(value, names, around);
        }
    }
    evaluate(otherwise, names, around)
}

/// An expression that must give true or false.
pub(super) fn truth(code: &Code, names: &Names, around: &mut Surroundings, span: Span) -> Result<bool, Failure> {
    let value = evaluate(code, names, around)?;
    value.as_bool().ok_or_else(|| Failure {
        span,
        message: format!("a condition must be true or false, found {} `{}`", value.type_name(), value.shown()),
    })
}

/// An expression that must give a number.
pub(super) fn number(code: &Code, names: &Names, around: &mut Surroundings, span: Span) -> Result<f64, Failure> {
    let value = evaluate(code, names, around)?;
    value.as_float().ok_or_else(|| Failure {
        span,
        message: format!("a number is wanted, found {} `{}`", value.type_name(), value.shown()),
    })
}

#[inline(never)]
fn call(index: u32, args: &[Code], names: &Names, around: &mut Surroundings) -> Result<Value, Failure> {
    let function = &names.program.functions[index as usize];
    let left = names.calls.checked_sub(1).zip(names.room.checked_sub(function.height));
    let Some((calls, room)) = left else {
        let message = format!("`{}` is called too deep within itself or others: the limit is `calls`", function.name);
        return Err(Failure { span: function.span, message });
    };
    names.spent.set(names.spent.get() + 1);
    if names.spent.get() > MOST_CALLS {
        let message = format!(
            "`{}` and others are called more than {MOST_CALLS} times in one expression: the limit is `evaluations`",
            function.name
        );
        return Err(Failure { span: function.span, message });
    }
    let params: SmallVec<[Value; 4]> = args.iter().map(|arg| evaluate(arg, names, around)).collect::<Result<_, _>>()?;
    evaluate(&function.value, &Names { params: &params, calls, room, ..*names }, around)
}

/// `a + b` and the like, both evaluated.
#[inline(never)]
pub(super) fn binary(op: BinaryOp, left: Value, right: Value) -> Result<Value, String> {
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
        (B::Add, Some(_), _) | (B::Add, _, Some(_)) => Value::written(format_args!("{left}{right}")),
        (B::Less, Some(a), Some(b)) => Ok(Value::Bool(a < b)),
        (B::LessEqual, Some(a), Some(b)) => Ok(Value::Bool(a <= b)),
        (B::Greater, Some(a), Some(b)) => Ok(Value::Bool(a > b)),
        (B::GreaterEqual, Some(a), Some(b)) => Ok(Value::Bool(a >= b)),
        (B::Less | B::LessEqual | B::Greater | B::GreaterEqual, None, None) => sorted(op, &left, &right),
        _ => Err(undone(&left, &right)),
    }
}

/// Arrays of numbers or texts by what comes first.
fn sorted(op: BinaryOp, left: &Value, right: &Value) -> Result<Value, String> {
    let order = left.as_array().zip(right.as_array()).and_then(|(a, b)| a.order(b));
    let Some(order) = order else {
        return Err(undone(left, right));
    };
    Ok(Value::Bool(match op {
        BinaryOp::Less => order.is_lt(),
        BinaryOp::LessEqual => order.is_le(),
        BinaryOp::Greater => order.is_gt(),
        _ => order.is_ge(),
    }))
}

fn undone(left: &Value, right: &Value) -> String {
    let [a, b] = [left, right].map(|value| format!("{} `{}`", value.type_name(), value.shown()));
    format!("cannot be done with {a} and {b}")
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
            None => {
                let names = Names { program, params: &[], calls, room: HIGHEST, spent: &Cell::new(0) };
                evaluate(&attribute.initial, &names, &mut around)
            }
        };
        match value {
            Ok(value) => Arc::make_mut(&mut shape.attributes)[slot] = value,
            Err(failure) => failures.push(failure),
        }
    }
    (shape.attributes, failures)
}

/// The same surroundings for a shorter time.
pub(super) fn reborrow<'s>(around: &'s mut Surroundings<'_>) -> Surroundings<'s> {
    Surroundings {
        shape: around.shape,
        random: around.random,
        intra: around.intra,
        inter: around.inter,
        is_ancestor: around.is_ancestor,
        initial: around.initial,
        at: around.at,
        catalogue: around.catalogue,
        rasters: around.rasters,
        files: around.files,
        source: around.source,
        georeference: around.georeference,
        tree_key: around.tree_key,
        told: around.told,
    }
}
