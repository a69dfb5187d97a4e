//! The order of values of one kind: numbers, texts, and arrays row by row. What is not a number comes last.

use crate::value::{Array, Cells, Value};
use std::cmp::Ordering;

impl Value {
    /// How it stands to another of its kind; none for truth values and for values of two kinds.
    pub fn order(&self, other: &Value) -> Option<Ordering> {
        match (self, other) {
            (Value::Array(a), Value::Array(b)) => a.order(b),
            _ => match (self.as_float().zip(other.as_float()), self.as_str().zip(other.as_str())) {
                (Some((a, b)), _) => Some(order_of_numbers(a, b)),
                (_, Some((a, b))) => Some(a.cmp(b)),
                _ => None,
            },
        }
    }
}

impl Array {
    /// Which of two comes first: the first value that differs decides, row by row; then the array of fewer columns is
    /// the lesser, then that of fewer rows. None for truth values and different types. Linear.
    pub fn order(&self, other: &Array) -> Option<Ordering> {
        for row in 0..self.rows().min(other.rows()) {
            let found = self.order_of_rows(row, other, row)?;
            if found != Ordering::Equal {
                return Some(found);
            }
        }
        is_kin(self, other).then(|| self.columns().cmp(&other.columns()).then(self.rows().cmp(&other.rows())))
    }

    /// How a row of it, which is there, stands to one of another array, which may be of another length; none where the
    /// arrays cannot be ordered.
    pub fn order_of_rows(&self, row: usize, other: &Array, other_row: usize) -> Option<Ordering> {
        let range = |array: &Array, row: usize| row * array.columns()..(row + 1) * array.columns();
        let (own, others) = (range(self, row), range(other, other_row));
        match (self.cells(), other.cells()) {
            (Cells::Numbers(a), Cells::Numbers(b)) => {
                Some(slices(&a[own], &b[others], |a, b| order_of_numbers(*a, *b)))
            }
            (Cells::Texts(a), Cells::Texts(b)) => Some(slices(&a[own], &b[others], Ord::cmp)),
            _ => None,
        }
    }
}

/// Numbers by size, and what is not a number after all others; the two zeros are the same.
pub fn order_of_numbers(a: f64, b: f64) -> Ordering {
    a.partial_cmp(&b).unwrap_or_else(|| a.is_nan().cmp(&b.is_nan()))
}

fn slices<T>(a: &[T], b: &[T], order: impl Fn(&T, &T) -> Ordering) -> Ordering {
    let mut pairs = a.iter().zip(b).map(|(a, b)| order(a, b));
    pairs.find(|order| *order != Ordering::Equal).unwrap_or_else(|| a.len().cmp(&b.len()))
}

fn is_kin(a: &Array, b: &Array) -> bool {
    matches!((a.cells(), b.cells()), (Cells::Numbers(_), Cells::Numbers(_)) | (Cells::Texts(_), Cells::Texts(_)))
}
