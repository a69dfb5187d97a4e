//! `setElems`: arrays with some values replaced, by indices, index arrays or truth values.

use crate::functions::args::{any, array_at, wrong};
use crate::functions::{Function, Gives};
use crate::value::{Array, Cells, Value, within_cells};

pub(super) static LIST: &[Function] = &[Function::new(
    "setElems",
    "(array, indices, values) | (array, rows, columns, values)",
    (3, 4),
    "The array with some values replaced: by an index, an array of them, or truth values that choose. One value goes to \
     all places, an array needs one for each. Negative indices are passed over, larger ones make the array grow.",
    |args, _| {
        let array = array_at(args, 0)?;
        let changed = match args {
            [_, indices, values] => linear(array, &places(indices)?, values),
            _ => by_rows(array, &places(any(args, 1)?)?, &places(any(args, 2)?)?, any(args, 3)?),
        };
        changed.map(|array| Value::Array(array.into()))
    },
)
.gives(Gives::Same)
.constant()];

/// The indices that a value stands for; none for such as are passed over.
fn places(value: &Value) -> Result<Vec<Option<usize>>, String> {
    let index = |number: f64| {
        let whole = number.floor();
        (whole >= 0.0).then_some(whole.min(f64::from(u32::MAX)) as usize)
    };
    if let Some(number) = value.as_float() {
        return Ok(vec![index(number)]);
    }
    match value.as_array().map(|array| array.cells()) {
        Some(Cells::Numbers(numbers)) => Ok(numbers.iter().map(|n| index(*n)).collect()),
        Some(Cells::Truths(truths)) => Ok((0..truths.len()).filter(|i| truths[*i]).map(Some).collect()),
        _ => Err(wrong("indices: a number, an array of numbers or of truth values", value)),
    }
}

fn linear(array: &Array, places: &[Option<usize>], values: &Value) -> Result<Array, String> {
    let values = values_for(array, values, places.len(), None)?;
    let needed = places.iter().flatten().max().map_or(0, |last| last + 1).max(array.len());
    // A single row grows by columns; several grow by rows.
    let columns = if array.rows() > 1 { array.columns() } else { needed };
    let rows = if columns == 0 { 0 } else { needed.div_ceil(columns) };
    let mut cells = grown(array, rows, columns)?;
    let targets = places.iter().enumerate().filter_map(|(from, to)| Some((from, (*to)?)));
    put(&mut cells, &values, targets);
    Ok(Array::new(columns, cells).expect("whole rows"))
}

fn by_rows(array: &Array, rows: &[Option<usize>], columns: &[Option<usize>], values: &Value) -> Result<Array, String> {
    let values = values_for(array, values, rows.len() * columns.len(), Some(columns.len()))?;
    let last = |places: &[Option<usize>]| places.iter().flatten().max().map_or(0, |last| last + 1);
    let (high, wide) = (last(rows).max(array.rows()), last(columns).max(array.columns()));
    let mut cells = grown(array, high, wide)?;
    let pairs = rows.iter().flat_map(|row| columns.iter().map(move |column| Some((*row)?).zip(*column)));
    let targets = pairs.enumerate().filter_map(|(from, to)| to.map(|(row, column)| (from, row * wide + column)));
    put(&mut cells, &values, targets);
    Ok(Array::new(if high == 0 { 0 } else { wide }, cells).expect("whole rows"))
}

/// The new values: one for all places, or as many as there are, in rows of so many.
fn values_for(array: &Array, values: &Value, places: usize, columns: Option<usize>) -> Result<Cells, String> {
    let cells = match values {
        Value::Array(given) if given.len() != places || columns.is_some_and(|c| places > 0 && c != given.columns()) => {
            let (rows, wide) = (given.rows(), given.columns());
            return Err(match columns {
                None => format!("takes one value or {places}, one for each place, found {}", given.len()),
                Some(columns) => {
                    let high = places.checked_div(columns).unwrap_or(0);
                    format!("takes one value or {high} rows of {columns}, found {rows} rows of {wide}")
                }
            });
        }
        Value::Array(given) => given.cells().clone(),
        Value::Bool(truth) => Cells::Truths(vec![*truth]),
        Value::Text(text) | Value::Word(text) => Cells::Texts(vec![text.clone()]),
        value => Cells::Numbers(vec![value.as_float().ok_or_else(|| wrong("a value", value))?]),
    };
    match (array.cells(), &cells) {
        (Cells::Numbers(_), Cells::Numbers(_))
        | (Cells::Truths(_), Cells::Truths(_))
        | (Cells::Texts(_), Cells::Texts(_)) => Ok(cells),
        _ => Err(format!("puts values into {} that are of another kind: {}", array.type_name(), values.type_name())),
    }
}

/// The cells of an array in more rows and columns; what is new is 0, `false` or empty.
fn grown(array: &Array, rows: usize, columns: usize) -> Result<Cells, String> {
    within_cells(rows as f64 * columns as f64)?;
    let (old, wide) = (array.columns(), columns);
    Ok(match array.cells() {
        Cells::Numbers(cells) => Cells::Numbers(laid(cells, old, rows, wide, &0.0)),
        Cells::Truths(cells) => Cells::Truths(laid(cells, old, rows, wide, &false)),
        Cells::Texts(cells) => Cells::Texts(laid(cells, old, rows, wide, &"".into())),
    })
}

fn laid<T: Clone>(cells: &[T], old: usize, rows: usize, columns: usize, empty: &T) -> Vec<T> {
    let mut new = vec![empty.clone(); rows * columns];
    if old == 0 {
        return new;
    }
    for (row, cells) in cells.chunks(old).enumerate() {
        new[row * columns..row * columns + cells.len()].clone_from_slice(cells);
    }
    new
}

/// Puts values, of which one goes everywhere, at places that exist.
fn put(cells: &mut Cells, values: &Cells, targets: impl Iterator<Item = (usize, usize)>) {
    let one = values.len() == 1;
    match (cells, values) {
        (Cells::Numbers(cells), Cells::Numbers(values)) => {
            targets.for_each(|(from, to)| cells[to] = values[if one { 0 } else { from }]);
        }
        (Cells::Truths(cells), Cells::Truths(values)) => {
            targets.for_each(|(from, to)| cells[to] = values[if one { 0 } else { from }]);
        }
        (Cells::Texts(cells), Cells::Texts(values)) => {
            targets.for_each(|(from, to)| cells[to] = values[if one { 0 } else { from }].clone());
        }
        _ => {}
    }
}
