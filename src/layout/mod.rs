//! The layout: regions with their kinds, attributes, buildings and markers, and the way back to the world.
//!
//! Plan coordinates are metres around the layout's centre: x east, y north. Heights are metres.

mod crs;
mod geojson;
mod region;

pub use crs::{Crs, CrsError, Georeference};
pub use geojson::read_geojson;
pub use region::{Feature, Kind, Layout, Region, Shapes};
