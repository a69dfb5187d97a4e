//! `scatter`: CityEngine's random points.

use crate::geometry::Area;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, points};
use crate::placement;
use crate::shape::Shape;
use crate::value::Size;
use glam::DVec2;

operation! {
    /// Sets a number of points on the shape at random, without any spacing (CityEngine's).
    ///
    /// `uniform` spreads them evenly by chance; `gaussian` gathers them about the centre or a side, with a standard
    /// deviation in metres or as a share of the scope. Each child is a point with y along the surface's normal;
    /// `place.index` and `place.total` count them. The shape itself stays: `NIL` after the block removes it.
    /// ```cga
    /// Meadow --> scatter(surface, 30, gaussian, center, '0.16) { I(birch, young, rand(7)) } Lawn
    /// ```
    "scatter" (CityEngine, Body) => pub struct Scatter {
        /// What the points are set on: the surface, or the scope's ground rectangle.
        domain: Domain = Domain::Surface => "surface",
        /// How many.
        count: u32,
        /// How they are spread.
        distribution: Distribution = Distribution::Uniform => "uniform",
        /// What Gaussian points gather about.
        centre: Towards = Towards::Center => "center",
        /// Standard deviation of Gaussian points: metres, or with `'` a share of the scope.
        deviation: Size = Size::Relative(0.16) => "'0.16",
    }
}

choice! {
    /// What points are set on.
    pub enum Domain {
        /// The surface.
        Surface = "surface",
        /// The surface too: volumes fall back to it.
        Volume = "volume",
        /// The rectangle of the scope.
        Scope = "scope",
    }
}

choice! {
    /// How points are spread.
    pub enum Distribution {
        /// Evenly by chance.
        Uniform = "uniform",
        /// About a centre.
        Gaussian = "gaussian",
    }
}

choice! {
    /// What Gaussian points gather about.
    pub enum Towards {
        /// The middle.
        Center = "center",
        /// The front side.
        Front = "front",
        /// The back side.
        Back = "back",
        /// The left side.
        Left = "left",
        /// The right side.
        Right = "right",
        /// The middle, on flat shapes.
        Top = "top",
        /// The middle, on flat shapes.
        Bottom = "bottom",
    }
}

impl Apply for Scatter {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        if self.count as usize > given.most {
            let message = format!("{} points are more than the limit `children` of {}", self.count, given.most);
            return Err(Problem::new(message));
        }
        let (plane, area, lift) = points::surface(shape)?;
        let bounds = area.bounds();
        let area = match self.domain {
            Domain::Scope => crate::geometry::Polygon::rectangle(bounds.min, bounds.max).into_iter().collect(),
            Domain::Surface | Domain::Volume => area,
        };
        let found = match self.distribution {
            Distribution::Uniform => placement::uniform(&area, self.count as usize, given.seed),
            Distribution::Gaussian => self.gathered(&area, given),
        };
        let found = found.map_err(|e| Problem::new(e.to_string()))?;
        Ok(points::children(shape, &plane, lift, &found))
    }
}

impl Scatter {
    fn gathered(&self, area: &Area, given: &Given) -> Result<Vec<DVec2>, placement::PlacementError> {
        let bounds = area.bounds();
        let (middle, size) = (bounds.centre(), bounds.size());
        // On the ground the front lies at the least v, on a face too.
        let centre = match self.centre {
            Towards::Center | Towards::Top | Towards::Bottom => middle,
            Towards::Front => DVec2::new(middle.x, bounds.min.y),
            Towards::Back => DVec2::new(middle.x, bounds.max.y),
            Towards::Left => DVec2::new(bounds.min.x, middle.y),
            Towards::Right => DVec2::new(bounds.max.x, middle.y),
        };
        let deviation = match self.deviation {
            Size::Relative(share) | Size::Floating(share) => size * share,
            Size::Absolute(metres) => DVec2::splat(metres),
        };
        Ok(placement::gaussian(area, self.count as usize, centre, deviation, given.seed)?.points)
    }
}
