//! How the files on the desk import each other: where a name with dots leads, and which attributes are one.
//!
//! An attribute of the importing file with the name of an imported one *is* that attribute, unless the import's
//! parentheses hold it back; so whoever renames one has to rename the other.

use crate::ide::Desk;
use crate::ide::document::{Definition, Document, Sort};
use crate::ide::walk::Role;
use crate::syntax::TokenKind;
use crate::world::{World, imported, join};
use std::collections::BTreeSet;
use std::rc::Rc;

impl Desk<'_> {
    /// The file that an import of a document brings, as the world calls it.
    pub(super) fn imported(&self, document: &Document, name: &str) -> Option<String> {
        let import = document.named(name).find(|d| d.sort == Sort::Import)?;
        imported_path(self.world, document, import)
    }

    /// A document and all that it imports, itself first.
    pub(super) fn with_imports(&self, path: &str) -> Vec<Rc<Document>> {
        let (mut found, mut seen, mut open) = (Vec::new(), BTreeSet::new(), vec![path.to_string()]);
        while let Some(path) = open.pop() {
            if !seen.insert(path.clone()) {
                continue;
            }
            let Some(document) = self.document(&path) else { continue };
            open.extend(imports(&document).filter_map(|import| imported_path(self.world, &document, import)));
            found.push(document);
        }
        found
    }

    /// Every file that may use a name of the file at `path`: those the editor knows, and what it imports itself.
    pub(super) fn around(&self, path: &str) -> Vec<Rc<Document>> {
        let mut found = self.with_imports(path);
        let known = self.files.iter().filter_map(|path| self.document(path));
        for document in known.collect::<Vec<_>>() {
            if !found.iter().any(|other| other.path() == document.path()) {
                found.push(document);
            }
        }
        found
    }

    /// The files in which the attribute `name` of the file at `path` is declared as the same attribute.
    pub(super) fn same_attribute(&self, path: &str, name: &str, around: &[Rc<Document>]) -> BTreeSet<String> {
        let edges: Vec<(String, String)> = around.iter().flat_map(|document| shared(self, document, name)).collect();
        let mut found = BTreeSet::from([path.to_string()]);
        loop {
            let before = found.len();
            for (one, other) in &edges {
                if found.contains(one) || found.contains(other) {
                    found.extend([one.clone(), other.clone()]);
                }
            }
            if found.len() == before {
                return found;
            }
        }
    }

    /// The pairs of files, importing and imported, between which an import of the document would make one attribute of
    /// `new` and of what is called `old` in the other of the two.
    pub(super) fn merging(&self, document: &Document, old: &str, new: &str) -> Vec<(String, String)> {
        let mut found = Vec::new();
        for import in imports(document).filter(|import| !is_held(document, import, new)) {
            let path = imported_path(self.world, document, import);
            let Some(inner) = path.and_then(|path| self.document(&path)) else { continue };
            // Where the parentheses hold back the old name, they are renamed too.
            let below = is_given(document, new) && is_taken_over(&inner, old) && !is_held(document, import, old);
            let above = is_given(document, old) && is_taken_over(&inner, new);
            if below || above {
                found.push((document.path().to_string(), inner.path().to_string()));
            }
        }
        found
    }
}

/// The imports of a document.
fn imports(document: &Document) -> impl Iterator<Item = &Definition> {
    document.definitions().iter().filter(|definition| definition.sort == Sort::Import)
}

/// Where an import leads.
pub(super) fn imported_path(world: &dyn World, document: &Document, import: &Definition) -> Option<String> {
    let text = document.text_of(path_token(document, import)?);
    let found = imported(world, document.path(), text).map(|(path, _)| path);
    Some(found.unwrap_or_else(|_| join(document.path(), text)))
}

/// The text of an import that is its path; other definitions have none.
pub(super) fn path_token(document: &Document, import: &Definition) -> Option<usize> {
    let piece = document.pieces.get(import.piece).filter(|_| import.sort == Sort::Import)?;
    let mut tokens = piece.tokens.clone();
    tokens.find(|token| document.kind(*token) == Some(TokenKind::Text))
}

/// The pairs of files between which an import of the document shares the attribute.
fn shared(desk: &Desk, document: &Document, name: &str) -> Vec<(String, String)> {
    if !is_given(document, name) {
        return Vec::new();
    }
    let open = imports(document).filter(|import| !is_held(document, import, name));
    let paths = open.filter_map(|import| imported_path(desk.world, document, import));
    let inner = paths.filter_map(|path| desk.document(&path)).filter(|inner| is_taken_over(inner, name));
    inner.map(|inner| (document.path().to_string(), inner.path().to_string())).collect()
}

/// Whether a document has a value of that name which reaches into its imports.
fn is_given(document: &Document, name: &str) -> bool {
    let reaches = |sort| matches!(sort, Sort::Attribute | Sort::Constant);
    document.named(name).any(|d| reaches(d.sort) && d.params.is_none())
}

/// Whether a document has an attribute of that name, whose place one of an importing file takes.
fn is_taken_over(document: &Document, name: &str) -> bool {
    document.named(name).any(|d| d.sort == Sort::Attribute && d.params.is_none())
}

/// Whether the parentheses of an import keep the attribute apart: they are empty, or name it.
fn is_held(document: &Document, import: &Definition, name: &str) -> bool {
    let Some(after) = path_token(document, import).map(|token| token + 1) else { return false };
    let range = document.pieces[import.piece].tokens.clone();
    if !range.contains(&after) || document.kind(after) != Some(TokenKind::Open) {
        return false;
    }
    let given = document.names.iter().filter(|n| n.piece == import.piece && n.role == Role::Given);
    document.kind(after + 1) == Some(TokenKind::Close) || given.into_iter().any(|n| document.word(n.token) == name)
}
