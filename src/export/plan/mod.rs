//! The planting plan: a scene on a sheet of paper, true to scale, as SVG or PNG.
//!
//! [`draw`] turns a resolved scene into one drawing list in millimetres; [`svg`] and [`png`] write that list and
//! nothing else, so both show the same. Same scene and options, same drawing. Nothing here knows rules or files.
//!
//! Light comes from the north-west of the paper, the paper is ivory, the lines are sepia: the conventions of the
//! hand-drawn garden plan. Surfaces are drawn with their marks one after the other, so that a path hides the grass
//! of the lawn it crosses.

mod drawing;
mod field;
mod furniture;
mod ground;
mod ink;
mod labels;
mod legend;
mod lettering;
mod objects;
mod palette;
mod path;
mod planting;
mod png;
mod sheet;
mod solids;
mod svg;
mod symbol;
mod texture;

pub use drawing::{Anchor, Drawing, Group, Item, Layer, Shape, Stroke, Style, Symbol, Text, Use};
pub use ink::Ink;
pub use path::{Path, Step};
pub use png::{MOST_PIXELS, PlanError, Resolution, png, small_png};
pub use svg::svg;

use crate::export::plan::labels::Board;
use crate::export::plan::legend::Section;
use crate::export::plan::planting::Planting;
use crate::export::plan::sheet::{Extent, GUTTER, Panel, Sheet};
use crate::export::plan::symbol::Cabinet;
use crate::geometry::Bounds;
use crate::scene::Scene;
use glam::DVec2;

/// How a plan is drawn.
#[derive(Clone, Debug, PartialEq)]
pub struct PlanOptions {
    /// Metres of plan per metre of paper, 500 for 1:500; `None` takes the roundest that fits.
    pub scale: Option<f64>,
    /// The sheet.
    pub size: PlanSize,
    /// How far the plan is turned on the sheet, degrees counter-clockwise.
    pub rotation: f64,
    /// Whether plants carry their codes.
    pub codes: bool,
    /// Whether names of regions are written.
    pub names: bool,
    /// Whether there is a legend.
    pub legend: bool,
    /// The title; `None` takes the scene's.
    pub title: Option<String>,
    /// A line under the title.
    pub subtitle: Option<String>,
    /// The part of the plan to show, metres; `None` shows all.
    pub extent: Option<Bounds>,
}

/// How large the sheet is.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum PlanSize {
    /// As large as the plan needs; without a wanted scale not larger than A3.
    #[default]
    Auto,
    /// A picture of so many pixels, width and height.
    Pixels(u32, u32),
    /// As `Auto`, and the picture shows so many metres of the plan per pixel.
    MetresPerPixel(f64),
}

impl Default for PlanOptions {
    fn default() -> PlanOptions {
        PlanOptions {
            scale: None,
            size: PlanSize::Auto,
            rotation: 0.0,
            codes: false,
            names: true,
            legend: true,
            title: None,
            subtitle: None,
            extent: None,
        }
    }
}

/// Draws a scene. Cost: linear in what the sheet shows, and in labels times labels.
pub fn draw(scene: &Scene, options: &PlanOptions) -> Drawing {
    let extent = match options.extent.filter(|e| !e.is_empty()) {
        Some(bounds) => Extent::around(corners(bounds), options.rotation),
        None => Extent::around(everything(scene), options.rotation),
    };
    let part = options.extent.and_then(|_| extent.outline(options.rotation));
    let legend = if options.legend { legend::sections(scene, part) } else { Vec::new() };
    let sheet = Sheet::new(&extent, legend::height(&legend), options);
    let mut cabinet = Cabinet::new();
    let mut layers = vec![furniture::paper(&sheet)];
    layers.extend(plan_layers(scene, options, &sheet, &mut cabinet));
    let title = options.title.clone().unwrap_or_else(|| scene.title.to_string());
    layers.extend(furnishings(legend, &title, options, &sheet, &mut cabinet));
    Drawing {
        title,
        size: sheet.size,
        window: [sheet.window.min, sheet.window.max],
        scale: sheet.frame.scale,
        dots: sheet.dots,
        symbols: cabinet.into_symbols(),
        layers,
    }
}

/// The plan itself, lowest layer first.
fn plan_layers(scene: &Scene, options: &PlanOptions, sheet: &Sheet, cabinet: &mut Cabinet) -> Vec<Layer> {
    let planting = Planting::new(&scene.plants, sheet);
    let mut shadows = Layer {
        opacity: 0.3,
        blur: (0.15 * sheet.frame.length(1.0)).clamp(0.15, 0.9),
        ..Layer::new("shadows", "Shadows")
    };
    shadows.items = solids::shadows(&scene.solids, sheet);
    shadows.items.extend(planting.shadows(cabinet, sheet));
    let mut layers = vec![
        ground::covers(&scene.covers, sheet),
        ground::lots(&scene.lots, sheet),
        ground::lines(&scene.lines, sheet),
        shadows,
        solids::layer(&scene.solids, sheet),
    ];
    layers.extend(planting.layers(cabinet, sheet));
    layers.push(objects::layer(&scene.objects, sheet));
    let mut board = Board::default();
    if options.names {
        layers.push(labels::names(&scene.lots, &scene.title, &mut board, sheet));
    }
    if options.codes {
        layers.push(planting.codes(&mut board));
    }
    layers
}

/// Frame, title, legend, scale bar and north arrow.
fn furnishings(
    legend: Vec<Section>,
    title: &str,
    options: &PlanOptions,
    sheet: &Sheet,
    cabinet: &mut Cabinet,
) -> Vec<Layer> {
    let Some(panel) = sheet.panel else { return Vec::new() };
    let mut lettering = Layer { windowed: false, ..Layer::new("title", "Title and scale") };
    lettering.items = furniture::neatline(sheet);
    let mut key = Layer { windowed: false, ..Layer::new("legend", "Legend") };
    match panel {
        Panel::Strip(place) => lettering.items.extend(furniture::strip(title, options, sheet, place)),
        Panel::Side(place) | Panel::Foot(place) => {
            let below = matches!(panel, Panel::Foot(_));
            let first = legend::columns(place).first().copied().unwrap_or(place);
            let (words, height) = furniture::title(title, options, first);
            let (columns, scale) = furniture::places(place, height + GUTTER * 0.5, below);
            key.items = legend::draw(legend, &columns, cabinet, sheet);
            lettering.items.extend(words);
            lettering.items.extend(furniture::scale_block(sheet, scale));
        }
    }
    vec![lettering, key]
}

/// Points around everything in the scene.
fn everything(scene: &Scene) -> impl Iterator<Item = DVec2> {
    let areas = scene.lots.iter().map(|lot| &lot.area);
    let areas = areas.chain(scene.covers.iter().map(|cover| &cover.area));
    let areas = areas.chain(scene.solids.iter().map(|solid| &solid.footprint));
    let lines = scene.lines.iter().flat_map(|line| line.points.iter().copied());
    let crowns = scene.plants.iter().flat_map(|plant| {
        let reach = if plant.crown_radius.is_finite() { plant.crown_radius } else { 0.0 };
        corners(Bounds::of([plant.position]).grown(reach))
    });
    let objects = scene.objects.iter().map(|object| object.position);
    areas.flat_map(|area| area.edges().map(|(a, _)| a)).chain(lines).chain(crowns).chain(objects)
}

fn corners(bounds: Bounds) -> [DVec2; 4] {
    let (low, high) = (bounds.min, bounds.max);
    [low, DVec2::new(high.x, low.y), high, DVec2::new(low.x, high.y)]
}
