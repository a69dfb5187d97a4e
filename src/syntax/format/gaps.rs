//! What stands between the tokens of a file: comments, and how many lines end there.

use crate::syntax::token::Token;

/// A comment.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Comment<'t> {
    /// As written, without blanks at its end.
    pub text: &'t str,
    /// Whether it runs to the end of its line.
    pub to_end: bool,
    /// Lines that end between it and what comes before it.
    pub lines: usize,
    /// Columns before it in its line.
    pub column: usize,
}

/// What stands before a token, or before the end of the file.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Gap<'t> {
    /// The comments, in order.
    pub comments: Vec<Comment<'t>>,
    /// Lines that end between the last of them, or the token before, and the token.
    pub lines: usize,
}

impl Gap<'_> {
    /// Lines that end between a comment, by its index, and what follows it.
    pub fn lines_after(&self, comment: usize) -> usize {
        self.comments.get(comment + 1).map_or(self.lines, |next| next.lines)
    }

    /// Whether what follows a comment must begin a line.
    pub fn breaks_after(&self, comment: usize) -> bool {
        self.comments[comment].to_end || self.lines_after(comment) > 0
    }

    /// Whether the comments need a line end among them.
    pub fn breaks(&self) -> bool {
        let breaks =
            |at: usize| self.comments[at].lines > 0 || self.breaks_after(at) || self.comments[at].text.contains('\n');
        (0..self.comments.len()).any(breaks)
    }

    /// Characters of the comments in a line, a blank before each.
    pub fn width(&self) -> usize {
        self.comments.iter().map(|comment| comment.text.chars().count() + 1).sum()
    }
}

/// The gap before each token, and the one at the end. Cost: linear.
pub(super) fn gaps<'t>(text: &'t str, tokens: &[Token]) -> Vec<Gap<'t>> {
    let starts = tokens.iter().map(|token| token.start as usize).chain([text.len()]);
    let ends = [0].into_iter().chain(tokens.iter().map(|token| token.end as usize));
    ends.zip(starts).map(|(end, start)| gap(text, end, start)).collect()
}

/// Gives what stands behind a bar to the gap before it: comments there belong to the alternative that ends.
pub(super) fn before_bar(gaps: &mut [Gap], bar: usize) {
    let behind = std::mem::take(&mut gaps[bar + 1]);
    if !behind.comments.is_empty() && !behind.breaks() {
        gaps[bar + 1] = behind;
        return;
    }
    let before = &mut gaps[bar];
    let lines = before.lines;
    before.lines = lines.max(behind.lines);
    if let Some(first) = behind.comments.first() {
        let first = Comment { lines: first.lines.max(lines), ..*first };
        before.comments.push(first);
        before.comments.extend(&behind.comments[1..]);
        before.lines = behind.lines;
    }
}

fn gap(text: &str, mut at: usize, end: usize) -> Gap<'_> {
    let mut gap = Gap::default();
    while at < end {
        let rest = &text[at..end];
        let next = rest.find(['/', '#']).unwrap_or(rest.len());
        gap.lines += line_ends(&rest[..next]);
        at += next;
        if at < end {
            let length = comment_length(&text[at..end]);
            let to_end = !text[at..].starts_with("/*");
            let (lines, column) = (std::mem::take(&mut gap.lines), column(text, at));
            gap.comments.push(Comment { text: text[at..at + length].trim_end(), to_end, lines, column });
            at += length;
        }
    }
    gap
}

fn comment_length(rest: &str) -> usize {
    match rest.strip_prefix("/*") {
        Some(inside) => inside.find("*/").map_or(rest.len(), |end| end + 4),
        None => rest.find(['\n', '\r']).unwrap_or(rest.len()),
    }
}

/// Line ends of any system: `\n`, `\r\n`, `\r`.
fn line_ends(blanks: &str) -> usize {
    let returns = blanks.matches('\r').count() - blanks.matches("\r\n").count();
    blanks.matches('\n').count() + returns
}

/// Columns before a place in its line, a tab reaching to the next multiple of four.
pub(super) fn column(text: &str, at: usize) -> usize {
    let start = text[..at].rfind(['\n', '\r']).map_or(0, |end| end + 1);
    text[start..at].chars().fold(0, |column, c| if c == '\t' { column / 4 * 4 + 4 } else { column + 1 })
}
