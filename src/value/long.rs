//! Values as texts that do not grow without end: arrays repeat what they share, and a rule may double a text each turn.

use crate::value::Value;
use std::fmt::{self, Write};

/// The longest text that an expression makes, bytes.
pub const MOST_TEXT: usize = 1 << 20;

/// Characters of a value that a message shows.
const SHOWN: usize = 40;

impl Value {
    /// A text from its parts, unless it is longer than the limit. Cost: linear in what is written, the limit at most.
    pub fn written(parts: fmt::Arguments) -> Result<Value, String> {
        let mut text = Bounded { text: String::new(), most: MOST_TEXT };
        text.write_fmt(parts).map_err(|_| too_long())?;
        Ok(Value::text(text.text))
    }

    /// The value as messages show it: cut where it is long.
    pub fn shown(&self) -> String {
        let mut text = Bounded { text: String::new(), most: SHOWN * 4 };
        let is_whole = write!(text, "{self}").is_ok();
        match text.text.char_indices().nth(SHOWN) {
            Some((end, _)) => format!("{}…", &text.text[..end]),
            None if is_whole => text.text,
            None => text.text + "…",
        }
    }
}

/// An error where a text would have more bytes than the limit.
pub fn within_text(bytes: usize) -> Result<(), String> {
    if bytes <= MOST_TEXT { Ok(()) } else { Err(too_long()) }
}

fn too_long() -> String {
    format!("would be a text of more than {MOST_TEXT} bytes: the limit `text`")
}

/// A text that refuses what is too much for it.
struct Bounded {
    text: String,
    most: usize,
}

impl Write for Bounded {
    fn write_str(&mut self, part: &str) -> fmt::Result {
        let room = self.most - self.text.len();
        let end = part.len().min(room);
        let end = (0..=end).rev().find(|at| part.is_char_boundary(*at)).unwrap_or(0);
        self.text.push_str(&part[..end]);
        if end == part.len() { Ok(()) } else { Err(fmt::Error) }
    }
}
