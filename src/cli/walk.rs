//! The files below a folder, by one set of rules: for listings, for the formatter, for the editor.
//!
//! Hidden files and folders are passed over, and folders that other tools fill: `node_modules`, and those which say that
//! they are caches (a `CACHEDIR.TAG` lies in them, as in Cargo's). Links to folders are not followed, so there is no circle.

use std::io::Result;
use std::path::{Path, PathBuf};

/// Gives every file to `each`, by name in each folder; folders in folders to the depth `deepest`, 0 for none.
///
/// What cannot be read is given as its error: `each` decides whether that ends it, as any error of its own does.
pub fn walk(folder: &Path, deepest: usize, each: &mut dyn FnMut(Result<PathBuf>) -> Result<()>) -> Result<()> {
    let mut entries = match std::fs::read_dir(folder).and_then(Iterator::collect::<Result<Vec<_>>>) {
        Ok(entries) => entries,
        Err(error) => return each(Err(error)),
    };
    entries.sort_unstable_by_key(std::fs::DirEntry::file_name);
    entries.retain(|entry| !entry.file_name().as_encoded_bytes().starts_with(b"."));
    for entry in entries {
        let path = entry.path();
        match entry.file_type() {
            Ok(kind) if kind.is_dir() && (deepest == 0 || is_foreign(&path)) => {}
            Ok(kind) if kind.is_dir() => walk(&path, deepest - 1, each)?,
            Ok(kind) if kind.is_symlink() && path.is_dir() => {}
            Ok(_) => each(Ok(path))?,
            Err(error) => each(Err(error))?,
        }
    }
    Ok(())
}

/// Whether a folder is another tool's.
fn is_foreign(folder: &Path) -> bool {
    folder.ends_with("node_modules") || folder.join("CACHEDIR.TAG").is_file()
}

/// Whether a path is a rule file's, by its ending.
pub fn is_rules(path: &Path) -> bool {
    path.extension().is_some_and(|ending| ending == "cga")
}
