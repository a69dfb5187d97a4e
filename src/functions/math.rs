//! Numbers. Angles are degrees, as in CityEngine.

use crate::functions::{Function, number};
use crate::value::Value;

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

macro_rules! binary {
    ($name:literal, $signature:literal, $docs:literal, $f:expr) => {
        Function::new($name, $signature, (2, 2), $docs, |args, _| {
            let f: fn(f64, f64) -> f64 = $f;
            Ok(Value::Float(f(number(args, 0)?, number(args, 1)?)))
        })
        .constant()
    };
}

pub(super) static LIST: &[Function] = &[
    unary!("abs", "The absolute value.", f64::abs),
    unary!("ceil", "The next whole number above.", f64::ceil),
    unary!("floor", "The next whole number below.", f64::floor),
    unary!("rint", "The nearest whole number.", f64::round_ties_even),
    unary!("sqrt", "The square root.", f64::sqrt),
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
    binary!("min", "(a, b)", "The lesser of two numbers.", f64::min),
    binary!("max", "(a, b)", "The greater of two numbers.", f64::max),
    Function::new("clamp", "(x, least, greatest)", (3, 3), "x, kept between two bounds.", |args, _| {
        let (x, low, high) = (number(args, 0)?, number(args, 1)?, number(args, 2)?);
        Ok(Value::Float(x.max(low).min(high)))
    })
    .constant(),
    Function::new("isnan", "(x)", (1, 1), "Whether x is not a number.", |args, _| {
        Ok(Value::Bool(number(args, 0)?.is_nan()))
    })
    .truth()
    .constant(),
    Function::new("isinf", "(x)", (1, 1), "Whether x is infinite.", |args, _| {
        Ok(Value::Bool(number(args, 0)?.is_infinite()))
    })
    .truth()
    .constant(),
];
