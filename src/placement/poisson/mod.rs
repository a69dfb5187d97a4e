//! Disks at random until no more fit: maximal Poisson-disk sampling with radii of each plant's own.
//!
//! In: where centres may lie, the radii, a count or none, a seed. Out: disks that nowhere overlap. Niese et al. 2022,
//! §5.3; the way of splitting what is left follows Ebeida et al. 2012. Knows nothing of strategies.
//!
//! Squares cover all that is free and only shrink: one is given up when a single disk or a single condition excludes
//! it wholly. Darts fall into squares; what is left of them is split, and darts fall again, until no square is left.
//! Then no place is left where the least radius fits. At first a dart brings its radius along and is refused when that
//! is too large. In smaller squares a gap that takes only small disks would refuse for ever: there the radius comes
//! from the part of the distribution that fits, as if darts had been thrown at the very place until one landed.

mod capacity;
mod darts;
mod equals;
mod ground;
mod lattice;
mod window;

pub use ground::Ground;

use crate::placement::{Disk, PlacementError, Radii};
use crate::seed::Seed;
use capacity::Capacity;
use darts::Darts;
use lattice::Lattice;

/// The least radius may be this many times smaller than the greatest.
const MOST_RATIO: f64 = 400.0;

/// Disks on the ground, each radius from `radii`: `wanted` of them, or until none fits.
///
/// Where `wanted` are too many, there are fewer. Costs time and memory in proportion to the area and its edges measured
/// in least radii.
pub fn fill(ground: &Ground, radii: &Radii, wanted: Option<usize>, seed: Seed) -> Result<Vec<Disk>, PlacementError> {
    let lattice = lattice(ground, radii, wanted)?;
    Ok(lattice.map_or(Vec::new(), |lattice| Darts::new(ground, radii, lattice, seed).throw(wanted)))
}

/// Places for `count` disks, each drawn as if it were alone; none where there is none.
pub fn alone(ground: &Ground, radii: &Radii, count: usize, seed: Seed) -> Result<Vec<Disk>, PlacementError> {
    let lattice = lattice(ground, radii, Some(1))?;
    let one = |(lattice, index): (&Lattice, u64)| {
        Darts::new(ground, radii, lattice.clone(), seed.child(index)).throw(Some(1))
    };
    Ok(lattice.iter().cycle().zip(0..count as u64).flat_map(one).collect())
}

/// An empty lattice, if there is a place for anything.
fn lattice(ground: &Ground, radii: &Radii, wanted: Option<usize>) -> Result<Option<Lattice>, PlacementError> {
    radii.check()?;
    if radii.largest() > MOST_RATIO * radii.smallest() {
        let allowed = "a 400th of the greatest radius or more";
        return Err(PlacementError::Value { parameter: "radius_min", found: radii.smallest(), allowed });
    }
    if ground.bounds().is_empty() || wanted == Some(0) {
        return Ok(None);
    }
    let capacity = Capacity::of(ground, radii);
    let grain = capacity.grain(radii, wanted)?;
    Ok(Some(Lattice::new(ground, radii, capacity.area(), grain)))
}
