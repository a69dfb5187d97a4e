//! One rule file as read: bytes in, text out, with the way back from places in the text to the file.
//!
//! Rule files are UTF-8 by agreement and Windows-1252 by history: many of CityEngine's own are, in comments and
//! annotation texts. Bytes that are not UTF-8 are therefore read as Windows-1252, and said so by [`Source::lint`].
//! Line ends stay as they are. Nothing here knows what the text means.

use crate::diag::{Diagnostic, Span};
use crate::text::{from_windows_1252, to_windows_1252};

/// The text of a rule file.
#[derive(Clone, Debug, PartialEq)]
pub struct Source {
    path: String,
    text: String,
    /// Bytes of the file before the text: a byte-order mark.
    skipped: u32,
    /// Where the text and the file part ways: byte offsets in the text just after a character that is longer in the
    /// text than in the file, with the excess summed up to there. Ascending.
    excess: Vec<(u32, u32)>,
    /// Byte offsets at which lines start, the first being 0.
    lines: Vec<u32>,
    /// The first character that was not UTF-8.
    foreign: Option<Foreign>,
    /// Where the first NUL byte was, which reads as a blank.
    nul: Option<u32>,
}

/// A character that made a file be read as Windows-1252.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Foreign {
    at: u32,
    byte: u8,
}

impl Source {
    /// The file at `path` with these bytes. Any bytes will do. Cost: linear.
    pub fn new(path: &str, bytes: &[u8]) -> Source {
        let body = bytes.strip_prefix(b"\xEF\xBB\xBF").unwrap_or(bytes);
        let skipped = (bytes.len() - body.len()) as u32;
        let (text, excess, foreign) = match std::str::from_utf8(body) {
            Ok(text) => (text.to_owned(), Vec::new(), None),
            Err(error) => windows_1252(body, error.valid_up_to()),
        };
        let nul = text.find('\0').map(|at| at as u32);
        let text = if nul.is_some() { text.replace('\0', " ") } else { text };
        let ends = text.bytes().enumerate().filter(|(_, b)| *b == b'\n').map(|(i, _)| i as u32 + 1);
        let lines = std::iter::once(0).chain(ends).collect();
        Source { path: path.to_owned(), text, skipped, excess, lines, foreign, nul }
    }

    /// The path as it was asked for.
    pub fn path(&self) -> &str {
        &self.path
    }

    /// The decoded text, which all spans refer to.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The byte of the file at which the text's byte `offset` came in; past the end, the end.
    pub fn original(&self, offset: u32) -> u32 {
        let offset = offset.min(self.text.len() as u32);
        let before = self.excess.partition_point(|(at, _)| *at <= offset);
        let excess = if before == 0 { 0 } else { self.excess[before - 1].1 };
        offset - excess + self.skipped
    }

    /// Another text as bytes, the way this file is written: with its byte-order mark, and in Windows-1252 if it is.
    ///
    /// What Windows-1252 has no byte for, which cannot come from this file, becomes `?`.
    pub fn encoded(&self, text: &str) -> Vec<u8> {
        let mark = if self.skipped > 0 { "\u{feff}".as_bytes() } else { &[] };
        match self.foreign {
            None => [mark, text.as_bytes()].concat(),
            Some(_) => mark.iter().copied().chain(text.chars().map(to_windows_1252)).collect(),
        }
    }

    /// Line and column of a byte of the text, both from 1, the column in characters; past the end, the end.
    ///
    /// Cost: logarithmic in the lines and linear in the column.
    pub fn line_column(&self, offset: u32) -> (usize, usize) {
        let offset = self.text.floor_char_boundary(offset as usize);
        let line = self.lines.partition_point(|start| *start as usize <= offset);
        let start = self.lines[line - 1] as usize;
        (line, self.text[start..offset].chars().count() + 1)
    }

    /// That there are NUL bytes in the file.
    pub(super) fn lint_nul(&self, file: u16) -> Option<Diagnostic> {
        let at = self.nul?;
        let message = format!("`{}` holds NUL bytes, which are read as blanks", self.path);
        let lint = Diagnostic::lint("syntax-encoding", Span { file, start: at, end: at + 1 }, message);
        Some(lint.hint("the file may be UTF-16 or damaged: save it as UTF-8"))
    }

    /// What is to be said about how the file is written: that it is not UTF-8.
    pub(super) fn lint(&self, file: u16) -> Option<Diagnostic> {
        let Foreign { at, byte } = self.foreign?;
        let length = self.text[at as usize..].chars().next().map_or(0, char::len_utf8) as u32;
        let span = Span { file, start: at, end: at + length };
        let message = format!("`{}` is not UTF-8 (byte `{byte:#04x}`) and is read as Windows-1252", self.path);
        Some(Diagnostic::lint("syntax-encoding", span, message).hint("save the file as UTF-8"))
    }
}

/// Bytes as Windows-1252; the first `valid` of them are known to be UTF-8, which here need not mean ASCII.
fn windows_1252(bytes: &[u8], valid: usize) -> (String, Vec<(u32, u32)>, Option<Foreign>) {
    let mut text = String::with_capacity(bytes.len() + bytes.len() / 8);
    let (mut excess, mut sum, mut foreign) = (Vec::new(), 0, None);
    for (index, byte) in bytes.iter().copied().enumerate() {
        if index == valid {
            foreign = Some(Foreign { at: text.len() as u32, byte });
        }
        let character = from_windows_1252(byte);
        text.push(character);
        if character.len_utf8() > 1 {
            sum += character.len_utf8() as u32 - 1;
            excess.push((text.len() as u32, sum));
        }
    }
    (text, excess, foreign)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn windows_1252_is_read_and_every_byte_is_found_again() {
        let bytes = b"// caf\xe9 \x93x\x94\nattr gr\xfcn = 1";
        let source = Source::new("a.cga", bytes);
        assert_eq!(source.text(), "// café “x”\nattr grün = 1");
        let attr = source.text().find("attr").unwrap() as u32;
        assert_eq!(bytes[source.original(attr) as usize..][..4], *b"attr");
        assert_eq!(source.original(source.text().len() as u32) as usize, bytes.len());
        let lint = source.lint(0).expect("a lint");
        assert!(lint.message.contains("0xe9"), "{}", lint.message);
    }

    #[test]
    fn a_mark_is_skipped_and_columns_count_characters() {
        let source = Source::new("a.cga", "\u{feff}attr a = \"ü\" b\r\nLot --> X".as_bytes());
        assert!(source.text().starts_with("attr") && source.lint(0).is_none());
        assert_eq!(source.original(0), 3);
        assert_eq!(source.line_column(source.text().find('b').unwrap() as u32), (1, 14));
        assert_eq!(source.line_column(source.text().find("Lot").unwrap() as u32), (2, 1));
        assert_eq!(source.line_column(9999), (2, 10));
    }
}
