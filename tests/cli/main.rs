//! The command as users run it: the built binary on files in a folder of its own.
//!
//! Every run goes through [`bench::Bench`], which fails on a panic, whatever the test asks for.

mod bench;
mod check;
mod coverage;
mod derive;
mod diff;
mod errors;
mod explain;
mod fmt;
mod hostile;
mod layouts;
mod limits;
mod manual;
mod models;
mod outputs;
mod sandbox;
mod stats;
mod tree;
mod versailles;
mod watch;
