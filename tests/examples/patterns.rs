//! The pattern library, `rules/patterns/`: every file stands alone, and the zones compose them.

use crate::planting::derive;
use bosquet::check::check;
use bosquet::world::{World, WorldError};
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// The project's own files, by their paths.
struct Project;

impl World for Project {
    fn source(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        std::fs::read(path).map(Arc::from).map_err(|_| WorldError::Missing(path.into()))
    }

    fn asset(&self, path: &str) -> Result<Arc<[u8]>, WorldError> {
        self.source(path)
    }
}

fn patterns() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("rules/patterns");
    let entries = std::fs::read_dir(folder).expect("the pattern library");
    let mut paths: Vec<PathBuf> = entries.map(|entry| entry.expect("an entry").path()).collect();
    paths.sort();
    paths
}

#[test]
fn patterns_have_neither_errors_nor_lints() {
    assert!(patterns().len() >= 15);
    for path in patterns() {
        let (_, found) = check(&Project, &path.to_string_lossy());
        assert!(found.is_empty(), "{}: {:?}", path.display(), found.iter().map(|d| &d.message).collect::<Vec<_>>());
    }
}

/// A lot of 60 × 40 m with a house, in each zone.
fn layout(zone: &str) -> String {
    format!(
        r#"{{"type": "FeatureCollection", "crs": "local", "features": [
        {{"type": "Feature", "properties": {{"id": "lot", "kind": "lot", "zone": "{zone}"}}, "geometry":
          {{"type": "Polygon", "coordinates": [[[0, 0], [60, 0], [60, 40], [0, 40], [0, 0]]]}}}},
        {{"type": "Feature", "properties": {{"id": "house", "kind": "building"}}, "geometry":
          {{"type": "Polygon", "coordinates": [[[24, 16], [36, 16], [36, 25], [24, 25], [24, 16]]]}}}}]}}"#
    )
}

#[test]
fn every_pattern_plants_a_lot() {
    for path in patterns() {
        let trees = plants("residential", &path);
        let alone = path.ends_with("single.cga");
        assert!(if alone { trees == 1 } else { trees > 1 }, "{}: {trees} plants", path.display());
    }
}

#[test]
fn industry_is_planted_more_sparsely_than_homes() {
    let zones = patterns().into_iter().find(|path| path.ends_with("zones.cga")).expect("the zones");
    let counts = ["residential", "commercial", "industrial", "street", "other"].map(|zone| plants(zone, &zones));
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    assert!(counts[0] > 2 * counts[2] && counts[4] > 2 * counts[2], "{counts:?}");
}

/// How many plants a rule file gives the lot of a zone.
fn plants(zone: &str, rules: &Path) -> usize {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("lot.geojson");
    std::fs::write(&file, layout(zone)).expect("a layout");
    let rules = format!("--rules={}", rules.display());
    let ran = derive(&file, &[&rules, "--allow-outside", "plants:plants.csv"]);
    assert_eq!(ran.complaints(), Vec::<&str>::new(), "{rules}");
    let written = std::fs::read_to_string(ran.file("plants.csv")).expect("the plants");
    written.lines().count() - 1
}
