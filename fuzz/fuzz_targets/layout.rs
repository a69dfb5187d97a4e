//! Bytes as a layout: read, and a garden on it that asks for streets, buildings and neighbours.

#![no_main]

#[path = "../../tests/common/told.rs"]
mod told;
#[path = "../../tests/common/trial.rs"]
mod trial;

use bosquet::check::{Program, check};
use bosquet::diag::Diagnostic;
use bosquet::layout::read_geojson;
use bosquet::seed::Seed;
use bosquet::world::MemoryWorld;
use std::sync::LazyLock;
use told::is_told_well;
use trial::run;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| laid_out(bytes));

/// A garden for every kind of region, which asks for streets, buildings and neighbours.
const GARDEN: &str = r#"
attr density = 0.02
@StartRule
Any --> without("building", 0.5) setback(1) { street.front : Hedge | front = Path | remainder : Rest }
Hedge --> extrude(1.5) comp(f) { top : Box. | side : Yew. }
Path --> splitArea(x) { 5 : Gravel. | ~1 : Stone. }
Rest --> case inside("park") : Lawn. else : split(x) { ~6 : Bed }*
Bed --> scatter(surface, density * geometry.area, uniform) { Tree } innerRectangle(scope) { shape : Lawn. | remainder : Meadow. }
Tree --> case overlaps(intra) : NIL else : plant("birch")
"#;

/// Reads bytes as a layout and makes a garden of it.
fn laid_out(bytes: &[u8]) {
    static PROGRAM: LazyLock<Program> = LazyLock::new(|| {
        let (program, told) = check(&MemoryWorld::default().with("main.cga", GARDEN), "main.cga");
        assert!(!told.iter().any(Diagnostic::is_error), "{told:?}");
        program
    });
    let (layout, told) = read_geojson("layout.geojson", bytes);
    told.iter().for_each(is_told_well);
    assert!(!layout.regions.is_empty() || !layout.features.is_empty() || !told.is_empty(), "nothing and nothing said");
    run(&PROGRAM, &layout, Seed(3), &MemoryWorld::default());
}
