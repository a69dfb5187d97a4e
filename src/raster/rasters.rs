//! The coverage maps of a run: each file is read once, whichever lot asks first, and shared by all.

use crate::layout::Georeference;
use crate::raster::{Drawn, Flaw, Raster, RasterError};
use crate::world::{World, join};
use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

/// The coverage maps of a run.
pub struct Rasters<'a> {
    world: &'a dyn World,
    /// The rule file that paths are relative to.
    rules: String,
    georeference: Georeference,
    rasters: Shelf<Raster>,
    drawn: Shelf<Drawn>,
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
            let bytes = self.world.asset(path)?;
            Raster::read(path, &bytes, self.world, &self.georeference)
        })
    }

    /// The drawn polygons at a path, as a rule writes it.
    pub fn drawn(&self, path: &str) -> Result<Arc<Drawn>, RasterError> {
        self.drawn.get(&join(&self.rules, path), |path| {
            let bytes = self.world.source(path)?;
            Drawn::read(path, &bytes, &self.georeference)
        })
    }
}

/// A file that is read, or is about to be.
type Slot<T> = Arc<OnceLock<Result<Arc<T>, RasterError>>>;

/// Files by path.
struct Shelf<T>(Mutex<BTreeMap<String, Slot<T>>>);

impl<T> Default for Shelf<T> {
    fn default() -> Shelf<T> {
        Shelf(Mutex::default())
    }
}

impl<T> Shelf<T> {
    /// The file at a path; the first to ask reads it, others wait for that file alone.
    fn get(&self, path: &str, read: impl FnOnce(&str) -> Result<T, Flaw>) -> Result<Arc<T>, RasterError> {
        let slot = {
            let mut slots = self.0.lock().unwrap_or_else(PoisonError::into_inner);
            slots.entry(path.into()).or_default().clone()
        };
        slot.get_or_init(|| read(path).map(Arc::new).map_err(|flaw| flaw.of(path))).clone()
    }
}
