//! `bosquet ops`: the manual, from the declarations.

use crate::cli::Ended;
use crate::cli::show::print;
use bosquet::element::{Catalogue, Words};
use bosquet::functions::{self, Function};
use bosquet::ops::{OPERATIONS, Origin, Spec, UNBUILT_OPERATIONS, Unbuilt};
use bosquet::plant::Growth;
use bosquet::text::{nearest, suggestion};
use serde_json::json;

/// Arguments of `bosquet ops`.
#[derive(clap::Args)]
pub struct Arguments {
    /// An operation or function; or `functions`, `covers`, `elements`, `unbuilt`
    name: Option<String>,
    /// For machines
    #[arg(long)]
    json: bool,
}

/// Prints the manual.
pub fn run(arguments: &Arguments) -> Ended {
    match (arguments.name.as_deref(), arguments.json) {
        (None, true) => print_json(&json!({
            "operations": OPERATIONS.iter().map(|o| operation_json(o.spec)).collect::<Vec<_>>(),
            "functions": functions::all().map(function_json).collect::<Vec<_>>(),
            "unbuilt": unbuilt_json(),
        })),
        (None, false) => print(overview()),
        (Some("functions"), false) => functions::all().for_each(|f| print(function_line(f))),
        (Some("covers"), false) => print(covers()),
        (Some("elements"), false) => print(elements()),
        (Some("unbuilt"), false) => print(unbuilt()),
        (Some(name), json) => return one(name, json),
    }
    Ended::Well
}

fn one(name: &str, as_json: bool) -> Ended {
    let operation = bosquet::ops::find(name);
    let function = functions::find(name);
    let missing = UNBUILT_OPERATIONS.iter().find(|u| u.name == name);
    match (operation, function, missing) {
        (Some(operation), _, _) if as_json => print_json(&operation_json(operation.spec)),
        (Some(operation), _, _) => print(page(operation.spec)),
        (None, Some(function), _) if as_json => print_json(&function_json(function)),
        (None, Some(function), _) => print(function_line(function)),
        (None, None, Some(unbuilt)) => {
            print(format_args!("{name}: {}. CityEngine's; bosquet does not have it yet.\n", unbuilt.does))
        }
        (None, None, None) => {
            let built = OPERATIONS.iter().flat_map(|o| o.spec.aliases.iter().copied().chain([o.spec.name]));
            let near = nearest(name, built.chain(functions::all().map(|f| f.name)));
            return Ended::Usage(format!("there is no operation or function `{name}`{}", suggestion(near)));
        }
    }
    Ended::Well
}

fn print_json(value: &serde_json::Value) {
    print(format_args!("{}\n", serde_json::to_string_pretty(value).unwrap_or_default()));
}

fn overview() -> String {
    let mut text = String::from("Operations (`bosquet ops NAME` tells all of one)\n\n");
    for operation in OPERATIONS {
        text += &format!("  {}\n      {}\n", operation.spec.usage(), operation.spec.summary());
    }
    let counts = [
        (functions::all().count(), "functions"),
        (Catalogue::built_in().covers().count(), "covers"),
        (Catalogue::built_in().entries().count(), "elements"),
        (UNBUILT_OPERATIONS.len(), "unbuilt"),
    ];
    text += "\nMore\n\n";
    for (count, name) in counts {
        text += &format!("  bosquet ops {name:<10} {count}\n");
    }
    text
}

fn page(spec: &Spec) -> String {
    let mut text = format!("{}\n\n{}", spec.usage(), spec.prose());
    if !spec.params.is_empty() {
        text += "\n";
    }
    for param in spec.params {
        let default = param.default.map(|d| format!(", {d} where not given")).unwrap_or_default();
        text += &format!("  {}: {}{default}\n      {}\n", param.name, param.kind.words(), param.meaning());
    }
    text + &spec.also_called()
}

fn function_line(function: &Function) -> String {
    format!("  {}{}\n      {}\n", function.name, function.signature, function.docs)
}

fn covers() -> String {
    let line = |cover: &bosquet::element::Cover| {
        let names: Vec<&str> = cover.names.iter().map(|n| &**n).collect();
        let names = if names.is_empty() { String::new() } else { format!("  ({})", names.join(", ")) };
        format!("  {:<18} {}{names}\n", cover.material.name, cover.material.label)
    };
    Catalogue::built_in().covers().map(line).collect()
}

fn elements() -> String {
    let line = |entry: &bosquet::element::Entry| {
        let types: Vec<String> = entry.variants.iter().map(|v| format!("{} ×{}", v.name, v.appearances)).collect();
        let latin = if entry.species.is_empty() { "" } else { &*entry.species };
        let (types, growth) = (types.join(", "), growth(entry));
        format!("  {:<16} {:<12} {:<28} {types}{growth}\n", entry.category, entry.kind.word(), latin)
    };
    Catalogue::built_in().entries().map(line).collect::<String>() + &palettes()
}

/// Until what age a plant was measured.
fn growth(entry: &bosquet::element::Entry) -> String {
    match Growth::of(entry) {
        Ok(growth) if growth.is_measured() => format!("; measured to {} years", growth.last_age()),
        _ => String::new(),
    }
}

fn palettes() -> String {
    let catalogue = Catalogue::built_in();
    let line = |palette: &bosquet::element::Palette| {
        let names: Vec<&str> = palette.plants(catalogue).map(|entry| &*entry.label).collect();
        format!("  {:<16} {}: {}\n", palette.name, palette.label, names.join(", "))
    };
    "\nPalettes for `plant`\n\n".to_owned() + &catalogue.palettes().map(line).collect::<String>()
}

fn unbuilt() -> String {
    let lines: String = UNBUILT_OPERATIONS.iter().map(|u| format!("  {:<28} {}\n", u.name, u.does)).collect();
    format!("Operations of CityEngine that bosquet does not have yet\n\n{lines}")
}

fn operation_json(spec: &Spec) -> serde_json::Value {
    let params: Vec<serde_json::Value> = spec
        .params
        .iter()
        .map(|p| json!({"name": p.name, "docs": p.docs.trim(), "takes": p.kind.words(), "default": p.default}))
        .collect();
    let origin = if spec.origin == Origin::CityEngine { "cityengine" } else { "bosquet" };
    json!({
        "name": spec.name, "aliases": spec.aliases, "usage": spec.usage(), "docs": spec.docs.trim(),
        "params": params, "origin": origin,
    })
}

fn function_json(function: &Function) -> serde_json::Value {
    json!({
        "name": function.name, "signature": function.signature, "docs": function.docs,
        "settable": function.settable, "origin": if function.added { "bosquet" } else { "cityengine" },
    })
}

fn unbuilt_json() -> serde_json::Value {
    let one = |u: &Unbuilt| json!({"name": u.name, "does": u.does});
    json!({ "operations": UNBUILT_OPERATIONS.iter().map(one).collect::<Vec<_>>() })
}
