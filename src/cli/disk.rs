//! The world on disk: reads below the folders it was opened for, up to a size, and keeps in mind what was read; and
//! files written whole or not at all.

use crate::cli::walk::walk;
use bosquet::world::{World, WorldError};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};

/// Files below some folders. Paths are as the user would write them here.
pub struct Disk {
    folders: Vec<PathBuf>,
    is_open: bool,
    most_bytes: u64,
    /// The hash of every file that was read, and of every listing; folders end in `/`.
    hashes: Mutex<BTreeMap<String, String>>,
    /// Every file and folder that was asked for, there or not.
    asked: Mutex<BTreeSet<String>>,
}

impl Disk {
    /// No folder yet; files up to a size.
    pub fn new(most_bytes: u64) -> Disk {
        Disk { folders: Vec::new(), is_open: false, most_bytes, hashes: Mutex::default(), asked: Mutex::default() }
    }

    /// The same with what lies below one more folder; the empty path is the working directory.
    pub fn open(mut self, folder: &Path) -> Disk {
        let folder = if folder.as_os_str().is_empty() { Path::new(".") } else { folder };
        self.folders.extend(folder.canonicalize());
        self
    }

    /// The same with everything there is.
    pub fn open_all(self) -> Disk {
        Disk { is_open: true, ..self }
    }

    /// A file that the user named, wherever it lies.
    pub fn named(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).insert(path.into());
        let data = std::fs::metadata(path).map_err(|error| unreadable(path, &error))?;
        if data.len() > self.most_bytes {
            return Err(WorldError::TooLarge { path: path.into(), bytes: data.len(), limit: self.most_bytes });
        }
        let bytes: Arc<[u8]> = std::fs::read(path).map_err(|error| unreadable(path, &error))?.into();
        let hash = hash(&bytes);
        self.hashes.lock().unwrap_or_else(PoisonError::into_inner).insert(path.into(), hash);
        Ok(bytes)
    }

    /// Every file that was read and every folder that was listed so far with its BLAKE3 hash in hexadecimal, by path.
    pub fn inputs(&self) -> Vec<(String, String)> {
        self.hashes.lock().unwrap_or_else(PoisonError::into_inner).clone().into_iter().collect()
    }

    /// Every file and folder that was asked for so far, with the hash of what was read; none where it could not be.
    pub fn asked(&self) -> BTreeMap<String, Option<String>> {
        let hashes = self.hashes.lock().unwrap_or_else(PoisonError::into_inner);
        let asked = self.asked.lock().unwrap_or_else(PoisonError::into_inner);
        asked.iter().map(|path| (path.clone(), hashes.get(path).cloned())).collect()
    }

    fn read(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).insert(path.into());
        let real = Path::new(path).canonicalize().map_err(|error| unreadable(path, &error))?;
        if self.shows(&real) { self.named(path) } else { Err(WorldError::Outside(path.into())) }
    }

    /// Whether a path without links lies below one of the folders.
    fn shows(&self, real: &Path) -> bool {
        self.is_open || self.folders.iter().any(|folder| real.starts_with(folder))
    }
}

impl World for Disk {
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.read(path)
    }

    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.read(path)
    }

    fn exists(&self, path: &str) -> bool {
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).insert(path.into());
        Path::new(path).canonicalize().is_ok_and(|real| real.is_file() && self.shows(&real))
    }

    fn list(&self, folder: &str) -> Result<Vec<String>, WorldError> {
        let place = if folder.is_empty() { "./" } else { folder };
        let real = Path::new(place).canonicalize();
        // What lies outside stays there, and need not be kept in mind.
        if real.as_ref().is_ok_and(|real| !self.shows(real)) {
            return Err(WorldError::Outside(place.into()));
        }
        self.asked.lock().unwrap_or_else(PoisonError::into_inner).insert(place.into());
        let real = real.map_err(|error| unreadable(place, &error))?;
        let files = below(&real, folder).map_err(|error| unreadable(place, &error))?;
        self.hashes.lock().unwrap_or_else(PoisonError::into_inner).insert(place.into(), listing_hash(&files));
        Ok(files)
    }
}

/// Files of one listing: a folder with more is probably not the place's.
const MOST_LISTED: usize = 200_000;

/// The files below a folder, sorted, under a prefix. Those with names that are no text cannot be asked for.
fn below(folder: &Path, prefix: &str) -> std::io::Result<Vec<String>> {
    let mut files = Vec::new();
    walk(folder, usize::MAX, &mut |path| {
        if files.len() >= MOST_LISTED {
            return Err(std::io::Error::other(format!("there are more than {MOST_LISTED} files below it")));
        }
        let path = path?;
        let parts = path.strip_prefix(folder).unwrap_or(&path).iter().map(std::ffi::OsStr::to_str);
        files.extend(parts.collect::<Option<Vec<_>>>().map(|parts| format!("{prefix}{}", parts.join("/"))));
        Ok(())
    })?;
    files.sort_unstable();
    Ok(files)
}

/// The hash of a listing: it changes as files come and go.
fn listing_hash(files: &[String]) -> String {
    hash(files.join("\n").as_bytes())
}

/// Whether a path that was asked for is a folder's, which was listed.
pub fn is_listing(path: &str) -> bool {
    path.ends_with('/')
}

/// The hash of a file or listing as it is now; none where it cannot be read.
pub fn hash_now(path: &str) -> Option<String> {
    if !is_listing(path) {
        return std::fs::read(path).ok().map(|bytes| hash(&bytes));
    }
    let prefix = if path == "./" { "" } else { path };
    let files = below(&Path::new(path).canonicalize().ok()?, prefix).ok()?;
    Some(listing_hash(&files))
}

/// The BLAKE3 hash in hexadecimal.
pub fn hash(bytes: &[u8]) -> String {
    blake3::hash(bytes).to_hex().to_string()
}

fn unreadable(path: &str, error: &std::io::Error) -> WorldError {
    match error.kind() {
        std::io::ErrorKind::NotFound => WorldError::Missing(path.into()),
        _ => WorldError::Unreadable { path: path.into(), reason: error.to_string() },
    }
}

/// Writes those of the files that differ from what lies in their place, as [`write_all`] does.
pub fn write_changed(files: &[(PathBuf, Vec<u8>)]) -> Result<Vec<usize>, String> {
    let is_new = |(path, bytes): &(PathBuf, Vec<u8>)| std::fs::read(path).map_or(true, |old| old != *bytes);
    let changed: Vec<usize> = (0..files.len()).filter(|index| is_new(&files[*index])).collect();
    write_some(&changed.iter().map(|index| &files[*index]).collect::<Vec<_>>()).map(|()| changed)
}

/// Writes all files, each beside its place first and then renamed into it: a failure leaves no half file. Gives the
/// indices of what it wrote.
pub fn write_all(files: &[(PathBuf, Vec<u8>)]) -> Result<Vec<usize>, String> {
    write_some(&files.iter().collect::<Vec<_>>()).map(|()| (0..files.len()).collect())
}

fn write_some(files: &[&(PathBuf, Vec<u8>)]) -> Result<(), String> {
    let mut beside: Vec<(PathBuf, &PathBuf)> = Vec::new();
    let written = files.iter().try_for_each(|&(path, bytes)| {
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
