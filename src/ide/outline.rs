//! The outline of a file: what it defines, in order.

use crate::ide::Desk;
use crate::ide::document::Sort;
use crate::ide::page;
use std::ops::Range;

/// An entry of the outline.
#[derive(Clone, Debug, PartialEq)]
pub struct Symbol {
    /// The name.
    pub name: String,
    /// Its parameters or value, in short.
    pub detail: String,
    /// What it is.
    pub sort: Sort,
    /// From its first annotation to its end; of a style, to the end of what belongs to it.
    pub whole: Range<usize>,
    /// Its name.
    pub at: Range<usize>,
    /// What belongs to a style.
    pub inside: Vec<Symbol>,
}

impl Desk<'_> {
    /// The outline of a file; definitions after a style stand inside it.
    pub fn symbols(&self, path: &str) -> Vec<Symbol> {
        let Some(document) = self.document(path) else { return Vec::new() };
        let mut found: Vec<Symbol> = Vec::new();
        for definition in document.definitions() {
            let symbol = Symbol {
                name: definition.name.clone(),
                detail: page::head(&document, definition),
                sort: definition.sort,
                whole: definition.whole.clone(),
                at: definition.at.clone(),
                inside: Vec::new(),
            };
            match found.last_mut().filter(|last| last.sort == Sort::Style && symbol.sort != Sort::Style) {
                Some(style) => {
                    style.whole.end = symbol.whole.end;
                    style.inside.push(symbol);
                }
                None => found.push(symbol),
            }
        }
        found
    }
}
