//! Shapes: scope, geometry, attributes, and the tree a derivation makes of them.

mod chart;
mod derivation;
mod footprint;
mod geometry;
mod measure;
mod occluders;
mod scope;
mod state;
mod surface;
mod tag;

pub use chart::{Chart, Course, Way};
pub use derivation::{Derivation, LeafOf, Lot, Node, NodeId, Outcome, Print};
pub use footprint::{Extent, Footprint, on_plan};
pub use geometry::{Geometry, Grown, Placed, Plane};
pub use measure::Measure;
pub use occluders::{Occluder, Occluders, Relation};
pub use scope::{Axis, Frame, Scope};
pub use state::{Envelope, Ordinals, Place, Shape, Style};
pub use surface::Surface;
pub use tag::{Part, Patch, Tag};
