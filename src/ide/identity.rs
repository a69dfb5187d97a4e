//! What a name means: which definition, in which file, or which parameter.
//!
//! Rules and values (attributes, constants, functions) do not meet, whatever their names; definitions of one sort that
//! share a name in a file are taken together, be they overloads or the papers' alternatives.

use crate::ide::document::{Definition, Document, NameUse, Sort};
use crate::ide::walk::Role;
use crate::ide::{Desk, Place};
use crate::ops::{self, Origin};
use crate::syntax::TokenKind;
use std::ops::Range;
use std::rc::Rc;

/// What a name of the user's stands for; equal for all its uses.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Identity {
    /// What a file defines under a name.
    Defined {
        /// The file.
        path: String,
        /// Which sort.
        class: Class,
        /// The name.
        name: String,
    },
    /// A parameter or local of one definition.
    Local {
        /// The file.
        path: String,
        /// The piece of the file.
        piece: usize,
        /// The name.
        name: String,
    },
}

/// Sorts of definitions whose names are looked up together.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) enum Class {
    /// Rules.
    Rule,
    /// Attributes, constants, functions.
    Value,
    /// Imports.
    Import,
    /// Styles.
    Style,
}

/// A part of a name between dots, and what it means.
pub(super) struct Segment {
    /// Where.
    pub range: Range<usize>,
    /// What, where it is the user's.
    pub identity: Option<Identity>,
}

impl Class {
    /// The class of a sort.
    pub fn of(sort: Sort) -> Class {
        match sort {
            Sort::Rule => Class::Rule,
            Sort::Attribute | Sort::Constant | Sort::Function => Class::Value,
            Sort::Import => Class::Import,
            Sort::Style => Class::Style,
        }
    }
}

impl Identity {
    fn defined(document: &Document, class: Class, name: &str) -> Option<Identity> {
        let known = document.named(name).any(|d| Class::of(d.sort) == class);
        known.then(|| Identity::Defined { path: document.path().to_string(), class, name: name.to_string() })
    }

    /// The file that it belongs to.
    pub fn path(&self) -> &str {
        match self {
            Identity::Defined { path, .. } | Identity::Local { path, .. } => path,
        }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        match self {
            Identity::Defined { name, .. } | Identity::Local { name, .. } => name,
        }
    }

    /// Its definitions in the file that it belongs to.
    pub fn definitions<'d>(&self, document: &'d Document) -> Vec<&'d Definition> {
        match self {
            Identity::Defined { class, name, .. } => {
                document.named(name).filter(|d| Class::of(d.sort) == *class).collect()
            }
            Identity::Local { .. } => Vec::new(),
        }
    }
}

impl Desk<'_> {
    /// What the name at a byte means; nothing where there is no name, or one of the language's own.
    pub(super) fn identity_at(&self, path: &str, offset: usize) -> Option<(Place, Identity)> {
        let document = self.document(path)?;
        let name = document.name_at(document.token_at(offset)?)?;
        let segments = self.segments(&document, &name);
        let found = segments.into_iter().find(|s| s.range.start <= offset && offset <= s.range.end)?;
        Some((Place::new(path, found.range), found.identity?))
    }

    /// The parts of a name and what they mean.
    pub(super) fn segments(&self, document: &Document, name: &NameUse) -> Vec<Segment> {
        let word = document.word(name.token);
        let range = document.range(name.token);
        let own = Identity::defined(document, Class::Import, word.split('.').next().unwrap_or(word));
        if !word.contains('.') || own.is_none() {
            return vec![Segment { range, identity: self.whole(document, name) }];
        }
        self.dotted(document, name, word, range.start)
    }

    fn dotted(&self, document: &Document, name: &NameUse, word: &str, start: usize) -> Vec<Segment> {
        let class = match name.role {
            Role::Defined(_) | Role::Step | Role::Member(_) => Class::Rule,
            _ => Class::Value,
        };
        let own = self.document(document.path());
        let (mut found, mut at, mut here) = (Vec::new(), start, own);
        let mut parts = word.split('.').peekable();
        while let Some(part) = parts.next() {
            let class = if parts.peek().is_some() { Class::Import } else { class };
            let identity = here.as_ref().and_then(|document| Identity::defined(document, class, part));
            found.push(Segment { range: at..at + part.len(), identity });
            here = here.and_then(|document| self.document(&self.imported(&document, part)?));
            at += part.len() + 1;
        }
        found
    }

    /// What a name without dots means.
    fn whole(&self, document: &Document, name: &NameUse) -> Option<Identity> {
        let word = document.word(name.token);
        match name.role {
            Role::Defined(sort) => Identity::defined(document, Class::of(sort), word),
            Role::Param | Role::Local => Some(local(document, name.piece, word)),
            Role::Step if is_taken(word) => None,
            Role::Step | Role::Value if is_called(document, name) => Identity::defined(document, Class::Import, word),
            Role::Step => Identity::defined(document, Class::Rule, word),
            Role::Value if is_local(document, name.piece, word) => Some(local(document, name.piece, word)),
            Role::Value => Identity::defined(document, Class::Value, word),
            Role::Style => Identity::defined(document, Class::Style, word),
            Role::Member(import) => {
                let inner = self.document(&self.imported(document, document.word(import))?)?;
                Identity::defined(&inner, Class::Rule, word)
            }
            Role::Argument(owner) => {
                let inner = self.document(&self.imported(document, document.word(owner))?)?;
                Identity::defined(&inner, Class::Value, word)
            }
            Role::Given => self.given(document, name, word),
            Role::Selector | Role::Annotation | Role::Word => None,
        }
    }

    /// A name in the parentheses of an import: an attribute, or a rule where an arrow follows.
    fn given(&self, document: &Document, name: &NameUse, word: &str) -> Option<Identity> {
        let import = document.definition_of(name.piece)?;
        let inner = self.document(&self.imported(document, &import.name)?)?;
        let is_rule = matches!(document.kind(name.token + 1), Some(TokenKind::Arrow | TokenKind::Open));
        Identity::defined(&inner, if is_rule { Class::Rule } else { Class::Value }, word)
    }

    /// Where an identity is declared.
    pub(super) fn declared(&self, identity: &Identity) -> Vec<(Rc<Document>, Range<usize>)> {
        let Some(document) = self.document(identity.path()) else { return Vec::new() };
        let ranges: Vec<Range<usize>> = match identity {
            Identity::Defined { .. } => identity.definitions(&document).iter().map(|d| d.at.clone()).collect(),
            Identity::Local { piece, name, .. } => {
                let own = |n: &&NameUse| n.piece == *piece && matches!(n.role, Role::Param | Role::Local);
                let uses = document.names.iter().filter(own).filter(|n| document.word(n.token) == name);
                uses.map(|n| document.range(n.token)).collect()
            }
        };
        ranges.into_iter().map(|range| (document.clone(), range)).collect()
    }
}

fn local(document: &Document, piece: usize, word: &str) -> Identity {
    Identity::Local { path: document.path().to_string(), piece, name: word.to_string() }
}

/// Whether a parameter or local of the piece has the name.
fn is_local(document: &Document, piece: usize, word: &str) -> bool {
    let first = document.names.partition_point(|name| name.piece < piece);
    let own = document.names[first..].iter().take_while(|name| name.piece == piece);
    own.filter(|n| matches!(n.role, Role::Param | Role::Local)).any(|n| document.word(n.token) == word)
}

/// Whether a step of that name is one of CityEngine's operations, which no rule can shadow.
pub(super) fn is_taken(word: &str) -> bool {
    word == "NIL" || ops::find(word).is_some_and(|operation| operation.spec.origin == Origin::CityEngine)
}

/// `plants(spacing = 3).Row`
fn is_called(document: &Document, name: &NameUse) -> bool {
    let after = document.past_group(name.token + 1);
    let is = |token: usize, kind: TokenKind| document.kind(token) == Some(kind);
    after.is_some_and(|after| is(after, TokenKind::Dot) && is(after + 1, TokenKind::Name))
}
