//! What users rely on where rules place plants: exact distances, room between all of them, the same places on any number
//! of threads, and an edit that stays within its context.

#[path = "common/place.rs"]
mod place;
#[path = "common/polygons.rs"]
mod polygons;

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::geometry::Polygon;
use bosquet::layout::{Feature, Kind, Layout, Region, Shapes};
use bosquet::placement::Body;
use bosquet::seed::Seed;
use bosquet::shape::{Derivation, Shape, on_plan};
use bosquet::trace::{TreeOptions, lot_text, tree_text};
use bosquet::value::Value;
use bosquet::world::MemoryWorld;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

/// Every strategy, one after the other.
const ALL: &str = r#"
attr walls = 3
Lot --> set(envelope.walls, walls) along(spacing = 9, inset = 1.5, corner = 3, radius = 1) { T }
        boundary(width = 4, radius = 1.4, radius_sd = 0.2, density = 0.7) { T }
        equidistant(spacing = 7, radius = 1.2) { T } regular(cell = 8, jitter = 0.4, radius = 1.5) { T }
        cluster(cluster_radius = 6, clusters = 3, radius = 1.1) { T } single(radius = 2) { T }
        rows(spacing = 6, distance = 9, radius = 0.9, inset = 1) { T } quincunx(spacing = 11, radius = 1) { T }
        semirandom(radius = 1.3 + place.u, radius_sd = 0.3, avoid = "layer:pipes", margin = 2) { T } NIL
T --> Plant.
"#;

fn sound(rules: &str) -> (Program, MemoryWorld) {
    let world = MemoryWorld::default().with("main.cga", rules);
    let (program, diagnostics) = check(&world, "main.cga");
    assert!(!diagnostics.iter().any(Diagnostic::is_error), "{diagnostics:?}");
    (program, world)
}

fn run(rules: &str, layout: &Layout, seed: u64) -> (Derivation, Vec<Diagnostic>) {
    let (program, world) = sound(rules);
    let (catalogue, limits) = (Catalogue::built_in(), Limits::default());
    let options = Options { start: None, seed: Seed(seed), set: Vec::new(), catalogue, world: &world, limits };
    derive(&program, layout, &options, &Progress::default())
}

fn feature(kind: Kind, shapes: Shapes) -> Feature {
    let attributes = Default::default();
    Feature { id: "".into(), name: "".into(), kind, shapes, elevation: 0.0, height: 0.0, attributes }
}

/// The shapes that a placement gave a radius, each with its place on the plan.
fn placed(derivation: &Derivation) -> Vec<(&Shape, DVec2, f64)> {
    let leaves = derivation.lots.iter().flat_map(|lot| &lot.outcome.leaves).map(|leaf| &*leaf.shape);
    let place = |shape: &Shape| (on_plan(shape.scope.frame.origin), shape.ordinals.place.radius);
    leaves.filter(|shape| shape.ordinals.place.radius > 0.0).map(|s| (s, place(s).0, place(s).1)).collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(128) })]

    #[test]
    fn plants_keep_clear_of_everything_that_stands(
        polygon in polygons::polygon(),
        walls in polygons::convex(),
        (house, drive, door, tree, pipe) in {
            let point = || (-25.0..25.0f64, -25.0..25.0f64).prop_map(DVec2::from);
            (point(), point(), point(), point(), point())
        },
        seed in any::<u64>(),
    ) {
        let about = |centre: DVec2, radius: f64, sides: usize| Polygon::regular(centre, radius, sides).expect("round");
        let house = walls.mapped(|p| p * 0.2 + house);
        let crown = Feature {
            attributes: [("crown_radius".into(), Value::Float(2.5))].into(),
            ..feature(Kind::Tree, Shapes::Points(vec![tree]))
        };
        let pipes = Feature {
            attributes: [("layer".into(), Value::text("pipes"))].into(),
            ..feature(Kind::Marker("manhole".into()), Shapes::Points(vec![pipe]))
        };
        let features = vec![
            feature(Kind::Building, Shapes::Areas(vec![house.clone()])),
            feature(Kind::Driveway, Shapes::Areas(vec![about(drive, 3.0, 4)])),
            feature(Kind::Marker("door".into()), Shapes::Points(vec![door])),
            crown,
            pipes,
        ];
        let layout = place::layout(vec![place::region("lot", polygon.clone())], features);
        let (derivation, found) = run(ALL, &layout, seed);
        prop_assert!(!found.iter().any(Diagnostic::is_error), "{found:?}");
        let plants = placed(&derivation);
        let kept = [
            (Body::Area(house.into()), 3.0),
            (Body::Area(about(drive, 3.0, 4).into()), 1.5),
            (Body::Point(door), 6.0),
        ];
        for (shape, p, radius) in &plants {
            prop_assert!(polygon.contains(*p) || polygon.distance_to_edges(*p) < 1e-6, "{p} lies outside");
            for (body, distance) in &kept {
                prop_assert!(body.distance(*p) >= distance - 1e-6, "{p} is {} m from {body:?}", body.distance(*p));
            }
            prop_assert!(p.distance(tree) >= radius + 2.5 - 1e-6, "{p} stands under the tree");
            let up = shape.scope.frame.rotation * DVec3::Y;
            prop_assert!(shape.scope.size == DVec3::ZERO && (up - DVec3::Y).length() < 1e-9);
        }
        for (index, (_, p, radius)) in plants.iter().enumerate() {
            for (_, q, other) in &plants[..index] {
                prop_assert!(p.distance(*q) >= radius + other - 1e-6, "{p} and {q} overlap");
            }
        }
    }

    #[test]
    fn disks_stay_inside_their_lot_where_a_rule_asks(lot in polygons::area(), seed in any::<u64>()) {
        let layout = place::layout(vec![place::region("lot", lot.polygons()[0].clone())], Vec::new());
        // The half of the lot that is planted is not its own seam.
        let half = "Lot --> set(envelope.seams, true)
            split(x) { '0.5 : semirandom(2, radius_sd = 0.4) { T. } NIL | ~1 : Lawn. }";
        let (derivation, _) = run(half, &layout, seed);
        for (_, p, radius) in placed(&derivation) {
            prop_assert!(lot.contains(p) && lot.distance_to_edges(p) >= radius - 1e-6, "{p} reaches over the edge");
        }
    }
}

/// Gardens of 30 × 20 m, each with a house, whose attributes are blended.
fn city(count: usize) -> (Vec<Region>, Vec<Feature>) {
    let corner = |index: usize| DVec2::new((index % 5) as f64 * 32.0, (index / 5) as f64 * 22.0);
    let square = |at: DVec2, size: DVec2| Polygon::rectangle(at, at + size).expect("an extent");
    let lot = |index: usize| {
        let mut region = place::region(&format!("lot{index}"), square(corner(index), DVec2::new(30.0, 20.0)));
        region.attributes.insert("radius".into(), Value::Float(1.0 + (index % 3) as f64));
        region
    };
    let house = |index: usize| square(corner(index) + DVec2::new(8.0, 5.0), DVec2::new(10.0, 8.0));
    let building = |index: usize| feature(Kind::Building, Shapes::Areas(vec![house(index)]));
    ((0..count).map(lot).collect(), (0..count).map(building).collect())
}

const CITY: &str = r#"
@Context(60)
attr radius = 2
@Context(60)
attr palette = "temperate"
Lot  --> set(envelope.walls, 2) boundary(3, radius, 0.2) { Tree } semirandom(radius, density = 0.5) { Tree } Lawn.
Tree --> plant(palette = palette)
"#;

#[test]
fn threads_change_no_place() {
    let (regions, features) = city(40);
    let layout = place::layout(regions, features);
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| tree_text(&run(CITY, &layout, 5).0, &TreeOptions::default()))
    };
    let one = with(1);
    assert!(one.lines().count() > 600, "{} lines", one.lines().count());
    assert_eq!(one, with(2));
    assert_eq!(one, with(5));
}

#[test]
fn an_edit_reaches_as_far_as_its_context() {
    let lots = |edited: bool| {
        let (mut regions, features) = city(40);
        if edited {
            regions[0].attributes.insert("radius".into(), Value::Float(4.0));
        }
        let (derivation, _) = run(CITY, &place::layout(regions, features), 5);
        derivation.lots.iter().map(|lot| lot_text(&derivation, lot, &TreeOptions::default())).collect::<Vec<_>>()
    };
    let (before, after) = (lots(false), lots(true));
    let centre = |index: usize| DVec2::new((index % 5) as f64 * 32.0, (index / 5) as f64 * 22.0);
    for index in 0..before.len() {
        let near = centre(index).distance(centre(0)) <= 60.0;
        assert_eq!(before[index] != after[index], near, "lot {index}, {:.0} m away", centre(index).length());
    }
}

#[test]
fn numbers_that_are_none_leave_out_their_operation_alone() {
    let layout = place::parse(&["rect 40 40"]).expect("a lot");
    for argument in ["radius = 0 / 0", "radius = 1 / 0", "radius = 2, density = 0 / 0", "radius = 2, radius_sd = 0 / 0"]
    {
        let rules = format!("Lot --> [ semirandom({argument}) {{ T. }} NIL ] semirandom(3) {{ T. }} Lawn.");
        let (derivation, found) = run(&rules, &layout, 1);
        let errors: Vec<&Diagnostic> = found.iter().filter(|d| d.is_error()).collect();
        assert!(errors.len() == 1 && errors[0].lot.as_deref() == Some("lot"), "{argument}: {found:?}");
        assert!(placed(&derivation).len() > 20, "{argument}: the rest of the lot goes on");
    }
}

#[test]
fn layers_are_avoided_by_name() {
    let pipe = Feature {
        attributes: [("layer".into(), Value::text("gas"))].into(),
        ..feature(
            Kind::Marker("pipe".into()),
            Shapes::Lines(vec![vec![DVec2::new(0.0, 20.0), DVec2::new(40.0, 20.0)]], 0.0),
        )
    };
    let square = Polygon::rectangle(DVec2::ZERO, DVec2::splat(40.0)).expect("an extent");
    let layout = place::layout(vec![place::region("lot", square)], vec![pipe]);
    let near = |avoid: &str| {
        let rules = format!("Lot --> semirandom(1, avoid = \"{avoid}\", margin = 4) {{ T. }} NIL");
        let (derivation, _) = run(&rules, &layout, 1);
        placed(&derivation).iter().filter(|(_, p, _)| (p.y - 20.0).abs() < 4.0).count()
    };
    assert_eq!([near("layer:gas"), near("gas"), near("kind:pipe")], [0, 0, 0]);
    assert!(near("label:pipe") > 20 && near("layer:water") > 20);
}

#[test]
fn what_lies_beyond_the_lot_line_counts() {
    let text = r#"{"type": "FeatureCollection", "crs": "local", "features": [
        {"type": "Feature", "properties": {"kind": "lot"}, "geometry":
          {"type": "Polygon", "coordinates": [[[0, 0], [50, 0], [50, 40], [0, 40], [0, 0]]]}},
        {"type": "Feature", "properties": {"kind": "building"}, "geometry":
          {"type": "Polygon", "coordinates": [[[52, 0], [60, 0], [60, 40], [52, 40], [52, 0]]]}},
        {"type": "Feature", "properties": {"kind": "tree", "crown_radius": 6}, "geometry":
          {"type": "Point", "coordinates": [-2, 20]}}]}"#;
    let (layout, _) = bosquet::layout::read_geojson("lot.geojson", text.as_bytes());
    let (derivation, _) = run("Lot --> semirandom(1) { T. } NIL", &layout, 1);
    let (house, tree) = match (&layout.features[0].shapes, &layout.features[1].shapes) {
        (Shapes::Areas(areas), Shapes::Points(points)) => (areas[0].clone(), points[0]),
        other => panic!("{other:?}"),
    };
    let plants = placed(&derivation);
    assert!(plants.len() > 200, "{} plants", plants.len());
    for (_, p, radius) in plants {
        assert!(house.distance_to_edges(p) >= 6.0 - 1e-6, "{p} is near the neighbour's house");
        assert!(p.distance(tree) >= 6.0 + radius - 1e-6, "{p} stands under the neighbour's tree");
    }
}

#[test]
fn radii_follow_a_spacing_that_varies() {
    let layout = place::parse(&["rect 60 40"]).expect("a lot");
    let (derivation, _) = run("Lot --> along(spacing = 4 + place.x / 5, inset = 3) { T. } NIL", &layout, 1);
    let radii: Vec<f64> = placed(&derivation).iter().map(|(.., radius)| *radius).collect();
    let (least, most) = radii.iter().fold((f64::MAX, 0.0f64), |(a, b), r| (a.min(*r), b.max(*r)));
    assert!(least < 2.8 && most > 5.0, "from {least} to {most}");
}

#[test]
fn plants_on_walls_take_no_ground() {
    let layout = place::parse(&["rect 30 30"]).expect("a lot");
    let ground = |before: &str| {
        let rules = format!("Lot --> {before} semirandom(1, avoid = \"none\") {{ T. }} NIL");
        let (derivation, _) = run(&rules, &layout, 1);
        let upright = |shape: &Shape| (shape.scope.frame.rotation * DVec3::Y).y > 0.99;
        placed(&derivation).iter().filter(|(shape, ..)| upright(shape)).count()
    };
    let walls = ground("[ extrude(6) comp(f) { side : semirandom(1.5) { P. } NIL | all : NIL } ]");
    assert!(walls > 100 && walls.abs_diff(ground("")) < 12, "{walls} plants beside {}", ground(""));
}
