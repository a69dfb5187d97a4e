//! How long the command takes to its first byte.

use crate::{ROUNDS, median};
use std::io::Read;
use std::process::{Command, Stdio};
use std::time::Instant;

/// What is asked of it.
const ASKED: &[&[&str]] = &[&["--version"], &["ops"], &["check", "examples/square/square.cga"]];

/// Milliseconds from the call to the first byte, for each.
pub fn report() {
    for arguments in ASKED {
        let times: Vec<f64> = (0..ROUNDS * 3).map(|_| first_byte(arguments)).collect();
        println!("start       {:>11.1} ms         bosquet {}", median(times) * 1e3, arguments.join(" "));
    }
}

/// Seconds to the first byte, on either stream.
fn first_byte(arguments: &[&str]) -> f64 {
    let (mut reads, writes) = std::io::pipe().expect("a pipe");
    let begun = Instant::now();
    let mut command = Command::new(env!("CARGO_BIN_EXE_bosquet"));
    command.args(arguments).current_dir(env!("CARGO_MANIFEST_DIR")).stdin(Stdio::null());
    command.stdout(writes.try_clone().expect("a pipe")).stderr(writes);
    let mut child = command.spawn().expect("the command");
    drop(command);
    // The end of a silent run counts as its first byte.
    let _ = reads.read(&mut [0]).expect("a readable pipe");
    let seconds = begun.elapsed().as_secs_f64();
    let _ = reads.read_to_end(&mut Vec::new());
    child.wait().expect("an end");
    seconds
}
