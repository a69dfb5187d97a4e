//! The cabinet of plant symbols: drawn once per kind, colour, size and variant, placed many times.
//!
//! Light comes from the north-west of the paper, so symbols are not turned when placed; their irregularity comes
//! from a handful of variants, chosen by the plant's own seed. Sizes are rounded to steps of a fifth and the rest is
//! scaled, so line widths stay as they should be. How much is drawn depends on the size on paper.

mod crown;
mod outline;
mod shaped;

pub use outline::LEE;

use crate::export::plan::drawing::{Shape, Symbol};
use crate::export::plan::ink::{Ink, SHADOW};
use crate::export::plan::path::Path;
use crate::scene::PlantSymbol;
use crate::seed::{Random, Seed};
use glam::DVec2;
use std::collections::BTreeMap;

/// Ratio of one drawn size to the next.
const STEP: f64 = 1.2;
/// Crowns below this diameter on paper (mm) are dots.
const DOT: f64 = 0.8;
/// Crowns from this diameter on show everything.
const FULL: f64 = 4.0;

/// How much of a symbol is drawn.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Level {
    /// A disc.
    Dot,
    /// Outline and shade.
    Outline,
    /// Outline, shade, light, branches and leaves.
    Full,
}

/// A pencil set for one symbol: radius in millimetres, colours, detail and chance.
struct Pencil {
    radius: f64,
    ink: Ink,
    level: Level,
    /// The plant's turn on paper, radians clockwise: for clipped forms.
    turn: f64,
    random: Random,
}

#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
struct Key {
    symbol: u8,
    ink: Ink,
    size: i32,
    variant: u64,
    /// Whole degrees clockwise; 0 for what looks the same from all sides.
    turn: i32,
}

/// Half the side of a block whose crown has the radius 1.
const BLOCK: f64 = 0.92;

/// All symbols drawn so far.
pub struct Cabinet {
    symbols: Vec<Symbol>,
    known: BTreeMap<Key, usize>,
}

impl Default for Cabinet {
    fn default() -> Cabinet {
        Cabinet::new()
    }
}

impl Cabinet {
    /// A cabinet with nothing but the shadows.
    pub fn new() -> Cabinet {
        let disc = Shape::filled(Path::circle(DVec2::ZERO, 1.0), SHADOW);
        let shadow = Symbol { id: "shadow".into(), shapes: vec![disc] };
        let block = Path::rectangle(DVec2::splat(-BLOCK), DVec2::splat(2.0 * BLOCK));
        let block = Symbol { id: "shadow-block".into(), shapes: vec![Shape::filled(block, SHADOW)] };
        Cabinet { symbols: vec![shadow, block], known: BTreeMap::new() }
    }

    /// What casts the shadow of a crown of radius 1: a disc, or the block of what is clipped to a box.
    pub fn shadow(&self, symbol: PlantSymbol) -> usize {
        usize::from(symbol == PlantSymbol::Box)
    }

    /// The symbol for a crown of `radius` mm, turned by so many degrees clockwise on paper, and the enlargement that
    /// makes it exact.
    pub fn crown(&mut self, symbol: PlantSymbol, ink: Ink, radius: f64, seed: u64, turn: f64) -> (usize, f64) {
        let size = (libm::log(radius.max(1e-3)) / libm::log(STEP)).floor() as i32;
        let drawn = libm::pow(STEP, f64::from(size) + 0.5);
        let level = level(drawn * 2.0);
        let variant = Seed(seed).draw("plan variant").below(variants(symbol, level));
        let turn = if is_square(symbol) { turn.rem_euclid(90.0).round() } else { 0.0 };
        let key = Key { symbol: symbol as u8, ink, size, variant, turn: turn as i32 };
        let index = *self.known.entry(key).or_insert_with(|| {
            let random = Seed(variant).child(key.symbol.into()).draw("plan symbol");
            let pencil = Pencil { radius: drawn, ink, level, turn: turn.to_radians(), random };
            let shapes = pencil.draw(symbol).into_iter().map(|s| Shape { path: s.path.coarse_to(0.01), ..s }).collect();
            self.symbols.push(Symbol { id: format!("plant-{}", self.symbols.len()), shapes });
            self.symbols.len() - 1
        });
        (index, radius / drawn)
    }

    /// The symbols, in order of their numbers.
    pub fn into_symbols(self) -> Vec<Symbol> {
        self.symbols
    }
}

/// Whether a symbol shows how the plant is turned: clipped to a box, or to a cone of few facets.
fn is_square(symbol: PlantSymbol) -> bool {
    matches!(symbol, PlantSymbol::Box | PlantSymbol::Cone)
}

/// How much to draw at a diameter on paper.
fn level(diameter: f64) -> Level {
    match diameter {
        d if d < DOT => Level::Dot,
        d if d < FULL => Level::Outline,
        _ => Level::Full,
    }
}

/// How many different drawings of one symbol there are.
fn variants(symbol: PlantSymbol, level: Level) -> u64 {
    let built = matches!(symbol, PlantSymbol::Box | PlantSymbol::Cone | PlantSymbol::Clipped | PlantSymbol::Flower);
    match level {
        Level::Dot => 1,
        _ if built => 1,
        Level::Outline => 5,
        Level::Full => 7,
    }
}

impl Pencil {
    fn draw(mut self, symbol: PlantSymbol) -> Vec<Shape> {
        match symbol {
            _ if self.level == Level::Dot => self.dot(),
            PlantSymbol::Broadleaf => self.broadleaf(),
            PlantSymbol::Feathery => self.feathery(),
            PlantSymbol::Conifer => self.conifer(),
            PlantSymbol::Palm => self.palm(),
            PlantSymbol::Clipped => self.clipped(),
            PlantSymbol::Box => self.block(),
            PlantSymbol::Cone => self.cone(),
            PlantSymbol::Shrub => self.shrub(),
            PlantSymbol::Flower => self.flower(),
        }
    }

    /// A disc, a little darker than the crown: small things need contrast.
    fn dot(&self) -> Vec<Shape> {
        vec![Shape::filled(Path::circle(DVec2::ZERO, self.radius.max(0.06)), self.ink.darker(0.12))]
    }

    fn is_full(&self) -> bool {
        self.level == Level::Full
    }

    /// How many scallops or tips of `size` mm go round the rim.
    fn teeth(&self, size: f64, least: usize, most: usize) -> usize {
        ((std::f64::consts::TAU * self.radius / size) as usize).clamp(least, most)
    }

    /// The colour of outlines and branches.
    fn line(&self) -> Ink {
        Ink { alpha: 255, ..self.ink.darker(0.52) }
    }

    /// The width of outlines: finer on small symbols.
    fn width(&self) -> f64 {
        (0.05 + 0.02 * self.radius).clamp(0.06, 0.16)
    }

    /// The fill of a crown: lets what stands below shine through.
    fn wash(&self) -> Ink {
        self.ink.faded(0.9)
    }
}
