//! Arguments, files, progress, colours: the only IO, the only stderr, the only exit codes.
//!
//! Exit codes: 0 done (lints alone count as done), 1 something is wrong with the input, 2 wrong usage, 130 stopped.

mod check;
mod derive;
mod diff;
mod differences;
mod disk;
mod explain;
mod explained;
mod fmt;
mod job;
mod limits;
mod lsp;
mod manual;
mod new;
mod ops;
mod outputs;
mod place;
mod points;
mod prepare;
mod progress;
mod show;
mod statistics;
mod stats;
mod tree;
mod walk;
mod watch;

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
    /// Say why something is there: the rules, choices and numbers that made it
    Explain(Box<explain::Arguments>),
    /// Say what two runs, plantings or reports have different
    Diff(Box<diff::Arguments>),
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
    /// The language server for editors, on standard input and output
    Lsp(LspArguments),
}

/// Editors say it; there is nothing else to choose.
#[derive(clap::Args)]
struct LspArguments {
    /// Talk on standard input and output, as it does anyway
    #[arg(long)]
    stdio: bool,
}

/// How a command ended.
enum Ended {
    Well,
    /// The input is wrong; what is wrong has been said.
    Wrong,
    /// What was compared differs.
    Different,
    /// The input is wrong, where 1 means something else; what is wrong has been said.
    Trouble,
    /// The arguments are wrong.
    Usage(String),
    /// Ctrl-C.
    Stopped,
}

/// Runs the command of this process.
pub fn main() -> ExitCode {
    let ended = match Arguments::parse().command {
        Command::Derive(arguments) => derive::run(&arguments),
        Command::Explain(arguments) => explain::run(&arguments),
        Command::Diff(arguments) => diff::run(&arguments),
        Command::Check(arguments) => check::run(&arguments),
        Command::Fmt(arguments) => fmt::run(&arguments),
        Command::Ops(arguments) => ops::run(&arguments),
        Command::Manual(arguments) => manual::run(&arguments),
        Command::New(arguments) => new::run(&arguments),
        Command::Stats(arguments) => stats::run(&arguments),
        Command::Lsp(LspArguments { stdio: _ }) => lsp::run(),
    };
    match ended {
        Ended::Well => ExitCode::SUCCESS,
        Ended::Wrong | Ended::Different => ExitCode::from(1),
        Ended::Trouble => ExitCode::from(2),
        Ended::Usage(message) => {
            show::tell(format_args!("error: {message}"));
            ExitCode::from(2)
        }
        Ended::Stopped => ExitCode::from(130),
    }
}
