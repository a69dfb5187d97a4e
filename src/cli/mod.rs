//! Arguments, files, progress, colours: the only IO, the only stderr, the only exit codes.
//!
//! Exit codes: 0 done (lints alone count as done), 1 something is wrong with the input, 2 wrong usage, 130 stopped.

mod check;
mod derive;
mod disk;
mod fmt;
mod job;
mod limits;
mod manual;
mod new;
mod ops;
mod outputs;
mod place;
mod points;
mod progress;
mod show;
mod statistics;
mod stats;

use clap::{Parser, Subcommand};
use std::process::ExitCode;

/// Urban open spaces by rules.
#[derive(Parser)]
#[command(name = "bosquet", version, about, long_about = None)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Subcommand)]
enum Command {
    /// Derive a layout by rules and write plans, plants, surfaces, schedules, reports
    Derive(Box<job::Arguments>),
    /// Check rule files without deriving
    Check(check::Arguments),
    /// Lay rule files out evenly
    Fmt(fmt::Arguments),
    /// The manual: every operation, function, ground cover and element
    Ops(ops::Arguments),
    /// Write the manual: a page an operation, with a plan of its example
    Manual(manual::Arguments),
    /// Make a starter place that derives
    New(new::Arguments),
    /// Measure how plants stand, and how far two plantings are from each other
    Stats(Box<stats::Arguments>),
}

/// How a command ended.
enum Ended {
    Well,
    /// The input is wrong; what is wrong has been said.
    Wrong,
    /// The arguments are wrong.
    Usage(String),
    /// Ctrl-C.
    Stopped,
}

/// Runs the command of this process.
pub fn main() -> ExitCode {
    let ended = match Arguments::parse().command {
        Command::Derive(arguments) => derive::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Fmt(arguments) => fmt::run(&arguments),
        Command::Ops(arguments) => ops::run(&arguments),
        Command::Manual(arguments) => manual::run(&arguments),
        Command::New(arguments) => new::run(&arguments),
        Command::Stats(arguments) => stats::run(&arguments),
    };
    match ended {
        Ended::Well => ExitCode::SUCCESS,
        Ended::Wrong => ExitCode::from(1),
        Ended::Usage(message) => {
            show::tell(format_args!("error: {message}"));
            ExitCode::from(2)
        }
        Ended::Stopped => ExitCode::from(130),
    }
}
