//! A raster laid on the plan: values at places, and the area where they reach a threshold.

use crate::geometry::{Area, Bounds};
use crate::layout::Georeference;
use crate::raster::crossing::Crossing;
use crate::raster::footing::Footing;
use crate::raster::measure::Measure;
use crate::raster::pixels::Pixels;
use crate::raster::trace::Heights;
use crate::raster::{Flaw, MOST_TRACED, outline, picture, tiff, world_file};
use crate::world::{World, WorldError};
use glam::{DAffine2, DVec2};

/// Pixels around a part of the plan that are outlined with it: where an outline is cut off does not show within.
const MARGIN: f64 = 4.0;

/// A raster laid on the plan of a layout.
#[derive(Clone, Debug)]
pub struct Raster {
    pixels: Pixels,
    footing: Footing,
}

impl Raster {
    /// The raster in a PNG or TIFF, in the plan of a layout. The tags of a GeoTIFF say where it lies, else a world file
    /// beside it does; its coordinates are the layout's unless its tags name another system.
    pub fn read(path: &str, bytes: &[u8], world: &dyn World, layout: &Georeference) -> Result<Raster, Flaw> {
        let (pixels, tagged, crs) = if bytes.starts_with(picture::SIGNATURE) {
            (picture::read(bytes)?, None, None)
        } else if tiff::SIGNATURES.iter().any(|signature| bytes.starts_with(signature)) {
            let (pixels, tags) = tiff::read(bytes)?;
            (pixels, tags.map()?, tags.crs()?)
        } else {
            return Err(Flaw::Format);
        };
        let to_world = match tagged {
            Some(map) => map,
            None => beside(path, world)?,
        };
        let [width, height] = pixels.size().map(|side| side as f64 * 0.5);
        let middle = to_world.transform_point2(DVec2::new(width, height)).to_array();
        let footing = Footing::new(pixels.size(), to_world, Crossing::new(crs, middle, layout)?)?;
        Ok(Raster { pixels, footing })
    }

    /// Columns and rows.
    pub fn size(&self) -> [usize; 2] {
        self.pixels.size()
    }

    /// The side of a square pixel of the same area on the plan, metres.
    pub fn pixel(&self) -> f64 {
        self.footing.pixel()
    }

    /// The value at a place of the plan, interpolated between the centres of pixels: 0 to 1 for bytes and words, as it
    /// is for other numbers. None beyond the rim, where the raster says nothing, and where it has no such band.
    pub fn at(&self, place: DVec2, measure: &Measure) -> Option<f64> {
        let pixel = self.footing.to_pixel(place)?;
        let size = DVec2::new(self.size()[0] as f64, self.size()[1] as f64);
        if pixel.cmplt(DVec2::ZERO).any() || pixel.cmpgt(size).any() {
            return None;
        }
        let measure = measure.on(&self.pixels).ok()?;
        let own = pixel.min(size - 1.0).floor();
        measure.of(&self.pixels, own.x as usize, own.y as usize)?;
        let low = (pixel - 0.5).floor();
        let (mut sum, mut weights) = (0.0, 0.0);
        for corner in [DVec2::ZERO, DVec2::X, DVec2::Y, DVec2::ONE] {
            let weight = (DVec2::ONE - (pixel - 0.5 - low - corner).abs()).element_product();
            let node = (low + corner).clamp(DVec2::ZERO, size - 1.0);
            if let Some(value) = measure.of(&self.pixels, node.x as usize, node.y as usize) {
                sum += f64::from(value) * weight;
                weights += weight;
            }
        }
        (weights > 0.0).then(|| sum / weights)
    }

    /// The area around a part of the plan where the value is at least `threshold`, in plan metres.
    ///
    /// Its outline lies where the value interpolated between pixels is the threshold, give or take half a pixel; at
    /// the rim of the raster and of what it says nothing of, it follows the pixels. Within the bounds it is complete;
    /// what it does outside of them is no matter. Cost: linear in the pixels within the bounds, n log n in the outline.
    pub fn area(&self, measure: &Measure, threshold: f64, within: Bounds) -> Result<Area, Flaw> {
        let measure = measure.on(&self.pixels)?;
        let Some([left, top, right, bottom]) = self.window(within) else { return Ok(Area::empty()) };
        let size = [right - left, bottom - top];
        if size[0].saturating_mul(size[1]) > MOST_TRACED {
            return Err(Flaw::TooManyTraced(size[0].saturating_mul(size[1])));
        }
        let above = |(column, row): (usize, usize)| {
            let value = measure.of(&self.pixels, column, row);
            value.map_or(f32::NAN, |value| (f64::from(value) - threshold) as f32)
        };
        let nodes = (top..bottom).flat_map(|row| (left..right).map(move |column| (column, row)));
        let patches = Heights::new(size, nodes.map(above).collect()).patches();
        let corner = DVec2::new(left as f64, top as f64) + 0.5;
        Ok(outline::area(&patches, |p| self.footing.to_plan(corner + p)))
    }

    /// The columns and rows around a part of the plan, from and to; none where it lies beside the raster.
    fn window(&self, within: Bounds) -> Option<[usize; 4]> {
        let own = self.footing.bounds().grown(MARGIN * self.pixel());
        let within = Bounds { min: within.min.max(own.min), max: within.max.min(own.max) };
        if within.is_empty() {
            return None;
        }
        let along = [0.0, 0.5, 1.0];
        let places = along.iter().flat_map(|x| along.iter().map(|y| within.min + within.size() * DVec2::new(*x, *y)));
        let pixels = places.map(|place| self.footing.to_pixel(place)).collect::<Option<Vec<DVec2>>>()?;
        let around = Bounds::of(pixels).grown(MARGIN);
        let [width, height] = self.size();
        let whole = |x: f64, most: usize| x.clamp(0.0, most as f64) as usize;
        let (left, right) = (whole(around.min.x.floor(), width), whole(around.max.x.ceil(), width));
        let (top, bottom) = (whole(around.min.y.floor(), height), whole(around.max.y.ceil(), height));
        (left < right && top < bottom).then_some([left, top, right, bottom])
    }
}

/// The map of the first world file that there is.
fn beside(path: &str, world: &dyn World) -> Result<DAffine2, Flaw> {
    let names = world_file::names(path);
    for name in &names {
        match world.asset(name) {
            Ok(bytes) => {
                let broken = |reason| Flaw::WorldFile { path: name.clone(), reason };
                return world_file::parse(&bytes).map_err(broken);
            }
            Err(WorldError::Missing(_)) => {}
            Err(error) => return Err(error.into()),
        }
    }
    Err(Flaw::Placeless(names))
}
