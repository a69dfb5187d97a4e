//! `inline`, `union`, `subtract` and `intersect`: shapes derived inside a rule become the current shape.
//!
//! In: what the engine derived of each part of the block, as leaves. Out: the current shape with their geometry. Flat
//! shapes and prisms over one plane are computed exactly ([`level`]); other meshes are put together as they are.

mod level;
mod stack;

use crate::geometry::Mesh;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, fit};
use crate::shape::{Geometry, Shape};
use glam::DAffine3;
use level::{Keep, Levels};
use std::sync::Arc;

operation! {
    /// Derives a rule, an operation or a block in place: what it makes becomes the current shape, and the rule goes on
    /// with that.
    ///
    /// Without braces one operation or rule follows: `inline(unify) Beds`. A single shape is taken as it is, with its
    /// scope; of several the geometry is put together and what they agree in is kept. `append` leaves parts as they
    /// are, `unify` and `recompose` make one of those that overlap or touch. Plants, things, lines and points cannot
    /// become part of a shape: they are built as they are.
    /// ```cga
    /// Lot  --> [ Lawn ] inline(unify) { split(x) { ~1 : Part | ~2 : NIL | ~1 : Part } } offset(-1, inside) Bed.
    /// Part --> offset(-2, inside)
    /// ```
    "inline" (CityEngine, Operands(1)) => pub struct Inline {
        /// How several shapes are put together.
        strategy: Strategy = Strategy::Append => "append",
    }
}

operation! {
    /// What lies in either of two derivations of the current shape.
    ///
    /// Both parts are derived in place; the first decides about colour and attributes. Flat shapes in one plane and
    /// prisms over one plane are united exactly; other solids are put together as they are.
    /// ```cga
    /// Lot --> [ Lawn ] union { s('1, '1, 8) center(z) | s(8, '1, '1) center(x) } Gravel
    /// ```
    "union" (CityEngine, Operands(2)) => pub struct Union {}
}

operation! {
    /// What the first of two derivations of the current shape has and the second has not.
    ///
    /// Flat shapes lose what lies in others of their plane and in prisms through it; prisms lose prisms over the same
    /// plane. What is taken off wholly is deleted.
    /// ```cga
    /// Lot --> subtract { Keep. | s(20, '1, 20) center(xz) primitiveDisk(48) } Lawn
    /// ```
    "subtract" (CityEngine, Operands(2)) => pub struct Subtract {}
}

operation! {
    /// What two derivations of the current shape have in common.
    /// ```cga
    /// Lot --> [ Lawn ] intersect { Disk | t(14, 0, 0) Disk } Water
    /// Disk --> s(26, '1, 26) center(z) primitiveDisk(48)
    /// ```
    "intersect" (CityEngine, Operands(2)) => pub struct Intersect {}
}

choice! {
    /// How shapes are put together.
    pub enum Strategy {
        /// As they are.
        Append = "append",
        /// United.
        Unify = "unify",
        /// Joined where they touch; bosquet unites them.
        Recompose = "recompose",
    }
}

impl Apply for Inline {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let [made] = given.operands else { return Ok(Pieces::Vanished) };
        match made.as_slice() {
            [] => shape.geometry = Geometry::Empty,
            [only] => take(shape, only),
            several => {
                let united = match self.strategy {
                    Strategy::Append => Levels::of(several, shape).and_then(Levels::beside),
                    Strategy::Unify | Strategy::Recompose => {
                        Levels::of(several, shape).and_then(|levels| levels.combined(&Levels::none(), Keep::Either))
                    }
                };
                agree(shape, several);
                match united {
                    Some(levels) => levels.become_of(shape),
                    None => append(shape, several),
                }
            }
        }
        Ok(Pieces::left_of(shape))
    }
}

impl Apply for Union {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        both(shape, given, "union", Keep::Either)
    }
}

impl Apply for Subtract {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        both(shape, given, "subtract", Keep::First)
    }
}

impl Apply for Intersect {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        both(shape, given, "intersect", Keep::Common)
    }
}

fn both(shape: &mut Shape, given: &Given, name: &str, keep: Keep) -> Result<Pieces, Problem> {
    let [first, second] = given.operands else { return Ok(Pieces::Vanished) };
    let all: Vec<Shape> = first.iter().chain(second).cloned().collect();
    let plane = Levels::plane(&all, shape);
    let levels = |part: &[Shape]| Levels::over(part, shape, plane.as_ref()?);
    let combined = match (levels(first), levels(second)) {
        (Some(a), Some(b)) => a.combined(&b, keep),
        _ => None,
    };
    agree(shape, if first.is_empty() { second } else { first });
    match combined {
        Some(levels) => levels.become_of(shape),
        None if keep == Keep::Either => append(shape, &all),
        None => {
            let problem = Problem::new(format!("`{name}` takes flat shapes in one plane, or prisms over one plane"));
            return Err(problem.hint("extrude after it: what is flat is cut exactly"));
        }
    }
    Ok(Pieces::left_of(shape))
}

/// A single result, with its scope and all; the place in the derivation stays.
fn take(shape: &mut Shape, made: &Shape) {
    let (ordinals, seed) = (shape.ordinals, shape.seed);
    *shape = Shape { ordinals, seed, ..made.clone() };
}

/// What all results have alike is the shape's.
fn agree(shape: &mut Shape, made: &[Shape]) {
    let Some((first, rest)) = made.split_first() else { return };
    if rest.iter().all(|other| other.style == first.style) {
        shape.style = first.style.clone();
    }
    if rest.iter().all(|other| other.attributes == first.attributes) {
        shape.attributes = first.attributes.clone();
    }
}

/// The faces of all results as they are, in the frame of the shape.
fn append(shape: &mut Shape, made: &[Shape]) {
    let frame = shape.scope.frame;
    let into = DAffine3::from_rotation_translation(frame.rotation, frame.origin).inverse();
    let mut mesh = Mesh::default();
    made.iter().filter_map(Shape::world_mesh).for_each(|part| mesh.append(&part.transformed(&into)));
    let geometry = if mesh.faces.is_empty() { Geometry::Empty } else { Geometry::Mesh(Arc::new(mesh)) };
    fit::refit(shape, geometry);
}
