//! The scope: an oriented box that says where a shape is, how it is turned and how large it is.
//!
//! Frame: world x east, y up, −z north, metres. A scope's origin is the corner of its box with the least local
//! coordinates; a shape's geometry is given in local coordinates, so moving or turning a scope moves its geometry.

use glam::{DQuat, DVec3};

/// A right-handed coordinate frame in the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Frame {
    /// The origin in the world.
    pub origin: DVec3,
    /// Turns local directions into world directions.
    pub rotation: DQuat,
}

/// An oriented box.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Scope {
    /// The corner with the least coordinates, and the directions of the sides.
    pub frame: Frame,
    /// Lengths along local x, y and z; zero for flat, thin and point shapes.
    pub size: DVec3,
}

/// One of the three axes of a scope.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Axis {
    /// Along the first edge of a lot.
    X,
    /// Up.
    Y,
    /// Out of the front.
    Z,
}

impl Frame {
    /// The world's own frame.
    pub const WORLD: Frame = Frame { origin: DVec3::ZERO, rotation: DQuat::IDENTITY };

    /// A local point in the world.
    pub fn to_world(&self, local: DVec3) -> DVec3 {
        self.origin + self.rotation * local
    }

    /// A world point in this frame.
    pub fn to_local(&self, world: DVec3) -> DVec3 {
        self.rotation.inverse() * (world - self.origin)
    }

    /// The same frame with its origin moved by a local offset.
    pub fn moved(&self, local: DVec3) -> Frame {
        Frame { origin: self.to_world(local), rotation: self.rotation }
    }

    /// The same origin, turned by a local rotation.
    pub fn turned(&self, local: DQuat) -> Frame {
        Frame { origin: self.origin, rotation: (self.rotation * local).normalize() }
    }
}

impl Axis {
    /// Its index in a vector.
    pub fn index(self) -> usize {
        self as usize
    }

    /// Its direction.
    pub fn direction(self) -> DVec3 {
        DVec3::AXES[self.index()]
    }
}
