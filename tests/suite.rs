//! The suite: what the language means, in the language (see `tests/common/section.rs` for how it is written).
//!
//! Stages: `check` compares what is reported about the rules alone; `report` derives them too, and compares
//! `// Report: key = sum`, `// Count: Symbol = number` and what is printed (`print(x) // = 3`); `tree` compares the
//! derivation tree with `tests/ref/name.txt` besides. `UPDATE_SUITE=1 cargo test --test suite` writes notes and
//! references anew: look at the difference before it is committed.

#[path = "common/place.rs"]
mod place;
#[path = "common/section.rs"]
mod section;

use bosquet::check::{Program, check_style};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::diag::{Diagnostic, Place};
use bosquet::element::Catalogue;
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::text::number;
use bosquet::trace::{TreeOptions, tree_text};
use bosquet::value::Value;
use bosquet::world::MemoryWorld;
use section::{Note, Section};
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn tests() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests")
}

fn updating() -> bool {
    std::env::var_os("UPDATE_SUITE").is_some()
}

/// What a section gave.
struct Given {
    diagnostics: Vec<Diagnostic>,
    program: Program,
    derivation: Option<Derivation>,
}

#[test]
fn the_suite_holds() {
    let sections = section::sections(&tests().join("suite"));
    assert!(sections.len() > 50, "only {} sections were found", sections.len());
    let mut rewritten: BTreeMap<PathBuf, String> = BTreeMap::new();
    let mut failures = Vec::new();
    for section in &sections {
        let given = run(section);
        let notes = notes(section, &given);
        if updating() {
            rewritten.entry(section.path.clone()).or_default().push_str(&section.rewritten(&notes));
        } else {
            failures.extend(compare_notes(section, &notes));
        }
        failures.extend(given.derivation.iter().flat_map(|d| compare(section, d)));
    }
    rewritten.iter().for_each(|(path, text)| std::fs::write(path, text).expect("a writable suite"));
    failures.extend(not_in_order(&sections));
    assert!(failures.is_empty(), "{} failures\n\n{}", failures.len(), failures.join("\n\n"));
}

#[test]
fn every_operation_and_function_has_a_section() {
    let sections = section::sections(&tests().join("suite"));
    let text: String = sections.iter().flat_map(|s| &s.files).map(section::RuleFile::text).collect();
    let is_word = |c: char| c.is_alphanumeric() || c == '_' || c == '.';
    let words: std::collections::BTreeSet<&str> = text.split(|c| !is_word(c)).collect();
    let operations = bosquet::ops::OPERATIONS.iter().map(|operation| operation.spec.name);
    let missing: Vec<&str> =
        operations.chain(bosquet::functions::all().map(|f| f.name)).filter(|name| !words.contains(name)).collect();
    assert!(missing.is_empty(), "no section of the suite uses {missing:?}");
}

/// Names that stand twice, stages that are none, references that nobody reads.
fn not_in_order(sections: &[Section]) -> Vec<String> {
    let (mut seen, mut failures) = (BTreeMap::new(), Vec::new());
    for section in sections {
        if let Some(first) = seen.insert(section.name.clone(), section.place(0, 0)) {
            failures.push(format!("{}: `{}` is also the name of {first}", section.place(0, 0), section.name));
        }
        if !["check", "report", "tree"].contains(&section.stage.as_str()) {
            failures.push(format!("{}: there is no stage `{}`", section.place(0, 0), section.stage));
        }
    }
    let trees = |name: &str| sections.iter().any(|s| s.name == name && s.stage == "tree");
    for entry in std::fs::read_dir(tests().join("ref")).expect("references") {
        let path = entry.expect("a readable folder").path();
        let name = path.file_stem().unwrap_or_default().to_string_lossy().into_owned();
        if path.extension().is_some_and(|e| e == "txt") && !trees(&name) {
            failures.push(format!("{}: no section of the suite has this name", path.display()));
        }
    }
    failures
}

fn run(section: &Section) -> Given {
    let files = section.files.iter();
    let world = files.fold(MemoryWorld::default(), |world, file| world.with(file.path.clone(), file.text()));
    let (program, mut diagnostics) = check_style(&world, "main.cga", section.all("Style").next());
    if section.stage == "check" || diagnostics.iter().any(Diagnostic::is_error) {
        return Given { diagnostics, program, derivation: None };
    }
    let options = options(section, &program, &world);
    let statements: Vec<&str> = section.all("Layout").collect();
    let layout = place::parse(&statements).unwrap_or_else(|e| panic!("{}: {e}", section.place(0, 0)));
    let (derivation, derived) = derive(&program, &layout, &options, &Progress::default());
    diagnostics.extend(derived);
    Given { diagnostics, program, derivation: Some(derivation) }
}

fn options<'a>(section: &Section, program: &Program, world: &'a MemoryWorld) -> Options<'a> {
    let pairs = |word| section.all(word).map(|text| text.split_once('=').expect("name=value"));
    let slot = |name: &str| program.slot(name).unwrap_or_else(|| panic!("{}: no `{name}`", section.place(0, 0)));
    let mut limits = Limits::default();
    for (name, value) in pairs("Limit") {
        let value = value.parse().expect("a number");
        match name {
            "depth" => limits.depth = value,
            "calls" => limits.calls = value,
            "shapes" => limits.shapes = value,
            "children" => limits.children = value,
            _ => panic!("{}: there is no limit `{name}`", section.place(0, 0)),
        }
    }
    Options {
        start: section.all("Start").next().map(Arc::from),
        seed: Seed(section.all("Seed").next().map_or(0, |seed| seed.parse().expect("a number"))),
        set: pairs("Set").map(|(name, value)| (slot(name), place::value(value))).collect(),
        catalogue: Catalogue::built_in(),
        world,
        limits,
    }
}

/// The diagnostics of a run as notes, per file of the section.
fn notes(section: &Section, given: &Given) -> Vec<Vec<Note>> {
    let mut notes: Vec<Vec<Note>> = section.files.iter().map(|_| Vec::new()).collect();
    for diagnostic in &given.diagnostics {
        let text = format!("{}: {}", diagnostic.severity.word(), diagnostic.message);
        let mut note =
            Note { line: section.files[0].lines.len(), columns: None, text, hints: diagnostic.hints.clone() };
        let mut file = 0;
        if let Place::Rule(span) = &diagnostic.place {
            let source = &given.program.sources[span.file as usize];
            let (line, first) = source.line_column(span.start);
            let (last_line, last) = source.line_column(span.end);
            file = section.files.iter().position(|f| f.path == source.path()).unwrap_or(0);
            let width = section.files[file].lines.get(line - 1).map_or(0, |(_, text)| text.chars().count());
            let last = if last_line == line { last.saturating_sub(1) } else { width };
            (note.line, note.columns) = (line - 1, Some((first, last.max(first))));
        }
        notes[file].push(note);
    }
    notes.iter_mut().for_each(|notes| notes.sort());
    notes
}

fn compare_notes(section: &Section, found: &[Vec<Note>]) -> Vec<String> {
    let mut failures = Vec::new();
    for (index, file) in section.files.iter().enumerate() {
        let mut expected = file.notes.clone();
        expected.iter_mut().filter(|n| n.columns.is_none()).for_each(|n| n.line = section.files[0].lines.len());
        expected.sort();
        let missing = expected.iter().filter(|note| !found[index].contains(note));
        let extra = found[index].iter().filter(|note| !expected.contains(note));
        let said = |what: &str, note: &Note| {
            format!("{} ({}): {what}\n  {}", section.place(index, note.line), section.name, note.lines().join("\n  "))
        };
        failures.extend(missing.map(|note| said("expected, not reported", note)));
        failures.extend(extra.map(|note| said("reported, not expected", note)));
    }
    failures
}

/// Reports, counts, prints and the tree against what the section says.
fn compare(section: &Section, derivation: &Derivation) -> Vec<String> {
    let place = format!("{} ({})", section.place(0, 0), section.name);
    let mut failures = Vec::new();
    let mut same = |what: &str, expected: &str, found: &str| {
        if expected != found {
            failures.push(format!("{place}: {what}\n  expected {expected}\n  found    {found}"));
        }
    };
    for (word, found) in [("Report", reported(derivation)), ("Count", counted(derivation))] {
        for (key, expected) in section.all(word).map(|text| text.split_once(" = ").expect("key = value")) {
            let found = found.get(key).copied().unwrap_or(0.0);
            let (value, slack) = expected.split_once(" ± ").unwrap_or((expected, "0"));
            let [value, slack]: [f64; 2] = [value, slack].map(|n| n.parse().expect("a number"));
            let found_text = number(found, 3);
            let near = (found - value).abs() <= slack + 5e-4;
            same(&format!("{word} {key}"), expected, if near { expected } else { &found_text });
        }
    }
    let prints = derivation.lots.iter().flat_map(|lot| &lot.outcome.prints).map(|p| p.value.to_string());
    let prints: Vec<String> = prints.collect();
    same("print", &section.prints().join(" | "), &prints.join(" | "));
    if section.stage == "tree" {
        let (path, found) =
            (tests().join("ref").join(format!("{}.txt", section.name)), tree_text(derivation, &TreeOptions::default()));
        match updating() {
            true => std::fs::write(&path, &found).expect("writable references"),
            false => same("the tree", &std::fs::read_to_string(&path).unwrap_or_default(), &found),
        }
    }
    failures
}

/// Numbers summed, texts and truth values counted, over all lots.
fn reported(derivation: &Derivation) -> BTreeMap<&str, f64> {
    let mut sums = BTreeMap::new();
    for (key, value) in derivation.lots.iter().flat_map(|lot| &lot.outcome.reports) {
        let number = if let Value::Float(number) = value { *number } else { 1.0 };
        *sums.entry(&**key).or_insert(0.0) += number;
    }
    sums
}

/// How many shapes each symbol has.
fn counted(derivation: &Derivation) -> BTreeMap<&str, f64> {
    let mut counts = BTreeMap::new();
    for node in derivation.lots.iter().flat_map(|lot| &lot.outcome.nodes) {
        *counts.entry(&*derivation.symbols[node.symbol as usize]).or_insert(0.0) += 1.0;
    }
    counts
}
