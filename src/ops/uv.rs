//! Operations on texture coordinates: move, turn, scale, fit and tile them, copy and remove a set.
//!
//! They change the chart of a set, never the geometry; `split` along u and v and exports see it.

use crate::geometry::Bounds;
use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem, projection};
use crate::shape::{Shape, Way};
use crate::unit::Degrees;
use crate::value::Value;
use glam::{DAffine2, DMat2, DVec2};

operation! {
    /// Moves the texture coordinates of a set.
    ///
    /// Older rules write `offsetUV`.
    /// ```cga
    /// Lot --> translateUV(0, 0.5, 0) split(u, unitSpace, 0) { ~1 : Lawn | 3 : Gravel | ~1 : Bed }
    /// ```
    "translateUV" | "offsetUV" (CityEngine, None) => pub struct TranslateUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// Added to u.
        u: f64,
        /// Added to v.
        v: f64,
    }
}

operation! {
    /// Multiplies the texture coordinates of a set.
    /// ```cga
    /// Lot --> scaleUV(0, 4, 1) split(u, uvSpace, 0) { 0.5 : Lawn | 0.5 : Bed }*
    /// ```
    "scaleUV" (CityEngine, None) => pub struct ScaleUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// Factor of u.
        u: f64,
        /// Factor of v.
        v: f64,
    }
}

operation! {
    /// Turns the texture coordinates of a set about 0, so that what `split` calls u and v turns too.
    /// ```cga
    /// Lot --> rotateUV(0, 90) split(u, unitSpace, 0) { ~1 : Lawn | 3 : Gravel | ~1 : Lawn }
    /// ```
    "rotateUV" (CityEngine, None) => pub struct RotateUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// By how much (degrees, counter-clockwise).
        angle: Degrees,
    }
}

operation! {
    /// Scales and moves the texture coordinates of a set so that the shape runs from 0 to 1.
    ///
    /// `uvUniform` scales both alike, so that the longer side does.
    /// ```cga
    /// Lot --> split(x) { ~1 : Half | ~1 : Half }
    /// Half --> normalizeUV(0, uv, collectiveAllFaces) split(u, uvSpace, 0) { 0.25 : Gravel | ~1 : Lawn }
    /// ```
    "normalizeUV" (CityEngine, None) => pub struct NormalizeUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// Which of them.
        coordinates: Coordinates = Coordinates::Both => "uv",
        /// Each face by itself or all together: a shape has one chart, so both mean all.
        faces: Faces = Faces::Separate => "separatePerFace",
    }
}

operation! {
    /// Scales the texture coordinates of a set so that a texture is so many metres long and wide, from the shape's
    /// first u and v on.
    ///
    /// With `~` as many tiles fit as come nearest, with `'` a tile has that share of the shape; a negative size turns
    /// the texture round, 0 leaves that coordinate as it is.
    /// ```cga
    /// Lot --> tileUV(0, ~5, ~5) split(u, uvSpace, 0) { 0.8 : Bed | 0.2 : Gravel }*
    /// ```
    "tileUV" (CityEngine, None) => pub struct TileUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// A tile along u: metres, a share with `'`, about so many metres with `~`.
        width: Value,
        /// A tile along v, likewise.
        height: Value,
    }
}

operation! {
    /// Removes the texture coordinates of a set.
    ///
    /// Where none are left, `split` along u and v takes those that the shape has of itself.
    /// ```cga
    /// Lot --> rotateUV(0, 90) deleteUV(0) split(u, unitSpace, 0) { ~1 : Lawn | 3 : Gravel | ~1 : Bed }
    /// ```
    "deleteUV" (CityEngine, None) => pub struct DeleteUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
    }
}

operation! {
    /// Copies the texture coordinates of one set to another.
    /// ```cga
    /// Lot --> copyUV(0, 3) rotateUV(3, 90) split(u, unitSpace, 3) { ~1 : Lawn | 3 : Gravel | ~1 : Lawn }
    /// ```
    "copyUV" (CityEngine, None) => pub struct CopyUv {
        /// The set that is copied, 0 to 9.
        from: u32,
        /// The set that becomes like it, 0 to 9.
        to: u32,
    }
}

choice! {
    /// Texture coordinates.
    pub enum Coordinates {
        /// u
        U = "u",
        /// v
        V = "v",
        /// Both.
        Both = "uv",
        /// Both by the same factor.
        Uniform = "uvUniform",
    }
}

choice! {
    /// What counts as one.
    pub enum Faces {
        /// Each face.
        Separate = "separatePerFace",
        /// All faces.
        Collective = "collectiveAllFaces",
    }
}

impl Apply for TranslateUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        rescale(shape, self.uv_set, DAffine2::from_translation(DVec2::new(self.u, self.v)))
    }
}

impl Apply for ScaleUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        rescale(shape, self.uv_set, DAffine2::from_scale(DVec2::new(self.u, self.v)))
    }
}

impl Apply for RotateUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let (sin, cos) = match self.angle.0.rem_euclid(360.0) {
            // Right angles are exact, so that what was straight stays so.
            0.0 => (0.0, 1.0),
            90.0 => (1.0, 0.0),
            180.0 => (0.0, -1.0),
            270.0 => (-1.0, 0.0),
            angle => libm::sincos(Degrees(angle).radians()),
        };
        let turn = DMat2::from_cols(DVec2::new(cos, sin), DVec2::new(-sin, cos));
        rescale(shape, self.uv_set, DAffine2 { matrix2: turn, translation: DVec2::ZERO })
    }
}

impl Apply for NormalizeUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(extent) = extent(shape, self.uv_set) else { return Ok(Pieces::Changed) };
        // One chart lies under all faces.
        let (Faces::Separate | Faces::Collective) = self.faces;
        let size = extent.size().max(DVec2::splat(1e-12));
        let (scale, from) = match self.coordinates {
            Coordinates::U => (DVec2::new(1.0 / size.x, 1.0), DVec2::new(extent.min.x, 0.0)),
            Coordinates::V => (DVec2::new(1.0, 1.0 / size.y), DVec2::new(0.0, extent.min.y)),
            Coordinates::Both => (1.0 / size, extent.min),
            Coordinates::Uniform => (DVec2::splat(1.0 / size.max_element()), extent.min),
        };
        rescale(shape, self.uv_set, DAffine2::from_scale(scale) * DAffine2::from_translation(-from))
    }
}

impl Apply for TileUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let Some(extent) = extent(shape, self.uv_set) else { return Ok(Pieces::Changed) };
        let Some(chart) = shape.chart(self.uv_set) else { return Ok(Pieces::Changed) };
        let places = chart.places(shape);
        let mut map = DAffine2::IDENTITY;
        for (way, size) in [(Way::U, &self.width), (Way::V, &self.height)] {
            let (index, low) = (way.index(), extent.min[way.index()]);
            let (span, metres) = (extent.size()[index], chart.metres(way, low, extent.max[index], places));
            let Some(tiles) = projection::tiles(size, metres)?.filter(|_| span > 1e-12) else { continue };
            map.matrix2.col_mut(index)[index] = tiles / span;
            map.translation[index] = -low * tiles / span;
        }
        rescale(shape, self.uv_set, map)
    }
}

impl Apply for DeleteUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        if shape.attached().is_some_and(|surface| surface.chart(self.uv_set).is_some()) {
            shape.surface_mut().charts.retain(|(set, _)| *set != self.uv_set);
        }
        Ok(Pieces::Changed)
    }
}

impl Apply for CopyUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        shape.charted();
        if let Some(chart) = shape.chart(self.from) {
            shape.surface_mut().put_chart(self.to, chart);
        }
        Ok(Pieces::Changed)
    }
}

/// Lets u begin at 0 where the shape does.
pub(super) fn begun(shape: &mut Shape, set: u32) -> Result<(), Problem> {
    match extent(shape, set) {
        Some(extent) => rescale(shape, set, DAffine2::from_translation(DVec2::new(-extent.min.x, 0.0))).map(drop),
        None => Ok(()),
    }
}

/// Maps the texture coordinates of a set; what flattens them is refused.
fn rescale(shape: &mut Shape, set: u32, map: DAffine2) -> Result<Pieces, Problem> {
    if !map.is_finite() || map.matrix2.determinant().abs() < 1e-12 {
        return Err(Problem::new("texture coordinates cannot be scaled to nothing"));
    }
    shape.charted();
    if let Some(mut chart) = shape.chart(set) {
        chart.rescaled(map);
        shape.surface_mut().put_chart(set, chart);
    }
    Ok(Pieces::Changed)
}

fn extent(shape: &mut Shape, set: u32) -> Option<Bounds> {
    shape.charted();
    let extent = shape.chart(set)?.extent(shape);
    (!extent.is_empty()).then_some(extent)
}
