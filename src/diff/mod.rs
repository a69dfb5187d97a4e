//! Two results side by side: which plants came, went, moved or changed, by lot; areas of grounds, counts of symbols and
//! totals.
//!
//! In: two [`Side`]s, of runs, of written plants or of reports. Out: a [`Difference`], plain values for text and JSON.

mod plants;
mod side;

pub use plants::{Change, LotDifference, Stand, compare_plants};
pub use side::{Figures, Side};

use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// A figure on both sides.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Pair {
    /// On the first side.
    pub a: f64,
    /// On the second side.
    pub b: f64,
}

/// Pairs by name.
pub type Pairs = BTreeMap<String, Pair>;

/// What differs; equal figures are left out.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Plants, by lot; those of the layout under the empty name.
    pub lots: BTreeMap<String, LotDifference>,
    /// Areas of ground covers as they lie, m², by lot and material; under the empty lot where lots are not known.
    pub grounds: BTreeMap<String, Pairs>,
    /// Shapes by symbol.
    pub symbols: Pairs,
    /// Plants by species.
    pub species: Pairs,
    /// What rules reported, summed by key.
    pub reports: Pairs,
    /// Totals: plants, area of their crowns (m²), lots, covers, solids …
    pub totals: Pairs,
}

impl Difference {
    /// What differs between two sides; what is known of one side alone is not compared.
    ///
    /// Cost: n log n in the plants.
    pub fn between(a: &Side, b: &Side) -> Difference {
        let plants = a.plants.as_ref().zip(b.plants.as_ref());
        let known = |a: &Option<Figures>, b: &Option<Figures>| {
            a.as_ref().zip(b.as_ref()).map(|(a, b)| pairs(a, b)).unwrap_or_default()
        };
        let mut totals = pairs(&a.totals, &b.totals);
        totals.retain(|name, _| a.totals.contains_key(name) && b.totals.contains_key(name));
        Difference {
            lots: plants.map(|(a, b)| compare_plants(a, b)).unwrap_or_default(),
            grounds: a.grounds.as_ref().zip(b.grounds.as_ref()).map(|(a, b)| grounds(a, b)).unwrap_or_default(),
            symbols: known(&a.symbols, &b.symbols),
            species: pairs(&a.species, &b.species),
            reports: known(&a.reports, &b.reports),
            totals,
        }
    }

    /// Whether both are the same.
    pub fn is_empty(&self) -> bool {
        *self == Difference::default()
    }
}

/// Areas by lot, or of all lots together where one side does not know them.
fn grounds(a: &BTreeMap<String, Figures>, b: &BTreeMap<String, Figures>) -> BTreeMap<String, Pairs> {
    let whole = |side: &BTreeMap<String, Figures>| side.len() == 1 && side.contains_key("");
    if whole(a) || whole(b) {
        let pairs = pairs(&together(a), &together(b));
        return if pairs.is_empty() { BTreeMap::new() } else { BTreeMap::from([(String::new(), pairs)]) };
    }
    let (lots, none): (BTreeSet<&String>, _) = (a.keys().chain(b.keys()).collect(), Figures::new());
    let lot = |lot: &String| (lot.clone(), pairs(a.get(lot).unwrap_or(&none), b.get(lot).unwrap_or(&none)));
    lots.into_iter().map(lot).filter(|(_, pairs)| !pairs.is_empty()).collect()
}

/// The sums over all lots.
fn together(lots: &BTreeMap<String, Figures>) -> Figures {
    let mut sums = Figures::new();
    lots.values().flatten().for_each(|(name, area)| *sums.entry(name.clone()).or_default() += area);
    sums
}

/// The figures that differ by more than rounding.
fn pairs(a: &Figures, b: &Figures) -> Pairs {
    let names: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    let figure = |side: &Figures, name: &String| side.get(name).copied().unwrap_or(0.0);
    let all = names.into_iter().map(|name| (name.clone(), Pair { a: figure(a, name), b: figure(b, name) }));
    all.filter(|(_, pair)| !same(pair.a, pair.b)).collect()
}

/// Equal to a millionth, as reports write them.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a.abs().max(b.abs()).max(1.0)
}
