//! Bytes as a program that checks, on an odd layout: derived, resolved, drawn and written, twice.

#![no_main]

#[path = "../../tests/common/place.rs"]
mod place;
#[path = "../../tests/common/programs/mod.rs"]
mod programs;
#[path = "../../tests/common/read.rs"]
mod read;
#[path = "../../tests/common/trial.rs"]
mod trial;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let (files, layout, seed) = trial::of_bytes(bytes);
    if std::env::var_os("SHOW").is_some() {
        println!("// second.cga\n{}\n// main.cga\n{}", files.second, files.main);
    }
    trial::tried(&files, &layout, seed);
});
