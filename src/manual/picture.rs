//! Rules → their plan on a plain lot.

use crate::check::check;
use crate::derive::{Limits, Options, Progress, derive};
use crate::diag::Diagnostic;
use crate::element::Catalogue;
use crate::export::plan::{self, PlanOptions, PlanSize, Resolution};
use crate::layout::read_geojson;
use crate::scene;
use crate::seed::Seed;
use crate::world::MemoryWorld;

/// What is drawn on, and how.
pub struct Sheet<'a> {
    /// The layout, GeoJSON.
    pub layout: &'a str,
    /// Pixels, width and height.
    pub pixels: [u32; 2],
    /// Whether there is a legend.
    pub legend: bool,
}

/// A lot of 40 by 30 metres, the street to the south.
const LOT: &str = r#"{ "type": "Feature", "crs": "local", "id": "lot", "properties": { "kind": "lot" }, "geometry":
    { "type": "Polygon", "coordinates": [[[0, 0], [40, 0], [40, 30], [0, 30], [0, 0]]] } }"#;

impl Sheet<'_> {
    /// The plain lot, without a legend.
    pub fn small() -> Sheet<'static> {
        Sheet { layout: LOT, pixels: [720, 560], legend: false }
    }
}

/// The plan of what rules make of a layout, as PNG: it begins with their first rule without parameters.
///
/// The error is the first thing that is wrong with the rules, the layout or the derivation.
pub fn draw(rules: &str, sheet: &Sheet) -> Result<Vec<u8>, String> {
    let world = MemoryWorld::default().with("example.cga", rules);
    let (program, found) = check(&world, "example.cga");
    sound(&found)?;
    let first = program.rules.iter().find(|rule| rule.params == 0).ok_or("there is no rule to begin with")?;
    let start = program.start.map_or(first, |start| &program.rules[start as usize]);
    let (layout, found) = read_geojson("lot.geojson", sheet.layout.as_bytes());
    sound(&found)?;
    let options = Options {
        start: Some(program.symbols[start.symbol as usize].clone()),
        seed: Seed(1),
        set: Vec::new(),
        catalogue: Catalogue::built_in(),
        world: &world,
        limits: Limits::default(),
    };
    let (derivation, found) = derive(&program, &layout, &options, &Progress::default());
    sound(&found)?;
    let (scene, found) = scene::resolve(&layout, &derivation, options.catalogue, "");
    sound(&found)?;
    let [width, height] = sheet.pixels;
    let drawing = plan::draw(
        &scene,
        &PlanOptions {
            size: PlanSize::Pixels(width, height),
            names: false,
            legend: sheet.legend,
            ..PlanOptions::default()
        },
    );
    plan::png(&drawing, Resolution::Drawn).map_err(|error| error.to_string())
}

fn sound(found: &[Diagnostic]) -> Result<(), String> {
    found.iter().find(|d| d.is_error()).map_or(Ok(()), |error| Err(error.message.clone()))
}
