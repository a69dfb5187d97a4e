//! Plans: true to scale, well-formed, the same every time, and an error instead of a panic.

#[path = "common/sample_scene.rs"]
mod sample_scene;

use bosquet::export::plan::{Drawing, PlanError, PlanOptions, PlanSize, Resolution, draw, png, svg};
use bosquet::geometry::{Area, Bounds, Polygon};
use bosquet::scene::{LotOutline, Scene};
use glam::DVec2;
use sample_scene::{formal_garden, plant, rectangle};
use std::time::Instant;

/// A rectangle as a region, and one tree.
fn small_scene(width: f64, depth: f64) -> Scene {
    let lot = LotOutline {
        id: "a".into(),
        name: "Garden".into(),
        kind: "lot".into(),
        zone: "".into(),
        area: rectangle(0.0, 0.0, width, depth),
    };
    Scene {
        lots: vec![lot],
        plants: vec![plant("betula-pendula", "adult", DVec2::new(5.0, 5.0), 3)],
        ..Scene::default()
    }
}

fn at_scale(scale: f64) -> PlanOptions {
    PlanOptions { scale: Some(scale), ..PlanOptions::default() }
}

/// The numbers of a path's data, two by two.
fn points(data: &str) -> Vec<DVec2> {
    let (mut points, mut pen) = (Vec::new(), DVec2::ZERO);
    let mut rest = data;
    while let Some(command) = rest.chars().next().filter(|c| *c != 'Z') {
        let end = rest[1..].find(|c: char| c.is_alphabetic()).map_or(rest.len(), |i| i + 1);
        let numbers: Vec<f64> = rest[1..end].split(' ').map(|n| n.parse().expect("a number")).collect();
        pen = match command {
            'H' => DVec2::new(numbers[0], pen.y),
            'V' => DVec2::new(pen.x, numbers[0]),
            _ => DVec2::new(numbers[numbers.len() - 2], numbers[numbers.len() - 1]),
        };
        points.push(pen);
        rest = &rest[end..];
    }
    points
}

fn outline_size(text: &str) -> DVec2 {
    let document = roxmltree::Document::parse(text).expect("well-formed");
    let lot = document.descendants().find(|n| n.attribute("class") == Some("lot lot")).expect("a lot");
    let path = lot.descendants().find(|n| n.has_tag_name("path")).expect("its outline");
    Bounds::of(points(path.attribute("d").expect("data"))).size()
}

#[test]
fn lengths_are_true_to_scale() {
    for (scale, millimetres) in [(500.0, 2.0), (200.0, 5.0), (1000.0, 1.0), (333.0, 1000.0 / 333.0)] {
        let text = svg(&draw(&small_scene(40.0, 25.0), &at_scale(scale)));
        let size = outline_size(&text);
        assert!(size.distance(DVec2::new(40.0, 25.0) * millimetres) < 2e-3, "1:{scale} gives {size}");
    }
    // A quarter turn exchanges width and depth.
    let turned = PlanOptions { rotation: 90.0, ..at_scale(500.0) };
    assert!(outline_size(&svg(&draw(&small_scene(40.0, 25.0), &turned))).distance(DVec2::new(50.0, 80.0)) < 2e-3);
}

#[test]
fn units_are_millimetres_of_paper() {
    let drawing = draw(&small_scene(40.0, 25.0), &at_scale(500.0));
    let text = svg(&drawing);
    let document = roxmltree::Document::parse(&text).expect("well-formed");
    let root = document.root_element();
    let view: Vec<f64> = root.attribute("viewBox").expect("a box").split(' ').map(|n| n.parse().expect("n")).collect();
    assert_eq!(root.attribute("width"), Some(format!("{}mm", view[2]).as_str()));
    assert_eq!(root.attribute("height"), Some(format!("{}mm", view[3]).as_str()));
}

#[test]
fn without_a_wish_the_scale_is_round_and_the_sheet_at_most_a3() {
    for (width, depth) in [(30.0, 20.0), (330.0, 230.0), (1500.0, 90.0), (90.0, 1500.0), (2800.0, 1600.0)] {
        let drawing = draw(&small_scene(width, depth), &PlanOptions::default());
        let round = [20.0, 25.0, 50.0, 75.0, 100.0, 125.0, 150.0];
        assert!(round.iter().any(|r| [1.0, 10.0, 100.0, 1000.0].contains(&(drawing.scale / r))), "1:{}", drawing.scale);
        assert!(drawing.size.max_element() <= 420.0 && drawing.size.min_element() <= 297.0, "{}", drawing.size);
        let window = drawing.window[1] - drawing.window[0];
        assert!(window.cmpge(DVec2::new(width, depth) * 1000.0 / drawing.scale).all(), "the plan has room");
    }
}

#[test]
fn every_plant_has_its_title() {
    let scene = formal_garden();
    let text = svg(&draw(&scene, &PlanOptions::default()));
    let document = roxmltree::Document::parse(&text).expect("well-formed");
    let titles = document
        .descendants()
        .filter(|n| n.has_tag_name("use"))
        .filter_map(|n| n.children().find(|c| c.has_tag_name("title")).and_then(|t| t.text()));
    let titles: Vec<&str> = titles.collect();
    assert_eq!(titles.len(), scene.plants.len());
    assert!(titles.iter().any(|t| t.starts_with("Silver birch (Betula pendula), height ")), "{:?}", titles[0]);
}

#[test]
fn layers_are_layers_and_references_lead_somewhere() {
    let text = svg(&draw(&formal_garden(), &PlanOptions { codes: true, ..PlanOptions::default() }));
    let document = roxmltree::Document::parse(&text).expect("well-formed");
    let ids: Vec<&str> = document.descendants().filter_map(|n| n.attribute("id")).collect();
    let unique: std::collections::BTreeSet<&str> = ids.iter().copied().collect();
    assert_eq!(unique.len(), ids.len(), "ids are unique");
    for reference in document.descendants().filter_map(|n| n.attribute("href")) {
        assert!(unique.contains(&reference[1..]), "{reference}");
    }
    let inkscape = "http://www.inkscape.org/namespaces/inkscape";
    let layers: Vec<_> = document.descendants().filter_map(|n| n.attribute((inkscape, "label"))).collect();
    let expected = ["Paper", "Ground covers", "Shadows", "Solids", "Trees", "Objects", "Legend"];
    let mut rest = layers.iter();
    assert!(expected.iter().all(|label| rest.any(|l| l == label)), "in order: {layers:?}");
}

#[test]
fn hostile_names_stay_words() {
    let hostile = "<&\">'\u{0}\u{1b}]]>\u{fffe} & co";
    let mut scene = small_scene(40.0, 25.0);
    scene.title = hostile.into();
    scene.lots[0].name = hostile.into();
    scene.lots[0].kind = hostile.into();
    let tree = &mut scene.plants[0];
    for name in [&mut tree.common_name, &mut tree.species, &mut tree.code] {
        *name = hostile.into();
    }
    let options = PlanOptions { codes: true, subtitle: Some(hostile.into()), ..PlanOptions::default() };
    let drawing = draw(&scene, &options);
    let text = svg(&drawing);
    let document = roxmltree::Document::parse(&text).expect("well-formed");
    let title = document.root_element().children().find(|n| n.has_tag_name("title")).and_then(|n| n.text());
    assert_eq!(title, Some("<&\">']]> & co"));
    assert!(png(&drawing, Resolution::Drawn).is_ok());
}

#[test]
fn the_same_scene_gives_the_same_bytes() {
    let options = PlanOptions { codes: true, ..PlanOptions::default() };
    let once = draw(&formal_garden(), &options);
    let twice = draw(&formal_garden(), &options);
    assert_eq!(svg(&once), svg(&twice));
    let small = Resolution::Width(400);
    assert_eq!(png(&once, small), png(&twice, small));
}

#[test]
fn a_plant_more_leaves_the_others_as_they_are() {
    let mut scene = formal_garden();
    let options = PlanOptions { extent: Some(extent(&scene)), ..at_scale(1000.0) };
    let trees = |scene: &Scene| -> Vec<(String, String)> {
        let text = svg(&draw(scene, &options));
        let document = roxmltree::Document::parse(&text).expect("well-formed");
        let placed = document.descendants().filter(|n| n.has_tag_name("use") && n.has_children());
        let attribute = |n: roxmltree::Node, name| n.attribute(name).unwrap_or_default().to_string();
        placed.map(|n| (attribute(n, "transform"), attribute(n, "href"))).collect()
    };
    let before = trees(&scene);
    scene.plants.push(plant("tulipa-gesneriana", "adult", DVec2::new(0.0, 112.0), 99));
    let after = trees(&scene);
    assert_eq!(after.len(), before.len() + 1);
    let places: std::collections::BTreeSet<&String> = after.iter().map(|t| &t.0).collect();
    assert!(before.iter().all(|t| places.contains(&t.0)));
}

fn extent(scene: &Scene) -> Bounds {
    scene.lots.iter().map(|lot| lot.area.bounds()).fold(Bounds::EMPTY, Bounds::union)
}

/// Width and height as the file's header says.
fn pixels(bytes: &[u8]) -> (u32, u32) {
    let picture = image::load_from_memory(bytes).expect("a picture");
    (picture.width(), picture.height())
}

#[test]
fn pictures_have_the_promised_size() {
    let scene = small_scene(40.0, 25.0);
    for (width, height) in [(1200, 800), (801, 333), (64, 64), (1, 1), (300, 2000)] {
        let options = PlanOptions { size: PlanSize::Pixels(width, height), ..PlanOptions::default() };
        let bytes = png(&draw(&scene, &options), Resolution::Drawn).expect("a picture");
        assert_eq!(pixels(&bytes), (width, height));
    }
    let drawing = draw(&scene, &at_scale(500.0));
    let bytes = png(&drawing, Resolution::DotsPerInch(254.0)).expect("a picture");
    assert_eq!(pixels(&bytes), ((drawing.size.x * 10.0).round() as u32, (drawing.size.y * 10.0).round() as u32));
    assert_eq!(bytes[37..41], *b"pHYs");
    assert_eq!(bytes[41..45], 10_000u32.to_be_bytes());
    assert_eq!(pixels(&png(&drawing, Resolution::Width(777)).expect("a picture")).0, 777);
}

#[test]
fn metres_per_pixel_hold() {
    let options = PlanOptions { size: PlanSize::MetresPerPixel(0.1), ..at_scale(500.0) };
    let drawing = draw(&small_scene(40.0, 25.0), &options);
    // 0.1 m are 0.2 mm at 1:500: five dots to the millimetre.
    assert!((drawing.dots - 5.0).abs() < 1e-12);
}

#[test]
fn impossible_pictures_are_errors() {
    let scene = small_scene(40.0, 25.0);
    let huge = PlanOptions { size: PlanSize::Pixels(u32::MAX, u32::MAX), ..PlanOptions::default() };
    let drawing = draw(&scene, &huge);
    assert!(matches!(png(&drawing, Resolution::Drawn), Err(PlanError::Size { .. })));
    let drawing = draw(&scene, &PlanOptions::default());
    for dots in [1e9, 0.0, -300.0, f64::NAN, f64::INFINITY] {
        let error = png(&drawing, Resolution::DotsPerInch(dots)).expect_err("an error");
        assert!(error.to_string().contains("80000000"), "{error}");
    }
    assert!(png(&Drawing::default(), Resolution::Drawn).is_err(), "nothing has no size");
}

#[test]
fn nothing_and_nonsense_are_drawn_without_a_panic() {
    let point = Scene { plants: vec![plant("betula-pendula", "adult", DVec2::new(1e7, -1e7), 1)], ..Scene::default() };
    let mut broken = small_scene(40.0, 25.0);
    broken.plants[0].position = DVec2::NAN;
    broken.plants.push(plant("betula-pendula", "adult", DVec2::new(3.0, 3.0), 1));
    (broken.plants[1].height, broken.plants[1].crown_radius, broken.plants[1].age) = (f64::NAN, f64::INFINITY, -1.0);
    let options = [
        PlanOptions::default(),
        PlanOptions { legend: false, names: false, codes: true, ..PlanOptions::default() },
        PlanOptions { scale: Some(f64::NAN), rotation: 33.0, ..PlanOptions::default() },
        PlanOptions { size: PlanSize::Pixels(0, 0), ..PlanOptions::default() },
        PlanOptions { size: PlanSize::MetresPerPixel(-1.0), ..PlanOptions::default() },
        PlanOptions { extent: Some(Bounds::of([DVec2::ZERO, DVec2::ZERO])), ..PlanOptions::default() },
    ];
    for scene in [Scene::default(), point, broken] {
        for options in &options {
            let drawing = draw(&scene, options);
            let text = svg(&drawing);
            assert!(roxmltree::Document::parse(&text).is_ok());
            let _ = png(&drawing, Resolution::Width(200));
        }
    }
}

#[test]
fn a_narrow_view_of_a_large_park_draws_its_part_only() {
    let extent = Some(Bounds::of([DVec2::new(-10.0, -10.0), DVec2::new(10.0, 10.0)]));
    let drawing = draw(&formal_garden(), &PlanOptions { extent, ..at_scale(20.0) });
    assert!(svg(&drawing).len() < 4_000_000);
    assert!(png(&drawing, Resolution::Width(600)).is_ok());
}

/// Writes pictures for people to look at: `PLAN_GALLERY=folder cargo test --test plan -- --ignored`.
#[test]
#[ignore = "for the eye"]
fn gallery() {
    let folder = std::env::var("PLAN_GALLERY").expect("a folder in PLAN_GALLERY");
    let scene = formal_garden();
    let part = |x: f64, y: f64, size: DVec2| Some(Bounds::of([DVec2::new(x, y), DVec2::new(x, y) + size]));
    let whole = PlanOptions { subtitle: Some("Planting plan".into()), ..PlanOptions::default() };
    let detail = part(-40.0, -60.0, DVec2::new(75.0, 60.0));
    let parterre = part(45.0, -10.0, DVec2::new(100.0, 70.0));
    let garden = part(-40.0, -60.0, DVec2::new(30.0, 24.0));
    let views = [
        ("whole", whole.clone()),
        ("park", PlanOptions { scale: Some(5000.0), ..whole.clone() }),
        ("part", PlanOptions { scale: Some(1000.0), rotation: 12.0, ..whole.clone() }),
        ("detail", PlanOptions { scale: Some(250.0), codes: true, extent: detail, ..whole.clone() }),
        ("parterre", PlanOptions { scale: Some(250.0), extent: parterre, ..whole.clone() }),
        ("garden", PlanOptions { scale: Some(100.0), codes: true, extent: garden, ..whole.clone() }),
        ("screen", PlanOptions { size: PlanSize::Pixels(1600, 1000), ..whole.clone() }),
        ("strip", PlanOptions { legend: false, ..whole.clone() }),
    ];
    for (name, options) in views {
        write(&folder, name, &scene, &options);
    }
    write(&folder, "forest", &forest(), &whole);
}

/// A park of 2.8 kilometres with 25,000 trees.
fn forest() -> Scene {
    let mut scene = Scene { title: "Grand Parc".into(), ..Scene::default() };
    let area = |points: &[DVec2]| Polygon::new(points, &[]).map(Area::from).unwrap_or_default();
    let corner = |x: f64, y: f64| DVec2::new(x, y);
    let ring = [corner(0.0, 0.0), corner(2800.0, 0.0), corner(2800.0, 1600.0), corner(0.0, 1600.0)];
    for (word, region) in [("meadow", area(&ring)), ("water", rectangle(200.0, 750.0, 1800.0, 100.0))] {
        scene.covers.push(sample_scene::cover(word, region));
    }
    for i in 0..25_000u32 {
        let (column, row) = (f64::from(i % 250), f64::from(i / 250));
        let at = DVec2::new(20.0 + 11.0 * column, if row < 50.0 { 20.0 + 14.0 * row } else { 180.0 + 14.0 * row });
        let id = ["carpinus-betulus", "quercus-robur", "tilia-europaea"][(i as usize * 7 / 3) % 3];
        let kind = ["young", "medium"][(i as usize * 5 / 4) % 2];
        scene.plants.push(plant(id, kind, at, u64::from(i)));
    }
    scene
}

fn write(folder: &str, name: &str, scene: &Scene, options: &PlanOptions) {
    let start = Instant::now();
    let drawing = draw(scene, options);
    let text = svg(&drawing);
    let drawn = start.elapsed();
    let bytes = png(&drawing, Resolution::Drawn).expect("a picture");
    println!("{name}: svg {} kB {drawn:?}, png {} kB {:?}", text.len() / 1024, bytes.len() / 1024, start.elapsed());
    std::fs::write(format!("{folder}/{name}.svg"), text).expect("written");
    std::fs::write(format!("{folder}/{name}.png"), bytes).expect("written");
}
