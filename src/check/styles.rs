//! Styles: which definitions of a file count under which style.
//!
//! What stands before the first `style` belongs to `Default`; what follows a `style` belongs to that one, up to the
//! next. A style has what its base has and puts its own definitions in their place. In: the tree of a file. Out: the
//! items that count, in the order of the text.

use crate::diag::Diagnostic;
use crate::syntax::ast::{self, File, ItemKind, Name};
use crate::text::nearest;
use std::collections::BTreeMap;
use std::sync::Arc;

/// The style that every file has.
pub(super) const DEFAULT: &str = "Default";

/// The styles of a file.
pub(super) struct Styles {
    /// `Default` is the first.
    styles: Vec<Style>,
    /// The style of each item; none for what defines nothing.
    owners: Vec<Option<usize>>,
    /// What is wrong with them.
    pub diagnostics: Vec<Diagnostic>,
}

struct Style {
    name: Arc<str>,
    /// The style it extends; itself for `Default`.
    base: usize,
}

/// What a definition puts in the place of its base's: what it is, its name, how many parameters it has.
type Key<'a> = (u8, &'a str, usize);

impl Styles {
    /// The styles of a tree, each name once. Cost: linear, times the logarithm of the styles.
    pub fn of(tree: &File) -> Styles {
        let default = Style { name: DEFAULT.into(), base: 0 };
        let mut styles = Styles { styles: vec![default], owners: Vec::new(), diagnostics: Vec::new() };
        let mut bases: Vec<(usize, &Name)> = Vec::new();
        let mut current = 0;
        for item in &tree.items {
            if let ItemKind::Style { name, base } = &item.kind {
                current = styles.begin(name);
                bases.extend(base.iter().map(|base| (current, base)));
            }
            styles.owners.push(key(&item.kind).map(|_| current));
        }
        bases.into_iter().for_each(|(style, base)| styles.extend(style, base));
        styles.extensions(tree);
        styles
    }

    /// The names beside `Default`.
    pub fn names(&self) -> impl Iterator<Item = &Arc<str>> {
        self.styles.iter().skip(1).map(|style| &style.name)
    }

    /// The style of that name.
    pub fn find(&self, name: &str) -> Option<usize> {
        self.styles.iter().position(|style| &*style.name == name)
    }

    /// The items that count under a style: of those that define the same thing, those of the style nearest to it.
    pub fn items(&self, tree: &File, style: usize) -> Vec<usize> {
        let mut ranks: Vec<Option<usize>> = vec![None; self.styles.len()];
        self.chain(style).into_iter().enumerate().for_each(|(rank, style)| ranks[style] = Some(rank));
        let rank = |item: usize| ranks[self.owners[item]?];
        let mut nearest: BTreeMap<Key, usize> = BTreeMap::new();
        for (item, definition) in tree.items.iter().enumerate() {
            if let Some((key, rank)) = key(&definition.kind).zip(rank(item)) {
                nearest.entry(key).and_modify(|least| *least = rank.min(*least)).or_insert(rank);
            }
        }
        let counts =
            |item: &usize| key(&tree.items[*item].kind).is_some_and(|k| rank(*item) == nearest.get(&k).copied());
        (0..tree.items.len()).filter(|item| rank(*item).is_some()).filter(counts).collect()
    }

    /// Whether an item stands in `Default`.
    pub fn is_default(&self, item: usize) -> bool {
        self.owners[item] == Some(0)
    }

    /// Advice where a name is no style: a near one, and which there are.
    pub fn advise(&self, diagnostic: Diagnostic, name: &str) -> Diagnostic {
        let near = nearest(name, self.styles.iter().map(|style| &*style.name));
        let all: Vec<String> = self.styles.iter().map(|style| format!("`{}`", style.name)).collect();
        diagnostic.did_you_mean(near).hint(format!("the file has {}", all.join(", ")))
    }

    /// A style begins; its index. Stated a second time it goes on.
    fn begin(&mut self, name: &Name) -> usize {
        if let Some(known) = self.find(&name.text) {
            let message = format!("the style `{}` is there already", name.text);
            self.diagnostics.push(Diagnostic::error("defined-twice", name.span, message));
            return known;
        }
        self.styles.push(Style { name: name.text.clone(), base: 0 });
        self.styles.len() - 1
    }

    fn extend(&mut self, style: usize, base: &Name) {
        let Some(index) = self.find(&base.text) else {
            let diagnostic = Diagnostic::error("unknown-name", base.span, format!("there is no style `{}`", base.text));
            let advised = self.advise(diagnostic, &base.text);
            return self.diagnostics.push(advised);
        };
        if self.chain(index).contains(&style) {
            let message = format!("the style `{}` extends itself", self.styles[style].name);
            return self.diagnostics.push(Diagnostic::error("style-cycle", base.span, message));
        }
        self.styles[style].base = index;
    }

    /// A style and those it extends, down to `Default`.
    fn chain(&self, style: usize) -> Vec<usize> {
        let next = |style: &usize| (*style > 0).then(|| self.styles[*style].base);
        std::iter::successors(Some(style), next).collect()
    }

    /// `extension` rules stand in `Default`, one for each name.
    fn extensions(&mut self, tree: &File) {
        let mut known: BTreeMap<&str, usize> = BTreeMap::new();
        for (item, definition) in tree.items.iter().enumerate() {
            let ItemKind::Rule(rule) = &definition.kind else { continue };
            let marked = rule.mark == Some(ast::RuleMark::Extension);
            if marked && !self.is_default(item) {
                let message = format!("the `extension` rule `{}` stands in a style of its own", rule.name.text);
                let hint =
                    "an `extension` rule stands before the first `style`; a style may redefine it without the word";
                self.diagnostics.push(Diagnostic::error("extension", rule.name.span, message).hint(hint));
            }
            if marked && known.insert(&rule.name.text, item).is_some() {
                let message = format!("there are two `extension` rules `{}`", rule.name.text);
                let hint =
                    "an `extension` rule has one form: whoever replaces it must know how many arguments it takes";
                self.diagnostics.push(Diagnostic::error("extension", rule.name.span, message).hint(hint));
            }
        }
    }
}

fn key(kind: &ItemKind) -> Option<Key<'_>> {
    let count = |params: &Option<Vec<Name>>| params.as_ref().map_or(0, Vec::len);
    match kind {
        ItemKind::Rule(rule) => Some((0, &rule.name.text, count(&rule.params))),
        ItemKind::Function(function) => Some((1, &function.name.text, count(&function.params))),
        ItemKind::Import(import) => Some((2, &import.name.text, 0)),
        ItemKind::Style { .. } | ItemKind::Nothing => None,
    }
}
