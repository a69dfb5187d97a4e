//! What each name of a file is, for editors that colour by meaning.

use crate::functions;
use crate::ide::Desk;
use crate::ide::document::{Document, NameUse, Sort};
use crate::ide::identity::{Class, Identity, Segment};
use crate::ide::page::of_papers;
use crate::ide::walk::Role;
use crate::ops;
use std::ops::Range;

/// What a name is coloured as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tint {
    /// An operation.
    Operation,
    /// A rule.
    Rule,
    /// A function.
    Function,
    /// An attribute or constant.
    Attribute,
    /// A parameter, local, or the name of an argument.
    Param,
    /// An import.
    Import,
    /// An annotation.
    Annotation,
    /// A selector or another word that stands for itself.
    Word,
    /// A style.
    Style,
}

/// Every tint, in the order of their numbers.
pub const TINTS: [Tint; 9] = [
    Tint::Operation,
    Tint::Rule,
    Tint::Function,
    Tint::Attribute,
    Tint::Param,
    Tint::Import,
    Tint::Annotation,
    Tint::Word,
    Tint::Style,
];

/// A name with its tint.
#[derive(Clone, Debug, PartialEq)]
pub struct Tinted {
    /// Where.
    pub range: Range<usize>,
    /// As what.
    pub tint: Tint,
    /// It is built in.
    pub is_built_in: bool,
    /// It is defined here.
    pub is_definition: bool,
}

impl Desk<'_> {
    /// The names of a file in order, with what they are.
    pub fn tints(&self, path: &str) -> Vec<Tinted> {
        let Some(document) = self.document(path) else { return Vec::new() };
        document.names.iter().flat_map(|name| self.tints_of(&document, name)).collect()
    }

    fn tints_of(&self, document: &Document, name: &NameUse) -> Vec<Tinted> {
        let is_definition = matches!(name.role, Role::Defined(_) | Role::Param | Role::Local);
        let tinted = |segment: Segment| {
            let own = segment.identity.as_ref().map(|identity| self.tint_of(identity));
            let built_in = own.is_none().then(|| built_in(document, name)).flatten();
            let is_built_in = built_in.is_some();
            own.or(built_in).map(|tint| Tinted { range: segment.range, tint, is_built_in, is_definition })
        };
        self.segments(document, name).into_iter().filter_map(tinted).collect()
    }

    fn tint_of(&self, identity: &Identity) -> Tint {
        match identity {
            Identity::Local { .. } => Tint::Param,
            Identity::Defined { class: Class::Rule, .. } => Tint::Rule,
            Identity::Defined { class: Class::Import, .. } => Tint::Import,
            Identity::Defined { class: Class::Style, .. } => Tint::Style,
            Identity::Defined { class: Class::Value, .. } => {
                let document = self.document(identity.path());
                let is_function =
                    document.is_some_and(|d| identity.definitions(&d).iter().any(|d| d.sort == Sort::Function));
                if is_function { Tint::Function } else { Tint::Attribute }
            }
        }
    }
}

/// The tint of a name that no file defines.
fn built_in(document: &Document, name: &NameUse) -> Option<Tint> {
    let word = document.word(name.token);
    match name.role {
        Role::Step if word == "NIL" || ops::find(word).or_else(|| of_papers(word)).is_some() => Some(Tint::Operation),
        Role::Step => Some(Tint::Rule),
        Role::Value => match functions::find(word) {
            Some(function) if function.signature.is_empty() => Some(Tint::Attribute),
            Some(_) => Some(Tint::Function),
            None => Some(Tint::Word),
        },
        Role::Argument(_) => Some(Tint::Param),
        Role::Annotation => Some(Tint::Annotation),
        Role::Selector | Role::Word => Some(Tint::Word),
        _ => None,
    }
}
