//! The command: see `bosquet --help`.

mod cli;

/// Derivations make and drop millions of small buffers.
#[global_allocator]
static ALLOCATOR: mimalloc::MiMalloc = mimalloc::MiMalloc;

fn main() -> std::process::ExitCode {
    cli::main()
}
