//! From a map's own coordinates into the plan of the layout.
//!
//! A map without a system of its own lies in the layout's. Any system of the register can be brought into a layout in
//! degrees; other pairs are refused by name. Knows no pixels.

use crate::layout::{Crs, Georeference};
use crate::raster::Flaw;
use glam::DVec2;

/// The way from a map's coordinates to plan metres.
#[derive(Clone, Debug)]
pub struct Crossing {
    /// The map's own way to degrees, where it needs one.
    own: Option<Georeference>,
    layout: Georeference,
}

impl Crossing {
    /// The way of a map in `crs`, or in the layout's system where it names none, around a place of its own.
    pub fn new(crs: Option<Crs>, around: [f64; 2], layout: &Georeference) -> Result<Crossing, Flaw> {
        let own = match crs.filter(|crs| *crs != layout.crs) {
            None => None,
            Some(crs @ Crs::Epsg(_)) if layout.crs == Crs::Wgs84 => Some(Georeference::new(crs, around)?),
            Some(found) => return Err(Flaw::OtherSystem { found, layout: layout.crs.clone() }),
        };
        Ok(Crossing { own, layout: layout.clone() })
    }

    /// The map's coordinates → plan metres; not finite where they have no place in the plan.
    pub fn to_plan(&self, world: [f64; 2]) -> DVec2 {
        let Some(own) = &self.own else { return self.layout.to_plan(world) };
        own.lonlat(own.to_plan(world)).map_or(DVec2::NAN, |degrees| self.layout.to_plan(degrees))
    }
}
