//! What makes a drawing a plan: paper, frame, title block, scale bar and north arrow.

use crate::export::plan::drawing::{Anchor, Item, Layer, Shape, Style, Text};
use crate::export::plan::ink::{FIELD, PAPER, SEPIA, UMBER};
use crate::export::plan::lettering;
use crate::export::plan::path::Path;
use crate::export::plan::sheet::{GUTTER, Sheet};
use crate::export::plan::{PlanOptions, legend};
use crate::geometry::Bounds;
use crate::text::number;
use glam::DVec2;

/// Radius of the north arrow's ring.
const ARROW: f64 = 6.0;
/// Height of the block with scale bar and north arrow.
pub const SCALE_BLOCK: f64 = 19.0;

/// The sheet, and the ground below the plan.
pub fn paper(sheet: &Sheet) -> Layer {
    let window = sheet.window;
    let items = vec![
        Shape::filled(Path::rectangle(DVec2::NEG_ONE, sheet.size + 2.0), PAPER).into(),
        Shape::filled(Path::rectangle(window.min, window.size()), FIELD).into(),
    ];
    Layer { items, windowed: false, ..Layer::new("paper", "Paper") }
}

/// The neatline: a strong line, and a hairline around it.
pub fn neatline(sheet: &Sheet) -> Vec<Item> {
    let frame = |out: f64, width: f64, bounds: Bounds| {
        let bounds = bounds.grown(out);
        Shape::drawn(Path::rectangle(bounds.min, bounds.size()), SEPIA, width).into()
    };
    let whole = Bounds { min: sheet.window.min, max: sheet.size - sheet.window.min };
    vec![frame(1.2, 0.1, whole), frame(0.0, 0.25, whole), frame(0.0, 0.15, sheet.window)]
}

/// Title and subtitle from the panel's upper left corner, and the height they take.
pub fn title(words: &str, options: &PlanOptions, panel: Bounds) -> (Vec<Item>, f64) {
    let (mut items, mut y, room) = (Vec::new(), 0.0, panel.size().x);
    let capitals = words.to_uppercase();
    let style = |size: f64| Style::plain(size).strong().spaced(0.2);
    let widest = |size: f64| {
        let widths = capitals.split_whitespace().map(|w| lettering::width(w, &style(size)));
        widths.fold(0.0, f64::max)
    };
    let size = [5.2, 4.4, 3.7, 3.0, 2.5].into_iter().find(|s| widest(*s) <= room).unwrap_or(2.0);
    for line in lettering::wrapped(&capitals, &style(size), room).into_iter().take(4) {
        y += size * 1.25;
        let line = lettering::fitted(&line, &style(size), room);
        items.push(Text::new(line, panel.min + DVec2::new(0.0, y), style(size)).into());
    }
    let style = Style::plain(2.7).italic().ink(UMBER);
    y += 1.4;
    for line in lettering::wrapped(options.subtitle.as_deref().unwrap_or(""), &style, room).into_iter().take(3) {
        y += 4.2;
        items.push(Text::new(line, panel.min + DVec2::new(0.0, y), style).into());
    }
    (items, y)
}

/// Scale in words, scale bar and north arrow along the bottom of a panel.
pub fn scale_block(sheet: &Sheet, panel: Bounds) -> Vec<Item> {
    let arrow = panel.max - DVec2::splat(ARROW + 0.6);
    let room = panel.size().x - 2.0 * ARROW - 2.0 * GUTTER;
    let mut items = scale_bar(sheet, DVec2::new(panel.min.x, panel.max.y - 1.2), room);
    items.extend(north_arrow(sheet, arrow));
    items
}

/// Title left, scale right: the sheet without a legend.
pub fn strip(words: &str, options: &PlanOptions, sheet: &Sheet, panel: Bounds) -> Vec<Item> {
    let block = (panel.size().x * 0.5).min(86.0);
    let left = Bounds { min: panel.min, max: DVec2::new(panel.max.x - block - GUTTER, panel.max.y) };
    let right = Bounds { min: DVec2::new(panel.max.x - block, panel.min.y), max: panel.max };
    let (mut items, _) = title(words, options, left);
    items.extend(scale_block(sheet, right));
    items
}

/// The columns a legend may use beside or below the title, and where title and scale go.
pub fn places(panel: Bounds, title_height: f64, below: bool) -> (Vec<Bounds>, Bounds) {
    let mut columns = legend::columns(panel);
    if columns.is_empty() {
        return (columns, panel);
    }
    if below {
        let first = columns.remove(0);
        return (columns, first);
    }
    let first = columns[0];
    columns[0].min.y += title_height;
    columns[0].max.y -= SCALE_BLOCK + GUTTER;
    (columns, first)
}

/// A bar of four parts in two tones, its left end on the baseline point, about `room` wide.
fn scale_bar(sheet: &Sheet, at: DVec2, room: f64) -> Vec<Item> {
    let metres = nice((room * 0.88).min(60.0) / sheet.frame.length(1.0));
    let (length, height) = (sheet.frame.length(metres), 1.3);
    let top = at - DVec2::new(0.0, height);
    let part = |i: f64| top + DVec2::new(length * i / 4.0, 0.0);
    let mut items: Vec<Item> = Vec::new();
    for i in 0..4 {
        let ink = if i % 2 == 0 { SEPIA } else { PAPER };
        let path = Path::rectangle(part(f64::from(i)), DVec2::new(length / 4.0, height));
        items.push(Shape::filled(path, ink).outlined(SEPIA, 0.12).into());
    }
    let style = Style::plain(2.0);
    let unit = if metres >= 2_000.0 { (1_000.0, " km") } else { (1.0, " m") };
    for (i, suffix) in [(0.0, ""), (2.0, ""), (4.0, unit.1)] {
        let words = number(metres * i / 4.0 / unit.0, 2) + suffix;
        items.push(Text::new(words, part(i) - DVec2::new(0.0, 1.2), style).anchored(middle(i)).into());
    }
    let scale = format!("1 : {}", ratio(sheet.frame.scale));
    items.push(Text::new(scale, top - DVec2::new(0.0, 5.6), Style::plain(3.2).strong().spaced(0.06)).into());
    items
}

fn middle(part: f64) -> Anchor {
    if part == 0.0 { Anchor::Start } else { Anchor::Middle }
}

/// The scale's number, with thin commas where it is a whole number.
fn ratio(scale: f64) -> String {
    match scale.fract() == 0.0 && scale < 1e12 {
        true => crate::text::thousands(scale as usize),
        false => number(scale, 1),
    }
}

/// The largest of 1, 2, 4, 5, 8 times a power of ten that is not above the value.
fn nice(value: f64) -> f64 {
    let decade = libm::pow(10.0, libm::floor(libm::log10(value.max(1e-3))));
    let steps = [8.0, 4.0, 2.0, 1.0];
    steps.into_iter().map(|s| s * decade).find(|s| *s <= value * 1.000_001).unwrap_or(decade)
}

/// A ring, a needle half dark and half light, and the letter.
fn north_arrow(sheet: &Sheet, at: DVec2) -> Vec<Item> {
    let (north, east) = (sheet.frame.north(), -sheet.frame.north().perp());
    let point = |n: f64, e: f64| at + north * (n * ARROW) + east * (e * ARROW);
    let half = |side: f64| Path::ring(&[point(0.98, 0.0), point(-0.62, side * 0.34), point(-0.34, 0.0)]);
    let mut ticks = Path::default();
    for (n, e) in [(-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
        ticks.add_line(&[point(n * 0.86, e * 0.86), point(n, e)], false);
    }
    let letter = point(1.36, 0.0) + DVec2::new(0.0, 1.0);
    vec![
        Shape::drawn(Path::circle(at, ARROW), SEPIA, 0.12).into(),
        Shape::drawn(ticks, SEPIA, 0.12).into(),
        Shape::filled(half(1.0), PAPER).outlined(SEPIA, 0.12).into(),
        Shape::filled(half(-1.0), SEPIA).outlined(SEPIA, 0.12).into(),
        Text::new("N", letter, Style::plain(2.8).strong()).anchored(Anchor::Middle).into(),
    ]
}
