//! The one door for files: rule files, layouts, catalogues and models come in through [`World`].
//!
//! Disk, browser, tests and editor each have one. Paths are as written by the user, joined to the folder of the file
//! that names them by [`join`]; a world decides what they may reach.

use crate::library;
use std::sync::Arc;

/// Why a file could not be had.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WorldError {
    /// There is no such file.
    #[error("there is no file `{0}`")]
    Missing(String),
    /// The path leads out of what this world shows.
    #[error("`{0}` lies outside the place's folder")]
    Outside(String),
    /// The file is larger than the limit.
    #[error("`{path}` has {bytes} bytes, more than the limit `file` of {limit}")]
    TooLarge {
        /// The file.
        path: String,
        /// Its size.
        bytes: u64,
        /// The largest allowed.
        limit: u64,
    },
    /// The system refused.
    #[error("`{path}` cannot be read: {reason}")]
    Unreadable {
        /// The file.
        path: String,
        /// The system's words.
        reason: String,
    },
}

/// Where files come from.
pub trait World: Sync {
    /// The bytes of a text the user wrote: rules, layout, catalogue.
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError>;
    /// The bytes of a model or picture that a text names.
    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError>;
    /// Whether there is a file at a path that may be read.
    fn exists(&self, path: &str) -> bool {
        self.asset(path).is_ok()
    }
    /// The paths of all files below a folder, sorted; `folder` ends in `/` or is empty, and every path begins with it.
    ///
    /// None in a world that cannot tell.
    fn list(&self, _folder: &str) -> Result<Vec<String>, WorldError> {
        Ok(Vec::new())
    }
}

/// The bytes of a rule file: of the pattern library where the path begins with `bosquet:`, else of the world.
pub fn rules(world: &dyn World, path: &str) -> Result<Arc<[u8]>, WorldError> {
    if !path.starts_with(library::PREFIX) {
        return world.source(path);
    }
    let text = library::text(path).ok_or_else(|| WorldError::Missing(path.into()))?;
    Ok(text.as_bytes().into())
}

/// The rule file that `from` imports as `path`: where it is, and its bytes.
///
/// It is looked for from the folder of `from` and then as CityEngine's projects name it: from a folder `rules` above it,
/// and where the path begins with `/`, from every folder above it. The error is that of the first place.
pub fn imported(world: &dyn World, from: &str, path: &str) -> Result<(String, Arc<[u8]>), WorldError> {
    let first = join(from, path);
    let error = match rules(world, &first) {
        Ok(bytes) => return Ok((first, bytes)),
        Err(error) => error,
    };
    let found = elsewhere(from, path).into_iter().find_map(|place| Some((place.clone(), world.source(&place).ok()?)));
    found.ok_or(error)
}

/// The further places of an import, the nearest first.
fn elsewhere(from: &str, path: &str) -> Vec<String> {
    if path.starts_with(library::PREFIX) || from.starts_with(library::PREFIX) {
        return Vec::new();
    }
    let above = from.match_indices('/').rev().map(|(end, _)| &from[..end]);
    match path.strip_prefix('/') {
        Some(inside) => above.map(|folder| format!("{folder}/{inside}")).chain([inside.to_string()]).collect(),
        None => {
            let named = above.filter(|folder| folder.rsplit('/').next() == Some("rules"));
            named.map(|folder| join(&format!("{folder}/_"), path)).collect()
        }
    }
}

/// `path` as seen from the file `from`: relative to its folder, with `.` and `..` folded. Paths into the library stay in
/// it, and are the same from everywhere.
pub fn join(from: &str, path: &str) -> String {
    if path.starts_with(library::PREFIX) {
        return path.into();
    }
    if let Some(inside) = from.strip_prefix(library::PREFIX) {
        return format!("{}{}", library::PREFIX, join(inside, path));
    }
    let rooted = path.starts_with('/');
    let base = if rooted { "" } else { from.rsplit_once('/').map_or("", |(folder, _)| folder) };
    let mut parts: Vec<&str> = Vec::new();
    for part in base.split('/').chain(path.split('/')) {
        match part {
            "" | "." => {}
            ".." if parts.last().is_some_and(|p| *p != "..") => drop(parts.pop()),
            part => parts.push(part),
        }
    }
    let root = if rooted || base.starts_with('/') { "/" } else { "" };
    format!("{root}{}", parts.join("/"))
}

/// A world of texts in memory, for tests, examples and editors.
#[derive(Clone, Debug, Default)]
pub struct MemoryWorld {
    files: std::collections::BTreeMap<String, Arc<[u8]>>,
}

impl MemoryWorld {
    /// The same world with one more file.
    pub fn with(mut self, path: impl Into<String>, bytes: impl AsRef<[u8]>) -> MemoryWorld {
        self.files.insert(path.into(), bytes.as_ref().into());
        self
    }
}

impl World for MemoryWorld {
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.files.get(path).cloned().ok_or_else(|| WorldError::Missing(path.into()))
    }

    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.source(path)
    }

    fn list(&self, folder: &str) -> Result<Vec<String>, WorldError> {
        Ok(self.files.keys().filter(|path| path.starts_with(folder)).cloned().collect())
    }
}

#[cfg(test)]
mod tests {
    use super::{elsewhere, join};

    #[test]
    fn imports_are_found_from_their_project() {
        assert_eq!(elsewhere("w/p/rules/lanes/a.cga", "lanes/b.cga"), ["w/p/rules/lanes/b.cga"]);
        assert_eq!(
            elsewhere("w/p/rules/a.cga", "/q/rules/b.cga")[..2],
            ["w/p/rules/q/rules/b.cga", "w/p/q/rules/b.cga"]
        );
        assert_eq!(elsewhere("a.cga", "/b.cga"), ["b.cga"]);
        assert!(elsewhere("bosquet:patterns/a.cga", "b.cga").is_empty());
    }

    #[test]
    fn paths_are_relative_to_the_file_that_names_them() {
        assert_eq!(join("a/b.cga", "c.cga"), "a/c.cga");
        assert_eq!(join("a/b.cga", "../c.cga"), "c.cga");
        assert_eq!(join("b.cga", "../c.cga"), "../c.cga");
        assert_eq!(join("/a/b.cga", "./c.cga"), "/a/c.cga");
        assert_eq!(join("a/b.cga", "/c.cga"), "/c.cga");
        assert_eq!(join("a/b.cga", "bosquet:patterns/c.cga"), "bosquet:patterns/c.cga");
        assert_eq!(join("bosquet:patterns/c.cga", "../palettes/d.cga"), "bosquet:palettes/d.cga");
    }
}
