//! Drawn polygons as a coverage map: what a brush leaves behind (Niese et al. 2022, §7.1).
//!
//! In: a GeoJSON text. Out: the areas in it, whatever their kind, in plan metres of another layout.

use crate::diag::Diagnostic;
use crate::geometry::{Area, Bounds, BoxGrid, Polygon, union_all};
use crate::layout::{Georeference, Shapes, read_geojson};
use crate::raster::Flaw;
use crate::raster::crossing::Crossing;

/// Drawn polygons in plan metres.
#[derive(Clone, Debug)]
pub struct Drawn {
    polygons: Vec<Polygon>,
    grid: BoxGrid,
}

impl Drawn {
    /// The polygons of a GeoJSON text in the plan of a layout. Polygons may overlap; lines and points mean nothing.
    pub fn read(path: &str, bytes: &[u8], georeference: &Georeference) -> Result<Drawn, Flaw> {
        let (drawing, found) = read_geojson(path, bytes);
        if let Some(error) = found.iter().find(|diagnostic| diagnostic.is_error()) {
            return Err(Flaw::Drawing(words(error)));
        }
        let own = &drawing.georeference;
        let crossing = Crossing::new(Some(own.crs.clone()), own.centre, georeference)?;
        let areas = drawing.features.iter().filter_map(|feature| match &feature.shapes {
            Shapes::Areas(polygons) => Some(polygons),
            _ => None,
        });
        let all = drawing.regions.iter().map(|region| &region.polygon).chain(areas.flatten());
        let moved = all.map(|polygon| polygon.mapped(|p| crossing.to_plan(own.to_world(p))));
        let polygons: Vec<Polygon> = moved.filter(|p| p.sanity_check().is_ok()).collect();
        let grid = BoxGrid::new(&polygons.iter().map(Polygon::bounds).collect::<Vec<_>>());
        Ok(Drawn { polygons, grid })
    }

    /// What is drawn around a part of the plan: every polygon that reaches into it, whole.
    pub fn area(&self, within: Bounds) -> Area {
        let mut near: Vec<usize> = self.grid.touching(within).collect();
        near.sort_unstable();
        let near: Vec<Area> = near.iter().map(|index| self.polygons[*index].clone().into()).collect();
        union_all(&near)
    }
}

/// A diagnostic in one sentence.
fn words(diagnostic: &Diagnostic) -> String {
    match diagnostic.hints.first() {
        Some(hint) => format!("{}; {hint}", diagnostic.message),
        None => diagnostic.message.clone(),
    }
}
