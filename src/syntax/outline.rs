//! Tokens → pieces: where each annotation and definition of a rule file begins and ends.
//!
//! Definitions have no terminator, so an end is the next beginning, and a beginning is known by what follows it: the
//! arrow or equals sign after `Name(params)`. Hence the scan looks *back* from the sign, which is linear however deep
//! the parentheses nest. Inside brackets nothing begins, unless they cannot be balanced any more: then an arrow or a
//! keyword at the start of a line is taken for the next definition, and the open bracket is the broken piece's fault.

use super::token::{Kind, NONE, Token};

/// What a piece of a file is, told by its first tokens.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PieceKind {
    /// `@Name(args)`
    Annotation,
    /// `version "…"`
    Version,
    /// `import …`
    Import,
    /// `style …`
    Style,
    /// `attr`, `const`, a function
    Value,
    /// `Name --> …`
    Rule,
    /// `id: Name : cond ~> … : prob`
    PaperRule,
    /// What begins like no definition.
    Stray,
}

/// One annotation or definition.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// What it is.
    pub kind: PieceKind,
    /// Its tokens, as a range of indices.
    pub tokens: std::ops::Range<usize>,
    /// Its bytes, without the blanks after it.
    pub bytes: std::ops::Range<u32>,
    /// Brackets without a partner: indices of tokens, in order.
    pub lone: Vec<usize>,
    /// The first bracket deeper than `MAX_DEPTH`.
    pub too_deep: Option<usize>,
}

/// How deep brackets may nest: so that parsing and building fit into a stack of one megabyte.
pub(super) const MAX_DEPTH: usize = 128;

/// Cuts a file into pieces and links the brackets to their partners. Cost: linear.
pub(super) fn outline(text: &str, tokens: &mut [Token]) -> Vec<Piece> {
    let mut scan = Scan { text, tokens, open: Vec::new(), starts: Vec::new(), lone: Vec::new(), deep: Vec::new() };
    for index in 0..scan.tokens.len() {
        scan.step(index);
    }
    scan.lone.append(&mut scan.open);
    scan.pieces()
}

struct Scan<'t> {
    text: &'t str,
    tokens: &'t mut [Token],
    /// Open brackets.
    open: Vec<usize>,
    /// First tokens of the pieces so far.
    starts: Vec<usize>,
    /// Brackets without a partner.
    lone: Vec<usize>,
    /// Brackets that nest too deep.
    deep: Vec<usize>,
}

impl Scan<'_> {
    fn step(&mut self, index: usize) {
        if index == 0 {
            self.starts.push(0);
        }
        match self.tokens[index].kind {
            Kind::Open => self.open(index),
            Kind::Close => self.close(index),
            Kind::At | Kind::Attr | Kind::Const | Kind::Import => self.keyword(index),
            Kind::Name => self.word(index),
            Kind::Arrow | Kind::Squiggle | Kind::Equal | Kind::Bent => self.sign(index),
            _ => {}
        }
    }

    fn open(&mut self, index: usize) {
        self.open.push(index);
        if self.open.len() > MAX_DEPTH {
            self.deep.push(index);
        }
    }

    /// Joins a closing bracket with its opening one; what is open above that stays without a partner.
    fn close(&mut self, index: usize) {
        let wanted = match self.char(index) {
            b')' => b'(',
            b']' => b'[',
            _ => b'{',
        };
        // Beyond the nesting limit the piece is lost anyway, and looking further down would not be linear.
        let partner = self.open.iter().rev().take(MAX_DEPTH).position(|open| self.char(*open) == wanted);
        let Some(above) = partner else { return self.lone.push(index) };
        let keep = self.open.len() - above;
        self.lone.extend(self.open.drain(keep..));
        if let Some(opener) = self.open.pop() {
            self.tokens[opener].link = index as u32;
            self.tokens[index].link = opener as u32;
        }
        if self.open.is_empty() && self.ends_annotation(index) {
            self.starts.push(index + 1);
        }
    }

    /// Whether the bracket closing here is that of an annotation's arguments.
    fn ends_annotation(&self, index: usize) -> bool {
        let (start, opener) = (self.start(), self.tokens[index].link as usize);
        self.kind(start) == Some(Kind::At) && opener == start + 2
    }

    fn keyword(&mut self, index: usize) {
        if self.open.is_empty() || self.tokens[index].first {
            self.begin(index);
        }
    }

    /// The words that are keywords only where a definition can begin; and the end of an annotation without arguments.
    fn word(&mut self, index: usize) {
        if self.kind(self.start()) == Some(Kind::At) && index == self.start() + 1 {
            if self.open.is_empty() && !self.is(index + 1, b'(') {
                self.starts.push(index + 1);
            }
            return;
        }
        let next = self.kind(index + 1);
        let begins = match self.word_at(index) {
            "style" => next == Some(Kind::Name),
            "version" => next == Some(Kind::Text),
            _ => false,
        };
        if begins && (self.tokens[index].first || index == self.start()) {
            self.begin(index);
        }
    }

    fn sign(&mut self, index: usize) {
        let kind = self.tokens[index].kind;
        let header = if kind == Kind::Squiggle { self.paper_header(index) } else { self.header(index) };
        let Some(start) = header.filter(|start| *start > self.start()) else { return };
        if kind == Kind::Equal && self.leads_on(start - 1) {
            return;
        }
        let begins = match kind {
            Kind::Bent => self.tokens[start].first && self.open.is_empty(),
            _ => self.open.is_empty() || self.breaks_out(start, kind),
        };
        if begins {
            self.begin(start);
        }
    }

    /// Whether no definition can end with this token: the `=` after what follows it is a slip for `==`.
    fn leads_on(&self, index: usize) -> bool {
        match self.tokens[index].kind {
            Kind::Case | Kind::Logic | Kind::Mark | Kind::Percent => true,
            Kind::Sign => self.char(index) != b'*',
            _ => false,
        }
    }

    /// Whether a header inside open brackets is the next definition rather than part of this one.
    ///
    /// Selectors, named arguments and overrides come after a bracket, bar or comma; only an arrow at the margin of the
    /// definition itself is believed there, and nothing in an import.
    fn breaks_out(&self, start: usize, sign: Kind) -> bool {
        let inside = matches!(self.tokens[start - 1].kind, Kind::Open | Kind::Bar | Kind::Comma);
        let at_margin = || self.column(start) <= self.column(self.start());
        let import = self.kind(self.start()) == Some(Kind::Import);
        self.tokens[start].first
            && match sign {
                Kind::Equal => !inside && at_margin(),
                _ => !inside || (at_margin() && !import),
            }
    }

    /// A piece begins here; what is open stays without a partner.
    fn begin(&mut self, index: usize) {
        self.lone.append(&mut self.open);
        if self.starts.last() != Some(&index) {
            self.starts.push(index);
        }
    }

    /// The first token of the header that ends before the sign at `index`: `[word] Name [(…)] [with (…)]`.
    fn header(&self, index: usize) -> Option<usize> {
        let mut last = index.checked_sub(1)?;
        if let Some(before) = self.before_group(last) {
            last = match self.kind(before)? {
                Kind::With => self.before_params(before.checked_sub(1)?)?,
                _ => before,
            };
        }
        if self.kind(last)? != Kind::Name {
            return None;
        }
        let marked = last.checked_sub(1).filter(|mark| match self.kind(*mark) {
            Some(Kind::Attr | Kind::Const) => true,
            Some(Kind::Name) => matches!(self.word_at(*mark), "start" | "extension"),
            _ => false,
        });
        Some(marked.unwrap_or(last))
    }

    /// The first token of `[id :] Name [(…)] [: condition]` before the squiggle at `index`.
    fn paper_header(&self, index: usize) -> Option<usize> {
        let name = match self.condition_colon(index) {
            Some(colon) if self.is_label(colon - 1) && self.before_params(index - 1) == Some(colon + 1) => colon + 1,
            Some(colon) => self.before_params(colon - 1)?,
            None => self.before_params(index.checked_sub(1)?)?,
        };
        if self.kind(name)? != Kind::Name {
            return None;
        }
        let label = name.checked_sub(2).filter(|id| self.kind(id + 1) == Some(Kind::Colon) && self.is_label(*id));
        Some(label.unwrap_or(name))
    }

    /// The colon before the condition that ends at the squiggle, if what lies between reads as one expression.
    fn condition_colon(&self, squiggle: usize) -> Option<usize> {
        let (mut at, mut operand_after) = (squiggle, false);
        while at > self.start() {
            at -= 1;
            let operand = match self.tokens[at].kind {
                Kind::Colon => return Some(at).filter(|colon| *colon > self.start()),
                Kind::Name | Kind::Number | Kind::Text => true,
                Kind::Close if self.tokens[at].link != NONE && !operand_after => {
                    at = self.tokens[at].link as usize;
                    !matches!(self.kind(at.checked_sub(1)?), Some(Kind::Name | Kind::Close))
                }
                Kind::Logic | Kind::Sign | Kind::Percent | Kind::Dot => false,
                _ => return None,
            };
            if operand && operand_after {
                return None;
            }
            operand_after = operand;
        }
        None
    }

    /// Whether the token can be the id of a rule in the papers' notation: it begins a line, or the file.
    fn is_label(&self, index: usize) -> bool {
        let token = self.tokens[index];
        matches!(token.kind, Kind::Name | Kind::Number) && (token.first || index == 0)
    }

    /// The token before `(…)` ending at `last`, or `last` itself where there is none.
    fn before_params(&self, last: usize) -> Option<usize> {
        match self.kind(last)? {
            Kind::Close => match self.before_group(last)? {
                before if matches!(self.kind(before), Some(Kind::Name)) => Some(before),
                _ => self.tokens.get(last).map(|t| t.link as usize),
            },
            _ => Some(last),
        }
    }

    /// The token before the parentheses that close at `last`.
    fn before_group(&self, last: usize) -> Option<usize> {
        let token = self.tokens.get(last).filter(|t| t.kind == Kind::Close && t.link != NONE)?;
        (self.char(last) == b')').then_some(())?;
        (token.link as usize).checked_sub(1)
    }

    fn pieces(mut self) -> Vec<Piece> {
        self.starts.dedup();
        self.starts.retain(|start| *start < self.tokens.len());
        self.lone.sort_unstable();
        let (mut lone, mut deep) = (self.lone.iter().copied().peekable(), self.deep.iter().copied().peekable());
        let ends = self.starts.iter().skip(1).copied().chain([self.tokens.len()]);
        let ranges = self.starts.iter().copied().zip(ends);
        let piece = |(start, end): (usize, usize)| Piece {
            kind: self.kind_of(start, end),
            tokens: start..end,
            bytes: self.tokens[start].start..self.tokens[end - 1].end,
            lone: std::iter::from_fn(|| lone.next_if(|index| *index < end)).collect(),
            too_deep: std::iter::from_fn(|| deep.next_if(|index| *index < end)).min(),
        };
        ranges.map(piece).collect()
    }

    /// What a piece is, by its first tokens.
    fn kind_of(&self, start: usize, end: usize) -> PieceKind {
        match self.tokens[start].kind {
            Kind::At => PieceKind::Annotation,
            Kind::Import => PieceKind::Import,
            Kind::Attr | Kind::Const => PieceKind::Value,
            Kind::Name | Kind::Number => match (self.word_at(start), self.kind(start + 1)) {
                ("version", Some(Kind::Text)) => PieceKind::Version,
                ("style", Some(Kind::Name)) => PieceKind::Style,
                _ => self.signed(start, end),
            },
            _ => PieceKind::Stray,
        }
    }

    /// What a piece is, by its first arrow or equals sign outside brackets.
    fn signed(&self, start: usize, end: usize) -> PieceKind {
        let mut at = start;
        while at < end {
            match self.tokens[at] {
                Token { kind: Kind::Arrow, .. } => return PieceKind::Rule,
                Token { kind: Kind::Equal, .. } => return PieceKind::Value,
                Token { kind: Kind::Squiggle, .. } => return PieceKind::PaperRule,
                Token { kind: Kind::Open, link, .. } if link != NONE => at = link as usize + 1,
                _ => at += 1,
            }
        }
        PieceKind::Stray
    }

    /// First token of the piece under way.
    fn start(&self) -> usize {
        self.starts.last().copied().unwrap_or(0)
    }

    /// Bytes before the token on its line.
    fn column(&self, index: usize) -> usize {
        let before = &self.text[..self.tokens[index].start as usize];
        before.len() - before.rfind('\n').map_or(0, |end| end + 1)
    }

    fn kind(&self, index: usize) -> Option<Kind> {
        self.tokens.get(index).map(|t| t.kind)
    }

    fn word_at(&self, index: usize) -> &str {
        self.tokens.get(index).map_or("", |t| &self.text[t.start as usize..t.end as usize])
    }

    fn char(&self, index: usize) -> u8 {
        self.text.as_bytes()[self.tokens[index].start as usize]
    }

    fn is(&self, index: usize, byte: u8) -> bool {
        index < self.tokens.len() && self.char(index) == byte
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::syntax::token::tokens;

    fn cut(text: &str) -> Vec<(&str, PieceKind)> {
        let mut tokens = tokens(text);
        let pieces = outline(text, &mut tokens);
        pieces.iter().map(|p| (&text[p.bytes.start as usize..p.bytes.end as usize], p.kind)).collect()
    }

    #[test]
    fn definitions_end_where_the_next_begins() {
        let text = "version \"1\" @Hidden @Range(0, (1)) attr a = b(c) f(x) = [1] start R(p) with (q := f(p)) --> A (B) S.T --> C";
        let expected = [
            ("version \"1\"", PieceKind::Version),
            ("@Hidden", PieceKind::Annotation),
            ("@Range(0, (1))", PieceKind::Annotation),
            ("attr a = b(c)", PieceKind::Value),
            ("f(x) = [1]", PieceKind::Value),
            ("start R(p) with (q := f(p)) --> A (B)", PieceKind::Rule),
            ("S.T --> C", PieceKind::Rule),
        ];
        assert_eq!(cut(text), expected);
    }

    #[test]
    fn selectors_and_named_arguments_begin_nothing() {
        let text =
            "A --> comp(f){\ntop = X |\nside = Y } f(a = 1,\nb = 2)\nimport i : \"x\" (E --> X,\nF --> Y)\nB --> C";
        assert_eq!(cut(text).len(), 3, "{:?}", cut(text));
    }

    #[test]
    fn the_papers_headers_are_found_whole() {
        let text =
            "A ~> B : 0.5\n2: C ~> D : p\nE ~> F\nid: G(x) : x > f(3) && b ~> H : 1 - p\nI : occ(\"a\") == 1 ~> J\n";
        let starts: Vec<&str> = cut(text).iter().map(|(t, _)| &t[..2]).collect();
        assert_eq!(starts, ["A ", "2:", "E ", "id", "I "]);
    }

    #[test]
    fn an_open_bracket_swallows_only_its_own_definition() {
        for broken in ["A --> split(x){ 1 : B", "A --> t(1, (2, 3)", "attr a = f(", "@Range(0, 1"] {
            let text = format!("{broken}\n\nC --> D\nattr e = 1\n@Hidden\nf(x) = x");
            assert_eq!(cut(&text).len(), 5, "{broken}");
        }
        assert_eq!(cut("A --> f({ X\ng(x) = 3\n").len(), 2);
    }
}
