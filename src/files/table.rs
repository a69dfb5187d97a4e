//! Comma-separated values (RFC 4180, and what is found under that name): the delimiter is `;`, a tab, `,` or spaces,
//! whichever divides the lines evenly; quotes keep delimiters and line ends in a cell.

use crate::files::text::clean;
use crate::value::{Array, Cells};
use std::sync::Arc;

/// A table that was read.
#[derive(Debug)]
pub struct Table {
    /// Its cells as texts.
    pub strings: Arc<Array>,
    /// Its cells as numbers.
    pub numbers: Arc<Array>,
    /// What was filled in.
    pub remark: Option<String>,
}

/// Cells of one table: the one array that may be larger than the limit `array`, since a file's size bounds it.
const MOST_CELLS: usize = 10_000_000;
/// Lines from which the delimiter is told.
const LINES_TO_TELL: usize = 50;

impl Table {
    /// The table in a text; rows that are too short are filled up with empty cells. Cost: linear.
    pub fn read(text: &str) -> Result<Table, String> {
        let text = clean(text);
        let rows = Reader::read(&text, delimiter(&text), usize::MAX).rows;
        let columns = rows.iter().map(Vec::len).max().unwrap_or(0);
        if rows.len().saturating_mul(columns) > MOST_CELLS {
            return Err(format!("has {} rows of {columns}: a table has at most {MOST_CELLS} cells", rows.len()));
        }
        let short: Vec<usize> = (0..rows.len()).filter(|row| rows[*row].len() < columns).collect();
        let remark = short.first().map(|first| {
            let rows = crate::text::counted(short.len(), "row");
            format!("{rows} of fewer than {columns} cells, row {} first: the missing ones are empty", first + 1)
        });
        let empty: Arc<str> = "".into();
        let mut cells: Vec<Arc<str>> = Vec::with_capacity(rows.len() * columns);
        for row in rows {
            let missing = columns - row.len();
            cells.extend(row.into_iter().map(|cell| if cell.is_empty() { empty.clone() } else { cell.into() }));
            cells.extend(std::iter::repeat_n(empty.clone(), missing));
        }
        let numbers = cells.iter().map(|cell| crate::text::leading_number(cell)).collect();
        let array = |cells| Arc::new(Array::new(columns, cells).expect("whole rows"));
        Ok(Table { strings: array(Cells::Texts(cells)), numbers: array(Cells::Numbers(numbers)), remark })
    }
}

/// The delimiter that divides the first lines into the same number of cells, more than one; else the one that is there.
fn delimiter(text: &str) -> char {
    let score = |delimiter: char| {
        let reader = Reader::read(text, delimiter, LINES_TO_TELL);
        let first = reader.rows.first().map_or(0, Vec::len);
        let is_even = first > 1 && reader.rows.iter().all(|row| row.len() == first);
        (is_even && !reader.is_broken, reader.rows.iter().any(|row| row.len() > 1))
    };
    let scores = [';', '\t', ',', ' '].map(|delimiter| (delimiter, score(delimiter)));
    let even = scores.iter().find(|(_, (is_even, _))| *is_even);
    // Words within cells have spaces too, so they alone do not make columns.
    let there = || scores[..3].iter().find(|(_, (_, is_there))| *is_there);
    even.or_else(there).map_or(',', |(delimiter, _)| *delimiter)
}

/// What was read of a table.
#[derive(Default)]
struct Reader {
    rows: Vec<Vec<String>>,
    row: Vec<String>,
    cell: String,
    /// The cell stood in quotes.
    was_quoted: bool,
    /// Something follows the quotes of a cell, so the delimiter is probably another.
    is_broken: bool,
}

impl Reader {
    /// The rows of a text, at most so many. Empty lines are none.
    fn read(text: &str, delimiter: char, most: usize) -> Reader {
        let mut reader = Reader::default();
        let mut letters = text.chars().peekable();
        let mut quoted = false;
        while let Some(letter) = letters.next() {
            match letter {
                '"' if quoted && letters.next_if_eq(&'"').is_some() => reader.cell.push('"'),
                '"' if quoted => quoted = false,
                letter if quoted => reader.cell.push(letter),
                '\n' if reader.rows.len() + 1 >= most => break,
                '\n' => reader.end_row(),
                // Several spaces are one delimiter.
                ' ' if delimiter == ' ' && reader.cell.is_empty() && !reader.was_quoted => {}
                letter if letter == delimiter => reader.end_cell(),
                letter if reader.was_quoted && letter.is_whitespace() => {}
                '"' if !reader.was_quoted && reader.cell.trim().is_empty() => {
                    reader.cell.clear();
                    (quoted, reader.was_quoted) = (true, true);
                }
                letter => {
                    reader.is_broken |= reader.was_quoted;
                    reader.cell.push(letter);
                }
            }
        }
        reader.end_row();
        reader
    }

    fn end_cell(&mut self) {
        let cell = std::mem::take(&mut self.cell);
        self.row.push(if self.was_quoted { cell } else { cell.trim().into() });
        self.was_quoted = false;
    }

    fn end_row(&mut self) {
        if self.row.is_empty() && self.cell.trim().is_empty() && !self.was_quoted {
            self.cell.clear();
            return;
        }
        self.end_cell();
        self.rows.push(std::mem::take(&mut self.row));
    }
}

#[cfg(test)]
mod tests {
    use super::Table;
    use crate::value::Value;

    fn read(text: &str) -> String {
        Value::Array(Table::read(text).unwrap().strings).to_string()
    }

    #[test]
    fn delimiters_are_told_from_the_lines() {
        let plain = read("a,b\n1,2\n");
        for text in ["a;b\r\n1;2", "a\tb\n1\t2\n\n", "a b\n1  2", "\"a\",b\n1,\"2\"", "a , b\n1, 2"] {
            assert_eq!(read(text), plain, "{text:?}");
        }
    }

    #[test]
    fn decimal_commas_stay_in_their_cells() {
        assert_eq!(read("lime;1,5\noak;2,5"), read("\"lime\",\"1,5\"\n\"oak\",\"2,5\""));
        assert_eq!(read("a;x, y\nb;z"), read("\"a\"\t\"x, y\"\n\"b\"\t\"z\""));
    }

    #[test]
    fn quotes_keep_delimiters_and_lines() {
        let table = Table::read("name,note\noak,\"tall, \"\"old\"\"\nand wide\"").unwrap();
        assert_eq!(table.strings.cell(1, 1), Value::text("tall, \"old\"\nand wide"));
    }

    #[test]
    fn short_rows_are_filled_and_said() {
        let table = Table::read("a,b,c\n1,2,3\n4\n").unwrap();
        assert_eq!((table.strings.rows(), table.strings.columns()), (3, 3));
        assert_eq!(table.strings.cell(2, 2), Value::text(""));
        assert!(table.remark.is_some_and(|remark| remark.contains("row 3")));
        assert_eq!(Table::read("").unwrap().strings.len(), 0);
    }
}
