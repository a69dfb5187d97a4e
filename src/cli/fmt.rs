//! `bosquet fmt`: rule files laid out evenly, in place, or checked for it.

use crate::cli::disk::{Disk, write_all};
use crate::cli::walk::{is_rules, walk};
use crate::cli::{Ended, limits::STACK, show};
use bosquet::syntax::{Source, format};
use bosquet::text::counted;
use std::io::Read;
use std::path::{Path, PathBuf};

/// Arguments of `bosquet fmt`.
#[derive(clap::Args)]
pub struct Arguments {
    /// Rule files, folders whose rule files are meant, or `-` for standard input to standard output
    #[arg(required = true, value_name = "FILE.cga")]
    files: Vec<PathBuf>,
    /// Change nothing; name the files that are not laid out evenly and end with 1 if there are any
    #[arg(long)]
    check: bool,
    /// Bytes of one file that is read
    #[arg(long, value_name = "BYTES", default_value_t = 1 << 30)]
    limit_file: u64,
}

/// Formats every file, with as much stack as a derivation has.
pub fn run(arguments: &Arguments) -> Ended {
    std::thread::scope(|scope| {
        let thread = std::thread::Builder::new().stack_size(STACK).spawn_scoped(scope, || format_all(arguments));
        match thread.map(std::thread::ScopedJoinHandle::join) {
            Ok(Ok(ended)) => ended,
            Ok(Err(panic)) => std::panic::resume_unwind(panic),
            Err(error) => Ended::Usage(format!("the worker thread cannot be started: {error}")),
        }
    })
}

fn format_all(arguments: &Arguments) -> Ended {
    let mut files = Vec::new();
    for path in &arguments.files {
        if let Err(error) = gather(path, &mut files) {
            return Ended::Usage(format!("`{}` cannot be read: {error}", path.display()));
        }
    }
    let (mut changed, mut failed) = (0, false);
    for file in &files {
        match one(arguments, file) {
            Ok(has_changed) => changed += usize::from(has_changed),
            Err(()) => failed = true,
        }
    }
    if !files.iter().all(|file| is_stream(file)) {
        let what = if arguments.check { "not laid out evenly" } else { "laid out anew" };
        show::tell(format_args!("{} of {} {what}", changed, counted(files.len(), "file")));
    }
    if failed || arguments.check && changed > 0 { Ended::Wrong } else { Ended::Well }
}

/// The rule files below a folder, in order of their names, or the path itself.
fn gather(path: &Path, files: &mut Vec<PathBuf>) -> std::io::Result<()> {
    if is_stream(path) || !std::fs::metadata(path)?.is_dir() {
        files.push(path.to_owned());
        return Ok(());
    }
    walk(path, usize::MAX, &mut |file| {
        // Links may lead out of what was meant.
        files.extend(Some(file?).filter(|file| is_rules(file) && !file.is_symlink()));
        Ok(())
    })
}

/// Formats a file; tells whether that changes it. What is wrong with it has been said.
fn one(arguments: &Arguments, path: &Path) -> Result<bool, ()> {
    let name = if is_stream(path) { "standard input".to_owned() } else { path.display().to_string() };
    let bytes = read(arguments, path).map_err(|message| show::tell(format_args!("error: {message}")))?;
    let source = Source::new(&name, &bytes);
    let text = match format(0, &source) {
        Ok(text) => text,
        Err(reports) => {
            show::diagnostics(&reports, std::slice::from_ref(&source));
            show::tell(format_args!("`{name}` is left as it is\n"));
            return Err(());
        }
    };
    let has_changed = text != source.text();
    match (arguments.check, is_stream(path)) {
        (true, _) if has_changed => show::print(format_args!("{name}\n")),
        (true, _) => {}
        (false, true) => show::print(&text),
        (false, false) if has_changed => replace(path, source.encoded(&text))?,
        (false, false) => {}
    }
    Ok(has_changed)
}

fn read(arguments: &Arguments, path: &Path) -> Result<Vec<u8>, String> {
    if !is_stream(path) {
        let read = Disk::new(arguments.limit_file).named(&path.display().to_string());
        return read.map(|bytes| bytes.to_vec()).map_err(|error| error.to_string());
    }
    let (mut bytes, limit) = (Vec::new(), arguments.limit_file);
    let read = std::io::stdin().take(limit.saturating_add(1)).read_to_end(&mut bytes);
    match read {
        Ok(_) if bytes.len() as u64 > limit => Err(format!("standard input has more than {limit} bytes")),
        Ok(_) => Ok(bytes),
        Err(error) => Err(format!("standard input cannot be read: {error}")),
    }
}

/// Puts new bytes in the place of a file, whole or not at all; of what a link leads to, if it is one.
fn replace(path: &Path, bytes: Vec<u8>) -> Result<(), ()> {
    let place = path.canonicalize().unwrap_or(path.to_owned());
    write_all(&[(place, bytes)]).map(drop).map_err(|message| show::tell(format_args!("error: {message}")))
}

fn is_stream(path: &Path) -> bool {
    path.as_os_str() == "-"
}
