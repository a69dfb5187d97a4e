//! The catalogue: every element and cover by category, type and name; the built-in one, and users' own over it.

use crate::diag::Diagnostic;
use crate::element::read::read;
use crate::element::{Cover, Entry, Palette, Variant};
use crate::text;
use crate::world::{MemoryWorld, World};
use std::collections::BTreeMap;
use std::sync::{Arc, OnceLock};

/// The built-in texts, in the order they are read.
const BUILT_IN: [(&str, &str); 12] = [
    ("trees.toml", include_str!("catalogue/trees.toml")),
    ("trees-street.toml", include_str!("catalogue/trees-street.toml")),
    ("trees-warm.toml", include_str!("catalogue/trees-warm.toml")),
    ("growth.toml", include_str!("catalogue/growth.toml")),
    ("shrubs.toml", include_str!("catalogue/shrubs.toml")),
    ("shrubs-hedge.toml", include_str!("catalogue/shrubs-hedge.toml")),
    ("shrubs-flower.toml", include_str!("catalogue/shrubs-flower.toml")),
    ("palettes.toml", include_str!("catalogue/palettes.toml")),
    ("furniture.toml", include_str!("catalogue/furniture.toml")),
    ("architecture.toml", include_str!("catalogue/architecture.toml")),
    ("primitives.toml", include_str!("catalogue/primitives.toml")),
    ("covers.toml", include_str!("catalogue/covers.toml")),
];

/// The element repository.
#[derive(Clone, Debug, Default)]
pub struct Catalogue {
    entries: Vec<Arc<Entry>>,
    /// Where the entries of each user's text begin: what shares a name with them stands behind.
    texts: Vec<usize>,
    covers: Vec<Cover>,
    palettes: Vec<Palette>,
    /// Ids to indices of entries.
    ids: BTreeMap<Arc<str>, usize>,
    /// Folded names to indices of entries, those whose category it is first.
    entry_names: BTreeMap<String, Vec<usize>>,
    /// Folded names to indices of covers.
    cover_names: BTreeMap<String, usize>,
}

/// An element and one of its types.
#[derive(Clone, Copy, Debug)]
pub struct Found<'a> {
    /// The element.
    pub entry: &'a Entry,
    /// Its type.
    pub variant: &'a Variant,
}

/// Why an element was not found.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum NotFound {
    /// No element is called so.
    #[error("the catalogue has no element `{name}`")]
    Element {
        /// What was asked for.
        name: String,
        /// What was likely meant.
        suggestion: Option<String>,
    },
    /// It has no such type.
    #[error("`{element}` has no type `{name}`: it has {known}")]
    Variant {
        /// The element, as asked for.
        element: String,
        /// The type that was asked for.
        name: String,
        /// Its types, listed for people.
        known: String,
        /// What was likely meant.
        suggestion: Option<String>,
    },
}

impl NotFound {
    /// What was likely meant.
    pub fn suggestion(&self) -> Option<&str> {
        match self {
            NotFound::Element { suggestion, .. } | NotFound::Variant { suggestion, .. } => suggestion.as_deref(),
        }
    }
}

impl Catalogue {
    /// The catalogue that comes with the program, read once.
    pub fn built_in() -> &'static Catalogue {
        static CATALOGUE: OnceLock<Catalogue> = OnceLock::new();
        CATALOGUE.get_or_init(|| {
            let (catalogue, found) = Catalogue::read_built_in();
            debug_assert!(found.is_empty(), "the built-in catalogue is broken: {found:#?}");
            catalogue
        })
    }

    /// This catalogue with a user's text over it, and what was wrong with that.
    ///
    /// `path` is where the text lies: models are looked up beside it, through the world.
    pub fn extended(&self, path: &str, bytes: &[u8], world: &dyn World) -> (Catalogue, Vec<Diagnostic>) {
        let mut catalogue = self.clone();
        catalogue.texts.push(catalogue.entries.len());
        let found = read(path, bytes, world, &mut catalogue);
        catalogue.index();
        (catalogue, found)
    }

    /// The element called `name` (category, id, Latin or common name or another of its names), of type `kind`; an
    /// empty `kind` means the usual one.
    ///
    /// Case, spaces, hyphens, underscores and the × of hybrids do not count. Where several elements share a
    /// category, the first that has the type is meant; users' own come before the built-in ones.
    pub fn find(&self, name: &str, kind: &str) -> Result<Found<'_>, NotFound> {
        let Some(indices) = self.entry_names.get(&fold(name)) else {
            return Err(NotFound::Element { name: name.into(), suggestion: self.suggest(name) });
        };
        let entries = || indices.iter().map(|index| &*self.entries[*index]);
        let found = entries().find_map(|entry| entry.variant(kind).map(|variant| Found { entry, variant }));
        found.ok_or_else(|| {
            let types: Vec<&str> = entries().flat_map(|entry| &entry.variants).map(|v| &*v.name).collect();
            NotFound::Variant {
                element: name.into(),
                name: kind.into(),
                known: types.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", "),
                suggestion: text::nearest(kind, types).map(Into::into),
            }
        })
    }

    /// The element of exactly that id.
    pub fn by_id(&self, id: &str) -> Option<&Entry> {
        self.ids.get(id).map(|index| &*self.entries[*index])
    }

    /// The cover of that word, or one of its other names.
    pub fn cover(&self, word: &str) -> Option<&Cover> {
        self.cover_names.get(&fold(word)).map(|index| &self.covers[*index])
    }

    /// The cover whose word was likely meant.
    pub fn nearest_cover(&self, word: &str) -> Option<&str> {
        text::nearest(word, self.covers.iter().map(|cover| &*cover.material.name))
    }

    /// The palette of that name; case, spaces and hyphens do not count.
    pub fn palette(&self, name: &str) -> Option<&Palette> {
        self.palettes.iter().find(|palette| *palette.name == *name || fold(&palette.name) == fold(name))
    }

    /// The palette whose name was likely meant.
    pub fn nearest_palette(&self, name: &str) -> Option<&str> {
        text::nearest(name, self.palettes.iter().map(|palette| &*palette.name))
    }

    /// Every palette, in the order written.
    pub fn palettes(&self) -> impl Iterator<Item = &Palette> {
        self.palettes.iter()
    }

    /// Every element, in the order written.
    pub fn entries(&self) -> impl Iterator<Item = &Entry> {
        self.entries.iter().map(|entry| &**entry)
    }

    /// Every cover, in the order written.
    pub fn covers(&self) -> impl Iterator<Item = &Cover> {
        self.covers.iter()
    }

    /// Adds an entry, or puts it in the place of the one with its id.
    pub(super) fn put(&mut self, entry: Entry) {
        match self.ids.get(&entry.id) {
            Some(index) => self.entries[*index] = Arc::new(entry),
            None => {
                self.ids.insert(entry.id.clone(), self.entries.len());
                self.entries.push(Arc::new(entry));
            }
        }
    }

    /// Adds a cover, or puts it in the place of the one with its word.
    pub(super) fn put_cover(&mut self, cover: Cover) {
        match self.covers.iter_mut().find(|known| known.material.name == cover.material.name) {
            Some(known) => *known = cover,
            None => self.covers.push(cover),
        }
    }

    /// Adds a palette, or puts it in the place of the one with its name.
    pub(super) fn put_palette(&mut self, palette: Palette) {
        match self.palettes.iter_mut().find(|known| known.name == palette.name) {
            Some(known) => *known = palette,
            None => self.palettes.push(palette),
        }
    }

    /// The entry at a place.
    pub(super) fn nth(&self, index: usize) -> Option<&Entry> {
        self.entries.get(index).map(|entry| &**entry)
    }

    /// Where an entry stands.
    pub(super) fn place_of(&self, id: &str) -> Option<usize> {
        self.ids.get(id).copied()
    }

    fn read_built_in() -> (Catalogue, Vec<Diagnostic>) {
        let mut catalogue = Catalogue::default();
        let mut found = Vec::new();
        for (path, text) in BUILT_IN {
            found.extend(read(path, text.as_bytes(), &MemoryWorld::default(), &mut catalogue));
        }
        catalogue.index();
        (catalogue, found)
    }

    /// Makes the names anew after entries were put.
    pub(super) fn index(&mut self) {
        self.entry_names.clear();
        self.cover_names.clear();
        let starts = [0].into_iter().chain(self.texts.iter().copied());
        let ends = self.texts.iter().copied().chain([self.entries.len()]);
        let order: Vec<usize> =
            starts.zip(ends).collect::<Vec<_>>().into_iter().rev().flat_map(|(start, end)| start..end).collect();
        for index in order.iter().copied() {
            self.entry_names.entry(fold(&self.entries[index].category)).or_default().push(index);
        }
        for index in order {
            let entry = &self.entries[index];
            for name in entry.all_names().filter(|name| !name.is_empty()) {
                let indices = self.entry_names.entry(fold(name)).or_default();
                if !indices.contains(&index) {
                    indices.push(index);
                }
            }
        }
        for (index, cover) in self.covers.iter().enumerate() {
            self.cover_names.insert(fold(&cover.material.name), index);
        }
        for (index, cover) in self.covers.iter().enumerate() {
            for name in &cover.names {
                self.cover_names.entry(fold(name)).or_insert(index);
            }
        }
    }

    /// The name nearest to what was asked for.
    fn suggest(&self, name: &str) -> Option<String> {
        let names = self.entries().flat_map(Entry::all_names).map(|name| &**name);
        text::nearest(name, names.filter(|name| !name.is_empty())).map(Into::into)
    }
}

/// A name without what does not count: case, spaces, hyphens, underscores, the × of hybrids.
pub(super) fn fold(name: &str) -> String {
    let words = name.split(|c: char| !c.is_alphanumeric()).filter(|word| !word.eq_ignore_ascii_case("x"));
    words.flat_map(str::chars).flat_map(char::to_lowercase).collect()
}
