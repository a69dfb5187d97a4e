//! Rule files → program: names, arguments, kinds of values, imports and lints. Never fails, never stops at the first:
//! what is wrong is reported, and what passes fails later only for geometry.

mod advice;
mod annotations;
mod arrays;
mod bodies;
mod calls;
mod code;
mod dynamic;
mod expressions;
mod modules;
mod names;
mod order;
mod overrides;
mod perimeter;
mod program;
mod reach;
mod styles;
mod words;

pub use code::{Code, Kind, Measure};
pub use program::{
    Alternative, Application, Attribute, Block, Body, Cut, Fresh, Function, Program, Renewed, Rule, Selector, Step,
    Successor, Test, Zone,
};

use crate::diag::Diagnostic;
use crate::syntax::ast::{self, ItemKind};
use crate::world::World;
use modules::{Initial, Loaded};
use names::{Names, Written};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Checks the rule file `path` with everything it imports.
pub fn check(world: &dyn World, path: &str) -> (Program, Vec<Diagnostic>) {
    check_style(world, path, None)
}

/// The same with the definitions of a style of the file: its own first, then those of what it extends.
pub fn check_style(world: &dyn World, path: &str, style: Option<&str>) -> (Program, Vec<Diagnostic>) {
    let loaded = modules::load(world, path, style);
    let (names, rules, functions, repeated) = names::number(&loaded.modules);
    let mut checker = Checker::new(loaded, names, &rules);
    for name in repeated {
        let message = format!("`{}` is defined twice with as many parameters", name.text);
        let hint = "the first definition counts; another number of parameters would overload it";
        checker.tell(Diagnostic::error("defined-twice", name.span, message).hint(hint));
    }
    checker.describe();
    checker.functions(&functions);
    checker.attributes();
    checker.order();
    checker.rules(&rules);
    checker.annotations(&rules);
    checker.finish()
}

/// The work in progress.
struct Checker {
    loaded: Loaded,
    names: Names,
    program: Program,
    symbols: BTreeMap<Arc<str>, u32>,
    diagnostics: Vec<Diagnostic>,
    /// What each function gives, once known.
    function_kinds: Vec<Kind>,
    /// The attribute whose value is read at the moment.
    initialised: Option<u32>,
    /// The module whose names count at the moment.
    module: usize,
    /// The parameters and locals in scope.
    params: Vec<Arc<str>>,
}

impl Checker {
    fn new(mut loaded: Loaded, names: Names, rules: &[Written]) -> Checker {
        let diagnostics = std::mem::take(&mut loaded.diagnostics);
        let mut checker = Checker {
            loaded,
            names,
            program: Program::default(),
            symbols: BTreeMap::new(),
            diagnostics,
            function_kinds: Vec::new(),
            initialised: None,
            module: 0,
            params: Vec::new(),
        };
        for written in rules {
            checker.symbol(&written.rule().name.text);
        }
        checker
    }

    /// The index of a symbol's name.
    fn symbol(&mut self, name: &Arc<str>) -> u32 {
        let bare: Arc<str> = name.rsplit('.').next().unwrap_or(name).into();
        let next = self.program.symbols.len() as u32;
        let symbols = &mut self.program.symbols;
        *self.symbols.entry(bare.clone()).or_insert_with(|| {
            symbols.push(bare);
            next
        })
    }

    fn tell(&mut self, diagnostic: Diagnostic) {
        self.diagnostics.push(diagnostic);
    }

    fn functions(&mut self, functions: &[(usize, Arc<ast::File>, usize)]) {
        self.function_kinds = vec![Kind::Unknown; functions.len()];
        for (index, (module, tree, item)) in functions.iter().enumerate() {
            let ItemKind::Function(function) = &tree.items[*item].kind else { continue };
            self.enter(*module, function.params.as_deref());
            let (value, kind) = self.with_locals(&function.locals, &function.value);
            let slot = self.loaded.modules[*module].slots.get(&function.name.text).copied();
            let (value, kind) = match slot.filter(|_| modules::has_slot(function)) {
                Some(slot) => (Code::Listed(slot, Box::new(value)), Kind::Unknown),
                None => (value, kind),
            };
            self.function_kinds[index] = kind;
            self.program.functions.push(Function {
                name: function.name.text.clone(),
                params: function.params.as_ref().map_or(0, Vec::len),
                height: value.height(),
                value,
                span: function.name.span,
            });
        }
    }

    /// What annotations say of each attribute, before anything is compared with it.
    fn describe(&mut self) {
        let initials = std::mem::take(&mut self.loaded.initials);
        for (slot, initial) in initials.iter().enumerate() {
            let Some((_, tree, Initial::Item(item))) = initial else { continue };
            let annotations = annotations_of(tree, *item);
            annotations::describe(&mut self.loaded.attributes[slot], annotations);
            self.loaded.attributes[slot].context = self.context(annotations);
        }
        self.loaded.initials = initials;
    }

    fn attributes(&mut self) {
        let initials = std::mem::take(&mut self.loaded.initials);
        for (slot, (module, tree, initial)) in initials.iter().enumerate().filter_map(|(i, x)| Some((i, x.as_ref()?))) {
            self.enter(*module, None);
            self.initialised = Some(slot as u32);
            let (value, kind) = match (initial, initial_item(tree, *initial)) {
                (Initial::Item(_), ItemKind::Function(function)) if function.params.is_some() => continue,
                (Initial::Item(_), ItemKind::Function(function)) => self.with_locals(&function.locals, &function.value),
                (Initial::Override(_, number), ItemKind::Import(import)) => {
                    match import.overrides.as_deref().and_then(|o| o.get(*number)) {
                        Some(ast::Override::Attribute(_, expr)) => self.value(expr),
                        _ => continue,
                    }
                }
                _ => continue,
            };
            self.loaded.attributes[slot].initial = value;
            self.loaded.attributes[slot].kind = kind;
        }
        self.initialised = None;
        self.program.attributes = std::mem::take(&mut self.loaded.attributes);
    }

    fn rules(&mut self, rules: &[Written]) {
        for (index, written) in rules.iter().enumerate() {
            let rule = self.rule(written);
            let main = written.is_main();
            if main && rule.params == 0 {
                self.program.starts.push((written.rule().name.text.clone(), index as u32));
            }
            if main && written.rule().mark == Some(ast::RuleMark::Start) {
                self.program.start = Some(index as u32);
            }
            self.program.rules.push(rule);
        }
    }

    fn rule(&mut self, written: &Written) -> Rule {
        let rule = written.rule();
        let symbol = self.symbol(&rule.name.text);
        let body = match rule.spelling {
            ast::Spelling::Paper => self.alternatives(written),
            ast::Spelling::Cga => {
                self.enter(written.module, rule.params.as_deref());
                let locals = self.locals(&rule.locals);
                match (self.body(&rule.body), locals.is_empty()) {
                    (body, true) => body,
                    (body, false) => Body::With(locals, Box::new(body)),
                }
            }
        };
        let (params, names) = (rule.params.as_ref().map_or(0, Vec::len), self.params.clone().into());
        Rule { symbol, params, names, body, span: rule.name.span }
    }

    fn alternatives(&mut self, written: &Written) -> Body {
        let alternatives = written.alternatives().map(|rule| {
            self.enter(written.module, rule.params.as_deref());
            let condition = rule.condition.as_ref().map(|c| self.condition(c));
            let probability = rule.probability.as_ref().map(|p| self.number(p));
            Alternative { condition, probability, body: self.body(&rule.body), span: rule.name.span }
        });
        Body::Alternatives(alternatives.collect())
    }

    /// Sets the names that count in the next body.
    fn enter(&mut self, module: usize, params: Option<&[ast::Name]>) {
        self.module = module;
        self.params = params.unwrap_or_default().iter().map(|p| p.text.clone()).collect();
    }

    /// The locals of a definition; each may use those before it.
    fn locals(&mut self, locals: &[(ast::Name, ast::Expr)]) -> Box<[Code]> {
        let mut codes = Vec::with_capacity(locals.len());
        for (name, expr) in locals {
            codes.push(self.value(expr).0);
            if self.params.contains(&name.text) {
                let message = format!("`{}` is a parameter or a local already", name.text);
                self.tell(Diagnostic::error("defined-twice", name.span, message));
            }
            self.params.push(name.text.clone());
        }
        codes.into()
    }

    fn with_locals(&mut self, locals: &[(ast::Name, ast::Expr)], value: &ast::Expr) -> (Code, Kind) {
        let locals = self.locals(locals);
        let (value, kind) = self.value(value);
        let value = if locals.is_empty() { value } else { Code::With(locals, Box::new(value)) };
        (value, kind)
    }

    fn finish(mut self) -> (Program, Vec<Diagnostic>) {
        self.program.styles =
            self.loaded.styles.first().into_iter().flat_map(|styles| styles.names().cloned()).collect();
        self.program.sources = self.loaded.files.into_iter().map(|(source, _)| source).collect();
        self.diagnostics.sort_by_key(|d| match d.place {
            crate::diag::Place::Rule(span) => (span.file, span.start),
            _ => (0, 0),
        });
        self.diagnostics.dedup();
        (self.program, self.diagnostics)
    }
}

/// The annotations of an attribute; where a style redefines it without any, those of the definition before.
fn annotations_of(tree: &ast::File, item: usize) -> &[ast::Annotation] {
    let ItemKind::Function(own) = &tree.items[item].kind else { return &[] };
    let same = |kind: &ItemKind| matches!(kind, ItemKind::Function(f) if f.name.text == own.name.text);
    let before = tree.items[..item].iter().rev().filter(|i| same(&i.kind));
    let said = std::iter::once(&tree.items[item]).chain(before).find(|i| !i.annotations.is_empty());
    said.map_or(&[], |i| &i.annotations)
}

fn initial_item(tree: &ast::File, initial: Initial) -> &ItemKind {
    match initial {
        Initial::Item(item) | Initial::Override(item, _) => &tree.items[item].kind,
    }
}
