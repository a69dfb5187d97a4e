//! pest's tree → the syntax tree, one piece of a file at a time.
//!
//! The grammar has settled what is right; what it leaves to be checked here are a few things about shape (an argument's
//! name must be a bare name, sizes and parts must agree in number). Every function gives `None` only where grammar and
//! builder disagree, which no text should bring about. The recursion is as deep as the tree, whose height the caller
//! has bounded ([`MAX_HEIGHT`](super::depth::MAX_HEIGHT)).

mod block;
mod body;
mod define;
mod value;

use super::ast::{Name, Text};
use super::grammar::{Pair, Rule};
use crate::diag::{Diagnostic, Span};
use std::cell::{Cell, RefCell};
use std::collections::HashMap;
use std::sync::Arc;

/// Builds the pieces of one file.
pub(super) struct Builder<'t> {
    file: u16,
    /// Where the piece under way begins in the file; pest counts from there.
    offset: Cell<u32>,
    /// Each name of the file once.
    names: RefCell<HashMap<&'t str, Arc<str>>>,
    /// What is wrong with the piece under way.
    reports: RefCell<Vec<Diagnostic>>,
    /// The papers' names that this file has rules for, which therefore are not the papers' operations.
    own: Vec<&'t str>,
}

impl<'t> Builder<'t> {
    /// A builder for the file with this number; `own` are the papers' names it defines itself.
    pub fn new(file: u16, own: Vec<&'t str>) -> Builder<'t> {
        Builder { file, offset: Cell::new(0), names: RefCell::default(), reports: RefCell::default(), own }
    }

    /// Builds the piece that begins at `offset` by `build`; its errors are `Err`, and lints come with either.
    pub fn piece<T>(&self, offset: u32, build: impl FnOnce(&Self) -> Option<T>) -> (Option<T>, Vec<Diagnostic>) {
        self.offset.set(offset);
        let built = build(self);
        let mut reports = self.reports.take();
        if built.is_none() && reports.is_empty() {
            let span = Span { file: self.file, start: offset, end: offset };
            reports.push(Diagnostic::error("syntax", span, "this definition cannot be read"));
        }
        let broken = reports.iter().any(Diagnostic::is_error);
        (built.filter(|_| !broken), reports)
    }

    /// Whether the file has a rule of its own by this name.
    pub(super) fn is_own(&self, name: &str) -> bool {
        self.own.contains(&name)
    }

    pub(super) fn report(&self, diagnostic: Diagnostic) {
        self.reports.borrow_mut().push(diagnostic);
    }

    /// The place of a node. pest lets a node that ends in an optional part run on over blanks; they are cut off.
    fn span(&self, pair: &Pair<'t>) -> Span {
        let span = pair.as_span();
        let start = self.offset.get() + span.start() as u32;
        Span { file: self.file, start, end: start + span.as_str().trim_end().len() as u32 }
    }

    fn name(&self, pair: &Pair<'t>) -> Name {
        Name { text: self.intern(pair.as_str()), span: self.span(pair) }
    }

    /// The one shared copy of a name.
    pub(super) fn intern(&self, name: &'t str) -> Arc<str> {
        self.names.borrow_mut().entry(name).or_insert_with(|| name.into()).clone()
    }

    fn text(&self, pair: &Pair<'t>) -> Text {
        Text { text: unescaped(pair.as_str()), span: self.span(pair) }
    }

    fn names(&self, pair: Pair<'t>) -> Vec<Name> {
        pair.into_inner().map(|name| self.name(&name)).collect()
    }
}

/// A text literal without its quotes, escapes resolved; a backslash before anything else stands for itself.
fn unescaped(literal: &str) -> Arc<str> {
    let inner = literal.get(1..literal.len() - 1).unwrap_or("");
    if !inner.contains('\\') {
        return inner.into();
    }
    let mut text = String::with_capacity(inner.len());
    let mut characters = inner.chars();
    while let Some(character) = characters.next() {
        match (character, characters.clone().next()) {
            ('\\', Some(escape @ ('n' | 't' | 'r' | '"' | '\\'))) => {
                characters.next();
                text.push(match escape {
                    'n' => '\n',
                    't' => '\t',
                    'r' => '\r',
                    other => other,
                });
            }
            _ => text.push(character),
        }
    }
    text.into()
}

/// The next node, if it is of this rule.
fn next_if<'t>(pairs: &mut pest::iterators::Pairs<'t, Rule>, rule: Rule) -> Option<Pair<'t>> {
    match pairs.peek() {
        Some(pair) if pair.as_rule() == rule => pairs.next(),
        _ => None,
    }
}
