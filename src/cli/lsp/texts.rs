//! The world of an editor: open buffers over the disk, and the two names that a file has, path and URI.
//!
//! Files of the library have no path on the disk; they are written into the user's cache when an editor first has to show
//! one, and read from there never.

use crate::cli::disk::Disk;
use crate::cli::lsp::uri;
use crate::cli::walk::{is_rules, walk};
use bosquet::library;
use bosquet::world::{World, WorldError};
use lsp_types::Uri;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Bytes of one file that is read.
const MOST_BYTES: u64 = 64 << 20;
/// Rule files that are looked for in the folders of a workspace, and how deep.
const MOST_FILES: usize = 5_000;
const DEEPEST_FOLDER: usize = 12;

/// Open buffers and the folders that were opened.
pub struct Texts {
    disk: Disk,
    /// Folders that may be read.
    open_folders: BTreeSet<PathBuf>,
    /// Folders of the workspace.
    workspace: Vec<PathBuf>,
    /// Open buffers by path.
    buffers: BTreeMap<String, Buffer>,
    /// Rule files of the workspace and beside open buffers.
    found: BTreeSet<String>,
}

struct Buffer {
    uri: Uri,
    text: String,
}

impl Texts {
    /// The folders of a workspace; more are read beside the files that are opened.
    pub fn new(workspace: Vec<PathBuf>) -> Texts {
        let open_folders = workspace.iter().cloned().collect();
        let mut texts = Texts {
            disk: Disk::new(MOST_BYTES),
            open_folders,
            workspace,
            buffers: BTreeMap::new(),
            found: BTreeSet::new(),
        };
        texts.reopen();
        texts
    }

    /// Reads a further folder.
    pub fn open_folder(&mut self, folder: &Path) {
        if self.open_folders.insert(folder.to_path_buf()) {
            self.reopen();
        }
    }

    fn reopen(&mut self) {
        self.disk = self.open_folders.iter().fold(Disk::new(MOST_BYTES), |disk, folder| disk.open(folder));
        self.look_for_files();
    }

    /// Looks again which rule files there are.
    pub fn look_for_files(&mut self) {
        let mut found = BTreeSet::new();
        for folder in &self.workspace {
            rule_files(folder, DEEPEST_FOLDER, &mut found);
        }
        for folder in &self.open_folders {
            rule_files(folder, 0, &mut found);
        }
        self.found = found;
    }

    /// The folders of the workspace.
    pub fn workspace(&self) -> &[PathBuf] {
        &self.workspace
    }

    /// The rule files there are, open ones among them.
    pub fn files(&self) -> Vec<String> {
        self.found.iter().chain(self.buffers.keys()).cloned().collect::<BTreeSet<_>>().into_iter().collect()
    }

    /// The paths of the open buffers.
    pub fn open_paths(&self) -> Vec<String> {
        self.buffers.keys().cloned().collect()
    }

    /// Takes over a text from the disk, or a newer one.
    pub fn put(&mut self, uri: &Uri, text: String) {
        let path = uri::path(uri);
        if let Some(folder) = Path::new(&path).parent().filter(|_| uri::is_file(uri)) {
            self.open_folder(folder);
        }
        self.buffers.insert(path, Buffer { uri: uri.clone(), text });
    }

    /// An open text, to be changed.
    pub fn buffer(&mut self, uri: &Uri) -> Option<&mut String> {
        self.buffers.get_mut(&uri::path(uri)).map(|buffer| &mut buffer.text)
    }

    /// Gives a text back to the disk.
    pub fn close(&mut self, uri: &Uri) {
        self.buffers.remove(&uri::path(uri));
    }

    /// What the editor calls the file at a path; `None` where it cannot be shown.
    pub fn uri(&self, path: &str) -> Option<Uri> {
        match self.buffers.get(path) {
            Some(buffer) => Some(buffer.uri.clone()),
            None => uri::of(path),
        }
    }
}

impl World for Texts {
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        match self.buffers.get(path) {
            Some(buffer) => Ok(buffer.text.as_bytes().into()),
            None => self.disk.source(path),
        }
    }

    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.disk.asset(path)
    }

    fn exists(&self, path: &str) -> bool {
        self.buffers.contains_key(path) || self.disk.exists(path)
    }

    fn list(&self, folder: &str) -> Result<Vec<String>, WorldError> {
        self.disk.list(folder)
    }
}

/// The rule files below a folder; what cannot be read is passed over.
fn rule_files(folder: &Path, deepest: usize, found: &mut BTreeSet<String>) {
    // The one error is that there are enough.
    drop(walk(folder, deepest, &mut |path| {
        let rules = path.ok().filter(|path| is_rules(path));
        found.extend(rules.map(|path| path.to_string_lossy().replace('\\', "/")));
        if found.len() < MOST_FILES { Ok(()) } else { Err(std::io::Error::other("there are enough")) }
    }));
}

/// Where the library is shown to editors: a folder in the user's cache that has its files, as this version has them.
pub fn shelf() -> Option<PathBuf> {
    let home = || std::env::var_os("HOME").map(|home| Path::new(&home).join(".cache"));
    let cache = std::env::var_os("XDG_CACHE_HOME").map(PathBuf::from).filter(|path| path.is_absolute());
    let cache = cache.or_else(home).or_else(|| std::env::var_os("LOCALAPPDATA").map(PathBuf::from))?;
    Some(cache.join("bosquet").join(format!("library-{}", env!("CARGO_PKG_VERSION"))))
}

/// The file of the shelf with a text of the library, written where it is not there or differs.
pub fn shelve(path: &str) -> Option<PathBuf> {
    let text = library::text(path)?;
    let file = shelf()?.join(path.strip_prefix(library::PREFIX)?);
    if std::fs::read(&file).ok().as_deref() != Some(text.as_bytes()) {
        std::fs::create_dir_all(file.parent()?).ok()?;
        crate::cli::disk::write_all(&[(file.clone(), text.as_bytes().to_vec())]).ok()?;
    }
    Some(file)
}
