//! Rule text → tokens, for finding where definitions begin and for saying what is wrong with them.
//!
//! This is no second grammar: it knows only what a character sequence is, never what may follow what. Whether a text is
//! right is decided by `grammar/cga.pest` alone; the two agree on names, numbers, texts and comments.

/// A stretch of text that means one thing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Token {
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
    /// What it is.
    pub kind: Kind,
    /// Nothing but blanks and comments before it on its line.
    pub first: bool,
    /// For a bracket with a partner, the partner's index; else [`NONE`].
    pub link: u32,
}

/// The [`Token::link`] of what has no partner.
pub const NONE: u32 = u32::MAX;

/// What a token is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// `Lot`, `scope.sx`
    Name,
    /// `3`, `.5`, `2r`
    Number,
    /// `"…"`
    Text,
    /// A text or block comment that never ends.
    Unclosed,
    /// `case`
    Case,
    /// `else`
    Else,
    /// `attr`
    Attr,
    /// `const`
    Const,
    /// `import`
    Import,
    /// `with`
    With,
    /// `-->`
    Arrow,
    /// `~>`
    Squiggle,
    /// `->`, `-- >`, `=>`, `→` and whatever else was meant to be an arrow.
    Bent,
    /// `=`
    Equal,
    /// `:=`, `=:`
    Joined,
    /// `==`, `!=`, `<`, `<=`, `>`, `>=`, `&&`, `||`
    Logic,
    /// `+`, `-`, `*`, `/`, `!`
    Sign,
    /// `'`, `~`
    Mark,
    /// `%`
    Percent,
    /// `:`
    Colon,
    /// `|`
    Bar,
    /// `,`
    Comma,
    /// `;`
    Semicolon,
    /// `.`
    Dot,
    /// `@`
    At,
    /// `(`, `[`, `{`
    Open,
    /// `)`, `]`, `}`
    Close,
    /// Nothing of the language.
    Other,
}

/// The tokens of a text, without links. Cost: linear.
pub(super) fn tokens(text: &str) -> Vec<Token> {
    let mut scanner = Scanner { text, bytes: text.as_bytes(), at: 0 };
    let mut found = Vec::with_capacity(text.len() / 4);
    let mut first = true;
    loop {
        first |= scanner.blanks();
        let start = scanner.at;
        let Some(kind) = scanner.token() else { return found };
        found.push(Token { start: start as u32, end: scanner.at as u32, kind, first, link: NONE });
        first = false;
    }
}

/// Whether a character may stand in a name, digits aside: `letter` of the grammar.
fn is_letter(c: char) -> bool {
    matches!(c, 'a'..='z' | 'A'..='Z' | '_' | '$' | '\u{c0}'..='\u{1fff}' | '\u{3040}'..='\u{d7ff}')
}

struct Scanner<'t> {
    text: &'t str,
    bytes: &'t [u8],
    at: usize,
}

impl Scanner<'_> {
    /// Skips blanks and comments; tells whether a line ended.
    fn blanks(&mut self) -> bool {
        let mut line = false;
        while let Some(byte) = self.peek(0) {
            match byte {
                b'\n' | b'\r' => line = true,
                b' ' | b'\t' | 0x0b | 0x0c => {}
                b'#' => self.skip_line(),
                b'/' if self.peek(1) == Some(b'/') => self.skip_line(),
                b'/' if self.peek(1) == Some(b'*') => match self.text[self.at + 2..].find("*/") {
                    Some(end) => self.at += end + 3,
                    None => return line,
                },
                0xc2 | 0xef if self.rest().starts_with(['\u{a0}', '\u{feff}']) => {
                    self.at += if byte == 0xc2 { 1 } else { 2 };
                }
                _ => return line,
            }
            self.at += 1;
        }
        line
    }

    /// Stops before the line's last byte, which the caller steps over.
    fn skip_line(&mut self) {
        let rest = &self.bytes[self.at..];
        let length = rest.iter().position(|b| matches!(b, b'\n' | b'\r')).unwrap_or(rest.len());
        self.at += length.max(1) - 1;
    }

    fn token(&mut self) -> Option<Kind> {
        let byte = self.peek(0)?;
        Some(match byte {
            b'0'..=b'9' => self.number(),
            b'.' if self.peek(1).is_some_and(|b| b.is_ascii_digit()) => self.number(),
            b'"' => self.quoted(),
            b'/' if self.peek(1) == Some(b'*') => self.take(self.bytes.len() - self.at, Kind::Unclosed),
            byte if byte.is_ascii() && !is_letter(char::from(byte)) => self.sign(byte),
            _ => self.word(),
        })
    }

    fn sign(&mut self, byte: u8) -> Kind {
        if let Some((length, kind)) = self.arrow() {
            return self.take(length, kind);
        }
        let (length, kind) = match (byte, self.peek(1)) {
            (b'=' | b'!' | b'<' | b'>', Some(b'=')) => (2, Kind::Logic),
            (b'&', Some(b'&')) | (b'|', Some(b'|')) => (2, Kind::Logic),
            (b':', Some(b'=')) | (b'=', Some(b':')) => (2, Kind::Joined),
            (b'<' | b'>', _) => (1, Kind::Logic),
            (b'=', _) => (1, Kind::Equal),
            (b'+' | b'-' | b'*' | b'/' | b'!', _) => (1, Kind::Sign),
            (b'\'' | b'~', _) => (1, Kind::Mark),
            (b'%', _) => (1, Kind::Percent),
            (b':', _) => (1, Kind::Colon),
            (b'|', _) => (1, Kind::Bar),
            (b',', _) => (1, Kind::Comma),
            (b';', _) => (1, Kind::Semicolon),
            (b'.', _) => (1, Kind::Dot),
            (b'@', _) => (1, Kind::At),
            (b'(' | b'[' | b'{', _) => (1, Kind::Open),
            (b')' | b']' | b'}', _) => (1, Kind::Close),
            _ => (1, Kind::Other),
        };
        self.take(length, kind)
    }

    /// An arrow, straight or bent, with its length.
    fn arrow(&self) -> Option<(usize, Kind)> {
        const BENT: [&str; 10] = ["--->", "-- >", "- ->", "->", "- >", "==>", "=>", "~ >", "~~>", "--~>"];
        if !matches!(self.peek(0), Some(b'-' | b'=' | b'~')) {
            return None;
        }
        let rest = self.rest();
        match () {
            () if rest.starts_with("-->") => Some((3, Kind::Arrow)),
            () if rest.starts_with("~>") => Some((2, Kind::Squiggle)),
            () => BENT.iter().find(|bent| rest.starts_with(**bent)).map(|bent| (bent.len(), Kind::Bent)),
        }
    }

    fn number(&mut self) -> Kind {
        self.digits();
        if self.peek(0) == Some(b'.') {
            self.at += 1;
            self.digits();
        }
        if matches!(self.peek(0), Some(b'e' | b'E')) {
            let sign = usize::from(matches!(self.peek(1), Some(b'+' | b'-')));
            if self.peek(1 + sign).is_some_and(|b| b.is_ascii_digit()) {
                self.at += 1 + sign;
                self.digits();
            }
        }
        if self.peek(0) == Some(b'r') && !self.text[self.at + 1..].starts_with(|c| is_letter(c) || c.is_ascii_digit()) {
            self.at += 1;
        }
        Kind::Number
    }

    fn digits(&mut self) {
        while self.peek(0).is_some_and(|b| b.is_ascii_digit()) {
            self.at += 1;
        }
    }

    /// A text. It may run over several lines, but not over lines that look like code: then its quote was forgotten.
    fn quoted(&mut self) -> Kind {
        let mut at = self.at + 1;
        let mut line = None;
        while let Some(byte) = self.bytes.get(at) {
            match byte {
                b'"' => return self.take(at + 1 - self.at, Kind::Text),
                b'\\' => at += 1,
                b'\n' => {
                    line = line.or(Some(at));
                    if begins_like_code(&self.text[at + 1..]) {
                        break;
                    }
                }
                _ => {}
            }
            at += 1;
        }
        let end = line.unwrap_or(self.bytes.len()).min(self.bytes.len());
        let seen = self.text[self.at..end].trim_end().len();
        self.take(seen, Kind::Unclosed)
    }

    fn word(&mut self) -> Kind {
        let start = self.at;
        self.at += self.simple();
        if self.at == start {
            let length = self.rest().chars().next().map_or(1, char::len_utf8);
            let kind =
                if self.rest().starts_with(['→', '⇒', '⟶', '↝', '⇝']) { Kind::Bent } else { Kind::Other };
            return self.take(length, kind);
        }
        while self.peek(0) == Some(b'.') {
            self.at += 1;
            match self.simple() {
                0 => {
                    self.at -= 1;
                    break;
                }
                length => self.at += length,
            }
        }
        match &self.text[start..self.at] {
            "case" => Kind::Case,
            "else" => Kind::Else,
            "attr" => Kind::Attr,
            "const" => Kind::Const,
            "import" => Kind::Import,
            "with" => Kind::With,
            _ => Kind::Name,
        }
    }

    /// Length of the simple name here, 0 if there is none.
    fn simple(&self) -> usize {
        let ascii = |b: &u8| b.is_ascii_alphanumeric() || matches!(b, b'_' | b'$');
        let rest = &self.bytes[self.at..];
        if rest.first().is_none_or(u8::is_ascii_digit) {
            return 0;
        }
        let length = rest.iter().position(|b| !ascii(b)).unwrap_or(rest.len());
        match rest.get(length) {
            Some(byte) if !byte.is_ascii() => {
                let rest = self.rest();
                rest.find(|c| !is_letter(c) && !char::is_ascii_digit(&c)).unwrap_or(rest.len())
            }
            _ => length,
        }
    }

    fn take(&mut self, length: usize, kind: Kind) -> Kind {
        self.at += length;
        kind
    }

    fn peek(&self, ahead: usize) -> Option<u8> {
        self.bytes.get(self.at + ahead).copied()
    }

    fn rest(&self) -> &str {
        &self.text[self.at..]
    }
}

/// Whether the line that begins here looks like code rather than the next line of a text.
fn begins_like_code(rest: &str) -> bool {
    let line = rest.lines().next().unwrap_or("");
    let word = line.trim_start();
    ["attr ", "const ", "import ", "style ", "@", "case ", "else"].iter().any(|start| word.starts_with(start))
        || line.contains("-->")
        || line.contains("~>")
}

#[cfg(test)]
mod tests {
    use super::*;

    fn kinds(text: &str) -> Vec<(&str, Kind)> {
        tokens(text).iter().map(|t| (&text[t.start as usize..t.end as usize], t.kind)).collect()
    }

    #[test]
    fn comments_of_all_kinds_are_blanks() {
        assert_eq!(kinds("a// b\n/* c \n*/d # e\r\nf /**/"), [("a", Kind::Name), ("d", Kind::Name), ("f", Kind::Name)]);
        assert!(tokens("a /* b").last().is_some_and(|t| t.kind == Kind::Unclosed));
    }

    #[test]
    fn arrows_are_known_straight_and_bent() {
        for (text, kind) in [("-->", Kind::Arrow), ("~>", Kind::Squiggle), ("-- >", Kind::Bent), ("→", Kind::Bent)] {
            assert_eq!(kinds(&format!("A {text} B"))[1], (text, kind));
        }
    }

    #[test]
    fn a_text_may_run_on_but_not_over_code() {
        assert_eq!(kinds("\"a\nb\" c")[0], ("\"a\nb\"", Kind::Text));
        assert_eq!(kinds("attr a = \"x\nattr b = \"y\"")[3], ("\"x", Kind::Unclosed));
    }

    #[test]
    fn names_take_their_dots_and_leaves_do_not() {
        assert_eq!(kinds("material.color.r A. grün 2r 5. .5").len(), 7);
    }
}
