//! Plants, surfaces, schedules and reports as data: what comes out can be trusted, and comes back.

use bosquet::diag::Diagnostic;
use bosquet::element::{Catalogue, Words};
use bosquet::export::plants::{FIELDS, ReadPlantsError, plants_csv, plants_geojson, read_plants};
use bosquet::export::report::{ReportInput, ReportedDiagnostic, Summary, report_json};
use bosquet::export::schedule::schedule_csv;
use bosquet::export::surfaces::surfaces_geojson;
use bosquet::geometry::{Area, Polygon};
use bosquet::layout::{Crs, Georeference};
use bosquet::scene::strip_length;
use bosquet::scene::{Cover, Object, Origin, Plant, PlantSymbol, Report, Scene, Solid};
use bosquet::value::Value;
use glam::DVec2;
use proptest::prelude::*;
use std::sync::Arc;

fn georeferences() -> [Georeference; 3] {
    [
        Georeference::new(Crs::Wgs84, [2.120148, 48.804826]).expect("degrees"),
        Georeference::new(Crs::Epsg(2154), [636_000.0, 6_856_000.0]).expect("Lambert-93"),
        Georeference::new(Crs::Local, [10.0, -20.0]).expect("local metres"),
    ]
}

fn scene(georeference: Georeference, plants: Vec<Plant>) -> Scene {
    Scene { title: "Le Nôtre's \"garden\"".into(), georeference, plants, ..Scene::default() }
}

fn rectangle(width: f64, depth: f64) -> Area {
    Polygon::rectangle(DVec2::ZERO, DVec2::new(width, depth)).expect("an extent").into()
}

fn origin(id: &str) -> Origin {
    Origin { lot: "lot-1".into(), rule: "Lawn".into(), id: id.into() }
}

fn cover(id: &str, word: &str, area: Area) -> Cover {
    let material = Catalogue::built_in().cover(word).expect(word).material.clone();
    Cover { origin: origin(id), material, area, elevation: 0.25, surface: None }
}

fn solid(word: &str, footprint: Area, height: f64) -> Solid {
    let material = Catalogue::built_in().cover(word).expect(word).material.clone();
    Solid { origin: origin(word), material, footprint, base: 0.0, height, mesh: None, surface: None }
}

/// A plant of the catalogue at a place.
fn plant(name: &str, class: &str, position: DVec2) -> Plant {
    let found = Catalogue::built_in().find(name, class).expect(name);
    let figures = found.variant.plant.expect("a plant");
    Plant {
        origin: origin("0123456789abcdef"),
        position,
        elevation: 1.5,
        heading: -22.75,
        kind: found.entry.kind.word().into(),
        category: found.entry.category.clone(),
        age_class: found.variant.name.clone(),
        appearance: 3,
        species: found.entry.species.clone(),
        common_name: found.entry.common_name.clone(),
        code: found.entry.code.clone(),
        spacing_radius: figures.spacing_radius,
        crown_radius: figures.crown_radius,
        age: figures.age,
        height: figures.height,
        trunk_diameter: figures.trunk_diameter,
        crown_height: 2.5,
        leaf_area: 0.0,
        pruning: 1.0,
        measured: true,
        seed: 0xfeed_0000_0000_0001,
        managed: true,
        existing: false,
        symbol: found.variant.symbol,
        color: found.entry.color,
    }
}

fn garden() -> Scene {
    let at = |x: f64| DVec2::new(x, 2.0);
    let plants = vec![
        plant("lime", "adult", at(0.0)),
        plant("birch", "adult", at(5.0)),
        Plant { height: 22.0, ..plant("birch", "adult", at(9.0)) },
        plant("birch", "young", at(12.0)),
    ];
    let ring = Polygon::rectangle(DVec2::ZERO, DVec2::splat(10.0)).expect("an extent");
    let inner: Vec<DVec2> = ring.outer().iter().map(|p| *p * 0.8 + 1.0).collect();
    let around = Polygon::new(ring.outer(), &[inner]).expect("a ring");
    let bench = Object {
        origin: origin("b"),
        entry: "bench".into(),
        category: "bench".into(),
        variant: "wood".into(),
        label: "Bench".into(),
        footprint: rectangle(1.8, 0.65),
        position: DVec2::ZERO,
        heading: 0.0,
        base: 0.0,
        size: [1.8, 0.85, 0.65],
        color: [0.5; 4],
        model: "".into(),
    };
    Scene {
        covers: vec![
            cover("c1", "lawn", rectangle(20.0, 10.0)),
            cover("c2", "lawn", rectangle(1.0, 1.0)),
            cover("c3", "gravel", around.clone().into()),
        ],
        solids: vec![
            solid("hedge", rectangle(30.0, 0.8), 1.5),
            solid("palissade", around.into(), 6.0),
            solid("wall", rectangle(8.0, 0.4), 2.0),
            solid("building", rectangle(12.0, 9.0), 7.0),
        ],
        objects: vec![bench.clone(), bench],
        ..scene(georeferences()[0].clone(), plants)
    }
}

fn any_plant() -> impl Strategy<Value = Plant> {
    let text = "[\\PC,\"\n;=é]{0,8}";
    let number =
        prop_oneof![Just(0.0), 0.0..40.0, any::<f32>().prop_map(f64::from).prop_filter("finite", |x| x.is_finite())];
    let place = (-3000.0..3000.0, -3000.0..3000.0, -50.0..4000.0);
    let texts = prop::collection::vec(text, 9);
    let numbers = prop::collection::vec(number, 4);
    let color = prop::array::uniform4(prop_oneof![(0u8..=255).prop_map(|byte| f32::from(byte) / 255.0), 0.0f32..1.0]);
    let rest = (any::<u64>(), any::<bool>(), any::<bool>(), any::<u32>(), 0..PlantSymbol::ALL.len());
    (place, texts, numbers, color, rest).prop_map(|((x, y, elevation), texts, numbers, color, rest)| {
        let mut texts = texts.into_iter().map(Arc::from);
        let mut text = || texts.next().unwrap_or_default();
        Plant {
            origin: Origin { lot: text(), rule: text(), id: text() },
            position: DVec2::new(x, y),
            elevation,
            heading: elevation * 0.25,
            kind: text(),
            category: text(),
            age_class: text(),
            species: text(),
            common_name: text(),
            code: text(),
            spacing_radius: numbers[0],
            crown_radius: numbers[1],
            age: numbers[2],
            height: numbers[3],
            trunk_diameter: numbers[0] * 0.5,
            crown_height: numbers[1] * 0.5,
            leaf_area: numbers[2] * 0.5,
            pruning: numbers[3] * 0.5,
            measured: rest.2,
            seed: rest.0,
            managed: rest.1,
            existing: rest.2,
            appearance: rest.3,
            symbol: PlantSymbol::ALL[rest.4].1,
            color,
        }
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn plants_come_back_as_they_went(plants in prop::collection::vec(any_plant(), 0..6)) {
        for georeference in georeferences() {
            let scene = scene(georeference, plants.clone());
            for text in [plants_geojson(&scene), plants_csv(&scene)] {
                let back = read_plants(text.as_bytes(), &scene.georeference).expect("what we wrote");
                prop_assert_eq!(back.len(), plants.len());
                for (read, plant) in back.into_iter().zip(&plants) {
                    prop_assert!(read.position.distance(plant.position) < 1e-4);
                    prop_assert_eq!(&Plant { position: plant.position, ..read }, plant);
                }
            }
        }
    }

    #[test]
    fn no_file_panics(bytes in prop::collection::vec(any::<u8>(), 0..200), cut in any::<prop::sample::Index>(), text in "[{}\\[\\],:\"a-z0-9\n]{0,80}") {
        let georeference = &georeferences()[0];
        let _ = read_plants(&bytes, georeference);
        let _ = read_plants(text.as_bytes(), georeference);
        let scene = garden();
        for whole in [plants_geojson(&scene), plants_csv(&scene)] {
            let _ = read_plants(&whole.as_bytes()[..cut.index(whole.len())], georeference);
        }
    }
}

#[test]
fn both_formats_carry_the_same_record() {
    let scene = garden();
    let collection: serde_json::Value = serde_json::from_str(&plants_geojson(&scene)).expect("JSON");
    let feature = &collection["features"][0];
    let names: Vec<&str> = FIELDS.iter().map(|field| field.name).collect();
    let keys: Vec<&str> = feature["properties"].as_object().expect("properties").keys().map(String::as_str).collect();
    assert_eq!(keys, names);
    let csv = plants_csv(&scene);
    assert_eq!(csv.lines().next().expect("a header"), format!("longitude,latitude,{}", names.join(",")));
    assert_eq!(feature["properties"]["seed"], "feed000000000001");
    assert_eq!(feature["properties"]["species"], "Tilia × europaea");
    assert_eq!(feature["geometry"]["coordinates"][2], 1.5);
    assert!(collection.get("crs").is_none() && csv.lines().count() == 5);
}

#[test]
fn projected_layouts_say_so() {
    let [_, lambert, local] = georeferences();
    let text = plants_geojson(&scene(lambert.clone(), vec![plant("oak", "", DVec2::new(1.0, 2.0))]));
    let collection: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(collection["crs"]["properties"]["name"], "urn:ogc:def:crs:EPSG::2154");
    let x = collection["features"][0]["geometry"]["coordinates"][0].as_f64().expect("a number");
    assert!((x - 636_001.0).abs() < 1e-3, "{x}");
    assert!(plants_csv(&scene(lambert, vec![])).starts_with("x,y,id,"));
    let error = read_plants(text.as_bytes(), &local).expect_err("another system");
    assert!(matches!(&error, ReadPlantsError::Crs { wanted, .. } if wanted == "local"), "{error}");
}

#[test]
fn mistakes_in_plant_files_are_named() {
    let georeference = &georeferences()[2];
    let message = |text: &str| read_plants(text.as_bytes(), georeference).expect_err("a mistake").to_string();
    assert_eq!(message("x,y,height\n1,2,tall\n"), "line 2: `height` must be a number, not `tall`");
    assert_eq!(message("x,y\n1,2\n\n1\n"), "line 4: there is no position");
    assert!(message("name\noak\n").contains("the first line must name the columns"));
    assert_eq!(message("x,y\n\"1,2"), "line 2: a quote is opened and never closed");
    assert!(message("{\"type\":").starts_with("the file is not JSON: "));
    assert_eq!(message("{}"), "the file is no GeoJSON feature collection");
    let plants = read_plants("\u{feff}y,x,species,planted by\r\n2,1,Quercus robur,me\r\n".as_bytes(), georeference);
    let plant = &plants.expect("a file from elsewhere")[0];
    assert_eq!((plant.position, &*plant.species), (DVec2::new(-9.0, 22.0), "Quercus robur"));
}

#[test]
fn surfaces_carry_material_and_area() {
    let scene = garden();
    let text = surfaces_geojson(&scene);
    let collection: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    let features = collection["features"].as_array().expect("features");
    assert_eq!(features.len(), 7);
    let lawn = &features[0]["properties"];
    assert_eq!((&lawn["material"], &lawn["class"], &lawn["area_m2"]), (&"lawn".into(), &"cover".into(), &200.into()));
    assert_eq!((&lawn["lot"], &lawn["rule"], &lawn["elevation"]), (&"lot-1".into(), &"Lawn".into(), &0.25.into()));
    let gravel = &features[2]["geometry"];
    assert_eq!(gravel["coordinates"].as_array().expect("rings").len(), 2, "the hole is kept");
    for ring in gravel["coordinates"].as_array().expect("rings") {
        let ring = ring.as_array().expect("positions");
        assert_eq!(ring.first(), ring.last(), "rings are closed");
    }
    assert_eq!(features[6]["properties"]["height"], 7);
    assert!(text.lines().count() == 9, "one feature a line");
}

#[test]
fn the_schedule_counts_and_measures() {
    let expected = "\
Plants
code,species,common name,kind,type,existing,count,mean height (m),mean crown radius (m),spacing radius (m)
BET,Betula pendula,Silver birch,tree,young,no,1,7,1.5,1.3
BET,Betula pendula,Silver birch,tree,adult,no,2,21,4.2,3.5
TIL,Tilia × europaea,Common lime,tree,adult,no,1,26,6.5,5.5

Surfaces
material,name,pieces,area (m²)
gravel,Gravel,1,36
lawn,Lawn,2,201

Hedges
material,name,pieces,length (m),mean height (m),area (m²)
hedge,Hedge,1,30,1.5,24
palissade,Clipped palissade,1,36,6,36

Walls
material,name,pieces,length (m),mean height (m),area (m²)
wall,Wall,1,8,2,3.2

Buildings and other solids
material,name,pieces,mean height (m),area (m²)
building,Building,1,7,108

Objects
entry,name,category,type,count
bench,Bench,bench,wood,2
";
    assert_eq!(schedule_csv(&garden()).replace("\r\n", "\n"), expected);
    assert_eq!(schedule_csv(&Scene::default()), "");
}

#[test]
fn strips_are_as_long_as_they_are() {
    // An L of 1 m width whose middle line is 19 m long; its area is 19 m², its half perimeter 20 m.
    let corners = [(0.0, 0.0), (10.0, 0.0), (10.0, 1.0), (1.0, 1.0), (1.0, 10.0), (0.0, 10.0)];
    let bent = Polygon::new(&corners.map(|(x, y)| DVec2::new(x, y)), &[]).expect("an L");
    assert!((strip_length(&bent.into()) - 19.0).abs() < 1e-9);
    assert!((strip_length(&rectangle(3.0, 3.0)) - 3.0).abs() < 1e-6);
    assert_eq!(strip_length(&Area::empty()), 0.0);
}

#[test]
fn the_report_is_plain_and_stable() {
    let mut trees = Report::new("trees".into());
    [1.0, 2.5, 4.0].into_iter().for_each(|number| trees.add(&Value::Float(number)));
    trees.add(&Value::text("a \"few\""));
    let problem = Diagnostic::data("geometry", "lot 7", "`lot 7` has no area").hint("draw it again");
    let reports = [trees];
    let input = ReportInput {
        settings: [("recursions".to_string(), "6".to_string())].into(),
        version: "0.1.0",
        seed: 7,
        inputs: vec![("garden.cga".into(), "af13".into())],
        summary: Summary::of(&garden()),
        without_rule: vec!["lot-9".to_owned()],
        counts_by_rule: [("Lot".to_owned(), 2), ("Lawn".to_owned(), 5)].into(),
        counts_by_symbol: [("Tree".to_owned(), 4)].into(),
        reports: &reports,
        diagnostics: vec![ReportedDiagnostic::of(&problem, "lot 7")],
    };
    let text = report_json(&input);
    assert_eq!(text, report_json(&input));
    let report: serde_json::Value = serde_json::from_str(&text).expect("JSON");
    assert_eq!(report["reports"][0]["sum"], 7.5);
    assert_eq!((&report["reports"][0]["average"], &report["reports"][0]["max"]), (&2.5.into(), &4.into()));
    assert_eq!(report["summary"]["area_by_material"]["lawn"], 201);
    assert_eq!(report["summary"]["plants_by_species"]["Betula pendula"], 3);
    assert_eq!(report["inputs"][0]["blake3"], "af13");
    assert_eq!(report["diagnostics"][0]["severity"], "error");
    let keys: Vec<&str> = report.as_object().expect("an object").keys().map(String::as_str).collect();
    let order = "version seed settings inputs summary without_rule counts_by_rule counts_by_symbol reports diagnostics";
    assert_eq!(keys.join(" "), order);
}
