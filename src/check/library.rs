//! The pattern library, built into the binary: `import avenue : "bosquet/avenue.cga"`.

/// The files, with the names they are imported by.
pub static LIBRARY: &[(&str, &str)] = &[];

/// The text of a library file.
pub fn find(path: &str) -> Option<&'static str> {
    LIBRARY.iter().find(|(name, _)| *name == path).map(|(_, text)| *text)
}
