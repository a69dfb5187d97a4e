//! Where files are looked for, and which of them a query means.
//!
//! A path is looked for in the folder of the rule file that names it, in `assets`, `data`, `images` and `models` there,
//! then likewise beside that folder, since CityEngine keeps `rules` and `assets` side by side. A path that begins with `/`
//! is taken as it is, or else from the project's folder, with the project's name or without it.

use crate::files::{FileError, Files};
use crate::library;
use crate::pattern::{Regex, glob};
use crate::world::{WorldError, join};
use std::sync::Arc;

/// Folders below that of the rules, and beside it, that are searched.
const FOLDERS: [&str; 5] = ["", "assets/", "data/", "images/", "models/"];

impl Files<'_> {
    /// The first of the places of a path where there is a file.
    pub(super) fn resolve(&self, source: u16, path: &str) -> Result<String, FileError> {
        let candidates = self.candidates(source, path);
        if let Some(found) = candidates.iter().find(|candidate| self.world.exists(candidate)) {
            return Ok(found.clone());
        }
        // A path that leads out of what may be read is told as that.
        match candidates.first().map(|first| self.world.asset(first)) {
            Some(Err(error)) if !matches!(error, WorldError::Missing(_)) => Err(error.into()),
            _ => Err(FileError::Unfound(path.into())),
        }
    }

    pub(super) fn candidates(&self, source: u16, path: &str) -> Vec<String> {
        let rules = self.rules(source);
        if path.is_empty() {
            return Vec::new();
        }
        if let Some(inside) = path.strip_prefix('/') {
            let without_project = inside.split_once('/').map(|(_, rest)| rest);
            let within = without_project.into_iter().chain([inside]);
            let from_project = within.flat_map(|p| [join(rules, p), join(rules, &format!("../{p}"))]);
            return std::iter::once(path.to_string()).chain(from_project).collect();
        }
        let places = |up: &'static str| FOLDERS.map(|folder| join(rules, &format!("{up}{folder}{path}")));
        places("").into_iter().chain(places("../")).collect()
    }

    /// The rule file that paths are relative to: the library's have no folder, and take the main file's.
    fn rules(&self, source: u16) -> &str {
        let own = self.sources.get(source as usize).filter(|path| !path.starts_with(library::PREFIX));
        own.or(self.sources.first()).map_or("", String::as_str)
    }

    /// Every file that a query means, sorted, as paths from the folder of the rule file. Cost: linear in the files where
    /// a query is new, else that of finding it again.
    pub fn search(&self, source: u16, query: &str) -> Result<Arc<[Arc<str>]>, FileError> {
        let rules = self.rules(source);
        self.searches.get(&format!("{rules}\n{query}"), |_| self.searched(rules, query))
    }

    fn searched(&self, rules: &str, query: &str) -> Result<Arc<[Arc<str>]>, FileError> {
        let terms = terms(query).map_err(FileError::Query)?;
        let mut found: Vec<String> = Vec::new();
        for up in ["", "../"] {
            let folder = folder_of(&join(rules, &format!("{up}_")));
            for file in self.listing(&folder)?.iter() {
                let inside = file.get(folder.len()..).unwrap_or(file);
                // What lies beside the rules is found from there; below them it was found already.
                let path = format!("{up}{inside}");
                let is_known = up == "../" && is_below(rules, &folder, inside);
                if !is_known && terms.iter().all(|term| term.takes(inside)) {
                    found.push(path);
                }
            }
        }
        found.sort_unstable();
        Ok(found.into_iter().map(Into::into).collect())
    }

    fn listing(&self, folder: &str) -> Result<Arc<[String]>, FileError> {
        self.listings.get(folder, |folder| match self.world.list(folder) {
            Ok(files) => Ok(files.into()),
            // The folder beside the rules may be closed; nothing is found in it then.
            Err(WorldError::Outside(_) | WorldError::Missing(_)) => Ok(Arc::new([])),
            Err(error) => Err(error.into()),
        })
    }
}

/// The folder of a path with its slash; empty where it has none.
fn folder_of(path: &str) -> String {
    path.rsplit_once('/').map_or(String::new(), |(folder, _)| format!("{folder}/"))
}

/// Whether a file in the folder beside the rules lies in the rules' own.
fn is_below(rules: &str, beside: &str, inside: &str) -> bool {
    let own = folder_of(rules);
    own.strip_prefix(beside).is_some_and(|name| !name.is_empty() && inside.starts_with(name))
}

/// One condition of a query.
enum Term {
    /// `*` and `?` on the path.
    Path(String),
    /// A regular expression on the path.
    Expression(Regex),
    /// `Name=`, `Ext=`, `Path=`: the file's name, its ending, or its folder and name.
    Property(&'static str, String),
}

/// The conditions of a query, all of which must hold: words between spaces; quotes `'…'` keep spaces together.
fn terms(query: &str) -> Result<Vec<Term>, String> {
    if let Some(expression) = query.strip_prefix('$') {
        return Ok(vec![Term::Expression(Regex::new(expression)?)]);
    }
    let mut words = vec![String::new()];
    let mut quoted = false;
    for letter in query.chars() {
        match letter {
            '\'' => quoted = !quoted,
            letter if letter.is_whitespace() && !quoted => words.push(String::new()),
            letter => words.last_mut().expect("one at least").push(letter),
        }
    }
    words.retain(|word| !word.is_empty());
    if words.is_empty() {
        return Err("takes a pattern such as `\"trees/*.png\"`, found nothing".into());
    }
    Ok(words.into_iter().map(term).collect())
}

fn term(word: String) -> Term {
    match word.split_once('=') {
        Some(("Name", name)) => Term::Property("Name", name.into()),
        Some(("Ext", ending)) => Term::Property("Ext", ending.trim_start_matches('.').into()),
        Some(("Path", path)) => Term::Property("Path", path.into()),
        // There is one project, whatever it is called.
        Some(("Project", _)) => Term::Path("*".into()),
        _ => Term::Path(word),
    }
}

impl Term {
    /// Whether the file at a path below one of the two folders is meant.
    fn takes(&self, path: &str) -> bool {
        let name = path.rsplit('/').next().unwrap_or(path);
        let names = FOLDERS.iter().filter_map(|folder| path.strip_prefix(folder));
        match self {
            Term::Path(pattern) if pattern.starts_with('/') => {
                let inside = pattern[1..].split_once('/').map_or("", |(_, rest)| rest);
                glob(&pattern[1..], path) || (!inside.is_empty() && glob(inside, path))
            }
            Term::Path(pattern) => {
                let rooted = pattern.starts_with('*').then(|| glob(pattern, &format!("/{path}")));
                rooted == Some(true) || names.into_iter().any(|name| glob(pattern, name))
            }
            Term::Expression(expression) => {
                expression.fits(&format!("/{path}")) || names.into_iter().any(|name| expression.fits(name))
            }
            Term::Property("Name", wanted) => glob(wanted, name),
            Term::Property("Ext", wanted) => {
                name.rsplit_once('.').is_some_and(|(_, ending)| ending.eq_ignore_ascii_case(wanted))
            }
            Term::Property(_, wanted) => names.into_iter().any(|name| glob(wanted, name)),
        }
    }
}
