//! A table of TOML being read: it hands out typed fields, reports what is wrong with each by line and column, and
//! in the end names the keys nobody asked for.

use crate::diag::{Diagnostic, Place, Severity};
use crate::element::{Words, parse_color};
use crate::text;
use serde::Deserialize;
use std::cell::RefCell;
use std::sync::Arc;
use toml::de::{DeTable, DeValue, ValueDeserializer};
use toml::{Spanned, Table, Value};

/// A text being read, and what was found wrong with it so far.
pub(super) struct Source<'t> {
    path: &'t str,
    text: &'t str,
    found: RefCell<Vec<Diagnostic>>,
}

/// One table of it.
pub(super) struct Record<'s> {
    source: &'s Source<'s>,
    /// What messages call it: ``plant `betula-pendula` ``.
    title: String,
    /// Where it starts, in bytes.
    at: usize,
    table: &'s DeTable<'s>,
    asked: Vec<&'static str>,
}

/// A value of a record, and where it stands.
type Field<'s> = &'s Spanned<DeValue<'s>>;

impl<'t> Source<'t> {
    /// A text under its path.
    pub fn new(path: &'t str, text: &'t str) -> Source<'t> {
        Source { path, text, found: RefCell::default() }
    }

    /// Its path.
    pub fn path(&self) -> &str {
        self.path
    }

    /// The text as tables; broken lines are reported and left out.
    pub fn parse(&self) -> DeTable<'t> {
        let (table, errors) = DeTable::parse_recoverable(self.text);
        for error in errors {
            self.report(self.error(error.span().map_or(0, |span| span.start), error.message()));
        }
        table.into_inner()
    }

    /// The whole text as a record.
    pub fn record<'s>(&'s self, table: &'s DeTable<'t>) -> Record<'s>
    where
        't: 's,
    {
        Record { source: self, title: "the catalogue".into(), at: 0, table, asked: Vec::new() }
    }

    /// Everything reported.
    pub fn into_found(self) -> Vec<Diagnostic> {
        self.found.into_inner()
    }

    /// Takes one more report in.
    pub fn report(&self, diagnostic: Diagnostic) {
        self.found.borrow_mut().push(diagnostic);
    }

    fn error(&self, at: usize, message: impl Into<String>) -> Diagnostic {
        Diagnostic::data("catalogue", self.place(at), message)
    }

    /// `path:line:column` of a byte.
    fn place(&self, at: usize) -> String {
        let before = self.text.get(..at).unwrap_or(self.text);
        let line = before.matches('\n').count() + 1;
        let column = before.rsplit('\n').next().map_or(0, |last| last.chars().count()) + 1;
        format!("{}:{line}:{column}", self.path)
    }
}

impl<'s> Record<'s> {
    /// Reports something wrong with the record as a whole.
    pub fn fail(&self, message: impl std::fmt::Display) -> Diagnostic {
        self.source.error(self.at, format!("{}: {message}", self.title))
    }

    /// Where it comes from.
    pub fn source(&self) -> &'s Source<'s> {
        self.source
    }

    /// Whether the key is written.
    pub fn has(&self, key: &str) -> bool {
        self.table.iter().any(|(name, _)| name.get_ref() == key)
    }

    /// A number between two limits, both allowed.
    pub fn number(&mut self, key: &'static str, least: f64, most: f64) -> Option<f64> {
        let field = self.take(key)?;
        match plain(field) {
            Some(Value::Float(number)) if (least..=most).contains(&number) => Some(number),
            Some(Value::Integer(number)) if (least..=most).contains(&(number as f64)) => Some(number as f64),
            _ => self.refuse(key, field, &format!("a number from {least} to {most}")),
        }
    }

    /// A whole number between two limits, both allowed.
    pub fn count(&mut self, key: &'static str, least: u32, most: u32) -> Option<u32> {
        let field = self.take(key)?;
        let number = plain(field).and_then(|value| value.as_integer()).and_then(|number| u32::try_from(number).ok());
        match number.filter(|number| (least..=most).contains(number)) {
            None => self.refuse(key, field, &format!("a whole number from {least} to {most}")),
            number => number,
        }
    }

    /// Three lengths in metres.
    pub fn size(&mut self, key: &'static str) -> Option<[f64; 3]> {
        let field = self.take(key)?;
        let lengths: Option<Vec<f64>> = field.get_ref().as_array().and_then(|array| array.iter().map(length).collect());
        match lengths.and_then(|lengths| <[f64; 3]>::try_from(lengths).ok()) {
            None => self.refuse(key, field, "three lengths in metres: `[x, y, z]`, y being the height"),
            size => size,
        }
    }

    /// A text.
    pub fn text(&mut self, key: &'static str) -> Option<Arc<str>> {
        let field = self.take(key)?;
        match field.get_ref().as_str() {
            Some(text) => Some(text.into()),
            None => self.refuse(key, field, "a text"),
        }
    }

    /// A list of texts.
    pub fn texts(&mut self, key: &'static str) -> Option<Vec<Arc<str>>> {
        let field = self.take(key)?;
        let each = |array: &'s toml::de::DeArray<'s>| {
            array.iter().map(|item| item.get_ref().as_str().map(Arc::from)).collect::<Option<Vec<_>>>()
        };
        match field.get_ref().as_array().and_then(each) {
            None => self.refuse(key, field, "a list of texts"),
            texts => texts,
        }
    }

    /// A colour.
    pub fn color(&mut self, key: &'static str) -> Option<[f32; 4]> {
        let field = self.take(key)?;
        match field.get_ref().as_str().and_then(parse_color) {
            None => self.refuse(key, field, "a colour like `#9bb86b`"),
            color => color,
        }
    }

    /// One of a set of words.
    pub fn word<W: Words>(&mut self, key: &'static str) -> Option<W> {
        let field = self.take(key)?;
        let written = field.get_ref().as_str().unwrap_or_default();
        if let Some(choice) = W::from_word(written) {
            return Some(choice);
        }
        let words: Vec<String> = W::ALL.iter().map(|(word, _)| format!("`{word}`")).collect();
        let message = self.found_instead(key, field, &format!("one of {}", words.join(", ")));
        self.source.report(message.did_you_mean(W::nearest(written)));
        None
    }

    /// A table that is kept as it is written.
    pub fn free(&mut self, key: &'static str) -> Option<Table> {
        let field = self.take(key)?;
        match plain(field) {
            Some(Value::Table(table)) => Some(table),
            _ => self.refuse(key, field, "a table"),
        }
    }

    /// The tables below a key, in the order written.
    pub fn records(&mut self, key: &'static str) -> Vec<(Arc<str>, Record<'s>)> {
        let Some(field) = self.take(key) else { return Vec::new() };
        let Some(table) = field.get_ref().as_table() else {
            self.refuse::<()>(key, field, "a table of tables");
            return Vec::new();
        };
        let mut entries: Vec<_> = table.iter().collect();
        entries.sort_by_key(|(name, _)| name.span().start);
        entries.into_iter().filter_map(|(name, value)| self.below(key, name, value)).collect()
    }

    /// Reports the keys nobody asked for.
    pub fn finish(self) {
        for (name, _) in self.table.iter().filter(|(name, _)| !self.asked.contains(&&**name.get_ref())) {
            let known = text::nearest(name.get_ref(), self.asked.iter().copied());
            let message = format!("{}: there is no key `{}` here", self.title, name.get_ref());
            let place = Place::Data(self.source.place(name.span().start).into());
            let unknown = Diagnostic::new(Severity::Lint, "catalogue-key", place, message);
            let keys =
                format!("known are {}", self.asked.iter().map(|k| format!("`{k}`")).collect::<Vec<_>>().join(", "));
            self.source.report(unknown.did_you_mean(known).hint(keys));
        }
    }

    fn below(
        &self,
        key: &str,
        name: &'s Spanned<std::borrow::Cow<'s, str>>,
        value: Field<'s>,
    ) -> Option<(Arc<str>, Record<'s>)> {
        let outer = if self.at == 0 { String::new() } else { format!("{}, ", self.title) };
        let title = format!("{outer}{} `{}`", key.trim_end_matches('s'), name.get_ref());
        let at = name.span().start;
        let Some(table) = value.get_ref().as_table() else {
            let found = value.get_ref().type_str();
            self.source.report(self.source.error(at, format!("{title}: a table is expected, not {found}")));
            return None;
        };
        Some((name.get_ref().as_ref().into(), Record { source: self.source, title, at, table, asked: Vec::new() }))
    }

    fn take(&mut self, key: &'static str) -> Option<Field<'s>> {
        self.asked.push(key);
        self.table.iter().find(|(name, _)| name.get_ref() == key).map(|(_, value)| value)
    }

    fn refuse<T>(&self, key: &str, field: Field<'s>, wanted: &str) -> Option<T> {
        self.source.report(self.found_instead(key, field, wanted));
        None
    }

    fn found_instead(&self, key: &str, field: Field<'s>, wanted: &str) -> Diagnostic {
        let span = field.span();
        let written = self.source.text.get(span.clone()).unwrap_or_default().lines().next().unwrap_or_default();
        let found: String = written.chars().take(40).collect();
        self.source.error(span.start, format!("{}: `{key}` must be {wanted}, not `{found}`", self.title))
    }
}

/// The value without its places; `None` for numbers out of range.
fn plain(field: Field<'_>) -> Option<Value> {
    Value::deserialize(ValueDeserializer::from(field.clone())).ok()
}

/// A finite length that is not negative.
fn length(field: Field<'_>) -> Option<f64> {
    let number = match plain(field)? {
        Value::Float(number) => number,
        Value::Integer(number) => number as f64,
        _ => return None,
    };
    (number.is_finite() && number >= 0.0).then_some(number)
}
