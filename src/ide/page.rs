//! Manual pages as Markdown: operations, functions, annotations, and what a file defines.

use crate::functions::Function;
use crate::ide::document::{Definition, Document, Sort};
use crate::ops::{self, Operation, Param, Spec};
use crate::syntax::{ANNOTATIONS, TokenKind};

/// What annotations do, and how they are written; those of CityEngine's that are not here change nothing.
const NOTES: &[(&str, &str, &str)] = &[
    ("Color", "Color", "The attribute is a colour, `\"#rrggbb\"`."),
    ("Context", "Context(${1:180})", "The attribute is blended over the lots within so many metres."),
    ("Description", "Description(\"${1}\")", "What the attribute is for."),
    ("Enum", "Enum(${1})", "The choices for people."),
    ("Group", "Group(\"${1}\")", "The group it is shown in."),
    ("Hidden", "Hidden", "Neither layouts nor `--set` reach the attribute."),
    ("Order", "Order(${1:1})", "Its place among the others."),
    ("Range", "Range(min = ${1:0}, max = ${2:10})", "The range for people; an initial value outside is a lint."),
    ("StartRule", "StartRule", "Begins where nothing else says what does."),
    ("Zone", "Zone(${1:lot})", "Begins on regions of a kind, or a kind and zone: `@Zone(lot, residential)`."),
];

/// Longer values are cut in hovers, characters.
const MOST_SHOWN: usize = 400;

/// The operation that a name of the papers means, where no rule has the name.
pub(super) fn of_papers(name: &str) -> Option<&'static Operation> {
    ops::find(match name {
        "Subdiv" | "Repeat" => "split",
        "Comp" => "comp",
        "T" => "t",
        "S" => "s",
        "Rx" | "Ry" | "Rz" => "r",
        _ => return None,
    })
}

/// The page of an operation, with a picture where there is one.
pub(super) fn operation(spec: &Spec, picture: Option<&str>) -> String {
    let mut text = fenced(&spec.usage()) + "\n" + &spec.prose();
    if let Some(picture) = picture {
        text += &format!("\n![{}]({picture})\n", spec.name);
    }
    if !spec.params.is_empty() {
        text += "\n";
    }
    spec.params.iter().for_each(|param| text += &format!("- `{}`: {}\n", param.name, parameter(param)));
    text + &spec.also_called()
}

/// What a parameter takes and means, on one line.
pub(super) fn parameter(param: &Param) -> String {
    let default = param.default.map_or(String::new(), |default| format!(", `{default}` where not given"));
    let usual = param.usual.map_or(String::new(), |[low, high]| format!(", usually {low} to {high}"));
    format!("{} ({}{default}{usual})", param.meaning(), param.kind.words())
}

/// The page of a built-in function.
pub(super) fn function(function: &Function) -> String {
    let settable = if function.settable { "\n`set` may change it.\n" } else { "" };
    format!("{}\n{}\n{settable}", fenced(&format!("{}{}", function.name, function.signature)), function.docs)
}

/// The page of an annotation; `None` for unknown ones.
pub(super) fn annotation(name: &str) -> Option<String> {
    let known = NOTES.iter().find(|(note, ..)| *note == name).map(|(.., does)| *does);
    let passed = "CityEngine's; it is read and changes nothing.";
    let does = known.or_else(|| ANNOTATIONS.contains(&name).then_some(passed))?;
    Some(format!("{}\n{does}\n", fenced(&format!("@{name}"))))
}

/// Every annotation with the snippet that writes it.
pub(super) fn annotations() -> impl Iterator<Item = (&'static str, &'static str)> {
    ANNOTATIONS.into_iter().map(|name| {
        let written = NOTES.iter().find(|(note, ..)| *note == name).map(|(_, snippet, _)| *snippet);
        (name, written.unwrap_or(name))
    })
}

/// The page of a definition: how it is written, its comment, and its file where that is another.
pub(super) fn definition(document: &Document, definition: &Definition, here: &str) -> String {
    let mut text = fenced(&written(document, definition));
    for part in [described(document, definition), comment(document, definition)].into_iter().flatten() {
        text += &format!("\n{part}\n");
    }
    if document.path() != here {
        text += &format!("\nin `{}`\n", document.path());
    }
    text
}

/// A definition in short: the head of a rule, the whole of anything else, its annotations before it.
pub(super) fn written(document: &Document, definition: &Definition) -> String {
    let notes = definition.annotations.clone().map(|piece| piece_text(document, piece) + "\n");
    let notes: String = notes.filter(|note| !note.starts_with("@Description")).collect();
    let text = match definition.sort {
        Sort::Rule => head(document, definition),
        _ => shortened(&piece_text(document, definition.piece)),
    };
    notes + &text
}

/// The head of a definition up to its sign, on one line.
pub(super) fn head(document: &Document, definition: &Definition) -> String {
    let piece = &document.pieces[definition.piece];
    let is_sign = |token: &usize| {
        matches!(
            document.kind(*token),
            Some(TokenKind::Arrow | TokenKind::Squiggle | TokenKind::Bent | TokenKind::Equal)
        )
    };
    let end = piece.tokens.clone().find(is_sign).map_or(piece.bytes.end as usize, |sign| document.range(sign).end);
    let words: Vec<&str> = document.text()[piece.bytes.start as usize..end].split_whitespace().collect();
    words.join(" ")
}

fn piece_text(document: &Document, piece: usize) -> String {
    let bytes = &document.pieces[piece].bytes;
    document.text()[bytes.start as usize..bytes.end as usize].to_string()
}

fn shortened(text: &str) -> String {
    match text.char_indices().nth(MOST_SHOWN) {
        Some((end, _)) => format!("{} …", &text[..end]),
        None => text.to_string(),
    }
}

/// The text of `@Description`.
fn described(document: &Document, definition: &Definition) -> Option<String> {
    let note = definition.annotations.clone().find(|piece| piece_text(document, *piece).starts_with("@Description"))?;
    let mut tokens = document.pieces[note].tokens.clone();
    let text = tokens.find(|token| document.kind(*token) == Some(TokenKind::Text))?;
    Some(document.text_of(text).to_string())
}

/// The comment right above a definition, without its marks.
pub(super) fn comment(document: &Document, definition: &Definition) -> Option<String> {
    let above = &document.text()[..definition.whole.start];
    let own = above.rfind('\n').map_or("", |end| &above[..end]);
    let is_comment = |line: &&str| {
        let line = line.trim();
        line.starts_with("//") || line.starts_with('#') || line.starts_with("/*") || line.ends_with("*/")
    };
    let mut lines: Vec<&str> = own.lines().rev().take_while(is_comment).map(bare).collect();
    lines.reverse();
    let text = lines.join("\n").trim().to_string();
    (!text.is_empty()).then_some(text)
}

fn bare(line: &str) -> &str {
    let line = line.trim().trim_end_matches("*/");
    line.trim_start_matches(['/', '#', '*']).trim()
}

fn fenced(code: &str) -> String {
    format!("```cga\n{code}\n```\n")
}
