//! The values of the language: what attributes hold, functions return and layout properties become.

mod array;
mod build;
mod each;
mod long;
mod order;
mod pick;

pub use array::{Array, Cells};
pub use build::{MOST_CELLS, within_cells};
pub use long::{MOST_TEXT, within_text};
pub use order::order_of_numbers;

use std::fmt;
use std::sync::Arc;

/// A value of the language (CGA has one numeric type).
#[derive(Clone, Debug, PartialEq)]
pub enum Value {
    /// A number.
    Float(f64),
    /// A truth value.
    Bool(bool),
    /// A text.
    Text(Arc<str>),
    /// A bare word that stands for itself: `front`, `birch`, `x`.
    Word(Arc<str>),
    /// A number relative to the scope (`'0.3`) or floating (`~3`, the papers' `1r`).
    Size(Size),
    /// Several values of one type, in rows and columns.
    Array(Arc<Array>),
}

/// A length of a split or a transformation, before the scope is known.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Size {
    /// In metres.
    Absolute(f64),
    /// A share of the scope's size.
    Relative(f64),
    /// A weight in what is left over.
    Floating(f64),
}

impl Value {
    /// A text value.
    pub fn text(text: impl Into<Arc<str>>) -> Value {
        Value::Text(text.into())
    }

    /// The word for its type, as messages say it.
    pub fn type_name(&self) -> &'static str {
        match self {
            Value::Float(_) => "a number",
            Value::Bool(_) => "a truth value",
            Value::Text(_) => "a text",
            Value::Word(_) => "a word",
            Value::Size(Size::Absolute(_)) => "a number",
            Value::Size(Size::Relative(_)) => "a relative size",
            Value::Size(Size::Floating(_)) => "a floating size",
            Value::Array(array) => array.type_name(),
        }
    }

    /// The number, if it is one.
    pub fn as_float(&self) -> Option<f64> {
        match self {
            Value::Float(number) | Value::Size(Size::Absolute(number)) => Some(*number),
            _ => None,
        }
    }

    /// The text or word, if it is one.
    pub fn as_str(&self) -> Option<&str> {
        match self {
            Value::Text(text) | Value::Word(text) => Some(text),
            _ => None,
        }
    }

    /// The array, if it is one.
    pub fn as_array(&self) -> Option<&Arc<Array>> {
        match self {
            Value::Array(array) => Some(array),
            _ => None,
        }
    }

    /// The truth value, if it is one.
    pub fn as_bool(&self) -> Option<bool> {
        match self {
            Value::Bool(truth) => Some(*truth),
            _ => None,
        }
    }
}

/// As `str()` and string concatenation write it: six significant places at most, no trailing zeros.
impl fmt::Display for Value {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Value::Float(number) => f.write_str(&crate::text::number(*number, 6)),
            Value::Bool(truth) => write!(f, "{truth}"),
            Value::Text(text) | Value::Word(text) => f.write_str(text),
            Value::Size(Size::Absolute(number)) => f.write_str(&crate::text::number(*number, 6)),
            Value::Size(Size::Relative(number)) => write!(f, "'{}", crate::text::number(*number, 6)),
            Value::Size(Size::Floating(number)) => write!(f, "~{}", crate::text::number(*number, 6)),
            Value::Array(array) => write!(f, "{array}"),
        }
    }
}
