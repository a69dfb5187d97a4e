//! The planting schedule: what has to be ordered, laid and built, as a table for spreadsheets.
//!
//! In: a scene. Out: CSV in sections, each with a title, a header and its rows, a blank line between: plants by species
//! and age class, surfaces, hedges, walls, other solids, objects. Rows are sorted by what they are called.

use crate::export::csv::push_row;
use crate::scene::{Material, Plant, Scene, Solid, Strip, strip_length};
use crate::text;
use std::collections::BTreeMap;

/// The schedule of a scene.
pub fn schedule_csv(scene: &Scene) -> String {
    let [hedges, walls, others] = solids(scene);
    let mut out = String::new();
    let mut section = Sections { out: &mut out };
    section.add(
        "Plants",
        "code,species,common name,kind,type,existing,count,mean height (m),mean crown radius (m),spacing radius (m)",
        plants(scene),
    );
    section.add("Surfaces", "material,name,pieces,area (m²)", covers(scene));
    section.add("Hedges", "material,name,pieces,length (m),mean height (m),area (m²)", hedges);
    section.add("Walls", "material,name,pieces,length (m),mean height (m),area (m²)", walls);
    section.add("Buildings and other solids", "material,name,pieces,mean height (m),area (m²)", others);
    section.add("Objects", "entry,name,category,type,count", objects(scene));
    out
}

struct Sections<'a> {
    out: &'a mut String,
}

impl Sections<'_> {
    fn add(&mut self, title: &str, header: &str, rows: Vec<Vec<String>>) {
        if rows.is_empty() {
            return;
        }
        if !self.out.is_empty() {
            self.out.push_str("\r\n");
        }
        push_row(self.out, [title]);
        push_row(self.out, header.split(','));
        rows.into_iter().for_each(|row| push_row(self.out, row));
    }
}

/// What the plants of one row share; rows are sorted by these in turn.
#[derive(PartialEq, Eq, PartialOrd, Ord)]
struct Stand<'a> {
    species: &'a str,
    /// Young before old, other types after them.
    rank: usize,
    age_class: &'a str,
    code: &'a str,
    common_name: &'a str,
    kind: &'a str,
    existing: bool,
}

/// Sums over the plants of one row.
#[derive(Default)]
struct Sum {
    count: usize,
    height: f64,
    crown: f64,
    spacing: f64,
}

fn plants(scene: &Scene) -> Vec<Vec<String>> {
    let mut stands: BTreeMap<Stand<'_>, Sum> = BTreeMap::new();
    for plant in &scene.plants {
        let sum = stands.entry(stand(plant)).or_default();
        sum.count += 1;
        sum.height += plant.height;
        sum.crown += plant.crown_radius;
        sum.spacing += plant.spacing_radius;
    }
    let row = |(stand, sum): (Stand<'_>, Sum)| {
        let existing = if stand.existing { "yes" } else { "no" };
        let texts = [stand.code, stand.species, stand.common_name, stand.kind, stand.age_class, existing];
        let means = [sum.height, sum.crown, sum.spacing].map(|total| text::number(total / sum.count as f64, 2));
        texts.map(str::to_owned).into_iter().chain([sum.count.to_string()]).chain(means).collect()
    };
    stands.into_iter().map(row).collect()
}

fn stand(plant: &Plant) -> Stand<'_> {
    Stand {
        species: if plant.species.is_empty() { &plant.category } else { &plant.species },
        rank: rank(&plant.age_class),
        age_class: &plant.age_class,
        code: &plant.code,
        common_name: &plant.common_name,
        kind: &plant.kind,
        existing: plant.existing,
    }
}

fn rank(age_class: &str) -> usize {
    ["young", "medium", "adult"].iter().position(|class| *class == age_class).unwrap_or(3)
}

fn covers(scene: &Scene) -> Vec<Vec<String>> {
    let mut sums: BTreeMap<[&str; 2], (usize, f64)> = BTreeMap::new();
    for cover in &scene.covers {
        let sum = sums.entry(names(&cover.material)).or_default();
        sum.0 += 1;
        sum.1 += cover.area.area();
    }
    let row = |([name, label], (pieces, area)): ([&str; 2], (usize, f64))| {
        vec![name.to_owned(), label.to_owned(), pieces.to_string(), text::number(area, 2)]
    };
    sums.into_iter().map(row).collect()
}

fn names(material: &Material) -> [&str; 2] {
    [&material.name, &material.label]
}

/// The column of the length in the rows of solids.
const LENGTH: usize = 3;

/// Sums over the solids of one row.
#[derive(Default)]
struct Run {
    pieces: usize,
    length: f64,
    height: f64,
    area: f64,
}

/// The rows of hedges, walls and all other solids.
fn solids(scene: &Scene) -> [Vec<Vec<String>>; 3] {
    let mut runs: [BTreeMap<[&str; 2], Run>; 3] = Default::default();
    for solid in &scene.solids {
        let run = runs[class(&solid.material)].entry(names(&solid.material)).or_default();
        run.add(solid);
    }
    let [hedges, walls, others] = runs
        .map(|runs| runs.into_iter().map(|([name, label], run)| run.row(name, label)).collect::<Vec<Vec<String>>>());
    [hedges, walls, others.into_iter().map(without_length).collect()]
}

/// Nobody measures a building along.
fn without_length(mut row: Vec<String>) -> Vec<String> {
    row.remove(LENGTH);
    row
}

fn class(material: &Material) -> usize {
    match Strip::of(material) {
        Some(Strip::Hedge) => 0,
        Some(Strip::Wall) => 1,
        None => 2,
    }
}

impl Run {
    fn add(&mut self, solid: &Solid) {
        self.pieces += 1;
        self.length += strip_length(&solid.footprint);
        self.height += solid.height;
        self.area += solid.footprint.area();
    }

    fn row(&self, name: &str, label: &str) -> Vec<String> {
        let height = self.height / self.pieces as f64;
        let numbers = [self.length, height, self.area].map(|number| text::number(number, 2));
        [name.to_owned(), label.to_owned(), self.pieces.to_string()].into_iter().chain(numbers).collect()
    }
}

fn objects(scene: &Scene) -> Vec<Vec<String>> {
    let mut counts: BTreeMap<[&str; 4], usize> = BTreeMap::new();
    for object in &scene.objects {
        *counts.entry([&object.category, &object.entry, &object.variant, &object.label]).or_default() += 1;
    }
    let row = |([category, entry, variant, label], count): ([&str; 4], usize)| {
        let texts = [entry, label, category, variant].map(str::to_owned);
        texts.into_iter().chain([count.to_string()]).collect()
    };
    counts.into_iter().map(row).collect()
}
