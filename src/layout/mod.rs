//! The layout: regions with their kinds, attributes, buildings and markers, and the way back to the world.
//!
//! Plan coordinates are metres around the layout's centre: x east, y north. Heights are metres.

mod crs;
mod geojson;
mod georeference;
mod mercator;
mod region;

pub use crs::{Crs, CrsError};
pub use geojson::read_geojson;
pub use georeference::Georeference;
pub use region::{Feature, Kind, Layout, Region, Shapes};
