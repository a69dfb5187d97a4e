//! What holds for any program and any layout: it is checked or refused with words, it ends within its limits, every
//! number that comes out is one, threads change nothing, and an edit in one lot leaves the others alone.

#[path = "common/place.rs"]
mod place;
#[path = "common/programs/mod.rs"]
mod programs;
#[path = "common/read.rs"]
mod read;
#[path = "common/trial.rs"]
mod trial;

use bosquet::check::check;
use bosquet::diag::Diagnostic;
use bosquet::seed::Seed;
use proptest::prelude::*;
use trial::Verdict;

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
        let (files, layout, seed) = trial::of_bytes(&bytes);
        read::rules(files.main.as_bytes());
        trial::tried(&files, &layout, seed);
    }

}

#[test]
fn most_programs_are_sound() {
    let mut random = Seed(5).draw("programs");
    let mut refused = Vec::new();
    for _ in 0..300 {
        let bytes: Vec<u8> = (0..400).map(|_| random.below(256) as u8).collect();
        let (files, layout, seed) = trial::of_bytes(&bytes);
        if let Verdict::Refused(told) = trial::tried(&files, &layout, seed) {
            refused.extend(told.into_iter().find(Diagnostic::is_error).map(|d| d.message));
        }
    }
    assert!(refused.len() < 100, "{} of 300 are refused: {refused:#?}", refused.len());
}
