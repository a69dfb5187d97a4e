//! `rotateScope`, `mirrorScope`, `setPivot`: turn the frame of a shape, not its geometry.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, align_scope_to_axes, r};
use crate::shape::{Frame, Shape};
use crate::unit::Degrees;
use glam::{DMat3, DQuat, DVec3};

operation! {
    /// Turns the scope about its axes and fits it again; the geometry stays where it is.
    /// ```cga
    /// Lot --> rotateScope(0, 90, 0) split(x) { 4 : Hedge | ~1 : Lawn | 8 : Bed }
    /// ```
    "rotateScope" (CityEngine, None) => pub struct RotateScope {
        /// About x (degrees).
        x: Degrees,
        /// About y (degrees).
        y: Degrees,
        /// About z (degrees).
        z: Degrees,
    }
}

operation! {
    /// Turns axes of the scope round; the geometry stays where it is.
    ///
    /// A scope stays right-handed: with x or y alone z turns round too, with z alone x, and all three are x and z.
    /// ```cga
    /// Lot --> mirrorScope(true, false, false) split(x) { 12 : Bed | 2 : Gravel | ~1 : Lawn }
    /// ```
    "mirrorScope" (CityEngine, None) => pub struct MirrorScope {
        /// Whether x is turned round.
        x: bool,
        /// Whether y is.
        y: bool,
        /// Whether z is.
        z: bool,
    }
}

operation! {
    /// Puts the pivot, about which `r` and `rotate` turn, at a corner of the scope.
    ///
    /// Corners 0 to 3 are those at y = 0, 4 to 7 those above: the origin, then along x, then both, then along z.
    /// ```cga
    /// Lot --> [ Lawn ] s(20, 0, 12) t(10, 0, 9) [ Bed ] setPivot(xyz, 2) r(0, 30, 0) Paving
    /// ```
    "setPivot" (CityEngine, None) => pub struct SetPivot {
        /// Which axes of the scope are the pivot's x, y and z.
        axes: AxisMap,
        /// The corner, 0 to 7.
        corner: f64,
    }
}

choice! {
    /// The axes in another order.
    pub enum AxisMap {
        /// x, y, z
        Xyz = "xyz",
        /// y, z, x
        Yzx = "yzx",
        /// z, x, y
        Zxy = "zxy",
        /// x, z, y
        Xzy = "xzy",
        /// z, y, x
        Zyx = "zyx",
        /// y, x, z
        Yxz = "yxz",
    }
}

impl Apply for RotateScope {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let turn = r::turn([self.x, self.y, self.z])?;
        align_scope_to_axes::turn(shape, (shape.scope.frame.rotation * turn).normalize());
        Ok(Pieces::Changed)
    }
}

impl Apply for MirrorScope {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let about = match (self.x, self.y, self.z) {
            (false, false, false) => return Ok(Pieces::Changed),
            (false, true, _) => DVec3::X,
            (true, true, false) => DVec3::Z,
            _ => DVec3::Y,
        };
        let half = DQuat::from_xyzw(about.x, about.y, about.z, 0.0);
        align_scope_to_axes::turn(shape, (shape.scope.frame.rotation * half).normalize());
        Ok(Pieces::Changed)
    }
}

impl Apply for SetPivot {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let corner = self.corner.round();
        if !(0.0..8.0).contains(&corner) {
            return Err(Problem::new(format!("there is no corner {}", self.corner)).hint("a scope has 0 to 7"));
        }
        let corner = corner as usize;
        let share = DVec3::new(
            f64::from(u8::from(matches!(corner % 4, 1 | 2))),
            (corner / 4) as f64,
            f64::from(u8::from(corner % 4 >= 2)),
        );
        let frame = shape.scope.frame;
        let origin = frame.to_world(share * shape.scope.size);
        let rotation = (frame.rotation * self.axes.turn()).normalize();
        shape.surface_mut().pivot = Some(Frame { origin, rotation });
        Ok(Pieces::Changed)
    }
}

impl AxisMap {
    /// Where an odd order would turn right into left, its last axis points back.
    fn turn(self) -> DQuat {
        let [x, y, z] = DVec3::AXES;
        let columns = match self {
            AxisMap::Xyz => [x, y, z],
            AxisMap::Yzx => [y, z, x],
            AxisMap::Zxy => [z, x, y],
            AxisMap::Xzy => [x, z, -y],
            AxisMap::Zyx => [z, y, -x],
            AxisMap::Yxz => [y, x, -z],
        };
        DQuat::from_mat3(&DMat3::from_cols(columns[0], columns[1], columns[2]))
    }
}
