//! `a[i]`, `a[row, column]`: values of an array by number, by an array of numbers, or where an array says `true`.

use crate::value::build::within_cells;
use crate::value::{Array, Cells, Value};
use std::sync::Arc;

/// Which places of an array, or of its rows or columns.
enum Places {
    /// One.
    One(usize),
    /// Several, in rows of so many columns.
    Many(usize, Vec<usize>),
}

impl Array {
    /// The value at one index, counted row by row, or at a row and column. What is given as an array gives an array:
    /// of its rows and columns for one index, of as many rows and columns as are asked for with two. Outside stands
    /// what [`Array::at`] gives there.
    pub fn pick(&self, indices: &[Value]) -> Result<Value, String> {
        let places = indices.iter().map(places).collect::<Result<Vec<_>, _>>()?;
        match places.as_slice() {
            [Places::One(index)] => Ok(self.at(*index)),
            [Places::Many(columns, all)] => Ok(self.gathered(*columns, all)),
            [Places::One(row), Places::One(column)] => Ok(self.cell(*row, *column)),
            [rows, columns] => {
                let (rows, columns) = (rows.all(), columns.all());
                within_cells(rows.len() as f64 * columns.len() as f64)?;
                let all: Vec<usize> =
                    rows.iter().flat_map(|row| columns.iter().map(|c| self.place(*row, *c))).collect();
                Ok(self.gathered(columns.len(), &all))
            }
            _ => Err(format!("is indexed with one or two indices, found {}", indices.len())),
        }
    }

    /// The index of a cell, counted row by row; beyond the last where it is outside.
    fn place(&self, row: usize, column: usize) -> usize {
        if row < self.rows() && column < self.columns() { row * self.columns() + column } else { usize::MAX }
    }

    fn gathered(&self, columns: usize, places: &[usize]) -> Value {
        let cells = match self.cells() {
            Cells::Numbers(all) => Cells::Numbers(places.iter().map(|i| all.get(*i).copied().unwrap_or(0.0)).collect()),
            Cells::Truths(all) => Cells::Truths(places.iter().map(|i| all.get(*i).copied().unwrap_or(false)).collect()),
            Cells::Texts(all) => {
                let none: Arc<str> = "".into();
                Cells::Texts(places.iter().map(|i| all.get(*i).unwrap_or(&none).clone()).collect())
            }
        };
        let columns = if places.is_empty() { 0 } else { columns };
        Value::Array(Arc::new(Array::new(columns, cells).unwrap_or_else(|| Array::row(Cells::Numbers(Vec::new())))))
    }
}

impl Places {
    fn all(&self) -> &[usize] {
        match self {
            Places::One(index) => std::slice::from_ref(index),
            Places::Many(_, all) => all,
        }
    }
}

fn places(value: &Value) -> Result<Places, String> {
    match value {
        Value::Float(number) => Ok(Places::One(index(*number))),
        Value::Array(array) => match array.cells() {
            Cells::Numbers(all) => Ok(Places::Many(array.columns(), all.iter().map(|n| index(*n)).collect())),
            Cells::Truths(all) => {
                let taken: Vec<usize> = (0..all.len()).filter(|index| all[*index]).collect();
                Ok(Places::Many(taken.len(), taken))
            }
            Cells::Texts(_) => Err(format!("is indexed with numbers or truth values, found {}", array.type_name())),
        },
        other => Err(format!("is indexed with numbers or truth values, found {} `{other}`", other.type_name())),
    }
}

/// A number as an index; beyond the last where it is below 0 or none.
fn index(number: f64) -> usize {
    if number >= 0.0 { number as usize } else { usize::MAX }
}
