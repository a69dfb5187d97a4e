//! Rule files → program: names, arguments, kinds of values, imports and lints. Never fails, never stops at the first:
//! what is wrong is reported, and what passes fails later only for geometry.

mod annotations;
mod bodies;
mod calls;
mod expressions;
mod modules;
mod names;
mod program;
mod reach;
mod words;

pub use program::{
    Alternative, Application, Attribute, Block, Body, Code, Cut, Function, Kind, Program, Rule, Selector, Step,
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
    let loaded = modules::load(world, path);
    let (names, rules, functions, repeated) = names::number(&loaded.modules);
    let mut checker = Checker::new(loaded, names, &rules);
    for name in repeated {
        let message = format!("`{}` is defined twice with as many parameters", name.text);
        let hint = "the first definition counts; another number of parameters would overload it";
        checker.tell(Diagnostic::error("defined-twice", name.span, message).hint(hint));
    }
    checker.functions(&functions);
    checker.attributes();
    checker.rules(&rules);
    checker.annotations(&rules);
    checker.order();
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
    /// What each slot holds, once known.
    slot_kinds: Vec<Kind>,
    /// The module whose names count at the moment.
    module: usize,
    /// The parameters and locals in scope.
    params: Vec<Arc<str>>,
}

impl Checker {
    fn new(mut loaded: Loaded, names: Names, rules: &[Written]) -> Checker {
        let diagnostics = std::mem::take(&mut loaded.diagnostics);
        let mut checker = Checker {
            slot_kinds: vec![Kind::Unknown; loaded.attributes.len()],
            loaded,
            names,
            program: Program::default(),
            symbols: BTreeMap::new(),
            diagnostics,
            function_kinds: Vec::new(),
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
            self.enter(*module, function.params.as_deref(), &function.locals);
            let (value, kind) = self.value(&function.value);
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

    fn attributes(&mut self) {
        let initials = std::mem::take(&mut self.loaded.initials);
        for (slot, (module, tree, initial)) in initials.iter().enumerate().filter_map(|(i, x)| Some((i, x.as_ref()?))) {
            let expr = match (initial, initial_item(tree, *initial)) {
                (Initial::Item(_), ItemKind::Function(function)) => &function.value,
                (Initial::Override(_, number), ItemKind::Import(import)) => {
                    match import.overrides.as_deref().and_then(|o| o.get(*number)) {
                        Some(ast::Override::Attribute(_, expr)) => expr,
                        _ => continue,
                    }
                }
                _ => continue,
            };
            if let (Initial::Item(_), ItemKind::Function(function)) = (initial, initial_item(tree, *initial)) {
                self.enter(*module, None, &function.locals);
            } else {
                self.enter(*module, None, &[]);
            }
            let (value, kind) = self.value(expr);
            self.loaded.attributes[slot].initial = value;
            self.loaded.attributes[slot].kind = kind;
            self.slot_kinds[slot] = kind;
            if let Initial::Item(item) = initial {
                let annotations = &tree.items[*item].annotations;
                annotations::describe(&mut self.loaded.attributes[slot], annotations);
                self.loaded.attributes[slot].context = self.context(annotations);
            }
        }
        self.program.attributes = std::mem::take(&mut self.loaded.attributes);
    }

    fn rules(&mut self, rules: &[Written]) {
        for (index, written) in rules.iter().enumerate() {
            let rule = self.rule(written);
            let main = written.module == 0 && written.given.is_none();
            if main && rule.params == 0 {
                self.program.starts.push((written.rule().name.text.clone(), index as u32));
            }
            if main && written.rule().mark == Some(ast::RuleMark::Start) {
                self.program.start = Some(index as u32);
            }
            self.program.rules.push(rule);
        }
    }

    /// One rule, or the one that an importer puts in its place.
    fn rule(&mut self, written: &Written) -> Rule {
        let own = written.rule();
        let key = (own.name.text.clone(), own.params.as_ref().map_or(0, Vec::len));
        let replaced = self.loaded.modules[written.module].replaced.get(&key).copied();
        let symbol = self.symbol(&own.name.text);
        let written = match replaced {
            Some((module, item, given)) => {
                let tree = self.loaded.modules[module].tree.clone();
                &Written { module, tree, item, given, more: Vec::new() }
            }
            None => written,
        };
        let rule = written.rule();
        let body = match rule.spelling {
            ast::Spelling::Paper => self.alternatives(written),
            ast::Spelling::Cga => {
                self.enter(written.module, rule.params.as_deref(), &rule.locals);
                self.body(&rule.body)
            }
        };
        let (params, names) = (rule.params.as_ref().map_or(0, Vec::len), self.params.clone().into());
        Rule { symbol, params, names, body, span: rule.name.span }
    }

    fn alternatives(&mut self, written: &Written) -> Body {
        let alternatives = written.alternatives().map(|rule| {
            self.enter(written.module, rule.params.as_deref(), &rule.locals);
            let condition = rule.condition.as_ref().map(|c| self.condition(c));
            let probability = rule.probability.as_ref().map(|p| self.number(p));
            Alternative { condition, probability, body: self.body(&rule.body), span: rule.name.span }
        });
        Body::Alternatives(alternatives.collect())
    }

    /// Sets the names that count in the next body.
    fn enter(&mut self, module: usize, params: Option<&[ast::Name]>, locals: &[(ast::Name, ast::Expr)]) {
        self.module = module;
        let names = params.unwrap_or_default().iter().chain(locals.iter().map(|(name, _)| name));
        self.params = names.map(|p| p.text.clone()).collect();
        if let Some((name, _)) = locals.first() {
            let message = "`with` is parsed, but not derived yet";
            self.tell(Diagnostic::error("unbuilt", name.span, message).hint("a parameter or a function does the same"));
        }
    }

    fn finish(mut self) -> (Program, Vec<Diagnostic>) {
        self.program.sources = self.loaded.files.into_iter().map(|(source, _)| source).collect();
        self.diagnostics.sort_by_key(|d| match d.place {
            crate::diag::Place::Rule(span) => (span.file, span.start),
            _ => (0, 0),
        });
        self.diagnostics.dedup();
        (self.program, self.diagnostics)
    }
}

fn initial_item(tree: &ast::File, initial: Initial) -> &ItemKind {
    match initial {
        Initial::Item(item) | Initial::Override(item, _) => &tree.items[item].kind,
    }
}
