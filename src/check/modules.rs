//! Loading: the main file and what it imports, each import an instance with its own names and attribute slots.
//!
//! An attribute of the importing file with the name of an attribute of the imported one *is* that attribute: both
//! names lead to one slot, unless the import protects it or gives it a value of its own.

use crate::check::program::{Attribute, Code, Kind};
use crate::diag::{Diagnostic, Place, Severity, Span};
use crate::library;
use crate::syntax::ast::{self, FunctionKind, ItemKind};
use crate::syntax::{Source, parse};
use crate::world::{World, join, rules};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// The deepest chain of imports.
const DEEPEST_IMPORT: usize = 32;

/// Files, instances and slots, before names are resolved in bodies.
#[derive(Default)]
pub(super) struct Loaded {
    /// Every file once.
    pub files: Vec<(Source, Arc<ast::File>)>,
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

/// Loads `path` and what it imports.
pub(super) fn load(world: &dyn World, path: &str) -> Loaded {
    let mut loaded = Loaded::default();
    match rules(world, path) {
        Ok(bytes) => {
            let file = loaded.file(path, &bytes);
            loaded.instance(world, file, String::new(), &BTreeMap::new(), &[]);
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
        self.files.push((source, Arc::new(tree)));
        index
    }

    /// A new instance of a file. `outer` are the slots that propagate into it, `chain` the files that import it.
    fn instance(
        &mut self,
        world: &dyn World,
        file: u16,
        prefix: String,
        outer: &BTreeMap<Arc<str>, u32>,
        chain: &[u16],
    ) -> usize {
        let index = self.modules.len();
        let tree = self.files[file as usize].1.clone();
        let slots = self.declare(index, &tree, &prefix, outer);
        self.modules.push(Module {
            file,
            tree: tree.clone(),
            prefix,
            imports: BTreeMap::new(),
            missing: BTreeSet::new(),
            slots,
            replaced: BTreeMap::new(),
        });
        let chain: Vec<u16> = chain.iter().copied().chain([file]).collect();
        for (item, definition) in tree.items.iter().enumerate() {
            if let ItemKind::Style { name, .. } = &definition.kind {
                self.error("unbuilt", name.span, "styles are parsed, but not derived yet".into());
            }
            if let ItemKind::Import(import) = &definition.kind
                && self.import(world, index, item, import, &chain).is_none()
            {
                self.modules[index].missing.insert(import.name.text.clone());
            }
        }
        self.replace_rules(index, &tree);
        index
    }

    /// Slots for the attributes and constants of a file.
    fn declare(
        &mut self,
        module: usize,
        tree: &Arc<ast::File>,
        prefix: &str,
        outer: &BTreeMap<Arc<str>, u32>,
    ) -> BTreeMap<Arc<str>, u32> {
        let mut slots = BTreeMap::new();
        for (item, definition) in tree.items.iter().enumerate() {
            let ItemKind::Function(function) = &definition.kind else { continue };
            if function.kind == FunctionKind::Function || function.params.is_some() {
                continue;
            }
            let name = &function.name.text;
            let outer_slot = outer.get(name).filter(|_| function.kind == FunctionKind::Attr);
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
            initial: Code::Value(crate::value::Value::Float(0.0)),
            kind: Kind::Unknown,
            context: None,
            description: None,
            range: None,
            choices: Vec::new(),
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
        let path = join(&from, &import.path.text);
        let span = import.path.span;
        if chain.len() >= DEEPEST_IMPORT {
            self.error("import", span, format!("imports are nested deeper than {DEEPEST_IMPORT}"));
            return None;
        }
        let bytes = match rules(world, &path) {
            Ok(bytes) => bytes,
            Err(error) => {
                let relative = || "paths of imports are relative to the file that imports".to_string();
                let hint = library::beside(&path).unwrap_or_else(relative);
                let diagnostic = Diagnostic::error("import", span, error.to_string()).hint(hint);
                self.diagnostics.push(diagnostic);
                return None;
            }
        };
        let file = self.file(&path, &bytes);
        if let Some(at) = chain.iter().position(|f| *f == file) {
            let names: Vec<&str> =
                chain[at..].iter().chain([&file]).map(|f| self.files[*f as usize].0.path()).collect();
            self.error("import-cycle", span, format!("the imports go in a circle: {}", names.join(" → ")));
            return None;
        }
        if let Some(style) = import.styles.first() {
            self.error("unbuilt", style.span, "styles are parsed, but not derived yet".into());
        }
        let outer = self.propagated(module, import);
        let prefix = format!("{}{}.", self.modules[module].prefix, import.name.text);
        let inner = self.instance(world, file, prefix, &outer, chain);
        self.override_attributes(module, item, import, inner);
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

    fn override_attributes(&mut self, module: usize, item: usize, import: &ast::Import, inner: usize) {
        for (number, given) in import.overrides.iter().flatten().enumerate() {
            match given {
                ast::Override::Attribute(name, _) => match self.modules[inner].slots.get(&name.text) {
                    Some(slot) => {
                        let tree = self.modules[module].tree.clone();
                        self.initials[*slot as usize] = Some((module, tree, Initial::Override(item, number)));
                        self.attributes[*slot as usize].public = false;
                    }
                    None => self.unknown_attribute(inner, name),
                },
                ast::Override::Protect(name) if !self.modules[inner].slots.contains_key(&name.text) => {
                    self.unknown_attribute(inner, name);
                }
                ast::Override::Protect(_) => {}
                ast::Override::Rule(rule) => {
                    let key = (rule.name.text.clone(), rule.params.as_ref().map_or(0, Vec::len));
                    self.modules[inner].replaced.insert(key, (module, item, Some(number)));
                }
            }
        }
    }

    /// `import.Rule --> …` puts a rule in place of an imported one.
    fn replace_rules(&mut self, module: usize, tree: &ast::File) {
        for (item, definition) in tree.items.iter().enumerate() {
            let ItemKind::Rule(rule) = &definition.kind else { continue };
            let Some((import, name)) = rule.name.text.split_once('.') else { continue };
            match self.modules[module].imports.get(import).copied() {
                Some(inner) => {
                    let key = (name.into(), rule.params.as_ref().map_or(0, Vec::len));
                    self.modules[inner].replaced.insert(key, (module, item, None));
                }
                None => self.error("unknown-name", rule.name.span, format!("there is no import `{import}`")),
            }
        }
    }

    fn unknown_attribute(&mut self, inner: usize, name: &ast::Name) {
        let file = self.files[self.modules[inner].file as usize].0.path();
        let near = crate::text::nearest(&name.text, self.modules[inner].slots.keys().map(|k| &**k));
        let message = format!("`{file}` has no attribute `{}`", name.text);
        let diagnostic = Diagnostic::error("unknown-name", name.span, message).did_you_mean(near);
        self.diagnostics.push(diagnostic);
    }

    fn error(&mut self, code: &'static str, span: Span, message: String) {
        self.diagnostics.push(Diagnostic::error(code, span, message));
    }
}
