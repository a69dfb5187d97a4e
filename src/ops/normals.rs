//! `setNormals`, `softenNormals` and `reduceGeometry`: accepted, and said to change nothing.
//!
//! They tell CityEngine's renderer how to shade and how much to load. Faces here are flat polygons with one normal each,
//! and exports draw every corner, so there is nothing to change; a note says so.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Effect, Given, Pieces, Problem, Remark};
use crate::shape::Shape;
use crate::unit::Degrees;

operation! {
    /// Sets how vertices are shaded in CityEngine; here it changes nothing, and a note says so.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { ~1 : Ball | ~1 : Ball }
    /// Ball --> s(12, 12, 12) center(xz) primitiveSphere(24, 12) setNormals(soft) Topiary
    /// ```
    "setNormals" (CityEngine, None) => pub struct SetNormals {
        /// How vertices are shaded.
        mode: Mode = Mode::Auto => "auto",
    }
}

operation! {
    /// Shades edges softly in CityEngine; here it changes nothing, and a note says so.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { ~1 : Ball | ~1 : Ball }
    /// Ball --> s(12, 12, 12) center(xz) primitiveSphere(24, 12) softenNormals(30) Topiary
    /// ```
    "softenNormals" (CityEngine, None) => pub struct SoftenNormals {
        /// Between faces up to this angle (degrees).
        angle: Degrees,
    }
}

operation! {
    /// Loads less of a mesh in CityEngine; here it changes nothing, and a note says so.
    /// ```cga
    /// Lot --> [ Lawn ] split(x) { ~1 : Ball(0) | ~1 : Ball(0.8) }
    /// Ball(part) --> s(14, 14, 14) center(xz) primitiveSphere(24, 12) reduceGeometry(part) Topiary
    /// ```
    "reduceGeometry" (CityEngine, None) => pub struct ReduceGeometry {
        /// The share of vertices that goes, 0 to 1.
        reduction: f64,
    }
}

choice! {
    /// How CityEngine makes vertex normals.
    pub enum Mode {
        /// By the angle between faces.
        Auto = "auto",
        /// One for all faces at a vertex.
        Soft = "soft",
        /// One for each face.
        Hard = "hard",
        /// As they are.
        Conservative = "conservative",
    }
}

impl Apply for SetNormals {
    fn apply(self, _: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        // What is to stay as it is does.
        Ok(if self.mode == Mode::Conservative { Pieces::Changed } else { without_effect("setNormals") })
    }
}

impl Apply for SoftenNormals {
    fn apply(self, _: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        match self.angle.0 {
            0.0..=180.0 => Ok(without_effect("softenNormals")),
            angle => Err(Problem::new(format!("an angle between faces lies from 0 to 180 degrees, found {angle}"))),
        }
    }
}

impl Apply for ReduceGeometry {
    fn apply(self, _: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        match self.reduction {
            0.0..=1.0 => Ok(without_effect("reduceGeometry")),
            share => Err(Problem::new(format!("the share of vertices that goes lies from 0 to 1, found {share}"))),
        }
    }
}

fn without_effect(name: &str) -> Pieces {
    let message = format!("`{name}` changes nothing: faces are drawn and written as they are");
    Pieces::Told(Effect::Remark(Remark { message, parameter: None, is_note: true }))
}
