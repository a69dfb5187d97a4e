//! Texts and conversions.

use crate::functions::{Function, number, text_at};
use crate::value::Value;

pub(super) static LIST: &[Function] = &[
    Function::new("str", "(value)", (1, 1), "Any value as a text.", |args, _| Ok(Value::text(args[0].to_string())))
        .text()
        .constant(),
    Function::new(
        "float",
        "(text)",
        (1, 1),
        "A text, truth value or number as a number; 0 where it is none.",
        |args, _| {
            Ok(Value::Float(match &args[0] {
                Value::Bool(truth) => f64::from(u8::from(*truth)),
                Value::Text(text) | Value::Word(text) => text.trim().parse().unwrap_or(0.0),
                value => value.as_float().unwrap_or(0.0),
            }))
        },
    )
    .constant(),
    Function::new("bool", "(value)", (1, 1), "Whether a number is not 0, or a text says `true`.", |args, _| {
        Ok(Value::Bool(match &args[0] {
            Value::Bool(truth) => *truth,
            Value::Text(text) | Value::Word(text) => text.trim().eq_ignore_ascii_case("true"),
            value => value.as_float().is_some_and(|n| n != 0.0),
        }))
    })
    .truth()
    .constant(),
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
            Ok(Value::Float(found.map_or(-1.0, |(byte, _)| text[..byte].chars().count() as f64)))
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
    Function::new("replace", "(text, old, new)", (3, 3), "The text with every old part replaced.", |args, _| {
        Ok(Value::text(text_at(args, 0)?.replace(text_at(args, 1)?, text_at(args, 2)?)))
    })
    .text()
    .constant(),
];
