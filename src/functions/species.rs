//! What the catalogue knows of a species at an age: so that spacing follows the plant, as ordinances have it.

use crate::element::{Catalogue, Entry, NotFound, Words};
use crate::functions::args::{number, text_at};
use crate::functions::{Function, Surroundings};
use crate::plant::{Sizes, sizes};
use crate::text::suggestion;
use crate::value::Value;

macro_rules! size {
    ($name:literal, $docs:literal, $f:expr) => {
        Function::new($name, "(name, age)", (2, 2), $docs, |args, around| {
            let f: fn(Sizes) -> f64 = $f;
            Ok(Value::Float(f(sizes_of(args, around)?)))
        })
        .added()
    };
}

pub(super) static LIST: &[Function] = &[
    size!("species.crown", "The radius of a species' crown at an age in years, metres.", |s| s.crown_diameter * 0.5),
    size!("species.height", "The height of a species at an age in years, metres.", |s| s.height),
    size!("species.dbh", "The trunk's diameter at breast height of a species at an age in years, metres.", |s| s.dbh),
    Function::new(
        "species.kind",
        "(name)",
        (1, 1),
        "What a species is: `tree`, `shrub`, `hedge` or `flower`.",
        |args, around| Ok(Value::text(plant(around.catalogue, text_at(args, 0)?)?.kind.word())),
    )
    .text()
    .added(),
];

fn sizes_of(args: &[Value], around: &Surroundings) -> Result<Sizes, String> {
    let entry = plant(around.catalogue, text_at(args, 0)?)?;
    let age = number(args, 1)?;
    if !(age.is_finite() && age >= 0.0) {
        return Err(format!("takes an age of 0 years or more, found `{}`", args[1]));
    }
    sizes(entry, age).map_err(|error| format!("cannot tell: {error}"))
}

fn plant<'a>(catalogue: &'a Catalogue, name: &str) -> Result<&'a Entry, String> {
    let found = catalogue.find(name, "").map_err(unknown)?;
    match found.entry.kind.is_plant() {
        true => Ok(found.entry),
        false => Err(format!("takes a plant, and `{name}` is none")),
    }
}

fn unknown(error: NotFound) -> String {
    format!("finds no plant: {error}{}", suggestion(error.suggestion()))
}
