//! Coordinate systems: from the layout's to local metres and back.

/// STUB replaced by the layout helper.
#[derive(Clone, Debug, PartialEq, Default)]
pub enum Crs {
    /// Degrees on WGS84: GeoJSON's own.
    #[default]
    Wgs84,
    /// Metres without a place on earth.
    Local,
    /// A projected system by EPSG code, in metres.
    Epsg(u16),
}

/// Why a coordinate system cannot be used.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum CrsError {
    /// It is not known by that name.
    #[error("the coordinate system `{0}` is not known")]
    Unknown(String),
}

/// The way from local plan metres back to the layout's own coordinates.
#[derive(Clone, Debug, Default)]
pub struct Georeference {
    /// The layout's system.
    pub crs: Crs,
    /// The layout's centre in its own coordinates (x or longitude, y or latitude).
    pub centre: [f64; 2],
}

impl Georeference {
    /// Plan metres → the layout's own coordinates.
    pub fn to_world(&self, _plan: glam::DVec2) -> [f64; 2] {
        unimplemented!()
    }
}
