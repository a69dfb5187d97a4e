//! Plane and solid geometry: the only room that knows the geometry crates.

mod bounds;
mod mesh;
mod polygon;

pub use bounds::Bounds;
pub use mesh::Mesh;
pub use polygon::{Area, LEAST_AREA, Polygon, ring_area};
