//! The legend: what the plan shows, with samples drawn as on the plan, amounts and counts.
//!
//! In comes the scene, out come sections of rows, and then rows laid into columns. What has no room is counted
//! ("and 4 more"), never silently left out.

use crate::export::plan::drawing::{Anchor, Item, Shape, Style, Text, Use};
use crate::export::plan::ground;
use crate::export::plan::ink::{Ink, SEPIA, UMBER};
use crate::export::plan::lettering;
use crate::export::plan::objects::Piece;
use crate::export::plan::path::Path;
use crate::export::plan::sheet::{COLUMN, GUTTER, Sheet};
use crate::export::plan::solids;
use crate::export::plan::symbol::Cabinet;
use crate::export::plan::texture::Ground;
use crate::geometry::{Area, Bounds, Polygon, intersection};
use crate::scene::{Material, Object, Plant, PlantSymbol, Scene, Strip, strip_length};
use crate::text::{area_words, thousands};
use glam::DVec2;
use std::collections::BTreeMap;
use std::sync::Arc;

/// Height of a row of one line, of a row of two, and of a section's title with the air above it.
const ROW: f64 = 4.8;
const TALL_ROW: f64 = 6.6;
const TITLE: f64 = 8.2;
/// Size of a sample of a surface.
const SWATCH: DVec2 = DVec2::new(8.0, 3.6);
/// The title of the first section.
const PLANTS: &str = "Plants";
/// Where the words start.
const INDENT: f64 = 11.0;

/// A part of the legend under a title.
#[derive(Clone)]
pub struct Section {
    title: &'static str,
    rows: Vec<Row>,
    /// How many rows were left out.
    more: usize,
}

#[derive(Clone)]
struct Row {
    sample: Sample,
    code: String,
    words: String,
    latin: String,
    figure: String,
}

#[derive(Clone)]
enum Sample {
    Cover(Arc<Material>),
    Solid(Arc<Material>),
    Plant(PlantSymbol, Ink),
    Object(String, Ink),
}

/// All sections of the legend of a part of a scene, metres; empty ones are left out.
pub fn sections(scene: &Scene, part: Option<Polygon>) -> Vec<Section> {
    let part = Part(part.map(Area::from));
    let section = |title, rows| Section { title, rows, more: 0 };
    let all = [
        section(PLANTS, plants(scene.plants.iter().filter(|p| part.holds(p.position)))),
        section("Surfaces", covers(scene, &part)),
        section("Hedges and buildings", solid_rows(scene, &part)),
        section("Furniture", objects(scene.objects.iter().filter(|o| part.holds(o.position)))),
    ];
    all.into_iter().filter(|s| !s.rows.is_empty()).collect()
}

/// The part of the plan that is shown; `None` shows all.
struct Part(Option<Area>);

impl Part {
    fn holds(&self, point: DVec2) -> bool {
        self.0.as_ref().is_none_or(|part| part.contains(point))
    }

    /// What of a region lies in the part.
    fn of(&self, area: &Area) -> Area {
        match &self.0 {
            Some(part) => intersection(area, part),
            None => area.clone(),
        }
    }
}

/// Height of the whole legend in one column.
pub fn height(sections: &[Section]) -> f64 {
    sections.iter().map(|s| TITLE + s.rows.iter().map(Row::height).sum::<f64>()).sum()
}

/// The legend in columns of the panel's height, as much of it as there is room for.
pub fn draw(mut sections: Vec<Section>, columns: &[Bounds], cabinet: &mut Cabinet, sheet: &Sheet) -> Vec<Item> {
    while !sections.is_empty() && flow(&sections, columns).is_none() {
        shorten(&mut sections);
    }
    let mut items = Vec::new();
    for (line, at) in flow(&sections, columns).unwrap_or_default() {
        match line {
            Line::Title(words) => items.extend(title(words, at)),
            Line::Row(row) => items.extend(row_items(row, at, cabinet, sheet)),
            Line::More(count) => items.push(
                Text::new(format!("and {} more", thousands(count)), at + DVec2::new(INDENT, 3.2), small().italic())
                    .into(),
            ),
        }
    }
    items
}

enum Line<'a> {
    Title(&'static str),
    Row(&'a Row),
    More(usize),
}

/// Every line with its upper left corner, or `None` where the columns are too short.
fn flow<'a>(sections: &'a [Section], columns: &[Bounds]) -> Option<Vec<(Line<'a>, DVec2)>> {
    let mut placed = Vec::new();
    let (mut column, mut y) = (0, 0.0);
    for section in sections {
        let rows = section.rows.iter().map(|row| (Line::Row(row), row.height()));
        let more = (section.more > 0).then_some((Line::More(section.more), ROW));
        // A title stays with its first row.
        let first = section.rows.first().map_or(0.0, Row::height);
        let lines = [(Line::Title(section.title), TITLE)].into_iter().chain(rows).chain(more);
        for (line, height) in lines {
            let needed = if matches!(line, Line::Title(_)) { height + first } else { height };
            if columns.get(column)?.size().y < y + needed {
                (column, y) = (column + 1, 0.0);
                if columns.get(column)?.size().y < needed {
                    return None;
                }
            }
            placed.push((line, columns[column].min + DVec2::new(0.0, y)));
            y += height;
        }
    }
    Some(placed)
}

/// Takes the last row off the longest section, or the last section off the legend; plants count for less than
/// half, for the plan is about them.
fn shorten(sections: &mut Vec<Section>) {
    let length = |s: &&mut Section| s.rows.len() * if s.title == PLANTS { 2 } else { 5 };
    match sections.iter_mut().rev().filter(|s| s.rows.len() > 1).max_by_key(length) {
        Some(longest) => {
            longest.rows.pop();
            longest.more += 1;
        }
        None => drop(sections.pop()),
    }
}

impl Row {
    fn height(&self) -> f64 {
        if self.latin.is_empty() { ROW } else { TALL_ROW }
    }
}

fn small() -> Style {
    Style::plain(2.3)
}

fn title(words: &str, at: DVec2) -> Vec<Item> {
    let style = Style::plain(2.1).strong().spaced(0.16).ink(UMBER);
    let rule = Path::line(&[at + DVec2::new(0.0, 6.0), at + DVec2::new(COLUMN, 6.0)]);
    vec![
        Text::new(words.to_uppercase(), at + DVec2::new(0.0, 4.7), style).into(),
        Shape::drawn(rule, UMBER.faded(0.6), 0.1).into(),
    ]
}

fn row_items(row: &Row, at: DVec2, cabinet: &mut Cabinet, sheet: &Sheet) -> Vec<Item> {
    let mut items = sample(&row.sample, at + DVec2::new(0.0, row.height() / 2.0), cabinet, sheet);
    let figure = Text::new(&*row.figure, at + DVec2::new(COLUMN, 3.3), small()).anchored(Anchor::End);
    let room = COLUMN - INDENT - lettering::width(&row.figure, &small()) - 2.0;
    let mut x = INDENT;
    if !row.code.is_empty() {
        let style = small().strong();
        items.push(Text::new(&*row.code, at + DVec2::new(x, 3.3), style).into());
        x += lettering::width(&row.code, &style).max(5.6) + 1.2;
    }
    let words = lettering::fitted(&row.words, &small(), room - (x - INDENT));
    items.push(Text::new(words, at + DVec2::new(x, 3.3), small()).into());
    if !row.latin.is_empty() {
        let style = Style::plain(2.0).italic().ink(UMBER);
        let words = lettering::fitted(&row.latin, &style, COLUMN - x);
        items.push(Text::new(words, at + DVec2::new(x, 6.1), style).into());
    }
    items.push(figure.into());
    items
}

/// A sample whose middle left is at `at`.
fn sample(sample: &Sample, at: DVec2, cabinet: &mut Cabinet, sheet: &Sheet) -> Vec<Item> {
    let middle = at + DVec2::new(SWATCH.x / 2.0, 0.0);
    match sample {
        Sample::Plant(symbol, ink) => {
            let radius = if matches!(symbol, PlantSymbol::Shrub | PlantSymbol::Flower) { 1.5 } else { 2.4 };
            let (symbol, scale) = cabinet.crown(*symbol, *ink, radius, 1, 0.0);
            vec![Use { symbol, at: middle, scale, turn: 0.0, title: None }.into()]
        }
        Sample::Object(category, ink) => {
            let size = if category == "bench" { DVec2::new(4.0, 1.4) } else { DVec2::splat(2.6) };
            Piece::new(middle, size, 0.0, *ink).draw(category, &Area::empty())
        }
        Sample::Cover(material) => swatch(at, material, false, sheet),
        Sample::Solid(material) => swatch(at, material, true, sheet),
    }
}

/// A piece of a surface or solid whose middle left is at `at`: ten metres of it, whatever the plan's scale.
fn swatch(at: DVec2, material: &Material, solid: bool, sheet: &Sheet) -> Vec<Item> {
    let corner = at - DVec2::new(0.0, SWATCH.y / 2.0);
    let Some(swatch) = Polygon::rectangle(corner, corner + SWATCH) else { return Vec::new() };
    let (area, id) = (Area::from(swatch), format!("legend {}", material.name));
    let (sheet, metre) = (Sheet { window: area.bounds(), ..sheet.clone() }, SWATCH.x / 10.0);
    if solid {
        return solids::body(&Ground::new(&area, sheet.window, material, metre, &id), material, None, &sheet);
    }
    let mut items = ground::surface(&area, material, metre, &sheet, &id);
    items.push(Shape::drawn(Path::area(&area), SEPIA.faded(0.35), 0.08).into());
    items
}

fn plants<'a>(plants: impl Iterator<Item = &'a Plant>) -> Vec<Row> {
    let mut species: BTreeMap<(&str, &str, &str), (usize, &Plant)> = BTreeMap::new();
    for plant in plants {
        let name = if plant.common_name.is_empty() { &plant.category } else { &plant.common_name };
        species.entry((name, &plant.species, &plant.code)).or_insert((0, plant)).0 += 1;
    }
    let mut rows: Vec<_> = species.into_iter().collect();
    rows.sort_by(|a, b| b.1.0.cmp(&a.1.0).then(a.0.cmp(&b.0)));
    let row = |((words, latin, code), (count, plant)): ((&str, &str, &str), (usize, &Plant))| Row {
        sample: Sample::Plant(plant.symbol, Ink::of(plant.color)),
        code: code.into(),
        words: if words.is_empty() { "Unnamed".into() } else { words.into() },
        latin: latin.into(),
        figure: thousands(count),
    };
    rows.into_iter().map(row).collect()
}

fn covers(scene: &Scene, part: &Part) -> Vec<Row> {
    let mut found: BTreeMap<&str, (f64, &Arc<Material>)> = BTreeMap::new();
    for cover in &scene.covers {
        let area = part.of(&cover.area).area();
        if area > 0.0 {
            found.entry(&cover.material.label).or_insert((0.0, &cover.material)).0 += area;
        }
    }
    let rows = found.into_iter().map(|(label, (area, material))| (label, area, material, false));
    measured(rows.collect(), Sample::Cover)
}

fn solid_rows(scene: &Scene, part: &Part) -> Vec<Row> {
    let mut found: BTreeMap<&str, (f64, &Arc<Material>, bool)> = BTreeMap::new();
    for solid in &scene.solids {
        let (long, footprint) = (Strip::of(&solid.material).is_some(), part.of(&solid.footprint));
        if footprint.is_empty() {
            continue;
        }
        let amount = if long { strip_length(&footprint) } else { footprint.area() };
        found.entry(&solid.material.label).or_insert((0.0, &solid.material, long)).0 += amount;
    }
    measured(found.into_iter().map(|(label, (amount, m, long))| (label, amount, m, long)).collect(), Sample::Solid)
}

/// Rows with amounts, large ones first; lengths where the flag says so.
fn measured(mut found: Vec<(&str, f64, &Arc<Material>, bool)>, sample: impl Fn(Arc<Material>) -> Sample) -> Vec<Row> {
    found.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.cmp(b.0)));
    let row = |(label, amount, material, long): (&str, f64, &Arc<Material>, bool)| Row {
        sample: sample(material.clone()),
        code: String::new(),
        words: label.into(),
        latin: String::new(),
        figure: if long { format!("{} m", thousands(amount.round() as usize)) } else { area_words(amount) },
    };
    found.into_iter().map(row).collect()
}

fn objects<'a>(objects: impl Iterator<Item = &'a Object>) -> Vec<Row> {
    let mut found: BTreeMap<&str, (usize, &Object)> = BTreeMap::new();
    for object in objects {
        found.entry(&object.label).or_insert((0, object)).0 += 1;
    }
    let row = |(label, (count, object)): (&str, (usize, &Object))| Row {
        sample: Sample::Object(object.category.to_string(), Ink::of(object.color)),
        code: String::new(),
        words: label.into(),
        latin: String::new(),
        figure: thousands(count),
    };
    found.into_iter().map(row).collect()
}

/// Columns of the legend's width that fit side by side into a panel.
pub fn columns(panel: Bounds) -> Vec<Bounds> {
    let count = ((panel.size().x + GUTTER) / (COLUMN + GUTTER)).floor() as usize;
    let column = |i: usize| {
        let x = panel.min.x + i as f64 * (COLUMN + GUTTER);
        Bounds { min: DVec2::new(x, panel.min.y), max: DVec2::new(x + COLUMN, panel.max.y) }
    };
    (0..count).map(column).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_has_no_room_is_counted() {
        let row = Row {
            sample: Sample::Plant(PlantSymbol::Broadleaf, SEPIA),
            code: String::new(),
            words: "Oak".into(),
            latin: String::new(),
            figure: "1".into(),
        };
        let mut sections = vec![Section { title: PLANTS, rows: vec![row; 40], more: 0 }];
        let column = Bounds { min: DVec2::ZERO, max: DVec2::new(COLUMN, 100.0) };
        while flow(&sections, &[column]).is_none() {
            shorten(&mut sections);
        }
        assert!(sections[0].more > 0);
        assert_eq!(sections[0].rows.len() + sections[0].more, 40);
    }
}
