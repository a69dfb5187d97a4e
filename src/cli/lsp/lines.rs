//! Places in a text, as the protocol counts them (lines from 0, UTF-16 units from 0) and as we do (bytes).

use lsp_types::{Position, Range};

/// Where the lines of a text begin.
pub struct Lines<'t> {
    text: &'t str,
    starts: Vec<usize>,
}

impl<'t> Lines<'t> {
    /// The lines of a text: `\n`, `\r\n` and `\r` end them.
    pub fn of(text: &'t str) -> Lines<'t> {
        let bytes = text.as_bytes();
        let ends = |index: &usize| match bytes[*index] {
            b'\n' => true,
            b'\r' => bytes.get(index + 1) != Some(&b'\n'),
            _ => false,
        };
        let starts = (0..bytes.len()).filter(ends).map(|index| index + 1);
        Lines { text, starts: std::iter::once(0).chain(starts).collect() }
    }

    /// The byte of a position: past the end of a line its end, past the last line the end of the text, in the middle of
    /// a character its beginning.
    pub fn offset(&self, position: Position) -> usize {
        let line = position.line as usize;
        let Some(start) = self.starts.get(line).copied() else { return self.text.len() };
        let end = self.starts.get(line + 1).copied().unwrap_or(self.text.len());
        let content = self.text[start..end].trim_end_matches(['\r', '\n']);
        let mut units = 0;
        for (index, c) in content.char_indices() {
            units += c.len_utf16() as u32;
            if units > position.character {
                return start + index;
            }
        }
        start + content.len()
    }

    /// The position of a byte. Cost: logarithmic in the lines and linear in the column.
    pub fn position(&self, offset: usize) -> Position {
        let offset = self.text.floor_char_boundary(offset);
        let line = self.starts.partition_point(|start| *start <= offset) - 1;
        let units: usize = self.text[self.starts[line]..offset].chars().map(char::len_utf16).sum();
        Position::new(line as u32, units as u32)
    }

    /// The stretch between two bytes.
    pub fn range(&self, range: &std::ops::Range<usize>) -> Range {
        Range::new(self.position(range.start), self.position(range.end))
    }

    /// The bytes of a stretch; empty where it runs backwards.
    pub fn bytes(&self, range: Range) -> std::ops::Range<usize> {
        let start = self.offset(range.start);
        start..self.offset(range.end).max(start)
    }
}
