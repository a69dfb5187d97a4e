//! `setupProjection` and `projectUV`: texture coordinates by two axes of the scope or the world.

use crate::ops::declare::operation;
use crate::ops::spec::choice;
use crate::ops::{Apply, Given, Pieces, Problem};
use crate::shape::{Chart, Course, Frame, Shape};
use crate::value::{Size, Value};
use glam::{DAffine2, DAffine3, DMat3, DVec2, DVec3};

operation! {
    /// Prepares texture coordinates for `projectUV`: u and v along two axes, a texture so many metres long and wide.
    ///
    /// It lies in the world from now on and moves with the shape. With `'` a texture has that share of the scope, with
    /// `~` as many fit into the scope as come nearest.
    /// ```cga
    /// Lot --> setupProjection(0, world.xz, 8, 8) projectUV(0) split(u, uvSpace, 0) { 0.8 : Lawn | 0.2 : Gravel }*
    /// ```
    "setupProjection" (CityEngine, None) => pub struct SetupProjection {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
        /// The axes for u and v.
        axes: Axes,
        /// A texture along u: metres, a share with `'`, about so many metres with `~`.
        width: Value,
        /// A texture along v, likewise.
        height: Value,
        /// Where it begins along u, metres or a share.
        width_offset: Value = Value::Float(0.0) => "0",
        /// Where it begins along v, metres or a share.
        height_offset: Value = Value::Float(0.0) => "0",
        /// The factor of a third coordinate, which bosquet does not use.
        uw_factor: f64 = 0.0 => "0",
    }
}

operation! {
    /// Gives a set the texture coordinates that `setupProjection` prepared; else those of the scope's x and y.
    /// ```cga
    /// Lot --> setupProjection(0, world.xz, 10, 10) projectUV(0) split(u, uvSpace, 0) { 1 : Lawn | 1 : Gravel }*
    /// ```
    "projectUV" (CityEngine, None) => pub struct ProjectUv {
        /// The set of texture coordinates, 0 to 9.
        uv_set: u32,
    }
}

choice! {
    /// Two axes of the scope or the world.
    pub enum Axes {
        /// The scope's x and y.
        ScopeXy = "scope.xy",
        /// The scope's x and z.
        ScopeXz = "scope.xz",
        /// The scope's y and x.
        ScopeYx = "scope.yx",
        /// The scope's y and z.
        ScopeYz = "scope.yz",
        /// The scope's z and x.
        ScopeZx = "scope.zx",
        /// The scope's z and y.
        ScopeZy = "scope.zy",
        /// The world's x and y.
        WorldXy = "world.xy",
        /// The world's x and z.
        WorldXz = "world.xz",
        /// The world's y and x.
        WorldYx = "world.yx",
        /// The world's y and z.
        WorldYz = "world.yz",
        /// The world's z and x.
        WorldZx = "world.zx",
        /// The world's z and y.
        WorldZy = "world.zy",
    }
}

impl Axes {
    fn pair(self) -> [usize; 2] {
        match self {
            Axes::ScopeXy | Axes::WorldXy => [0, 1],
            Axes::ScopeXz | Axes::WorldXz => [0, 2],
            Axes::ScopeYx | Axes::WorldYx => [1, 0],
            Axes::ScopeYz | Axes::WorldYz => [1, 2],
            Axes::ScopeZx | Axes::WorldZx => [2, 0],
            Axes::ScopeZy | Axes::WorldZy => [2, 1],
        }
    }

    fn is_world(self) -> bool {
        use Axes as A;
        matches!(self, A::WorldXy | A::WorldXz | A::WorldYx | A::WorldYz | A::WorldZx | A::WorldZy)
    }
}

impl Apply for SetupProjection {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        if !self.uw_factor.is_finite() {
            return Err(Problem::new(format!("{} is not a factor", self.uw_factor)));
        }
        let [along, across] = self.axes.pair();
        let size = DVec2::new(shape.scope.size[along], shape.scope.size[across]);
        let mut scale = DVec2::ONE;
        for (index, wanted) in [&self.width, &self.height].into_iter().enumerate() {
            if let Some(tiles) = tiles(wanted, size[index])? {
                scale[index] = tiles / if size[index] > 1e-12 { size[index] } else { 1.0 };
            }
        }
        let from = DVec2::new(length(&self.width_offset, size.x)?, length(&self.height_offset, size.y)?);
        let frame = if self.axes.is_world() { Frame::WORLD } else { shape.scope.frame };
        let mut chart = projected(&frame, along, across);
        chart.rescaled(DAffine2::from_scale(scale) * DAffine2::from_translation(-from));
        shape.surface_mut().put_projection(self.uv_set, chart);
        Ok(Pieces::Changed)
    }
}

impl Apply for ProjectUv {
    fn apply(self, shape: &mut Shape, _: &Given) -> Result<Pieces, Problem> {
        let prepared = shape.attached().and_then(|surface| {
            surface.projections.iter().find(|(set, _)| *set == self.uv_set).map(|(_, chart)| chart.clone())
        });
        let chart = prepared.unwrap_or_else(|| projected(&shape.scope.frame, 0, 1));
        shape.surface_mut().put_chart(self.uv_set, chart);
        Ok(Pieces::Changed)
    }
}

/// Metres along two axes of a frame.
fn projected(frame: &Frame, along: usize, across: usize) -> Chart {
    let [u, v] = [along, across].map(|axis| DVec3::AXES[axis]);
    let axes = DMat3::from_cols(frame.rotation * u, frame.rotation * v, frame.rotation * u.cross(v));
    let plane = DAffine3 { matrix3: axes, translation: frame.origin }.inverse();
    Chart { plane, course: Course::Straight, scale: DAffine2::IDENTITY }
}

/// How many tiles of a size fill so many metres; of a length without metres, tiles a metre. `None` for the size 0.
pub(super) fn tiles(size: &Value, metres: f64) -> Result<Option<f64>, Problem> {
    let whole = if metres > 1e-12 { metres } else { 1.0 };
    let tiles = match size {
        Value::Size(Size::Relative(share)) => 1.0 / share,
        Value::Size(Size::Floating(about)) => {
            let count = (whole / about.abs()).round().max(1.0);
            count.copysign(*about)
        }
        other => whole / length(other, metres)?,
    };
    if tiles.is_nan() {
        return Err(Problem::new(format!("a texture cannot be `{size}` long")));
    }
    Ok((tiles.is_finite() && tiles != 0.0).then_some(tiles))
}

/// Metres, or a share of some.
fn length(size: &Value, of: f64) -> Result<f64, Problem> {
    let metres = match size {
        Value::Size(Size::Relative(share) | Size::Floating(share)) => Some(share * of),
        other => other.as_float(),
    };
    metres.filter(|m| !m.is_nan()).ok_or_else(|| Problem::new(format!("`{size}` is not a length of a texture")))
}
