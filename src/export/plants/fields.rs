//! The record of a plant: its fields, in the order of every export. Declared here once; the writers and the reader
//! go by this list.

use crate::element::{Words, color_text, parse_color};
use crate::scene::{Plant, PlantSymbol};
use std::sync::Arc;

/// One field of the record; the position is not among them, as each format has its own way for it.
pub struct Field {
    /// Its name in every format.
    pub name: &'static str,
    /// What it says, with its unit.
    pub doc: &'static str,
    lens: Lens,
}

/// How a field's value sits in a plant.
enum Lens {
    Text(fn(&Plant) -> &Arc<str>, fn(&mut Plant) -> &mut Arc<str>),
    Number(fn(&Plant) -> &f64, fn(&mut Plant) -> &mut f64),
    Count(fn(&Plant) -> &u32, fn(&mut Plant) -> &mut u32),
    Flag(fn(&Plant) -> &bool, fn(&mut Plant) -> &mut bool),
    Bits(fn(&Plant) -> &u64, fn(&mut Plant) -> &mut u64),
    Symbol(fn(&Plant) -> &PlantSymbol, fn(&mut Plant) -> &mut PlantSymbol),
    Color(fn(&Plant) -> &[f32; 4], fn(&mut Plant) -> &mut [f32; 4]),
}

/// A value on its way into a file.
pub(super) enum Cell {
    Text(String),
    Plain(String),
    Missing,
}

macro_rules! fields {
    ($($name:literal $kind:ident $($part:ident).+ : $doc:literal),+ $(,)?) => {
        /// Every field of the record of a plant, in order.
        pub const FIELDS: &[Field] = &[
            $(Field { name: $name, doc: $doc, lens: Lens::$kind(|p| &p.$($part).+, |p| &mut p.$($part).+) }),+
        ];
    };
}

fields! {
    "id" Text origin.id: "stable id",
    "elevation" Number elevation: "height of its foot above the datum, metres",
    "heading" Number heading: "how it is turned, degrees counter-clockwise from east",
    "kind" Text kind: "habit: tree, shrub, hedge, flower",
    "category" Text category: "the catalogue's category",
    "type" Text age_class: "age class, or clipped form",
    "species" Text species: "Latin name",
    "common_name" Text common_name: "common name",
    "code" Text code: "code on plans",
    "spacing_radius" Number spacing_radius: "radius kept clear of other plants, metres",
    "crown_radius" Number crown_radius: "radius of the crown, metres",
    "age" Number age: "years",
    "height" Number height: "metres",
    "trunk_diameter" Number trunk_diameter: "at breast height, metres",
    "crown_height" Number crown_height: "from the lowest leaves to the top, metres; 0 where unknown",
    "leaf_area" Number leaf_area: "one side of all leaves, square metres; 0 where unknown",
    "pruning" Number pruning: "what pruning left of the crown's volume, 0 to 1",
    "measured" Flag measured: "its sizes follow curves fitted to measured trees",
    "seed" Bits seed: "seed of its shape, hexadecimal",
    "managed" Flag managed: "planted and cared for, not wild",
    "existing" Flag existing: "stood there before",
    "lot" Text origin.lot: "id of its lot",
    "rule" Text origin.rule: "the rule that planted it",
    "appearance" Count appearance: "which appearance of its type",
    "symbol" Symbol symbol: "how plans draw it",
    "color" Color color: "crown colour",
}

impl Field {
    /// The plant's value of this field.
    pub(super) fn get(&self, plant: &Plant) -> Cell {
        match &self.lens {
            Lens::Text(get, _) => Cell::Text(get(plant).to_string()),
            Lens::Number(get, _) if get(plant).is_finite() => Cell::Plain(get(plant).to_string()),
            Lens::Number(..) => Cell::Missing,
            Lens::Count(get, _) => Cell::Plain(get(plant).to_string()),
            Lens::Flag(get, _) => Cell::Plain(get(plant).to_string()),
            Lens::Bits(get, _) => Cell::Text(format!("{:016x}", get(plant))),
            Lens::Symbol(get, _) => Cell::Text(get(plant).word().to_owned()),
            Lens::Color(get, _) => Cell::Text(color_text(*get(plant))),
        }
    }

    /// Puts a value as written in a file into the plant; `false` where it cannot be one.
    pub(super) fn set(&self, plant: &mut Plant, written: &str) -> bool {
        match &self.lens {
            Lens::Text(_, slot) => put(slot(plant), Some(written.into())),
            Lens::Number(_, slot) => put(slot(plant), written.trim().parse().ok().filter(|n: &f64| n.is_finite())),
            Lens::Count(_, slot) => put(slot(plant), written.trim().parse().ok()),
            Lens::Flag(_, slot) => put(slot(plant), truth(written)),
            Lens::Bits(_, slot) => put(slot(plant), u64::from_str_radix(written.trim(), 16).ok()),
            Lens::Symbol(_, slot) => put(slot(plant), PlantSymbol::from_word(written.trim())),
            Lens::Color(_, slot) => put(slot(plant), parse_color(written.trim())),
        }
    }

    /// What its values look like, for messages.
    pub(super) fn wanted(&self) -> &'static str {
        match &self.lens {
            Lens::Text(..) => "a text",
            Lens::Number(..) => "a number",
            Lens::Count(..) => "a whole number",
            Lens::Flag(..) => "`true` or `false`",
            Lens::Bits(..) => "up to 16 hexadecimal digits",
            Lens::Symbol(..) => "a plan symbol like `broadleaf`",
            Lens::Color(..) => "a colour like `#9bb86b`",
        }
    }

    /// Whether an empty cell is a value of it, and not a missing one.
    pub(super) fn may_be_empty(&self) -> bool {
        matches!(self.lens, Lens::Text(..))
    }
}

fn put<T>(slot: &mut T, value: Option<T>) -> bool {
    let fits = value.is_some();
    if let Some(value) = value {
        *slot = value;
    }
    fits
}

/// Spreadsheets write `TRUE`, GIS programs `1`.
fn truth(written: &str) -> Option<bool> {
    match written.trim().to_ascii_lowercase().as_str() {
        "true" | "1" => Some(true),
        "false" | "0" => Some(false),
        _ => None,
    }
}
