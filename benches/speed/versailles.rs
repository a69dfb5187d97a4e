//! The example `versailles`, with its park halved more often than the paper did.

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::layout::{Layout, read_geojson};
use bosquet::seed::Seed;
use bosquet::shape::Derivation;
use bosquet::value::Value;
use bosquet::world::MemoryWorld;
use std::path::Path;

const FOLDER: &str = "examples/versailles";

/// The park with its rules.
pub struct Park {
    program: Program,
    layout: Layout,
    world: MemoryWorld,
    recursions: f64,
}

impl Park {
    /// Halved so often.
    pub fn with_recursions(recursions: u32) -> Park {
        let file = |name: &str| std::fs::read(Path::new(env!("CARGO_MANIFEST_DIR")).join(FOLDER).join(name));
        let read = |name: &str| file(name).unwrap_or_else(|error| panic!("{FOLDER}/{name}: {error}"));
        let rules = ["versailles.cga", "parterre.cga", "bosquet.cga"];
        let world = rules.iter().fold(MemoryWorld::default(), |world, name| world.with(*name, read(name)));
        let (program, found) = check(&world, "versailles.cga");
        assert!(!found.iter().any(|d| d.is_error()), "{found:?}");
        let (layout, found) = read_geojson("versailles.geojson", &read("versailles.geojson"));
        assert!(!found.iter().any(|d| d.is_error()), "{found:?}");
        Park { program, layout, world, recursions: f64::from(recursions) }
    }

    /// All regions.
    pub fn derive(&self) -> Derivation {
        let slot = self.program.slot("recursions").expect("an attribute of the example");
        let options = Options {
            start: None,
            seed: Seed(1682),
            set: vec![(slot, Value::Float(self.recursions))],
            catalogue: Catalogue::built_in(),
            world: &self.world,
            limits: Limits::default(),
        };
        let (derivation, found) = derive(&self.program, &self.layout, &options, &Progress::default());
        assert!(!found.iter().any(|d| d.is_error()), "{:?}", found.first());
        derivation
    }
}
