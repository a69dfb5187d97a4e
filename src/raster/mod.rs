//! Coverage maps: pictures and drawn polygons that say where plants may stand (Niese et al. 2022, §6.1 and §7.1).
//!
//! In: PNG, TIFF and GeoTIFF files with their world files, and GeoJSON files, all of them through
//! [`crate::world::World`]. Out: numbers at places of the plan, and areas in plan metres. Knows no rules and no shapes.
//!
//! A map is read once in a run: [`Rasters`] keeps it for all lots. The way from the file's coordinates to the plan is
//! exact at every point, however large the map is; nothing is resampled.

mod crossing;
mod drawn;
mod error;
mod footing;
mod geotiff;
mod map;
mod measure;
mod outline;
mod picture;
mod pixels;
mod rasters;
mod thin;
mod tiff;
mod trace;
mod world_file;

pub use drawn::Drawn;
pub use error::{Flaw, RasterError};
pub use map::Raster;
pub use measure::Measure;
pub use outline::without_trifles;
pub use rasters::Rasters;

/// More pixels than this in one raster are refused: cut it into tiles.
pub const MOST_PIXELS: u64 = 200_000_000;
/// More bytes than this in one decoded raster are refused.
pub const MOST_BYTES: usize = 1 << 30;
/// More pixels than this are not outlined for one shape.
pub const MOST_TRACED: usize = 40_000_000;
