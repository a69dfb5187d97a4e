//! Lists as texts, `"birch;lime;oak;"`: each item is followed by a semicolon, the last one too. What comes unterminated
//! is read as if it were terminated. Searches take a `*` at the start or end of the word for any letters.
//!
//! Cost: linear in the text, for an item too. A table or an array is the better home for many items.

use crate::functions::args::{array_at, number, text_at};
use crate::functions::arrays::place;
use crate::functions::{Function, Gives};
use crate::value::{Array, Cells, Value, within_text};
use std::sync::Arc;

/// A function that gives a text.
macro_rules! text {
    ($name:literal, $signature:literal, $count:literal, $docs:literal, $f:expr) => {
        Function::new($name, $signature, ($count, $count), $docs, |args, _| {
            let f: fn(&[Value]) -> Result<String, String> = $f;
            Ok(Value::text(f(args)?))
        })
        .text()
        .constant()
    };
}

pub(super) static LIST: &[Function] = &[
    text!("listAdd", "(list, item)", 2, "The list with one more item at its end.", |args| {
        let item = Value::written(format_args!("{}", args[1]))?;
        let list = terminated(text_at(args, 0)?) + &terminated(item.as_str().unwrap_or_default());
        within_text(list.len()).map(|()| list)
    }),
    text!("listClean", "(list)", 1, "The list, terminated and without empty items.", |args| {
        Ok(listed(items(text_at(args, 0)?).filter(|item| !item.is_empty())))
    }),
    text!("listTerminate", "(list)", 1, "The list with a semicolon at its end.", |args| {
        Ok(terminated(text_at(args, 0)?))
    }),
    text!("listFirst", "(list)", 1, "The first item; empty where there is none.", |args| {
        Ok(items(text_at(args, 0)?).next().unwrap_or_default().into())
    }),
    text!("listLast", "(list)", 1, "The last item; empty where there is none.", |args| {
        Ok(items(text_at(args, 0)?).last().unwrap_or_default().into())
    }),
    text!("listItem", "(list, index)", 2, "The item at an index, from 0; empty where there is none.", |args| {
        let index = number(args, 1)?.floor();
        let item = if index >= 0.0 { items(text_at(args, 0)?).nth(index as usize) } else { None };
        Ok(item.unwrap_or_default().into())
    }),
    text!("listRange", "(list, from, to)", 3, "The items from one index up to another, which is left out.", |args| {
        let [from, to] = [number(args, 1)?, number(args, 2)?].map(|n| n.max(0.0).floor() as usize);
        Ok(listed(items(text_at(args, 0)?).skip(from).take(to.saturating_sub(from))))
    }),
    text!("listRemove", "(list, item)", 2, "The list without the first such item.", |args| {
        let (list, wanted) = (text_at(args, 0)?, text_at(args, 1)?);
        let first = items(list).position(|item| fits(item, wanted));
        Ok(listed(items(list).enumerate().filter(|(i, _)| Some(*i) != first).map(|(_, item)| item)))
    }),
    text!("listRemoveAll", "(list, item)", 2, "The list without any such item.", |args| {
        let wanted = text_at(args, 1)?;
        Ok(listed(items(text_at(args, 0)?).filter(|item| !fits(item, wanted))))
    }),
    text!("listRetainAll", "(list, item)", 2, "Of the list only such items.", |args| {
        let wanted = text_at(args, 1)?;
        Ok(listed(items(text_at(args, 0)?).filter(|item| fits(item, wanted))))
    }),
    text!("listFromArray", "(array)", 1, "The values of an array as a list, row by row.", |args| {
        let array = array_at(args, 0)?;
        let mut list = String::new();
        for index in 0..array.len() {
            list.push_str(&format!("{};", array.at(index)));
            within_text(list.len())?;
        }
        Ok(list)
    }),
    Function::new(
        "listIndex",
        "(list, item)",
        (2, 2),
        "The index of the first such item, from 0; -1 where there is none.",
        |args, _| {
            let wanted = text_at(args, 1)?;
            Ok(place(items(text_at(args, 0)?).position(|item| fits(item, wanted))))
        },
    )
    .constant(),
    Function::new("listCount", "(list, item)", (2, 2), "How many such items there are.", |args, _| {
        let wanted = text_at(args, 1)?;
        Ok(Value::Float(items(text_at(args, 0)?).filter(|item| fits(item, wanted)).count() as f64))
    })
    .constant(),
    Function::new("listSize", "(list)", (1, 1), "How many items a list has.", |args, _| {
        Ok(Value::Float(items(text_at(args, 0)?).count() as f64))
    })
    .constant(),
    Function::new("listToArray", "(list)", (1, 1), "The items of a list as an array.", |args, _| {
        let texts: Vec<Arc<str>> = items(text_at(args, 0)?).map(Into::into).collect();
        Ok(Value::Array(Array::row(Cells::Texts(texts)).into()))
    })
    .gives(Gives::Texts)
    .constant(),
    Function::new(
        "listRandom",
        "(list)",
        (1, 1),
        "Any item of the list, from the shape's own numbers; empty where there is none.",
        |args, around| {
            let list = text_at(args, 0)?;
            let index = around.random.below(items(list).count() as u64);
            Ok(Value::text(items(list).nth(index as usize).unwrap_or_default()))
        },
    )
    .text(),
];

/// The items of a list.
pub(super) fn items(list: &str) -> impl Iterator<Item = &str> {
    let inner = list.strip_suffix(';').unwrap_or(list);
    inner.split(';').take(if list.is_empty() { 0 } else { usize::MAX })
}

/// Items as a list.
pub(super) fn listed<'a>(items: impl Iterator<Item = &'a str>) -> String {
    items.fold(String::new(), |list, item| list + item + ";")
}

fn terminated(list: &str) -> String {
    if list.is_empty() || list.ends_with(';') { list.into() } else { format!("{list};") }
}

/// Whether an item is the wanted one; a `*` at the start or end of the word stands for any letters.
fn fits(item: &str, wanted: &str) -> bool {
    match (wanted.strip_prefix('*'), wanted.strip_suffix('*')) {
        (Some(rest), Some(_)) => rest.strip_suffix('*').is_none_or(|inner| item.contains(inner)),
        (Some(end), None) => item.ends_with(end),
        (None, Some(start)) => item.starts_with(start),
        (None, None) => item == wanted,
    }
}
