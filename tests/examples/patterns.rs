//! The pattern library, `rules/`: it is built in whole, every pattern stands alone, and the zones compose them.

use crate::planting::derive;
use bosquet::check::check;
use bosquet::library::{FILES, PREFIX};
use bosquet::world::MemoryWorld;
use std::path::Path;

fn patterns() -> impl Iterator<Item = String> {
    let paths = FILES.iter().map(|(path, _)| path);
    paths.filter(|path| path.starts_with("patterns/")).map(|path| format!("{PREFIX}{path}"))
}

#[test]
fn the_library_is_built_in_whole() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("rules");
    let inside = |folder: &str| {
        let entries = std::fs::read_dir(root.join(folder)).expect("a folder of the library");
        let name = |entry: std::fs::DirEntry| entry.file_name().to_string_lossy().into_owned();
        entries.map(|entry| format!("{folder}/{}", name(entry.expect("an entry")))).collect::<Vec<String>>()
    };
    let mut files = [inside("palettes"), inside("patterns")].concat();
    files.sort();
    assert_eq!(files, FILES.iter().map(|(path, _)| *path).collect::<Vec<&str>>());
}

#[test]
fn patterns_have_neither_errors_nor_lints() {
    for path in patterns() {
        let (_, found) = check(&MemoryWorld::default(), &path);
        assert!(found.is_empty(), "{path}: {:?}", found.iter().map(|d| &d.message).collect::<Vec<_>>());
    }
}

#[test]
fn a_name_that_the_library_lacks_is_answered_with_those_it_has() {
    let world = MemoryWorld::default().with("a.cga", "import a : \"bosquet:patterns/clusters.cga\"\n");
    let (_, found) = check(&world, "a.cga");
    let hints: Vec<&str> = found.iter().flat_map(|diagnostic| &diagnostic.hints).map(|hint| &**hint).collect();
    assert!(hints.iter().any(|hint| hint.contains("`cluster.cga`")), "{found:?}");
}

/// A lot of 90 × 40 m with a house in its corner, in each zone.
fn layout(zone: &str) -> String {
    format!(
        r#"{{"type": "FeatureCollection", "crs": "local", "features": [
        {{"type": "Feature", "properties": {{"id": "lot", "kind": "lot", "zone": "{zone}"}}, "geometry":
          {{"type": "Polygon", "coordinates": [[[0, 0], [90, 0], [90, 40], [0, 40], [0, 0]]]}}}},
        {{"type": "Feature", "properties": {{"id": "house", "kind": "building"}}, "geometry":
          {{"type": "Polygon", "coordinates": [[[2, 28], [12, 28], [12, 38], [2, 38], [2, 28]]]}}}}]}}"#
    )
}

#[test]
fn every_pattern_plants_a_lot() {
    for path in patterns() {
        let trees = plants("residential", &path);
        let alone = path.ends_with("single.cga");
        assert!(trees == 1 || (trees > 1 && !alone), "{path}: {trees} plants");
    }
}

#[test]
fn industry_is_planted_more_sparsely_than_homes() {
    let zones = ["residential", "commercial", "industrial", "street", "other"];
    let counts = zones.map(|zone| plants(zone, "bosquet:patterns/zones.cga"));
    assert!(counts.iter().all(|count| *count > 0), "{counts:?}");
    assert!(counts[0] > 2 * counts[2] && counts[4] > 2 * counts[2], "{counts:?}");
}

/// How many plants a rule file gives the lot of a zone.
fn plants(zone: &str, rules: &str) -> usize {
    let folder = tempfile::tempdir().expect("a folder");
    let file = folder.path().join("lot.geojson");
    std::fs::write(&file, layout(zone)).expect("a layout");
    let ran = derive(&file, &[&format!("--rules={rules}"), "plants:plants.csv"]);
    assert_eq!(ran.complaints(), Vec::<&str>::new(), "{rules}");
    let written = std::fs::read_to_string(ran.file("plants.csv")).expect("the plants");
    written.lines().count() - 1
}
