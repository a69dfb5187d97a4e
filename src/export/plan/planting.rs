//! Plants on the plan: true to size, small ones below large ones, each with its name; and their codes.

use crate::export::plan::drawing::{Anchor, Item, Layer, Style, Text, Use};
use crate::export::plan::ink::{Ink, PAPER};
use crate::export::plan::labels::Board;
use crate::export::plan::lettering;
use crate::export::plan::sheet::Sheet;
use crate::export::plan::symbol::Cabinet;
use crate::geometry::Bounds;
use crate::scene::{Plant, PlantSymbol};
use crate::text::{counted, number};
use glam::DVec2;
use std::collections::BTreeMap;

/// Font size of codes.
const CODE: f64 = 1.7;
/// Crowns below this radius on paper cast no shadow.
const LEAST_SHADOW: f64 = 0.22;
/// No crown is drawn smaller than this radius: it would vanish from the sheet.
const LEAST_CROWN: f64 = 0.16;

/// The plants in the window, lowest first.
pub struct Planting<'a> {
    drawn: Vec<(&'a Plant, DVec2, f64)>,
}

impl<'a> Planting<'a> {
    /// Finds the plants whose crowns show, and their order.
    pub fn new(plants: &'a [Plant], sheet: &Sheet) -> Planting<'a> {
        let mut drawn: Vec<_> = plants
            .iter()
            .filter(|p| p.position.is_finite())
            .map(|p| (p, sheet.frame.point(p.position), radius(p, sheet)))
            .filter(|(_, at, radius)| sheet.window.grown(*radius).contains(*at))
            .collect();
        drawn.sort_by(|a, b| rank(a.0).cmp(&rank(b.0)).then(a.0.height.total_cmp(&b.0.height)));
        Planting { drawn }
    }

    /// The shadows of all crowns.
    pub fn shadows(&self, cabinet: &Cabinet, sheet: &Sheet) -> Vec<Item> {
        let cast = |(plant, at, radius): &(&Plant, DVec2, f64)| {
            let reach = sheet.frame.length(0.2 * plant.height).min(0.75 * radius).max(0.0);
            let at = *at + DVec2::splat(reach * std::f64::consts::FRAC_1_SQRT_2);
            let symbol = cabinet.shadow(plant.symbol);
            let turn = if symbol == 0 { 0.0 } else { sheet.frame.turn(plant.heading) };
            Use { symbol, at, scale: *radius, turn, title: None }.into()
        };
        self.drawn.iter().filter(|(_, _, radius)| *radius >= LEAST_SHADOW).map(cast).collect()
    }

    /// Two layers: what grows low, and trees.
    pub fn layers(&self, cabinet: &mut Cabinet, sheet: &Sheet) -> [Layer; 2] {
        let (mut low, mut trees) = (Layer::new("shrubs", "Shrubs and flowers"), Layer::new("trees", "Trees"));
        for (plant, at, radius) in &self.drawn {
            let turn = sheet.frame.turn(plant.heading);
            let (symbol, scale) = cabinet.crown(plant.symbol, Ink::of(plant.color), *radius, plant.seed, turn);
            let item = Use { symbol, at: *at, scale, turn: 0.0, title: Some(title(plant)) }.into();
            if rank(plant) < 2 { low.items.push(item) } else { trees.items.push(item) }
        }
        [low, trees]
    }

    /// The plants' codes: in their crowns where they fit, else once for a lot's plants of a kind.
    pub fn codes(&self, board: &mut Board) -> Layer {
        let mut layer = Layer::new("codes", "Plant codes");
        let mut crowded: BTreeMap<(&str, &str), Vec<DVec2>> = BTreeMap::new();
        for (plant, at, radius) in self.drawn.iter().filter(|(p, ..)| !p.code.is_empty()) {
            let width = lettering::width(&plant.code, &style());
            let place = Bounds::of([*at]).grown(width * 0.5);
            if width + 0.8 <= radius * 2.0 && board.take(place) {
                layer.items.push(code(plant.code.to_string(), *at));
            } else {
                crowded.entry((&*plant.origin.lot, &*plant.code)).or_default().push(*at);
            }
        }
        for ((_, words), mut members) in crowded {
            let middle = members.iter().sum::<DVec2>() / members.len() as f64;
            members.sort_by(|a, b| a.distance_squared(middle).total_cmp(&b.distance_squared(middle)));
            let words = if members.len() == 1 { words.to_string() } else { format!("{} {words}", members.len()) };
            let size = DVec2::new(lettering::width(&words, &style()) + 0.8, CODE * 1.1);
            let free =
                members.into_iter().take(24).find(|at| board.take(Bounds::of([*at - size / 2.0, *at + size / 2.0])));
            layer.items.extend(free.map(|at| code(words, at)));
        }
        layer
    }
}

/// The plant's name, kind and sizes in words.
pub fn title(plant: &Plant) -> String {
    let name = match (&*plant.common_name, &*plant.species) {
        ("", "") => plant.category.to_string(),
        ("", species) => species.to_string(),
        (common, "") => common.to_string(),
        (common, species) => format!("{common} ({species})"),
    };
    let age =
        if plant.age > 0.0 { format!(", {}", counted(plant.age.round() as usize, "year")) } else { String::new() };
    let (height, crown) = (number(plant.height, 1), number(plant.crown_radius * 2.0, 1));
    format!("{name}, height {height} m, crown {crown} m{age}{}", if plant.existing { ", existing" } else { "" })
}

fn code(words: String, at: DVec2) -> Item {
    let at = at + DVec2::new(0.0, CODE * 0.34);
    Text::new(words, at, style()).anchored(Anchor::Middle).with_halo(PAPER.faded(0.75), 0.55).into()
}

fn style() -> Style {
    Style::plain(CODE).strong()
}

fn radius(plant: &Plant, sheet: &Sheet) -> f64 {
    let radius = if plant.crown_radius.is_finite() { plant.crown_radius } else { 0.0 };
    sheet.frame.length(radius).max(LEAST_CROWN)
}

/// Flowers lie below shrubs and shrubs below trees.
fn rank(plant: &Plant) -> u8 {
    match (plant.symbol, &*plant.kind) {
        (PlantSymbol::Flower, _) | (_, "flower") => 0,
        (PlantSymbol::Shrub, _) | (_, "shrub" | "hedge") => 1,
        _ => 2,
    }
}
