//! Palettes: which plants a climate or a manner of gardening has to choose from.

use crate::element::{Catalogue, Entry};
use std::sync::Arc;

/// A list of plants under a name.
#[derive(Clone, Debug, PartialEq)]
pub struct Palette {
    /// What rules call it: `temperate`.
    pub name: Arc<str>,
    /// The name people read.
    pub label: Arc<str>,
    /// Where its plants stand in the catalogue, in the order written; a replaced entry keeps its place.
    pub(super) plants: Vec<usize>,
}

impl Palette {
    /// Its plants in the order written, as the catalogue has them now.
    pub fn plants<'a>(&'a self, catalogue: &'a Catalogue) -> impl Iterator<Item = &'a Entry> {
        self.plants.iter().filter_map(|index| catalogue.nth(*index))
    }
}
