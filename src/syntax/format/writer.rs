//! Tokens into lines: what has been written, what a line end or blank does to comments, and what still fits.

use super::align::{self, Class, Mark};
use super::gaps::{Gap, before_bar, column, gaps};
use super::spacing::Spaced;
use super::structure::Structure;
use super::{INDENT, WIDTH};
use crate::syntax::outline::Piece;
use crate::syntax::token::{Kind, Token};

/// A line end to come before the next token.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Break {
    /// Blanks before the token.
    pub indent: usize,
    /// Blanks before comments on lines of their own that stand before it.
    pub comments: usize,
    /// Between definitions: comments farther in than the next one still belong to the last one's body.
    pub is_outer: bool,
}

/// A file half written.
pub(super) struct Writer<'t> {
    text: &'t str,
    tokens: &'t [Token],
    gaps: Vec<Gap<'t>>,
    structure: &'t Structure,
    /// Of each token whether a blank stands before it in a line.
    blanks: Vec<bool>,
    /// The width of all tokens before each token, and of all, if they stood in one line.
    widths: Vec<usize>,
    /// How many tokens before each token must begin a line.
    breaks: Vec<usize>,
    out: String,
    /// Characters in the last line.
    column: usize,
    /// The next token.
    pub at: usize,
    /// Blanks before the line, or construct, under way.
    pub indent: usize,
    /// The line end that comes next.
    pub pending: Option<Break>,
    /// What the next token is lined up by.
    pub mark: Option<Class>,
    marks: Vec<Mark>,
    /// Where the first line of the definition under way, comments included, and its first token begin.
    pub paragraph: (usize, usize),
    /// Whether the definition before takes several lines.
    pub was_long: bool,
}

impl<'t> Writer<'t> {
    /// A writer at the start of a file.
    pub fn new(text: &'t str, tokens: &'t [Token], pieces: &[Piece], structure: &'t Structure) -> Writer<'t> {
        let spaced = Spaced { text, tokens, in_body: &structure.in_body };
        let mut blanks = vec![false; tokens.len()];
        for piece in pieces {
            piece.tokens.clone().skip(1).for_each(|at| blanks[at] = spaced.has_blank(piece, at));
            // The first of a piece comes after a blank where it shares the line with an annotation.
            blanks[piece.tokens.start] = true;
        }
        let mut gaps = gaps(text, tokens);
        let is_bar = |at: &usize| tokens[*at].kind == Kind::Bar && structure.keeps_line[*at];
        (0..tokens.len()).filter(is_bar).for_each(|bar| before_bar(&mut gaps, bar));
        let (widths, breaks) = (widths(text, tokens, &gaps, &blanks), breaks(&gaps, structure));
        Writer {
            text,
            tokens,
            gaps,
            structure,
            blanks,
            widths,
            breaks,
            out: String::with_capacity(text.len() + text.len() / 8),
            column: 0,
            at: 0,
            indent: 0,
            pending: None,
            mark: None,
            marks: Vec::new(),
            paragraph: (0, 0),
            was_long: false,
        }
    }

    /// The whole text, when all tokens are written.
    pub fn finish(mut self) -> String {
        self.break_out();
        self.comments();
        if !self.out.is_empty() {
            self.out.push('\n');
        }
        align::aligned(&self.out, &self.marks)
    }

    /// The next token comes on a line of its own, after so many blanks.
    pub fn break_to(&mut self, indent: usize) {
        self.pending = Some(Break { indent, comments: indent, is_outer: false });
    }

    /// The next token begins a definition.
    pub fn break_out(&mut self) {
        self.pending = Some(Break { indent: 0, comments: 0, is_outer: true });
    }

    /// Writes what comes before a token in one line, as far as comments let it.
    pub fn flat(&mut self, end: usize) {
        while self.at < end {
            self.token();
        }
    }

    /// Writes the next token, with the comments before it.
    pub fn token(&mut self) {
        let after_comment = self.comments();
        match self.pending.take() {
            Some(Break { indent, is_outer, .. }) => {
                self.end_line(indent, self.gaps[self.at].lines);
                if is_outer {
                    self.begin_paragraph();
                }
            }
            None if (self.blanks[self.at] || after_comment && !self.sticks(self.at)) && self.column > 0 => {
                self.push(" ")
            }
            None => {}
        }
        let token = self.tokens[self.at];
        if let Some(class) = self.mark.take() {
            self.mark_here(class, column(self.text, token.start as usize));
        }
        if self.paragraph.1 == usize::MAX {
            self.paragraph.1 = self.out.len();
        }
        self.push(&self.text[token.start as usize..token.end as usize]);
        self.at += 1;
    }

    /// Writes the comments before the next token; tells whether the last shares its line.
    fn comments(&mut self) -> bool {
        let mut in_body = self.at > 0;
        for index in 0..self.gaps[self.at].comments.len() {
            let comment = self.gaps[self.at].comments[index];
            let is_own = comment.lines > 0 || self.out.is_empty();
            if is_own {
                let to = self.pending.unwrap_or(self.hanging());
                in_body &= to.is_outer && comment.column > self.column_of_next();
                self.end_line(if in_body { INDENT } else { to.comments }, comment.lines);
                if to.is_outer && !in_body {
                    self.begin_paragraph();
                }
            } else {
                self.push(" ");
                if comment.to_end {
                    self.mark_here(Class::Comment, comment.column);
                }
            }
            self.push(comment.text);
            let shares = !self.gaps[self.at].breaks_after(index);
            match shares {
                false => self.pending = self.pending.or(Some(self.hanging())),
                true if is_own && index + 1 == self.gaps[self.at].comments.len() => self.pending = None,
                true => {}
            }
        }
        !self.gaps[self.at].comments.is_empty() && self.pending.is_none()
    }

    /// A line end where none was foreseen.
    fn hanging(&self) -> Break {
        Break { indent: self.indent + INDENT, comments: self.indent + INDENT, is_outer: false }
    }

    /// The source's column of the next token, or the margin at the end.
    fn column_of_next(&self) -> usize {
        self.tokens.get(self.at).map_or(0, |token| column(self.text, token.start as usize))
    }

    fn end_line(&mut self, indent: usize, lines: usize) {
        if !self.out.is_empty() {
            let blank = lines > 1 && !self.begins_group();
            self.out.push_str(if blank { "\n\n" } else { "\n" });
        }
        self.out.extend(std::iter::repeat_n(' ', indent));
        self.column = indent;
    }

    /// Whether no blank line may follow here: a bracket, a colon or an arrow was written last, or one closes next.
    fn begins_group(&self) -> bool {
        let closes = self.tokens.get(self.at).is_some_and(|token| token.kind == Kind::Close);
        closes || self.out.ends_with(['(', '[', '{', ':', '=', '>'])
    }

    fn begin_paragraph(&mut self) {
        if self.paragraph.0 == usize::MAX {
            self.paragraph.0 = self.out.len() - self.column;
        }
    }

    fn push(&mut self, text: &str) {
        self.out.push_str(text);
        self.column = match text.rfind('\n') {
            Some(end) => text[end + 1..].chars().count(),
            None => self.column + text.chars().count(),
        };
    }

    fn mark_here(&mut self, class: Class, column: usize) {
        self.marks.push(Mark { offset: self.out.len(), class, column });
    }

    // ---- what a definition takes

    /// Begins to note where a definition begins.
    pub fn open_paragraph(&mut self) {
        self.paragraph = (usize::MAX, usize::MAX);
    }

    /// Sets a definition of several lines, annotations counted, apart from those around it by a blank line.
    pub fn close_paragraph(&mut self) {
        let (lines, first) = self.paragraph;
        let is_long = self.out.get(first..).is_some_and(|text| text.contains('\n'));
        if (is_long || self.was_long) && lines > 0 && lines < self.out.len() && !self.out[..lines].ends_with("\n\n") {
            self.out.insert(lines, '\n');
            self.marks.iter_mut().rev().take_while(|mark| mark.offset >= lines).for_each(|mark| mark.offset += 1);
        }
        self.was_long = is_long;
    }

    // ---- what fits

    /// Whether all before a token, and what closes right after it, fits into the line.
    pub fn fits(&self, end: usize) -> bool {
        match self.pending {
            Some(to) => self.fits_at(to.indent, end),
            None => self.breaks_between(self.at, end) == 0 && self.column + self.width(self.at, end) <= WIDTH,
        }
    }

    /// The same on a line of its own after so many blanks.
    pub fn fits_at(&self, indent: usize, end: usize) -> bool {
        let own = indent + self.width(self.at, end) - self.lead(self.at);
        self.at >= end || self.breaks_between(self.at + 1, end) == 0 && own <= WIDTH
    }

    fn width(&self, start: usize, end: usize) -> usize {
        self.widths[self.closed(end)] - self.widths[start]
    }

    /// The width of what stands before a token in its line.
    fn lead(&self, at: usize) -> usize {
        match self.gaps[at].comments.is_empty() {
            true => usize::from(self.blanks.get(at) == Some(&true)),
            false => self.gaps[at].width() + 1,
        }
    }

    fn breaks_between(&self, start: usize, end: usize) -> usize {
        self.breaks[end.max(start)] - self.breaks[start]
    }

    /// One past the brackets and commas that follow without a blank of their own.
    fn closed(&self, end: usize) -> usize {
        let ends = |at: &usize| !self.sticks(*at) || !self.gaps[*at].comments.is_empty();
        (end..).find(ends).unwrap_or(end)
    }

    /// Whether the token is a closing bracket or a comma.
    fn sticks(&self, at: usize) -> bool {
        matches!(self.kind(at), Some(Kind::Close | Kind::Comma | Kind::Semicolon))
    }

    /// Whether the token must begin a line: the author had it so, or a comment wants it.
    pub fn must_break(&self, at: usize) -> bool {
        self.breaks[at + 1] > self.breaks[at]
    }

    /// Whether a line ended before the token.
    pub fn began_line(&self, at: usize) -> bool {
        self.gaps[at].lines > 0
    }

    /// Whether the gap before the token holds comments that want a line end.
    pub fn has_breaking_comment(&self, at: usize) -> bool {
        self.gaps[at].breaks()
    }

    /// Whether nothing but blanks stands in the line, or will.
    pub fn is_at_start(&self) -> bool {
        self.pending.is_some() || self.column <= self.indent
    }

    /// The token as the scanner sees it.
    pub fn kind(&self, at: usize) -> Option<Kind> {
        self.tokens.get(at).map(|token| token.kind)
    }

    /// The index of a bracket's partner.
    pub fn partner(&self, at: usize) -> usize {
        self.tokens[at].link as usize
    }

    /// The tokens with what spacing knows of them.
    pub fn spaced(&self) -> Spaced<'t> {
        Spaced { text: self.text, tokens: self.tokens, in_body: &self.structure.in_body }
    }
}

fn widths(text: &str, tokens: &[Token], gaps: &[Gap], blanks: &[bool]) -> Vec<usize> {
    let width = |at: usize| {
        let token = &text[tokens[at].start as usize..tokens[at].end as usize];
        let comments = gaps[at].width();
        token.chars().count() + comments + usize::from(blanks[at] || comments > 0)
    };
    sums((0..tokens.len()).map(width))
}

fn breaks(gaps: &[Gap], structure: &Structure) -> Vec<usize> {
    let has_line = |gap: &Gap| gap.lines > 0 || gap.comments.iter().any(|comment| comment.lines > 0);
    let breaks = |(gap, keeps): (&Gap, &bool)| usize::from(gap.breaks() || *keeps && has_line(gap));
    sums(gaps.iter().zip(&structure.keeps_line).map(breaks))
}

/// The sums of all before each, and of all.
fn sums(numbers: impl Iterator<Item = usize>) -> Vec<usize> {
    std::iter::once(0)
        .chain(numbers.scan(0, |sum, number| {
            *sum += number;
            Some(*sum)
        }))
        .collect()
}
