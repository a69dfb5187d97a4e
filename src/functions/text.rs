//! Texts: parts of them, and where these stand. Places count characters from 0.

use crate::functions::args::{any, number, text_at};
use crate::functions::arrays::{characters, place};
use crate::functions::{Function, Gives};
use crate::pattern::Regex;
use crate::value::{Array, Cells, Value, within_cells, within_text};
use std::sync::Arc;

pub(super) static LIST: &[Function] = &[
    Function::new("len", "(text)", (1, 1), "The number of characters.", |args, _| {
        Ok(Value::Float(text_at(args, 0)?.chars().count() as f64))
    })
    .constant(),
    Function::new("count", "(text, part)", (2, 2), "How often a part occurs in a text.", |args, _| {
        let (text, part) = (text_at(args, 0)?, text_at(args, 1)?);
        Ok(Value::Float(if part.is_empty() { 0.0 } else { text.matches(part).count() as f64 }))
    })
    .constant(),
    Function::new(
        "find",
        "(text, part, n)",
        (3, 3),
        "Where the nth occurrence of a part begins, from 0; -1 where there is none.",
        |args, _| {
            let (text, part, n) = (text_at(args, 0)?, text_at(args, 1)?, number(args, 2)?);
            let found = text.match_indices(part).nth(n.max(0.0) as usize);
            Ok(place(found.map(|(byte, _)| characters(text, byte))))
        },
    )
    .constant(),
    Function::new(
        "substring",
        "(text, from, to)",
        (3, 3),
        "The characters from one place up to another.",
        |args, _| {
            let (text, from, to) = (text_at(args, 0)?, number(args, 1)?, number(args, 2)?);
            let count = (to - from).max(0.0) as usize;
            Ok(Value::text(text.chars().skip(from.max(0.0) as usize).take(count).collect::<String>()))
        },
    )
    .text()
    .constant(),
    Function::new(
        "replace",
        "(text, old, new)",
        (3, 3),
        "The text with every old part replaced by a text or another value.",
        |args, _| {
            let (text, old) = (text_at(args, 0)?, text_at(args, 1)?);
            let Value::Text(new) = Value::written(format_args!("{}", any(args, 2)?))? else { return Ok(args[0].clone()) };
            if old.is_empty() {
                return Ok(args[0].clone());
            }
            within_text(text.len() + text.matches(old).count() * new.len())?;
            Ok(Value::text(text.replace(old, &new)))
        },
    )
    .text()
    .constant(),
    Function::new(
        "getPrefix",
        "(text, part)",
        (2, 2),
        "The text before the first occurrence of a part; empty where there is none.",
        |args, _| {
            let (text, part) = (text_at(args, 0)?, text_at(args, 1)?);
            Ok(Value::text(text.find(part).map_or("", |byte| &text[..byte])))
        },
    )
    .text()
    .constant(),
    Function::new(
        "getSuffix",
        "(text, part)",
        (2, 2),
        "The text after the last occurrence of a part; empty where there is none.",
        |args, _| {
            let (text, part) = (text_at(args, 0)?, text_at(args, 1)?);
            Ok(Value::text(text.rfind(part).map_or("", |byte| &text[byte + part.len()..])))
        },
    )
    .text()
    .constant(),
    Function::new(
        "getRange",
        "(text, left, right)",
        (3, 3),
        "The text after the first occurrence of `left` and before the last of `right`; empty where one is missing or \
         they overlap.",
        |args, _| {
            let (text, left, right) = (text_at(args, 0)?, text_at(args, 1)?, text_at(args, 2)?);
            let from = text.find(left).map(|byte| byte + left.len());
            let range = from.zip(text.rfind(right)).and_then(|(from, to)| text.get(from..to));
            Ok(Value::text(range.unwrap_or_default()))
        },
    )
    .text()
    .constant(),
    Function::new(
        "splitString",
        "(text, delimiter)",
        (2, 2),
        "The parts of a text between delimiters, as an array. `$` begins a regular expression, as in `\"$;|\\n\"`; an empty \
         delimiter splits between all characters.",
        |args, _| {
            let (text, delimiter) = (text_at(args, 0)?, text_at(args, 1)?);
            let parts: Vec<Arc<str>> = match delimiter.strip_prefix('$') {
                Some(expression) => Regex::new(expression)?.split(text).into_iter().map(Into::into).collect(),
                None => text.split(delimiter).map(Into::into).collect(),
            };
            within_cells(parts.len() as f64)?;
            Ok(Value::Array(Array::row(Cells::Texts(parts)).into()))
        },
    )
    .gives(Gives::Texts)
    .constant(),
];
