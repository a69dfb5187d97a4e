//! The floors of the house: a room imports only from lower ones, so that it can be read without those above.
//!
//! Reads every `crate::room` path of `src/`, tests inside the files included, and says file and line of what runs up.

use std::path::{Path, PathBuf};

/// Every room with its floor; a room on the same floor as another does not see it.
const FLOORS: &[(&str, u32)] = &[
    ("unit", 1),
    ("seed", 1),
    ("text", 1),
    ("library", 1),
    ("pattern", 1),
    ("shelf", 1),
    ("geometry", 2),
    ("value", 2),
    ("diag", 2),
    ("world", 2),
    ("syntax", 3),
    ("shape", 3),
    ("layout", 3),
    ("placement", 3),
    ("element", 3),
    ("scene", 4),
    ("plant", 4),
    ("raster", 4),
    ("files", 4),
    ("ops", 5),
    ("functions", 5),
    ("check", 6),
    ("stats", 6),
    ("diff", 6),
    ("derive", 7),
    ("export", 7),
    ("trace", 7),
    ("manual", 8),
    ("cli", 9),
    ("main", 9),
];

/// The face: it lists the rooms and belongs to none.
const FACE: &str = "lib";

fn floor(room: &str) -> Option<u32> {
    FLOORS.iter().find(|(name, _)| *name == room).map(|(_, floor)| *floor)
}

/// Every `.rs` file under a folder, sorted.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(folder).expect("the sources are there");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("a readable folder").path()).collect();
    paths.sort();
    let inside = |path: PathBuf| if path.is_dir() { files(&path) } else { vec![path] };
    paths.into_iter().flat_map(inside).filter(|path| path.extension().is_some_and(|e| e == "rs")).collect()
}

/// The room a file belongs to: the first folder or file under `src`.
fn room_of(relative: &Path) -> String {
    let first = relative.iter().next().unwrap_or_default().to_string_lossy();
    first.trim_end_matches(".rs").to_string()
}

/// The rooms that a line of code names after `crate::`; a brace after it comes back as such.
fn named(line: &str) -> impl Iterator<Item = &str> {
    line.split("crate::").skip(1).map(|rest| {
        let end = rest.find(|c: char| !c.is_alphanumeric() && c != '_').unwrap_or(rest.len());
        if end == 0 { &rest[..1.min(rest.len())] } else { &rest[..end] }
    })
}

/// What is wrong with one line of a room.
fn wrong(room: &str, line: &str) -> Vec<String> {
    let code = line.split("//").next().unwrap_or_default();
    let mut found = Vec::new();
    if code.contains("super::super") {
        found.push("`super::super`: name the room, `crate::room::…`".to_string());
    }
    for target in named(code).filter(|target| *target != room) {
        match (floor(room), floor(target)) {
            (_, None) => found.push(format!("`crate::{target}` is not a room: paths begin with the room's name")),
            (Some(here), Some(there)) if there > here => {
                found.push(format!("`{room}` (floor {here}) imports from `{target}` above it (floor {there})"));
            }
            (Some(here), Some(there)) if there == here => {
                found.push(format!("`{room}` imports from `{target}` beside it (floor {here})"));
            }
            _ => {}
        }
    }
    found
}

#[test]
fn rooms_import_from_lower_floors_only() {
    let src = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let (mut paths, mut violations) = (0, Vec::new());
    for path in files(&src) {
        let relative = path.strip_prefix(&src).expect("a file under src");
        let room = room_of(relative);
        if room == FACE {
            continue;
        }
        if floor(&room).is_none() {
            violations.push(format!("src/{}: the room `{room}` has no floor yet", relative.display()));
        }
        let text = std::fs::read_to_string(&path).expect("a readable source");
        for (number, line) in text.lines().enumerate() {
            paths += named(line).count();
            let place = format!("src/{}:{}", relative.display(), number + 1);
            violations.extend(wrong(&room, line).into_iter().map(|message| format!("{place}: {message}")));
        }
    }
    assert!(violations.is_empty(), "{} violations:\n{}", violations.len(), violations.join("\n"));
    assert!(paths > 300, "only {paths} paths were seen: the test no longer reads the sources");
}

#[test]
fn violations_are_seen() {
    assert_eq!(wrong("geometry", "use crate::geometry::Polygon; // crate::cli::x"), Vec::<String>::new());
    assert_eq!(wrong("derive", "let x = crate::value::Value::Bool(crate::diag::f());"), Vec::<String>::new());
    let up = wrong("shape", "    pub(crate) fn f(_: $crate::derive::Options) {}");
    assert!(up[0].contains("floor 3") && up[0].contains("floor 7"), "{up:?}");
    let beside = wrong("ops", "use crate::functions::find;");
    assert!(beside[0].contains("beside"), "{beside:?}");
    assert_eq!(wrong("ops", "use crate::{diag, seed};").len(), 1);
    assert_eq!(wrong("ops", "use crate::Polygon;").len(), 1);
    assert_eq!(wrong("ops", "use super::super::seed;").len(), 1);
}
