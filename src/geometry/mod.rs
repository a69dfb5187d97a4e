//! Plane and solid geometry: the only room that knows the geometry crates.
//!
//! Polygons and areas, where a point lies in them, cutting, offsets, booleans, lines, triangles, even spreading,
//! grids, meshes. Knows nothing of shapes, scopes or the language.

mod boolean;
mod bounds;
mod clip;
mod convexify;
mod cut;
mod grid;
mod hull;
mod inner;
mod locate;
mod medial;
mod mesh;
mod offset;
mod overlay;
mod path;
mod polygon;
mod repair;
mod ribbon;
mod setback;
mod slab;
mod spread;
mod straight;
mod tidy;
mod triangulate;
mod twins;

pub use boolean::{difference, intersection, overlap_area, overlaps, union, union_all};
pub use bounds::Bounds;
pub use convexify::convexify;
pub use cut::{band, bands};
pub use grid::{BoxGrid, PointGrid};
pub use hull::{OrientedBox, convex_hull};
pub use inner::inner_rectangle;
pub use locate::{NearestEdge, nearest_on_segment};
pub use medial::{Branch, MedialAxis, Pruning};
pub use mesh::{Edge, Face, Mesh};
pub use offset::{buffered, inset, into_offset, offset};
pub use path::{Path, stroke};
pub use polygon::{Area, LEAST_AREA, Polygon, ring_area};
pub use repair::repair;
pub use ribbon::Ribbon;
pub use setback::{Setback, Strip, set_in, setback};
pub use slab::Sweep;
pub use spread::relax;
pub use straight::{StraightSkeleton, Unskeletal};
pub use tidy::{rectified, thinned};
pub use triangulate::triangulate;
