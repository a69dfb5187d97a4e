//! `plant`: a plant by species and age, or by the structure of a planting.

use crate::element::{Catalogue, Entry};
use crate::ops::declare::operation;
use crate::ops::insert::{not_found, stand};
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Remark, Word};
use crate::plant::{Growth, Seeds, Sizes, Stock, Structure, age_class, choose};
use crate::shape::{Grown, Placed, Shape};
use crate::unit::{Metres, Share};
use glam::DVec3;

operation! {
    /// Plants a species at an age, or what a palette has for the lot, with the sizes it has at that age.
    ///
    /// Niese et al. 2022, §5.4. Without a `species` one is chosen: `landscape_species` of the palette grow in the whole
    /// layout, `species_count` of those in a lot, and one tree and one shrub of these is the lot's dominant. The age is
    /// drawn evenly between `min_age` and `max_age` in years since planting, and then lowered until the crown keeps
    /// within the radius that a placement has reserved, and the height within `max_height`. The plant stands about the
    /// middle of the scope. `species.crown` tells the radius to reserve for a species at an age.
    /// ```cga
    /// Lot  --> boundary(width = 5, radius = 2.6) { Tree } Lawn
    /// Tree --> plant(palette = temperate, max_age = 60, tree_ratio = 0.8, diversity = 0.5, species_count = 4)
    /// ```
    "plant" (Added, None) => pub struct Plant {
        /// The species by any name the catalogue knows; empty: one of the palette (ϕ).
        species: Word = Word("".into()) => "\"\"",
        /// A palette of the catalogue, or a list of species: `"plane; lime; yew"`.
        palette: Word = Word("temperate".into()) => "temperate",
        /// The greatest age in years (α).
        max_age: f64 [0.0, 100.0] = 60.0 => "60",
        /// The least age in years.
        min_age: Option<f64> = None => "half of max_age",
        /// No plant is older than it takes to grow so high, in metres; 0 sets no limit.
        max_height: Metres = Metres(0.0) => "0",
        /// The share of trees among the plants, the rest being shrubs (ρ).
        tree_ratio: Share = Share(0.8) => "0.8",
        /// The share of the lot's dominant tree among its trees, and of its dominant shrub among its shrubs (θ).
        diversity: Share = Share(0.5) => "0.5",
        /// How many species a lot has, at least one of each kind that is planted (λ).
        species_count: u32 [1.0, 10.0] = 4 => "4",
        /// How many species the whole layout has (n).
        landscape_species: u32 = 10 => "10",
        /// What pruning leaves of the crown's volume, above 0 to 1: its radius and its height above the lowest leaves
        /// shrink by the cube root (γ).
        pruning: Share = Share(1.0) => "1",
    }
}

/// Older is a slip of the pen.
const OLDEST: f64 = 5000.0;

impl Apply for Plant {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        self.check()?;
        let entry = self.entry(given)?;
        let growth = Growth::of(entry).map_err(|error| Problem::new(error.to_string()))?;
        let radius = shape.ordinals.place.radius;
        // γ scales a volume, so lengths go by its cube root.
        let pruned = libm::cbrt(self.pruning.0);
        let age = self.age(given).min(self.oldest(&growth, radius / pruned));
        let sizes = Sizes { age, ..growth.sizes(age) };
        self.stand(shape, entry, &sizes, pruned, given);
        // Where a range is given, younger plants are a matter of course.
        let exact = self.min_age.filter(|least| self.max_age - least < 1.0);
        let too_young = exact.filter(|least| age < least - 1e-6).map(|least| too_young(entry, least, &growth, shape));
        Ok(too_young.map_or(Pieces::Changed, |remark| Pieces::Told(Effect::Remark(remark))))
    }
}

impl Plant {
    fn check(&self) -> Result<(), Problem> {
        let shares = [("tree_ratio", self.tree_ratio), ("diversity", self.diversity), ("pruning", self.pruning)];
        for (name, Share(share)) in shares {
            if !(0.0..=1.0).contains(&share) {
                return Err(refused(name, "a share from 0 to 1", share));
            }
        }
        if self.pruning.0 <= 0.0 {
            return Err(refused("pruning", "a share above 0: nothing would be left of the crown", 0.0));
        }
        if !(0.0..=OLDEST).contains(&self.max_age) {
            return Err(refused("max_age", "years from 0 to 5000", self.max_age));
        }
        if let Some(age) = self.min_age.filter(|age| !(0.0..=self.max_age).contains(age)) {
            return Err(refused("min_age", "years from 0 to `max_age`", age));
        }
        if self.max_height.0 < 0.0 {
            return Err(refused("max_height", "metres from 0 up", self.max_height.0));
        }
        match (self.species_count, self.landscape_species) {
            (0, _) => Err(refused("species_count", "a whole number from 1 up", 0.0)),
            (_, 0) => Err(refused("landscape_species", "a whole number from 1 up", 0.0)),
            _ => Ok(()),
        }
    }

    fn entry<'a>(&self, given: &Given<'a>) -> Result<&'a Entry, Problem> {
        let name = self.species.0.trim();
        if !name.is_empty() {
            return plant_called(given.catalogue, name, "species");
        }
        let stock = stock(given.catalogue, self.palette.0.trim())?;
        let structure = Structure {
            tree_ratio: self.tree_ratio.0,
            diversity: self.diversity.0,
            species_count: self.species_count as usize,
            landscape_species: self.landscape_species as usize,
        };
        let seeds = Seeds { run: given.run, lot: given.lot, plant: given.seed };
        choose(&stock, &structure, seeds).ok_or_else(|| at("palette", Problem::new("the palette has no plants")))
    }

    fn age(&self, given: &Given) -> f64 {
        let least = self.min_age.unwrap_or(self.max_age * 0.5);
        given.seed.draw("age").uniform(least, self.max_age)
    }

    /// The age that the reserved radius and the height allow; 0 is no limit.
    fn oldest(&self, growth: &Growth, radius: f64) -> f64 {
        let by_crown = if radius > 0.0 { growth.age_at_crown_radius(radius) } else { f64::INFINITY };
        let height = self.max_height.0;
        let by_height = if height > 0.0 { growth.age_at_height(height) } else { f64::INFINITY };
        by_crown.min(by_height)
    }

    fn stand(&self, shape: &mut Shape, entry: &Entry, sizes: &Sizes, pruned: f64, given: &Given) {
        let class = age_class(entry, sizes.age);
        let crown_height = sizes.crown_height * pruned;
        let width = sizes.crown_diameter * pruned;
        // The smallest plant of a nursery may still be wider than what is reserved.
        let reserved = shape.ordinals.place.radius;
        let width = if reserved > 0.0 { width.min(2.0 * reserved) } else { width };
        let height = sizes.height - sizes.crown_height + crown_height;
        let placed = Placed {
            entry: entry.id.clone(),
            kind: class.name.clone(),
            appearance: given.seed.draw("appearance").below(u64::from(class.appearances)) as u32,
            age: sizes.age,
            round: true,
            grown: Some(Grown {
                trunk_diameter: sizes.dbh,
                crown_height,
                // Leaves fill the crown evenly.
                leaf_area: sizes.leaf_area * self.pruning.0,
                pruning: self.pruning.0,
                measured: sizes.measured,
            }),
        };
        stand(shape, DVec3::new(width, height, width), placed);
    }
}

/// A plant that is younger than a rule wants it, since it would outgrow its place.
fn too_young(entry: &Entry, least: f64, growth: &Growth, shape: &Shape) -> Remark {
    let number = |n: f64| crate::text::number(n, 2);
    let crown = number(0.5 * growth.sizes(least).crown_diameter);
    let reserved = shape.ordinals.place.radius;
    let room =
        if reserved > 0.0 { format!("the {} m reserved for it", number(reserved)) } else { "`max_height`".into() };
    let message = format!(
        "`{}` of {} years is too large for {room} (its crown has a radius of {crown} m): it is planted younger",
        entry.label,
        number(least)
    );
    Remark { message, parameter: Some("min_age"), is_note: false }
}

/// The plants of a palette, or of a list of names.
fn stock<'a>(catalogue: &'a Catalogue, palette: &str) -> Result<Stock<'a>, Problem> {
    if let Some(palette) = catalogue.palette(palette) {
        return Ok(palette.plants(catalogue).collect());
    }
    let names: Vec<&str> = palette.split([';', ',']).map(str::trim).filter(|name| !name.is_empty()).collect();
    match names.as_slice() {
        [one] if catalogue.find(one, "").is_err() => Err(no_palette(catalogue, one)),
        names => names.iter().map(|name| plant_called(catalogue, name, "palette")).collect(),
    }
}

fn no_palette(catalogue: &Catalogue, name: &str) -> Problem {
    let known: Vec<String> = catalogue.palettes().map(|palette| format!("`{}`", palette.name)).collect();
    let problem = at("palette", Problem::new(format!("there is no palette `{name}`, and no such plant")));
    match catalogue.nearest_palette(name) {
        Some(near) => problem.hint(crate::text::did_you_mean(near)),
        None => problem.hint(format!("palettes are {}", known.join(", "))),
    }
}

/// The plant of that name, for a parameter.
fn plant_called<'a>(catalogue: &'a Catalogue, name: &str, parameter: &'static str) -> Result<&'a Entry, Problem> {
    let found = catalogue.find(name, "").map_err(|error| at(parameter, not_found(error)))?;
    match found.entry.kind.is_plant() {
        true => Ok(found.entry),
        false => Err(at(parameter, Problem::new(format!("`{name}` is no plant: `i` inserts it")))),
    }
}

fn refused(parameter: &'static str, allowed: &str, found: f64) -> Problem {
    let found = crate::text::number(found, 6);
    at(parameter, Problem::new(format!("`{parameter}` must be {allowed}, not {found}")))
}

fn at(parameter: &'static str, problem: Problem) -> Problem {
    Problem { parameter: Some(parameter), ..problem }
}
