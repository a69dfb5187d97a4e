//! `without`: what is left of a shape when others are taken off.

use crate::geometry::{self, Area};
use crate::ops::declare::operation;
use crate::ops::envelope::{self, Avoided};
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Word, fit, strategy};
use crate::shape::{Extent, Geometry, Shape};
use crate::unit::Metres;
use glam::{DAffine2, DVec2, DVec3};

operation! {
    /// Takes everything under a label off a level shape, with a margin.
    ///
    /// A label is the kind of a feature of the lot (`"building"`, `"water"`, `"driveway"` …), the kind of a
    /// neighbouring region, or the label of a shape that was derived before. So lawns end at the pond and their area is right. What is taken off wholly is deleted.
    /// ```cga
    /// Lot  --> [ s(18, 0, 14) center(xz) primitiveDisk(48) label("pond") Water ] Rest
    /// Rest --> without("pond", 2) Lawn
    /// ```
    "without" (Added, None) => pub struct Without {
        /// The label.
        label: Word,
        /// How far around it is taken off too (metres).
        margin: Metres = Metres(0.0) => "0",
    }
}

impl Apply for Without {
    const LOOKS_AROUND: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let Geometry::Flat(plane, area) = &shape.geometry else {
            return Err(Problem::new("`without` takes flat shapes"));
        };
        let footprint = shape.footprint();
        let Extent::Area(on_plan) = &footprint.extent else {
            return Err(Problem::new("`without` takes level shapes"));
        };
        let (near, margin) = (on_plan.bounds(), self.margin.0.max(0.0));
        let other = envelope::kind(&self.label.0);
        let labels = [&*self.label.0, &*other];
        let labels = if labels[0] == labels[1] { &labels[..1] } else { &labels[..] };
        let areas = |label: &&str| [given.intra, given.inter].map(|set| set.areas(near, label, margin));
        let taken: Vec<Area> = labels.iter().flat_map(areas).flatten().collect();
        if taken.is_empty() {
            let unheard = Avoided::parse("label", &self.label.0).ok();
            let unheard = unheard.as_ref().and_then(|name| name.unheard(given));
            let remark = unheard.map(|name| strategy::unheard("label", name, given));
            return Ok(remark.map_or(Pieces::Changed, |remark| Pieces::Told(Effect::Remark(remark))));
        }
        let frame = shape.scope.frame;
        // From the plan straight down onto the shape's plane: the shape is level, so the map is affine.
        let local = |p: DVec2| plane.foot(frame.to_local(DVec3::new(p.x, frame.origin.y, -p.y)));
        let origin = local(DVec2::ZERO);
        let map = DAffine2::from_cols(local(DVec2::X) - origin, local(DVec2::Y) - origin, origin);
        let left = geometry::difference(area, &geometry::union_all(&taken).transformed(&map));
        let left = Geometry::Flat(plane.clone(), left);
        fit::refit(shape, left);
        Ok(Pieces::left_of(shape))
    }
}
