//! Bytes → text: UTF-8 and UTF-16 by their marks, else UTF-8, else Windows-1252, as spreadsheets still write it.

use crate::text::from_windows_1252;

/// The text of a file.
pub fn decode(bytes: &[u8]) -> String {
    match bytes {
        [0xef, 0xbb, 0xbf, rest @ ..] => plain(rest),
        [0xff, 0xfe, rest @ ..] => wide(rest, u16::from_le_bytes),
        [0xfe, 0xff, rest @ ..] => wide(rest, u16::from_be_bytes),
        bytes => plain(bytes),
    }
}

fn plain(bytes: &[u8]) -> String {
    match std::str::from_utf8(bytes) {
        Ok(text) => text.into(),
        Err(_) => bytes.iter().map(|byte| from_windows_1252(*byte)).collect(),
    }
}

fn wide(bytes: &[u8], unit: fn([u8; 2]) -> u16) -> String {
    let units: Vec<u16> = bytes.chunks_exact(2).map(|pair| unit([pair[0], pair[1]])).collect();
    String::from_utf16_lossy(&units)
}

/// Line ends as `\n`, and `?` for characters that have no picture.
pub fn clean(text: &str) -> String {
    let text = text.replace("\r\n", "\n").replace('\r', "\n");
    let is_unprintable = |c: char| c.is_control() && c != '\n' && c != '\t';
    if text.contains(is_unprintable) { text.replace(is_unprintable, "?") } else { text }
}
