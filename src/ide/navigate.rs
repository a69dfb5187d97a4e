//! Where a name is defined, and where it is used.

use crate::ide::document::Document;
use crate::ide::identity::{Class, Identity};
use crate::ide::imports::{imported_path, path_token};
use crate::ide::{Desk, Place};
use crate::syntax::TokenKind;
use std::collections::BTreeSet;
use std::rc::Rc;

impl Desk<'_> {
    /// Where what stands at a byte is defined: several places for overloads and alternatives, the beginning of the file
    /// for the path of an import. Of overloads, those with as many parameters as the use has arguments, if there are any.
    pub fn definition(&self, path: &str, offset: usize) -> Vec<Place> {
        let Some(document) = self.document(path) else { return Vec::new() };
        if let Some(file) = self.import_at(&document, offset) {
            return vec![Place::new(&file, 0..0)];
        }
        let Some((place, identity)) = self.identity_at(path, offset) else { return Vec::new() };
        let declared = self.declared(&identity);
        let wanted = arguments(&document, place.end);
        let fits = |document: &Document, at: usize| {
            let found = document.definitions().iter().find(|d| d.at.start == at);
            found.is_some_and(|d| d.params.as_ref().map_or(0, Vec::len) == wanted)
        };
        let any = declared.iter().any(|(document, range)| fits(document, range.start));
        let kept = declared.into_iter().filter(|(document, range)| !any || fits(document, range.start));
        kept.map(|(document, range)| Place::new(document.path(), range)).collect()
    }

    /// Every place in the known files where what stands at a byte is written, its definitions among them.
    ///
    /// Attributes of importing and imported files that are one attribute are taken together. Cost: linear in the texts of
    /// all files.
    pub fn references(&self, path: &str, offset: usize) -> Vec<Place> {
        let Some((_, identity)) = self.identity_at(path, offset) else { return Vec::new() };
        self.uses(&identity)
    }

    /// Every place where an identity, or one that is the same attribute, is written.
    pub(super) fn uses(&self, identity: &Identity) -> Vec<Place> {
        let around = self.around(identity.path());
        let wanted = self.equals(identity, &around);
        let mut found = BTreeSet::new();
        for document in &around {
            for name in document.names.iter().filter(|n| document.word(n.token).contains(identity.name())) {
                let same = self.segments(document, name).into_iter();
                let same = same.filter(|s| s.identity.as_ref().is_some_and(|identity| wanted.contains(identity)));
                found.extend(same.map(|segment| Place::new(document.path(), segment.range)));
            }
        }
        found.into_iter().collect()
    }

    /// The identity, and the same attribute in other files.
    pub(super) fn equals(&self, identity: &Identity, around: &[Rc<Document>]) -> BTreeSet<Identity> {
        match identity {
            Identity::Defined { path, class: Class::Value, name } => {
                let paths = self.same_attribute(path, name, around).into_iter();
                paths.map(|path| Identity::Defined { path, class: Class::Value, name: name.clone() }).collect()
            }
            _ => BTreeSet::from([identity.clone()]),
        }
    }

    /// The file that the path of an import at this byte leads to, if it is there.
    fn import_at(&self, document: &Document, offset: usize) -> Option<String> {
        let token = document.token_at(offset).filter(|token| document.kind(*token) == Some(TokenKind::Text))?;
        let import = document.definition_of(document.piece_of(token))?;
        let path =
            imported_path(self.world, document, import).filter(|_| path_token(document, import) == Some(token))?;
        self.document(&path).map(|_| path)
    }
}

/// How many arguments, or parameters, stand behind a name that ends at this byte.
fn arguments(document: &Document, end: usize) -> usize {
    let Some(name) = document.token_at(end) else { return 0 };
    let Some(past) = document.past_group(name + 1).filter(|_| document.word(name + 1) == "(") else { return 0 };
    let (mut at, mut commas) = (name + 2, 0);
    while at + 1 < past {
        commas += usize::from(document.kind(at) == Some(TokenKind::Comma));
        at = document.past_group(at).unwrap_or(at + 1);
    }
    if past == name + 3 { 0 } else { commas + 1 }
}
