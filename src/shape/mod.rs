//! Shapes: scope, geometry, attributes, and the tree a derivation makes of them.

mod chart;
mod derivation;
mod direction;
mod facing;
mod footprint;
mod gap;
mod geometry;
mod measure;
mod occluders;
mod record;
mod scope;
mod state;
mod streets;
mod surface;
mod tag;

pub use chart::{Chart, Course, Way};
pub use derivation::{Derivation, LeafOf, Lot, Node, NodeId, Outcome, Print};
pub use direction::{Facing, Space};
pub use footprint::{Extent, Footprint, on_plan};
pub use geometry::{Geometry, Grown, Placed, Plane};
pub use measure::Measure;
pub use occluders::{Occluder, Occluders, Relation};
pub use record::{Deed, Event, Passage, Record};
pub use scope::{Axis, Frame, Scope};
pub use state::{Envelope, Ordinals, Place, Shape, Style};
pub use streets::{StreetSide, Streets};
pub use surface::Surface;
pub use tag::{Part, Patch, Tag};
