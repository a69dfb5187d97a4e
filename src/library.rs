//! The pattern library: the rule files under `rules/`, built in, so that every place can import them.
//!
//! In: a path that begins with `bosquet:`, as in `import groves : "bosquet:patterns/cluster.cga"`. Out: the text. What a
//! file of the library imports itself is relative to it, as everywhere.

/// What a path into the library begins with.
pub const PREFIX: &str = "bosquet:";

/// Files by their paths below `rules/`.
macro_rules! files {
    ($($path:literal)*) => {
        /// Every file of the library: its path below `rules/`, and its text.
        pub static FILES: &[(&str, &str)] = &[$(($path, include_str!(concat!("../rules/", $path)))),*];
    };
}

files! {
    "palettes/continental.cga"
    "palettes/formal.cga"
    "palettes/mediterranean.cga"
    "palettes/subtropical.cga"
    "palettes/temperate.cga"
    "patterns/along.cga"
    "patterns/baseline-benes.cga"
    "patterns/baseline-random.cga"
    "patterns/boundary.cga"
    "patterns/cluster.cga"
    "patterns/commercial.cga"
    "patterns/equidistant.cga"
    "patterns/industrial.cga"
    "patterns/other.cga"
    "patterns/quincunx.cga"
    "patterns/regular.cga"
    "patterns/residential.cga"
    "patterns/rows.cga"
    "patterns/semirandom.cga"
    "patterns/single.cga"
    "patterns/street.cga"
    "patterns/zones.cga"
}

/// The text at a path with [`PREFIX`]; `None` where the library has no such file.
pub fn text(path: &str) -> Option<&'static str> {
    let inside = path.strip_prefix(PREFIX)?;
    FILES.iter().find(|(path, _)| *path == inside).map(|(_, text)| *text)
}

/// The files of the library with a path in their folder, to be told where that path leads to none; `None` for paths that
/// do not lead into the library.
pub fn beside(path: &str) -> Option<String> {
    let inside = path.strip_prefix(PREFIX)?;
    let folder = inside.split_once('/').map_or("patterns", |(folder, _)| folder);
    let names = FILES.iter().filter_map(|(path, _)| path.strip_prefix(folder)?.strip_prefix('/'));
    let names: Vec<String> = names.map(|name| format!("`{name}`")).collect();
    (!names.is_empty()).then(|| format!("`{PREFIX}{folder}/` has {}", names.join(", ")))
}
