//! Values, deeds of rules and things of a scene in words.

use crate::shape::Deed;
use crate::text::number;
use crate::trace::Thing;
use crate::value::Value;

/// What a rule did, in words.
pub(super) fn deed(deed: &Deed) -> String {
    match deed {
        Deed::Applied(operation, args) => {
            let args: Vec<String> = args.iter().map(|(name, value)| format!("{name} = {}", plain(value))).collect();
            format!("`{operation}({})`", args.join(", "))
        }
        Deed::Took { entry, index, total } if entry.is_empty() => format!("piece {} of {total}", index + 1),
        Deed::Took { entry, index, total } => format!("piece {} of {total}: `{entry}`", index + 1),
        Deed::Chose { condition, failed, reads } => chose(condition.as_deref(), failed, reads),
        Deed::Drew { number: drawn, part: (from, to), of } => {
            let [drawn, from, to, of] = [drawn, from, to, of].map(|n| number(*n, 3));
            format!("drew {drawn} of {of}: the part from {from} to {to}")
        }
    }
}

fn chose(condition: Option<&str>, failed: &[String], reads: &[(String, Value)]) -> String {
    let failed: Vec<String> = failed.iter().map(|words| format!("`{words}`")).collect();
    let failed = failed.join(", ");
    let choice = match condition {
        Some(condition) if failed.is_empty() => format!("`{condition}` holds"),
        Some(condition) => format!("`{condition}` holds, and not {failed}"),
        None => format!("`else`, as {failed} does not hold"),
    };
    let reads: Vec<String> = reads.iter().map(|(name, value)| format!("{name} = {}", plain(value))).collect();
    if reads.is_empty() { choice } else { format!("{choice}, with {}", reads.join(", ")) }
}

/// A thing in one line.
pub(super) fn thing_words(thing: Thing) -> String {
    match thing {
        Thing::Plant(plant) => {
            let latin = if plant.species.is_empty() { String::new() } else { format!(" ({})", plant.species) };
            let age = if plant.age > 0.0 { format!(", {} years", number(plant.age, 1)) } else { String::new() };
            let [height, crown] = [plant.height, plant.crown_radius].map(|n| number(n, 2));
            let (name, class) = (&plant.category, &plant.age_class);
            format!("{name}{latin}, {class}{age}, {height} m high, crown radius {crown} m")
        }
        Thing::Object(object) => {
            let [x, y, z] = object.size.map(|n| number(n, 2));
            format!("{}, {x} × {y} × {z} m", object.label)
        }
        Thing::Solid(solid) => {
            let (area, height) = (number(solid.footprint.area(), 1), number(solid.height, 2));
            format!("{}, {height} m high over {area} m²", solid.material.label)
        }
        Thing::Line(line) => line.material.label.to_string(),
        Thing::Cover(cover) => format!("{}, {} m²", cover.material.label, number(cover.area.area(), 1)),
    }
}

/// A value, texts in quotes, numbers rounded as shapes are.
pub(super) fn plain(value: &Value) -> String {
    match value {
        Value::Text(text) => format!("{text:?}"),
        Value::Float(value) => number(*value, 3),
        other => other.to_string(),
    }
}
