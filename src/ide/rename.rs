//! A new name for a rule, attribute, function, parameter, import or style, in every file that uses it; or why not.

use crate::functions;
use crate::ide::document::{Document, NameUse};
use crate::ide::identity::{Class, Identity, is_taken};
use crate::ide::walk::Role;
use crate::ide::{Desk, Place};
use crate::library;
use crate::ops::{self, Selectors};
use crate::syntax::{TokenKind, pieces};
use std::rc::Rc;

/// A name that can be changed.
#[derive(Clone, Debug, PartialEq)]
pub struct Renaming {
    /// Where it stands.
    pub place: Place,
    /// What it is now.
    pub name: String,
}

/// Why a name is not changed: what was found and what would do.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{0}")]
pub struct Refusal(pub String);

impl Desk<'_> {
    /// The name at a byte, if it can be changed.
    pub fn renamable(&self, path: &str, offset: usize) -> Result<Renaming, Refusal> {
        let (place, identity) = self.identity_at(path, offset).ok_or_else(|| self.stranger(path, offset))?;
        let around = self.around(identity.path());
        let foreign = self.equals(&identity, &around).into_iter().find(|i| i.path().starts_with(library::PREFIX));
        match foreign {
            Some(foreign) => Err(Refusal(format!(
                "`{}` is the pattern library's (`{}`): it cannot be renamed",
                foreign.name(),
                foreign.path()
            ))),
            None => Ok(Renaming { place, name: identity.name().to_string() }),
        }
    }

    /// Every place where the name at a byte has to be replaced by `new`. Refuses what is built in, words that are no
    /// names, and names that are taken.
    pub fn rename(&self, path: &str, offset: usize, new: &str) -> Result<Vec<Place>, Refusal> {
        let old = self.renamable(path, offset)?;
        if !is_name(new) {
            return Err(Refusal(format!("`{new}` is no name: names are letters, digits and `_`, a letter first")));
        }
        if old.name == new {
            return Ok(Vec::new());
        }
        let (_, identity) = self.identity_at(path, offset).ok_or_else(|| self.stranger(path, offset))?;
        match self.clash(&identity, new) {
            Some(clash) => Err(Refusal(clash)),
            None => Ok(self.uses(&identity)),
        }
    }

    /// Why there is nothing to rename.
    fn stranger(&self, path: &str, offset: usize) -> Refusal {
        let document = self.document(path);
        let word = document.as_ref().and_then(|document| {
            let token = document.token_at(offset).filter(|t| document.kind(*t) == Some(TokenKind::Name))?;
            Some(document.word(token))
        });
        Refusal(match word {
            Some(word) if ops::find(word).is_some() || functions::find(word).is_some() => {
                format!("`{word}` is built in: it cannot be renamed")
            }
            Some(word) => format!("`{word}` has no definition in the files that are known here"),
            None => "there is no name here".to_string(),
        })
    }

    /// What the new name would meet.
    fn clash(&self, identity: &Identity, new: &str) -> Option<String> {
        let around = self.around(identity.path());
        self.equals(identity, &around).iter().find_map(|same| {
            let document = self.document(same.path())?;
            match same {
                Identity::Defined { class, .. } => {
                    defined_clash(&document, *class, new).or_else(|| self.merged(same, new, &around))
                }
                Identity::Local { piece, .. } => local_clash(&document, *piece, new),
            }
        })
    }

    /// An attribute of another file that would become one with this one under the new name, which nobody has asked for.
    fn merged(&self, identity: &Identity, new: &str, around: &[Rc<Document>]) -> Option<String> {
        let Identity::Defined { path, class: Class::Value, name } = identity else { return None };
        let pairs = around.iter().flat_map(|document| self.merging(document, name, new));
        let mut met = pairs.filter_map(|(outer, inner)| match (outer == *path, inner == *path) {
            (true, _) => Some(format!("`{inner}`, which `{outer}` imports, has `{new}` already")),
            (_, true) => Some(format!("`{outer}`, which imports `{inner}`, has `{new}` already")),
            _ => None,
        });
        met.next()
    }
}

/// What a definition of that name would meet in its file.
fn defined_clash(document: &Document, class: Class, new: &str) -> Option<String> {
    let file = document.path();
    if let Some(taken) = document.named(new).find(|d| Class::of(d.sort) == class) {
        return Some(format!("`{file}` has {} `{new}` already", article(taken.sort.word())));
    }
    let used = |name: &&NameUse| document.word(name.token) == new;
    let mine = |role| match class {
        Class::Rule => matches!(role, Role::Step),
        // What parentheses of imports and calls name is the import's.
        Class::Value => !matches!(role, Role::Step | Role::Argument(_) | Role::Given),
        Class::Import | Class::Style => false,
    };
    match class {
        Class::Rule if is_taken(new) || ops::find(new).is_some() => Some(format!("`{new}` is an operation")),
        Class::Value if functions::find(new).is_some() => Some(format!("`{new}` is a built-in function")),
        Class::Value if Selectors::of_word(new).is_some() => Some(format!("`{new}` is a selector")),
        _ if document.names.iter().filter(used).any(|name| mine(name.role)) => {
            Some(format!("`{file}` uses the word `{new}` for something else"))
        }
        _ => None,
    }
}

/// What a parameter of that name would meet in its definition.
fn local_clash(document: &Document, piece: usize, new: &str) -> Option<String> {
    let mut own = document.names.iter().filter(|name| name.piece == piece);
    let met = own.any(|name| document.word(name.token) == new && name.role != Role::Step);
    met.then(|| format!("the definition uses the word `{new}` already"))
}

fn article(noun: &str) -> String {
    let vowel = noun.starts_with(['a', 'e', 'i', 'o', 'u']);
    format!("{} {noun}", if vowel { "an" } else { "a" })
}

/// Whether a word can be a name: one token, without dots, that is no keyword.
fn is_name(word: &str) -> bool {
    let (tokens, _) = pieces(word);
    matches!(tokens.as_slice(), [one] if one.kind == TokenKind::Name && one.end as usize - one.start as usize == word.len())
        && !word.contains('.')
        && word != "NIL"
}
