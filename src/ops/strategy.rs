//! What the placement strategies share: parameters of radius, density, number and avoidance, the site they narrow a
//! shape to, and the point shapes that come out (Niese et al. 2022, §5.2–5.3, Tables 1 and 2).

use crate::ops::envelope::{self, Avoided};
use crate::ops::ground::Ground;
use crate::ops::spec::Varying;
use crate::ops::{Given, Pieces, Problem, Remark, Word};
use crate::placement::{Amount, Field, Placed, PlacementError, Radii, Site, Stop};
use crate::shape::Shape;
use crate::unit::{Metres, PerArea, Share};

/// Declares a placement strategy: an operation with a successor for every place and the parameters that all share.
macro_rules! strategy {
    ($(#[doc = $doc:literal])* $name:literal => pub struct $type:ident { $($own:tt)* }) => {
        $crate::ops::declare::operation! {
            $(#[doc = $doc])*
            $name (Added, Body) => pub struct $type {
                $($own)*
                /// Standard deviation of the radius (√σ: the paper's σ is a variance), metres.
                radius_sd: $crate::unit::Metres [0.0, 1.415] = $crate::unit::Metres(0.0) => "0",
                /// The share of the places that is kept (τ).
                density: $crate::ops::spec::Varying<$crate::unit::Share> [0.0, 1.0]
                    = $crate::ops::spec::Varying($crate::unit::Share(1.0)) => "1",
                /// So many places instead of all, before `density`.
                count: Option<u32> = None => "all",
                /// So many places per m² instead of all, before `density`; of the shape, the band or the disks, with
                /// what is kept clear.
                per_area: Option<$crate::unit::PerArea> = None => "all",
                /// No radius is below this, metres.
                radius_min: Option<$crate::unit::Metres> = None => "radius / 2",
                /// What is kept clear of as well: kinds, labels or layers (`"pond kind:building layer:pipes"`).
                avoid: Option<$crate::ops::Word> = None => "nothing",
                /// How far plants keep from what `avoid` names, metres.
                margin: $crate::unit::Metres = $crate::unit::Metres(0.0) => "0",
            }
        }

        impl $type {
            fn shared(&self) -> $crate::ops::strategy::Shared<'_> {
                $crate::ops::strategy::Shared {
                    deviation: self.radius_sd,
                    least: self.radius_min,
                    density: self.density.0,
                    count: self.count,
                    per_area: self.per_area,
                    avoid: self.avoid.as_ref(),
                    margin: self.margin,
                }
            }
        }
    };
}
pub(super) use strategy;

/// The parameters that all strategies have.
pub struct Shared<'a> {
    pub deviation: Metres,
    pub least: Option<Metres>,
    pub density: Share,
    pub count: Option<u32>,
    pub per_area: Option<PerArea>,
    pub avoid: Option<&'a Word>,
    pub margin: Metres,
}

impl Shared<'_> {
    /// Where plants may stand on the ground.
    pub fn site(&self, ground: &Ground, shape: &Shape, given: &Given, radii: &Radii) -> Result<Site, Problem> {
        let mut site = Site::new(ground.area.clone());
        let avoided = self.avoid.map_or(Ok(Avoided::default()), |word| Avoided::parse("avoid", &word.0))?;
        let margin = not_negative("margin", self.margin.0)?;
        if !ground.level || ground.area.is_empty() {
            return Ok(site);
        }
        let (near, envelope) = (site.bounds(), &shape.style.envelope);
        for (body, distance) in envelope::bodies(near, envelope, &avoided, margin, given) {
            site = site.clear_of(body, distance);
        }
        site = site.standing(given.standing.near(near.grown(radii.largest()), shape.ordinals.place.disk));
        Ok(if envelope.seams { site.within(given.outline.clone()) } else { site })
    }

    /// The radii about a mean, which may vary over the shape.
    pub fn radii(&self, mean: Field) -> Result<Radii, Problem> {
        let radii = Radii { mean, deviation: self.deviation.0, least: self.least.map(|least| least.0) };
        radii.check().map_err(problem)?;
        Ok(radii)
    }

    /// The same about a mean of half the spacing where a rule gives none.
    pub fn radii_or(&self, given: &Given, radius: Option<Varying<Metres>>, spacing: &Field) -> Result<Radii, Problem> {
        match radius {
            Some(radius) => self.radii(given.field("radius", radius.0.0)),
            // Whatever is wrong with the spacing is told by the strategy itself, under its own name.
            None if !(spacing.least() > 0.0 && spacing.most().is_finite()) => Ok(Radii::constant(1.0)),
            None => self.radii(spacing.scaled(0.5)),
        }
    }

    /// How many plants are wanted.
    pub fn amount(&self, given: &Given) -> Result<Amount, Problem> {
        if let Some(per_area) = self.per_area {
            not_negative("per_area", per_area.0)?;
        }
        let stop = match (self.count, self.per_area) {
            (None, None) => Stop::Saturated,
            (Some(count), None) => Stop::Count(count as usize),
            (None, Some(per_area)) => Stop::PerArea(per_area.0),
            (Some(_), Some(_)) => {
                let message = "`count` and `per_area` are two ways to say the same: one is enough";
                return Err(Problem { parameter: Some("per_area"), ..Problem::new(message) });
            }
        };
        let amount = Amount { stop, density: given.field("density", self.density.0) };
        amount.check().map_err(problem)?;
        Ok(amount)
    }

    /// The places as point shapes, with what there is to say about them.
    pub fn pieces(
        &self,
        ground: &Ground,
        shape: &Shape,
        given: &Given,
        radii: &Radii,
        placed: Result<Placed, PlacementError>,
    ) -> Result<Pieces, Problem> {
        let placed = placed.map_err(problem)?;
        if placed.spots.len() > given.most {
            let found = crate::text::counted(placed.spots.len(), "point");
            return Err(Problem::new(format!("{found} are more than the limit `children` of {}", given.most)));
        }
        let remarks = self.remarks(ground, given, radii, &placed);
        Ok(Pieces::Placed(ground.children(shape, &placed.spots), remarks))
    }

    fn remarks(&self, ground: &Ground, given: &Given, radii: &Radii, placed: &Placed) -> Vec<Remark> {
        let mut remarks = Vec::new();
        let avoided = self.avoid.and_then(|word| Avoided::parse("avoid", &word.0).ok());
        if let Some(name) = avoided.as_ref().and_then(|avoided| avoided.unheard(given)) {
            remarks.push(unheard("avoid", name, given));
        }
        let mut remark = |parameter, message| remarks.push(Remark { message, parameter, is_note: false });
        if radii.deviation > 0.5 * radii.mean.least() {
            let number = |n: f64| crate::text::number(n, 3);
            let (deviation, mean) = (number(radii.deviation), number(radii.mean.least()));
            let message = format!("a deviation of {deviation} m is more than half of the radius of {mean} m");
            remark(Some("radius_sd"), format!("{message}: small plants will be cut off"));
        }
        if placed.missing > 0 {
            let parameter = self.count.map(|_| "count").or(self.per_area.map(|_| "per_area"));
            let missing = crate::text::counted(placed.missing, "plant");
            let of = self.count.map(|count| format!(" of {}", crate::text::thousands(count as usize)));
            remark(parameter, format!("{missing}{} found no place", of.unwrap_or_default()));
        }
        if ground.area.is_empty() {
            remark(None, "there is no area to place on".into());
        } else if placed.spots.is_empty() && placed.missing == 0 && self.density.0 >= 1.0 {
            let message = "nothing is placed: no place keeps clear of all that stands and is to be kept clear".into();
            remarks.push(Remark { message, parameter: None, is_note: true });
        }
        remarks
    }
}

/// A name that nothing has.
pub fn unheard(parameter: &'static str, name: &str, given: &Given) -> Remark {
    let near = crate::text::nearest(name, given.names.into_iter().flatten().map(|name| &**name));
    let near = near.map_or(String::new(), |near| format!("; {}", crate::text::did_you_mean(near)));
    let message = format!("nothing is called `{name}`: no kind or layer of the layout and no label of the rules{near}");
    Remark { message, parameter: Some(parameter), is_note: false }
}

/// A number from 0 up.
pub fn not_negative(parameter: &'static str, number: f64) -> Result<f64, Problem> {
    if number.is_finite() && number >= 0.0 {
        return Ok(number);
    }
    Err(problem(PlacementError::Value { parameter, found: number, allowed: "a number from 0 up" }))
}

/// What a strategy refuses, at the argument that it is about.
pub fn problem(error: PlacementError) -> Problem {
    Problem { parameter: error.parameter(), ..Problem::new(error.to_string()) }
}
