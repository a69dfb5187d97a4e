//! What fuzzing has found, kept small and under a name that says what it was: `tests/regress/parse` has rule files of
//! any bytes, `layout` layouts,
//! `derive` programs, with `// Layout:` lines where it matters and a second file after `// File: second.cga`.

#[path = "common/laid_out.rs"]
mod laid_out;
#[path = "common/place.rs"]
mod place;
#[path = "common/read.rs"]
mod read;
#[path = "common/told.rs"]
mod told;
#[path = "common/trial.rs"]
mod trial;

use bosquet::seed::Seed;
use std::path::{Path, PathBuf};
use trial::{Files, Verdict};

fn kept(what: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/regress").join(what)
}

/// The bytes of every file that was kept.
fn bytes(what: &str) -> Vec<Vec<u8>> {
    let entries = std::fs::read_dir(kept(what)).expect("the folder");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    assert!(!paths.is_empty(), "nothing is kept in {what}");
    paths.iter().map(|path| std::fs::read(path).expect("a readable file")).collect()
}

#[test]
fn rule_files() {
    bytes("parse").iter().for_each(|bytes| read::rules(bytes));
}

#[test]
fn layouts() {
    bytes("layout").iter().for_each(|bytes| laid_out::laid_out(bytes));
}

#[test]
fn programs() {
    for text in texts("derive") {
        let (main, second) = text.split_once("// File: second.cga\n").unwrap_or((&text, ""));
        let files = Files { main: main.into(), second: second.into() };
        let statements: Vec<&str> = main.lines().filter_map(|line| line.strip_prefix("// Layout: ")).collect();
        let layout = place::parse(&statements).expect("a layout");
        match trial::tried(&files, &layout, Seed(3)) {
            Verdict::Ran(written) => assert!(!written.tree.is_empty()),
            Verdict::Refused(told) => panic!("{main} is refused: {told:?}"),
        }
    }
}
