//! Operators that work element by element: on two arrays of the same rows and columns, or on an array and one value.

use crate::value::{Array, Cells, Value};
use std::sync::Arc;

impl Value {
    /// An action on each element; on the value itself where it is no array.
    pub fn each(&self, mut act: impl FnMut(Value) -> Result<Value, String>) -> Result<Value, String> {
        match self {
            Value::Array(array) => array_of(array, |index| act(array.at(index))),
            single => act(single.clone()),
        }
    }

    /// An action on the elements of two values at the same places; a single value stands at every place.
    pub fn paired(
        &self,
        other: &Value,
        mut act: impl FnMut(Value, Value) -> Result<Value, String>,
    ) -> Result<Value, String> {
        match (self, other) {
            (Value::Array(a), Value::Array(b)) if (a.rows(), a.columns()) != (b.rows(), b.columns()) => Err(format!(
                "works element by element on arrays of the same rows and columns, found {} × {} and {} × {}",
                a.rows(),
                a.columns(),
                b.rows(),
                b.columns()
            )),
            (Value::Array(a), Value::Array(b)) => array_of(a, |index| act(a.at(index), b.at(index))),
            (Value::Array(a), single) => array_of(a, |index| act(a.at(index), single.clone())),
            (single, Value::Array(b)) => array_of(b, |index| act(single.clone(), b.at(index))),
            (a, b) => act(a.clone(), b.clone()),
        }
    }
}

/// An array with the rows and columns of another.
fn array_of(like: &Array, act: impl FnMut(usize) -> Result<Value, String>) -> Result<Value, String> {
    let cells = Cells::of((0..like.len()).map(act).collect::<Result<_, _>>()?)?;
    Ok(Value::Array(Arc::new(Array::new(like.columns(), cells).unwrap_or_else(|| like.clone()))))
}
