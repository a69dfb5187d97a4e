//! Names on the plan: small, only where they fit, never over one another.

use crate::export::plan::drawing::{Anchor, Item, Layer, Style, Text};
use crate::export::plan::ink::PAPER;
use crate::export::plan::lettering;
use crate::export::plan::sheet::Sheet;
use crate::geometry::{Area, Bounds};
use crate::scene::LotOutline;
use glam::DVec2;

/// Font sizes of names, for large regions first.
const SIZES: [f64; 3] = [2.4, 2.1, 1.8];
/// The most names on a sheet.
const MOST: usize = 400;

/// Where lettering already stands.
#[derive(Default)]
pub struct Board {
    taken: Vec<Bounds>,
}

impl Board {
    /// Takes a place if it is free. Cost: linear in what was taken.
    pub fn take(&mut self, place: Bounds) -> bool {
        let free = self.taken.iter().all(|t| !t.touches(place));
        if free {
            self.taken.push(place);
        }
        free
    }
}

/// The names of regions that have one, large regions first. What the sheet's title says is not said again.
pub fn names(lots: &[LotOutline], title: &str, board: &mut Board, sheet: &Sheet) -> Layer {
    let is_named = |lot: &&LotOutline| !lot.name.is_empty() && &*lot.name != title;
    let mut named: Vec<&LotOutline> = lots.iter().filter(is_named).collect();
    named.sort_by(|a, b| b.area.area().total_cmp(&a.area.area()).then(a.id.cmp(&b.id)));
    let items = named.into_iter().take(MOST).filter_map(|lot| name(lot, board, sheet)).collect();
    Layer { items, ..Layer::new("names", "Names") }
}

fn name(lot: &LotOutline, board: &mut Board, sheet: &Sheet) -> Option<Item> {
    let area = sheet.frame.area(&lot.area);
    let (at, room) = place(&area)?;
    SIZES.into_iter().find_map(|size| {
        let style = Style::plain(size).italic().strong().spaced(0.08);
        let extent = DVec2::new(lettering::width(&lot.name, &style), size);
        let bounds = Bounds::of([at - extent / 2.0, at + extent / 2.0]);
        let fits = extent.x <= room.x && extent.y * 1.4 <= room.y && inside(sheet.window, bounds);
        (fits && board.take(bounds.grown(0.6))).then(|| {
            let text = Text::new(&*lot.name, at + DVec2::new(0.0, size * 0.35), style);
            text.anchored(Anchor::Middle).with_halo(PAPER.faded(0.7), size * 0.24).into()
        })
    })
}

/// A point well inside, and the width and height that are free around it.
fn place(area: &Area) -> Option<(DVec2, DVec2)> {
    let polygon = area.largest()?;
    let part = Area::from(polygon.clone());
    let middle = polygon.centroid();
    let at = if polygon.contains(middle) { middle } else { polygon.interior_point() };
    Some((at, DVec2::new(free(&part, at, DVec2::X), free(&part, at, DVec2::Y)) * 0.94))
}

/// The free length through a point in a direction, as far as it is even on both sides.
fn free(area: &Area, at: DVec2, along: DVec2) -> f64 {
    let level = at.dot(along.perp());
    let (mut before, mut after) = (f64::INFINITY, f64::INFINITY);
    for (a, b) in area.edges() {
        let (from, to) = (a.dot(along.perp()), b.dot(along.perp()));
        if (from > level) != (to > level) {
            let reach = (a.lerp(b, (level - from) / (to - from)) - at).dot(along);
            if reach < 0.0 { before = before.min(-reach) } else { after = after.min(reach) }
        }
    }
    if before.is_finite() && after.is_finite() { before.min(after) * 2.0 } else { 0.0 }
}

fn inside(outer: Bounds, inner: Bounds) -> bool {
    outer.contains(inner.min) && outer.contains(inner.max)
}
