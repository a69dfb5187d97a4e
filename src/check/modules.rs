//! Loading: the main file and what it imports, each import an instance with its own names and attribute slots.
//!
//! An attribute of the importing file with the name of an attribute of the imported one *is* that attribute: both
//! names lead to one slot, unless the import protects it or gives it a value of its own.

use crate::check::code::{Code, Kind};
use crate::check::program::Attribute;
use crate::check::styles::Styles;
use crate::diag::{Diagnostic, Place, Severity, Span};
use crate::library;
use crate::syntax::ast::{self, FunctionKind, ItemKind};
use crate::syntax::{Source, parse};
use crate::value::{Array, Cells, Value};
use crate::world::{World, imported, join, rules};
use std::collections::{BTreeMap, BTreeSet};
use std::ops::Range;
use std::sync::Arc;

/// The deepest chain of imports.
const DEEPEST_IMPORT: usize = 32;

/// The most imports of all files together: each has names and attributes of its own.
const MOST_IMPORTS: usize = 4096;

/// Files, instances and slots, before names are resolved in bodies.
#[derive(Default)]
pub(super) struct Loaded {
    /// Every file once.
    pub files: Vec<(Source, Arc<ast::File>)>,
    /// The styles of each file.
    pub styles: Vec<Styles>,
    /// Every instance; the main file's is the first.
    pub modules: Vec<Module>,
    /// Every slot; initial values are filled in later.
    pub attributes: Vec<Attribute>,
    /// What initialises each slot: an expression and the module whose names it uses.
    pub initials: Vec<Option<(usize, Arc<ast::File>, Initial)>>,
    /// What went wrong.
    pub diagnostics: Vec<Diagnostic>,
}

/// Which expression initialises a slot.
#[derive(Clone, Copy)]
pub(super) enum Initial {
    /// The value of the function item of this index.
    Item(usize),
    /// The override number `.1` of the import item number `.0`.
    Override(usize, usize),
}

/// One import of a file, or the main file.
pub(super) struct Module {
    /// The index of its file.
    pub file: u16,
    /// Its tree.
    pub tree: Arc<ast::File>,
    /// The items that count under its style.
    pub items: Vec<usize>,
    /// The slots that came with it and its imports.
    pub own: Range<u32>,
    /// How the user calls it: `a.b.`; empty for the main file.
    pub prefix: String,
    /// Its imports by name.
    pub imports: BTreeMap<Arc<str>, usize>,
    /// Imports that could not be loaded, which has been said: what they would have brought is not missed again.
    pub missing: BTreeSet<Arc<str>>,
    /// Its attributes and constants by name.
    pub slots: BTreeMap<Arc<str>, u32>,
    /// Rules that its importers put in place of its own, by name and number of parameters: which module, item and override.
    pub replaced: BTreeMap<(Arc<str>, usize), Replacement>,
}

/// A rule that stands in for an imported one: its module, item, and the override where it is one.
pub(super) type Replacement = (usize, usize, Option<usize>);

/// Loads `path`, its definitions as `style` has them, and what it imports.
pub(super) fn load(world: &dyn World, path: &str, style: Option<&str>) -> Loaded {
    let mut loaded = Loaded::default();
    match rules(world, path) {
        Ok(bytes) => {
            let file = loaded.file(path, &bytes);
            let style = style.map_or(0, |style| loaded.main_style(file, style));
            loaded.instance(world, file, String::new(), &BTreeMap::new(), &[], style);
        }
        Err(error) => loaded.diagnostics.push(Diagnostic::new(Severity::Error, "file", Place::Run, error.to_string())),
    }
    loaded
}

impl Loaded {
    /// The index of the file, parsed once.
    fn file(&mut self, path: &str, bytes: &[u8]) -> u16 {
        if let Some(index) = self.files.iter().position(|(source, _)| source.path() == path) {
            return index as u16;
        }
        let index = self.files.len() as u16;
        let source = Source::new(path, bytes);
        let (tree, errors) = parse(index, &source);
        self.diagnostics.extend(errors);
        let mut styles = Styles::of(&tree);
        self.diagnostics.append(&mut styles.diagnostics);
        self.styles.push(styles);
        self.files.push((source, Arc::new(tree)));
        index
    }

    /// The style of that name in the main file.
    fn main_style(&mut self, file: u16, name: &str) -> usize {
        let styles = &self.styles[file as usize];
        styles.find(name).unwrap_or_else(|| {
            let message = format!("`{}` has no style `{name}`", self.files[file as usize].0.path());
            let diagnostic = Diagnostic::new(Severity::Error, "unknown-name", Place::Run, message);
            self.diagnostics.push(styles.advise(diagnostic, name));
            0
        })
    }

    /// The style that an import asks for.
    fn import_style(&mut self, file: u16, import: &ast::Import) -> usize {
        let Some(name) = import.styles.first() else { return 0 };
        if let Some(second) = import.styles.get(1) {
            let message = format!("an import has one style: `{}` counts here", name.text);
            let hint = "import the file once more under another name to have another of its styles";
            self.diagnostics.push(Diagnostic::lint("style", second.span, message).hint(hint));
        }
        let styles = &self.styles[file as usize];
        styles.find(&name.text).unwrap_or_else(|| {
            let message = format!("`{}` has no style `{}`", self.files[file as usize].0.path(), name.text);
            let diagnostic = Diagnostic::error("unknown-name", name.span, message);
            self.diagnostics.push(styles.advise(diagnostic, &name.text));
            0
        })
    }

    /// A new instance of a file. `outer` are the slots that propagate into it, `chain` the files that import it.
    fn instance(
        &mut self,
        world: &dyn World,
        file: u16,
        prefix: String,
        outer: &BTreeMap<Arc<str>, u32>,
        chain: &[u16],
        style: usize,
    ) -> usize {
        let index = self.modules.len();
        let tree = self.files[file as usize].1.clone();
        let items = self.styles[file as usize].items(&tree, style);
        let first = self.attributes.len() as u32;
        let slots = self.declare(index, file, &items, &prefix, outer);
        self.modules.push(Module {
            file,
            tree: tree.clone(),
            items: items.clone(),
            own: first..first,
            prefix,
            imports: BTreeMap::new(),
            missing: BTreeSet::new(),
            slots,
            replaced: BTreeMap::new(),
        });
        let chain: Vec<u16> = chain.iter().copied().chain([file]).collect();
        for item in &items {
            if let ItemKind::Import(import) = &tree.items[*item].kind
                && self.import(world, index, *item, import, &chain).is_none()
            {
                self.modules[index].missing.insert(import.name.text.clone());
            }
        }
        self.modules[index].own.end = self.attributes.len() as u32;
        self.replace_rules(index);
        index
    }

    /// Slots for the attributes and constants of a file.
    fn declare(
        &mut self,
        module: usize,
        file: u16,
        items: &[usize],
        prefix: &str,
        outer: &BTreeMap<Arc<str>, u32>,
    ) -> BTreeMap<Arc<str>, u32> {
        let tree = &self.files[file as usize].1.clone();
        let mut slots = BTreeMap::new();
        for item in items.iter().copied() {
            let ItemKind::Function(function) = &tree.items[item].kind else { continue };
            if !has_slot(function) {
                continue;
            }
            let name = &function.name.text;
            // What a style has redefined is the style's, whatever the importer has under that name.
            let redefined = !self.styles[file as usize].is_default(item);
            let outer_slot = outer.get(name).filter(|_| function.kind == FunctionKind::Attr && !redefined);
            if slots.contains_key(name) {
                let message = format!("`{name}` is defined twice");
                self.diagnostics.push(
                    Diagnostic::error("defined-twice", function.name.span, message).hint("the first definition counts"),
                );
                continue;
            }
            let slot = outer_slot.copied().unwrap_or_else(|| self.slot(module, tree, item, function, prefix));
            slots.insert(name.clone(), slot);
        }
        slots
    }

    fn slot(
        &mut self,
        module: usize,
        tree: &Arc<ast::File>,
        item: usize,
        function: &ast::Function,
        prefix: &str,
    ) -> u32 {
        self.attributes.push(Attribute {
            name: format!("{prefix}{}", function.name.text).into(),
            public: function.kind == FunctionKind::Attr,
            initial: Code::Value(nothing(function)),
            kind: Kind::Unknown,
            context: None,
            description: None,
            range: None,
            choices: Vec::new(),
            is_open: false,
            span: function.name.span,
        });
        self.initials.push(Some((module, tree.clone(), Initial::Item(item))));
        (self.attributes.len() - 1) as u32
    }

    /// Loads an import; nothing where it cannot be loaded.
    fn import(
        &mut self,
        world: &dyn World,
        module: usize,
        item: usize,
        import: &ast::Import,
        chain: &[u16],
    ) -> Option<()> {
        let from = self.files[self.modules[module].file as usize].0.path().to_string();
        let span = import.path.span;
        if chain.len() >= DEEPEST_IMPORT {
            self.error("import", span, format!("imports are nested deeper than {DEEPEST_IMPORT}"));
            return None;
        }
        let (path, bytes) = match imported(world, &from, &import.path.text) {
            Ok(found) => found,
            Err(error) => {
                let relative = || {
                    "paths of imports are relative to the file that imports, or to a folder `rules` above it"
                        .to_string()
                };
                let hint = library::beside(&join(&from, &import.path.text)).unwrap_or_else(relative);
                let diagnostic = Diagnostic::error("import", span, error.to_string()).hint(hint);
                self.diagnostics.push(diagnostic);
                return None;
            }
        };
        let file = self.file(&path, &bytes);
        if let Some(at) = chain.iter().position(|f| *f == file) {
            let names: Vec<&str> =
                chain[at..].iter().chain([&file]).map(|f| self.files[*f as usize].0.path()).collect();
            let message = format!("the imports go in a circle: {}", names.join(" → "));
            let hint = "what both files need goes into a third that both import";
            self.diagnostics.push(Diagnostic::error("import-cycle", span, message).hint(hint));
            return None;
        }
        if self.modules.len() >= MOST_IMPORTS {
            self.error("import", span, format!("there are more than {MOST_IMPORTS} imports in all"));
            return None;
        }
        let style = self.import_style(file, import);
        let outer = self.propagated(module, import);
        let prefix = format!("{}{}.", self.modules[module].prefix, import.name.text);
        let inner = self.instance(world, file, prefix, &outer, chain, style);
        self.override_all(module, item, import, inner);
        if self.modules[module].imports.insert(import.name.text.clone(), inner).is_some() {
            self.error("defined-twice", import.name.span, format!("`{}` is imported twice", import.name.text));
        }
        Some(())
    }

    /// The slots of a module that reach into an import: all, or those that its parentheses do not hold back.
    fn propagated(&self, module: usize, import: &ast::Import) -> BTreeMap<Arc<str>, u32> {
        let slots = &self.modules[module].slots;
        let Some(overrides) = &import.overrides else { return slots.clone() };
        if overrides.is_empty() {
            return BTreeMap::new();
        }
        let held = |name: &str| {
            overrides.iter().any(|o| match o {
                ast::Override::Protect(n) | ast::Override::Attribute(n, _) => *n.text == *name,
                ast::Override::Rule(_) => false,
            })
        };
        slots.iter().filter(|(name, _)| !held(name)).map(|(name, slot)| (name.clone(), *slot)).collect()
    }

    pub(super) fn error(&mut self, code: &'static str, span: Span, message: String) {
        self.diagnostics.push(Diagnostic::error(code, span, message));
    }
}

/// What a slot holds before its expression is known: of `attr name(index)` an empty list.
fn nothing(function: &ast::Function) -> Value {
    match function.params {
        Some(_) => Value::Array(Arc::new(Array::row(Cells::Numbers(Vec::new())))),
        None => Value::Float(0.0),
    }
}

/// Whether a definition is evaluated once for a lot, and so has a place among the attributes: `attr name(index)` has
/// one for the list that the layout may give.
pub(super) fn has_slot(function: &ast::Function) -> bool {
    match function.kind {
        FunctionKind::Attr => true,
        FunctionKind::Const => function.params.is_none(),
        FunctionKind::Function => false,
    }
}
