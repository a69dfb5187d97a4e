//! Bytes as a layout: read, derived by a garden that looks around, drawn and written.

#![no_main]

#[path = "../../tests/common/laid_out.rs"]
mod laid_out;
#[path = "../../tests/common/told.rs"]
mod told;
#[path = "../../tests/common/trial.rs"]
mod trial;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| laid_out::laid_out(bytes));
