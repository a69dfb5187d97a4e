//! The catalogues of places: a rule file below a folder with `bosquet.toml` knows the elements that the place adds.

use crate::cli::lsp::texts::Texts;
use crate::cli::place;
use bosquet::element::Catalogue;
use bosquet::world::World;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Catalogues by manifest, each read once.
#[derive(Default)]
pub struct Places {
    known: BTreeMap<PathBuf, Option<Arc<Catalogue>>>,
}

impl Places {
    /// Reads all anew when they are next asked for.
    pub fn forget(&mut self) {
        self.known.clear();
    }

    /// The catalogue of the place that a file belongs to; `None` where that adds nothing to the built-in one.
    pub fn catalogue(&mut self, texts: &mut Texts, path: &str) -> Option<Arc<Catalogue>> {
        let manifest = Path::new(path).ancestors().skip(1).map(|folder| folder.join(place::MANIFEST));
        let manifest = manifest.into_iter().find(|manifest| manifest.is_file())?;
        if let Some(known) = self.known.get(&manifest) {
            return known.clone();
        }
        let read = extended(texts, &manifest);
        self.known.insert(manifest, read.clone());
        read
    }
}

/// The built-in catalogue with those of a place over it; what is wrong with them is for `bosquet derive` to say.
fn extended(texts: &mut Texts, manifest: &Path) -> Option<Arc<Catalogue>> {
    let place = place::read(manifest).ok().filter(|place| !place.catalogues.is_empty())?;
    let folder = manifest.parent()?;
    texts.open_folder(folder);
    let mut catalogue = Catalogue::built_in().clone();
    for path in &place.catalogues {
        let path = folder.join(path).to_string_lossy().replace('\\', "/");
        if let Ok(bytes) = texts.source(&path) {
            catalogue = catalogue.extended(&path, &bytes, texts).0;
        }
    }
    Some(Arc::new(catalogue))
}
