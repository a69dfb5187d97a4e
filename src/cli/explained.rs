//! Explanations as text: what there is from top to bottom, and for each the way from the start rule down.

use bosquet::text::{counted, number};
use bosquet::trace::{Explanation, Happened, Step};
use std::fmt::Write;

/// All of them; behind each where it stands, in the layout's own coordinates.
pub fn text(all: &[(&Explanation, Option<[f64; 2]>)]) -> String {
    let mut out = String::new();
    if all.len() > 1 {
        let _ = writeln!(out, "{}, from top to bottom:", counted(all.len(), "thing"));
        all.iter().for_each(|(thing, _)| _ = writeln!(out, "  {}", title(thing)));
        out.push('\n');
    }
    let texts: Vec<String> = all.iter().map(|(thing, place)| one(thing, *place)).collect();
    out + &texts.join("\n")
}

fn title(thing: &Explanation) -> String {
    format!("{} {}: {}", thing.class, thing.id, thing.what)
}

fn one(thing: &Explanation, place: Option<[f64; 2]>) -> String {
    let mut out = title(thing) + "\n";
    if let Some([x, y]) = place {
        // Nine places of a degree, or of a metre, are finer than anything that was placed.
        let _ = writeln!(out, "  at {}, {}", number(x, 7), number(y, 7));
    }
    if let Some(reserved) = thing.reserved {
        let _ = writeln!(out, "  keeps {} m clear of others", number(reserved, 2));
    }
    for near in &thing.near {
        let [distance, reserved] = [near.distance, near.reserved].map(|n| number(n, 2));
        let _ = writeln!(out, "  {distance} m away: {}, keeps {reserved} m ({})", near.species, near.id);
    }
    if thing.lot.is_empty() {
        return out + "  it was read from the layout: no rule made it\n";
    }
    let attributes: Vec<String> = thing.attributes.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let attributes = if attributes.is_empty() { String::new() } else { format!(": {}", attributes.join(", ")) };
    let _ = writeln!(out, "  lot {}, seed {}{attributes}", thing.lot, thing.seed);
    thing.steps.iter().for_each(|step| self::step(&mut out, step));
    out
}

fn step(out: &mut String, step: &Step) {
    let args: Vec<String> = step.arguments.iter().map(|(name, value)| format!("{name} = {value}")).collect();
    let args = if args.is_empty() { String::new() } else { format!("({})", args.join(", ")) };
    let _ = writeln!(out, "\n  {}{args}", step.rule);
    if !step.place.is_empty() {
        let _ = writeln!(out, "    {}: {}", step.place, step.source);
    }
    let _ = writeln!(out, "    {}", step.shape);
    step.set.iter().for_each(|(name, value)| _ = writeln!(out, "    {name} = {value}"));
    let mut shown = step.place.as_str();
    for happened in &step.did {
        self::happened(out, happened, &mut shown);
    }
}

/// One deed; its line where that is not the one shown last.
fn happened<'a>(out: &mut String, happened: &'a Happened, shown: &mut &'a str) {
    if happened.place != *shown && !happened.place.is_empty() {
        let _ = writeln!(out, "    {}: {}", happened.place, happened.source);
        *shown = &happened.place;
    }
    let _ = writeln!(out, "      {}", happened.what);
}
