//! What could stand at the cursor.
//!
//! In: a file, whole or broken, and a byte. Out: [`Completion`]s, each with what it replaces; the editor sorts out those
//! that do not begin with what is written. Which lists are asked is decided here, [`crate::ide::suggest`] makes them.

use crate::ide::Desk;
use crate::ide::context::{Callee, Context};
use crate::ide::document::Document;
use crate::ide::imports::path_token;
use crate::ide::snippet;
use crate::ide::walk::Mode;
use crate::ops::{self, BlockKind};
use crate::syntax::PieceKind;
use std::ops::Range;

/// One thing that could stand at the cursor.
#[derive(Clone, Debug, PartialEq)]
pub struct Completion {
    /// What is shown, and what the written word is compared with.
    pub label: String,
    /// What it is.
    pub kind: CompletionKind,
    /// A few words beside it.
    pub detail: String,
    /// Its page, Markdown; may be empty.
    pub docs: String,
    /// What is inserted: a snippet with tab stops, `${1:axis}`.
    pub insert: String,
    /// What it replaces, in bytes of the text.
    pub replaces: Range<usize>,
}

/// What a completion is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum CompletionKind {
    /// An operation.
    Operation,
    /// A function, built in or of a file.
    Function,
    /// An attribute or constant, built in or of a file.
    Attribute,
    /// A rule.
    Rule,
    /// A parameter in scope.
    Param,
    /// The name of an argument.
    Argument,
    /// A word that a parameter or block takes.
    Word,
    /// An annotation.
    Annotation,
    /// A word of the syntax.
    Keyword,
    /// A file.
    File,
    /// A ground cover, element, species or palette.
    Element,
}

impl Desk<'_> {
    /// What could stand at a byte; nothing in comments and numbers.
    pub fn completions(&self, path: &str, offset: usize) -> Vec<Completion> {
        let Some(document) = self.document(path) else { return Vec::new() };
        let Some(context) = Context::of(&document, offset) else { return Vec::new() };
        let mut found =
            List { items: Vec::new(), replaces: context.word.clone(), is_called: is_called(&document, offset) };
        match context.text {
            Some(token) => self.in_text(&document, &context, token, &mut found),
            None if context.is_annotation(&document) => found.annotations(),
            None => self.in_code(&document, &context, &mut found),
        }
        found.items
    }

    fn in_code(&self, document: &Document, context: &Context, found: &mut List) {
        if context.begins(document) {
            found.statements();
        }
        match context.mode() {
            Mode::Steps => self.steps(document, found),
            Mode::Value | Mode::Test => self.values(document, context, found),
            Mode::Key => self.keys(document, context, found),
            Mode::Given => self.names_of_import(document, context, found),
            Mode::Nothing if context.piece.is_some() => self.steps(document, found),
            Mode::Head | Mode::Params | Mode::Locals | Mode::Styles | Mode::Notes | Mode::Nothing => {}
        }
    }

    /// An argument, where the call is known: its names, words, then whatever has a value.
    fn values(&self, document: &Document, context: &Context, found: &mut List) {
        if let Some((spec, param)) = self.parameter(document, context) {
            let fresh = context.frames.last().is_some_and(|frame| frame.is_call && frame.fresh);
            if fresh {
                found.arguments(spec);
            }
            self.words(document, context, spec, param, false, found);
        }
        let owner = context.call().and_then(|call| call.owner);
        if let Some(Callee::Import(path)) = owner.and_then(|owner| self.callee(document, owner)) {
            self.settable(document, Some(path), found);
        }
        self.locals(document, context, found);
        self.expressions(document, found);
    }

    /// The head of a block's entry.
    fn keys(&self, document: &Document, context: &Context, found: &mut List) {
        let owner = context.frames.last().and_then(|frame| frame.owner);
        match owner.and_then(|owner| ops::find(document.word(owner))).map(|operation| operation.spec.block) {
            Some(BlockKind::Selectors(extra)) => found.selectors(extra),
            Some(BlockKind::Cuts) => {}
            Some(BlockKind::Perimeter) => found.selectors(&["remainder"]),
            _ => found.selectors(&[]),
        }
        self.locals(document, context, found);
        self.expressions(document, found);
    }

    fn in_text(&self, document: &Document, context: &Context, token: usize, found: &mut List) {
        let range = document.range(token);
        let start = range.start + 1;
        let end = if document.word(token).ends_with('"') && range.len() > 1 { range.end - 1 } else { context.word.end };
        found.replaces = start.min(context.word.end)..end.max(context.word.end);
        let piece = document.piece_of(token);
        let import = document.definition_of(piece);
        let is_path = match import {
            Some(import) => path_token(document, import) == Some(token),
            None => document.pieces.get(piece).is_some_and(|piece| piece.kind == PieceKind::Import),
        };
        match self.parameter(document, context) {
            _ if is_path => self.paths(document, found),
            Some((spec, param)) => self.words(document, context, spec, param, true, found),
            None => self.loose_words(document, context, found),
        }
    }
}

/// Completions under way.
pub(super) struct List {
    pub items: Vec<Completion>,
    replaces: Range<usize>,
    /// Parentheses stand behind the cursor already.
    is_called: bool,
}

impl List {
    /// Adds one.
    pub fn add(&mut self, kind: CompletionKind, label: &str, detail: impl Into<String>, docs: String, insert: String) {
        let insert = if self.is_called { snippet::literal(label) } else { insert };
        let (label, detail, replaces) = (label.to_string(), detail.into(), self.replaces.clone());
        self.items.push(Completion { label, kind, detail, docs, insert, replaces });
    }

    /// Adds one that is inserted as it is shown.
    pub fn plain(&mut self, kind: CompletionKind, label: &str, detail: impl Into<String>) {
        self.add(kind, label, detail, String::new(), snippet::literal(label));
    }
}

/// Whether an opening parenthesis follows the cursor at once.
fn is_called(document: &Document, offset: usize) -> bool {
    document.text().get(offset..).is_some_and(|rest| rest.starts_with('('))
}
