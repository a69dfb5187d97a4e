//! Dynamic imports: `import(name = value).Rule` calls a rule with the import's attributes found anew.

use crate::check::code::{Code, Kind};
use crate::check::program::{Fresh, Renewed, Step};
use crate::check::{Checker, modules, order};
use crate::diag::Diagnostic;
use crate::syntax::ast::{Call, ItemKind, Name, Override};
use std::collections::{BTreeMap, BTreeSet};

impl Checker {
    /// A call of a rule of an import, its attributes found anew.
    pub(super) fn dynamic(&mut self, import: &Name, overrides: &[Override], call: &Call) -> Option<Step> {
        let own = &self.loaded.modules[self.module];
        let Some(inner) = own.imports.get(&import.text).copied() else {
            if !own.missing.contains(&import.text) {
                self.no_import(import);
            }
            return None;
        };
        let name = Name { text: format!("{}.{}", import.text, call.name.text).into(), ..call.name.clone() };
        let call = Call { name, ..call.clone() };
        let Some(rule) = self.rule_named(&call.name.text, call.args.len()) else { return self.stranger(&call) };
        let fresh = self.fresh(inner, overrides);
        match self.successor(&call, Some(rule)) {
            Step::Successor(successor) => {
                Some(Step::Successor(crate::check::Successor { fresh: Some(Box::new(fresh)), ..successor }))
            }
            other => Some(other),
        }
    }

    fn no_import(&mut self, import: &Name) {
        let imports = self.loaded.modules[self.module].imports.keys().map(|k| &**k);
        let near = crate::text::nearest(&import.text, imports);
        let message = format!("there is no import `{}`", import.text);
        let diagnostic = Diagnostic::error("unknown-name", import.span, message).did_you_mean(near);
        self.tell(diagnostic.hint("`import(name = value).Rule` calls a rule of an import with attributes of its own"));
    }

    /// What the parentheses give, and all else that the import and its own imports have.
    fn fresh(&mut self, inner: usize, overrides: &[Override]) -> Fresh {
        let (mut given, mut protected) = (Vec::new(), BTreeMap::new());
        for change in overrides {
            match change {
                Override::Attribute(name, expr) => {
                    let code = self.value(expr).0;
                    given.extend(self.slot_in(inner, name).map(|slot| (slot, code)));
                }
                Override::Protect(name) => {
                    if let Some(slot) = self.slot_in(inner, name) {
                        protected.extend(self.own_value(inner, &name.text).map(|(code, _)| (slot, code)));
                    }
                }
                Override::Rule(rule) => {
                    let message = format!("`{}` cannot be replaced for one call", rule.name.text);
                    let hint =
                        "import the file once more under another name, and replace the rule in those parentheses";
                    self.tell(Diagnostic::error("extension", rule.name.span, message).hint(hint));
                }
            }
        }
        let anew = self.renewed(inner, &given, protected);
        Fresh { given: given.into(), anew }
    }

    /// All slots that came with an import or are protected, but those that are given, in their order.
    fn renewed(&self, inner: usize, given: &[(u32, Code)], protected: BTreeMap<u32, Code>) -> Box<[(u32, Renewed)]> {
        let own = self.loaded.modules[inner].own.clone();
        let taken: BTreeSet<u32> = given.iter().map(|(slot, _)| *slot).collect();
        let all: BTreeSet<u32> = own.chain(protected.keys().copied()).filter(|slot| !taken.contains(slot)).collect();
        let initial = |slot: u32| &self.program.attributes[slot as usize].initial;
        let codes: Vec<(u32, &Code)> =
            all.iter().map(|slot| (*slot, protected.get(slot).unwrap_or_else(|| initial(*slot)))).collect();
        let (order, _) = order::ordered(&self.program, &codes);
        let renewed =
            |slot: u32| protected.get(&slot).map_or(Renewed::Initial, |code| Renewed::Protected(code.clone()));
        order.into_iter().map(|slot| (slot, renewed(slot))).collect()
    }

    fn slot_in(&mut self, inner: usize, name: &Name) -> Option<u32> {
        let slot = self.loaded.modules[inner].slots.get(&name.text).copied();
        if slot.is_none() {
            self.loaded.unknown_attribute(inner, name);
            self.diagnostics.append(&mut self.loaded.diagnostics);
        }
        slot
    }

    /// The import's own expression of an attribute that the importer shares.
    pub(super) fn own_value(&mut self, inner: usize, name: &str) -> Option<(Code, Kind)> {
        let tree = self.loaded.modules[inner].tree.clone();
        let items = self.loaded.modules[inner].items.clone();
        let function = items.into_iter().find_map(|item| match &tree.items[item].kind {
            ItemKind::Function(f) if &*f.name.text == name && modules::has_slot(f) => Some(f),
            _ => None,
        })?;
        let (module, params) = (self.module, std::mem::take(&mut self.params));
        self.enter(inner, None);
        let value = self.with_locals(&function.locals, &function.value);
        (self.module, self.params) = (module, params);
        Some(value)
    }
}
