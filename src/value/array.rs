//! Arrays: one or two dimensions of numbers, truth values or texts (CGA's `float[]`, `bool[]`, `string[]`).

use crate::value::Value;
use std::fmt;
use std::sync::Arc;

/// Rows and columns of one type; a row of values is an array with one row.
#[derive(Clone, Debug, PartialEq)]
pub struct Array {
    columns: usize,
    cells: Cells,
}

/// The values of an array, row by row.
#[derive(Clone, Debug, PartialEq)]
pub enum Cells {
    /// Numbers.
    Numbers(Vec<f64>),
    /// Truth values.
    Truths(Vec<bool>),
    /// Texts.
    Texts(Vec<Arc<str>>),
}

impl Array {
    /// One row.
    pub fn row(cells: Cells) -> Array {
        Array { columns: cells.len(), cells }
    }

    /// Rows of so many columns each; `None` where the cells do not fill them.
    pub fn new(columns: usize, cells: Cells) -> Option<Array> {
        let fills = if columns == 0 { cells.is_empty() } else { cells.len().is_multiple_of(columns) };
        fills.then_some(Array { columns, cells })
    }

    /// How many values.
    pub fn len(&self) -> usize {
        self.cells.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// How many columns.
    pub fn columns(&self) -> usize {
        self.columns
    }

    /// How many rows.
    pub fn rows(&self) -> usize {
        self.len().checked_div(self.columns).unwrap_or(0)
    }

    /// The values, row by row.
    pub fn cells(&self) -> &Cells {
        &self.cells
    }

    /// The value at a place, counted row by row; 0, `false` or an empty text beyond the last, as CityEngine has it.
    pub fn at(&self, index: usize) -> Value {
        match &self.cells {
            Cells::Numbers(numbers) => Value::Float(numbers.get(index).copied().unwrap_or(0.0)),
            Cells::Truths(truths) => Value::Bool(truths.get(index).copied().unwrap_or(false)),
            Cells::Texts(texts) => Value::Text(texts.get(index).cloned().unwrap_or_else(|| "".into())),
        }
    }

    /// The value in a row and column; as [`Array::at`] outside.
    pub fn cell(&self, row: usize, column: usize) -> Value {
        let inside = column < self.columns && row < self.rows();
        self.at(if inside { row * self.columns + column } else { usize::MAX })
    }

    /// The word for its type, as messages say it.
    pub fn type_name(&self) -> &'static str {
        match self.cells {
            Cells::Numbers(_) => "an array of numbers",
            Cells::Truths(_) => "an array of truth values",
            Cells::Texts(_) => "an array of texts",
        }
    }
}

impl Cells {
    /// How many values.
    pub fn len(&self) -> usize {
        match self {
            Cells::Numbers(numbers) => numbers.len(),
            Cells::Truths(truths) => truths.len(),
            Cells::Texts(texts) => texts.len(),
        }
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }
}

/// As `print` and `str()` write it: `[1, 2; 3, 4]`.
impl fmt::Display for Array {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("[")?;
        for index in 0..self.len() {
            let sign = if index == 0 {
                ""
            } else if index % self.columns == 0 {
                "; "
            } else {
                ", "
            };
            write!(f, "{sign}{}", self.at(index))?;
        }
        f.write_str("]")
    }
}
