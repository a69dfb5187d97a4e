//! What strategies share whose places are given by lines and lattices: radii, neighbours, the amount.
//!
//! In: places in order. Out: those where the site allows a disk that overlaps none before it.

use crate::placement::ready::Ready;
use crate::placement::{Amount, Disk, Field, MOST_POINTS, Placed, PlacementError, Radii, Site, Spot};
use crate::seed::Seed;
use glam::DVec2;
use std::collections::BTreeMap;

/// Disks that overlap by less than this (metres) only touch.
const TOUCH: f64 = 1e-6;

/// A place on offer.
#[derive(Clone, Copy)]
pub(super) struct Place {
    /// What its radius depends on, with the seed: whatever else there is, it keeps it.
    pub number: u64,
    pub position: DVec2,
    pub direction: DVec2,
    pub cluster: u32,
}

/// The places taken so far.
pub(super) struct Places<'a> {
    site: &'a Site,
    ready: Ready<'a>,
    radii: &'a Radii,
    seed: Seed,
    /// No radius is larger: half of what places are apart.
    most: f64,
    spots: Vec<Spot>,
    near: Near,
}

impl<'a> Places<'a> {
    /// None yet, for places that are from `least` to `most` metres apart. Refuses a radius of all that does not fit
    /// between them; where radii vary or are drawn, they are held to half of what is there.
    pub fn new(
        site: &'a Site,
        radii: &'a Radii,
        amount: &Amount,
        [least, most]: [f64; 2],
        seed: Seed,
    ) -> Result<Self, PlacementError> {
        radii.check()?;
        amount.check()?;
        let constant = matches!(radii.mean, Field::Constant(_)) && radii.deviation == 0.0;
        if constant && radii.largest() > 0.5 * least + TOUCH {
            let allowed = "at most half of the way to the next place, so that disks do not overlap";
            return Err(PlacementError::Value { parameter: "radius", found: radii.largest(), allowed });
        }
        let near = Near::new(most);
        Ok(Places { site, ready: Ready::of(site), radii, seed, most: 0.5 * most, spots: Vec::new(), near })
    }

    /// Whether the rim of the site's area is no nearer to a place than `distance` metres.
    pub fn is_inset(&self, p: DVec2, distance: f64) -> bool {
        self.ready.is_inset(p, distance)
    }

    /// Takes a place whose neighbours are known to be far enough, if the site allows it.
    pub fn take(&mut self, place: Place) {
        let radius = self.radius(place);
        if self.ready.allows(place.position, radius) {
            self.push(place, radius);
        }
    }

    /// Takes a place with a radius of at most `most` metres, if the site allows it, no disk overlaps, and no spot of
    /// another cluster is nearer than `apart`. Whether it did.
    pub fn take_apart(&mut self, place: Place, most: f64, apart: f64) -> bool {
        let disk = Disk { position: place.position, radius: self.radius(place).min(most) };
        let free = self.near.around(disk.position, apart).all(|index| {
            let other = &self.spots[index];
            let least = disk.radius + other.radius - TOUCH;
            let least = if other.cluster == place.cluster { least } else { least.max(apart) };
            other.position.distance(disk.position) >= least
        });
        let free = free && self.ready.allows(disk.position, disk.radius);
        if free {
            self.near.add(disk.position, self.spots.len());
            self.push(place, disk.radius);
        }
        free
    }

    /// Takes places along a line in turn, each apart from its neighbours: where the line bends, disks shrink to half
    /// the way to the next place.
    pub fn take_run(&mut self, run: &[(DVec2, DVec2)], closed: bool, cluster: u32, apart: impl Fn(DVec2) -> f64) {
        let count = run.len();
        let way = |i: usize, j: usize| if i == j { f64::INFINITY } else { run[i].0.distance(run[j].0) };
        for (i, (position, direction)) in run.iter().copied().enumerate() {
            let before = if i > 0 || closed { way(i, (i + count - 1) % count) } else { f64::INFINITY };
            let after = if i + 1 < count || closed { way(i, (i + 1) % count) } else { f64::INFINITY };
            let number = u64::from(cluster) << 32 | i as u64;
            self.take_apart(Place { number, position, direction, cluster }, 0.5 * before.min(after), apart(position));
        }
    }

    /// Of the places taken those that are wanted, spread evenly over their order, less what the density gives up.
    pub fn finish(self, amount: &Amount) -> Result<Placed, PlacementError> {
        let mut spots = self.spots;
        let wanted = amount.wanted(self.site.area())?.unwrap_or(spots.len());
        let missing = wanted.saturating_sub(spots.len());
        if wanted < spots.len() {
            spots = (0..wanted).map(|i| spots[(2 * i + 1) * spots.len() / (2 * wanted)]).collect();
        }
        amount.thin(&mut spots, self.seed);
        Ok(Placed { spots, missing })
    }

    fn radius(&self, place: Place) -> f64 {
        let mut random = self.seed.named("radius").child(place.number).random();
        self.radii.draw(place.position, &mut random).min(self.most)
    }

    fn push(&mut self, place: Place, radius: f64) {
        let Place { position, direction, cluster, .. } = place;
        self.spots.push(Spot { position, radius, direction, cluster });
    }
}

/// A growing grid of points.
struct Near {
    cell: f64,
    cells: BTreeMap<[i64; 2], Vec<u32>>,
}

impl Near {
    /// Cells as wide as two of the largest disks.
    fn new(cell: f64) -> Near {
        Near { cell, cells: BTreeMap::new() }
    }

    fn add(&mut self, p: DVec2, index: usize) {
        self.cells.entry(self.of(p)).or_default().push(index as u32);
    }

    /// Everything that may lie within `reach`, or so near that disks overlap.
    fn around(&self, p: DVec2, reach: f64) -> impl Iterator<Item = usize> {
        let reach = reach.max(self.cell);
        let (low, high) = (self.of(p - reach), self.of(p + reach));
        let columns = low[0]..=high[0];
        let lists = columns.flat_map(move |x| self.cells.range([x, low[1]]..=[x, high[1]]));
        lists.flat_map(|(_, list)| list.iter().map(|index| *index as usize))
    }

    fn of(&self, p: DVec2) -> [i64; 2] {
        // The conversion saturates: far cells are shared, which costs time and changes nothing.
        (p / self.cell).floor().to_array().map(|c| (c as i64).clamp(-1 << 53, 1 << 53))
    }
}

/// Refuses a length that is not positive and finite.
pub(super) fn positive(parameter: &'static str, found: f64) -> Result<(), PlacementError> {
    let allowed = "a number of metres above 0";
    if found.is_finite() && found > 0.0 { Ok(()) } else { Err(PlacementError::Value { parameter, found, allowed }) }
}

/// Refuses a length that is negative or not finite.
pub(super) fn from_zero(parameter: &'static str, found: f64) -> Result<(), PlacementError> {
    let allowed = "a number of metres from 0 up";
    if found.is_finite() && found >= 0.0 { Ok(()) } else { Err(PlacementError::Value { parameter, found, allowed }) }
}

/// Refuses more places than [`MOST_POINTS`].
pub(super) fn few_enough(count: f64) -> Result<(), PlacementError> {
    if count <= MOST_POINTS as f64 { Ok(()) } else { Err(PlacementError::TooMany(count)) }
}
