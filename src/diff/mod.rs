//! Two results side by side: which plants came, went, moved or changed, by lot; areas of grounds, counts of symbols and
//! totals.
//!
//! In: two [`Side`]s, of runs, of written plants or of reports. Out: a [`Difference`], plain values for text and JSON.

mod plants;
mod side;

pub use plants::{Change, LotDifference, Stand, compare_plants};
pub use side::Side;

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

/// What differs; equal figures are left out.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct Difference {
    /// Plants, by lot; those of the layout under the empty name.
    pub lots: BTreeMap<String, LotDifference>,
    /// Areas of ground covers as they lie, m², by lot and material; under the empty lot where lots are not known.
    pub grounds: BTreeMap<String, BTreeMap<String, Pair>>,
    /// Shapes by symbol.
    pub symbols: BTreeMap<String, Pair>,
    /// Plants by species.
    pub species: BTreeMap<String, Pair>,
    /// Totals: plants, crown area, areas and what rules reported.
    pub totals: BTreeMap<String, Pair>,
}

impl Difference {
    /// What differs between two sides; what is known of one side alone is not compared.
    ///
    /// Cost: n log n in the plants.
    pub fn between(a: &Side, b: &Side) -> Difference {
        let both = a.plants.as_ref().zip(b.plants.as_ref());
        let lots: BTreeSet<&String> = a.grounds.keys().chain(b.grounds.keys()).collect();
        let ground = |lot: &&String| {
            let of = |side: &Side| side.grounds.get(*lot).cloned().unwrap_or_default();
            (lot.to_string(), pairs(&of(a), &of(b)))
        };
        Difference {
            lots: both.map(|(a, b)| compare_plants(a, b)).unwrap_or_default(),
            grounds: lots.iter().map(ground).filter(|(_, pairs)| !pairs.is_empty()).collect(),
            symbols: pairs(&a.symbols, &b.symbols),
            species: pairs(&a.species, &b.species),
            totals: pairs(&a.totals, &b.totals),
        }
    }

    /// Whether both are the same.
    pub fn is_empty(&self) -> bool {
        *self == Difference::default()
    }
}

/// The figures that differ by more than rounding.
fn pairs(a: &BTreeMap<String, f64>, b: &BTreeMap<String, f64>) -> BTreeMap<String, Pair> {
    let names: BTreeSet<&String> = a.keys().chain(b.keys()).collect();
    let figure = |side: &BTreeMap<String, f64>, name: &String| side.get(name).copied().unwrap_or(0.0);
    let all = names.into_iter().map(|name| (name.clone(), Pair { a: figure(a, name), b: figure(b, name) }));
    all.filter(|(_, pair)| !same(pair.a, pair.b)).collect()
}

/// Equal to a millionth, as reports write them.
fn same(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * a.abs().max(b.abs()).max(1.0)
}
