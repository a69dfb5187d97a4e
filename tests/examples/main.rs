//! What the places under `examples/` promise: each derives without an error, and each figure shows what the paper says
//! about it, measured on the plants that the command writes.

mod figures;
mod park;
mod patterns;
mod planting;
mod tasks;

use planting::derive;
use std::path::{Path, PathBuf};

#[test]
fn every_place_derives_without_complaint() {
    let manifests = manifests();
    assert!(manifests.len() > 8, "{manifests:?}");
    for manifest in manifests {
        let ran = derive(&manifest, &["report.json"]);
        let complaints = ran.complaints();
        assert!(complaints.is_empty(), "{}: {complaints:?}", manifest.display());
    }
}

/// Every manifest of every place.
fn manifests() -> Vec<PathBuf> {
    let examples = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples");
    let inside = |folder: &Path| {
        let entries = std::fs::read_dir(folder).expect("a folder that can be read");
        entries.map(|entry| entry.expect("an entry").path()).collect::<Vec<PathBuf>>()
    };
    let folders = inside(&examples).into_iter().filter(|path| path.is_dir());
    let mut found: Vec<PathBuf> = folders.flat_map(|folder| inside(&folder)).collect();
    found.retain(|path| path.extension().is_some_and(|ending| ending == "toml"));
    found.sort();
    found
}
