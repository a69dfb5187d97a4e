//! What an editor asks about a rule file: what is wrong, what a name means, where it is written, what could stand here.
//!
//! In: a [`Desk`] (a world, a catalogue, the rule files there are), the path of a file and a byte of its text. Out: plain
//! data with places in bytes of texts. All answers but [`Desk::diagnose`] read tokens and not the tree, so a file that is
//! broken, as it is while somebody writes, is served like a whole one. Knows no protocol, no editor and no disk.

mod catalogue;
mod color;
mod complete;
mod context;
mod diagnose;
mod document;
mod fold;
mod hover;
mod identity;
mod imports;
mod navigate;
mod outline;
mod page;
mod rename;
mod signature;
mod snippet;
mod suggest;
mod tint;
mod walk;

pub use color::Swatch;
pub use complete::{Completion, CompletionKind};
pub use diagnose::Finding;
pub use document::{Definition, Document, Sort};
pub use fold::Fold;
pub use hover::Hover;
pub use outline::Symbol;
pub use rename::{Refusal, Renaming};
pub use signature::Signature;
pub use tint::{TINTS, Tint, Tinted};

use crate::element::Catalogue;
use crate::world::{World, rules};
use std::cell::RefCell;
use std::collections::BTreeMap;
use std::ops::Range;
use std::rc::Rc;

/// What lies before the editor for the time of one answer: files are read once.
pub struct Desk<'a> {
    world: &'a dyn World,
    catalogue: &'a Catalogue,
    /// The rule files there are, as far as the editor knows: those in which a name may be used.
    files: &'a [String],
    pictures: Option<Pictures<'a>>,
    documents: RefCell<BTreeMap<String, Option<Rc<Document>>>>,
}

/// Where the manual's pictures lie, one for each operation: `NAME.png`.
#[derive(Clone, Copy, Debug)]
pub struct Pictures<'a> {
    /// Their folder, as the world calls it.
    pub folder: &'a str,
    /// The same as the editor calls it, in front of a name.
    pub address: &'a str,
}

/// A stretch of a file, in bytes of its text.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    /// The file, as the world calls it.
    pub path: String,
    /// First byte.
    pub start: usize,
    /// One past the last byte.
    pub end: usize,
}

impl<'a> Desk<'a> {
    /// A desk on which nothing lies yet.
    pub fn new(world: &'a dyn World, catalogue: &'a Catalogue) -> Desk<'a> {
        Desk { world, catalogue, files: &[], pictures: None, documents: RefCell::default() }
    }

    /// The same, knowing which rule files there are: uses of a name are looked for in these, and paths offered.
    pub fn with_files(self, files: &'a [String]) -> Desk<'a> {
        Desk { files, ..self }
    }

    /// The same, with the manual's pictures.
    pub fn with_pictures(self, pictures: Option<Pictures<'a>>) -> Desk<'a> {
        Desk { pictures, ..self }
    }

    /// The file at a path of the world or of the library; `None` where there is none.
    pub fn document(&self, path: &str) -> Option<Rc<Document>> {
        if let Some(known) = self.documents.borrow().get(path) {
            return known.clone();
        }
        let read = rules(self.world, path).ok().map(|bytes| Rc::new(Document::new(path, &bytes)));
        self.documents.borrow_mut().insert(path.to_string(), read.clone());
        read
    }
}

impl Place {
    fn new(path: &str, range: Range<usize>) -> Place {
        Place { path: path.to_string(), start: range.start, end: range.end }
    }
}
