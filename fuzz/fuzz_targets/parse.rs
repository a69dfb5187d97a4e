//! Bytes as a rule file: read, checked, formatted.

#![no_main]

#[path = "../../tests/common/read.rs"]
mod read;
#[path = "../../tests/common/told.rs"]
mod told;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| read::rules(bytes));
