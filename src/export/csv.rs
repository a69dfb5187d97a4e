//! Comma-separated values as RFC 4180 has them: fields with commas, quotes or line breaks stand in quotes, and every
//! text comes back as it was.

/// Writes one record and ends the line.
pub(super) fn push_row<S: AsRef<str>>(out: &mut String, fields: impl IntoIterator<Item = S>) {
    for (index, field) in fields.into_iter().enumerate() {
        if index > 0 {
            out.push(',');
        }
        push_field(out, field.as_ref());
    }
    out.push_str("\r\n");
}

fn push_field(out: &mut String, field: &str) {
    let plain = !field.contains([',', '"', '\n', '\r']) && field.trim() == field;
    if plain {
        out.push_str(field);
        return;
    }
    out.push('"');
    for part in field.split_inclusive('"') {
        out.push_str(part);
        if part.ends_with('"') {
            out.push('"');
        }
    }
    out.push('"');
}

/// A record and the line it starts on.
pub(super) type Row = (usize, Vec<String>);

/// The records of a text, blank lines left out; the error is the line of a quote that never closes.
pub(super) fn parse_rows(text: &str) -> Result<Vec<Row>, usize> {
    let mut reader = Reader { left: text.strip_prefix('\u{feff}').unwrap_or(text), line: 1 };
    let mut rows = Vec::new();
    while !reader.left.is_empty() {
        let line = reader.line;
        let row = reader.row()?;
        if row != [""] {
            rows.push((line, row));
        }
    }
    Ok(rows)
}

struct Reader<'t> {
    left: &'t str,
    line: usize,
}

impl Reader<'_> {
    fn row(&mut self) -> Result<Vec<String>, usize> {
        let mut fields = Vec::new();
        loop {
            let field = if self.left.starts_with('"') { self.quoted()? } else { String::new() };
            fields.push(field + self.bare());
            if !self.skip(",") {
                break;
            }
        }
        self.skip("\r");
        self.line += usize::from(self.skip("\n"));
        Ok(fields)
    }

    /// A field in quotes, up to and with its closing quote.
    fn quoted(&mut self) -> Result<String, usize> {
        let start = self.line;
        let mut field = String::new();
        self.skip("\"");
        loop {
            let end = self.left.find('"').ok_or(start)?;
            let part = &self.left[..end];
            self.line += part.matches('\n').count();
            field.push_str(part);
            self.left = &self.left[end + 1..];
            if !self.skip("\"") {
                return Ok(field);
            }
            field.push('"');
        }
    }

    /// What stands before the next comma or line break.
    fn bare(&mut self) -> &str {
        let end = self.left.find([',', '\n', '\r']).unwrap_or(self.left.len());
        let (field, left) = self.left.split_at(end);
        self.left = left;
        field
    }

    fn skip(&mut self, token: &str) -> bool {
        let rest = self.left.strip_prefix(token);
        self.left = rest.unwrap_or(self.left);
        rest.is_some()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use proptest::prelude::*;

    #[test]
    fn unusual_but_valid_texts_are_read() {
        let rows = parse_rows("\u{feff}a,\"b\"\"c\nd\"\n\n,\r\nlast").expect("valid");
        let expected = [(1, vec!["a", "b\"c\nd"]), (4, vec!["", ""]), (5, vec!["last"])];
        assert_eq!(rows.len(), expected.len());
        for ((line, fields), (at, want)) in rows.iter().zip(expected) {
            assert_eq!((*line, fields), (at, &want.iter().map(|f| (*f).to_owned()).collect::<Vec<_>>()));
        }
        assert_eq!(parse_rows("a\n\"open"), Err(2));
    }

    proptest! {
        #[test]
        fn every_text_comes_back(rows in prop::collection::vec(prop::collection::vec("[a,\"\n\r =é;]{0,6}", 2..4), 0..5)) {
            let mut text = String::new();
            rows.iter().for_each(|row| push_row(&mut text, row));
            let read: Vec<Vec<String>> = parse_rows(&text).expect("valid").into_iter().map(|(_, row)| row).collect();
            prop_assert_eq!(read, rows);
        }

        #[test]
        fn no_text_panics(text in "[a,\"\n\ré]{0,40}") {
            let _ = parse_rows(&text);
        }
    }
}
