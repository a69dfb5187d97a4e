//! What is known of the word under the cursor: the manual's page, a definition with its comment, the catalogue's entry.

use crate::functions;
use crate::ide::catalogue;
use crate::ide::document::{Document, NameUse};
use crate::ide::identity::Identity;
use crate::ide::imports::{imported_path, path_token};
use crate::ide::page;
use crate::ide::walk::Role;
use crate::ide::{Desk, Place};
use crate::ops::{self, Selectors, UNBUILT_OPERATIONS};
use crate::syntax::TokenKind;
use std::ops::Range;

/// What is shown over a word.
#[derive(Clone, Debug, PartialEq)]
pub struct Hover {
    /// The word.
    pub place: Place,
    /// Markdown.
    pub text: String,
}

impl Desk<'_> {
    /// What is known of what stands at a byte.
    pub fn hover(&self, path: &str, offset: usize) -> Option<Hover> {
        let document = self.document(path)?;
        let token = document.token_at(offset)?;
        let (range, text) = match document.kind(token)? {
            TokenKind::Text => (document.range(token), self.text_page(&document, token)?),
            TokenKind::Name => self.name_page(&document, &document.name_at(token)?, offset)?,
            _ => return None,
        };
        Some(Hover { place: Place::new(path, range), text })
    }

    /// A text may be the path of an import, or a word of the catalogue.
    fn text_page(&self, document: &Document, token: usize) -> Option<String> {
        let import = document.definition_of(document.piece_of(token));
        let path = import.filter(|import| path_token(document, import) == Some(token));
        match path {
            Some(import) => {
                let path = imported_path(self.world, document, import)?;
                let names: Vec<String> =
                    self.document(&path)?.definitions().iter().map(|d| format!("`{}`", d.name)).collect();
                Some(format!("`{path}`: {}", names.join(", ")))
            }
            None => catalogue::describe(self.catalogue, document.text_of(token)),
        }
    }

    fn name_page(&self, document: &Document, name: &NameUse, offset: usize) -> Option<(Range<usize>, String)> {
        let segments = self.segments(document, name);
        let found = segments.into_iter().find(|s| s.range.start <= offset && offset <= s.range.end);
        if let Some((range, identity)) = found.and_then(|s| Some((s.range, s.identity?))) {
            return Some((range, self.identity_page(document.path(), &identity)?));
        }
        Some((document.range(name.token), self.built_in_page(document, name)?))
    }

    /// The page of what a file defines: every overload in turn.
    pub(super) fn identity_page(&self, here: &str, identity: &Identity) -> Option<String> {
        let document = self.document(identity.path())?;
        match identity {
            Identity::Defined { .. } => {
                let definitions = identity.definitions(&document).into_iter();
                let pages: Vec<String> = definitions.map(|d| page::definition(&document, d, here)).collect();
                Some(pages.join("\n"))
            }
            Identity::Local { piece, name, .. } => {
                let definition = document.definition_of(*piece)?;
                Some(format!("`{name}`, a parameter of `{}`", page::head(&document, definition)))
            }
        }
    }

    fn built_in_page(&self, document: &Document, name: &NameUse) -> Option<String> {
        let word = document.word(name.token);
        match name.role {
            Role::Step => self.step_page(word),
            Role::Value => self.value_page(word),
            Role::Argument(owner) => {
                let operation = ops::find(document.word(owner))?;
                let param = operation.spec.params.iter().find(|p| p.name == word)?;
                Some(format!("`{word}` of `{}`: {}", operation.spec.name, page::parameter(param)))
            }
            Role::Annotation => page::annotation(word),
            Role::Selector if Selectors::of_word(word).is_some() || word == "remainder" => {
                Some(format!("`{word}`, a selector"))
            }
            _ => None,
        }
    }

    /// An operation, what is missing of CityEngine's, or a leaf that is a ground cover.
    fn step_page(&self, word: &str) -> Option<String> {
        if word == "NIL" {
            return Some("`NIL` deletes the shape; what stands after it in the body is not run.".into());
        }
        if let Some(operation) = ops::find(word).or_else(|| page::of_papers(word)) {
            return Some(page::operation(operation.spec, self.picture(operation.spec.name).as_deref()));
        }
        let missing = UNBUILT_OPERATIONS.iter().find(|unbuilt| unbuilt.name == word);
        let missing = missing.map(|unbuilt| format!("`{word}` is CityEngine's and not built yet: {}.", unbuilt.does));
        missing.or_else(|| catalogue::describe(self.catalogue, word))
    }

    fn value_page(&self, word: &str) -> Option<String> {
        if let Some(function) = functions::find(word) {
            return Some(page::function(function));
        }
        catalogue::describe(self.catalogue, word)
    }

    /// Where the picture of an operation's example lies, if it is there.
    pub(super) fn picture(&self, name: &str) -> Option<String> {
        let pictures = self.pictures?;
        let is_there = self.world.exists(&format!("{}/{name}.png", pictures.folder));
        is_there.then(|| format!("{}/{name}.png", pictures.address))
    }
}
