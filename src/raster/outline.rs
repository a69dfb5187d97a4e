//! Patches of pixels → areas in plan metres, and areas without what is too small to matter.

use crate::geometry::{Area, Polygon, difference, repair, ring_area, union_all};
use crate::raster::thin::thinned;
use crate::raster::trace::Patch;
use glam::DVec2;

/// Outlines give up vertices within this of what is left, in pixels: the stairs of a mask are no higher.
const TOLERANCE: f64 = 0.5;

/// The area of patches whose rings are in pixels, by their way to the plan.
pub fn area(patches: &[Patch], to_plan: impl Fn(DVec2) -> DVec2) -> Area {
    let on_plan = |ring: &Vec<DVec2>| -> Area {
        let ring: Vec<DVec2> = thinned(ring, TOLERANCE).into_iter().map(&to_plan).collect();
        repair(&[ring]).0
    };
    let pierced = |patch: &Patch| {
        let holes: Vec<Area> = patch.holes.iter().map(on_plan).collect();
        difference(&on_plan(&patch.outer), &union_all(&holes))
    };
    // Thinned patches can overlap their neighbours by a fraction of a pixel.
    union_all(&patches.iter().map(pierced).collect::<Vec<_>>())
}

/// The area without parts smaller than `least` m², and with holes smaller than that filled.
pub fn without_trifles(area: &Area, least: f64) -> Area {
    let large = |ring: &&[DVec2]| ring_area(ring).abs() >= least;
    let filled = |polygon: &Polygon| {
        let holes: Vec<Vec<DVec2>> = polygon.holes().filter(large).map(<[DVec2]>::to_vec).collect();
        Polygon::new(polygon.outer(), &holes)
    };
    area.polygons().iter().filter_map(filled).filter(|polygon| polygon.area() >= least).collect()
}
