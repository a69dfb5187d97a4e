//! URIs of editors and paths of worlds: `file:///gardens/a%20b.cga` is `/gardens/a b.cga`; other schemes are kept whole.

use crate::cli::lsp::texts::{shelf, shelve};
use bosquet::library;
use lsp_types::Uri;
use std::str::FromStr;

/// What a world calls the file of a URI; files on the shelf are the library's.
pub fn path(uri: &Uri) -> String {
    let Some(rest) = uri.as_str().strip_prefix("file://") else { return uri.as_str().to_string() };
    let rest = rest.find('/').map_or(rest, |slash| &rest[slash..]);
    let path = decoded(rest);
    // `/C:/gardens` is `C:/gardens`.
    let drive = path.as_bytes().get(2) == Some(&b':') && path.as_bytes()[1].is_ascii_alphabetic();
    let path = if drive { path[1..].to_string() } else { path };
    let shelf = shelf().map(|shelf| shelf.to_string_lossy().replace('\\', "/") + "/");
    match shelf.and_then(|shelf| path.strip_prefix(&shelf).map(|inside| format!("{}{inside}", library::PREFIX))) {
        Some(inside) if library::text(&inside).is_some() => inside,
        _ => path,
    }
}

/// Whether a URI names a file on the disk.
pub fn is_file(uri: &Uri) -> bool {
    uri.as_str().starts_with("file://")
}

/// What an editor calls the file at a path; `None` where it cannot be shown.
pub fn of(path: &str) -> Option<Uri> {
    if path.starts_with(library::PREFIX) {
        return of(&shelve(path)?.to_string_lossy().replace('\\', "/"));
    }
    let is_drive = path.as_bytes().get(1) == Some(&b':');
    match path.starts_with('/') || is_drive {
        true => Uri::from_str(&address(path)).ok(),
        false => Uri::from_str(path).ok(),
    }
}

/// The URI of a path on the disk, as text.
pub fn address(path: &str) -> String {
    let slash = if path.starts_with('/') { "" } else { "/" };
    format!("file://{slash}{}", encoded(path))
}

fn encoded(path: &str) -> String {
    let mut text = String::with_capacity(path.len());
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' | b':' => text.push(byte.into()),
            other => text += &format!("%{other:02X}"),
        }
    }
    text
}

fn decoded(text: &str) -> String {
    let (mut bytes, mut rest) = (Vec::with_capacity(text.len()), text.as_bytes());
    while let Some((first, after)) = rest.split_first() {
        let pair = after.get(..2).filter(|_| *first == b'%').and_then(|pair| std::str::from_utf8(pair).ok());
        match pair.and_then(|pair| u8::from_str_radix(pair, 16).ok()) {
            Some(byte) => {
                bytes.push(byte);
                rest = &after[2..];
            }
            None => {
                bytes.push(*first);
                rest = after;
            }
        }
    }
    String::from_utf8_lossy(&bytes).into_owned()
}
