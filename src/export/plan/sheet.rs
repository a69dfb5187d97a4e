//! The sheet: how plan metres become paper millimetres, and where on the paper what goes.
//!
//! In come the plan's extent and the options, out come the scale, the sheet's size, the window of the plan and the
//! panel for title, legend, scale bar and north arrow. Nothing is drawn here.

use crate::export::plan::path::direction;
use crate::export::plan::{PlanOptions, PlanSize};
use crate::geometry::{Area, Bounds, Polygon, intersection};
use glam::{DAffine2, DMat2, DVec2};

/// From the paper's edge to the neatline.
pub const MARGIN: f64 = 9.0;
/// From the neatline to what is inside.
pub const GUTTER: f64 = 6.0;
/// Width of the panel beside the plan, or of one of its columns below.
pub const COLUMN: f64 = 64.0;
/// Height of the strip below a plan without legend.
const STRIP: f64 = 24.0;
/// Least height of a panel with a legend below the plan.
const LEAST_FOOT: f64 = 66.0;
/// What title and scale take of the column beside the plan.
const TITLE_BLOCK: f64 = 56.0;
/// Least height of a sheet with a panel beside the plan, and how far the legend may stretch it.
const LEAST_SIDE: f64 = 140.0;
const TALLEST_SIDE: f64 = 296.0;
/// Least width of a sheet with a strip below.
const LEAST_STRIP: f64 = 150.0;
/// Columns never break evenly: room for a row or two more in each.
const SLACK: f64 = 12.0;
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
/// How far outside of the window regions are cut off.
const BEYOND: f64 = 400.0;

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
    /// One or several columns beside the plan.
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
    /// A frame of a scale, turned counter-clockwise by `rotation` degrees; the origins lie on each other.
    pub fn new(scale: f64, rotation: f64) -> Frame {
        let east = direction(-rotation.to_radians());
        let matrix = DMat2::from_cols(east, DVec2::new(east.y, -east.x)) * (1000.0 / scale);
        Frame { scale, map: DAffine2::from_mat2(matrix), turn: rotation }
    }

    /// The same with the plan's point `centre` on the paper's point `at`.
    pub fn centred(self, centre: DVec2, at: DVec2) -> Frame {
        let translation = at - self.map.transform_vector2(centre);
        Frame { map: DAffine2 { translation, ..self.map }, ..self }
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

/// What a plan shows: the least rectangle that is level on the sheet, in metres.
#[derive(Clone, Copy, Debug)]
pub struct Extent {
    /// Its middle on the plan.
    pub centre: DVec2,
    /// Its width and height on the sheet, at least a metre.
    pub size: DVec2,
}

impl Extent {
    /// Around points of the plan, which is turned counter-clockwise by `rotation` degrees.
    pub fn around(points: impl IntoIterator<Item = DVec2>, rotation: f64) -> Extent {
        let turn = direction(rotation.to_radians());
        let bounds = Bounds::of(points.into_iter().filter(|p| p.is_finite()).map(|p| turn.rotate(p)));
        let middle = if bounds.is_empty() { DVec2::ZERO } else { bounds.centre() };
        let back = DVec2::new(turn.x, -turn.y);
        Extent { centre: back.rotate(middle), size: bounds.size().max(DVec2::ONE) }
    }

    /// Its outline on the plan, which is turned by `rotation` degrees.
    pub fn outline(&self, rotation: f64) -> Option<Polygon> {
        let turn = direction(-rotation.to_radians());
        let corner = |x: f64, y: f64| self.centre + turn.rotate(self.size * 0.5 * DVec2::new(x, y));
        Polygon::new(&[corner(-1.0, -1.0), corner(1.0, -1.0), corner(1.0, 1.0), corner(-1.0, 1.0)], &[])
    }
}

impl Sheet {
    /// A region of the plan on the paper, or nothing where the window shows none of it.
    ///
    /// What reaches far out of the window is cut off well outside of it: no marks are strewn where nobody looks, and
    /// no coordinate is larger than a rasteriser can bear.
    pub fn shown(&self, plan: &Area) -> Option<Area> {
        let area = self.frame.area(plan);
        let (bounds, reach) = (area.bounds(), self.window.grown(BEYOND));
        if area.is_empty() || !bounds.touches(self.window) {
            return None;
        }
        if reach.contains(bounds.min) && reach.contains(bounds.max) {
            return Some(area);
        }
        let cut = Polygon::rectangle(reach.min, reach.max).map(|frame| intersection(&area, &frame.into()));
        cut.filter(|area| !area.is_empty())
    }

    /// Chooses scale, sheet and places for a plan that shows `extent`.
    ///
    /// `legend` is the legend's height in one column; 0 for none.
    pub fn new(extent: &Extent, legend: f64, options: &PlanOptions) -> Sheet {
        match options.size {
            PlanSize::Pixels(width, height) => {
                fixed(extent, DVec2::new(width.into(), height.into()) / SCREEN, legend, options)
            }
            PlanSize::Auto => fitted(extent, None, legend, options),
            PlanSize::MetresPerPixel(metres) => fitted(extent, Some(metres), legend, options),
        }
    }
}

/// A sheet that fits around the plan.
fn fitted(extent: &Extent, pixel: Option<f64>, legend: f64, options: &PlanOptions) -> Sheet {
    let size = extent.size;
    let sheet = |scale: f64| around(size * 1000.0 / scale, legend);
    let fits = |scale: &f64| {
        let paper = sheet(*scale).0;
        paper.cmple(A3).all() || paper.cmple(DVec2::new(A3.y, A3.x)).all()
    };
    // Larger than any country: whatever scale fits.
    let exact = size.max_element() * 1000.0 / 250.0;
    let scale = wanted(options).unwrap_or_else(|| round_scales().find(fits).unwrap_or(exact));
    let (paper, layout) = sheet(scale);
    let dots = pixel.filter(|m| *m > 0.0).map_or(PRINT, |metres| scale / 1000.0 / metres);
    compose(extent, Frame::new(scale, options.rotation), paper, layout, legend, dots)
}

/// A sheet of given size, with the roundest scale at which the plan fits into its window.
fn fixed(extent: &Extent, paper: DVec2, legend: f64, options: &PlanOptions) -> Sheet {
    let size = extent.size;
    let roomy = paper.x > 2.0 * COLUMN + 4.0 * MARGIN && paper.y > LEAST_FOOT + 4.0 * MARGIN;
    let foot = foot_height(paper.x, legend).min(paper.y * 0.4);
    let candidates = match () {
        () if paper.min_element() < BARE => [Layout::Bare, Layout::Bare],
        () if legend == 0.0 || !roomy => [Layout::Below(STRIP), Layout::Below(STRIP)],
        () => [Layout::Side(1.0), Layout::Below(foot)],
    };
    // The layout that lets the plan be larger.
    let exact = |layout: &Layout| {
        let air = if *layout == Layout::Bare { 0.5 } else { AIR };
        (size * 1000.0 / (window(paper, *layout).size() - 2.0 * air).max(DVec2::ONE)).max_element()
    };
    let [first, second] = candidates;
    let layout = if exact(&second) < exact(&first) { second } else { first };
    let (exact, legend) = (exact(&layout), if layout == Layout::Below(STRIP) { 0.0 } else { legend });
    let scale = wanted(options).unwrap_or_else(|| round_scales().find(|s| *s >= exact).unwrap_or(exact));
    compose(extent, Frame::new(scale, options.rotation), paper, layout, legend, SCREEN)
}

fn compose(extent: &Extent, frame: Frame, paper: DVec2, layout: Layout, legend: f64, dots: f64) -> Sheet {
    let window = window(paper, layout);
    let frame = frame.centred(extent.centre, window.centre());
    Sheet { size: paper, window, panel: panel(paper, window, layout, legend), frame, dots }
}

fn wanted(options: &PlanOptions) -> Option<f64> {
    options.scale.filter(|s| s.is_finite() && *s > 0.0)
}

/// How plan and panel share the sheet.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Layout {
    /// So many columns beside the plan.
    Side(f64),
    /// A panel of some height below it.
    Below(f64),
    /// Only the plan.
    Bare,
}

/// The paper for a plan that takes `plan` millimetres, and how it is shared: whichever wastes least paper.
fn around(plan: DVec2, legend: f64) -> (DVec2, Layout) {
    let room = plan + 2.0 * (MARGIN + AIR);
    if legend == 0.0 {
        return ((room + DVec2::new(0.0, STRIP)).max(DVec2::new(LEAST_STRIP, 0.0)), Layout::Below(STRIP));
    }
    let side = |columns: f64| {
        let height = (legend + TITLE_BLOCK) / columns + 2.0 * (MARGIN + GUTTER) + SLACK * (columns - 1.0);
        let paper = room + DVec2::new(columns * (COLUMN + GUTTER) + GUTTER, 0.0);
        (paper.max(DVec2::new(0.0, height.clamp(LEAST_SIDE, TALLEST_SIDE))), Layout::Side(columns))
    };
    let below = |columns: f64| {
        let width = room.x.max(columns * (COLUMN + GUTTER) + 2.0 * MARGIN + GUTTER);
        let height = foot_height(width, legend);
        (DVec2::new(width, room.y + height), Layout::Below(height))
    };
    let candidates = [side(1.0), side(2.0), side(3.0), below(2.0), below(3.0), below(4.0), below(5.0)];
    candidates.into_iter().min_by(|a, b| waste(a.0).total_cmp(&waste(b.0))).unwrap_or((room, Layout::Bare))
}

/// Area of the paper, more where it is far from the shape of common sheets.
fn waste(paper: DVec2) -> f64 {
    paper.x * paper.y * (1.0 + 0.3 * libm::fabs(libm::log(paper.x / paper.y / 1.414)))
}

/// Height of a panel below a plan on paper of some width: the first column is the title's.
fn foot_height(width: f64, legend: f64) -> f64 {
    let columns = ((width - 2.0 * MARGIN - GUTTER) / (COLUMN + GUTTER)).floor() - 1.0;
    (legend / columns.max(1.0) + SLACK + 2.0 * GUTTER).clamp(LEAST_FOOT, TALLEST_SIDE)
}

/// The plan's window on a paper.
fn window(paper: DVec2, layout: Layout) -> Bounds {
    let taken = match layout {
        Layout::Bare => return Bounds { min: DVec2::ZERO, max: paper },
        Layout::Side(columns) => DVec2::new(columns * (COLUMN + GUTTER) + GUTTER, 0.0),
        Layout::Below(height) => DVec2::new(0.0, height),
    };
    Bounds { min: DVec2::splat(MARGIN), max: paper - MARGIN - taken }
}

fn panel(paper: DVec2, window: Bounds, layout: Layout, legend: f64) -> Option<Panel> {
    let end = paper - MARGIN - GUTTER;
    let below = Bounds { min: DVec2::new(MARGIN + GUTTER, window.max.y + GUTTER), max: end };
    match layout {
        Layout::Bare => None,
        Layout::Side(_) => {
            Some(Panel::Side(Bounds { min: DVec2::new(window.max.x + GUTTER, MARGIN + GUTTER), max: end }))
        }
        Layout::Below(_) if legend > 0.0 => Some(Panel::Foot(below)),
        Layout::Below(_) => Some(Panel::Strip(below)),
    }
}

/// The scales architects use, large plans first: 1:20 to 1:500,000.
fn round_scales() -> impl Iterator<Item = f64> {
    let decades = [10.0, 100.0, 1_000.0, 10_000.0, 100_000.0];
    let steps = [2.0, 2.5, 5.0, 7.5, 10.0, 12.5, 15.0];
    // Between round numbers only where plans are large: nobody owns a 1:125 ruler.
    let common = |scale: &f64| ![75.0, 125.0, 150.0].contains(scale);
    decades.into_iter().flat_map(move |d| steps.map(|s| s * d)).filter(common)
}
