//! What fuzzing has found, kept small in `tests/regress/` under a name that says what it was: a program, with
//! `// Layout:` lines where it matters and a second file after `// File: second.cga`.

#[path = "common/place.rs"]
mod place;
#[path = "common/told.rs"]
mod told;
#[path = "common/trial.rs"]
mod trial;

use bosquet::seed::Seed;
use std::path::Path;
use trial::{Files, Verdict};

#[test]
fn what_was_found_stays_mended() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/regress");
    for entry in std::fs::read_dir(folder).expect("the folder") {
        let path = entry.expect("an entry").path();
        let text = std::fs::read_to_string(&path).expect("a readable file");
        let (main, second) = text.split_once("// File: second.cga\n").unwrap_or((&text, ""));
        let files = Files { main: main.into(), second: second.into() };
        let statements: Vec<&str> = main.lines().filter_map(|line| line.strip_prefix("// Layout: ")).collect();
        let layout = place::parse(&statements).expect("a layout");
        match trial::tried(&files, &layout, Seed(3)) {
            Verdict::Ran(written) => assert!(!written.tree.is_empty()),
            Verdict::Refused(told) => panic!("{} is refused: {told:?}", path.display()),
        }
    }
}
