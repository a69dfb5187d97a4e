//! Words and signs of other languages, told by what stands where parsing stopped.

use super::Broken;
use crate::diag::Diagnostic;
use crate::syntax::outline::PieceKind;
use crate::syntax::token::{Kind, NONE, Token};

/// Quotes that word processors make.
const QUOTES: [&str; 8] = ["“", "”", "„", "‘", "’", "«", "»", "`"];

/// Dashes that word processors make of a minus.
const DASHES: [&str; 4] = ["–", "—", "−", "‐"];

/// Words that other languages begin definitions with.
const WORDS: [&str; 7] = ["rule", "function", "func", "def", "var", "let", "val"];

impl Broken<'_> {
    /// `elseif`, `else if`
    pub(super) fn else_if(&self) -> Option<Diagnostic> {
        let range = self.piece.tokens.clone();
        let found = |at: &usize| match self.kind(*at) {
            Some(Kind::Else) => matches!(self.word(at + 1), "if" | "case"),
            Some(Kind::Name) => {
                matches!(self.word(*at), "elseif" | "elsif" | "elif" | "elseIf" | "elsecase")
                    && !matches!(self.kind(at + 1), Some(Kind::Open | Kind::Arrow | Kind::Equal))
            }
            _ => false,
        };
        let at = range.clone().find(found)?;
        let last = if self.kind(at) == Some(Kind::Else) { at + 1 } else { at };
        let span = self.span(at).to(self.span(last));
        let words = &self.text[span.start as usize..span.end as usize];
        let message = format!("there is no `{words}`");
        let hint = "each further condition is one more `case`: `case a : X  case b : Y  else : Z`";
        Some(self.error("syntax-case", span, message).hint(hint))
    }

    /// Words and signs that mean something elsewhere.
    pub(super) fn foreign(&self, at: usize) -> Option<Diagnostic> {
        self.worded_operator(at)
            .or_else(|| self.value_sign(at))
            .or_else(|| self.typeset(at))
            .or_else(|| self.foreign_operator(at))
            .or_else(|| self.lone_star(at))
            .or_else(|| self.bare_argument(at))
    }

    /// `a and b`, `not a`
    fn worded_operator(&self, at: usize) -> Option<Diagnostic> {
        let words = [at.checked_sub(1), Some(at)].into_iter().flatten();
        let at = words.rev().find(|at| {
            self.kind(*at) == Some(Kind::Name) && matches!(self.word(*at), "and" | "or" | "not" | "AND" | "OR" | "NOT")
        })?;
        let sign = match self.word(at) {
            "and" | "AND" => "&&",
            "or" | "OR" => "||",
            _ => "!",
        };
        let word = self.word(at);
        let message = format!("`{word}` is no operator");
        Some(self.error("syntax", self.span(at), message).hint(format!("{} is written `{sign}`", word.to_lowercase())))
    }

    /// `attr x : 3`, `attr x := 3`, `attr x == 3`, `attr x 3`
    fn value_sign(&self, at: usize) -> Option<Diagnostic> {
        let start = self.piece.tokens.start;
        let at = if self.word(at) == "=" { at } else { at.min(start + 2) };
        let declares = matches!(self.kind(start), Some(Kind::Attr | Kind::Const)) && at == start + 2;
        if !declares
            || !matches!(self.kind(at), Some(Kind::Colon | Kind::Joined | Kind::Logic | Kind::Number | Kind::Text))
        {
            return None;
        }
        let (word, name) = (self.word(start), self.word(start + 1));
        let message = format!("expected `=` before the value of `{name}`, found {}", self.found(Some(at)));
        Some(self.error("syntax", self.span(at), message).hint(format!("write `{word} {name} = …`")))
    }

    /// `“red”`, `4 – 3`
    fn typeset(&self, at: usize) -> Option<Diagnostic> {
        let word = self.word(at);
        if QUOTES.contains(&word) {
            let message = format!("`{word}` does not begin a text");
            let hint = "texts stand in straight double quotes: `\"red\"`";
            return Some(self.error("syntax-text", self.span(at), message).hint(hint));
        }
        if DASHES.contains(&word) {
            let message = format!("`{word}` is a dash and no minus");
            return Some(self.error("syntax", self.span(at), message).hint("write `-`, as on the keyboard"));
        }
        None
    }

    /// `2 ^ 3`, `2 ** 3`, `a <> b`, `"a" . "b"`
    fn foreign_operator(&self, at: usize) -> Option<Diagnostic> {
        let before = at.checked_sub(1).filter(|before| self.kind(*before).is_some());
        let glued = before.filter(|before| self.tokens[*before].end == self.tokens[at].start);
        let pair = glued.map(|before| (before, self.word(before), self.word(at)));
        let (first, hint) = match (self.word(at), pair) {
            ("^", _) => (at, "a power is written `pow(a, b)`"),
            (_, Some((first, "*", "*"))) => (first, "a power is written `pow(a, b)`"),
            (_, Some((first, "<", ">"))) => (first, "unequal is written `!=`"),
            (".", _) if before.is_some_and(|before| self.kind(before) == Some(Kind::Text)) => {
                (at, "texts are joined with `+`")
            }
            _ => return None,
        };
        let span = self.span(first).to(self.span(at));
        let message = format!("there is no operator `{}`", &self.text[span.start as usize..span.end as usize]);
        Some(self.error("syntax", span, message).hint(hint))
    }

    /// `A * B` in a successor.
    fn lone_star(&self, at: usize) -> Option<Diagnostic> {
        if self.word(at) != "*" || !self.is_in_body(at) {
            return None;
        }
        let hint = "a `*` stands right behind the braces of a split: `split(x){ ~2 : A }*`";
        Some(self.error("syntax-block", self.span(at), "`*` repeats nothing here").hint(hint))
    }

    /// `extrude 3`
    fn bare_argument(&self, at: usize) -> Option<Diagnostic> {
        let operation = at.checked_sub(1).filter(|before| self.kind(*before) == Some(Kind::Name))?;
        let is_value =
            matches!(self.kind(at), Some(Kind::Number | Kind::Text)) && self.kind(at + 1) != Some(Kind::Percent);
        if !is_value || !self.is_in_body(at) || self.level_has_colon(at) {
            return None;
        }
        let (name, value) = (self.word(operation), self.word(at));
        let message = format!("the arguments of `{name}` stand in parentheses");
        Some(self.error("syntax-arguments", self.span(at), message).hint(format!("write `{name}({value})`")))
    }

    /// Whether the token stands in a rule's successor rather than in parentheses.
    fn is_in_body(&self, at: usize) -> bool {
        let arrow = |index: usize| matches!(self.kind(index), Some(Kind::Arrow | Kind::Squiggle));
        (self.piece.tokens.start..at).any(arrow) && self.opener(at).is_none_or(|opener| self.word(opener) != "(")
    }

    /// Whether the token after the value is a colon: a size, with something missing before it.
    fn level_has_colon(&self, at: usize) -> bool {
        matches!(self.kind(at + 1), Some(Kind::Colon | Kind::Equal | Kind::Joined))
    }

    /// `@Range 0 10`: what follows an annotation without parentheses.
    pub(super) fn bare_note(&self) -> Option<Diagnostic> {
        let start = self.piece.tokens.start;
        let name = start.checked_sub(1)?;
        let is_noted = self.tokens[name].kind == Kind::Name && name > 0 && self.tokens[name - 1].kind == Kind::At;
        if !is_noted || !matches!(self.kind(start), Some(Kind::Number | Kind::Text | Kind::Sign)) {
            return None;
        }
        let name = self.word(name);
        let message = format!("the arguments of `@{name}` stand in parentheses");
        Some(self.error("syntax-annotation", self.span(start), message).hint(format!("write `@{name}(…)`")))
    }

    /// `rule Lot --> …`, `function f(x) = …`
    pub(super) fn needless_word(&self) -> Option<Diagnostic> {
        let start = self.piece.tokens.start;
        if !WORDS.contains(&self.word(start)) || self.piece.tokens.len() > 1 {
            return None;
        }
        let message = format!("there is no `{}` before a definition", self.word(start));
        let hint = "a rule is written `Lot --> …`, a function `f(x) = …`, an attribute `attr a = …`";
        Some(self.error("syntax", self.span(start), message).hint(hint))
    }

    /// `attr a = 10%`
    pub(super) fn percent_of_nothing(&self) -> Option<Diagnostic> {
        let last = self.piece.tokens.end - 1;
        if self.kind(last) != Some(Kind::Percent) || self.piece.kind != PieceKind::Value {
            return None;
        }
        let message = "`%` is the remainder of a division, and nothing follows it";
        let hint = "a share is written `0.1`, a share of the scope `'0.1`";
        Some(self.error("syntax-number", self.span(last), message).hint(hint))
    }

    /// Whether the bracket that opens here holds the parameters of the definition.
    pub(super) fn holds_parameters(&self, opener: usize) -> bool {
        let first = opener == self.piece.tokens.start + 1;
        let after = match self.tokens[opener] {
            Token { link, .. } if link != NONE => self.kind(link as usize + 1),
            _ => None,
        };
        first && matches!(after, Some(Kind::Arrow | Kind::Equal | Kind::Squiggle))
    }
}
