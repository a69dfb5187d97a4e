//! The sheet: how plan metres become paper millimetres, and where on the paper what goes.
//!
//! In come the plan's extent and the options, out come the scale, the sheet's size, the window of the plan and the
//! panel for title, legend, scale bar and north arrow. Nothing is drawn here.

use crate::export::plan::path::direction;
use crate::export::plan::{PlanOptions, PlanSize};
use crate::geometry::{Area, Bounds};
use glam::{DAffine2, DMat2, DVec2};

/// From the paper's edge to the neatline.
pub const MARGIN: f64 = 9.0;
/// From the neatline to what is inside.
pub const GUTTER: f64 = 6.0;
/// Width of the panel beside the plan, or of one of its columns below.
pub const COLUMN: f64 = 64.0;
/// Height of the strip below a plan without legend.
const STRIP: f64 = 24.0;
/// Height of the panel below a wide plan.
const FOOT: f64 = 78.0;
/// Least height of a sheet with a panel beside the plan.
const LEAST_SIDE: f64 = 176.0;
/// Least width of a sheet with a panel below.
const LEAST_FOOT: f64 = 150.0;
/// Air around the plan inside its window.
const AIR: f64 = 4.0;
/// The sheet a plan of its own choice fits on: A3.
const A3: DVec2 = DVec2::new(420.0, 297.0);
/// Dots per millimetre of a sheet given in pixels: 110 to the inch.
const SCREEN: f64 = 110.0 / 25.4;
/// Dots per millimetre otherwise: 200 to the inch.
const PRINT: f64 = 200.0 / 25.4;
/// Sheets narrower than this have no room for anything but the plan.
const BARE: f64 = 110.0;
/// The largest sheet, millimetres a side: larger than any plotter.
const LARGEST: f64 = 20_000.0;

/// Where everything goes.
#[derive(Clone, Debug)]
pub struct Sheet {
    /// The paper.
    pub size: DVec2,
    /// The plan's window.
    pub window: Bounds,
    /// Title, legend, scale bar and north arrow; `None` where there is no room.
    pub panel: Option<Panel>,
    /// The way from the plan to the paper.
    pub frame: Frame,
    /// The picture's resolution in dots per millimetre.
    pub dots: f64,
}

/// Where the sheet's own lettering goes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Panel {
    /// One column beside the plan.
    Side(Bounds),
    /// Several columns below the plan.
    Foot(Bounds),
    /// A single strip below the plan, without legend.
    Strip(Bounds),
}

/// The way from plan metres (x east, y north) to paper millimetres (x right, y down).
#[derive(Clone, Copy, Debug)]
pub struct Frame {
    /// Metres of plan per metre of paper.
    pub scale: f64,
    map: DAffine2,
    turn: f64,
}

impl Frame {
    /// Lays the plan's point `centre` on the paper's point `at`, turned counter-clockwise by `rotation` degrees.
    pub fn new(scale: f64, rotation: f64, centre: DVec2, at: DVec2) -> Frame {
        let east = direction(-rotation.to_radians());
        let matrix = DMat2::from_cols(east, DVec2::new(east.y, -east.x)) * (1000.0 / scale);
        let map = DAffine2::from_mat2_translation(matrix, at - matrix * centre);
        Frame { scale, map, turn: rotation }
    }

    /// A point of the plan on the paper.
    pub fn point(&self, plan: DVec2) -> DVec2 {
        self.map.transform_point2(plan)
    }

    /// A length in metres on the paper.
    pub fn length(&self, metres: f64) -> f64 {
        metres * 1000.0 / self.scale
    }

    /// A region of the plan on the paper.
    pub fn area(&self, plan: &Area) -> Area {
        plan.transformed(&self.map)
    }

    /// The direction on paper of an angle in the plan, degrees clockwise from the paper's right.
    pub fn turn(&self, heading: f64) -> f64 {
        -(heading + self.turn)
    }

    /// North's direction on paper, a unit vector.
    pub fn north(&self) -> DVec2 {
        self.map.transform_vector2(DVec2::Y).normalize_or(DVec2::NEG_Y)
    }
}

impl Sheet {
    /// Chooses scale, sheet and places for a plan of the given extent (metres, before turning).
    pub fn new(extent: Bounds, options: &PlanOptions) -> Sheet {
        let extent = if extent.is_empty() { Bounds { min: DVec2::ZERO, max: DVec2::ZERO } } else { extent };
        let size = turned_size(extent.size().max(DVec2::splat(1.0)), options.rotation);
        match options.size {
            PlanSize::Pixels(width, height) => {
                fixed(extent, size, DVec2::new(width.into(), height.into()) / SCREEN, options)
            }
            PlanSize::Auto => fitted(extent, size, None, options),
            PlanSize::MetresPerPixel(metres) => fitted(extent, size, Some(metres), options),
        }
    }
}

/// A sheet that fits around the plan.
fn fitted(extent: Bounds, size: DVec2, metres_per_pixel: Option<f64>, options: &PlanOptions) -> Sheet {
    let sheet = |scale: f64| around(size * 1000.0 / scale, options);
    let fits = |scale: &f64| {
        let paper = sheet(*scale).0;
        paper.cmple(A3).all() || paper.cmple(DVec2::new(A3.y, A3.x)).all()
    };
    let least = size.max_element() * 1000.0 / LARGEST;
    let scale = wanted(options).unwrap_or_else(|| round_scales().find(fits).unwrap_or(least)).max(least);
    let (paper, layout) = sheet(scale);
    let dots = metres_per_pixel.filter(|m| *m > 0.0).map_or(PRINT, |metres| scale / 1000.0 / metres);
    compose(extent, scale, paper, layout, dots, options)
}

/// A sheet of given size, with the roundest scale at which the plan fits into its window.
fn fixed(extent: Bounds, size: DVec2, paper: DVec2, options: &PlanOptions) -> Sheet {
    let layout = match () {
        () if paper.min_element() < BARE => Layout::Bare,
        () if !options.legend => Layout::Strip,
        () if size.x > 2.2 * size.y && paper.x > 2.0 * COLUMN + 4.0 * MARGIN => Layout::Foot,
        () if paper.x > 2.0 * COLUMN + 4.0 * MARGIN => Layout::Side,
        () => Layout::Strip,
    };
    let room = (window(paper, layout).size() - 2.0 * layout.air()).max(DVec2::ONE);
    let exact = (size * 1000.0 / room).max_element();
    let scale = wanted(options).unwrap_or_else(|| round_scales().find(|s| *s >= exact).unwrap_or(exact));
    compose(extent, scale, paper, layout, SCREEN, options)
}

fn compose(extent: Bounds, scale: f64, paper: DVec2, layout: Layout, dots: f64, options: &PlanOptions) -> Sheet {
    let window = window(paper, layout);
    let frame = Frame::new(scale, options.rotation, extent.centre(), window.centre());
    Sheet { size: paper, window, panel: panel(paper, window, layout), frame, dots }
}

fn wanted(options: &PlanOptions) -> Option<f64> {
    options.scale.filter(|s| s.is_finite() && *s > 0.0)
}

/// How plan and panel share the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Layout {
    Side,
    Foot,
    Strip,
    Bare,
}

impl Layout {
    fn air(self) -> f64 {
        if self == Layout::Bare { 0.5 } else { AIR }
    }
}

/// The paper for a plan that takes `plan` millimetres, and how it is shared.
fn around(plan: DVec2, options: &PlanOptions) -> (DVec2, Layout) {
    let edge = DVec2::splat(2.0 * (MARGIN + AIR));
    match () {
        () if !options.legend => {
            ((plan + edge + DVec2::new(0.0, STRIP)).max(DVec2::new(LEAST_FOOT, 0.0)), Layout::Strip)
        }
        () if plan.x > 2.2 * plan.y && plan.x > 2.5 * COLUMN => {
            ((plan + edge + DVec2::new(0.0, FOOT)).max(DVec2::new(LEAST_FOOT, 0.0)), Layout::Foot)
        }
        () => {
            let beside = plan + edge + DVec2::new(COLUMN + 2.0 * GUTTER, 0.0);
            (beside.max(DVec2::new(0.0, LEAST_SIDE)), Layout::Side)
        }
    }
}

/// The plan's window on a paper.
fn window(paper: DVec2, layout: Layout) -> Bounds {
    let taken = match layout {
        Layout::Bare => return Bounds { min: DVec2::ZERO, max: paper },
        Layout::Side => DVec2::new(COLUMN + 2.0 * GUTTER, 0.0),
        Layout::Foot => DVec2::new(0.0, FOOT),
        Layout::Strip => DVec2::new(0.0, STRIP),
    };
    Bounds { min: DVec2::splat(MARGIN), max: paper - MARGIN - taken }
}

fn panel(paper: DVec2, window: Bounds, layout: Layout) -> Option<Panel> {
    let end = paper - MARGIN - GUTTER;
    let below = Bounds { min: DVec2::new(MARGIN + GUTTER, window.max.y + GUTTER), max: end };
    match layout {
        Layout::Bare => None,
        Layout::Side => {
            Some(Panel::Side(Bounds { min: DVec2::new(window.max.x + GUTTER, MARGIN + GUTTER), max: end }))
        }
        Layout::Foot => Some(Panel::Foot(below)),
        Layout::Strip => Some(Panel::Strip(below)),
    }
}

/// The scales architects use, large plans first: 1:20 to 1:500,000.
fn round_scales() -> impl Iterator<Item = f64> {
    let decades = [10.0, 100.0, 1_000.0, 10_000.0, 100_000.0];
    decades.into_iter().flat_map(|d| [2.0, 2.5, 5.0, 7.5, 10.0].map(|s| s * d)).filter(|s| *s != 75.0)
}

/// Width and height of the turned extent's bounding box.
fn turned_size(size: DVec2, rotation: f64) -> DVec2 {
    let turn = direction(rotation.to_radians()).abs();
    DVec2::new(size.x * turn.x + size.y * turn.y, size.x * turn.y + size.y * turn.x)
}
