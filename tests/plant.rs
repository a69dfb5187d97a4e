//! Plants by species and age: sizes against measured trees, and the structure of a planting against its parameters.

use bosquet::element::{Catalogue, Entry, Kind};
use bosquet::geometry::Area;
use bosquet::layout::Georeference;
use bosquet::ops::Given;
use bosquet::placement::Standing;
use bosquet::plant::{Curve, Growth, Seeds, Stock, Structure, choose, landscape, of_lot, sizes};
use bosquet::raster::Rasters;
use bosquet::seed::Seed;
use bosquet::shape::{Frame, Geometry, Occluders, Ordinals, Place, Placed, Scope, Shape};
use bosquet::value::Value;
use bosquet::world::MemoryWorld;
use glam::DVec3;
use proptest::prelude::*;
use std::collections::{BTreeMap, BTreeSet};

fn entry(name: &str) -> &'static Entry {
    Catalogue::built_in().find(name, "").expect(name).entry
}

fn plants() -> impl Iterator<Item = &'static Entry> {
    Catalogue::built_in().entries().filter(|entry| entry.kind.is_plant())
}

fn is_measured(entry: &Entry) -> bool {
    sizes(entry, 1.0).expect("a growth").measured
}

/// Rows of table TS6 (Urban Tree Database), worked out by hand for an age or diameter of 30.
const BY_HAND: [(&str, &[f64], f64); 12] = [
    ("lin", &[2.73019, 0.1214], 6.372_19),
    ("quad", &[0.72545, 0.2537, -0.00123], 7.229_45),
    ("cub", &[1.01405, 0.26806, -0.00275, 0.00001], 6.850_85),
    ("quart", &[-0.163, 0.783, 0.00079, -0.00015, 9.06e-7], 20.721_86),
    ("loglogw1", &[-2.82649, 6.13761, 0.38432], 139.459_566),
    ("loglogw2", &[-1.12316, 2.38565, 0.01614], 6.451_226),
    ("loglogw3", &[-1.20695, 2.52258, 0.00112], 6.834_700),
    ("loglogw4", &[-0.96824, 2.60965, 0.00001], 9.543_332),
    ("expow1", &[0.74144, 0.10207, 0.83082], 67.962_087),
    ("expow2", &[0.61312, 0.03283, 0.01321], 5.125_341),
    ("expow3", &[-2.00792, 0.15525, 0.02028], 19.178_311),
    ("expow4", &[0.26305, 0.05754, 0.00007], 7.543_981),
];

fn curve(form: &str, with: &[f64]) -> Result<Curve, String> {
    let text = format!("form = \"{form}\"\nwith = {with:?}\nover = [0, 50]\nwithin = [0, 1000]");
    Curve::read(&text.parse().expect("toml"))
}

#[test]
fn every_form_gives_the_tables_values() {
    for (form, with, expected) in BY_HAND {
        let curve = curve(form, with).expect(form);
        assert!((curve.at(30.0) - expected).abs() < 1e-5, "{form}: {} and not {expected}", curve.at(30.0));
        assert_eq!(curve.at(80.0), curve.at(50.0), "{form}: beyond its range the end is held");
        assert!(curve.at(f64::NAN).is_finite() && curve.at(-1e300) >= 0.0);
    }
}

#[test]
fn broken_curves_say_what_is_wrong() {
    assert!(curve("cubic", &[1.0]).expect_err("no form").contains("`form` must be one of `lin`"));
    assert!(curve("quad", &[1.0]).expect_err("too few").contains("a list of 3 numbers"));
    let text = "[plant.birch-own]\ncategory = \"birch\"\ntypes.adult = { height = 9, crown_radius = 2 }\n\
                growth.height = { form = \"lin\", with = [1, 2], over = [9, 2], within = [0, 9] }\n";
    let (catalogue, _) = Catalogue::built_in().extended("a.toml", text.as_bytes(), &MemoryWorld::default());
    let error = sizes(catalogue.by_id("birch-own").expect("a birch"), 3.0).expect_err("a broken range").to_string();
    assert!(error.contains("`birch-own`") && error.contains("`height`: `over` must be two numbers"), "{error}");
}

#[test]
fn sizes_never_shrink_with_age() {
    for entry in plants() {
        let growth = Growth::of(entry).expect("a growth");
        let mut last = growth.sizes(0.0);
        for half_years in 1..400 {
            let now = growth.sizes(f64::from(half_years) * 0.5);
            let grows = now.dbh >= last.dbh - 1e-9
                && now.height >= last.height - 1e-9
                && now.crown_diameter >= last.crown_diameter - 1e-9
                && now.leaf_area >= last.leaf_area - 1e-6;
            assert!(grows, "{}: {now:?} after {last:?}", entry.id);
            assert!(now.height > 0.0 && now.crown_diameter > 0.0 && now.crown_height <= now.height + 1e-9);
            last = now;
        }
        let old = growth.sizes(10_000.0);
        assert!(old.beyond && !growth.sizes(growth.last_age()).beyond && old.height == last.height, "{}", entry.id);
    }
}

#[test]
fn the_catalogue_has_what_towns_plant() {
    let measured = plants().filter(|entry| is_measured(entry)).count();
    let trees = plants().filter(|entry| entry.kind == Kind::Tree).count();
    assert!(measured >= 30 && trees >= 45 && plants().count() - trees >= 25, "{measured} of {trees}");
    // London plane of Modesto: table TS6, by hand: dbh at 40 years 53.30 cm, from that 17.38 and 15.04 m.
    let plane = sizes(entry("plane"), 40.0).expect("a plane");
    assert!((plane.dbh - 0.5330).abs() < 5e-4 && (plane.height - 17.38).abs() < 0.02, "{plane:?}");
    assert!((plane.crown_diameter - 15.04).abs() < 0.02 && plane.measured && !plane.beyond, "{plane:?}");
    // Without measured trees the types are the truth.
    let beech = entry("box").variant("medium").expect("a type").plant.expect("figures");
    let sizes = sizes(entry("box"), beech.age).expect("box");
    assert_eq!((sizes.height, sizes.crown_diameter * 0.5, sizes.measured), (beech.height, beech.crown_radius, false));
}

proptest! {
    #[test]
    fn the_age_at_a_radius_is_the_last_that_fits(index in 0usize..80, radius in 0.2..12.0f64) {
        let all: Vec<&Entry> = plants().collect();
        let growth = Growth::of(all[index % all.len()]).expect("a growth");
        let age = growth.age_at_crown_radius(radius);
        if age.is_finite() && age > 0.0 {
            prop_assert!(growth.sizes(age).crown_diameter * 0.5 <= radius);
        }
        if age.is_finite() {
            prop_assert!(growth.sizes(age + 0.5).crown_diameter * 0.5 >= radius - 1e-6 || age == 0.0);
        } else {
            prop_assert!(growth.sizes(1e6).crown_diameter * 0.5 <= radius);
        }
    }
}

fn palette(name: &str) -> Stock<'static> {
    let catalogue = Catalogue::built_in();
    catalogue.palette(name).expect(name).plants(catalogue).collect()
}

fn chosen(structure: &Structure, lot: Seed, count: u64) -> BTreeMap<&'static str, f64> {
    let stock = palette("temperate");
    let mut counts = BTreeMap::new();
    for index in 0..count {
        let seeds = Seeds { run: Seed(5), lot, plant: lot.child(index) };
        *counts.entry(&*choose(&stock, structure, seeds).expect("a species").id).or_insert(0.0) += 1.0;
    }
    counts
}

#[test]
fn shares_are_those_asked_for() {
    let count = 6000.0;
    for (tree_ratio, diversity) in [(0.8, 0.5), (0.3, 0.7), (1.0, 0.2), (0.0, 0.9)] {
        let structure = Structure { tree_ratio, diversity, species_count: 6, landscape_species: 12 };
        for lot in [Seed(1), Seed(2)] {
            let counts = chosen(&structure, lot, count as u64);
            let of = |kind: bool| {
                counts.iter().filter(move |(id, _)| (entry(id).kind == Kind::Tree) == kind).map(|(_, n)| *n)
            };
            let trees: f64 = of(true).sum();
            // Four standard deviations of a binomial share.
            let slack = |p: f64, n: f64| 4.0 * (p * (1.0 - p) / n.max(1.0)).sqrt() + 1e-9;
            assert!((trees / count - tree_ratio).abs() <= slack(tree_ratio, count), "ρ {tree_ratio}: {trees}");
            for (kind, total) in [(true, trees), (false, count - trees)] {
                let most = of(kind).fold(0.0, f64::max);
                if of(kind).count() > 1 {
                    let share = most / total;
                    assert!(share >= diversity - slack(diversity, total), "θ {diversity}: {share}");
                    let fair = of(kind).count() as f64 - 1.0;
                    let others = (1.0 - diversity) / fair;
                    let expected = diversity.max(others);
                    assert!(share <= expected + 2.0 * slack(expected, total), "θ {diversity}: {share} > {expected}");
                }
            }
        }
    }
}

#[test]
fn lots_have_their_few_of_the_landscapes_ten() {
    let stock = palette("temperate");
    let structure = Structure::default();
    let ids = |stock: &Stock| -> BTreeSet<String> {
        stock.trees.iter().chain(&stock.shrubs).map(|entry| entry.id.to_string()).collect()
    };
    let ten = ids(&landscape(&stock, &structure, Seed(9)));
    assert_eq!(ten.len(), 10);
    let lots: Vec<BTreeSet<String>> =
        (0..40).map(|lot| ids(&of_lot(&landscape(&stock, &structure, Seed(9)), &structure, Seed(lot)))).collect();
    assert!(lots.iter().all(|lot| lot.len() == 4 && lot.is_subset(&ten)));
    assert!(lots.iter().collect::<BTreeSet<_>>().len() > 10, "lots differ");
    assert!(ids(&landscape(&stock, &structure, Seed(10))) != ten, "runs differ");
    // One more species in a lot keeps those that were there.
    let more = Structure { species_count: 5, ..structure };
    let five = ids(&of_lot(&landscape(&stock, &structure, Seed(9)), &more, Seed(3)));
    assert!(lots[3].is_subset(&five) && five.len() == 5);
}

#[test]
fn no_palette_is_one_kind_by_mistake() {
    let catalogue = Catalogue::built_in();
    for name in ["temperate", "continental", "mediterranean", "subtropical", "formal", "avenue"] {
        let stock: Stock = catalogue.palette(name).expect(name).plants(catalogue).collect();
        assert!(stock.trees.len() >= 6 && stock.shrubs.len() >= 2, "{name}");
    }
    let one = Stock { trees: stock_of(&["plane"]), ..Stock::default() };
    let shrubs = Structure { tree_ratio: 0.0, ..Structure::default() };
    let seeds = Seeds { run: Seed(1), lot: Seed(1), plant: Seed(1) };
    assert_eq!(&*choose(&one, &shrubs, seeds).expect("the only one").category, "plane");
    assert!(choose(&Stock::default(), &shrubs, seeds).is_none());
}

fn stock_of(names: &[&str]) -> smallvec::SmallVec<[&'static Entry; 16]> {
    names.iter().map(|name| entry(name)).collect()
}

#[test]
fn users_palettes_and_old_catalogues_are_read() {
    let text = "[plant.my-elm]\nspecies = \"Ulmus minor\"\ntypes.adult = { age = 50, height = 20, crown_radius = 6 }\n\
                [palette.quay]\nplants = [\"my-elm\", \"plane\", \"plame\", \"bench\"]\n\
                [palette.temperate]\nplants = [\"yew\"]\n[palette.none]\nplants = []\n";
    let (catalogue, found) = Catalogue::built_in().extended("a.toml", text.as_bytes(), &MemoryWorld::default());
    let names = |name: &str| -> Vec<String> {
        catalogue.palette(name).expect(name).plants(&catalogue).map(|entry| entry.id.to_string()).collect()
    };
    assert_eq!(
        (names("quay"), names("temperate")),
        (vec!["my-elm".into(), "platanus-hispanica".into()], vec!["taxus-baccata".into()])
    );
    let said: Vec<String> = found.iter().map(|d| format!("{} {}", d.message, d.hints.join(" "))).collect();
    let said = said.join("\n");
    for expected in ["has no element `plame`", "did you mean `plane`?", "`bench` is no plant", "at least one plant"] {
        assert!(said.contains(expected), "missing: {expected}\n{said}");
    }
    let elm = sizes(catalogue.by_id("my-elm").expect("an elm"), 25.0).expect("sizes");
    assert!(!elm.measured && (elm.height - 11.0).abs() < 1e-9, "{elm:?}");
}

/// The rows of a table, as maps from column to text.
fn table(text: &str) -> Vec<BTreeMap<String, String>> {
    let split = |line: &str| -> Vec<String> {
        let (mut cells, mut quoted) = (vec![String::new()], false);
        for c in line.chars() {
            match c {
                '"' => quoted = !quoted,
                ',' if !quoted => cells.push(String::new()),
                c => cells.last_mut().expect("a cell").push(c),
            }
        }
        cells.into_iter().map(|cell| cell.trim().to_string()).collect()
    };
    let mut lines = text.trim_start_matches('\u{feff}').lines();
    let header = split(lines.next().unwrap_or_default());
    lines.map(|line| header.iter().cloned().zip(split(line)).collect()).collect()
}

/// Published coefficients against the trees they were fitted to.
#[test]
fn curves_meet_the_measured_trees() {
    let path = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data/utd/TS3_Raw_tree_data.csv");
    let Ok(bytes) = std::fs::read(&path) else {
        println!("skipped: {} is not there", path.display());
        return;
    };
    let trees = table(&String::from_utf8_lossy(&bytes));
    let columns = [
        ("dbh", "Age", "DBH (cm)"),
        ("height", "DBH (cm)", "TreeHt (m)"),
        ("crown_diameter", "DBH (cm)", "AvgCdia (m)"),
        ("crown_height", "DBH (cm)", "CrnHt (m)"),
        ("leaf_area", "DBH (cm)", "Leaf (m2)"),
    ];
    let (mut compared, mut spreads) = (0, Vec::new());
    for entry in plants().filter(|entry| entry.growth.contains_key("dbh")) {
        let word = |key: &str| entry.growth.get(key).and_then(toml::Value::as_str).expect(key);
        let region = word("source").trim_start_matches("utd:");
        let own: Vec<_> = trees.iter().filter(|t| t["Region"] == region && t["SpCode"] == word("code")).collect();
        for (name, x, y) in columns {
            let written = entry.growth[name].as_table().expect("a curve");
            let curve = Curve::read(written).expect("a curve");
            let number = |tree: &BTreeMap<String, String>, key: &str| tree[key].parse().ok().filter(|n: &f64| *n > 0.0);
            let pairs: Vec<(f64, f64)> = own.iter().filter_map(|t| Some((number(t, x)?, number(t, y)?))).collect();
            if pairs.len() < 20 {
                continue;
            }
            let sum: f64 = pairs.iter().map(|(_, y)| y).sum();
            let bias = pairs.iter().map(|(x, y)| curve.at(*x) - y).sum::<f64>() / sum;
            let most = if name == "leaf_area" { 0.16 } else { 0.115 };
            assert!(bias.abs() < most, "{} {name}: {bias}", entry.id);
            if written["form"].as_str() == Some("loglogw1") {
                let mse = written["with"][2].as_float().expect("the published error");
                let squares: f64 =
                    pairs.iter().map(|(x, y)| (libm::log(y / curve.equation(*x)) + mse / 2.0).powi(2)).sum();
                spreads.push((squares / (pairs.len() - 2) as f64 / mse).sqrt());
            }
            compared += 1;
        }
    }
    assert!(compared > 130, "only {compared} curves have trees");
    spreads.sort_by(f64::total_cmp);
    let median = spreads[spreads.len() / 2];
    assert!((0.9..1.15).contains(&median), "the spread is {median} of the published one");
}

/// A point that a placement gave a radius, planted.
fn planted(arguments: &[(&str, Value)], radius: f64, seed: u64) -> Shape {
    let operation = bosquet::ops::find("plant").expect("an operation");
    let value = |name: &str| arguments.iter().find(|(known, _)| *known == name).map(|(_, value)| value.clone());
    let mut values: Vec<Option<Value>> = operation.spec.params.iter().map(|param| value(param.name)).collect();
    let scope = Scope { frame: Frame::WORLD, size: DVec3::ZERO };
    let place = Place { radius, ..Place::default() };
    let mut shape = Shape {
        scope,
        geometry: Geometry::Point,
        attributes: Vec::new().into(),
        style: Default::default(),
        ordinals: Ordinals { place, ..Ordinals::default() },
        seed: Seed(seed),
    };
    let world = MemoryWorld::default();
    let given = Given {
        cuts: &[],
        depths: &[],
        operands: &[],
        edge_attributes: &[],
        tags: false,
        chosen: &[],
        seed: Seed(seed),
        lot: Seed(7),
        run: Seed(1),
        around: &scope,
        fields: &[],
        outline: &Area::empty(),
        standing: &Standing::default(),
        intra: &Occluders::default(),
        inter: &Occluders::default(),
        beyond: &Occluders::default(),
        is_ancestor: &|_| false,
        names: None,
        catalogue: Catalogue::built_in(),
        world: &world,
        rasters: &Rasters::new(&world, "", Georeference::default()),
        most: 10,
    };
    operation.apply(&mut values, &mut shape, &given).unwrap_or_else(|problem| panic!("{problem:?}"));
    shape
}

fn record(shape: &Shape) -> &Placed {
    let Geometry::Element(placed) = &shape.geometry else { panic!("no plant: {:?}", shape.geometry) };
    placed
}

#[test]
fn crowns_keep_within_the_reserved_radius() {
    let (mut capped, mut free) = (0, 0);
    for seed in 0..500 {
        for (radius, pruning) in [(0.4, 1.0), (2.0, 1.0), (2.0, 0.3), (5.0, 0.7)] {
            let arguments = [("max_age", Value::Float(80.0)), ("pruning", Value::Float(pruning))];
            let (shape, wild) = (planted(&arguments, radius, seed), planted(&arguments, 0.0, seed));
            let (placed, size) = (record(&shape), shape.scope.size);
            assert!(size.x <= 2.0 * radius + 1e-9 && size.x == size.z && size.y > 0.0, "{placed:?} {size}");
            assert_eq!(placed.entry, record(&wild).entry, "the radius chooses no species");
            assert!(placed.age <= record(&wild).age && placed.age <= 80.0);
            // The middle of the crown stays on the point.
            assert!((shape.scope.frame.origin + size * 0.5).with_y(0.0).length() < 1e-9);
            let grown = placed.grown.expect("grown");
            assert!(grown.crown_height <= size.y + 1e-9 && grown.pruning == pruning && grown.trunk_diameter > 0.0);
            if placed.age < record(&wild).age { capped += 1 } else { free += 1 }
        }
    }
    assert!(capped > 300 && free > 100, "{capped} capped, {free} free");
}

#[test]
fn ages_are_even_between_their_bounds() {
    let count = 4000;
    let arguments = [("min_age", Value::Float(20.0)), ("max_age", Value::Float(60.0))];
    let ages: Vec<f64> = (0..count).map(|seed| record(&planted(&arguments, 0.0, seed)).age).collect();
    assert!(ages.iter().all(|age| (20.0..60.0).contains(age)));
    for quarter in 0..4 {
        let from = 20.0 + 10.0 * f64::from(quarter);
        let share = ages.iter().filter(|age| (from..from + 10.0).contains(*age)).count() as f64 / count as f64;
        assert!((share - 0.25).abs() < 4.0 * (0.25 * 0.75 / count as f64).sqrt(), "{share} from {from} years");
    }
}

#[test]
fn palettes_in_rules_can_take_each_others_place() {
    let folder = std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("rules/palettes");
    let mut names: Vec<BTreeSet<String>> = Vec::new();
    for file in std::fs::read_dir(folder).expect("palettes") {
        let text = std::fs::read_to_string(file.expect("a file").path()).expect("a text");
        let constants = text.lines().filter_map(|line| line.strip_prefix("const ")?.split_once(" = "));
        let constants: BTreeMap<&str, &str> = constants.map(|(name, value)| (name, value.trim_matches('"'))).collect();
        for (name, value) in &constants {
            let known = match *name {
                "palette" => Catalogue::built_in().palette(value).is_some(),
                _ => Catalogue::built_in().find(value, "").is_ok_and(|found| found.entry.kind.is_plant()),
            };
            assert!(known, "{name} = {value}");
        }
        names.push(constants.keys().map(|name| name.to_string()).collect());
        let rules = "import planting : \"palette.cga\"\nLot --> plant(planting.avenue, max_age = 40)\n";
        let world = MemoryWorld::default().with("main.cga", rules).with("palette.cga", text);
        assert_eq!(bosquet::check::check(&world, "main.cga").1, []);
    }
    assert!(names.len() >= 5 && names.windows(2).all(|pair| pair[0] == pair[1]), "{names:?}");
}
