//! Growth of plants that nobody measured: from type to type, evenly by age.
//!
//! A plant's `young`, `medium` and `adult` are taken as the truth; between them every size changes evenly, and never
//! falls. Before the first a seedling grows up to it; behind the last nothing is known, and its sizes are held.

use crate::element::{Entry, PlantFigures};
use smallvec::SmallVec;

/// The share of the youngest type's size that a plant has at age 0: what nurseries sell.
const PLANTED: f64 = 0.1;

/// The types that are ages; clipped forms and the like are none.
const AGES: [&str; 3] = ["young", "medium", "adult"];

/// A plant's figures at increasing ages, each at least as large as those before.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Stages(SmallVec<[PlantFigures; 3]>);

impl Stages {
    /// The age classes of a plant, else its usual type alone; objects have none.
    pub fn of(entry: &Entry) -> Stages {
        let classes = entry.variants.iter().filter(|variant| AGES.contains(&&*variant.name));
        let mut stages: SmallVec<[PlantFigures; 3]> = classes.filter_map(|variant| variant.plant).collect();
        if stages.is_empty() {
            stages.extend(entry.usual().plant);
        }
        stages.sort_by(|a, b| a.age.total_cmp(&b.age));
        for index in 1..stages.len() {
            stages[index] = at_least(stages[index], stages[index - 1]);
        }
        Stages(stages)
    }

    /// The figures at an age; `None` where there are no stages.
    pub fn at(&self, age: f64) -> Option<PlantFigures> {
        let after = self.0.iter().position(|stage| stage.age >= age);
        let Some(index) = after else { return self.0.last().copied() };
        let next = self.0[index];
        let before = match index {
            0 => scaled(next, PLANTED),
            _ => self.0[index - 1],
        };
        let years = next.age - before.age;
        let share = if years > 0.0 { (age - before.age) / years } else { 1.0 };
        Some(between(before, next, share))
    }

    /// The age behind which nothing is known.
    pub fn last_age(&self) -> f64 {
        self.0.last().map_or(0.0, |stage| stage.age)
    }
}

fn at_least(figures: PlantFigures, least: PlantFigures) -> PlantFigures {
    PlantFigures {
        age: figures.age,
        height: figures.height.max(least.height),
        crown_radius: figures.crown_radius.max(least.crown_radius),
        spacing_radius: figures.spacing_radius.max(least.spacing_radius),
        trunk_diameter: figures.trunk_diameter.max(least.trunk_diameter),
    }
}

/// The same at age 0, smaller.
fn scaled(figures: PlantFigures, share: f64) -> PlantFigures {
    PlantFigures {
        age: 0.0,
        height: figures.height * share,
        crown_radius: figures.crown_radius * share,
        spacing_radius: figures.spacing_radius * share,
        trunk_diameter: figures.trunk_diameter * share,
    }
}

fn between(a: PlantFigures, b: PlantFigures, share: f64) -> PlantFigures {
    let mix = |a: f64, b: f64| a + (b - a) * share;
    PlantFigures {
        age: mix(a.age, b.age),
        height: mix(a.height, b.height),
        crown_radius: mix(a.crown_radius, b.crown_radius),
        spacing_radius: mix(a.spacing_radius, b.spacing_radius),
        trunk_diameter: mix(a.trunk_diameter, b.trunk_diameter),
    }
}
