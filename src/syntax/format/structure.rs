//! What belongs together: operations, alternatives, arms, arguments, read from the tokens of a file that parses.
//!
//! No second grammar: what is right has been decided, and nothing here can refuse or lose a token. Brackets have their
//! partners, so it takes no look-ahead but that for a `%` with a colon.

use crate::syntax::outline::{Piece, PieceKind};
use crate::syntax::token::{Kind, NONE, Token};
use std::ops::Range;

/// How a part is laid out where it does not fit into a line.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Shape {
    /// Operations in a row.
    Ops,
    /// `case` or percentages: arms.
    Choice,
    /// Head, colon, content.
    Arm,
    /// Head, separator, content; or content alone.
    Entry,
    /// One operation with its arguments and blocks.
    Op,
    /// Brackets with things between commas.
    List,
    /// `with ( … )`: brackets with definitions in a row.
    Locals,
    /// `[ … ]` around a successor.
    Push,
    /// Braces with alternatives between bars.
    Block,
    /// Operands and operators.
    Value,
}

/// A stretch of tokens with a layout, and the parts in it.
#[derive(Debug)]
pub(super) struct Part {
    /// The layout.
    pub shape: Shape,
    /// Its tokens.
    pub tokens: Range<usize>,
    /// The parts inside, in order; tokens between them are written as they come.
    pub parts: Vec<Part>,
}

/// The parts of each piece of a file, and of each token whether it is a bracket or a `*` of a successor.
pub(super) struct Structure {
    /// One list for each piece.
    pub pieces: Vec<Vec<Part>>,
    /// One for each token.
    pub in_body: Vec<bool>,
    /// Of each token whether a line end before it, where the author made one, stays.
    pub keeps_line: Vec<bool>,
}

/// Reads a file's structure. Cost: linear.
pub(super) fn read(text: &str, tokens: &[Token], pieces: &[Piece]) -> Structure {
    let (in_body, keeps_line) = (vec![false; tokens.len() + 1], vec![false; tokens.len() + 1]);
    let mut reader = Reader { text, tokens, at: 0, in_body, keeps_line };
    let pieces = pieces.iter().map(|piece| reader.piece(piece)).collect();
    Structure { pieces, in_body: reader.in_body, keeps_line: reader.keeps_line }
}

struct Reader<'t> {
    text: &'t str,
    tokens: &'t [Token],
    at: usize,
    in_body: Vec<bool>,
    keeps_line: Vec<bool>,
}

impl Reader<'_> {
    fn piece(&mut self, piece: &Piece) -> Vec<Part> {
        self.at = piece.tokens.start;
        let (end, mut parts) = (piece.tokens.end, Vec::new());
        if !piece.lone.is_empty() {
            return parts;
        }
        while self.at < end {
            match self.kind() {
                Kind::Arrow | Kind::Squiggle => {
                    self.at += 1;
                    parts.push(self.body(end));
                }
                Kind::Equal if piece.kind == PieceKind::Value => {
                    self.at += 1;
                    parts.push(self.value(end));
                }
                Kind::Open if self.is_after(Kind::With) => parts.push(self.locals()),
                Kind::Open => parts.push(self.list()),
                _ => self.at += 1,
            }
        }
        parts
    }

    // ---- successors

    fn body(&mut self, end: usize) -> Part {
        if self.at < end && self.begins_arm() {
            return self.choice(end, Reader::body);
        }
        let (start, mut parts) = (self.at, Vec::new());
        while self.at < end && !self.ends_body() {
            self.keeps_line[self.at] = !parts.is_empty();
            parts.push(self.op(end));
        }
        Part { shape: Shape::Ops, tokens: start..self.at, parts }
    }

    fn ends_body(&self) -> bool {
        let sign = matches!(self.kind(), Kind::Case | Kind::Else | Kind::Bar | Kind::Close | Kind::Colon | Kind::Comma);
        sign || self.begins_arm()
    }

    fn op(&mut self, end: usize) -> Part {
        let (start, mut parts) = (self.at, Vec::new());
        if self.kind() == Kind::Open {
            parts.push(self.push());
            return Part { shape: Shape::Op, tokens: start..self.at, parts };
        }
        let is_inline = self.word() == "inline";
        let perimeter = self.word() == "splitAndSetbackPerimeter";
        self.at += 1;
        while self.at < end {
            match (self.kind(), self.word()) {
                (Kind::Open, "(") => parts.push(self.list()),
                (Kind::Open, "{") => {
                    let heads = if perimeter && parts.len() == 1 { 2 } else { 1 };
                    parts.push(self.block(heads, Reader::body));
                    self.star();
                }
                (Kind::Dot, _) => self.at += 1 + usize::from(self.is_member()),
                _ => break,
            }
        }
        let has_block = parts.last().is_some_and(|part| part.shape == Shape::Block);
        if is_inline && !has_block && self.at < end {
            parts.push(self.op(end));
        }
        Part { shape: Shape::Op, tokens: start..self.at, parts }
    }

    /// Whether the dot here has the name after it, without a blank.
    fn is_member(&self) -> bool {
        let next = self.tokens.get(self.at + 1);
        next.is_some_and(|next| next.kind == Kind::Name && next.start == self.tokens[self.at].end)
    }

    fn push(&mut self) -> Part {
        let (start, close) = self.enter(true);
        let parts = vec![self.body(close)];
        self.leave(Shape::Push, start, close, parts)
    }

    fn star(&mut self) {
        if self.at < self.tokens.len() && self.word() == "*" {
            self.in_body[self.at] = true;
            self.at += 1;
        }
    }

    fn block(&mut self, heads: usize, content: Content<Self>) -> Part {
        let (start, close) = self.enter(true);
        let mut parts = Vec::new();
        while self.at < close {
            if self.kind() == Kind::Bar {
                self.keeps_line[self.at] = true;
                self.at += 1;
            } else {
                parts.push(self.entry(heads, close, content));
            }
        }
        self.leave(Shape::Block, start, close, parts)
    }

    fn entry(&mut self, heads: usize, end: usize, content: Content<Self>) -> Part {
        let (start, mut parts) = (self.at, Vec::new());
        if self.kind() == Kind::Open && self.word() == "{" {
            parts.push(self.block(heads, content));
            self.star();
        } else {
            for _ in 0..heads {
                let Some(separator) = self.separator(end) else { break };
                parts.push(self.value(separator));
                self.at = separator + 1;
            }
            parts.push(content(self, end));
        }
        self.at = self.at.max(start + 1);
        Part { shape: Shape::Entry, tokens: start..self.at, parts }
    }

    /// The sign after the head that begins here, if one does.
    fn separator(&self, end: usize) -> Option<usize> {
        if self.begins_arm() {
            return None;
        }
        let mut level = self.level(self.at, end);
        let sign = level.find(|at| {
            matches!(self.tokens[*at].kind, Kind::Colon | Kind::Equal | Kind::Joined | Kind::Bar | Kind::Case)
        })?;
        let is_sign = matches!(self.tokens[sign].kind, Kind::Colon | Kind::Equal | Kind::Joined);
        (is_sign && self.tokens[sign - 1].kind != Kind::Percent).then_some(sign)
    }

    // ---- choices

    /// Whether `case`, or an operand with `% :` after it, stands here.
    fn begins_arm(&self) -> bool {
        let kind = |at: usize| self.tokens.get(at).map(|token| token.kind);
        let after = match self.kind() {
            Kind::Case => return true,
            Kind::Number => self.at + 1,
            Kind::Open if self.word() == "(" => self.after_bracket(self.at),
            Kind::Name if kind(self.at + 1) == Some(Kind::Open) && self.word_at(self.at + 1) == "(" => {
                self.after_bracket(self.at + 1)
            }
            Kind::Name => self.at + 1,
            _ => return false,
        };
        kind(after) == Some(Kind::Percent) && kind(after + 1) == Some(Kind::Colon)
    }

    fn choice(&mut self, end: usize, content: Content<Self>) -> Part {
        let (start, mut parts) = (self.at, Vec::new());
        while self.at < end && (self.kind() == Kind::Else || self.begins_arm()) {
            self.keeps_line[self.at] = !parts.is_empty();
            let is_last = self.kind() == Kind::Else;
            parts.push(self.arm(end, content));
            if is_last {
                break;
            }
        }
        Part { shape: Shape::Choice, tokens: start..self.at, parts }
    }

    fn arm(&mut self, end: usize, content: Content<Self>) -> Part {
        let (start, mut parts) = (self.at, Vec::new());
        let colon = self.level(start, end).find(|at| self.tokens[*at].kind == Kind::Colon);
        if let Some(colon) = colon {
            self.at += usize::from(self.kind() == Kind::Case);
            let head = self.at;
            if self.kind() != Kind::Else && self.tokens[colon - 1].kind != Kind::Percent {
                parts.push(self.value(colon));
            }
            self.at = colon.max(head) + 1;
        }
        parts.push(content(self, end));
        self.at = self.at.max(start + 1);
        Part { shape: Shape::Arm, tokens: start..self.at, parts }
    }

    // ---- values

    fn value(&mut self, end: usize) -> Part {
        let (start, mut parts) = (self.at, Vec::new());
        while self.at < end && !self.ends_value(start) {
            match (self.kind(), self.word()) {
                _ if self.begins_arm() => parts.push(self.choice(end, Reader::value)),
                (Kind::Arrow, _) => {
                    self.at += 1;
                    parts.push(self.body(end));
                }
                (Kind::Open, "{") if self.is_after(Kind::Close) => parts.push(self.values_block()),
                (Kind::Open, _) => parts.push(self.list()),
                _ => self.at += 1,
            }
        }
        Part { shape: Shape::Value, tokens: start..self.at, parts }
    }

    fn values_block(&mut self) -> Part {
        let open = self.at;
        let block = self.block(1, Reader::value);
        self.in_body[open] = false;
        block
    }

    fn ends_value(&self, start: usize) -> bool {
        match self.kind() {
            Kind::Comma | Kind::Semicolon | Kind::Bar | Kind::Close | Kind::Colon | Kind::Else => true,
            Kind::Name if self.tokens.get(self.at + 1).is_some_and(|next| next.kind == Kind::Joined) => self.at > start,
            _ => self.at > start && self.follows_operand() && self.begins_arm(),
        }
    }

    /// Whether the token before ends an operand, so that none can follow but that of another arm.
    fn follows_operand(&self) -> bool {
        matches!(self.tokens[self.at - 1].kind, Kind::Name | Kind::Number | Kind::Text | Kind::Close)
    }

    fn list(&mut self) -> Part {
        let (start, close) = self.enter(false);
        let mut parts = Vec::new();
        while self.at < close {
            if matches!(self.kind(), Kind::Comma | Kind::Semicolon | Kind::Colon) {
                self.at += 1;
                continue;
            }
            let before = self.at;
            parts.push(self.value(close));
            self.at = self.at.max(before + 1);
        }
        self.leave(Shape::List, start, close, parts)
    }

    fn locals(&mut self) -> Part {
        let (start, close) = self.enter(false);
        let mut parts = Vec::new();
        while self.at < close {
            self.keeps_line[self.at] = !parts.is_empty();
            let name = self.at;
            self.at = (name + 2).min(close);
            let mut local = self.value(close);
            local.tokens.start = name;
            parts.push(local);
        }
        self.leave(Shape::Locals, start, close, parts)
    }

    // ---- tokens

    /// Steps over the bracket here; its place and its partner's.
    fn enter(&mut self, in_body: bool) -> (usize, usize) {
        let (open, close) = (self.at, self.after_bracket(self.at) - 1);
        (self.in_body[open], self.in_body[close]) = (in_body, in_body);
        self.at += 1;
        (open, close)
    }

    fn leave(&mut self, shape: Shape, start: usize, close: usize, parts: Vec<Part>) -> Part {
        self.at = close + 1;
        Part { shape, tokens: start..self.at, parts }
    }

    /// One past the partner of a bracket.
    fn after_bracket(&self, open: usize) -> usize {
        match self.tokens[open].link {
            NONE => open + 1,
            close => close as usize + 1,
        }
    }

    /// The tokens of a stretch outside brackets.
    fn level(&self, start: usize, end: usize) -> impl Iterator<Item = usize> {
        let next = move |at: usize| if self.tokens[at].kind == Kind::Open { self.after_bracket(at) } else { at + 1 };
        std::iter::successors(Some(start), move |at| Some(next(*at))).take_while(move |at| *at < end)
    }

    fn is_after(&self, kind: Kind) -> bool {
        self.at > 0 && self.tokens[self.at - 1].kind == kind
    }

    fn kind(&self) -> Kind {
        self.tokens[self.at].kind
    }

    fn word(&self) -> &str {
        self.word_at(self.at)
    }

    fn word_at(&self, at: usize) -> &str {
        &self.text[self.tokens[at].start as usize..self.tokens[at].end as usize]
    }
}

/// Reads what stands after a colon: a successor or a value.
type Content<R> = fn(&mut R, usize) -> Part;
