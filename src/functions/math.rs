//! Numbers. Angles are degrees, as in CityEngine. What rounds or asks takes arrays too, and gives one of the same rows.

use crate::functions::args::{any, number, wrong};
use crate::functions::{Function, Gives, Surroundings};
use crate::value::{Array, Cells, Value};
use std::cmp::Ordering;
use std::sync::Arc;

const DEGREE: f64 = std::f64::consts::PI / 180.0;

macro_rules! unary {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(x)", (1, 1), $docs, |args, _| {
            let f: fn(f64) -> f64 = $f;
            Ok(Value::Float(f(number(args, 0)?)))
        })
        .constant()
    };
}

/// As `unary`, for arrays too.
macro_rules! each {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(x) | (array)", (1, 1), $docs, |args, _| {
            let f: fn(f64) -> f64 = $f;
            each(args, f)
        })
        .constant()
        .gives(Gives::Same)
    };
}

macro_rules! binary {
    ($name:literal, $signature:literal, $docs:literal, $f:expr) => {
        Function::new($name, $signature, (2, 2), $docs, |args, _| {
            let f: fn(f64, f64) -> f64 = $f;
            Ok(Value::Float(f(number(args, 0)?, number(args, 1)?)))
        })
        .constant()
    };
}

/// A question about a number, or about each of an array.
macro_rules! ask {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(x) | (array)", (1, 1), $docs, |args, _| {
            let f: fn(f64) -> bool = $f;
            ask(args, f)
        })
        .constant()
        .gives(Gives::TruthOfEach)
    };
}

pub(super) static LIST: &[Function] = &[
    each!("abs", "The absolute value, of each where it is an array.", f64::abs),
    each!("ceil", "The next whole number above, of each where it is an array.", f64::ceil),
    each!("floor", "The next whole number below, of each where it is an array.", f64::floor),
    each!(
        "rint",
        "The nearest whole number, of each where it is an array; halves go to the even one.",
        f64::round_ties_even
    ),
    unary!("sqrt", "The square root; not a number below 0.", f64::sqrt),
    unary!("exp", "e to the power of x.", libm::exp),
    unary!("ln", "The natural logarithm.", libm::log),
    unary!("log10", "The decimal logarithm.", libm::log10),
    unary!("sin", "The sine of an angle in degrees.", |x| libm::sin(x * DEGREE)),
    unary!("cos", "The cosine of an angle in degrees.", |x| libm::cos(x * DEGREE)),
    unary!("tan", "The tangent of an angle in degrees.", |x| libm::tan(x * DEGREE)),
    unary!("asin", "The angle in degrees whose sine is x.", |x| libm::asin(x) / DEGREE),
    unary!("acos", "The angle in degrees whose cosine is x.", |x| libm::acos(x) / DEGREE),
    unary!("atan", "The angle in degrees whose tangent is x.", |x| libm::atan(x) / DEGREE),
    binary!("atan2", "(y, x)", "The angle in degrees of the point (x, y).", |y, x| libm::atan2(y, x) / DEGREE),
    binary!("pow", "(base, exponent)", "A power.", libm::pow),
    Function::new(
        "min",
        "(a, b)",
        (2, 2),
        "The lesser of two numbers, texts or arrays, which are compared row by row.",
        |args, around| lesser(args, around, Ordering::Less),
    )
    .constant()
    .gives(Gives::Same),
    Function::new(
        "max",
        "(a, b)",
        (2, 2),
        "The greater of two numbers, texts or arrays, which are compared row by row.",
        |args, around| lesser(args, around, Ordering::Greater),
    )
    .constant()
    .gives(Gives::Same),
    Function::new(
        "clamp",
        "(x, least, greatest)",
        (3, 3),
        "x, kept between two bounds: numbers, texts or arrays.",
        |args, around| {
            let [x, low, high] = args else { return Err("takes three values".into()) };
            let raised = lesser(&[x.clone(), low.clone()], around, Ordering::Greater)?;
            lesser(&[raised, high.clone()], around, Ordering::Less)
        },
    )
    .constant()
    .gives(Gives::Same),
    ask!("isnan", "Whether x is not a number, for each where it is an array.", f64::is_nan),
    ask!("isinf", "Whether x is infinite, for each where it is an array.", f64::is_infinite),
];

/// A function of a number on a number, or on each of an array.
fn each(args: &[Value], f: fn(f64) -> f64) -> Result<Value, String> {
    let value = any(args, 0)?;
    match (value.as_float(), value) {
        (Some(number), _) => Ok(Value::Float(f(number))),
        (_, Value::Array(array)) => mapped(array, f).map(|mapped| Value::Array(mapped.into())),
        _ => Err(wrong("a number or an array of numbers", value)),
    }
}

fn mapped(array: &Array, f: impl Fn(f64) -> f64) -> Result<Array, String> {
    let Cells::Numbers(numbers) = array.cells() else {
        return Err(format!("takes a number or an array of numbers, found {}", array.type_name()));
    };
    let cells = Cells::Numbers(numbers.iter().map(|x| f(*x)).collect());
    Ok(Array::new(array.columns(), cells).expect("as many cells as before"))
}

fn ask(args: &[Value], f: fn(f64) -> bool) -> Result<Value, String> {
    let value = any(args, 0)?;
    if let Some(number) = value.as_float() {
        return Ok(Value::Bool(f(number)));
    }
    match value.as_array().map(|array| (array, array.cells())) {
        Some((array, Cells::Numbers(numbers))) => {
            let cells = Cells::Truths(numbers.iter().map(|x| f(*x)).collect());
            Ok(Value::Array(Arc::new(Array::new(array.columns(), cells).expect("as many cells as before"))))
        }
        _ => Err(wrong("a number or an array of numbers", value)),
    }
}

/// Of two values the one that is `wanted` beside the other. Of numbers of which one is not a number it is the other.
fn lesser(args: &[Value], _: &mut Surroundings, wanted: Ordering) -> Result<Value, String> {
    let (a, b) = (any(args, 0)?, any(args, 1)?);
    if let (Some(a), Some(b)) = (a.as_float(), b.as_float()) {
        return Ok(Value::Float(if wanted == Ordering::Less { a.min(b) } else { a.max(b) }));
    }
    match a.order(b) {
        Some(order) => Ok(if order == wanted { a } else { b }.clone()),
        None => Err(format!("takes two values of one kind, found {} and {}", a.type_name(), b.type_name())),
    }
}
