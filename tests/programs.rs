//! What holds for any program and any layout: it is checked or refused with words, it ends within its limits, every
//! number that comes out is one, threads change nothing, and an edit in one lot leaves the others alone.

#[path = "common/place.rs"]
mod place;
#[path = "common/programs/mod.rs"]
mod programs;
#[path = "common/read.rs"]
mod read;
#[path = "common/told.rs"]
mod told;
#[path = "common/trial.rs"]
mod trial;

use bosquet::diag::Diagnostic;
use bosquet::seed::Seed;
use proptest::prelude::*;
use trial::{Verdict, Written};

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

fn bytes() -> impl Strategy<Value = Vec<u8>> {
    prop::collection::vec(any::<u8>(), 0..600)
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn any_program_keeps_what_is_promised(bytes in bytes()) {
        let (files, layout, seed) = programs::of_bytes(&bytes);
        read::rules(files.main.as_bytes());
        trial::tried(&files, &layout, seed);
    }

    #[test]
    fn an_edit_in_one_lot_leaves_the_others_alone(bytes in bytes(), size in -3.0..20.0f64, start in 0..3usize) {
        let (mut files, _, seed) = programs::of_bytes(&bytes);
        // A context carries an edit as far as it reaches.
        files.main = files.main.replace("@Context(40)", "");
        let edit = [format!("attribute size={size}"), "attribute kind=elm".into(), "start C".into()];
        let lots = |edit: &str| {
            let statements = ["rect 12 9", edit, "rect 12 9 12 0", "rect 9 9 24 0", "feature street 0,-4 36,-4"];
            place::parse(&statements).expect("a layout")
        };
        let sides = [lots("elevation 0"), lots(&edit[start])].map(|layout| trial::tried(&files, &layout, seed));
        let [Verdict::Ran(before), Verdict::Ran(after)] = sides else { return Ok(()) };
        for lot in ["lot2", "lot3"] {
            prop_assert_eq!(of_lot(&before, lot), of_lot(&after, lot), "{}", files.main);
        }
    }
}

/// The plants and surfaces of a lot.
fn of_lot<'w>(written: &'w Written, lot: &str) -> Vec<&'w str> {
    let (mark, lines) = (format!("\"lot\":\"{lot}\""), written.plants.lines().chain(written.surfaces.lines()));
    lines.filter(|line| line.contains(&mark)).map(|line| line.trim_end_matches(',')).collect()
}

#[test]
fn most_programs_are_sound() {
    let mut random = Seed(5).draw("programs");
    let mut refused = Vec::new();
    for _ in 0..300 {
        let bytes: Vec<u8> = (0..400).map(|_| random.below(256) as u8).collect();
        let (files, layout, seed) = programs::of_bytes(&bytes);
        if let Verdict::Refused(told) = trial::tried(&files, &layout, seed) {
            refused.extend(told.into_iter().find(Diagnostic::is_error).map(|d| d.message));
        }
    }
    assert!(refused.len() < 60, "{} of 300 are refused: {refused:#?}", refused.len());
}
