//! Ground covers: fill, marks and outline of each surface, in the scene's order so that later ones hide earlier ones.

use crate::export::plan::drawing::{Group, Item, Layer, Shape};
use crate::export::plan::ink::{Ink, UMBER};
use crate::export::plan::path::Path;
use crate::export::plan::sheet::Sheet;
use crate::export::plan::texture::{self, Ground};
use crate::geometry::{Area, inset};
use crate::scene::{Cover, Line, LotOutline, Material, Texture};
use crate::text::area_words;

/// All covers of a scene.
pub fn covers(covers: &[Cover], sheet: &Sheet) -> Layer {
    let items = covers.iter().filter_map(|cover| draw(cover, sheet)).collect();
    Layer { items, ..Layer::new("covers", "Ground covers") }
}

/// The regions' outlines as hairlines.
pub fn lots(lots: &[LotOutline], sheet: &Sheet) -> Layer {
    let outline = |lot: &LotOutline| {
        let shape = Shape::drawn(Path::area(&sheet.shown(&lot.area)?), UMBER.faded(0.5), 0.08);
        let title = if lot.name.is_empty() { &lot.id } else { &lot.name };
        let (class, title) = (format!("lot {}", lot.kind), Some(title.to_string()));
        Some(Group { class, title, clip: None, items: vec![shape.into()] }.into())
    };
    Layer { items: lots.iter().filter_map(outline).collect(), ..Layer::new("lots", "Lots") }
}

/// All lines of a scene.
pub fn lines(lines: &[Line], sheet: &Sheet) -> Layer {
    let draw = |line: &Line| {
        let points: Vec<_> = line.points.iter().map(|p| sheet.frame.point(*p)).collect();
        let width = if line.material.line_width > 0.0 { line.material.line_width.into() } else { 0.15 };
        let path = Path::line(&points);
        (!path.is_empty()).then(|| Shape::drawn(path, Ink::of(line.material.line), width).into())
    };
    Layer { items: lines.iter().filter_map(draw).collect(), ..Layer::new("lines", "Lines") }
}

/// A region on paper with a material's fill, wash, marks and outline.
pub fn surface(area: &Area, material: &Material, metre: f64, sheet: &Sheet, id: &str) -> Vec<Item> {
    let ground = Ground::new(area, sheet.window, material, metre, id);
    let mut items = vec![Shape::filled(Path::area(area), ground.fill).into()];
    items.extend(wash(&ground, material.texture));
    items.extend(texture::draw(material.texture, &ground));
    if material.line_width > 0.0 {
        items.push(Shape::drawn(Path::area(area), ground.line, material.line_width.into()).into());
    }
    items
}

fn draw(cover: &Cover, sheet: &Sheet) -> Option<Item> {
    let area = sheet.shown(&cover.area)?;
    let items = surface(&area, &cover.material, sheet.frame.length(1.0), sheet, &cover.origin.id);
    let title = Some(format!("{}, {}", cover.material.label, area_words(cover.area.area())));
    Some(Group { class: format!("cover {}", cover.material.name), title, clip: None, items }.into())
}

/// The darker rim that watercolour leaves where a wash dries.
fn wash(ground: &Ground, texture: Texture) -> Option<Item> {
    if ground.fill.alpha == 0 || ground.area.area() < 6.0 {
        return None;
    }
    let ink = ground.line.faded(if texture == Texture::Plain { 0.09 } else { 0.13 });
    let band = |width: f64| Path::band(ground.area, &inset(ground.area, width));
    let items = vec![Shape::filled(band(0.35), ink).into(), Shape::filled(band(0.8), ink.faded(0.7)).into()];
    Some(Group { items, ..Group::default() }.into())
}
