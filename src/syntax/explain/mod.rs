//! What is wrong with a piece that cannot be parsed, in words that help.
//!
//! pest tells how far it came and what it would have taken there. That is the last resort: most mistakes are habits of
//! other languages or a forgotten sign, and are recognised in the tokens (`habits`, `choices`). This runs only for
//! pieces that are broken, so it decides nothing about what is right. One diagnostic per piece.

mod choices;
mod expected;
mod habits;
mod words;

use super::ast::Name;
use super::depth;
use super::grammar::Rule;
use super::outline::{MAX_DEPTH, Piece};
use super::token::{Kind, NONE, Token};
use crate::diag::{Diagnostic, Span};
use crate::text;
use pest::error::{Error, ErrorVariant, InputLocation};

/// A piece of a file that is, or may be, broken.
pub(super) struct Broken<'t> {
    /// The file's number.
    pub file: u16,
    /// The whole text.
    pub text: &'t str,
    /// All tokens.
    pub tokens: &'t [Token],
    /// The piece.
    pub piece: &'t Piece,
}

/// Every annotation there is: CityEngine's and ours.
const ANNOTATIONS: [&str; 25] = [
    "Angle",
    "Color",
    "Context",
    "Description",
    "Directory",
    "DisplayName",
    "Distance",
    "Enum",
    "File",
    "Group",
    "Handle",
    "Hidden",
    "InLine",
    "InMesh",
    "InPoint",
    "InPointCloud",
    "InPolygon",
    "MaterialFile",
    "Order",
    "Out",
    "Percent",
    "Range",
    "RuleFileDescription",
    "StartRule",
    "Zone",
];

/// A lint for an annotation nobody reads.
pub(super) fn unknown_annotation(name: &Name) -> Option<Diagnostic> {
    if ANNOTATIONS.contains(&&*name.text) {
        return None;
    }
    let message = format!("nothing reads the annotation `@{}`", name.text);
    let lint = Diagnostic::lint("syntax-annotation", name.span, message);
    Some(lint.did_you_mean(text::nearest(&name.text, ANNOTATIONS).map(|name| format!("@{name}")).as_deref()))
}

impl<'t> Broken<'t> {
    /// What makes parsing useless or unsafe: an open text, a lone bracket, too deep a nesting.
    pub fn before_parsing(&self) -> Option<Diagnostic> {
        let unclosed = || self.piece.tokens.clone().find(|index| self.kind(*index) == Some(Kind::Unclosed));
        if let Some(index) = unclosed() {
            return Some(self.unclosed(index));
        }
        if let Some(lone) = self.piece.lone.first() {
            return Some(self.lone_bracket(*lone));
        }
        if let Some(index) = self.piece.too_deep {
            let message = format!("brackets nest deeper than {MAX_DEPTH} here");
            return Some(self.limit(index, message));
        }
        let range = self.piece.tokens.clone();
        let high = depth::too_high(&self.tokens[range.clone()], range.start)?;
        let message = format!("operators and choices nest deeper than {} here", depth::MAX_HEIGHT);
        Some(self.limit(range.start + high, message))
    }

    /// Why pest refused the piece.
    pub fn explain(&self, error: &Error<Rule>) -> Diagnostic {
        let at = match error.location {
            InputLocation::Pos(at) | InputLocation::Span((at, _)) => self.piece.bytes.start + at as u32,
        };
        let place = self.piece.tokens.clone().find(|index| self.tokens[*index].end > at);
        match &error.variant {
            ErrorVariant::ParsingError { positives, .. } => self
                .habit(place)
                .or_else(|| self.broken_choice())
                .or_else(|| self.slip(place))
                .unwrap_or_else(|| self.expected(place, positives)),
            ErrorVariant::CustomError { .. } => self.limit(
                place.unwrap_or(self.piece.tokens.start),
                "this definition nests too deep for the space there is".to_owned(),
            ),
        }
    }

    fn unclosed(&self, index: usize) -> Diagnostic {
        if self.word(index).starts_with("/*") {
            let message = "this comment is never closed";
            return self.error("syntax-comment", self.first_two(index), message).hint("write `*/` where it ends");
        }
        let message = "this text is never closed";
        self.error("syntax-text", self.span(index), message).hint("write `\"` where it ends")
    }

    fn first_two(&self, index: usize) -> Span {
        let span = self.span(index);
        Span { end: (span.start + 2).min(span.end), ..span }
    }

    fn lone_bracket(&self, index: usize) -> Diagnostic {
        let bracket = self.word(index);
        if self.kind(index) == Some(Kind::Close) {
            let message = format!("`{bracket}` closes nothing: there is no `{}` before it", partner(bracket));
            return self.error("syntax-bracket", self.span(index), message);
        }
        let other = self.piece.lone.iter().find(|lone| self.kind(**lone) == Some(Kind::Close));
        let message = match other {
            Some(other) => {
                let line = self.text[..self.tokens[*other].start as usize].matches('\n').count() + 1;
                let wrong = self.word(*other);
                format!(
                    "`{bracket}` is never closed by `{}`; a lone `{wrong}` follows in line {line}",
                    partner(bracket)
                )
            }
            None => format!("`{bracket}` is never closed: its `{}` is missing", partner(bracket)),
        };
        self.error("syntax-bracket", self.span(index), message)
    }

    fn limit(&self, index: usize, message: String) -> Diagnostic {
        let hint = "break the definition up into rules or functions of their own";
        self.error("syntax-limit", self.span(index), message).hint(hint)
    }

    fn error(&self, code: &'static str, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::error(code, span, message)
    }

    fn kind(&self, index: usize) -> Option<Kind> {
        self.tokens.get(index).filter(|_| self.piece.tokens.contains(&index)).map(|token| token.kind)
    }

    /// The kind of the token before `index`, inside the piece.
    fn kind_before(&self, index: usize) -> Option<Kind> {
        index.checked_sub(1).and_then(|before| self.kind(before))
    }

    fn word(&self, index: usize) -> &'t str {
        self.tokens.get(index).map_or("", |token| &self.text[token.start as usize..token.end as usize])
    }

    fn span(&self, index: usize) -> Span {
        let token = self.tokens[index];
        Span { file: self.file, start: token.start, end: token.end }
    }

    /// The place of a token, or of the piece's end.
    fn place(&self, index: Option<usize>) -> Span {
        index.map_or_else(|| self.span(self.piece.tokens.end - 1), |index| self.span(index))
    }

    /// What was found there, in words.
    fn found(&self, index: Option<usize>) -> String {
        match index {
            None => "the end of the definition".to_owned(),
            Some(index) => match self.word(index) {
                word if word.chars().count() > 40 => format!("`{}…`", word.chars().take(39).collect::<String>()),
                word => format!("`{word}`"),
            },
        }
    }

    /// The opening bracket around a token (or around the piece's end: none).
    fn opener(&self, index: usize) -> Option<usize> {
        let mut at = index;
        while at > self.piece.tokens.start {
            at -= 1;
            match self.tokens[at] {
                Token { kind: Kind::Close, link, .. } if link != NONE => at = link as usize,
                Token { kind: Kind::Open, .. } => return Some(at),
                _ => {}
            }
        }
        None
    }

    /// The first token of what ends at `last`: a name, a number, `f(…)`, `(…)`.
    fn operand_start(&self, last: usize) -> usize {
        let start = match self.tokens[last] {
            Token { kind: Kind::Close, link, .. } if link != NONE => link as usize,
            _ => return last,
        };
        let called = self.kind_before(start) == Some(Kind::Name);
        start - usize::from(called)
    }
}

fn partner(bracket: &str) -> &'static str {
    match bracket {
        "(" => ")",
        "[" => "]",
        "{" => "}",
        ")" => "(",
        "]" => "[",
        _ => "{",
    }
}
