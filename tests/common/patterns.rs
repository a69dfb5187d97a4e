//! The pattern library as rules of a test can import it, and what they plant.

use bosquet::check::check;
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::layout::Layout;
use bosquet::scene::{Plant, resolve};
use bosquet::seed::Seed;
use bosquet::world::MemoryWorld;
use std::path::Path;

/// The folder `rules/` with one more file, `main.cga`.
pub fn world(main: &str) -> MemoryWorld {
    let mut world = MemoryWorld::default().with("main.cga", main);
    for folder in ["patterns", "palettes"] {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("rules").join(folder);
        for entry in std::fs::read_dir(path).expect("the folder of patterns") {
            let path = entry.expect("a readable folder").path();
            let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
            world = world.with(format!("{folder}/{name}"), std::fs::read(&path).expect("a file of rules"));
        }
    }
    world
}

/// What the rules of a file plant in a layout; no error and no warning of theirs is accepted.
pub fn plants(world: &MemoryWorld, file: &str, layout: &Layout, seed: Seed) -> Vec<Plant> {
    let (program, found) = check(world, file);
    assert!(found.is_empty(), "{found:?}");
    let catalogue = Catalogue::built_in();
    let options = Options { start: None, seed, set: Vec::new(), catalogue, world, limits: Limits::default() };
    let (derivation, found) = derive(&program, layout, &options, &Progress::default());
    assert!(!found.iter().any(|d| d.is_error()), "{:?}", found.iter().find(|d| d.is_error()));
    resolve(layout, &derivation, catalogue, "").0.plants
}
