//! Values as other kinds: numbers, truth values and texts, and arrays of them.

use crate::functions::args::{any, text_at, wrong};
use crate::functions::{Function, Gives};
use crate::text::leading_number;
use crate::value::{Array, Cells, Value};
use std::sync::Arc;

/// How CityEngine writes a text that is missing.
const MISSING: &str = "\u{e000}";

pub(super) static LIST: &[Function] = &[
    Function::new("str", "(value)", (1, 1), "Any value as a text.", |args, _| Value::written(format_args!("{}", args[0])))
        .text()
        .constant(),
    Function::new(
        "float",
        "(value)",
        (1, 1),
        "A text, truth value or number as a number: what a text begins with, or not a number where it begins with none.",
        |args, _| match any(args, 0)? {
            Value::Bool(truth) => Ok(Value::Float(f64::from(u8::from(*truth)))),
            Value::Text(text) | Value::Word(text) => Ok(Value::Float(leading_number(text))),
            value => value.as_float().map(Value::Float).ok_or_else(|| wrong("one value", value)),
        },
    )
    .constant(),
    Function::new(
        "bool",
        "(value)",
        (1, 1),
        "Whether a number is not 0; a text is false where it is empty, `f`, `false` or a zero, and true otherwise.",
        |args, _| match any(args, 0)? {
            Value::Bool(truth) => Ok(Value::Bool(*truth)),
            Value::Text(text) | Value::Word(text) => Ok(Value::Bool(is_true(text))),
            value => value.as_float().map(|n| Value::Bool(n != 0.0)).ok_or_else(|| wrong("one value", value)),
        },
    )
    .truth()
    .constant(),
    Function::new(
        "floatArray",
        "() | (array)",
        (0, 1),
        "An empty array of numbers, or each value of an array as `float()` has it.",
        |args, _| array(args, |cells| Cells::Numbers(numbers(cells))),
    )
    .gives(Gives::Numbers)
    .constant(),
    Function::new(
        "boolArray",
        "() | (array)",
        (0, 1),
        "An empty array of truth values, or each value of an array as `bool()` has it.",
        |args, _| array(args, |cells| Cells::Truths(truths(cells))),
    )
    .gives(Gives::Truths)
    .constant(),
    Function::new(
        "stringArray",
        "() | (array)",
        (0, 1),
        "An empty array of texts, or each value of an array as `str()` has it.",
        |args, _| array(args, |cells| Cells::Texts(texts(cells))),
    )
    .gives(Gives::Texts)
    .constant(),
    Function::new(
        "isNull",
        "(value) | (array)",
        (1, 1),
        "Whether a value is missing: not a number, or the text `\\ue000`; for each where it is an array.",
        |args, _| match any(args, 0)? {
            Value::Array(given) => {
                let cells = match given.cells() {
                    Cells::Numbers(numbers) => numbers.iter().map(|n| n.is_nan()).collect(),
                    Cells::Texts(texts) => texts.iter().map(|text| &**text == MISSING).collect(),
                    Cells::Truths(truths) => vec![false; truths.len()],
                };
                let nulls = Array::new(given.columns(), Cells::Truths(cells)).expect("as many cells as before");
                Ok(Value::Array(nulls.into()))
            }
            value => Ok(Value::Bool(value.as_float().is_some_and(f64::is_nan) || value.as_str() == Some(MISSING))),
        },
    )
    .gives(Gives::TruthOfEach)
    .constant(),
    Function::new("sel", "(text)", (1, 1), "A text as a selector or the name of an attribute.", |args, _| {
        Ok(Value::Word(text_at(args, 0)?.into()))
    })
    .text()
    .constant(),
];

fn is_true(text: &str) -> bool {
    let text = text.trim();
    let is_zero = || text.parse() == Ok(0.0);
    !(text.is_empty() || text.eq_ignore_ascii_case("f") || text.eq_ignore_ascii_case("false") || is_zero())
}

fn array(args: &[Value], convert: fn(&Cells) -> Cells) -> Result<Value, String> {
    let Some(value) = args.first() else { return Ok(Value::Array(Array::row(convert(&Cells::Truths(vec![]))).into())) };
    let given = value.as_array().ok_or_else(|| wrong("an array", value))?;
    let converted = Array::new(given.columns(), convert(given.cells())).expect("as many cells as before");
    Ok(Value::Array(Arc::new(converted)))
}

fn numbers(cells: &Cells) -> Vec<f64> {
    match cells {
        Cells::Numbers(numbers) => numbers.clone(),
        Cells::Truths(truths) => truths.iter().map(|truth| f64::from(u8::from(*truth))).collect(),
        Cells::Texts(texts) => texts.iter().map(|text| leading_number(text)).collect(),
    }
}

fn truths(cells: &Cells) -> Vec<bool> {
    match cells {
        Cells::Numbers(numbers) => numbers.iter().map(|n| *n != 0.0).collect(),
        Cells::Truths(truths) => truths.clone(),
        Cells::Texts(texts) => texts.iter().map(|text| is_true(text)).collect(),
    }
}

fn texts(cells: &Cells) -> Vec<Arc<str>> {
    match cells {
        Cells::Numbers(numbers) => numbers.iter().map(|n| Value::Float(*n).to_string().into()).collect(),
        Cells::Truths(truths) => truths.iter().map(|truth| if *truth { "true" } else { "false" }.into()).collect(),
        Cells::Texts(texts) => texts.clone(),
    }
}
