//! Arguments of functions: each is asked for by its place, and what does not fit is named.

use crate::value::{Array, Value};
use std::sync::Arc;

/// The number at `index`.
pub(super) fn number(args: &[Value], index: usize) -> Result<f64, String> {
    let value = any(args, index)?;
    value.as_float().ok_or_else(|| wrong("a number", value))
}

/// The text at `index`.
pub(super) fn text_at(args: &[Value], index: usize) -> Result<&str, String> {
    let value = any(args, index)?;
    value.as_str().ok_or_else(|| wrong("a text", value))
}

/// The array at `index`.
pub(super) fn array_at(args: &[Value], index: usize) -> Result<&Arc<Array>, String> {
    let value = any(args, index)?;
    value.as_array().ok_or_else(|| wrong("an array", value))
}

/// The word at `index`, which must be one of `words`.
pub(super) fn word_at<'a>(args: &'a [Value], index: usize, words: &[&str]) -> Result<&'a str, String> {
    let word = text_at(args, index)?;
    match words.contains(&word) {
        true => Ok(word),
        false => Err(format!("takes {}, found `{word}`", alternatives(words))),
    }
}

/// The value at `index`.
pub(super) fn any(args: &[Value], index: usize) -> Result<&Value, String> {
    args.get(index).ok_or_else(|| "an argument is missing".into())
}

/// What was wanted and what was found; long values are cut.
pub(super) fn wrong(wanted: &str, found: &Value) -> String {
    format!("takes {wanted}, found {} `{}`", found.type_name(), found.shown())
}

/// `` `a`, `b` or `c` ``.
fn alternatives(words: &[&str]) -> String {
    let quoted: Vec<String> = words.iter().map(|word| format!("`{word}`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} or {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}
