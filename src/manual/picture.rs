//! Rules → their plan on a plain lot, or on a layout of the reader's.

use crate::check::check;
use crate::derive::{Limits, Options, Progress, derive};
use crate::diag::Diagnostic;
use crate::element::Catalogue;
use crate::export::plan::{self, PlanOptions, PlanSize};
use crate::geometry::Bounds;
use crate::layout::read_geojson;
use crate::scene;
use crate::seed::Seed;
use crate::world::MemoryWorld;
use glam::DVec2;

/// What is drawn on, and how.
pub struct Sheet<'a> {
    /// The layout, GeoJSON.
    pub layout: &'a str,
    /// Files that the rules may ask for, by path.
    pub files: &'a [(&'a str, &'a str)],
    /// Whether every region begins with the first rule without parameters, whatever it is called; else with the rule
    /// for its kind.
    pub first_rule: bool,
    /// Pixels, width and height.
    pub pixels: [u32; 2],
    /// Metres of plan per metre of paper, at 110 dots to the inch; `None` takes the roundest that fits.
    pub scale: Option<f64>,
    /// The part to show, metres; `None` shows all.
    pub extent: Option<[f64; 4]>,
    /// How many colours the picture has at most: files of few are small.
    pub colours: usize,
    /// Whether there is a legend.
    pub legend: bool,
}

/// A lot of 40 by 30 metres, the street to the south.
const LOT: &str = r#"{ "type": "Feature", "crs": "local", "id": "lot",
    "properties": { "kind": "lot", "side": ["street", "garden", "garden", "garden"] }, "geometry":
    { "type": "Polygon", "coordinates": [[[0, 0], [40, 0], [40, 30], [0, 30], [0, 0]]] } }"#;

/// A wood drawn by hand, for examples that ask for a map.
const WOOD: &str = r#"{ "type": "Feature", "crs": "local", "properties": {}, "geometry": { "type": "Polygon",
    "coordinates": [[[-1, 31], [-1, 12], [5, 10], [11, 14], [15, 21], [24, 23], [29, 19], [41, 22], [41, 31], [-1, 31]]] } }"#;

impl Sheet<'_> {
    /// The plain lot with a little air around it.
    pub fn small() -> Sheet<'static> {
        Sheet {
            layout: LOT,
            files: &[("cover.geojson", WOOD)],
            first_rule: true,
            pixels: [352, 276],
            scale: Some(550.0),
            extent: Some([-2.0, -2.0, 42.0, 32.0]),
            colours: 32,
            legend: false,
        }
    }

    /// A part of a layout, metres, so large that it is 470 pixels wide, without a legend.
    pub fn part(layout: &str, extent: [f64; 4]) -> Sheet<'_> {
        let [width, height] = [extent[2] - extent[0], extent[3] - extent[1]];
        let pixels = [470, (470.0 * height / width).round() as u32];
        // 110 dots to the inch: 470 of them are 108 mm.
        Sheet { first_rule: false, layout, pixels, scale: Some(width / 0.1085), extent: Some(extent), ..Sheet::small() }
    }

    /// A layout as one would pin it on the wall, with its legend.
    pub fn whole(layout: &str) -> Sheet<'_> {
        let plain = Sheet::small();
        let pixels = [1000, 720];
        Sheet { first_rule: false, layout, pixels, scale: None, extent: None, colours: 64, legend: true, ..plain }
    }

    fn options(&self) -> PlanOptions {
        let [width, height] = self.pixels;
        let bounds = |[x0, y0, x1, y1]: [f64; 4]| Bounds { min: DVec2::new(x0, y0), max: DVec2::new(x1, y1) };
        PlanOptions {
            scale: self.scale,
            size: PlanSize::Pixels(width, height),
            names: false,
            legend: self.legend,
            extent: self.extent.map(bounds),
            ..PlanOptions::default()
        }
    }
}

/// The plan of what rules make of a layout, as PNG.
///
/// The error is the first thing that is wrong with the rules, the layout or the derivation.
pub fn draw(rules: &str, sheet: &Sheet) -> Result<Vec<u8>, String> {
    let world = MemoryWorld::default().with("example.cga", rules);
    let world = sheet.files.iter().fold(world, |world, (path, text)| world.with(*path, text));
    let (program, found) = check(&world, "example.cga");
    sound(&found)?;
    let first = program.rules.iter().find(|rule| rule.params == 0).ok_or("there is no rule to begin with")?;
    let (layout, found) = read_geojson("layout.geojson", sheet.layout.as_bytes());
    sound(&found)?;
    let options = Options {
        start: sheet.first_rule.then(|| program.symbols[first.symbol as usize].clone()),
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
    let drawing = plan::draw(&scene, &sheet.options());
    plan::small_png(&drawing, sheet.colours).map_err(|error| error.to_string())
}

fn sound(found: &[Diagnostic]) -> Result<(), String> {
    found.iter().find(|d| d.is_error()).map_or(Ok(()), |error| Err(error.message.clone()))
}
