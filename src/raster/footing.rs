//! Between pixels and the plan.
//!
//! Pixels are counted in columns and rows from the upper left corner of the raster, y downwards; the centre of the
//! first lies at 0.5, 0.5. The way to the plan is the file's own affine map and then the projection. Back, an affine
//! map fitted to the raster's corners is corrected until it is right (Newton's method): projections bend little over
//! a raster, so two or three steps do.

use crate::geometry::Bounds;
use crate::raster::Flaw;
use crate::raster::crossing::Crossing;
use glam::{DAffine2, DVec2};

/// Where a projection bends less than this (metres) over the raster, it is the affine map.
const STRAIGHT: f64 = 1e-6;
/// The way back ends this near (metres).
const EXACT: f64 = 1e-7;
/// A raster whose pixels come back farther off than this (metres) is refused.
const TOLERANCE: f64 = 0.01;
/// Steps of the way back, at most.
const STEPS: usize = 12;
/// Places along each side of a raster where its way is tried.
const TRIALS: [f64; 5] = [0.0, 0.25, 0.5, 0.75, 1.0];

/// Where the pixels of a raster lie.
#[derive(Clone, Debug)]
pub struct Footing {
    to_world: DAffine2,
    crossing: Crossing,
    near: DAffine2,
    back: DAffine2,
    is_straight: bool,
    bounds: Bounds,
}

impl Footing {
    /// The footing of a raster of that size, by its map to its own coordinates and their way into the plan.
    pub fn new(size: [usize; 2], to_world: DAffine2, crossing: Crossing) -> Result<Footing, Flaw> {
        let size = DVec2::new(size[0] as f64, size[1] as f64);
        let place = |x: f64, y: f64| crossing.to_plan(to_world.transform_point2(size * DVec2::new(x, y)).to_array());
        let near = fitted([place(0.0, 0.0), place(1.0, 0.0), place(0.0, 1.0), place(1.0, 1.0)], size);
        let back = near.inverse();
        // Against its sides, since a pixel may be a millimetre or a kilometre wide.
        let sides = near.x_axis.length() * near.y_axis.length();
        let is_wide = near.matrix2.determinant().abs() > 1e-6 * sides && sides > 0.0;
        if !near.is_finite() || !back.is_finite() || !is_wide {
            return Err(Flaw::NoExtent);
        }
        let bounds = Bounds::EMPTY;
        let mut footing = Footing { to_world, crossing, near, back, is_straight: false, bounds };
        let trials = || TRIALS.iter().flat_map(|x| TRIALS.iter().map(|y| size * DVec2::new(*x, *y)));
        footing.is_straight = trials().all(|p| footing.to_plan(p).distance(near.transform_point2(p)) < STRAIGHT);
        footing.bounds = Bounds::of(trials().map(|p| footing.to_plan(p)));
        let returns = |p: DVec2| {
            let plan = footing.to_plan(p);
            footing.to_pixel(plan).is_some_and(|q| footing.to_plan(q).distance(plan) < TOLERANCE)
        };
        if trials().all(returns) { Ok(footing) } else { Err(Flaw::Unplaceable) }
    }

    /// A place of the raster on the plan.
    pub fn to_plan(&self, pixel: DVec2) -> DVec2 {
        if self.is_straight {
            return self.near.transform_point2(pixel);
        }
        self.crossing.to_plan(self.to_world.transform_point2(pixel).to_array())
    }

    /// A place of the plan on the raster or beside it; none where the projection does not lead there.
    pub fn to_pixel(&self, plan: DVec2) -> Option<DVec2> {
        let mut pixel = self.back.transform_point2(plan);
        for _ in 0..if self.is_straight { 0 } else { STEPS } {
            let off = plan - self.to_plan(pixel);
            if off.length() < EXACT {
                break;
            }
            pixel += self.back.transform_vector2(off);
        }
        pixel.is_finite().then_some(pixel)
    }

    /// The extent of the raster on the plan; what a projection bulges beyond it is far less than a pixel.
    pub fn bounds(&self) -> Bounds {
        self.bounds
    }

    /// The side of a square pixel of the same area, metres.
    pub fn pixel(&self) -> f64 {
        self.near.matrix2.determinant().abs().sqrt()
    }
}

/// The affine map that takes the corners of a raster nearest to where they lie: the mean of its sides.
fn fitted([a, b, c, d]: [DVec2; 4], size: DVec2) -> DAffine2 {
    let (across, down) = ((b - a + d - c) * 0.5, (c - a + d - b) * 0.5);
    let middle = (a + b + c + d) * 0.25;
    DAffine2::from_cols(across / size.x, down / size.y, middle - (across + down) * 0.5)
}
