//! The order of values of one kind: numbers, texts, and arrays row by row. What is not a number comes last.

use crate::value::{Array, Cells, Value};
use std::cmp::Ordering;

/// How two values of one kind stand to each other; none for truth values and for values of two kinds.
pub(super) fn order(a: &Value, b: &Value) -> Option<Ordering> {
    match (a, b) {
        (Value::Array(a), Value::Array(b)) => arrays(a, b),
        _ => match (a.as_float().zip(b.as_float()), a.as_str().zip(b.as_str())) {
            (Some((a, b)), _) => Some(numbers(a, b)),
            (_, Some((a, b))) => Some(a.cmp(b)),
            _ => None,
        },
    }
}

/// Numbers by size, and what is not a number after all others; the two zeros are the same.
pub(super) fn numbers(a: f64, b: f64) -> Ordering {
    a.partial_cmp(&b).unwrap_or_else(|| a.is_nan().cmp(&b.is_nan()))
}

/// The first cell that differs decides; then the array of fewer columns is the lesser, then that of fewer rows.
fn arrays(a: &Array, b: &Array) -> Option<Ordering> {
    let rows = a.rows().min(b.rows());
    for row in 0..rows {
        let found = self::rows(a, row, b, row)?;
        if found != Ordering::Equal {
            return Some(found);
        }
    }
    kin(a, b).then(|| a.rows().cmp(&b.rows()))
}

/// Two rows, which may be of different lengths; none where the arrays cannot be ordered.
pub(super) fn rows(a: &Array, row_a: usize, b: &Array, row_b: usize) -> Option<Ordering> {
    let range = |array: &Array, row: usize| row * array.columns()..(row + 1) * array.columns();
    let (in_a, in_b) = (range(a, row_a), range(b, row_b));
    match (a.cells(), b.cells()) {
        (Cells::Numbers(a), Cells::Numbers(b)) => Some(slices(&a[in_a], &b[in_b], |a, b| numbers(*a, *b))),
        (Cells::Texts(a), Cells::Texts(b)) => Some(slices(&a[in_a], &b[in_b], Ord::cmp)),
        _ => None,
    }
}

fn slices<T>(a: &[T], b: &[T], order: impl Fn(&T, &T) -> Ordering) -> Ordering {
    let mut pairs = a.iter().zip(b).map(|(a, b)| order(a, b));
    pairs.find(|order| *order != Ordering::Equal).unwrap_or_else(|| a.len().cmp(&b.len()))
}

fn kin(a: &Array, b: &Array) -> bool {
    matches!((a.cells(), b.cells()), (Cells::Numbers(_), Cells::Numbers(_)) | (Cells::Texts(_), Cells::Texts(_)))
}
