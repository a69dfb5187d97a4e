//! Arrays: sizes, sums, orders, search, and new arrays from old ones. Indices count from 0, row by row.

use crate::functions::args::{any, array_at, number, text_at, wrong};
use crate::functions::{Function, Gives};
use crate::value::{Array, Cells, Value, order_of_numbers};

macro_rules! size {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(array)", (1, 1), $docs, |args, _| {
            let f: fn(&Array) -> usize = $f;
            Ok(Value::Float(f(array_at(args, 0)?) as f64))
        })
        .constant()
    };
}

pub(super) static LIST: &[Function] = &[
    size!("size", "How many values an array has.", Array::len),
    size!("nRows", "How many rows an array has.", Array::rows),
    size!("nColumns", "How many columns an array has.", |array| if array.is_empty() { 0 } else { array.columns() }),
    Function::new(
        "sum",
        "(array)",
        (1, 1),
        "The sum of numbers, how many truth values are true, or texts one after the other.",
        |args, _| {
            Ok(match array_at(args, 0)?.cells() {
                Cells::Numbers(numbers) => Value::Float(numbers.iter().sum()),
                Cells::Truths(truths) => Value::Float(truths.iter().filter(|truth| **truth).count() as f64),
                Cells::Texts(texts) => Value::text(texts.concat()),
            })
        },
    )
    .gives(Gives::Any)
    .constant(),
    Function::new("transpose", "(array)", (1, 1), "The array with its rows as columns.", |args, _| {
        let array = array_at(args, 0)?;
        let (rows, columns) = (array.rows(), array.columns());
        let places: Vec<usize> = (0..columns).flat_map(|c| (0..rows).map(move |r| r * columns + c)).collect();
        let turned = Array::new(rows, picked(array.cells(), &places)).expect("as many cells as before");
        Ok(Value::Array(turned.into()))
    })
    .gives(Gives::Same)
    .constant(),
    Function::new(
        "findFirst",
        "(text, part) | (array, value) | (array, value, tolerance)",
        (2, 3),
        "Where a part of a text or a value of an array comes first, from 0; -1 where it does not. Numbers may differ by a \
         tolerance (0); what is not a number is never found.",
        |args, _| match any(args, 0)? {
            Value::Array(array) => first_of(array, args).map(place),
            Value::Text(text) | Value::Word(text) => Ok(place(text.find(text_at(args, 1)?).map(|b| characters(text, b)))),
            other => Err(wrong("a text or an array", other)),
        },
    )
    .constant(),
    Function::new(
        "findLast",
        "(text, part)",
        (2, 2),
        "Where a part of a text comes last, from 0; -1 where it does not.",
        |args, _| {
            let text = text_at(args, 0)?;
            Ok(place(text.rfind(text_at(args, 1)?).map(|byte| characters(text, byte))))
        },
    )
    .constant(),
    Function::new(
        "sortIndices",
        "(array)",
        (1, 1),
        "The indices of the values in ascending order, equal ones as they stand; what is not a number comes last. n log n.",
        |args, _| {
            let array = array_at(args, 0)?;
            let mut indices: Vec<usize> = (0..array.len()).collect();
            match array.cells() {
                Cells::Numbers(numbers) => indices.sort_by(|a, b| order_of_numbers(numbers[*a], numbers[*b])),
                Cells::Texts(texts) => indices.sort_by(|a, b| texts[*a].cmp(&texts[*b])),
                Cells::Truths(_) => return Err(wrong("an array of numbers or texts", &args[0])),
            }
            Ok(row_of(indices))
        },
    )
    .gives(Gives::Numbers)
    .constant(),
    Function::new(
        "sortRowIndices",
        "(array)",
        (1, 1),
        "The indices of the rows in ascending order: by their first value, then by the next. n log n.",
        |args, _| {
            let array = array_at(args, 0)?;
            if let Cells::Truths(_) = array.cells() {
                return Err(wrong("an array of numbers or texts", &args[0]));
            }
            let mut indices: Vec<usize> = (0..array.rows()).collect();
            indices.sort_by(|a, b| array.order_of_rows(*a, array, *b).expect("one kind that has an order"));
            Ok(row_of(indices))
        },
    )
    .gives(Gives::Numbers)
    .constant(),
];

/// Where a value comes first in an array.
fn first_of(array: &Array, args: &[Value]) -> Result<Option<usize>, String> {
    Ok(match array.cells() {
        Cells::Numbers(numbers) => {
            let wanted = number(args, 1)?;
            let tolerance = if args.len() > 2 { number(args, 2)? } else { 0.0 };
            // Infinity is found as itself.
            numbers.iter().position(|n| *n == wanted || (n - wanted).abs() <= tolerance)
        }
        Cells::Texts(texts) => {
            let wanted = text_at(args, 1)?;
            texts.iter().position(|text| **text == *wanted)
        }
        Cells::Truths(truths) => {
            let wanted = any(args, 1)?.as_bool().ok_or_else(|| wrong("a truth value", &args[1]))?;
            truths.iter().position(|truth| *truth == wanted)
        }
    })
}

/// An index, or -1.
pub(super) fn place(found: Option<usize>) -> Value {
    Value::Float(found.map_or(-1.0, |index| index as f64))
}

/// How many characters stand before a byte.
pub(super) fn characters(text: &str, byte: usize) -> usize {
    text[..byte].chars().count()
}

/// The cells at some places, which exist.
fn picked(cells: &Cells, places: &[usize]) -> Cells {
    match cells {
        Cells::Numbers(numbers) => Cells::Numbers(places.iter().map(|i| numbers[*i]).collect()),
        Cells::Truths(truths) => Cells::Truths(places.iter().map(|i| truths[*i]).collect()),
        Cells::Texts(texts) => Cells::Texts(places.iter().map(|i| texts[*i].clone()).collect()),
    }
}

fn row_of(indices: Vec<usize>) -> Value {
    Value::Array(Array::row(Cells::Numbers(indices.into_iter().map(|i| i as f64).collect())).into())
}
