//! The pages as Markdown.

use crate::element::{Catalogue, Words};
use crate::functions;
use crate::manual::chapters::{OTHERS, PARTS, others};
use crate::manual::{page_path, picture_path};
use crate::ops::{Origin, Param, Selectors, Spec};

/// What stands at the head of every page.
const MADE: &str = "<!-- Made by `bosquet manual` from the declarations in src/: edit them, not this page. -->\n\n";

/// One operation: how it is called, what it does, its parameters, its example and what that looks like.
pub fn operation(spec: &Spec) -> String {
    let mut text = format!("{MADE}# {}\n\n```text\n{}\n```\n\n", spec.name, spec.usage());
    text += &spec.prose();
    text += &format!("\n![What the example gives on a lot of 40 by 30 m](../{})\n", picture_path(spec));
    text += &parameters(spec);
    text += &spec.also_called();
    text += match spec.origin {
        Origin::CityEngine => "\nCityEngine has it under the same name.\n",
        Origin::Added => "\nbosquet's own: a rule of that name in a file takes its place.\n",
    };
    text += "\n[All operations](../README.md)\n";
    text
}

fn parameters(spec: &Spec) -> String {
    if spec.params.is_empty() {
        return String::new();
    }
    let row = |param: &Param| {
        let default = param.default.map_or("must be given".to_string(), |default| format!("`{default}`"));
        format!("| `{}` | {} | {default} | {} |\n", param.name, cell(&param.kind.words()), cell(&param.meaning()))
    };
    let rows: String = spec.params.iter().map(row).collect();
    format!("\n| parameter | takes | where not given | what it is |\n| --- | --- | --- | --- |\n{rows}")
}

/// The list of everything.
pub fn contents() -> String {
    let mut text = format!("{MADE}# The manual of the language\n\n");
    // No links: a manual may be written anywhere, and these two are the sources'.
    text += "The language itself is told in `docs/language.md` of the sources; `docs/manual/tutorial.md` there goes from \
             an empty file to a planted square. Here stands every word that is built in.\n\n";
    text += "- [functions and shape attributes](functions.md)\n- [selectors](selectors.md)\n\
             - [ground covers](covers.md)\n- [plants and things](elements.md)\n\n## Operations\n\n";
    for part in PARTS {
        text += &format!("### {}\n\n{}\n\n", part.title, part.about);
        text += &part.operations().map(entry).collect::<String>();
        text += "\n";
    }
    text += &format!("### {OTHERS}\n\nTexture coordinates and meshes: scenes carry them, plans do not show them.\n\n");
    text += &others().map(entry).collect::<String>();
    text
}

/// A line of the contents.
fn entry(spec: &Spec) -> String {
    format!("- [`{}`]({}): {}\n", spec.name, page_path(spec), spec.summary())
}

/// Every function with what it takes and gives.
pub fn functions() -> String {
    let mut text =
        format!("{MADE}# Functions and shape attributes\n\n| how it is written | what it gives |\n| --- | --- |\n");
    for function in functions::all() {
        let mark = if function.settable { " Can be `set`." } else { "" };
        let own = if function.added { " bosquet's own." } else { "" };
        text += &format!("| `{}{}` | {}{mark}{own} |\n", function.name, cell(function.signature), cell(function.docs));
    }
    text
}

/// Every word that takes components.
pub fn selectors() -> String {
    let mut text = format!("{MADE}# Selectors\n\n");
    text += "Words that take components in the blocks of `comp`, `setback` and their like; beside them stand indices \
             (from the end where negative) and conditions on the component.\n\n";
    Selectors::words().for_each(|word| text += &format!("- `{word}`\n"));
    text
}

/// Every ground cover.
pub fn covers() -> String {
    let mut text = format!(
        "{MADE}# Ground covers\n\nWords for `material.name` and for leaves.\n\n| word | what it is | also |\n| --- | --- | --- |\n"
    );
    for cover in Catalogue::built_in().covers() {
        let names: Vec<&str> = cover.names.iter().map(|name| &**name).collect();
        text += &format!("| `{}` | {} | {} |\n", cover.material.name, cell(&cover.material.label), quoted(&names));
    }
    text
}

/// Every plant and thing.
pub fn elements() -> String {
    let mut text = format!(
        "{MADE}# Plants and things\n\nWhat `i`, `I` and `plant` insert.\n\n| word | kind | species | types |\n| --- | --- | --- | --- |\n"
    );
    for entry in Catalogue::built_in().entries() {
        let types: Vec<&str> = entry.variants.iter().map(|variant| &*variant.name).collect();
        text += &format!("| `{}` | {} | {} | {} |\n", entry.category, entry.kind.word(), entry.species, quoted(&types));
    }
    text
}

/// A text as the cell of a table.
fn cell(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace('|', "\\|")
}

fn quoted(words: &[&str]) -> String {
    words.iter().map(|word| format!("`{word}`")).collect::<Vec<_>>().join(", ")
}
