//! Bytes as a layout: read, derived by a garden that looks around, drawn and written.

#![no_main]

#[path = "../../tests/common/place.rs"]
mod place;
#[path = "../../tests/common/programs/mod.rs"]
mod programs;
#[path = "../../tests/common/read.rs"]
mod read;
#[path = "../../tests/common/trial.rs"]
mod trial;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| trial::laid_out(bytes));
