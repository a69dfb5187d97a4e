//! `bosquet check`: rule files, for people and for machines.

use crate::cli::{Ended, disk::Disk, limits::STACK, show};
use bosquet::check::{Program, check_style};
use bosquet::diag::{Diagnostic, Place};
use bosquet::syntax::Source;
use serde_json::json;
use std::path::Path;

/// Arguments of `bosquet check`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Rule files
    #[arg(required = true, value_name = "FILE.cga")]
    files: Vec<String>,
    /// `text` for people, `json` for machines
    #[arg(long, value_enum, default_value = "text")]
    format: Format,
    /// Only this style of each file, instead of all
    #[arg(long, value_name = "NAME")]
    style: Option<String>,
    /// Imports may lead out of the folder of the rule file
    #[arg(long)]
    allow_outside: bool,
    /// Bytes of one file that is read
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 30)]
    limit_file: u64,
}

#[derive(Clone, Copy, PartialEq, clap::ValueEnum)]
enum Format {
    Text,
    Json,
}

/// Checks every file, with as much stack as a derivation has.
pub fn run(arguments: &Arguments) -> Ended {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || check(arguments));
        match thread.map(std::thread::ScopedJoinHandle::join) {
            Ok(Ok(ended)) => ended,
            Ok(Err(panic)) => std::panic::resume_unwind(panic),
            Err(error) => Ended::Usage(format!("the worker thread cannot be started: {error}")),
        }
    })
}

fn check(arguments: &Arguments) -> Ended {
    let mut records = Vec::new();
    let (mut errors, mut rules, mut found_any) = (false, 0, false);
    for file in &arguments.files {
        let folder = Path::new(file).parent().unwrap_or(Path::new("."));
        let world = Disk::new(arguments.limit_file).open(folder);
        let world = if arguments.allow_outside { world.open_all() } else { world };
        let (program, found) = checked(&world, file, arguments.style.as_deref());
        errors |= found.iter().any(Diagnostic::is_error);
        found_any |= !found.is_empty();
        rules += program.rules.len();
        match arguments.format {
            Format::Text => show::diagnostics(&found, &program.sources),
            Format::Json => records.extend(found.iter().map(|d| record(d, &program.sources, file))),
        }
    }
    if arguments.format == Format::Json {
        show::print(format_args!("{}\n", serde_json::to_string_pretty(&records).unwrap_or_default()));
    } else if !found_any {
        let files = bosquet::text::counted(arguments.files.len(), "file");
        show::tell(format_args!("{files}, {}: nothing to report", bosquet::text::counted(rules, "rule")));
    }
    if errors { Ended::Wrong } else { Ended::Well }
}

/// A file under one style, or under all of them.
fn checked(world: &Disk, file: &str, style: Option<&str>) -> (Program, Vec<Diagnostic>) {
    let (program, mut found) = check_style(world, file, style);
    let others = if style.is_none() { &program.styles[..] } else { &[] };
    for other in others {
        let more = check_style(world, file, Some(other)).1;
        found.extend(more.into_iter().filter(|diagnostic| !found.contains(diagnostic)).collect::<Vec<_>>());
    }
    (program, found)
}

/// Byte offsets into the original file, line and column from 1, the column in characters.
fn record(diagnostic: &Diagnostic, sources: &[Source], file: &str) -> serde_json::Value {
    let (path, start, end, line, column) = match (&diagnostic.place, show::source(diagnostic, sources)) {
        (Place::Rule(span), Some(source)) => {
            let (line, column) = source.line_column(span.start);
            (source.path(), source.original(span.start), source.original(span.end), line, column)
        }
        _ => (file, 0, 0, 1, 1),
    };
    json!({
        "severity": diagnostic.severity.word(),
        "code": diagnostic.code,
        "message": diagnostic.message,
        "file": path,
        "start": start,
        "end": end,
        "line": line,
        "column": column,
        "hints": diagnostic.hints,
    })
}
