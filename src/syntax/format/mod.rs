//! Rule text → the same rules, evenly laid out. Nothing but blanks and line ends changes.
//!
//! In: a file that parses. Out: its text, every token in its order and spelling, and every comment where it was, with
//! one exception: one right behind a `|` that stays in its line goes before the bar, to the alternative that ends there.
//! `structure` reads what belongs together, `gaps` what stood between the tokens, `spacing` says where a blank goes,
//! `writer` writes tokens into lines, `layout` decides where lines break, and `align` keeps columns that the author had
//! aligned.
//!
//! Structure only ever chooses between a blank and a line end, so a mistake here can look bad and cannot change a
//! program. What the author grouped stays grouped: line breaks between operations, alternatives, arms and definitions,
//! single blank lines, and columns of arrows, colons and comments. Formatting twice is formatting once.

mod align;
mod gaps;
mod layout;
mod spacing;
mod structure;
mod writer;

use super::outline::{Piece, PieceKind, outline};
use super::source::Source;
use super::token::{Token, tokens};
use crate::diag::Diagnostic;
use writer::Writer;

/// Lines are broken that would be longer, characters.
pub(super) const WIDTH: usize = 100;

/// Blanks for each level.
pub(super) const INDENT: usize = 4;

/// The text of a rule file in the house's layout, with the line ends it has; or why it cannot be read.
///
/// The tree of the result is that of the file, its places aside. Cost: linear.
pub fn format(file: u16, source: &Source) -> Result<String, Vec<Diagnostic>> {
    let (_, reports) = super::parse(file, source);
    if reports.iter().any(Diagnostic::is_error) {
        return Err(reports);
    }
    let text = source.text();
    let mut tokens = tokens(text);
    let pieces = outline(text, &mut tokens);
    let laid_out = definitions(text, &tokens, &pieces);
    Ok(with_line_ends(text, laid_out))
}

fn definitions(text: &str, tokens: &[Token], pieces: &[Piece]) -> String {
    let structure = structure::read(text, tokens, pieces);
    let mut writer = Writer::new(text, tokens, pieces, &structure);
    let mut is_noted = false;
    for (piece, parts) in pieces.iter().zip(&structure.pieces) {
        writer.definition(piece, parts, is_noted);
        is_noted = piece.kind == PieceKind::Annotation;
    }
    writer.finish()
}

/// The line ends of the file, if its first line ends as Windows has it.
fn with_line_ends(before: &str, after: String) -> String {
    let first = before.find('\n').unwrap_or(0);
    match before[..first].ends_with('\r') {
        true => after.replace("\r\n", "\n").replace('\n', "\r\n"),
        false => after,
    }
}
