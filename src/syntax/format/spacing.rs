//! Where a blank stands between two tokens of one line.

use crate::syntax::outline::{Piece, PieceKind};
use crate::syntax::token::{Kind, NONE, Token};

/// The tokens of a file with what [`has_blank`] must know of them.
pub(super) struct Spaced<'t> {
    /// The whole text.
    pub text: &'t str,
    /// Its tokens.
    pub tokens: &'t [Token],
    /// For each token whether it is a bracket or `*` of a successor, not of a value.
    pub in_body: &'t [bool],
}

impl Spaced<'_> {
    /// Whether a blank stands before the token at `at`, which is not the first of its piece.
    pub fn has_blank(&self, piece: &Piece, at: usize) -> bool {
        use Kind::{At, Bar, Close, Colon, Comma, Dot, Name, Open, Percent, Semicolon, Sign};
        let (before, kind) = (self.tokens[at - 1].kind, self.tokens[at].kind);
        match (before, kind) {
            (_, Comma | Semicolon) | (At, _) => false,
            (Comma | Semicolon | Bar, _) | (_, Bar) => true,
            (Open, Close) => false,
            (Open, _) => self.is_wide(at - 1),
            (_, Close) => self.is_wide(at),
            _ if self.is_prefix(at - 1) => false,
            (Name, Open) if self.word(at) == "(" => piece.kind == PieceKind::Import && self.is_plain_import(piece, at),
            (_, Open) if self.word(at) == "[" => self.in_body[at] || !self.ends_operand(at - 1),
            (_, Percent) if self.kind(at + 1) == Some(Colon) => false,
            (_, Colon) => !self.is_label(piece, at),
            (_, Sign) if self.in_body[at] => false,
            (_, Dot) => self.dot_has_blank(at),
            (Dot, _) => !self.is_operator_dot(at - 1) && !self.is_member(at - 1),
            _ => true,
        }
    }

    /// Brackets with blanks inside: braces and the brackets of successors, and `with ( … )`; not braces of arrays.
    fn is_wide(&self, bracket: usize) -> bool {
        let opener = match self.tokens[bracket] {
            Token { kind: Kind::Close, link, .. } if link != NONE => link as usize,
            _ => bracket,
        };
        match self.word(opener) {
            "{" => !matches!(self.before(opener), Some(Kind::Open | Kind::Comma | Kind::Equal)) || self.in_body[opener],
            "[" => self.in_body[opener],
            _ => self.before(opener) == Some(Kind::With),
        }
    }

    /// Whether the parenthesis at `at` belongs to the import itself rather than to a call in it.
    fn is_plain_import(&self, piece: &Piece, at: usize) -> bool {
        at == piece.tokens.start + 2
    }

    /// The colon after the id of a rule in the papers' notation.
    fn is_label(&self, piece: &Piece, at: usize) -> bool {
        let second = at == piece.tokens.start + 1;
        second && piece.kind == PieceKind::PaperRule && {
            let rest = at + 1..piece.tokens.end;
            let name = self.kind(rest.start) == Some(Kind::Name);
            name && self.is_header_after(rest.start)
        }
    }

    /// Whether a rule's name stands at `name`: parameters, a condition or the arrow follow it.
    fn is_header_after(&self, name: usize) -> bool {
        let after = match self.tokens.get(name + 1) {
            Some(token) if token.kind == Kind::Open && token.link != NONE => token.link as usize + 1,
            _ => name + 1,
        };
        matches!(self.kind(after), Some(Kind::Colon | Kind::Squiggle))
    }

    fn dot_has_blank(&self, at: usize) -> bool {
        // `B .C` calls `C` of an import, and `B.C` would be one name.
        let blank_stays = self.is_member(at) && self.before(at) == Some(Kind::Name) && !self.touches(at);
        blank_stays || self.is_operator_dot(at)
    }

    /// `.+`, `.!`
    fn is_operator_dot(&self, at: usize) -> bool {
        let sign = matches!(self.kind(at + 1), Some(Kind::Sign | Kind::Logic | Kind::Percent));
        self.kind(at) == Some(Kind::Dot) && sign && self.touches(at + 1)
    }

    /// `plants(height = 3).Tree`
    fn is_member(&self, at: usize) -> bool {
        self.kind(at) == Some(Kind::Dot) && self.kind(at + 1) == Some(Kind::Name) && self.touches(at + 1)
    }

    /// Whether nothing at all stands before the token.
    fn touches(&self, at: usize) -> bool {
        at > 0 && self.tokens[at - 1].end == self.tokens[at].start
    }

    /// A sign that belongs to the operand after it.
    pub fn is_prefix(&self, at: usize) -> bool {
        match self.kind(at) {
            Some(Kind::Mark) => true,
            Some(Kind::Sign) if self.in_body[at] => false,
            Some(Kind::Sign) if self.before(at) == Some(Kind::Dot) => self.word(at) == "!",
            Some(Kind::Sign) => at == 0 || !self.ends_operand(at - 1),
            _ => false,
        }
    }

    /// Whether an operand may end with the token.
    pub fn ends_operand(&self, at: usize) -> bool {
        matches!(self.kind(at), Some(Kind::Name | Kind::Number | Kind::Text | Kind::Close))
    }

    /// Whether a line may be broken before the token, which is an operator between two operands.
    pub fn is_infix(&self, at: usize) -> bool {
        match self.kind(at) {
            Some(Kind::Sign) => !self.in_body[at] && self.before(at) != Some(Kind::Dot) && !self.is_prefix(at),
            Some(Kind::Logic) => self.before(at) != Some(Kind::Dot),
            _ => false,
        }
    }

    fn kind(&self, at: usize) -> Option<Kind> {
        self.tokens.get(at).map(|token| token.kind)
    }

    fn before(&self, at: usize) -> Option<Kind> {
        self.kind(at.checked_sub(1)?)
    }

    fn word(&self, at: usize) -> &str {
        &self.text[self.tokens[at].start as usize..self.tokens[at].end as usize]
    }
}
