//! What surrounds the cursor: the word being written, the brackets that are open, the call whose argument it is.

use crate::functions::{self, Function};
use crate::ide::Desk;
use crate::ide::document::Document;
use crate::ide::identity::{Class, Identity, Segment};
use crate::ide::walk::{Frame, Mode, Role, Walk};
use crate::ops::{self, Param, Spec};
use crate::syntax::{PieceKind, TokenKind};
use std::ops::Range;

/// The place of a cursor.
pub(super) struct Context {
    /// The piece that it stands in; `None` before the first.
    pub piece: Option<usize>,
    /// What is open there, the piece itself first; empty outside of all pieces.
    pub frames: Vec<Frame>,
    /// The text literal that it stands in.
    pub text: Option<usize>,
    /// The word under way, dots included, up to the cursor.
    pub word: Range<usize>,
    /// The last token before the word.
    pub before: Option<usize>,
    /// The word begins a line.
    pub at_margin: bool,
}

/// What is called where the cursor is an argument.
pub(super) enum Callee {
    /// An operation.
    Operation(&'static Spec),
    /// A built-in function.
    Builtin(&'static Function),
    /// A rule or function of a file.
    Own(Identity),
    /// An import with attributes of its own for one call: its file.
    Import(String),
}

impl Context {
    /// The surroundings of a byte of a text; `None` in comments and numbers.
    pub fn of(document: &Document, offset: usize) -> Option<Context> {
        let text = document.text();
        let offset = text.floor_char_boundary(offset.min(text.len()));
        let literal = literal_at(document, offset);
        let start = if literal.is_some() { offset } else { word_start(text, offset) };
        let after = match literal {
            Some(token) => token,
            None => document.tokens.partition_point(|token| (token.start as usize) < start),
        };
        let before = after.checked_sub(1);
        let gap = before.map_or(0, |before| document.range(before).end);
        let is_open_comment = before.is_some_and(|before| document.word(before).starts_with("/*"));
        let is_number = text[start..].starts_with(|c: char| c.is_ascii_digit());
        if literal.is_none() && (is_open_comment || is_number || in_comment(&text[gap.min(start)..start])) {
            return None;
        }
        let piece = literal.or(before).map(|token| document.piece_of(token));
        let frames = piece.map_or(Vec::new(), |piece| Walk::until(document, piece, after).frames);
        let at_margin = start == 0 || text[..start].ends_with('\n');
        Some(Context { piece, frames, text: literal, word: start..offset, before, at_margin })
    }

    /// What a name would be here.
    pub fn mode(&self) -> Mode {
        self.frames.last().map_or(Mode::Nothing, |frame| frame.mode)
    }

    /// The innermost call whose parentheses are open.
    pub fn call(&self) -> Option<&Frame> {
        self.frames.iter().rev().take_while(|frame| !frame.is_block).find(|frame| frame.is_call)
    }

    /// Whether a definition may begin here.
    pub fn begins(&self, document: &Document) -> bool {
        let Some(piece) = self.piece else { return true };
        let open = self.frames.len() == 1;
        open && (self.at_margin || document.pieces[piece].kind == PieceKind::Annotation || self.mode() == Mode::Nothing)
    }

    /// Whether an `@` stands before the word.
    pub fn is_annotation(&self, document: &Document) -> bool {
        self.before.is_some_and(|before| document.kind(before) == Some(TokenKind::At))
    }
}

impl Desk<'_> {
    /// What the name before parentheses calls.
    pub(super) fn callee(&self, document: &Document, owner: usize) -> Option<Callee> {
        let name = document.name_at(owner)?;
        let word = document.word(owner);
        let own = self.segments(document, &name).pop().and_then(|segment: Segment| segment.identity);
        match (own, name.role) {
            (Some(Identity::Defined { class: Class::Import, .. }), _) => {
                self.imported(document, word).map(Callee::Import)
            }
            (Some(identity), _) => Some(Callee::Own(identity)),
            (None, Role::Step) => ops::find(word).map(|operation| Callee::Operation(operation.spec)),
            (None, Role::Value) => functions::find(word).map(Callee::Builtin),
            _ => None,
        }
    }

    /// The parameter of an operation that the cursor's argument is.
    pub(super) fn parameter(&self, document: &Document, context: &Context) -> Option<(&'static Spec, &'static Param)> {
        let call = context.call()?;
        let Callee::Operation(spec) = self.callee(document, call.owner?)? else { return None };
        Some((spec, spec.params.get(parameter_index(document, spec, call))?))
    }
}

/// Which parameter an argument is: by its name, else by its place.
pub(super) fn parameter_index(document: &Document, spec: &Spec, call: &Frame) -> usize {
    let named = call.named.map(|token| document.word(token));
    named.and_then(|name| spec.params.iter().position(|p| p.name == name)).unwrap_or(call.argument)
}

/// The text literal around a byte, its quotes not counted; one that never ends holds what follows on its line.
fn literal_at(document: &Document, offset: usize) -> Option<usize> {
    let last = document.tokens.partition_point(|token| (token.start as usize) < offset).checked_sub(1)?;
    let range = document.range(last);
    let inside = match document.kind(last)? {
        TokenKind::Text => offset < range.end,
        TokenKind::Unclosed => {
            document.word(last).starts_with('"') && !document.text()[range.end.min(offset)..offset].contains('\n')
        }
        _ => false,
    };
    inside.then_some(last)
}

/// Where the word that ends at a byte begins.
fn word_start(text: &str, offset: usize) -> usize {
    let part = |c: &char| c.is_alphanumeric() || matches!(c, '_' | '$' | '.');
    let length: usize = text[..offset].chars().rev().take_while(part).map(char::len_utf8).sum();
    offset - length
}

/// Whether what stands between two tokens ends inside a comment.
fn in_comment(gap: &str) -> bool {
    let line = gap.rsplit('\n').next().unwrap_or(gap);
    let open = gap.rfind("/*").is_some_and(|open| !gap[open..].contains("*/"));
    open || line.contains("//") || line.contains('#')
}
