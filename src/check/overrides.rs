//! What an importer changes in what it imports: attributes it protects or gives a value, rules it puts in place of the
//! file's own.

use crate::check::modules::{Initial, Loaded};
use crate::diag::Diagnostic;
use crate::syntax::ast::{self, ItemKind, Name, RuleMark};
use crate::text::nearest;
use std::sync::Arc;

impl Loaded {
    /// The parentheses of an import.
    pub(super) fn override_all(&mut self, module: usize, item: usize, import: &ast::Import, inner: usize) {
        for (number, given) in import.overrides.iter().flatten().enumerate() {
            match given {
                ast::Override::Attribute(name, _) => self.override_attribute(module, (item, number), name, inner),
                ast::Override::Protect(name) if !self.modules[inner].slots.contains_key(&name.text) => {
                    self.unknown_attribute(inner, name);
                }
                ast::Override::Protect(_) => {}
                ast::Override::Rule(rule) => self.override_rule(module, (item, number), rule, inner),
            }
        }
    }

    fn override_attribute(&mut self, module: usize, (item, number): (usize, usize), name: &Name, inner: usize) {
        let Some(slot) = self.modules[inner].slots.get(&name.text).copied() else {
            return self.unknown_attribute(inner, name);
        };
        if self.is_styled(inner, |kind| matches!(kind, ItemKind::Function(f) if f.name.text == name.text)) {
            return self.styled(name);
        }
        let tree = self.modules[module].tree.clone();
        self.initials[slot as usize] = Some((module, tree, Initial::Override(item, number)));
        self.attributes[slot as usize].public = false;
    }

    /// `(Trunk --> …)`: any rule can be replaced, but only an `extension` rule says that it is meant to be.
    fn override_rule(&mut self, module: usize, (item, number): (usize, usize), rule: &ast::Rule, inner: usize) {
        let count = rule.params.as_ref().map_or(0, Vec::len);
        let found = self.rules_of(inner).find(|own| own.name.text == rule.name.text && count_of(own) == count);
        let mark = found.map(|own| own.mark);
        match mark {
            None => return self.unknown_rule(inner, rule),
            Some(Some(RuleMark::Extension)) => {}
            Some(_) => {
                let message = format!("`{}` is not marked `extension` in its file", rule.name.text);
                let hint = format!("`extension {} --> …` there says that importers may replace it", rule.name.text);
                self.diagnostics.push(Diagnostic::lint("extension", rule.name.span, message).hint(hint));
            }
        }
        if self.is_styled(inner, |kind| matches!(kind, ItemKind::Rule(r) if r.name.text == rule.name.text)) {
            return self.styled(&rule.name);
        }
        let key = (rule.name.text.clone(), count);
        self.modules[inner].replaced.insert(key, (module, item, Some(number)));
    }

    /// `import.Rule --> …` puts a rule in place of an imported one, or gives a rule to a leaf of it.
    pub(super) fn replace_rules(&mut self, module: usize) {
        let tree = self.modules[module].tree.clone();
        for item in self.modules[module].items.clone() {
            let ItemKind::Rule(rule) = &tree.items[item].kind else { continue };
            let Some((import, name)) = rule.name.text.split_once('.') else { continue };
            match self.modules[module].imports.get(import).copied() {
                Some(inner) => {
                    let key: (Arc<str>, usize) = (name.into(), count_of(rule));
                    self.modules[inner].replaced.insert(key, (module, item, None));
                }
                None if self.modules[module].missing.contains(import) => {}
                None => self.error("unknown-name", rule.name.span, format!("there is no import `{import}`")),
            }
        }
    }

    /// The rules of a module that count under its style.
    fn rules_of(&self, module: usize) -> impl Iterator<Item = &ast::Rule> {
        let module = &self.modules[module];
        module.items.iter().filter_map(|item| match &module.tree.items[*item].kind {
            ItemKind::Rule(rule) => Some(rule),
            _ => None,
        })
    }

    /// Whether the definition that counts stands in a style of the file.
    fn is_styled(&self, module: usize, is_meant: impl Fn(&ItemKind) -> bool) -> bool {
        let module = &self.modules[module];
        let styles = &self.styles[module.file as usize];
        let found = module.items.iter().find(|item| is_meant(&module.tree.items[**item].kind));
        found.is_some_and(|item| !styles.is_default(*item))
    }

    fn styled(&mut self, name: &Name) {
        let message = format!("`{}` is redefined by the style that is imported: that definition counts", name.text);
        let hint = "an importer changes what stands in the style `Default`";
        self.diagnostics.push(Diagnostic::lint("style", name.span, message).hint(hint));
    }

    fn unknown_rule(&mut self, inner: usize, rule: &ast::Rule) {
        let file = self.files[self.modules[inner].file as usize].0.path();
        let name = &rule.name.text;
        let others: Vec<String> = self
            .rules_of(inner)
            .filter(|own| own.name.text == *name)
            .map(|own| crate::text::counted(count_of(own), "argument"))
            .collect();
        let message = match others.is_empty() {
            true => format!("`{file}` has no rule `{name}` to replace"),
            false => {
                let found = crate::text::counted(count_of(rule), "parameter");
                format!("`{name}` of `{file}` takes {}, found {found}", others.join(" or "))
            }
        };
        let near = nearest(name, self.rules_of(inner).map(|own| &*own.name.text)).filter(|_| others.is_empty());
        let diagnostic = Diagnostic::error("extension", rule.name.span, message).did_you_mean(near);
        self.diagnostics.push(diagnostic);
    }

    /// Says that a file has no attribute of a name.
    pub(super) fn unknown_attribute(&mut self, inner: usize, name: &Name) {
        let file = self.files[self.modules[inner].file as usize].0.path();
        let near = nearest(&name.text, self.modules[inner].slots.keys().map(|k| &**k));
        let message = format!("`{file}` has no attribute `{}`", name.text);
        let diagnostic = Diagnostic::error("unknown-name", name.span, message).did_you_mean(near);
        self.diagnostics.push(diagnostic);
    }
}

fn count_of(rule: &ast::Rule) -> usize {
    rule.params.as_ref().map_or(0, Vec::len)
}
