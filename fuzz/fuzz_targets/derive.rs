//! Bytes as a program on an odd layout: formatted, checked, derived, drawn and written, on one thread and on two.

#![no_main]

#[path = "../../tests/common/place.rs"]
mod place;
#[path = "../../tests/common/programs/mod.rs"]
mod programs;
#[path = "../../tests/common/read.rs"]
mod read;
#[path = "../../tests/common/told.rs"]
mod told;
#[path = "../../tests/common/trial.rs"]
mod trial;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (files, layout, seed) = programs::of_bytes(bytes);
    if std::env::var_os("SHOW").is_some() {
        println!("// --- crash trial ---\n{}\n// File: second.cga\n{}", files.main, files.second);
    }
    read::rules(files.main.as_bytes());
    trial::tried(&files, &layout, seed);
});
