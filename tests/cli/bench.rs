//! A folder with files, and runs of the command in it.

use serde_json::Value;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use tempfile::TempDir;

/// A lot of 20 × 20 m with a house and a drive, a second beside it with an oak and its door, a patio for which most
/// tests have no rule, and a street; local metres.
pub const TWO_LOTS: &str = r#"{"type": "FeatureCollection", "crs": "local", "features": [
{"type": "Feature", "properties": {"id": "west", "kind": "lot", "wide": 5}, "geometry": {"type": "Polygon",
  "coordinates": [[[0, 0], [20, 0], [20, 20], [0, 20], [0, 0]]]}},
{"type": "Feature", "properties": {"id": "east", "kind": "lot", "wide": 0}, "geometry": {"type": "Polygon",
  "coordinates": [[[20, 0], [40, 0], [40, 20], [20, 20], [20, 0]]]}},
{"type": "Feature", "properties": {"id": "yard", "kind": "patio"}, "geometry": {"type": "Polygon",
  "coordinates": [[[40, 0], [60, 0], [60, 20], [40, 20], [40, 0]]]}},
{"type": "Feature", "properties": {"id": "house", "kind": "building"}, "geometry": {"type": "Polygon",
  "coordinates": [[[5, 10], [15, 10], [15, 15], [5, 15], [5, 10]]]}},
{"type": "Feature", "properties": {"id": "drive", "kind": "driveway"}, "geometry": {"type": "Polygon",
  "coordinates": [[[5, 0], [8, 0], [8, 10], [5, 10], [5, 0]]]}},
{"type": "Feature", "properties": {"id": "oak", "kind": "tree", "species": "Quercus robur", "height": 14,
  "crown_radius": 3}, "geometry": {"type": "Point", "coordinates": [30, 10, 2.5]}},
{"type": "Feature", "properties": {"id": "door", "kind": "entrance"},
  "geometry": {"type": "Point", "coordinates": [10, 10]}},
{"type": "Feature", "properties": {"id": "street", "kind": "street", "width": 6},
  "geometry": {"type": "LineString", "coordinates": [[-5, -4], [65, -4]]}}
]}"#;

/// A place of one lot of 30 × 20 m with trees and an attribute.
pub const GARDEN: &[(&str, &str)] = &[
    ("garden/bosquet.toml", "layout = \"lot.geojson\"\nrules = \"garden.cga\"\nseed = 4\n"),
    (
        "garden/lot.geojson",
        r#"{"type": "FeatureCollection", "crs": "local", "features": [{"type": "Feature", "properties": {"kind": "lot"},
        "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [30, 0], [30, 20], [0, 20], [0, 0]]]}}]}"#,
    ),
    (
        "garden/garden.cga",
        "attr hedge_height = 1.2\nattr shady = false\n\
         Lot --> setback(1) { all = Hedge | remainder : Inside }\n\
         Hedge --> extrude(hedge_height) Clipped.\n\
         Inside --> [ Distr(0.02, 0) { Tree } ] Lawn\n\
         Tree --> case shady : I(beech, adult, rand(3)) else : I(birch, young, rand(3))\n",
    ),
];

/// A folder of its own.
pub struct Bench {
    folder: TempDir,
}

/// What a run said and how it ended.
#[derive(Debug)]
pub struct Ran {
    /// The exit code.
    pub code: i32,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

impl Bench {
    /// An empty folder.
    pub fn new() -> Bench {
        Bench { folder: tempfile::tempdir().expect("a folder for the test") }
    }

    /// With the place [`GARDEN`] in `garden`.
    pub fn garden() -> Bench {
        GARDEN.iter().fold(Bench::new(), |bench, (path, text)| bench.with(path, text))
    }

    /// With the layout [`TWO_LOTS`] as `two.geojson` and these rules as `rules.cga`.
    pub fn two_lots(rules: &str) -> Bench {
        Bench::new().with("two.geojson", TWO_LOTS).with("rules.cga", rules)
    }

    /// The same with one more file.
    pub fn with(self, path: &str, bytes: impl AsRef<[u8]>) -> Bench {
        let path = self.path(path);
        path.parent().map(std::fs::create_dir_all).transpose().expect("a folder");
        std::fs::write(path, bytes).expect("a file");
        self
    }

    /// A path in the folder.
    pub fn path(&self, path: &str) -> PathBuf {
        self.folder.path().join(path)
    }

    /// Whether there is such a file.
    pub fn has(&self, path: &str) -> bool {
        self.path(path).exists()
    }

    /// A file's bytes.
    pub fn bytes(&self, path: &str) -> Vec<u8> {
        std::fs::read(self.path(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
    }

    /// A file's text.
    pub fn text(&self, path: &str) -> String {
        String::from_utf8(self.bytes(path)).expect("a text")
    }

    /// A file as JSON.
    pub fn json(&self, path: &str) -> Value {
        serde_json::from_slice(&self.bytes(path)).expect("JSON")
    }

    /// The names in the folder, sorted.
    pub fn names(&self) -> Vec<String> {
        let entries = std::fs::read_dir(self.folder.path()).expect("the folder");
        let mut names: Vec<String> =
            entries.map(|e| e.expect("an entry").file_name().to_string_lossy().into_owned()).collect();
        names.sort();
        names
    }

    /// The command with these arguments, in this folder.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_bosquet"));
        command.current_dir(self.folder.path()).args(arguments);
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Runs the command.
    pub fn run(&self, arguments: &[&str]) -> Ran {
        let ran = Ran::of(self.command(arguments).output().expect("the command starts"));
        assert!(ran.code != 101 && !ran.err.contains("panicked"), "bosquet {arguments:?} panics: {ran:#?}");
        ran
    }

    /// Runs it with arguments in one text, apart at spaces.
    pub fn bosquet(&self, line: &str) -> Ran {
        self.run(&line.split_whitespace().collect::<Vec<_>>())
    }

    /// Runs `bosquet derive two.geojson --rules rules.cga …`.
    pub fn derive_two(&self, more: &str) -> Ran {
        self.bosquet(&format!("derive two.geojson --rules rules.cga {more}"))
    }
}

impl Ran {
    /// What a process left.
    pub fn of(output: Output) -> Ran {
        let text = |bytes: Vec<u8>| String::from_utf8_lossy(&bytes).into_owned();
        Ran { code: output.status.code().unwrap_or(-1), out: text(output.stdout), err: text(output.stderr) }
    }

    /// Fails unless it ended so.
    #[track_caller]
    pub fn ends(self, code: i32) -> Ran {
        assert_eq!(self.code, code, "{self:#?}");
        self
    }

    /// Fails unless standard error has all of these.
    #[track_caller]
    pub fn says(self, words: &[&str]) -> Ran {
        words.iter().for_each(|word| assert!(self.err.contains(word), "`{word}` is not said: {self:#?}"));
        self
    }
}

/// A file or folder of the repository.
pub fn repository(path: &str) -> String {
    Path::new(env!("CARGO_MANIFEST_DIR")).join(path).to_string_lossy().into_owned()
}
