//! Which species a plant is: ten for the whole landscape, a few of them in each lot, one of those dominant.
//!
//! Niese et al. 2022, §5.4. The landscape's species come from the palette by the run's seed, a lot's from the
//! landscape's by the lot's seed, and a plant's from the lot's by its own: one plant more changes no other. Trees and
//! shrubs (whatever is no tree) are chosen apart, and each kind has a dominant species of its own.

use crate::element::{Entry, Kind};
use crate::seed::Seed;
use smallvec::SmallVec;

/// How a lot is planted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Structure {
    /// The share of trees among the plants, the rest being shrubs (ρ).
    pub tree_ratio: f64,
    /// The share of the dominant species among the trees, and among the shrubs (θ).
    pub diversity: f64,
    /// How many species a lot has (λ).
    pub species_count: usize,
    /// How many the whole landscape has (n).
    pub landscape_species: usize,
}

/// Whose choice it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Seeds {
    /// The run's: the landscape's species.
    pub run: Seed,
    /// The lot's: its species, and the dominant ones.
    pub lot: Seed,
    /// The plant's.
    pub plant: Seed,
}

/// Species to choose from, trees apart from shrubs.
#[derive(Clone, Debug, Default)]
pub struct Stock<'a> {
    /// Trees.
    pub trees: SmallVec<[&'a Entry; 16]>,
    /// Shrubs, hedge plants and flowers.
    pub shrubs: SmallVec<[&'a Entry; 16]>,
}

impl Default for Structure {
    fn default() -> Structure {
        Structure { tree_ratio: 0.8, diversity: 0.5, species_count: 4, landscape_species: 10 }
    }
}

/// The species of one plant; `None` where the palette is empty.
///
/// Cost: n log n in the species of the palette.
pub fn choose<'a>(palette: &Stock<'a>, structure: &Structure, seeds: Seeds) -> Option<&'a Entry> {
    let landscape = landscape(palette, structure, seeds.run);
    of_lot(&landscape, structure, seeds.lot).one(structure, seeds.plant)
}

/// The landscape's species (n): trees and shrubs in the proportion of the palette.
pub fn landscape<'a>(palette: &Stock<'a>, structure: &Structure, run: Seed) -> Stock<'a> {
    let share = palette.trees.len() as f64 / palette.len().max(1) as f64;
    palette.part(structure.landscape_species, share, run.named("landscape"))
}

/// The lot's species (λ), the dominant ones first: trees and shrubs in the proportion of the plants (ρ), but at least
/// one of each kind that is planted.
pub fn of_lot<'a>(landscape: &Stock<'a>, structure: &Structure, lot: Seed) -> Stock<'a> {
    landscape.part(structure.species_count, structure.tree_ratio, lot.named("species"))
}

impl<'a> Stock<'a> {
    /// How many species.
    pub fn len(&self) -> usize {
        self.trees.len() + self.shrubs.len()
    }

    /// Whether there is none.
    pub fn is_empty(&self) -> bool {
        self.len() == 0
    }

    /// So many of each kind as the share of trees asks, drawn without preference; a kind there is none of leaves its
    /// share to the other.
    fn part(&self, count: usize, share: f64, seed: Seed) -> Stock<'a> {
        let share = match (self.trees.is_empty(), self.shrubs.is_empty()) {
            (true, _) => 0.0,
            (_, true) => 1.0,
            _ => share,
        };
        let trees = (count as f64 * share).round() as usize;
        let trees = trees.max(usize::from(share > 0.0));
        let shrubs = count.saturating_sub(trees).max(usize::from(share < 1.0));
        Stock { trees: drawn(&self.trees, trees, seed), shrubs: drawn(&self.shrubs, shrubs, seed) }
    }

    /// One plant of a lot: a tree or a shrub (ρ), the dominant one or another (θ).
    fn one(&self, structure: &Structure, plant: Seed) -> Option<&'a Entry> {
        let mut random = plant.draw("species");
        let (tree, dominant, other) = (random.unit(), random.unit(), random.bits());
        let (wanted, instead) = match tree < structure.tree_ratio {
            true => (&self.trees, &self.shrubs),
            false => (&self.shrubs, &self.trees),
        };
        let kind = if wanted.is_empty() { instead } else { wanted };
        let (first, others) = kind.split_first()?;
        if dominant < structure.diversity || others.is_empty() {
            return Some(first);
        }
        let index = (u128::from(other) * others.len() as u128) >> 64;
        Some(others[index as usize])
    }
}

impl<'a> FromIterator<&'a Entry> for Stock<'a> {
    /// Trees and shrubs apart, each in order and once.
    fn from_iter<I: IntoIterator<Item = &'a Entry>>(entries: I) -> Stock<'a> {
        let mut stock = Stock::default();
        for entry in entries {
            let kind = if entry.kind == Kind::Tree { &mut stock.trees } else { &mut stock.shrubs };
            if !kind.iter().any(|known| known.id == entry.id) {
                kind.push(entry);
            }
        }
        stock
    }
}

/// The first of the species in an order of the seed's. A species keeps its rank whatever others there are, so a longer
/// palette or count only adds.
fn drawn<'a>(from: &[&'a Entry], count: usize, seed: Seed) -> SmallVec<[&'a Entry; 16]> {
    let mut ranked: SmallVec<[(u64, &Entry); 16]> =
        from.iter().map(|entry| (seed.named(&entry.id).random().bits(), *entry)).collect();
    ranked.sort_by(|a, b| a.0.cmp(&b.0).then_with(|| a.1.id.cmp(&b.1.id)));
    ranked.into_iter().take(count).map(|(_, entry)| entry).collect()
}
