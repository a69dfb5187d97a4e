//! `insertAlongUV`: an element bent along texture coordinates: barriers, railings, hedges, markings on a lane.

use crate::geometry::Area;
use crate::ops::declare::operation;
use crate::ops::insert::{by_model, not_found};
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, Word, fit};
use crate::shape::{Geometry, Plane, Shape};
use crate::unit::Metres;
use crate::value::Value;
use std::sync::Arc;

operation! {
    /// Fills a flat shape with an element that follows its texture coordinates, up to a height.
    ///
    /// Plans show a body of the shape's own outline in the element's colour; scenes also carry the element's name, as
    /// `material.alongUV`, beside the texture coordinates along which it is bent.
    /// ```cga
    /// Lot --> split(v, unitSpace, 0) { 2 : insertAlongUV(0, "bench", 0.5) Seats. | ~1 : Lawn }
    /// ```
    "insertAlongUV" (CityEngine, None) => pub struct InsertAlongUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// The element's id, name or model.
        path: Word,
        /// How high it reaches (metres); 0 leaves the shape flat.
        height: Metres,
        /// Which way it stands: `scope.y` on the side that is up, `vertex.normal` along the normals.
        up: Up = Up::Scope => "scope.y",
        /// How it lies along u.
        fit: Fit = Fit::Align => "alignPosition",
    }
}

choice! {
    /// Which way an element stands.
    pub enum Up {
        /// Square to the shape, on the side that is up.
        Scope = "scope.y",
        /// Along the normals: the same on a flat shape.
        Normal = "vertex.normal",
    }
}

choice! {
    /// How an element lies along u.
    pub enum Fit {
        /// It begins where the shape does.
        Align = "alignPosition",
        /// It begins at u = 0.
        Keep = "keepPosition",
    }
}

impl Apply for InsertAlongUv {
    const UNSEEN: bool = true;

    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let found = given.catalogue.find(&self.path.0, "").or_else(|error| by_model(given, &self.path.0).ok_or(error));
        let found = found.map_err(not_found)?;
        let height = self.height.0;
        let (plane, area) = flat(shape)?;
        if height != 0.0 {
            let sign = self.up.sign(shape, &plane);
            fit::refit(shape, Geometry::Prism(plane, area, height * sign));
        }
        shape.charted();
        if self.fit == Fit::Align {
            super::uv::begun(shape, self.uv_set)?;
        }
        shape.surface_mut().put_material("alongUV".into(), Value::Text(found.entry.id.clone()));
        Arc::make_mut(&mut shape.style).color.get_or_insert(found.entry.color);
        Ok(Pieces::Changed)
    }
}

impl Up {
    /// 1 where it is the way of the plane's normal, -1 where it is against it.
    fn sign(self, shape: &Shape, plane: &Plane) -> f64 {
        match self {
            Up::Normal => 1.0,
            Up::Scope if (shape.scope.frame.rotation * plane.normal()).y < -1e-9 => -1.0,
            Up::Scope => 1.0,
        }
    }
}

fn flat(shape: &Shape) -> Result<(Plane, Area), Problem> {
    match &shape.geometry {
        Geometry::Flat(plane, area) => Ok((plane.clone(), area.clone())),
        _ => Err(Problem::new("`insertAlongUV` takes flat shapes").hint("`comp(f)` takes the faces of a solid")),
    }
}
