//! Differences as text: the plants of each lot, then areas, counts and totals.

use bosquet::diff::{Difference, LotDifference, Pair, Pairs, Stand};
use bosquet::text::{counted, number};
use serde_json::{Value, json};
use std::fmt::Write;

/// Plants of a lot that are named; further ones are counted.
const MOST: usize = 10;

/// All of it.
pub fn text(difference: &Difference) -> String {
    if difference.is_empty() {
        return "no differences\n".into();
    }
    let mut out = String::new();
    difference.lots.iter().for_each(|(lot, plants)| self::lot(&mut out, lot, plants));
    for (lot, grounds) in &difference.grounds {
        let whose = if lot.is_empty() { String::new() } else { format!(" of lot {lot}") };
        figures(&mut out, &format!("grounds{whose}, m²"), grounds);
    }
    figures(&mut out, "species", &difference.species);
    figures(&mut out, "symbols", &difference.symbols);
    figures(&mut out, "reports", &difference.reports);
    figures(&mut out, "totals", &difference.totals);
    out
}

/// The same for machines.
pub fn record(difference: &Difference) -> Value {
    let mut record = json!(difference);
    record["equal"] = json!(difference.is_empty());
    record
}

fn lot(out: &mut String, name: &str, lot: &LotDifference) {
    let name = if name.is_empty() { "without a lot".into() } else { format!("lot {name}") };
    let moved = lot.changed.iter().filter(|change| change.moved > 0.0).count();
    let altered = lot.changed.iter().filter(|change| change.altered).count();
    let counts = [
        (lot.added.len(), "added"),
        (lot.removed.len(), "removed"),
        (moved, "moved"),
        (altered, "altered"),
        (lot.same, "the same"),
    ];
    let counts: Vec<String> = counts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| format!("{n} {word}")).collect();
    let _ = writeln!(out, "{name}: plants: {}", counts.join(", "));
    let removed = lot.removed.iter().map(|stand| format!("- {}", self::stand(stand)));
    let added = lot.added.iter().map(|stand| format!("+ {}", self::stand(stand)));
    let changed = lot.changed.iter().map(|change| {
        let moved = if change.moved > 0.0 { format!(", moved {} m", number(change.moved, 2)) } else { String::new() };
        let became = if change.altered { format!(" is now {}", looks(&change.b)) } else { String::new() };
        format!("~ {}{became}{moved}", self::stand(&change.a))
    });
    let all = lot.removed.len() + lot.added.len() + lot.changed.len();
    removed.chain(added).chain(changed).take(MOST).for_each(|line| _ = writeln!(out, "  {line}"));
    if all > MOST {
        let _ = writeln!(out, "  … and {}: `--json` has all", counted(all - MOST, "more plant"));
    }
}

fn stand(stand: &Stand) -> String {
    let [x, y] = stand.at.map(|metres| number(metres, 2));
    format!("{} at {x}, {y}", looks(stand))
}

fn looks(stand: &Stand) -> String {
    let class = if stand.class.is_empty() { String::new() } else { format!(" {}", stand.class) };
    format!("{}{class}, {} m", stand.species, number(stand.height, 2))
}

fn figures(out: &mut String, title: &str, pairs: &Pairs) {
    if pairs.is_empty() {
        return;
    }
    let _ = writeln!(out, "{title}:");
    for (name, Pair { a, b }) in pairs {
        let sign = if b > a { "+" } else { "" };
        let _ = writeln!(out, "  {name}: {} -> {} ({sign}{})", number(*a, 2), number(*b, 2), number(b - a, 2));
    }
}
