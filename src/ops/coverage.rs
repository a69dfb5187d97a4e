//! `coverage`: takes what a coverage map marks apart from what remains (Niese et al. 2022, §6.1 and §7.1).

use crate::geometry::{self, Area, Bounds};
use crate::ops::declare::operation;
use crate::ops::{Apply, Component, Gather, Given, Part, Pieces, Problem, Selectors, Word, color, fit, gather};
use crate::raster::{Measure, RasterError, without_trifles};
use crate::shape::{Extent, Geometry, Plane, Shape};
use crate::value::Value;
use glam::{DAffine2, DVec2, DVec3};

operation! {
    /// Takes a level shape apart by a coverage map: what the map marks, and what remains.
    ///
    /// The map is a picture (PNG or GeoTIFF), or polygons drawn in a GeoJSON file; its path is relative to the rule
    /// file the run begins with. A world file (`cover.pgw` beside `cover.png`) or the tags of a GeoTIFF say where a
    /// picture lies; its coordinates are the layout's unless its tags name another system. White is covered, black is
    /// not, and in pictures with clear pixels what is opaque is covered; `band` and `color` ask for something else. A
    /// picture's edges are smoothed within half a pixel.
    ///
    /// After `cover :` stands what becomes of each patch, after `cover =` of all patches in one shape; `remainder`
    /// takes what is left, in one. The parts sum to the whole. (Niese et al. 2022, §6.1; drawn polygons: §7.1.)
    /// ```cga
    /// Lot --> coverage("cover.geojson") { cover = Wood | remainder : Lawn }
    /// Wood --> semirandom(radius = 2) { plant("beech") } Undergrowth
    /// ```
    "coverage" (Added, Selectors(&["cover", "remainder"])) => pub struct Coverage {
        /// The map: a `.png`, `.tif` or `.geojson` file.
        source: Word,
        /// From which value a pixel is covered: 0 black or clear, 1 white or opaque. Floating-point rasters have
        /// values of their own.
        threshold: f64 = 0.5 => "0.5",
        /// What of a pixel counts: `"cover"` (opacity where there is any, else luminance), `"luminance"`, `"alpha"`,
        /// `"red"`, `"green"`, `"blue"`, or the number of a band from 1.
        band: Word = Word("cover".into()) => "\"cover\"",
        /// Instead of a band the colour of the pixels that are covered, as in `"#00ff00"`.
        color: Value = Value::text("") => "\"\"",
        /// How much red, green and blue may differ from `color`, 0 to 1.
        tolerance: f64 = 0.1 => "0.1",
        /// Patches smaller than this remain, and gaps smaller than this are covered (m²).
        least: f64 = 1.0 => "1",
    }
}

impl Apply for Coverage {
    fn components(&self, shape: &Shape) -> Result<Vec<Component>, Problem> {
        let component = |words| Component { shape: shape.clone(), selectors: Selectors::none(), words };
        Ok(vec![component(&["cover"]), component(&["remainder"])])
    }

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let (plane, area, on_plan) = level(shape)?;
        let marked = self.marked(on_plan.bounds(), given)?.transformed(&to_plane(shape, plane));
        let found = without_trifles(&geometry::intersection(area, &marked), self.least.max(0.0));
        // A gap that was closed may be a hole of the shape's own.
        let cover = geometry::intersection(area, &found);
        let mut parts = Vec::new();
        let mut add = |entry, area: Area| {
            parts.extend(fit::fitted(shape, Geometry::Flat(plane.clone(), area)).map(|shape| Part::new(entry, shape)));
        };
        let rest = geometry::difference(area, &cover);
        match given.chosen[0] {
            Some(choice) if choice.gather == Gather::All => add(choice.entry, cover),
            Some(choice) => cover.polygons().iter().for_each(|patch| add(choice.entry, patch.clone().into())),
            None => {}
        }
        if let Some(choice) = given.chosen[1] {
            add(choice.entry, rest);
        }
        gather::count(parts.iter_mut().map(|part| (part.entry, &mut *part.shape)));
        Ok(Pieces::Parts(parts))
    }
}

impl Coverage {
    /// What the map marks around a part of the plan.
    fn marked(&self, within: Bounds, given: &Given) -> Result<Area, Problem> {
        let path = &*self.source.0;
        let is_drawn = [".geojson", ".json"].iter().any(|ending| path.to_ascii_lowercase().ends_with(ending));
        if is_drawn {
            return Ok(given.rasters.drawn(path).map_err(unusable)?.area(within));
        }
        let measure = self.measure()?;
        let raster = given.rasters.get(path).map_err(unusable)?;
        let area = raster.area(&measure, self.threshold, within);
        area.map_err(|flaw| unusable(RasterError { path: path.into(), flaw }))
    }

    /// What of a pixel counts.
    fn measure(&self) -> Result<Measure, Problem> {
        let at = |parameter, problem| Problem { parameter: Some(parameter), ..problem };
        match self.color.as_str() {
            Some("") => Measure::parse(&self.band.0).ok_or_else(|| {
                let message = format!("there is no band `{}`", self.band.0);
                let hint = "a band is `cover`, `luminance`, `alpha`, `red`, `green`, `blue`, or a number from 1";
                at("band", Problem::new(message).hint(hint))
            }),
            Some(text) => {
                let [red, green, blue, _] = color::parse(text).map_err(|problem| at("color", problem))?;
                Ok(Measure::Color { color: [red, green, blue], tolerance: self.tolerance.max(0.0) as f32 })
            }
            None => Err(at("color", Problem::new(format!("`{}` is not a colour", self.color)))),
        }
    }
}

/// The plane and area of a level shape, and its area on the plan.
fn level(shape: &Shape) -> Result<(&Plane, &Area, Area), Problem> {
    let Geometry::Flat(plane, area) = &shape.geometry else {
        return Err(Problem::new("`coverage` takes flat shapes"));
    };
    match shape.footprint().extent {
        Extent::Area(on_plan) => Ok((plane, area, on_plan)),
        _ => Err(Problem::new("`coverage` takes level shapes")),
    }
}

/// From the plan straight down onto the shape's plane: the shape is level, so the map is affine.
fn to_plane(shape: &Shape, plane: &Plane) -> DAffine2 {
    let frame = shape.scope.frame;
    let local = |p: DVec2| plane.foot(frame.to_local(DVec3::new(p.x, frame.origin.y, -p.y)));
    let origin = local(DVec2::ZERO);
    DAffine2::from_cols(local(DVec2::X) - origin, local(DVec2::Y) - origin, origin)
}

/// A map that cannot be used, as a problem of its path.
fn unusable(error: RasterError) -> Problem {
    Problem { parameter: Some("source"), ..Problem::new(error.to_string()) }
}
