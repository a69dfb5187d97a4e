//! The lists that completions are made of: operations, rules, functions, attributes, words of the catalogue, paths.

use crate::functions::{self, Function};
use crate::ide::Desk;
use crate::ide::catalogue::{self, Known};
use crate::ide::complete::{CompletionKind, List};
use crate::ide::context::{Callee, Context};
use crate::ide::document::{Definition, Document, Sort};
use crate::ide::identity::is_taken;
use crate::ide::imports::imported_path;
use crate::ide::walk::Role;
use crate::ide::{page, snippet};
use crate::library;
use crate::ops::{OPERATIONS, Param, ParamKind, Selectors, Spec};
use crate::syntax::TokenKind;
use std::collections::BTreeSet;

/// What can begin where a definition can: label, detail, snippet.
const STATEMENTS: &[(&str, &str, &str)] = &[
    ("attr", "an attribute: each lot may have its own value", "attr ${1:name} = ${2:value}"),
    ("const", "an attribute that only the file sets", "const ${1:name} = ${2:value}"),
    ("import", "another file's rules, functions and attributes", "import ${1:name} : \"${2:bosquet:patterns/}\""),
    ("version", "the version of the language; it changes nothing", "version \"${1:2025.1}\""),
    ("style", "a style: what follows belongs to it", "style ${1:Name}"),
    ("rule", "a rule", "${1:Name} --> $0"),
    ("start", "the rule that begins", "start ${1:Name} --> $0"),
    ("extension", "a rule that importers may replace", "extension ${1:Name} --> $0"),
];

/// A choice among successors, and among values.
const CASE: &str = "case ${1:condition} : ${2:A}\nelse : ${3:B}";

/// How deep names of imports of imports are offered.
const DEEPEST_NAMES: usize = 4;

impl List {
    /// What can begin a definition.
    pub fn statements(&mut self) {
        for (label, detail, insert) in STATEMENTS {
            self.add(CompletionKind::Keyword, label, *detail, String::new(), (*insert).to_string());
        }
    }

    /// Every annotation.
    pub fn annotations(&mut self) {
        for (name, insert) in page::annotations() {
            let docs = page::annotation(name).unwrap_or_default();
            self.add(CompletionKind::Annotation, name, "annotation", docs, insert.to_string());
        }
    }

    /// The names of an operation's arguments.
    pub fn arguments(&mut self, spec: &Spec) {
        for param in spec.params {
            let (label, docs) = (format!("{} =", param.name), page::parameter(param));
            self.add(CompletionKind::Argument, &label, param.kind.words(), docs, format!("{} = $0", param.name));
        }
    }

    /// The selectors of a block, those of its operation first.
    pub fn selectors(&mut self, extra: &[&'static str]) {
        extra.iter().copied().chain(Selectors::words()).for_each(|word| {
            self.plain(CompletionKind::Word, word, "selector");
        });
    }

    fn known(&mut self, known: Vec<Known>, quoted: bool) {
        for Known { word, detail } in known {
            let bare =
                word.chars().all(|c| c.is_alphanumeric() || c == '_') && !word.starts_with(|c: char| c.is_numeric());
            if quoted || bare {
                self.plain(CompletionKind::Element, &word, detail);
            }
        }
    }

    fn definition(&mut self, document: &Document, definition: &Definition, prefix: &str, here: &str) {
        let kind = match definition.sort {
            Sort::Rule => CompletionKind::Rule,
            Sort::Function => CompletionKind::Function,
            _ => CompletionKind::Attribute,
        };
        let label = format!("{prefix}{}", definition.name);
        let docs = page::definition(document, definition, here);
        let insert = snippet::own(&label, definition.params.as_deref());
        self.add(kind, &label, definition.sort.word(), docs, insert);
    }
}

impl Desk<'_> {
    /// Operations, rules, leaves.
    pub(super) fn steps(&self, document: &Document, found: &mut List) {
        for operation in OPERATIONS {
            let spec = operation.spec;
            let docs = page::operation(spec, self.picture(spec.name).as_deref());
            found.add(CompletionKind::Operation, spec.name, spec.usage(), docs, snippet::operation(spec));
        }
        self.named(document, "", &[Sort::Rule], document.path(), found);
        found.plain(CompletionKind::Keyword, "NIL", "deletes the shape");
        found.add(CompletionKind::Keyword, "case", "a choice by conditions", String::new(), CASE.to_string());
        found.plain(CompletionKind::Keyword, "else", "what is left of a choice");
        for cover in catalogue::covers(self.catalogue) {
            found.plain(CompletionKind::Element, &leaf_name(&cover.word), format!("a leaf: {}", cover.detail));
        }
    }

    /// Attributes and functions, of the files and built in.
    pub(super) fn expressions(&self, document: &Document, found: &mut List) {
        let sorts = [Sort::Attribute, Sort::Constant, Sort::Function];
        self.named(document, "", &sorts, document.path(), found);
        let own: BTreeSet<String> = found.items.iter().map(|item| item.label.clone()).collect();
        for function in functions::all().filter(|function| !own.contains(function.name)) {
            let kind = if function.signature.is_empty() { CompletionKind::Attribute } else { CompletionKind::Function };
            let detail = format!("{}{}", function.name, function.signature);
            found.add(kind, function.name, detail, page::function(function), snippet::function(function));
        }
        for word in ["true", "false"] {
            found.plain(CompletionKind::Keyword, word, "a truth value");
        }
        found.add(CompletionKind::Keyword, "case", "a choice by conditions", String::new(), CASE.to_string());
    }

    /// The parameters and locals of the definition under way.
    pub(super) fn locals(&self, document: &Document, context: &Context, found: &mut List) {
        let own = document.names.iter().filter(|name| Some(name.piece) == context.piece);
        for name in own.filter(|name| matches!(name.role, Role::Param | Role::Local)) {
            found.plain(CompletionKind::Param, document.word(name.token), "a parameter of this definition");
        }
    }

    /// What a file defines, and what it imports under the imports' names.
    fn named(&self, document: &Document, prefix: &str, sorts: &[Sort], here: &str, found: &mut List) {
        let mut seen = BTreeSet::new();
        for definition in document.definitions().iter().filter(|d| sorts.contains(&d.sort)) {
            let hidden = definition.name.contains('.') || (definition.sort == Sort::Rule && is_taken(&definition.name));
            let arity = definition.params.as_ref().map_or(0, Vec::len);
            if !hidden && seen.insert((definition.name.clone(), arity)) {
                found.definition(document, definition, prefix, here);
            }
        }
        if prefix.matches('.').count() >= DEEPEST_NAMES {
            return;
        }
        for import in document.definitions().iter().filter(|d| d.sort == Sort::Import) {
            let inner = imported_path(self.world, document, import).filter(|path| path != here);
            if let Some(inner) = inner.and_then(|path| self.document(&path)) {
                self.named(&inner, &format!("{prefix}{}.", import.name), sorts, here, found);
            }
        }
    }

    /// What stands in the parentheses of an import: names of the imported file.
    pub(super) fn names_of_import(&self, document: &Document, context: &Context, found: &mut List) {
        let import = context.piece.and_then(|piece| document.definition_of(piece));
        let path = import.and_then(|import| imported_path(self.world, document, import));
        self.settable(document, path, found);
    }

    /// The attributes and rules of an imported file, under their own names.
    pub(super) fn settable(&self, document: &Document, path: Option<String>, found: &mut List) {
        let Some(inner) = path.and_then(|path| self.document(&path)) else { return };
        let offered = inner.definitions().iter().filter(|d| matches!(d.sort, Sort::Rule | Sort::Attribute));
        offered.for_each(|definition| found.definition(&inner, definition, "", document.path()));
    }

    /// The words that a parameter takes, bare or within quotes.
    pub(super) fn words(
        &self,
        document: &Document,
        context: &Context,
        spec: &Spec,
        param: &Param,
        quoted: bool,
        found: &mut List,
    ) {
        if let ParamKind::Choice(words) = param.kind {
            words.iter().for_each(|word| found.plain(CompletionKind::Word, word, format!("`{}`", param.name)));
        }
        if param.kind == ParamKind::Truth {
            ["true", "false"]
                .iter()
                .for_each(|word| found.plain(CompletionKind::Word, word, format!("`{}`", param.name)));
        }
        let first = context.call().and_then(|call| call.owner).map(|owner| argument_text(document, owner));
        match (spec.name, param.name) {
            ("plant", "species") => found.known(catalogue::elements(self.catalogue, true), quoted),
            ("plant", "palette") => found.known(catalogue::palettes(self.catalogue), quoted),
            ("I", "category") | ("i", _) => found.known(catalogue::elements(self.catalogue, false), quoted),
            ("I", "kind") => found.known(catalogue::variants(self.catalogue, &first.unwrap_or_default()), quoted),
            ("set", "value") if first.as_deref() == Some("material.name") => {
                found.known(catalogue::covers(self.catalogue), quoted);
            }
            _ if quoted && param.kind != ParamKind::Any => self.labels(document, found),
            _ => {}
        }
    }

    /// A text that is no argument of an operation: of a function that asks for a species, or anything.
    pub(super) fn loose_words(&self, document: &Document, context: &Context, found: &mut List) {
        let owner = context.call().and_then(|call| call.owner);
        match owner.and_then(|owner| self.callee(document, owner)) {
            Some(Callee::Builtin(function)) if is_of_species(function) => {
                found.known(catalogue::elements(self.catalogue, true), true);
            }
            Some(Callee::Builtin(function)) if function.looks_around => self.labels(document, found),
            _ => {
                found.known(catalogue::covers(self.catalogue), true);
                found.known(catalogue::elements(self.catalogue, false), true);
                found.known(catalogue::palettes(self.catalogue), true);
            }
        }
    }

    /// The labels that the file gives, and what layouts have.
    fn labels(&self, document: &Document, found: &mut List) {
        let given = document.names.iter().filter(|n| n.role == Role::Step && document.word(n.token) == "label");
        let mut words: BTreeSet<String> = given.map(|n| argument_text(document, n.token)).collect();
        words.extend(["building", "driveway", "footway", "street", "water", "pool", "tree"].map(String::from));
        words
            .iter()
            .filter(|word| !word.is_empty())
            .for_each(|word| found.plain(CompletionKind::Word, word, "label or kind"));
    }

    /// The rule files that an import can name: the library's, and those the editor knows, seen from this one.
    pub(super) fn paths(&self, document: &Document, found: &mut List) {
        for (path, _) in library::FILES {
            found.plain(CompletionKind::File, &format!("{}{path}", library::PREFIX), "the pattern library");
        }
        for path in self.files.iter().filter(|path| *path != document.path()) {
            found.plain(CompletionKind::File, &relative(document.path(), path), "");
        }
    }
}

/// The first argument of a call, without quotes, where it is a single token.
fn argument_text(document: &Document, owner: usize) -> String {
    match document.kind(owner + 2) {
        Some(TokenKind::Name | TokenKind::Text) => document.text_of(owner + 2).to_string(),
        _ => String::new(),
    }
}

fn is_of_species(function: &Function) -> bool {
    function.name.starts_with("species.")
}

/// A cover as the name of a leaf: `crushed-tile` gives `CrushedTile`.
fn leaf_name(word: &str) -> String {
    let parts = word.split(|c: char| !c.is_alphanumeric()).filter(|part| !part.is_empty());
    parts.flat_map(|part| part.chars().take(1).flat_map(char::to_uppercase).chain(part.chars().skip(1))).collect()
}

/// A path as it is written in a file of another folder.
fn relative(from: &str, path: &str) -> String {
    let own: Vec<&str> = from.split('/').collect();
    let other: Vec<&str> = path.split('/').collect();
    let folders = own.len().saturating_sub(1).min(other.len().saturating_sub(1));
    let shared = (0..folders).take_while(|index| own[*index] == other[*index]).count();
    let ups = own.len() - 1 - shared;
    "../".repeat(ups) + &other[shared..].join("/")
}
