//! What users of roofs and of shapes derived in place rely on: roofs are closed, lose nothing of the outline and slope
//! as they were told; areas after set operations are exact.

#[path = "common/place.rs"]
mod place;
#[path = "common/polygons.rs"]
mod polygons;

use bosquet::check::check;
use bosquet::derive::{Options, Progress, derive};
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::geometry::{Area, Mesh, Polygon, StraightSkeleton, inset, union_all};
use bosquet::seed::Seed;
use bosquet::shape::{LeafOf, Shape};
use bosquet::world::MemoryWorld;
use glam::{DVec2, DVec3};
use polygons::{area, convex, polygon};
use proptest::prelude::*;

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

/// What rules make of a polygon; nothing may be reported.
fn leaves(rules: &str, polygon: &Polygon) -> Vec<Shape> {
    let world = MemoryWorld::default().with("main.cga", rules);
    let (program, found) = check(&world, "main.cga");
    assert!(!found.iter().any(Diagnostic::is_error), "{found:?}");
    let layout = place::parse(&statements(polygon).iter().map(String::as_str).collect::<Vec<_>>()).expect("a layout");
    let (catalogue, limits) = (Catalogue::built_in(), Default::default());
    let options = Options { start: None, seed: Seed(3), set: Vec::new(), catalogue, world: &world, limits };
    let (mut derivation, found) = derive(&program, &layout, &options, &Progress::default());
    assert!(!found.iter().any(Diagnostic::is_error), "{found:?}");
    derivation.lots.remove(0).outcome.leaves.into_iter().map(|LeafOf { shape, .. }| *shape).collect()
}

/// The polygon as a test's layout says it.
fn statements(polygon: &Polygon) -> Vec<String> {
    let words = |ring: &[DVec2]| -> String { ring.iter().map(|p| format!(" {},{}", p.x, p.y)).collect() };
    let kinds = std::iter::once("polygon").chain(std::iter::repeat("hole"));
    polygon.rings().zip(kinds).map(|(ring, kind)| format!("{kind}{}", words(ring))).collect()
}

/// The mesh of the only leaf, in the world.
fn roof(rules: &str, polygon: &Polygon) -> Mesh {
    let leaves = leaves(rules, polygon);
    assert_eq!(leaves.len(), 1);
    let mesh = leaves[0].world_mesh().expect("a mesh");
    mesh.sanity_check().expect("a sound mesh");
    assert!(mesh.is_closed(), "an open roof over {polygon:?}");
    assert!(mesh.volume() > 0.0);
    mesh
}

#[track_caller]
fn close(a: f64, b: f64, slack: f64) {
    assert!((a - b).abs() <= slack, "{a} is not {b}");
}

/// Polygons with right angles on a grid of metres: many events of a skeleton come at the same time.
fn rectilinear() -> impl Strategy<Value = Polygon> {
    let rectangle = (0..12i32, 0..12i32, 1..9i32, 1..9i32);
    prop::collection::vec(rectangle, 1..6).prop_map(|rectangles| {
        let corner = |x: i32, y: i32| DVec2::new(x.into(), y.into());
        let area = |(x, y, w, h)| Area::from(Polygon::rectangle(corner(x, y), corner(x + w, y + h)).expect("a side"));
        let areas: Vec<Area> = rectangles.into_iter().map(area).collect();
        let union = union_all(&areas);
        let largest = union.polygons().iter().max_by(|a, b| a.area().total_cmp(&b.area()));
        largest.expect("a part").clone()
    })
}

/// Any of them.
fn outline() -> impl Strategy<Value = Polygon> {
    let afar = area().prop_map(|area| area.polygons()[0].clone());
    prop_oneof![polygon(), convex(), rectilinear(), afar]
}

/// The depth at which an outline shrinks to nothing, by halving.
fn depth(polygon: &Polygon) -> f64 {
    let (mut low, mut high) = (0.0, 100.0);
    for _ in 0..50 {
        let middle = (low + high) * 0.5;
        *(if inset(&polygon.clone().into(), middle).is_empty() { &mut high } else { &mut low }) = middle;
    }
    low
}

proptest! {
    #![proptest_config(cases(400))]

    #[test]
    fn every_outline_has_a_skeleton(polygon in outline()) {
        let skeleton = StraightSkeleton::of(&polygon, &[]).expect("a skeleton");
        let edges: Vec<(DVec2, DVec2)> = polygon.edges().collect();
        prop_assert_eq!(skeleton.faces.len(), edges.len());
        let mut covered = 0.0;
        for (face, (a, b)) in skeleton.faces.iter().zip(&edges) {
            let nodes: Vec<DVec3> = face.iter().map(|node| skeleton.nodes[*node as usize]).collect();
            // A face lies over its edge, and its nodes are as far from the edge's line as their time says.
            prop_assert_eq!((nodes[0].truncate(), nodes[1].truncate()), (*a, *b));
            let inwards = (*b - *a).normalize().perp();
            for node in &nodes {
                close(inwards.dot(node.truncate() - *a), node.z, 1e-5);
            }
            let ring: Vec<DVec2> = nodes.iter().map(|node| node.truncate()).collect();
            covered += bosquet::geometry::ring_area(&ring);
        }
        close(covered, polygon.area(), 1e-5 * (1.0 + polygon.area()));
    }

    #[test]
    fn the_ridge_is_as_high_as_the_largest_disk_is_deep(polygon in convex()) {
        let skeleton = StraightSkeleton::of(&polygon, &[]).expect("a skeleton");
        close(skeleton.latest(), depth(&polygon), 1e-4);
        let roof = roof("Lot --> roofHip(45)", &polygon);
        let (low, high) = roof.bounds().expect("a roof");
        close(high.y - low.y, skeleton.latest(), 1e-6);
    }
}

proptest! {
    #![proptest_config(cases(64))]

    #[test]
    fn hip_roofs_are_closed_and_equally_steep(polygon in outline(), angle in 10.0..70.0f64) {
        let roof = roof(&format!("Lot --> roofHip({angle})"), &polygon);
        let cosine = angle.to_radians().cos();
        let (bottom, slopes): (Vec<_>, Vec<_>) = roof.faces().partition(|face| face.normal().y < 0.0);
        prop_assert_eq!(bottom.len(), 1);
        prop_assert_eq!(slopes.len(), polygon.points().len());
        close(bottom[0].area(), polygon.area(), 1e-6 * polygon.area());
        // What slopes equally is its shadow's area by the cosine.
        close(slopes.iter().map(|face| face.area()).sum::<f64>() * cosine, polygon.area(), 1e-4 * polygon.area());
        for face in slopes.iter().filter(|face| face.area() > 1e-3) {
            close(face.normal().y, cosine, 1e-4);
        }
    }

    #[test]
    fn roofs_of_every_form_are_closed(polygon in outline(), angle in 10.0..60.0f64, index in -3..9i32) {
        for rule in ["roofGable({})", "roofShed({}, [])", "roofRidge(byAngle, {})", "extrude(3) roofHip({}, 0.05)"] {
            let rule = rule.replace("{}", &angle.to_string()).replace("[]", &index.to_string());
            let roof = roof(&format!("Lot --> {rule}"), &polygon);
            prop_assert!(roof.footprint().area() >= polygon.area() * 0.999, "{}", rule);
        }
    }

    #[test]
    fn walls_carry_the_roof(polygon in rectilinear()) {
        let bare = roof("Lot --> roofHip(40)", &polygon);
        let walled = roof("Lot --> extrude(3) roofHip(40)", &polygon);
        close(walled.volume(), bare.volume() + 3.0 * polygon.area(), 1e-6 * walled.volume());
        let ridge = roof("Lot --> extrude(3) roofRidge(byHeight, 2)", &polygon);
        let (low, high) = ridge.bounds().expect("a roof");
        prop_assert!(high.y - low.y <= 5.0 + 1e-9);
    }

    #[test]
    fn pyramids_have_a_third_of_their_box(polygon in convex(), height in 1.0..9.0f64) {
        for rule in [format!("roofPyramid(byHeight, {height})"), format!("taper({height})"), format!("taper(-{height})")] {
            let mesh = roof(&format!("Lot --> {rule}"), &polygon);
            close(mesh.volume(), polygon.area() * height / 3.0, 1e-6 * mesh.volume());
        }
    }

    #[test]
    fn sets_of_plane_shapes_add_up(polygon in outline(), share in 0.1..0.9f64, margin in 0.1..3.0f64) {
        let area = |rules: &str| -> f64 {
            let part = format!("A --> offset(-{margin}, inside)\nB --> split(x) {{ '{share} : NIL | ~1 : X. }}\n");
            leaves(&format!("Lot --> {rules}\n{part}"), &polygon).iter().map(|s| s.measure().area).sum()
        };
        let (a, b) = (area("A"), area("B"));
        let (either, both) = (area("union { A | B }"), area("intersect { A | B }"));
        let slack = 1e-5 * (1.0 + polygon.perimeter());
        close(either + both, a + b, slack);
        close(area("subtract { A | B }"), a - both, slack);
        close(area("inline(unify) { A B }"), either, slack);
        // The same as solids: between the ground and 2 m they are what they are on the plan.
        let volume = |rules: &str| -> f64 {
            let part = format!("A --> offset(-{margin}, inside) extrude(2)\n\
                B --> split(x) {{ '{share} : NIL | ~1 : extrude(3) X. }}\n");
            leaves(&format!("Lot --> {rules}\n{part}"), &polygon).iter().map(|s| s.measure().volume).sum()
        };
        close(volume("intersect { A | B }"), 2.0 * both, 4.0 * slack);
        close(volume("subtract { A | B }"), 2.0 * (a - both), 4.0 * slack);
        close(volume("union { A | B }"), 2.0 * either + b, 4.0 * slack);
    }
}

#[test]
fn known_roofs_have_the_volumes_of_the_books() {
    let rectangle = Polygon::rectangle(DVec2::ZERO, DVec2::new(10.0, 6.0)).expect("sides");
    // A hip roof 3 m high: a wedge of 4 m length between two halves of a pyramid.
    close(roof("Lot --> roofHip(45)", &rectangle).volume(), 4.0 * 9.0 + 6.0 * 6.0 * 3.0 / 3.0, 1e-9);
    close(roof("Lot --> roofGable(45)", &rectangle).volume(), 10.0 * 9.0, 1e-9);
    close(roof("Lot --> roofGable(45, 0, 0, false, 0)", &rectangle).volume(), 6.0 * 25.0, 1e-9);
    close(roof("Lot --> roofGable(byHeight, 1.5)", &rectangle).volume(), 10.0 * 4.5, 1e-9);
    close(roof("Lot --> roofRidge(byAngle, 45)", &rectangle).volume(), 10.0 * 9.0, 1e-9);
    close(roof("Lot --> roofShed(45)", &rectangle).volume(), 10.0 * 18.0, 1e-9);
    let eaves = roof("Lot --> roofHip(45, sqrt(2))", &rectangle);
    let (low, high) = eaves.bounds().expect("a roof");
    // The overhang is measured on the slope: a metre out and a metre down.
    close(low.y, -1.0, 1e-9);
    close(high.y, 3.0, 1e-9);
    close(high.x - low.x, 12.0, 1e-9);
}
