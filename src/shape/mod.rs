//! Shapes: scope, geometry, attributes, and the tree a derivation makes of them.

mod derivation;
mod geometry;
mod scope;
mod shape;

pub use derivation::{Derivation, LeafOf, Lot, Node, NodeId, Outcome, Print};
pub use geometry::{Geometry, Placed, Plane};
pub use scope::{Axis, Frame, Scope};
pub use shape::{Ordinals, Shape, Style};
