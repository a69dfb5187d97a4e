//! Which rule, function or attribute a name means in a module, and what is near it where it means nothing.

use crate::check::modules::Module;
use crate::syntax::ast::{self, FunctionKind, ItemKind};
use std::collections::BTreeMap;
use std::sync::Arc;

/// The rules and functions of every module by name and number of parameters.
#[derive(Default)]
pub(super) struct Names {
    /// Per module.
    pub rules: Vec<BTreeMap<(Arc<str>, usize), u32>>,
    /// Per module.
    pub functions: Vec<BTreeMap<(Arc<str>, usize), u32>>,
}

/// Where a rule or function is written.
#[derive(Clone)]
pub(super) struct Written {
    /// The module whose names its body uses.
    pub module: usize,
    /// The tree that holds it.
    pub tree: Arc<ast::File>,
    /// The item.
    pub item: usize,
    /// The override of that import item, for extension rules.
    pub given: Option<usize>,
    /// Every further item with the same predecessor in the papers' notation.
    pub more: Vec<usize>,
}

impl Written {
    /// The rule.
    pub fn rule(&self) -> &ast::Rule {
        rule_at(&self.tree, self.item, self.given)
    }

    /// The rule and its further alternatives.
    pub fn alternatives(&self) -> impl Iterator<Item = &ast::Rule> {
        std::iter::once(self.rule()).chain(self.more.iter().map(|item| rule_at(&self.tree, *item, None)))
    }

    /// Whether it is a rule of the main file itself, so that a region may begin with it.
    pub fn is_main(&self) -> bool {
        self.module == 0 && self.given.is_none() && !self.rule().name.text.contains('.')
    }

    /// The annotations before it.
    pub fn annotations(&self) -> &[ast::Annotation] {
        match self.given {
            None => &self.tree.items[self.item].annotations,
            Some(_) => &[],
        }
    }
}

/// The rule of an item, or of an override of an import.
pub(super) fn rule_at(tree: &ast::File, item: usize, given: Option<usize>) -> &ast::Rule {
    match (&tree.items[item].kind, given) {
        (ItemKind::Rule(rule), None) => rule,
        (ItemKind::Import(import), Some(number)) => match import.overrides.as_deref().and_then(|o| o.get(number)) {
            Some(ast::Override::Rule(rule)) => rule,
            _ => unreachable!("the loader stored an override that is a rule"),
        },
        _ => unreachable!("the loader stored an item that is a rule"),
    }
}

/// A definition that was given twice: the later name.
pub(super) type Repeated = ast::Name;

/// Where a function is written: its module, tree and item.
pub(super) type Definition = (usize, Arc<ast::File>, usize);

/// Numbers every rule and function of every module; names given twice come back.
pub(super) fn number(modules: &[Module]) -> (Names, Vec<Written>, Vec<Definition>, Vec<Repeated>) {
    let (mut names, mut rules, mut functions, mut repeated) = (Names::default(), Vec::new(), Vec::new(), Vec::new());
    for (index, module) in modules.iter().enumerate() {
        names.rules.push(number_rules(modules, index, &mut rules, &mut repeated));
        names.functions.push(number_functions(index, module, &mut functions, &mut repeated));
    }
    (names, rules, functions, repeated)
}

fn number_rules(
    modules: &[Module],
    index: usize,
    rules: &mut Vec<Written>,
    repeated: &mut Vec<Repeated>,
) -> BTreeMap<(Arc<str>, usize), u32> {
    let module = &modules[index];
    let mut known: BTreeMap<(Arc<str>, usize), u32> = BTreeMap::new();
    for item in module.items.iter().copied() {
        let ItemKind::Rule(rule) = &module.tree.items[item].kind else { continue };
        let key = (rule.name.text.clone(), rule.params.as_ref().map_or(0, Vec::len));
        if rule.name.text.contains('.') || module.replaced.contains_key(&key) {
            continue;
        }
        match known.get(&key) {
            Some(first) if both_papers(rules[*first as usize].rule(), rule) => rules[*first as usize].more.push(item),
            Some(_) => repeated.push(rule.name.clone()),
            None => {
                known.insert(key, rules.len() as u32);
                rules.push(Written { module: index, tree: module.tree.clone(), item, given: None, more: Vec::new() });
            }
        }
    }
    for (key, (outer, item, given)) in &module.replaced {
        known.insert(key.clone(), rules.len() as u32);
        let tree = modules[*outer].tree.clone();
        rules.push(Written { module: *outer, tree, item: *item, given: *given, more: Vec::new() });
    }
    known
}

/// Several rules with one predecessor are alternatives in the papers' notation, and a mistake in CityEngine's.
fn both_papers(first: &ast::Rule, second: &ast::Rule) -> bool {
    let paper = |rule: &ast::Rule| matches!(rule.spelling, ast::Spelling::Paper);
    paper(first) && paper(second)
}

fn number_functions(
    index: usize,
    module: &Module,
    functions: &mut Vec<Definition>,
    repeated: &mut Vec<Repeated>,
) -> BTreeMap<(Arc<str>, usize), u32> {
    let mut known = BTreeMap::new();
    for item in module.items.iter().copied() {
        let ItemKind::Function(function) = &module.tree.items[item].kind else { continue };
        if function.kind != FunctionKind::Function && function.params.is_none() {
            continue;
        }
        let key = (function.name.text.clone(), function.params.as_ref().map_or(0, Vec::len));
        if known.insert(key, functions.len() as u32).is_some() {
            repeated.push(function.name.clone());
        }
        functions.push((index, module.tree.clone(), item));
    }
    known
}
