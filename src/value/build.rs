//! Arrays out of values: `[a, b; c, d]` and `[1 : 2 : 9]`.

use crate::value::{Array, Cells, Value};

/// The largest array that an expression or a function makes: CityEngine's default. Tables of files alone may be larger.
pub const MOST_CELLS: usize = 100_000;
/// Share of its steps by which a range may miss its end.
const NEARLY: f64 = 1e-9;

impl Array {
    /// `from`, `from + step`, … as far as `to`; nothing where the step leads away from it or is 0.
    ///
    /// An end that only rounding has moved out of reach is reached: `[0 : 0.1 : 0.3]` has four values.
    pub fn range(from: f64, step: f64, to: f64) -> Result<Array, String> {
        let steps = (to - from) / step;
        let count = if step == 0.0 { 0.0 } else { (steps + NEARLY * steps.abs().max(1.0)).floor() + 1.0 };
        within_cells(count.max(0.0))?;
        Ok(Array::row(Cells::Numbers((0..count as usize).map(|index| from + index as f64 * step).collect())))
    }

    /// Rows of values and arrays: side by side within a row, then one row below the other. What is empty adds nothing.
    pub fn joined(rows: &[Vec<Value>]) -> Result<Array, String> {
        within_cells(rows.iter().flatten().map(|value| shape(value).0 * shape(value).1).sum::<usize>() as f64)?;
        let (mut columns, mut values) = (0, Vec::new());
        for row in rows {
            let width: usize = row.iter().filter(|value| !is_empty(value)).map(|value| shape(value).1).sum();
            if width > 0 && columns > 0 && width != columns {
                return Err(format!("needs rows of the same length: found {columns} and {width} values"));
            }
            columns = columns.max(width);
            beside(row, &mut values)?;
        }
        let cells = match values.is_empty() {
            true => rows.iter().flatten().find_map(Value::as_array).map_or(Cells::Numbers(Vec::new()), |a| a.none()),
            false => Cells::of(values)?,
        };
        Ok(Array::new(columns, cells).unwrap_or_else(|| Array::row(Cells::Numbers(Vec::new()))))
    }

    /// No cells, of the same type.
    fn none(&self) -> Cells {
        match self.cells() {
            Cells::Numbers(_) => Cells::Numbers(Vec::new()),
            Cells::Truths(_) => Cells::Truths(Vec::new()),
            Cells::Texts(_) => Cells::Texts(Vec::new()),
        }
    }
}

impl Cells {
    /// Values of one type, which is that of the first; numbers where there are none.
    pub fn of(values: Vec<Value>) -> Result<Cells, String> {
        let cells = match values.first() {
            None | Some(Value::Float(_)) => {
                values.iter().map(Value::as_float).collect::<Option<_>>().map(Cells::Numbers)
            }
            Some(Value::Bool(_)) => values.iter().map(Value::as_bool).collect::<Option<_>>().map(Cells::Truths),
            Some(Value::Text(_) | Value::Word(_)) => {
                values.iter().map(|value| value.as_str().map(Into::into)).collect::<Option<_>>().map(Cells::Texts)
            }
            Some(Value::Size(_) | Value::Array(_)) => None,
        };
        cells.ok_or_else(|| {
            let kind = |value: &Value| value.type_name();
            let first = values.first().map_or("nothing", kind);
            let other = values.iter().map(kind).find(|name| *name != first).unwrap_or(first);
            format!("holds values of one type, numbers, truth values or texts: found {first} and {other}")
        })
    }
}

/// The values of one row of a literal, row by row.
fn beside(row: &[Value], values: &mut Vec<Value>) -> Result<(), String> {
    let mut parts = row.iter().filter(|value| !is_empty(value));
    let Some((height, _)) = parts.next().map(shape) else { return Ok(()) };
    if let Some((other, _)) = parts.map(shape).find(|(rows, _)| *rows != height) {
        return Err(format!("has side by side what has {height} and {other} rows"));
    }
    for index in 0..height {
        for part in row.iter().filter(|value| !is_empty(value)) {
            match part {
                Value::Array(array) => values.extend((0..array.columns()).map(|column| array.cell(index, column))),
                single => values.push(single.clone()),
            }
        }
    }
    Ok(())
}

/// Rows and columns.
fn shape(value: &Value) -> (usize, usize) {
    value.as_array().map_or((1, 1), |array| (array.rows(), array.columns()))
}

fn is_empty(value: &Value) -> bool {
    value.as_array().is_some_and(|array| array.is_empty())
}

/// An error where an array would have more values than the limit.
pub fn within_cells(count: f64) -> Result<(), String> {
    if count <= MOST_CELLS as f64 || count.is_nan() {
        return Ok(());
    }
    let found = if count.is_finite() { crate::text::number(count, 12) } else { "endless".into() };
    Err(format!("would have {found} values: the limit `array` is {MOST_CELLS}"))
}
