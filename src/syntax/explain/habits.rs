//! Habits from other languages, and slips of the pen: what was written, and what would do.

use super::Broken;
use crate::diag::Diagnostic;
use crate::syntax::outline::PieceKind;
use crate::syntax::token::{Kind, NONE, Token};

impl Broken<'_> {
    /// Habits that are told by their signs wherever they stand in the piece.
    pub(super) fn habit(&self, place: Option<usize>) -> Option<Diagnostic> {
        self.bent_arrow()
            .or_else(|| self.quotes())
            .or_else(|| self.ternary())
            .or_else(|| self.else_if())
            .or_else(|| self.if_(place))
    }

    /// Mistakes told by what stands where parsing stopped.
    pub(super) fn slip(&self, place: Option<usize>) -> Option<Diagnostic> {
        self.import().or_else(|| self.no_arrow()).or_else(|| self.percent_of_nothing()).or_else(|| {
            let at = place?;
            self.foreign(at)
                .or_else(|| self.sign(at))
                .or_else(|| self.unit(at))
                .or_else(|| self.no_bar(at))
                .or_else(|| self.no_colon(at))
                .or_else(|| self.no_comma(at))
        })
    }

    fn find(&self, kind: Kind) -> Option<usize> {
        self.piece.tokens.clone().find(|index| self.tokens[*index].kind == kind)
    }

    /// `Lot -- > …`, `Lot -> …`, `a => b`
    fn bent_arrow(&self) -> Option<Diagnostic> {
        let at = self.find(Kind::Bent)?;
        let written = self.word(at);
        let header = at.checked_sub(1).map(|last| self.operand_start(last)) == Some(self.piece.tokens.start);
        if written == "=>" && !header {
            let message = "`=>` compares nothing";
            return Some(self.error("syntax", self.span(at), message).hint("at least is written `>=`"));
        }
        let message = format!("`{written}` is no arrow");
        if self.opener(at).is_some_and(|opener| self.word(opener) == "{") {
            let hint = "in a block a `:` stands before a successor: `{ 1 : A | 2 : B }`";
            return Some(self.error("syntax-arrow", self.span(at), message).hint(hint));
        }
        let hint = match written.starts_with(['~', '↝', '⇝']) {
            true => "the papers' arrow is `~>`, without a blank",
            false => "a rule is written `Lot --> …`, the arrow without a blank",
        };
        Some(self.error("syntax-arrow", self.span(at), message).hint(hint))
    }

    /// `'text'`
    fn quotes(&self) -> Option<Diagnostic> {
        let mark = |index: usize| self.kind(index) == Some(Kind::Mark) && self.word(index) == "'";
        let range = self.piece.tokens.clone();
        let open = range.clone().find(|at| {
            mark(*at)
                && (at + 1..at + 5).find(|end| mark(*end)).is_some_and(|end| {
                    end > at + 1
                        && (at + 1..end)
                            .all(|word| matches!(self.kind(word), Some(Kind::Name | Kind::Number | Kind::Dot)))
                })
        })?;
        let close = (open + 1..range.end).find(|end| mark(*end))?;
        let message = "single quotes do not make a text; `'` marks a size relative to the scope";
        let text = &self.text[self.tokens[open].end as usize..self.tokens[close].start as usize];
        let span = self.span(open).to(self.span(close));
        Some(self.error("syntax-text", span, message).hint(format!("write `\"{text}\"`")))
    }

    /// `a ? b : c`
    fn ternary(&self) -> Option<Diagnostic> {
        let at = self.piece.tokens.clone().find(|at| self.word(*at) == "?")?;
        let message = "`?` chooses nothing here";
        Some(
            self.error("syntax-case", self.span(at), message)
                .hint("write `case a : b else : c`, also inside arguments"),
        )
    }

    /// `if (a) …`, `for …`
    fn if_(&self, place: Option<usize>) -> Option<Diagnostic> {
        let end = place.unwrap_or(self.piece.tokens.end);
        let words = self.piece.tokens.start..end.saturating_add(1).min(self.piece.tokens.end);
        let foreign = |at: usize| self.kind(at) == Some(Kind::Name) && !self.names_something(at);
        let at = words.rev().find(|at| {
            foreign(*at) && matches!(self.word(*at), "if" | "elif" | "switch" | "while" | "for" | "return")
        })?;
        let word = self.word(at);
        let hint = match word {
            "while" | "for" => {
                "there are no loops: a rule that calls itself repeats, and so do `split(x){ … }*` and `scatter`"
            }
            "return" => "the value of a function is what stands after its `=`",
            _ => "write `case a : X  case b : Y  else : Z`",
        };
        Some(self.error("syntax-case", self.span(at), format!("there is no `{word}`")).hint(hint))
    }

    /// Whether a word is the name being defined.
    fn names_something(&self, at: usize) -> bool {
        at == self.piece.tokens.start || matches!(self.kind(at + 1), Some(Kind::Arrow | Kind::Equal))
    }

    /// `import Parcel.cga`, `import "x.cga"`
    fn import(&self) -> Option<Diagnostic> {
        let start = self.piece.tokens.start;
        let whole = self.find(Kind::Text).is_some() && self.find(Kind::Colon).is_some();
        if self.piece.kind != PieceKind::Import || whole {
            return None;
        }
        let message = "an import needs a name, a colon and a file in double quotes";
        Some(self.error("syntax-import", self.span(start), message).hint("write `import plants : \"plants.cga\"`"))
    }

    /// `Lot extrude(3)`: neither arrow nor equals sign.
    fn no_arrow(&self) -> Option<Diagnostic> {
        let start = self.piece.tokens.start;
        if self.piece.kind != PieceKind::Stray {
            return None;
        }
        if let Some(known) = self.bare_note().or_else(|| self.needless_word()) {
            return Some(known);
        }
        let word = self.found(Some(start));
        if self.kind(start) != Some(Kind::Name) {
            let message = format!("expected a definition, found {word}");
            return Some(self.error("syntax", self.span(start), message).hint("a rule is written `Lot --> …`"));
        }
        let message = format!("{word} begins no definition: it is followed by neither `-->` nor `=`");
        let name = self.word(start);
        let hint = format!("a rule is written `{name} --> …`, a function `{name}(a) = …`");
        Some(self.error("syntax-arrow", self.span(start), message).hint(hint))
    }

    /// Signs that cannot stand where they do.
    fn sign(&self, at: usize) -> Option<Diagnostic> {
        let percent =
            |index: usize| self.kind(index) == Some(Kind::Percent) && self.kind(index + 1) != Some(Kind::Colon);
        if let Some(percent) = [at, at + 1].into_iter().find(|index| percent(*index)) {
            return Some(self.no_colon_after_percent(percent));
        }
        let around = self.opener(at).map_or("", |opener| self.word(opener));
        let (message, hint) = match (self.tokens[at].kind, self.word(at), around) {
            (Kind::Semicolon, _, "(") => ("`;` cannot stand here", "arguments are separated by commas"),
            (Kind::Semicolon | Kind::Comma, _, "{") if self.ends_part(at) => {
                ("only `|` stands between the parts of a block", "write `{ 1 : A | 2 : B }`")
            }
            (Kind::Comma, _, "") if self.is_decimal(at) => ("`,` makes no number", "decimals have a point: `3.5`"),
            (Kind::Semicolon, ..) => ("`;` ends nothing here", "definitions and operations need no sign at their end"),
            (Kind::Equal, ..) if self.in_condition(at) => ("`=` compares nothing", "equal is written `==`"),
            (Kind::Comma, _, "" | "[" | "{") if self.piece.kind == PieceKind::Rule => {
                ("`,` cannot stand between operations", "operations follow each other with nothing between them")
            }
            (Kind::Arrow, ..) => {
                ("`-->` cannot stand here", "it begins a rule; in a block `:` stands before a successor")
            }
            (Kind::Bar, _, "" | "(" | "[") => ("`|` cannot stand here", "or is written `||`"),
            (Kind::Other, "&", _) => ("`&` is nothing", "and is written `&&`"),
            (Kind::Other, word, _) => {
                let message = format!("`{word}` means nothing in a rule file");
                return Some(self.error("syntax", self.span(at), message));
            }
            _ => return None,
        };
        Some(self.error("syntax", self.span(at), message).hint(hint))
    }

    /// Whether another part with a head follows the sign in its block.
    fn ends_part(&self, at: usize) -> bool {
        let separates = |index: usize| matches!(self.kind(index), Some(Kind::Colon | Kind::Equal | Kind::Joined));
        self.level(at + 1..self.piece.tokens.end).take_while(|i| self.kind(*i) != Some(Kind::Bar)).any(separates)
    }

    /// `3,5`
    fn is_decimal(&self, at: usize) -> bool {
        self.kind_before(at) == Some(Kind::Number) && self.kind(at + 1) == Some(Kind::Number)
    }

    /// Whether the token stands between `case` and its colon.
    fn in_condition(&self, at: usize) -> bool {
        let range = self.piece.tokens.start..at;
        range.rev().find_map(|index| match self.tokens[index].kind {
            Kind::Case => Some(true),
            Kind::Colon | Kind::Else | Kind::Bar | Kind::Arrow => Some(false),
            _ => None,
        }) == Some(true)
    }

    /// `3m`
    fn unit(&self, at: usize) -> Option<Diagnostic> {
        let before = at.checked_sub(1).filter(|before| self.kind(*before) == Some(Kind::Number))?;
        let glued = self.tokens[before].end == self.tokens[at].start && self.kind(at) == Some(Kind::Name);
        glued.then_some(())?;
        let (number, unit) = (self.word(before), self.word(at));
        let message = format!("`{number}{unit}` is no number");
        let hint = format!("units are not written, lengths are metres and angles degrees: `{number}`");
        Some(self.error("syntax-number", self.span(before).to(self.span(at)), message).hint(hint))
    }

    /// `{ 1 : A  2 : B }`: a second head in one alternative.
    fn no_bar(&self, at: usize) -> Option<Diagnostic> {
        let opener = self.opener(at).filter(|opener| self.word(*opener) == "{")?;
        let is_separator = |kind| matches!(kind, Kind::Colon | Kind::Equal | Kind::Joined);
        let part = self.part_start(opener, at);
        let headed = self.level(part..at).any(|index| is_separator(self.tokens[index].kind));
        let within = is_separator(self.tokens[at].kind) || matches!(self.tokens[at].kind, Kind::Logic | Kind::Sign);
        let head = if within { self.operand_start(at.checked_sub(1)?) } else { at };
        let mut rest = self.level(head..self.piece.tokens.end).map(|index| self.tokens[index].kind);
        let heads = rest.find(|kind| is_separator(*kind) || matches!(kind, Kind::Bar | Kind::Case | Kind::Else));
        let after_block = self.word(part) == "{";
        if head <= part || !headed && !after_block && head == at || !heads.is_some_and(is_separator) {
            return None;
        }
        let message = format!("a `|` is missing before {}", self.found(Some(head)));
        let hint = "the parts of a block are separated by bars: `{ 1 : A | 2 : B }`";
        Some(self.error("syntax-block", self.span(head), message).hint(hint))
    }

    /// `{ 3 A }`: a size or selector without its colon.
    fn no_colon(&self, at: usize) -> Option<Diagnostic> {
        let opener = self.opener(at).filter(|opener| self.word(*opener) == "{")?;
        let part = self.part_start(opener, at);
        let colon = |index: &usize| matches!(self.tokens[*index].kind, Kind::Colon | Kind::Equal | Kind::Joined);
        let whole = || self.level(part..self.piece.tokens.end).take_while(|i| self.tokens[*i].kind != Kind::Bar);
        let sized = matches!(self.kind(part), Some(Kind::Number | Kind::Mark));
        let compares = whole().any(|index| matches!(self.kind(index), Some(Kind::Logic | Kind::Sign)));
        if whole().any(|index| colon(&index)) || !(sized || compares) {
            return None;
        }
        let last = at.checked_sub(1).filter(|last| *last >= part).unwrap_or(part);
        let (message, hint) = match sized {
            true => ("a `:` is missing after this size", "write for example `2 : Path` or `~1 : Lawn`"),
            false => ("a `:` is missing after this selector", "write for example `top : Roof` or `all : Part`"),
        };
        Some(self.error("syntax-block", self.span(part).to(self.span(last)), message).hint(hint))
    }

    /// `t(0 1 0)`
    fn no_comma(&self, at: usize) -> Option<Diagnostic> {
        self.opener(at).filter(|opener| matches!(self.word(*opener), "(" | "["))?;
        let ends = matches!(self.kind_before(at), Some(Kind::Name | Kind::Number | Kind::Text | Kind::Close));
        let begins = matches!(self.kind(at), Some(Kind::Name | Kind::Number | Kind::Text | Kind::Mark));
        if !ends || !begins {
            return None;
        }
        let message = format!("a `,` is missing before {}", self.found(Some(at)));
        let hint = match self.opener(at).is_some_and(|opener| self.holds_parameters(opener)) {
            true => "parameters are separated by commas: `Lot(width, depth)`",
            false => "arguments are separated by commas: `t(0, 1, 0)`",
        };
        Some(self.error("syntax-arguments", self.span(at), message).hint(hint))
    }

    /// The first token of the alternative around `at` in the block that opens at `opener`.
    fn part_start(&self, opener: usize, at: usize) -> usize {
        self.level(opener + 1..at).filter(|index| self.tokens[*index].kind == Kind::Bar).last().unwrap_or(opener) + 1
    }

    /// The tokens of a stretch that are not inside brackets opened in it, up to a bracket that closes more.
    fn level(&self, range: std::ops::Range<usize>) -> impl Iterator<Item = usize> {
        let mut at = range.start;
        std::iter::from_fn(move || {
            let index = (at < range.end).then_some(at)?;
            at = match self.tokens[index] {
                Token { kind: Kind::Open, link, .. } if link != NONE => link as usize + 1,
                Token { kind: Kind::Close, .. } => return None,
                _ => index + 1,
            };
            Some(index)
        })
    }
}
