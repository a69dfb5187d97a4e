//! What the catalogue knows of a word, and the words it has: covers, elements, palettes.

use crate::element::{Catalogue, Cover, Entry, Palette, Words, color_text};
use crate::text::number;

/// A word of the catalogue with what to say of it.
pub(super) struct Known {
    /// The word.
    pub word: String,
    /// A few words beside it.
    pub detail: String,
}

/// What the catalogue says of a word, as Markdown: of a cover, an element, a palette, or several of these.
pub(super) fn describe(catalogue: &Catalogue, word: &str) -> Option<String> {
    if word.trim().is_empty() {
        return None;
    }
    let cover = catalogue.cover(word).map(cover_page);
    let entry = catalogue.find(word, "").ok().map(|found| entry_page(found.entry));
    let palette = catalogue.palette(word).map(|palette| palette_page(catalogue, palette));
    let pages: Vec<String> = [cover, entry, palette].into_iter().flatten().collect();
    (!pages.is_empty()).then(|| pages.join("\n\n"))
}

fn cover_page(cover: &Cover) -> String {
    let material = &cover.material;
    let names = listed("also", cover.names.iter().map(|name| &**name));
    format!(
        "**{}**, a ground cover: `{}`, {}, {}{names}",
        material.label,
        material.name,
        color_text(material.fill),
        material.texture.word()
    )
}

fn entry_page(entry: &Entry) -> String {
    let latin = if entry.species.is_empty() { String::new() } else { format!(" (*{}*)", entry.species) };
    let mut text = format!("**{}**{latin}, {}, id `{}`\n", entry.label, entry.kind.word(), entry.id);
    for variant in &entry.variants {
        let sizes = match &variant.plant {
            Some(plant) => format!(
                "{} years, {} m high, crown {} m across",
                number(plant.age, 0),
                number(plant.height, 1),
                number(plant.crown_radius * 2.0, 1)
            ),
            None => {
                let [x, y, z] = variant.size.map(|size| number(size, 2));
                format!("{x} × {y} × {z} m")
            }
        };
        text += &format!("\n- `{}`: {sizes}", variant.name);
    }
    text
}

fn palette_page(catalogue: &Catalogue, palette: &Palette) -> String {
    let plants: Vec<&str> = palette.plants(catalogue).map(|entry| &*entry.label).collect();
    format!("**{}**, a palette: {}", palette.label, plants.join(", "))
}

fn listed<'a>(before: &str, words: impl Iterator<Item = &'a str>) -> String {
    let words: Vec<String> = words.map(|word| format!("`{word}`")).collect();
    if words.is_empty() { String::new() } else { format!(" ({before} {})", words.join(", ")) }
}

/// Every cover.
pub(super) fn covers(catalogue: &Catalogue) -> Vec<Known> {
    let known =
        |cover: &Cover| Known { word: cover.material.name.to_string(), detail: cover.material.label.to_string() };
    catalogue.covers().map(known).collect()
}

/// Every palette.
pub(super) fn palettes(catalogue: &Catalogue) -> Vec<Known> {
    let known = |palette: &Palette| Known { word: palette.name.to_string(), detail: palette.label.to_string() };
    catalogue.palettes().map(known).collect()
}

/// Plants, or all elements, by category, id, common and Latin name; in a text only, since some have blanks.
pub(super) fn elements(catalogue: &Catalogue, plants_only: bool) -> Vec<Known> {
    let mut found: Vec<Known> = Vec::new();
    let mut seen = std::collections::BTreeSet::new();
    for entry in catalogue.entries().filter(|entry| !plants_only || entry.kind.is_plant()) {
        for name in entry.all_names().filter(|name| !name.is_empty()) {
            if seen.insert(name.clone()) {
                let detail = format!("{}, {}", entry.label, entry.kind.word());
                found.push(Known { word: name.to_string(), detail });
            }
        }
    }
    found
}

/// The types that an element has.
pub(super) fn variants(catalogue: &Catalogue, element: &str) -> Vec<Known> {
    let same = catalogue.entries().filter(|entry| entry.all_names().any(|name| **name == *element));
    let mut found: Vec<Known> = Vec::new();
    for variant in same.flat_map(|entry| &entry.variants) {
        if found.iter().all(|known| known.word != *variant.name) {
            let detail = format!("{} m high", number(variant.size[1], 1));
            found.push(Known { word: variant.name.to_string(), detail });
        }
    }
    found
}
