//! Plants of two results told apart, lot by lot.
//!
//! A plant is the same where its id is, which is the path of its shape; what is left over is the same where it stands on
//! the same spot. All else has come or gone.

use crate::scene::Plant;
use glam::DVec2;
use serde::Serialize;
use std::collections::{BTreeMap, BTreeSet};

/// So far (metres) a plant may stand from where it stood and has not moved: files round to a tenth of a millimetre.
const STILL: f64 = 1e-3;

/// A plant of one side.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Stand {
    /// Its id.
    pub id: String,
    /// Its species, or its category.
    pub species: String,
    /// Its age class or form.
    pub class: String,
    /// Metres in the plan: east, north.
    pub at: [f64; 2],
    /// Metres.
    pub height: f64,
    /// Metres.
    pub crown_radius: f64,
}

/// A plant of both sides that differs.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Change {
    /// On the first side.
    pub a: Stand,
    /// On the second side.
    pub b: Stand,
    /// How far it moved, metres; 0 where it stayed.
    pub moved: f64,
    /// Whether species, class or size differ.
    pub altered: bool,
}

/// What became of the plants of a lot.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
pub struct LotDifference {
    /// Those that only the second side has.
    pub added: Vec<Stand>,
    /// Those that only the first side has.
    pub removed: Vec<Stand>,
    /// Those that moved, or are of another species or size.
    pub changed: Vec<Change>,
    /// How many are the same.
    pub same: usize,
}

impl Stand {
    fn of(plant: &Plant) -> Stand {
        let species = if plant.species.is_empty() { &plant.category } else { &plant.species };
        Stand {
            id: plant.origin.id.to_string(),
            species: species.to_string(),
            class: plant.age_class.to_string(),
            at: plant.position.to_array().map(rounded),
            height: rounded(plant.height),
            crown_radius: rounded(plant.crown_radius),
        }
    }

    fn is_alike(&self, other: &Stand) -> bool {
        let sizes = [(self.height, other.height), (self.crown_radius, other.crown_radius)];
        let same = sizes.iter().all(|(a, b)| (a - b).abs() <= STILL);
        same && (&self.species, &self.class) == (&other.species, &other.class)
    }
}

/// The lots whose plants differ. Cost: n log n.
pub fn compare_plants(a: &[Plant], b: &[Plant]) -> BTreeMap<String, LotDifference> {
    let (mut of_a, mut of_b) = (by_lot(a), by_lot(b));
    let names: BTreeSet<String> = of_a.keys().chain(of_b.keys()).cloned().collect();
    let lot = |name: String| {
        let [a, b] = [&mut of_a, &mut of_b].map(|side| side.remove(&name).unwrap_or_default());
        (name, lot_difference(a, b))
    };
    names.into_iter().map(lot).filter(|(_, lot)| !lot.is_empty()).collect()
}

impl LotDifference {
    fn is_empty(&self) -> bool {
        self.added.is_empty() && self.removed.is_empty() && self.changed.is_empty()
    }
}

fn by_lot(plants: &[Plant]) -> BTreeMap<String, Vec<Stand>> {
    let mut lots: BTreeMap<String, Vec<Stand>> = BTreeMap::new();
    plants.iter().for_each(|plant| lots.entry(plant.origin.lot.to_string()).or_default().push(Stand::of(plant)));
    lots
}

fn lot_difference(a: Vec<Stand>, b: Vec<Stand>) -> LotDifference {
    let mut difference = LotDifference::default();
    let (pairs, a, b) = matched(a, b, |stand| (!stand.id.is_empty()).then(|| stand.id.clone()));
    pairs.into_iter().for_each(|(a, b)| difference.pair(a, b));
    let (pairs, a, b) = met(a, b);
    pairs.into_iter().for_each(|(a, b)| difference.pair(a, b));
    (difference.removed, difference.added) = (a, b);
    difference
}

impl LotDifference {
    fn pair(&mut self, a: Stand, b: Stand) {
        let distance = DVec2::from(a.at).distance(DVec2::from(b.at));
        let moved = if distance > STILL { rounded(distance) } else { 0.0 };
        let altered = !a.is_alike(&b);
        match altered || moved > 0.0 {
            true => self.changed.push(Change { a, b, moved, altered }),
            false => self.same += 1,
        }
    }
}

/// Pairs with the same key, in order, and what is left over on both sides.
type Matched = (Vec<(Stand, Stand)>, Vec<Stand>, Vec<Stand>);

fn matched<K: Ord>(a: Vec<Stand>, b: Vec<Stand>, key: impl Fn(&Stand) -> Option<K>) -> Matched {
    let mut waiting: BTreeMap<K, Vec<Stand>> = BTreeMap::new();
    let (mut pairs, mut left, mut right) = (Vec::new(), Vec::new(), Vec::new());
    for stand in b.into_iter().rev() {
        match key(&stand) {
            Some(key) => waiting.entry(key).or_default().push(stand),
            None => right.push(stand),
        }
    }
    for stand in a {
        match key(&stand).and_then(|key| waiting.get_mut(&key)?.pop()) {
            Some(other) => pairs.push((stand, other)),
            None => left.push(stand),
        }
    }
    right.extend(waiting.into_values().flatten());
    (pairs, left, right)
}

/// Pairs on the same spot, the nearest of those within reach, and what is left over on both sides.
fn met(a: Vec<Stand>, b: Vec<Stand>) -> Matched {
    let mut bins: BTreeMap<[i64; 2], Vec<usize>> = BTreeMap::new();
    b.iter().enumerate().for_each(|(index, stand)| bins.entry(bin(stand)).or_default().push(index));
    let mut right: Vec<Option<Stand>> = b.into_iter().map(Some).collect();
    let (mut pairs, mut left) = (Vec::new(), Vec::new());
    for stand in a {
        let here = DVec2::from(stand.at);
        let [x, y] = bin(&stand);
        // Two that stand together may lie on both sides of an edge between bins.
        let around = (-1..=1).flat_map(|i| (-1..=1).map(move |j| [x.saturating_add(i), y.saturating_add(j)]));
        let near = around.filter_map(|bin| bins.get(&bin)).flatten().filter_map(|index| {
            let distance = here.distance(DVec2::from(right[*index].as_ref()?.at));
            (distance <= STILL).then_some((distance, *index))
        });
        let nearest = near.min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        match nearest.and_then(|(_, index)| right[index].take()) {
            Some(other) => pairs.push((stand, other)),
            None => left.push(stand),
        }
    }
    (pairs, left, right.into_iter().flatten().collect())
}

/// The square of the plan, as wide as plants count as still, in which a plant stands.
fn bin(stand: &Stand) -> [i64; 2] {
    stand.at.map(|c| (c / STILL).round() as i64)
}

/// To a tenth of a millimetre, as files are written.
fn rounded(metres: f64) -> f64 {
    (metres * 1e4).round() / 1e4
}

#[cfg(test)]
mod tests {
    use super::*;

    fn stand(x: f64) -> Stand {
        let [id, class] = ["", "adult"].map(String::from);
        Stand { id, species: "Tilia cordata".into(), class, at: [x, 5.0], height: 8.0, crown_radius: 2.0 }
    }

    #[test]
    fn a_spot_is_the_same_on_both_sides_of_a_bin() {
        let found = lot_difference(vec![stand(1.00045)], vec![stand(1.00055)]);
        assert!(found.is_empty() && found.same == 1, "{found:?}");
        let found = lot_difference(vec![stand(1.0)], vec![stand(1.0025)]);
        assert_eq!((found.removed.len(), found.added.len()), (1, 1));
    }

    #[test]
    fn the_nearest_spot_is_taken_once() {
        let found = lot_difference(vec![stand(1.0), stand(1.0)], vec![stand(1.0008), stand(1.0)]);
        assert!(found.is_empty() && found.same == 2, "{found:?}");
        let found = lot_difference(vec![stand(1.0), stand(1.0)], vec![stand(1.0)]);
        assert_eq!((found.removed.len(), found.same), (1, 1));
    }
}
