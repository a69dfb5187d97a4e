//! The several appearances of one type: slight, fixed variations, so that seven adult birches are seven trees.

use crate::element::{Entry, Variant};
use crate::seed::Seed;

/// One appearance of a type: what it changes against the type's own figures.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Appearance {
    /// Which, from 0.
    pub index: u32,
    /// More were asked for than there are: `index` started again from 0.
    pub wrapped: bool,
    /// Factor of the height, 0.9 to 1.1.
    pub height: f64,
    /// Factor of the crown's radius, 0.9 to 1.1.
    pub crown: f64,
    /// Length of the crown's longer axis on the plan over its radius, 0.88 to 1.12.
    pub aspect: f64,
    /// Seed of its finer shape: equal for equal appearances.
    pub seed: Seed,
}

/// Steps of the three-dimensional golden-ratio sequence (Roberts 2018): successive points keep far apart.
const STEPS: [f64; 3] = [0.819_172_513_396_164_4, 0.671_043_606_703_789_2, 0.549_700_477_901_970_3];

impl Entry {
    /// The appearance number `instance` of one of its types; a type with a single one has it unchanged.
    pub fn appearance(&self, variant: &Variant, instance: u32) -> Appearance {
        let index = instance % variant.appearances.max(1);
        let family = Seed(0).named(&self.id).named(&variant.name);
        let [height, crown, aspect] = if variant.appearances > 1 { spread(family, index) } else { [0.0; 3] };
        Appearance {
            index,
            wrapped: instance >= variant.appearances,
            height: 1.0 + 0.1 * height,
            crown: 1.0 + 0.1 * crown,
            aspect: 1.0 + 0.12 * aspect,
            seed: family.child(u64::from(index)),
        }
    }
}

/// Point number `index` of an evenly spread sequence in the cube from −1 to 1, started anywhere.
fn spread(family: Seed, index: u32) -> [f64; 3] {
    let mut start = family.draw("appearance");
    STEPS.map(|step| {
        let turns = start.unit() + step * f64::from(index);
        2.0 * (turns - turns.floor()) - 1.0
    })
}
