//! The coverage maps of a run: each file is read once, whichever lot asks first, and shared by all.

use crate::layout::Georeference;
use crate::raster::{Drawn, Flaw, Raster, RasterError};
use crate::shelf::Shelf;
use crate::world::{World, join};
use std::sync::Arc;

/// The coverage maps of a run.
pub struct Rasters<'a> {
    world: &'a dyn World,
    /// The rule file that paths are relative to.
    rules: String,
    georeference: Georeference,
    rasters: Shelf<Arc<Raster>, RasterError>,
    drawn: Shelf<Arc<Drawn>, RasterError>,
}

impl<'a> Rasters<'a> {
    /// None read yet. Paths are relative to the folder of the rule file `rules`; the maps are laid on the plan of the
    /// layout whose georeference it is.
    pub fn new(world: &'a dyn World, rules: &str, georeference: Georeference) -> Rasters<'a> {
        Rasters { world, rules: rules.into(), georeference, rasters: Shelf::default(), drawn: Shelf::default() }
    }

    /// The raster at a path, as a rule writes it. What is wrong with a file is the same for everyone who asks.
    pub fn get(&self, path: &str) -> Result<Arc<Raster>, RasterError> {
        self.rasters.get(&join(&self.rules, path), |path| {
            let bytes = self.world.asset(path).map_err(|error| Flaw::from(error).of(path))?;
            let raster = Raster::read(path, &bytes, self.world, &self.georeference);
            raster.map(Arc::new).map_err(|flaw| flaw.of(path))
        })
    }

    /// The drawn polygons at a path, as a rule writes it.
    pub fn drawn(&self, path: &str) -> Result<Arc<Drawn>, RasterError> {
        self.drawn.get(&join(&self.rules, path), |path| {
            let bytes = self.world.source(path).map_err(|error| Flaw::from(error).of(path))?;
            Drawn::read(path, &bytes, &self.georeference).map(Arc::new).map_err(|flaw| flaw.of(path))
        })
    }
}
