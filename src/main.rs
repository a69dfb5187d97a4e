//! The command: see `bosquet --help`.

mod cli;

fn main() -> std::process::ExitCode {
    cli::main()
}
