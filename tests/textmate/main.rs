//! The TextMate grammar of `editors/vscode`: what it colours, and that it knows every word of the language.
//!
//! `UPDATE_GRAMMAR=1 cargo test --test textmate` writes new names of operations, functions and attributes into it.

mod runner;

use bosquet::{functions, ops};
use runner::{Grammar, Scoped};
use serde_json::Value;
use std::collections::BTreeSet;

const PATH: &str = "editors/vscode/syntaxes/cga.tmLanguage.json";

fn json() -> Value {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(PATH);
    serde_json::from_str(&std::fs::read_to_string(path).expect("the grammar")).expect("JSON")
}

/// The scope of the `nth` stretch with these letters.
fn scope(found: &[Scoped], text: &str, nth: usize) -> String {
    let mut same = found.iter().filter(|scoped| scoped.text.trim() == text);
    same.nth(nth).unwrap_or_else(|| panic!("no `{text}` in {found:#?}")).scope.clone()
}

fn coloured(text: &str, wanted: &[(&str, &str)]) {
    let grammar = Grammar::read(&json());
    let found = grammar.scopes(text);
    let mut seen = std::collections::BTreeMap::new();
    for (word, wanted) in wanted {
        let nth = seen.entry(*word).or_insert(0);
        assert_eq!(scope(&found, word, *nth), format!("{wanted}.cga"), "`{word}` in {text:?}");
        *nth += 1;
    }
}

#[test]
fn definitions_are_coloured_in_both_notations() {
    coloured(
        "attr hedge_height = 1.2",
        &[("attr", "storage.type"), ("hedge_height", "entity.name.variable.attribute")],
    );
    coloured(
        "half(x) = x / 2",
        &[("half", "entity.name.function"), ("x", "variable.other"), ("2", "constant.numeric")],
    );
    coloured("import own : \"plants.cga\"", &[("import", "keyword.control.import"), ("own", "entity.name.namespace")]);
    coloured("version \"2025.1\"", &[("version", "keyword.other.version"), ("2025.1", "string.quoted.double")]);
    coloured(
        "style Winter extends Bare",
        &[("style", "storage.type.style"), ("Bare", "entity.other.inherited-class.style")],
    );
    coloured(
        "start Lot(a, b) --> Lawn",
        &[
            ("start", "storage.modifier.rule"),
            ("Lot", "entity.name.function.rule"),
            ("-->", "keyword.operator.arrow"),
            ("Lawn", "entity.name.type.rule"),
        ],
    );
    coloured(
        "own.Trunk with (a := f(1)) --> NIL",
        &[("own.Trunk", "entity.name.function.rule"), ("NIL", "keyword.control.nil")],
    );
    coloured(
        "2: Side(w) : w > 3 ~> Lawn : 0.5",
        &[
            ("2", "entity.name.label"),
            ("Side", "entity.name.function.rule"),
            ("~>", "keyword.operator.arrow"),
            ("0.5", "constant.numeric"),
        ],
    );
}

#[test]
fn sizes_selectors_and_choices_are_coloured() {
    coloured(
        "Lot --> split(x) { ~6 : A | '0.5 : B | 2r : C | { 3 : D }* }",
        &[
            ("split", "support.function.operation"),
            ("~", "keyword.operator.floating"),
            ("6", "constant.numeric"),
            ("'", "keyword.operator.relative"),
            ("r", "keyword.other.unit.floating"),
            ("*", "keyword.operator.repeat"),
        ],
    );
    coloured(
        "A --> comp(f) { front : B | world.south = C | all : Tile. }",
        &[
            ("front", "support.constant.selector"),
            ("world.south", "support.constant.selector"),
            ("all", "support.constant.selector"),
            ("Tile", "entity.name.type.leaf"),
        ],
    );
    coloured(
        "A --> 30% : B else : case scope.sx > rand(3) : C else : D",
        &[
            ("30", "constant.numeric.percentage"),
            ("%", "keyword.operator.percentage"),
            ("else", "keyword.control.conditional"),
            ("case", "keyword.control.conditional"),
            ("scope.sx", "support.variable.attribute"),
            ("rand", "support.function"),
        ],
    );
    coloured(
        "A --> boundary(width = 4, radius = w) { front }",
        &[
            ("width", "variable.parameter"),
            ("radius", "variable.parameter"),
            ("w", "variable.other"),
            ("front", "variable.other"),
        ],
    );
}

#[test]
fn texts_comments_and_annotations_are_coloured() {
    coloured(
        "attr c = \"#9bb86b80\" // \"#fff\"",
        &[("#9bb86b80", "constant.other.color"), ("// \"#fff\"", "comment.line.double-slash")],
    );
    coloured(
        "attr c = \"a \\\" # b\" # d",
        &[("\\\"", "constant.character.escape"), ("# d", "comment.line.number-sign")],
    );
    coloured("/* attr\nattr */ Lot --> A", &[("attr", "comment.block"), ("attr", "comment.block")]);
    coloured(
        "@Range(min = 0)\n@Nonsense",
        &[
            ("Range", "storage.type.annotation"),
            ("min", "variable.parameter"),
            ("Nonsense", "invalid.deprecated.annotation"),
        ],
    );
}

/// The words of the pattern with this scope in a part of the grammar.
fn words(grammar: &Value, part: &str) -> BTreeSet<String> {
    let pattern = grammar["repository"][part]["patterns"][0]["match"].as_str().expect("a regex");
    let list = pattern.split("(?:").nth(1).and_then(|rest| rest.split(')').next()).expect("a list");
    list.split('|').map(|word| word.replace("\\.", ".")).collect()
}

fn put_words(grammar: &mut Value, part: &str, words: &BTreeSet<String>) {
    let pattern = grammar["repository"][part]["patterns"][0]["match"].as_str().expect("a regex").to_string();
    let (before, rest) = pattern.split_once("(?:").expect("a list");
    let (_, after) = rest.split_once(')').expect("an end");
    let mut list: Vec<String> = words.iter().map(|word| word.replace('.', "\\.")).collect();
    list.sort_by_key(|word| (std::cmp::Reverse(word.len()), word.clone()));
    grammar["repository"][part]["patterns"][0]["match"] = format!("{before}(?:{}){after}", list.join("|")).into();
}

#[test]
fn every_word_of_the_language_is_coloured() {
    let names = |names: Vec<&str>| names.into_iter().map(String::from).collect::<BTreeSet<String>>();
    let operations = ops::OPERATIONS.iter().flat_map(|o| o.spec.aliases.iter().copied().chain([o.spec.name]));
    // A function with an operation's name is coloured as that: a grammar does not know which is meant.
    let functions = functions::all().filter(|f| !f.signature.is_empty() && ops::find(f.name).is_none()).map(|f| f.name);
    let attributes = functions::all().filter(|f| f.signature.is_empty()).map(|f| f.name);
    let parts = [
        ("operations", names(operations.collect())),
        ("functions", names(functions.collect())),
        ("attributes", names(attributes.collect())),
    ];
    let mut grammar = json();
    if std::env::var_os("UPDATE_GRAMMAR").is_some() {
        for (part, wanted) in &parts {
            let all = words(&grammar, part).union(wanted).cloned().collect();
            put_words(&mut grammar, part, &all);
        }
        let selectors = names(ops::Selectors::words().chain(["remainder"]).collect());
        let all = words(&grammar, "selectors").union(&selectors).cloned().collect();
        put_words(&mut grammar, "selectors", &all);
        let text = serde_json::to_string_pretty(&grammar).expect("JSON") + "\n";
        std::fs::write(std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join(PATH), text).expect("the grammar");
    }
    let read = Grammar::read(&grammar);
    let (suffixes, scopes) =
        (["(1)", "(1)", ""], ["support.function.operation", "support.function", "support.variable.attribute"]);
    for (((part, names), suffix), wanted) in parts.iter().zip(suffixes).zip(scopes) {
        for name in names {
            let text = format!("Lot --> A {name}{suffix}");
            let found = scope(&read.scopes(&text), name, 0);
            assert_eq!(found, format!("{wanted}.cga"), "`{name}` of {part}: UPDATE_GRAMMAR=1 adds it");
        }
    }
    for word in ["case", "else", "NIL", "true", "false", "with"] {
        let found = scope(&read.scopes(&format!("Lot --> A {word} ")), word, 0);
        assert!(found.starts_with("keyword.") || found.starts_with("constant.language."), "`{word}`: {found}");
    }
    for selector in ops::Selectors::words().chain(["remainder"]) {
        let found = scope(&read.scopes(&format!("A --> comp(f) {{ {selector} : B }}")), selector, 0);
        assert_eq!(found, "support.constant.selector.cga", "`{selector}`");
    }
}

#[test]
fn the_library_is_coloured_whole() {
    let grammar = Grammar::read(&json());
    for (path, text) in bosquet::library::FILES {
        let plain: Vec<Scoped> = grammar.scopes(text).into_iter().filter(|scoped| scoped.scope.is_empty()).collect();
        assert!(plain.is_empty(), "{path}: {plain:?}");
    }
}
