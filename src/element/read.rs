//! Catalogue text → entries and covers, over those that are there already.
//!
//! Four tables: `[plant.<id>]`, `[object.<id>]`, `[cover.<word>]`, `[palette.<name>]`. An id that is known changes the
//! fields that are written and keeps the others; `types` are changed one by one likewise.

use crate::diag::Diagnostic;
use crate::element::record::{Record, Source};
use crate::element::{
    Catalogue, Cover, Entry, Form, Kind, Material, Palette, PlantFigures, PlantSymbol, Variant, model,
};
use crate::world::{World, join};
use std::sync::Arc;

/// Taller, wider or older is a slip of the pen.
const MOST_METRES: f64 = 200.0;
const MOST_YEARS: f64 = 5000.0;
const MOST_APPEARANCES: u32 = 1000;

/// Reads `bytes` into the catalogue; what is wrong is reported and left out.
pub(super) fn read(path: &str, bytes: &[u8], world: &dyn World, into: &mut Catalogue) -> Vec<Diagnostic> {
    let text = match std::str::from_utf8(bytes) {
        Ok(text) => text,
        Err(error) => {
            let message = format!("the catalogue is not UTF-8 text: byte {} is broken", error.valid_up_to());
            return vec![Diagnostic::data("catalogue", path, message)];
        }
    };
    let source = Source::new(path, text);
    let tables = source.parse();
    let mut record = source.record(&tables);
    for (id, plant) in record.records("plant") {
        read_entry(id, plant, true, world, into);
    }
    for (id, object) in record.records("object") {
        read_entry(id, object, false, world, into);
    }
    for (word, cover) in record.records("cover") {
        read_cover(word, cover, into);
    }
    let palettes = record.records("palette");
    if !palettes.is_empty() {
        // They name plants of this text too.
        into.index();
    }
    for (name, palette) in palettes {
        read_palette(name, palette, into);
    }
    record.finish();
    drop(tables);
    source.into_found()
}

fn read_entry(id: Arc<str>, mut record: Record<'_>, plant: bool, world: &dyn World, into: &mut Catalogue) {
    let mut entry = into.by_id(&id).cloned().unwrap_or_else(|| blank(id, plant));
    if entry.kind.is_plant() != plant {
        let other = if plant { "an object" } else { "a plant" };
        record.source().report(record.fail(format!("`{}` is {other} already", entry.id)).hint("choose another id"));
        return;
    }
    read_names(&mut record, &mut entry);
    read_looks(&mut record, &mut entry);
    let model = record.text("model");
    for (name, types) in record.records("types") {
        read_variant(name, types, model.as_ref(), world, &mut entry);
    }
    if let Some(problem) = problem(&entry, plant) {
        record.source().report(record.fail(problem));
    } else {
        into.put(entry);
    }
    record.finish();
}

fn blank(id: Arc<str>, plant: bool) -> Entry {
    let (color, line) = if plant {
        ([0.69, 0.77, 0.55, 1.0], [0.37, 0.47, 0.29, 1.0])
    } else {
        ([0.85, 0.83, 0.78, 1.0], [0.42, 0.4, 0.36, 1.0])
    };
    Entry {
        category: id.clone(),
        id,
        kind: if plant { Kind::Tree } else { Kind::Furniture },
        label: "".into(),
        species: "".into(),
        common_name: "".into(),
        names: Vec::new(),
        code: "".into(),
        symbol: PlantSymbol::default(),
        form: Form::default(),
        color,
        line,
        shader: toml::Table::new(),
        metadata: toml::Table::new(),
        growth: toml::Table::new(),
        variants: Vec::new(),
    }
}

fn read_names(record: &mut Record<'_>, entry: &mut Entry) {
    set(&mut entry.category, record.text("category"));
    set(&mut entry.kind, record.word("kind"));
    set(&mut entry.species, record.text("species"));
    set(&mut entry.common_name, record.text("common_name"));
    set(&mut entry.label, record.text("label"));
    set(&mut entry.names, record.texts("names"));
    set(&mut entry.code, record.text("code"));
    if entry.label.is_empty() {
        let name = if entry.common_name.is_empty() { &entry.category } else { &entry.common_name };
        entry.label = name.clone();
    }
    if entry.code.is_empty() {
        let letters = entry.category.chars().filter(|c| c.is_alphanumeric()).flat_map(char::to_uppercase);
        entry.code = letters.chain(std::iter::repeat('X')).take(3).collect::<String>().into();
    }
}

fn read_looks(record: &mut Record<'_>, entry: &mut Entry) {
    let former = entry.symbol;
    set(&mut entry.symbol, record.word("symbol"));
    // Types that had the common symbol follow it; those with their own keep it.
    for variant in entry.variants.iter_mut().filter(|variant| variant.symbol == former) {
        variant.symbol = entry.symbol;
    }
    set(&mut entry.form, record.word("form"));
    set(&mut entry.color, record.color("color"));
    set(&mut entry.line, record.color("line"));
    set(&mut entry.shader, record.free("shader"));
    set(&mut entry.metadata, record.free("metadata"));
    set(&mut entry.growth, record.free("growth"));
}

fn problem(entry: &Entry, plant: bool) -> Option<String> {
    if entry.kind.is_plant() != plant {
        let (table, kinds) = if plant {
            ("plant", "`tree`, `shrub`, `hedge` or `flower`")
        } else {
            ("object", "`furniture`, `architecture` or `primitive`")
        };
        return Some(format!("the `kind` of a {table} must be {kinds}"));
    }
    if entry.code.chars().count() != 3 {
        return Some(format!("`code` must have three letters, not `{}`", entry.code));
    }
    entry.variants.is_empty().then(|| "it needs at least one type: `types.adult = { … }`".into())
}

fn read_variant(
    name: Arc<str>,
    mut record: Record<'_>,
    model: Option<&Arc<str>>,
    world: &dyn World,
    entry: &mut Entry,
) {
    let known = entry.variants.iter().position(|variant| variant.name == name);
    let mut variant = match known {
        Some(index) => entry.variants[index].clone(),
        None => Variant {
            name,
            size: [0.0; 3],
            plant: entry.kind.is_plant().then(PlantFigures::default),
            symbol: entry.symbol,
            appearances: 1,
            model: "".into(),
        },
    };
    set(&mut variant.appearances, record.count("appearances", 1, MOST_APPEARANCES));
    set(&mut variant.symbol, record.word("symbol"));
    let own = record.text("model");
    if let Some(path) = own.as_ref().or(model) {
        take_model(path, &record, world, &mut variant);
    }
    let complete = match variant.plant {
        Some(_) => read_figures(&mut record, &mut variant),
        None => read_size(&mut record, &mut variant),
    };
    match (complete, known) {
        (false, _) => {}
        (true, Some(index)) => entry.variants[index] = variant,
        (true, None) => entry.variants.push(variant),
    }
    record.finish();
}

/// The model's path and size; what cannot be had is reported, and the built-in form stands for it.
fn take_model(path: &str, record: &Record<'_>, world: &dyn World, variant: &mut Variant) {
    let path = join(record.source().path(), path);
    let size = world.asset(&path).map_err(|error| error.to_string()).and_then(|bytes| {
        model::model_bounds(&path, &bytes).map(|b| b.size()).map_err(|error| format!("`{path}`: {error}"))
    });
    match size {
        Ok(size) => {
            variant.size = size;
            variant.model = path.into();
            if let Some(figures) = &mut variant.plant {
                *figures = PlantFigures { height: size[1], crown_radius: size[0].max(size[2]) / 2.0, ..*figures };
            }
        }
        Err(reason) => record.source().report(record.fail(reason)),
    }
}

fn read_figures(record: &mut Record<'_>, variant: &mut Variant) -> bool {
    let mut figures = variant.plant.unwrap_or_default();
    set(&mut figures.age, record.number("age", 0.0, MOST_YEARS));
    set(&mut figures.height, record.number("height", 0.01, MOST_METRES));
    set(&mut figures.crown_radius, record.number("crown_radius", 0.01, MOST_METRES));
    set(&mut figures.crown_radius, record.number("crown_diameter", 0.02, MOST_METRES).map(|width| width / 2.0));
    set(&mut figures.spacing_radius, record.number("spacing_radius", 0.0, MOST_METRES));
    set(&mut figures.trunk_diameter, record.number("trunk_diameter", 0.0, MOST_METRES));
    if figures.height == 0.0 || figures.crown_radius == 0.0 {
        record.source().report(record.fail("it needs a `height` and a `crown_radius`"));
        return false;
    }
    if figures.spacing_radius == 0.0 && !record.has("spacing_radius") {
        figures.spacing_radius = figures.crown_radius;
    }
    if figures.trunk_diameter == 0.0 && !record.has("trunk_diameter") {
        figures.trunk_diameter = figures.height / 40.0;
    }
    let width = 2.0 * figures.crown_radius;
    variant.size = [width, figures.height, width];
    variant.plant = Some(figures);
    true
}

fn read_size(record: &mut Record<'_>, variant: &mut Variant) -> bool {
    set(&mut variant.size, record.size("size"));
    let complete = variant.size.iter().any(|length| *length > 0.0);
    if !complete && !record.has("size") {
        record.source().report(record.fail("it needs a `size = [x, y, z]` in metres, or a `model`"));
    }
    complete
}

fn read_cover(word: Arc<str>, mut record: Record<'_>, into: &mut Catalogue) {
    let mut cover =
        into.cover(&word).filter(|cover| cover.material.name == word).cloned().unwrap_or_else(|| plain(word));
    let mut material = Material::clone(&cover.material);
    set(&mut material.label, record.text("label"));
    set(&mut material.fill, record.color("fill"));
    set(&mut material.line, record.color("line"));
    set(&mut material.line_width, record.number("line_width", 0.0, 10.0).map(|width| width as f32));
    set(&mut material.texture, record.word("texture"));
    set(&mut cover.names, record.texts("names"));
    set(&mut cover.shader, record.free("shader"));
    set(&mut cover.metadata, record.free("metadata"));
    cover.material = Arc::new(material);
    into.put_cover(cover);
    record.finish();
}

/// A palette of what the catalogue has; names that it has not are reported and left out.
fn read_palette(name: Arc<str>, mut record: Record<'_>, into: &mut Catalogue) {
    let known = into.palette(&name).filter(|palette| palette.name == name).cloned();
    let mut palette = known.unwrap_or_else(|| Palette { label: titled(&name), name, plants: Vec::new() });
    set(&mut palette.label, record.text("label"));
    if let Some(names) = record.texts("plants") {
        palette.plants = names.iter().filter_map(|name| plant_place(name, &record, into)).collect();
    }
    if palette.plants.is_empty() {
        record.source().report(record.fail("it needs at least one plant: `plants = [\"plane\", …]`"));
    } else {
        into.put_palette(palette);
    }
    record.finish();
}

fn plant_place(name: &str, record: &Record<'_>, catalogue: &Catalogue) -> Option<usize> {
    let report = |message: String, near: Option<&str>| {
        record.source().report(record.fail(message).did_you_mean(near));
    };
    match catalogue.find(name, "") {
        Ok(found) if found.entry.kind.is_plant() => return catalogue.place_of(&found.entry.id),
        Ok(_) => report(format!("`{name}` is no plant"), None),
        Err(error) => report(error.to_string(), error.suggestion()),
    }
    None
}

/// A word as a label: `crushed_tile` is `Crushed tile`.
fn titled(word: &str) -> Arc<str> {
    let mut letters = word.chars();
    let label: String = letters.next().into_iter().flat_map(char::to_uppercase).chain(letters).collect();
    label.replace(['-', '_'], " ").into()
}

/// A cover of which nothing is known but its name.
fn plain(word: Arc<str>) -> Cover {
    let material = Material {
        label: titled(&word),
        name: word,
        fill: [0.92, 0.9, 0.85, 1.0],
        line: [0.54, 0.51, 0.46, 1.0],
        line_width: 0.13,
        texture: Default::default(),
    };
    Cover { material: Arc::new(material), names: Vec::new(), shader: toml::Table::new(), metadata: toml::Table::new() }
}

fn set<T>(slot: &mut T, value: Option<T>) {
    if let Some(value) = value {
        *slot = value;
    }
}
