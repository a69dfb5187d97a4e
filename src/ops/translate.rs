//! `translate` and `rotate`: move and turn a shape within a chosen coordinate system.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, r, t};
use crate::shape::{Frame, Shape};
use crate::unit::Degrees;
use crate::value::Size;
use glam::DVec3;

operation! {
    /// Moves the shape within a coordinate system: by a distance, or to a place.
    ///
    /// The systems are those of the scope, of the pivot, of the initial shape (its origin is where the region's first
    /// edge begins) and of the world (x east, y up, z south).
    /// ```cga
    /// Lot --> [ Lawn ] s(14, 0, 12) [ Bed ] translate(rel, world, 18, 0, 10) Paving
    /// ```
    "translate" (CityEngine, None) => pub struct Move {
        /// By or to.
        mode: Mode,
        /// Whose axes and origin.
        system: System,
        /// Along x: metres, or with `'` a share of the scope.
        x: Size,
        /// Along y: metres, or with `'` a share of the scope.
        y: Size,
        /// Along z: metres, or with `'` a share of the scope.
        z: Size,
    }
}

operation! {
    /// Turns the shape about its pivot within a coordinate system: by angles, or to them; x first, then y, then z.
    /// ```cga
    /// Lot --> [ Lawn ] s(20, 0, 12) center(xz) [ Bed ] rotate(abs, world, 0, 30, 0) Paving
    /// ```
    "rotate" (CityEngine, None) => pub struct Turn {
        /// By or to.
        mode: Mode,
        /// Whose axes.
        system: System,
        /// About x (degrees).
        x: Degrees,
        /// About y (degrees).
        y: Degrees,
        /// About z (degrees).
        z: Degrees,
    }
}

choice! {
    /// Whether numbers are a difference or an end.
    pub enum Mode {
        /// To.
        Absolute = "abs",
        /// By.
        Relative = "rel",
    }
}

choice! {
    /// A coordinate system.
    pub enum System {
        /// The scope's.
        Scope = "scope",
        /// The pivot's.
        Pivot = "pivot",
        /// The initial shape's.
        Object = "object",
        /// The world's.
        World = "world",
    }
}

impl System {
    fn frame(self, shape: &Shape, given: &Given) -> Frame {
        match self {
            System::Scope => shape.scope.frame,
            System::Pivot => shape.pivot(),
            System::Object => {
                let first = given.outline.edges().next().map(|(a, _)| a).unwrap_or_default();
                let origin = DVec3::new(first.x, 0.0, -first.y);
                Frame { origin, rotation: shape.style.object }
            }
            System::World => Frame::WORLD,
        }
    }
}

impl Apply for Move {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let offset = t::lengths([self.x, self.y, self.z], shape.scope.size)?;
        let (before, system) = (shape.scope.frame, self.system.frame(shape, given));
        shape.scope.frame.origin = match self.mode {
            Mode::Absolute => system.to_world(offset),
            Mode::Relative => before.origin + system.rotation * offset,
        };
        shape.followed(before);
        Ok(Pieces::Changed)
    }
}

impl Apply for Turn {
    fn apply(self, shape: &mut Shape, given: &Given) -> Result<Pieces, Problem> {
        let turn = r::turn([self.x, self.y, self.z])?;
        let (before, axes) = (shape.scope.frame, self.system.frame(shape, given).rotation);
        let fixed = shape.pivot().origin;
        let rotation = match self.mode {
            Mode::Absolute => axes * turn,
            Mode::Relative => axes * turn * axes.inverse() * before.rotation,
        };
        let origin = fixed + rotation * (before.rotation.inverse() * (before.origin - fixed));
        shape.scope.frame = Frame { origin, rotation: rotation.normalize() };
        shape.followed(before);
        Ok(Pieces::Changed)
    }
}
