//! Allometry: a species and an age → its sizes.
//!
//! Measured species go age → trunk diameter → height, crown and leaf area, along the curves of their `growth` table
//! (`src/element/catalogue/growth.toml` says how it is written). Palms, whose trunks do not thicken, go age → height →
//! crown and leaf area. All others grow from type to type. Ages are years since planting.

use crate::element::{Entry, Kind, Variant};
use crate::plant::curve::{Curve, range};
use crate::plant::stages::Stages;

/// How large a plant is at an age.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sizes {
    /// Years.
    pub age: f64,
    /// Diameter of the trunk at breast height, metres.
    pub dbh: f64,
    /// From the foot to the top, metres.
    pub height: f64,
    /// Metres.
    pub crown_diameter: f64,
    /// From the lowest leaves to the top, metres.
    pub crown_height: f64,
    /// One side of all leaves, m²; 0 where nobody measured it.
    pub leaf_area: f64,
    /// By curves fitted to measured trees; else between the catalogue's types.
    pub measured: bool,
    /// Older than what is known: the sizes are those of the greatest age that is.
    pub beyond: bool,
}

/// How a species grows: read once, asked often.
#[derive(Clone, Debug)]
pub struct Growth {
    /// None where nobody measured.
    curves: Option<Curves>,
    stages: Stages,
    /// The share of its height that bears leaves, where nobody measured it.
    leafy: f64,
}

/// Why the growth table of an entry cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("the growth of `{entry}` in the catalogue: {reason}")]
pub struct GrowthError {
    /// The entry.
    pub entry: String,
    /// What is wrong with it.
    pub reason: String,
}

/// The curves of a measured species.
#[derive(Clone, Copy, Debug)]
struct Curves {
    /// The ages they were measured at.
    ages: [f64; 2],
    /// Age → centimetres; none for palms, of which height is by age and all else by height.
    dbh: Option<Curve>,
    /// Centimetres (or age) → metres.
    height: Curve,
    /// Centimetres (or height) → metres.
    crown_diameter: Curve,
    /// Centimetres (or height) → metres.
    crown_height: Curve,
    /// Centimetres (or height) → m².
    leaf_area: Option<Curve>,
}

/// Halvings of the range of ages: far below a day.
const STEPS: usize = 32;

/// The sizes of a plant at an age in years; ages below 0 are 0.
pub fn sizes(entry: &Entry, age: f64) -> Result<Sizes, GrowthError> {
    Ok(Growth::of(entry)?.sizes(age))
}

/// The type nearest in age: `young`, `medium` or `adult`; the usual one where a plant has none of these.
pub fn age_class(entry: &Entry, age: f64) -> &Variant {
    let years = |variant: &Variant| variant.plant.map_or(f64::INFINITY, |figures| (figures.age - age).abs());
    let classes = entry.variants.iter().filter(|variant| ["young", "medium", "adult"].contains(&&*variant.name));
    classes.min_by(|a, b| years(a).total_cmp(&years(b))).unwrap_or(entry.usual())
}

impl Growth {
    /// How a plant of the catalogue grows; an error where its `growth` table has a curve that is none.
    pub fn of(entry: &Entry) -> Result<Growth, GrowthError> {
        let curves =
            Curves::read(&entry.growth).map_err(|reason| GrowthError { entry: entry.id.to_string(), reason })?;
        let leafy = if entry.kind == Kind::Tree { 0.75 } else { 1.0 };
        Ok(Growth { curves, stages: Stages::of(entry), leafy })
    }

    /// The sizes at an age in years; ages below 0 are 0.
    pub fn sizes(&self, age: f64) -> Sizes {
        let age = age.max(0.0);
        match &self.curves {
            Some(curves) => self.measured(curves, age),
            None => self.between(age),
        }
    }

    /// The greatest age at which the crown keeps within a radius in metres: infinite where it never outgrows it, 0
    /// where it does from the start.
    pub fn age_at_crown_radius(&self, radius: f64) -> f64 {
        self.last_age_when(|age| self.crown_diameter(age) * 0.5 <= radius)
    }

    /// The greatest age at which it is not higher than so many metres; infinite and 0 as for the crown.
    pub fn age_at_height(&self, height: f64) -> f64 {
        self.last_age_when(|age| self.height(age) <= height)
    }

    /// The age behind which sizes are held, years.
    pub fn last_age(&self) -> f64 {
        self.curves.map_or(self.stages.last_age(), |curves| curves.ages[1])
    }

    /// Whether its sizes follow curves fitted to measured trees.
    pub fn is_measured(&self) -> bool {
        self.curves.is_some()
    }

    /// Bisects the ages, over which sizes only grow.
    fn last_age_when(&self, holds: impl Fn(f64) -> bool) -> f64 {
        let (mut low, mut high) = (0.0, self.last_age());
        if holds(high) {
            return f64::INFINITY;
        }
        for _ in 0..STEPS {
            let middle = 0.5 * (low + high);
            match holds(middle) {
                true => low = middle,
                false => high = middle,
            }
        }
        low
    }

    fn crown_diameter(&self, age: f64) -> f64 {
        match &self.curves {
            Some(curves) => curves.crown_diameter.at(curves.scale(age)),
            None => self.between(age).crown_diameter,
        }
    }

    fn height(&self, age: f64) -> f64 {
        match &self.curves {
            Some(curves) if curves.dbh.is_some() => curves.height.at(curves.scale(age)),
            Some(curves) => curves.scale(age),
            None => self.between(age).height,
        }
    }

    fn measured(&self, curves: &Curves, age: f64) -> Sizes {
        let by = curves.scale(age);
        let dbh = match &curves.dbh {
            Some(_) => by / 100.0,
            None => self.stages.at(age.min(curves.ages[1])).map_or(0.0, |figures| figures.trunk_diameter),
        };
        let height = if curves.dbh.is_some() { curves.height.at(by) } else { by };
        Sizes {
            age,
            dbh,
            height,
            crown_diameter: curves.crown_diameter.at(by),
            crown_height: curves.crown_height.at(by).min(height),
            leaf_area: curves.leaf_area.map_or(0.0, |curve| curve.at(by)),
            measured: true,
            beyond: age > curves.ages[1],
        }
    }

    fn between(&self, age: f64) -> Sizes {
        let figures = self.stages.at(age).unwrap_or_default();
        Sizes {
            age,
            dbh: figures.trunk_diameter,
            height: figures.height,
            crown_diameter: 2.0 * figures.crown_radius,
            crown_height: self.leafy * figures.height,
            leaf_area: 0.0,
            measured: false,
            beyond: age > self.stages.last_age(),
        }
    }
}

impl Curves {
    /// What all else goes by at an age: centimetres of trunk, or metres of height.
    fn scale(&self, age: f64) -> f64 {
        self.dbh.as_ref().unwrap_or(&self.height).at(age.min(self.ages[1]))
    }

    /// Without a `height` there are no curves.
    fn read(table: &toml::Table) -> Result<Option<Curves>, String> {
        let Some(height) = curve(table, "height")? else { return Ok(None) };
        let needed = |name: &'static str| curve(table, name)?.ok_or_else(|| format!("there is no `{name}`"));
        Ok(Some(Curves {
            ages: range(table, "ages")?,
            dbh: curve(table, "dbh")?,
            height,
            crown_diameter: needed("crown_diameter")?,
            crown_height: needed("crown_height")?,
            leaf_area: curve(table, "leaf_area")?,
        }))
    }
}

fn curve(table: &toml::Table, name: &str) -> Result<Option<Curve>, String> {
    let Some(value) = table.get(name) else { return Ok(None) };
    let table = value.as_table().ok_or_else(|| format!("`{name}` must be a table"))?;
    Curve::read(table).map(Some).map_err(|reason| format!("`{name}`: {reason}"))
}
