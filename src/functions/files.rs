//! Files: whether they are there, which there are, what is in them, and the parts of their names.

use crate::functions::args::text_at;
use crate::functions::lists::listed;
use crate::functions::{Function, Gives};
use crate::value::{Array, Cells, Value};

/// A part of a path.
macro_rules! part {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(path)", (1, 1), $docs, |args, _| {
            let f: fn(&str) -> &str = $f;
            Ok(Value::text(f(text_at(args, 0)?)))
        })
        .text()
        .constant()
    };
}

pub(super) static LIST: &[Function] = &[
    part!("fileName", "The name of a file, without its folder.", name),
    part!("fileBasename", "The name of a file, without its folder and ending.", |path| {
        name(path).rsplit_once('.').map_or(name(path), |(base, _)| base)
    }),
    part!("fileExtension", "The ending of a file, without the dot; empty where it has none.", |path| {
        name(path).rsplit_once('.').map_or("", |(_, ending)| ending)
    }),
    part!("fileDirectory", "The folder of a file with its slash; empty where it has none.", |path| {
        &path[..path.len() - name(path).len()]
    }),
    Function::new("fileExists", "(path)", (1, 1), "Whether there is such a file that may be read.", |args, around| {
        Ok(Value::Bool(around.files.exists(around.source, text_at(args, 0)?)))
    })
    .truth(),
    Function::new(
        "fileSearch",
        "(query)",
        (1, 1),
        "The files that a query means, as a list in the order of their names. Queries are as in `filesSearch`.",
        |args, around| {
            let found = around.files.search(around.source, text_at(args, 0)?).map_err(|error| format!("fails: {error}"))?;
            Ok(Value::text(listed(found.iter().map(|path| &**path))))
        },
    )
    .text(),
    Function::new(
        "filesSearch",
        "(query)",
        (1, 1),
        "The files that a query means, in the order of their names: `\"trees/*.png\"` with `*` and `?`, `\"$tree_[0-9]+.*\"` \
         as a regular expression, `\"Ext=png\"`, `\"Name=oak.png\"`. What spaces part must hold together; quotes `'…'` keep \
         a space. Empty where nothing is found.",
        |args, around| {
            let found = around.files.search(around.source, text_at(args, 0)?).map_err(|error| format!("fails: {error}"))?;
            Ok(Value::Array(Array::row(Cells::Texts(found.to_vec())).into()))
        },
    )
    .gives(Gives::Texts),
    Function::new(
        "fileRandom",
        "(query)",
        (1, 1),
        "Any of the files that a query means, from the shape's own numbers; empty where there is none.",
        |args, around| {
            let found = around.files.search(around.source, text_at(args, 0)?).map_err(|error| format!("fails: {error}"))?;
            let index = around.random.below(found.len() as u64) as usize;
            Ok(found.get(index).map_or_else(|| Value::text(""), |path| Value::Text(path.clone())))
        },
    )
    .text(),
    Function::new(
        "readTextFile",
        "(path)",
        (1, 1),
        "The text of a file, its line ends as `\\n`. Each file is read once in a run.",
        |args, around| {
            let text = around.files.text(around.source, text_at(args, 0)?);
            text.map(Value::Text).map_err(|error| format!("has nothing to read: {error}"))
        },
    )
    .text(),
    Function::new(
        "readStringTable",
        "(path)",
        (1, 1),
        "The cells of a table of comma-separated values; `;`, tabs and spaces part cells too. Each file is read once in a \
         run. Rows that are too short are filled up.",
        |args, around| {
            let table = around.files.strings(around.source, text_at(args, 0)?);
            table.map(Value::Array).map_err(|error| format!("has nothing to read: {error}"))
        },
    )
    .gives(Gives::Texts),
    Function::new(
        "readFloatTable",
        "(path)",
        (1, 1),
        "As `readStringTable`, with every cell as a number; not a number where a cell does not begin with one.",
        |args, around| {
            let table = around.files.numbers(around.source, text_at(args, 0)?);
            table.map(Value::Array).map_err(|error| format!("has nothing to read: {error}"))
        },
    )
    .gives(Gives::Numbers),
];

fn name(path: &str) -> &str {
    path.rsplit(['/', '\\']).next().unwrap_or(path)
}
