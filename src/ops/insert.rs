//! `i`: inserts an element or a model by its id or file.

use crate::element::{Found, NotFound};
use crate::geometry::Polygon;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Remark, Word};
use crate::shape::{Geometry, Placed, Plane, Shape};
use glam::{DVec2, DVec3};
use std::sync::Arc;

operation! {
    /// Inserts an element of the catalogue, by id or name, or the model of an entry, by its file.
    ///
    /// Where the scope has no size the element has its own; where it has one, the element fills it: a size of 0
    /// along two axes scales evenly from the third. A model's file that is nowhere has a box that stands in for it, with
    /// a warning, so that a rule file can be tried without its assets. The papers write `I("id")`.
    /// ```cga
    /// Lot   --> setback(8) { all = Gravel | remainder : [ s(6, 0, 6) center(xz) i("fountain") ] Court }
    /// Court --> [ split(x) { { ~6 : s(3, 1, 1) i("bench") }* } ] Lawn
    /// ```
    "i" (CityEngine, None) => pub struct Insert {
        /// The element's id, name or model.
        path: Word,
        /// Which axis of the model points up.
        up: Up = Up::Y => "yUp",
        /// How the model is fitted.
        fit: Fit = Fit::Align => "alignSizeAndPosition",
    }
}

choice! {
    /// The axis of a model that points up.
    pub enum Up {
        /// y
        Y = "yUp",
        /// z
        Z = "zUp",
    }
}

choice! {
    /// How a model is fitted to the scope.
    pub enum Fit {
        /// It fills the scope.
        Align = "alignSizeAndPosition",
        /// It keeps its size, and its own origin at the scope's.
        Keep = "keepSizeAndPosition",
        /// It keeps its size, and is put at the scope's origin.
        KeepSize = "keepSizeAlignPosition",
    }
}

impl Apply for Insert {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let found = given.catalogue.find(&self.path.0, "").or_else(|error| by_model(given, &self.path.0).ok_or(error));
        let found = match found {
            Ok(found) => found,
            Err(_) if is_file(&self.path.0) => return Ok(stand_in(shape, &self.path.0)),
            Err(error) => return Err(not_found(error)),
        };
        let own = DVec3::from(found.variant.size);
        let own = if self.up == Up::Z { DVec3::new(own.x, own.z, own.y) } else { own };
        let keep = self.fit != Fit::Align;
        place(shape, &found, 0, own, keep);
        Ok(Pieces::Changed)
    }
}

/// Whether a name is that of a file: it has an ending of a few letters.
fn is_file(name: &str) -> bool {
    let ending = name.rsplit_once('.').map_or("", |(_, ending)| ending);
    (2..=5).contains(&ending.len()) && ending.chars().all(|c| c.is_ascii_alphanumeric())
}

/// A box in the scope instead of a model: 1 m where the scope has no size.
fn stand_in(shape: &mut Shape, path: &str) -> Pieces {
    settle(shape, fitted(shape.scope.size, DVec3::ONE));
    let size = shape.scope.size;
    let plan = Polygon::rectangle(DVec2::ZERO, DVec2::new(size.x, -size.z));
    shape.geometry = plan.map_or(Geometry::Point, |plan| Geometry::Prism(Plane::Ground, plan.into(), size.y));
    let message = format!("there is no model `{path}`: a box stands in for it");
    Pieces::Told(Effect::Remark(Remark { message, parameter: Some("path"), is_note: false }))
}

/// The entry whose model is that file.
pub(super) fn by_model<'a>(given: &'a Given, path: &str) -> Option<Found<'a>> {
    let name = path.rsplit('/').next().unwrap_or(path);
    given.catalogue.entries().find_map(|entry| {
        let variant = entry
            .variants
            .iter()
            .find(|v| !v.model.is_empty() && (*v.model == *path || v.model.rsplit('/').next() == Some(name)))?;
        Some(Found { entry, variant })
    })
}

/// A missing element as a problem of the branch.
pub(super) fn not_found(error: NotFound) -> Problem {
    let problem = Problem::new(error.to_string());
    match error.suggestion() {
        Some(name) => problem.hint(crate::text::did_you_mean(name)),
        None => problem.hint("`bosquet ops elements` lists the catalogue"),
    }
}

/// Puts an element of the given size in the shape.
pub(super) fn place(shape: &mut Shape, found: &Found, appearance: u32, own: DVec3, keep: bool) {
    settle(shape, if keep { own } else { fitted(shape.scope.size, own) });
    let plant = found.variant.plant;
    shape.geometry = Geometry::Element(Arc::new(Placed {
        entry: found.entry.id.clone(),
        kind: found.variant.name.clone(),
        appearance,
        age: plant.map_or(0.0, |figures| figures.age),
        round: plant.is_some(),
        grown: None,
    }));
}

/// Gives the scope a size; a point or line is the middle of what stands on it.
fn settle(shape: &mut Shape, size: DVec3) {
    let scope = shape.scope.size;
    let centre = |axis: usize| if scope[axis] < 1e-9 { size[axis] * 0.5 } else { 0.0 };
    shape.scope.frame = shape.scope.frame.moved(DVec3::new(-centre(0), 0.0, -centre(2)));
    shape.scope.size = size;
}

/// Puts a plant of its own size about the middle of the shape's scope.
pub(super) fn stand(shape: &mut Shape, size: DVec3, placed: Placed) {
    let corner = (shape.scope.size - size) * 0.5;
    shape.scope.frame = shape.scope.frame.moved(DVec3::new(corner.x, 0.0, corner.z));
    shape.scope.size = size;
    shape.geometry = Geometry::Element(Arc::new(placed));
}

/// The size in a scope: zeros are filled in (CityEngine's rules for `i`).
fn fitted(scope: DVec3, own: DVec3) -> DVec3 {
    let given: Vec<usize> = (0..3).filter(|axis| scope[*axis] > 1e-9).collect();
    let ratio = |axis: usize| if own[axis] > 1e-9 { scope[axis] / own[axis] } else { 1.0 };
    match given.as_slice() {
        [] => own,
        [one] => own * ratio(*one),
        [one, two] => {
            let mut size = scope;
            let missing = 3 - one - two;
            size[missing] = own[missing] * 0.5 * (ratio(*one) + ratio(*two));
            size
        }
        _ => scope,
    }
}
