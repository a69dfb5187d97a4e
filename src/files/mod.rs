//! The files that rules ask for: texts, tables, sizes of models and pictures, and what there is.
//!
//! In: paths as rules write them, and the rule file that does. Out: values, each made once in a run whichever lot asks
//! first, so that all lots see the same. Everything comes through the world, which decides what may be reached.

mod picture;
mod search;
mod table;
mod text;

pub use table::Table;

use crate::element::{ModelBounds, ModelNames, model_bounds, model_names};
use crate::shelf::Shelf;
use crate::value::Array;
use crate::world::{World, WorldError};
use std::sync::Arc;

/// Why a file is of no use.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum FileError {
    /// It could not be had.
    #[error(transparent)]
    World(#[from] WorldError),
    /// There is none where rules look for files.
    #[error(
        "there is no file `{0}` beside the rules, in `assets`, `data`, `images` or `models` there, nor next to that folder"
    )]
    Unfound(String),
    /// It is not what it should be.
    #[error("`{0}` {1}")]
    Unusable(String, String),
    /// A search could not be understood.
    #[error("{0}")]
    Query(String),
}

/// The files of a run.
pub struct Files<'a> {
    world: &'a dyn World,
    /// The rule files, by their number in spans.
    sources: Vec<String>,
    listings: Shelf<Arc<[String]>, FileError>,
    texts: Shelf<Arc<str>, FileError>,
    tables: Shelf<Arc<Table>, FileError>,
    models: Shelf<ModelBounds, FileError>,
    names: Shelf<Arc<ModelNames>, FileError>,
    searches: Shelf<Arc<[Arc<str>]>, FileError>,
    pictures: Shelf<[u32; 2], FileError>,
}

impl<'a> Files<'a> {
    /// None read yet. `sources` are the paths of the rule files; the first is the main one.
    pub fn new(world: &'a dyn World, sources: impl IntoIterator<Item = String>) -> Files<'a> {
        Files {
            world,
            sources: sources.into_iter().collect(),
            listings: Shelf::default(),
            texts: Shelf::default(),
            tables: Shelf::default(),
            models: Shelf::default(),
            names: Shelf::default(),
            searches: Shelf::default(),
            pictures: Shelf::default(),
        }
    }

    /// The text of a file, its line ends as `\n`; control characters become `?`.
    pub fn text(&self, source: u16, path: &str) -> Result<Arc<str>, FileError> {
        self.texts.get(&self.resolve(source, path)?, |path| {
            let bytes = self.world.asset(path)?;
            Ok(text::clean(&text::decode(&bytes)).into())
        })
    }

    /// The cells of a table as texts.
    pub fn strings(&self, source: u16, path: &str) -> Result<Arc<Array>, FileError> {
        Ok(self.table(source, path)?.strings.clone())
    }

    /// The cells of a table as numbers; not a number where a cell does not begin with one.
    pub fn numbers(&self, source: u16, path: &str) -> Result<Arc<Array>, FileError> {
        Ok(self.table(source, path)?.numbers.clone())
    }

    fn table(&self, source: u16, path: &str) -> Result<Arc<Table>, FileError> {
        self.tables.get(&self.resolve(source, path)?, |path| {
            let bytes = self.world.asset(path)?;
            let table = Table::read(&text::decode(&bytes));
            table.map(Arc::new).map_err(|flaw| FileError::Unusable(path.into(), flaw))
        })
    }

    /// Tables of which some rows are shorter than others: the path, and what was done.
    pub fn remarks(&self) -> Vec<(String, String)> {
        let tables = self.tables.made().into_iter();
        tables.filter_map(|(path, table)| table.remark.clone().map(|remark| (path, remark))).collect()
    }

    /// The bounds of a model, metres, y up.
    pub fn model(&self, source: u16, path: &str) -> Result<ModelBounds, FileError> {
        self.models.get(&self.resolve(source, path)?, |path| {
            let bytes = self.world.asset(path)?;
            model_bounds(path, &bytes)
                .map_err(|error| FileError::Unusable(path.into(), format!("is of no use: {error}")))
        })
    }

    /// What a model says of itself: the names of its groups and materials, and what else is written in it.
    pub fn names(&self, source: u16, path: &str) -> Result<Arc<ModelNames>, FileError> {
        self.names.get(&self.resolve(source, path)?, |path| {
            let bytes = self.world.asset(path)?;
            let names = model_names(path, &bytes).map(Arc::new);
            names.map_err(|error| FileError::Unusable(path.into(), format!("is of no use: {error}")))
        })
    }

    /// The width and height of a picture in pixels.
    pub fn picture(&self, source: u16, path: &str) -> Result<[u32; 2], FileError> {
        self.pictures.get(&self.resolve(source, path)?, |path| {
            let bytes = self.world.asset(path)?;
            picture::size(&bytes).map_err(|flaw| FileError::Unusable(path.into(), flaw))
        })
    }

    /// Whether there is such a file.
    pub fn exists(&self, source: u16, path: &str) -> bool {
        self.candidates(source, path).iter().any(|path| self.world.exists(path))
    }
}
