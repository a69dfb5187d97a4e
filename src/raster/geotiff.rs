//! The georeferencing tags of a GeoTIFF (OGC 19-008r4) → the map from pixels to coordinates, and their system.

use crate::layout::Crs;
use crate::raster::Flaw;
use glam::{DAffine2, DVec2};

/// The tags as they stand in the file; empty where they do not.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Tags {
    /// ModelPixelScale: the size of a pixel.
    pub scale: Vec<f64>,
    /// ModelTiepoint: places of the raster and of the world, six numbers each.
    pub ties: Vec<f64>,
    /// ModelTransformation: a 4 × 4 matrix, row by row.
    pub matrix: Vec<f64>,
    /// GeoKeyDirectory: four numbers a key.
    pub keys: Vec<u16>,
}

/// Where pixel 0, 0 is: a corner or a centre.
const RASTER_TYPE: u16 = 1025;
/// The number of RASTER_TYPE for centres.
const PIXEL_IS_POINT: u16 = 2;
/// The EPSG code of degrees.
const GEODETIC: u16 = 2048;
/// The EPSG code of a projected system.
const PROJECTED: u16 = 3072;
/// “It is described elsewhere in the file.”
const USER_DEFINED: u16 = 32767;

impl Tags {
    /// The map from pixels, the upper left corner of the raster at 0, 0 and y downwards, to its coordinates; none
    /// where no tag says so.
    pub fn map(&self) -> Result<Option<DAffine2>, Flaw> {
        let map = match (&self.matrix[..], &self.scale[..], &self.ties[..]) {
            ([a, b, _, d, e, f, _, h, ..], ..) if self.matrix.len() == 16 => {
                DAffine2::from_cols(DVec2::new(*a, *e), DVec2::new(*b, *f), DVec2::new(*d, *h))
            }
            ([], [sx, sy, ..], [i, j, _, x, y, _]) => {
                let origin = DVec2::new(x - i * sx, y + j * sy);
                DAffine2::from_cols(DVec2::new(*sx, 0.0), DVec2::new(0.0, -sy), origin)
            }
            ([], [], []) => return Ok(None),
            ([], [], _) => return Err(Flaw::Place("it is tied to the ground by points alone: warp it first".into())),
            _ => return Err(Flaw::Place("its tags have too few or too many numbers".into())),
        };
        // The centre of the first pixel has the coordinates that its corner would have.
        let shift = if self.key(RASTER_TYPE) == Some(PIXEL_IS_POINT) { 0.5 } else { 0.0 };
        Ok(Some(map * DAffine2::from_translation(DVec2::splat(-shift))))
    }

    /// The system of its coordinates; none where it names none.
    pub fn crs(&self) -> Result<Option<Crs>, Flaw> {
        let code = self.key(PROJECTED).or_else(|| self.key(GEODETIC)).filter(|code| *code != 0);
        match code {
            None => Ok(None),
            Some(USER_DEFINED) => Err(Flaw::Place("its system has no EPSG code".into())),
            Some(code) => Ok(Some(Crs::parse(&format!("EPSG:{code}"))?)),
        }
    }

    /// The number that stands in the directory for a key.
    fn key(&self, key: u16) -> Option<u16> {
        let entries = self.keys.chunks_exact(4).skip(1);
        entries.filter(|entry| entry[0] == key && entry[1] == 0).map(|entry| entry[3]).next()
    }
}
