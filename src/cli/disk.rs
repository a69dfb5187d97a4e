//! The world on disk: reads below one folder, up to a size; and files written whole or not at all.

use bosquet::world::{World, WorldError};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Files below a folder.
pub struct Disk {
    root: Option<PathBuf>,
    most_bytes: u64,
}

impl Disk {
    /// What lies below `root`; everything where `outside` is allowed. Paths are as the user would write them here.
    pub fn new(root: &Path, outside: bool, most_bytes: u64) -> Disk {
        let root = if root.as_os_str().is_empty() { Path::new(".") } else { root };
        Disk { root: (!outside).then(|| root.canonicalize().unwrap_or_else(|_| root.into())), most_bytes }
    }

    fn read(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        let real = Path::new(path).canonicalize().map_err(|error| unreadable(path, &error))?;
        if self.root.as_ref().is_some_and(|root| !real.starts_with(root)) {
            return Err(WorldError::Outside(path.into()));
        }
        read_file(path, self.most_bytes).map(Into::into)
    }
}

impl World for Disk {
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.read(path)
    }

    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.read(path)
    }
}

/// A file that the user named, wherever it lies.
pub fn read_file(path: &str, most_bytes: u64) -> Result<Vec<u8>, WorldError> {
    let data = std::fs::metadata(path).map_err(|error| unreadable(path, &error))?;
    if data.len() > most_bytes {
        return Err(WorldError::TooLarge { path: path.into(), bytes: data.len(), limit: most_bytes });
    }
    std::fs::read(path).map_err(|error| unreadable(path, &error))
}

fn unreadable(path: &str, error: &std::io::Error) -> WorldError {
    match error.kind() {
        std::io::ErrorKind::NotFound => WorldError::Missing(path.into()),
        _ => WorldError::Unreadable { path: path.into(), reason: error.to_string() },
    }
}

/// Writes all files, each beside its place first and then renamed into it: a failure leaves no half file.
pub fn write_all(files: &[(PathBuf, Vec<u8>)]) -> Result<(), String> {
    let mut beside: Vec<(PathBuf, &PathBuf)> = Vec::new();
    let written = files.iter().try_for_each(|(path, bytes)| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let temporary = path.with_file_name(format!(".{name}.{}.part", std::process::id()));
        let failed = |error: std::io::Error| format!("`{}` cannot be written: {error}", path.display());
        let mut file = std::fs::File::create(&temporary).map_err(failed)?;
        beside.push((temporary, path));
        file.write_all(bytes).and_then(|()| file.sync_all()).map_err(failed)
    });
    let renamed = written.and_then(|()| {
        beside.iter().try_for_each(|(from, to)| {
            std::fs::rename(from, to).map_err(|error| format!("`{}` cannot be written: {error}", to.display()))
        })
    });
    if renamed.is_err() {
        beside.iter().for_each(|(path, _)| drop(std::fs::remove_file(path)));
    }
    renamed
}
