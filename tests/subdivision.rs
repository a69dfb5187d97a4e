//! What users rely on when a shape is divided, whatever its outline: parts sum to the whole and lie inside, areas are
//! met, rectangles fit and cannot grow, sets partition.

#[path = "common/place.rs"]
mod place;
#[path = "common/polygons.rs"]
mod polygons;

use bosquet::check::check;
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::geometry::{
    Area, Bounds, Polygon, Sweep, convexify, difference, inner_rectangle, rectified, set_in, setback,
};
use bosquet::seed::Seed;
use bosquet::shape::{Extent, LeafOf, Outcome};
use bosquet::world::MemoryWorld;
use glam::DVec2;
use proptest::prelude::*;

fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

/// A lot of that outline, derived.
fn outcome(rules: &str, polygon: &Polygon) -> Outcome {
    let (program, diagnostics) = check(&MemoryWorld::default().with("main.cga", rules), "main.cga");
    assert!(!diagnostics.iter().any(Diagnostic::is_error), "{rules}: {diagnostics:?}");
    let statements: Vec<String> = polygon.rings().zip(["polygon", "hole", "hole", "hole"]).map(statement).collect();
    let layout = place::parse(&statements.iter().map(String::as_str).collect::<Vec<_>>()).expect("a layout");
    let (world, limits) = (MemoryWorld::default(), Limits { children: 2_000, ..Limits::default() });
    let catalogue = Catalogue::built_in();
    let options = Options { start: None, seed: Seed(3), set: Vec::new(), catalogue, world: &world, limits };
    let (mut derivation, _) = derive(&program, &layout, &options, &Progress::default());
    derivation.lots.remove(0).outcome
}

/// A ring as the words of a layout.
fn statement((ring, word): (&[DVec2], &str)) -> String {
    let corners: String = ring.iter().map(|p| format!(" {},{}", p.x, p.y)).collect();
    format!("{word}{corners}")
}

fn area_of(leaf: &LeafOf) -> f64 {
    leaf.shape.measure().area
}

/// A part on the plan; strips too thin for it have no area.
fn on_plan(leaf: &LeafOf) -> Area {
    match leaf.shape.footprint().extent {
        Extent::Area(area) => area,
        _ => Area::empty(),
    }
}

fn any_polygon() -> impl Strategy<Value = Polygon> {
    let anywhere = polygons::area().prop_map(|area| area.polygons()[0].clone());
    prop_oneof![polygons::polygon(), polygons::convex(), anywhere]
}

/// Every way to take a flat shape apart.
const DIVISIONS: &[&str] = &[
    "Lot --> setback(1.2) { scope.sx > 4 =: A. | all : B. | remainder : C. }",
    "Lot --> setbackPerEdge(0.2 + rand(1.5)) { all : A. | remainder =: B. }",
    "Lot --> setbackPerEdge(scope.sx * 0.1) { border = A. | inside =: B. | remainder = C. }",
    "Lot --> setbackToArea('0.6) { all : A. | remainder : B. }",
    "Lot --> splitAndSetbackPerimeter('0.13) { ~5 : 1.1 : A. | 3 : 0.6 : B. | 1.5 : 0 : NIL }* { remainder : C. }",
    "Lot --> splitAndSetbackPerimeter(2.5, -1) { 9 : 2 : A. | '0.2 : 0.7 : B. } { remainder = C. }",
    "Lot --> shapeL(2, 1.4) { shape : A. | remainder : B. }",
    "Lot --> shapeU(1, 0.5, 2) { shape =: A. | remainder = B. }",
    "Lot --> shapeO(1, 1, 0, 2) { shape = A. | remainder : B. }",
    "Lot --> innerRectangle(scope) { shape : A. | remainder : B. }",
    "Lot --> innerRectangle(edge) { shape = A. | remainder = B. }",
    "Lot --> splitArea(x) { 10 : A. | '0.3 : B. | ~1 : C. | ~2 : D. }",
    "Lot --> splitArea(z, noAdjust) { ~15 : A. }*",
    "Lot --> convexify comp(f) { all : A. }",
    "Lot --> mirror(true, false, true) comp(f) { all =: A. }",
];

proptest! {
    #![proptest_config(cases(40))]

    #[test]
    fn parts_sum_to_the_whole_and_do_not_overlap(polygon in any_polygon(), division in 0..DIVISIONS.len()) {
        let rules = DIVISIONS[division];
        let outcome = outcome(rules, &polygon);
        let leaves: Vec<&LeafOf> = outcome.leaves.iter().collect();
        let sum: f64 = leaves.iter().map(|leaf| area_of(leaf)).sum();
        let slack = 1e-6 * polygon.area() + 1e-5 * leaves.len() as f64;
        prop_assert!((sum - polygon.area()).abs() < slack, "{rules}: {sum} of {}", polygon.area());
        if !rules.contains("mirror") {
            // What sums to the whole and lies inside cannot overlap.
            for leaf in leaves {
                let outside = difference(&on_plan(leaf), &polygon.clone().into()).area();
                prop_assert!(outside < 1e-5 * polygon.perimeter(), "{rules}: {outside} m² lie outside");
            }
        }
    }

    #[test]
    fn areas_are_met(polygon in any_polygon(), share in 0.05..0.95f64) {
        let whole = polygon.area();
        let left = outcome(&format!("Lot --> setbackToArea({}) {{ all = NIL | remainder = A. }}", share * whole), &polygon);
        let found: f64 = left.leaves.iter().map(area_of).sum();
        let slack = if polygon.is_convex() { 1e-6 } else { 1e-5 * polygon.perimeter() };
        prop_assert!((found - share * whole).abs() < slack, "{found} instead of {}", share * whole);
        let cut = outcome(&format!("Lot --> splitArea(x) {{ '{share} : A. | ~1 : NIL }}"), &polygon);
        let found: f64 = cut.leaves.iter().map(area_of).sum();
        prop_assert!((found - share * whole).abs() < 1e-9 * whole, "{found} instead of {}", share * whole);
    }

    #[test]
    fn a_sweep_finds_where_an_area_lies(polygon in any_polygon(), share in 0.0..1.0f64, degrees in 0.0..360.0f64) {
        let (sin, cos) = libm::sincos(degrees.to_radians());
        let along = DVec2::new(cos, sin);
        let sweep = Sweep::new(&polygon.clone().into(), along);
        prop_assert!((sweep.area() - polygon.area()).abs() < 1e-9 * polygon.area());
        let place = sweep.place(share * polygon.area());
        let before = bosquet::geometry::band(&polygon.clone().into(), along, f64::NEG_INFINITY, place).area();
        prop_assert!((before - share * polygon.area()).abs() < 1e-8 * polygon.area(), "{before}");
    }

    #[test]
    fn rectangles_fit_and_cannot_grow(polygon in any_polygon()) {
        let Some(found) = inner_rectangle(&polygon) else { return Err(TestCaseError::fail("none was found")) };
        prop_assert!(outside(found, &polygon) < 1e-6, "{found:?} reaches out by {} m²", outside(found, &polygon));
        let step = 1e-3;
        let sides = [
            Bounds { min: found.min - DVec2::new(step, 0.0), ..found },
            Bounds { min: found.min - DVec2::new(0.0, step), ..found },
            Bounds { max: found.max + DVec2::new(step, 0.0), ..found },
            Bounds { max: found.max + DVec2::new(0.0, step), ..found },
        ];
        for wider in sides {
            prop_assert!(outside(wider, &polygon) > 0.0, "{found:?} could be {wider:?}");
        }
    }

    #[test]
    fn no_rectangle_of_a_lattice_is_larger(polygon in any_polygon(), x in 0.0..1.0f64, y in 0.0..1.0f64) {
        let best = inner_rectangle(&polygon).map_or(0.0, |found| found.size().element_product());
        let (bounds, count) = (polygon.bounds(), 12);
        let at = |i: usize, j: usize| bounds.min + bounds.size() * (DVec2::new(i as f64 + x, j as f64 + y) / count as f64);
        let inside: Vec<Vec<bool>> = (0..count).map(|i| (0..count).map(|j| polygon.contains(at(i, j))).collect()).collect();
        for (i, j) in (0..count * count).map(|n| (n / count, n % count)).filter(|(i, j)| inside[*i][*j]) {
            for (k, l) in (0..count * count).map(|n| (n / count, n % count)).filter(|(k, l)| *k > i && *l > j) {
                let tried = Bounds { min: at(i, j), max: at(k, l) };
                let area = tried.size().element_product();
                if inside[k][l] && area > best {
                    let slack = 2e-3 * tried.size().element_sum();
                    prop_assert!(area < best + slack || outside(tried, &polygon) > 1e-9, "{tried:?} is larger than {best}");
                }
            }
        }
    }

    #[test]
    fn convex_parts_are_convex(polygon in polygons::polygon()) {
        let parts = convexify(&polygon, f64::INFINITY);
        for part in parts.polygons() {
            part.sanity_check().unwrap();
            let hull = part.hull().area();
            prop_assert!(!part.has_holes() && hull - part.area() < 1e-6 * hull + 1e-6, "{} of {hull}", part.area());
        }
    }

    #[test]
    fn what_is_left_is_left_with_and_without_strips(polygon in any_polygon(), distance in 0.1..4.0f64) {
        let by_edge = |edge: usize| if edge.is_multiple_of(3) { 0.0 } else { distance * (1.0 + edge as f64 * 0.1) };
        let (with, without) = (setback(&polygon, by_edge).remainder.area(), set_in(&polygon, by_edge).area());
        prop_assert!((with - without).abs() < 1e-9 * polygon.area(), "{with} and {without}");
    }

    #[test]
    fn rectifying_finds_the_rectangle_again(width in 5.0..40.0f64, depth in 5.0..40.0f64, shifts in prop::array::uniform8(-0.2..0.2f64)) {
        let corners = [DVec2::ZERO, DVec2::new(width, 0.0), DVec2::new(width, depth), DVec2::new(0.0, depth)];
        let moved = |i: usize| corners[i] + DVec2::new(shifts[2 * i], shifts[2 * i + 1]);
        let polygon = Polygon::new(&[moved(0), moved(1), moved(2), moved(3)], &[]).unwrap();
        let straight = rectified(&polygon.into(), 10f64.to_radians());
        prop_assert!(straight.polygons()[0].is_rectangle(1e-6), "{straight:?}");
    }

    #[test]
    fn sets_that_hang_together_partition_the_faces(polygon in polygons::polygon(), height in 1.0..9.0f64) {
        let rules = format!("Lot --> extrude({height}) comp(f) {{ scope.sx > 5 =: A. | all =: B. }}");
        let solid = outcome(&rules, &polygon);
        let surface = 2.0 * polygon.area() + polygon.perimeter() * height;
        let sum: f64 = solid.leaves.iter().map(area_of).sum();
        prop_assert!((sum - surface).abs() < 1e-6 * surface, "{sum} of {surface}");
        let faces: usize = solid.leaves.iter().map(|leaf| leaf.shape.measure().faces).sum();
        prop_assert_eq!(faces, polygon.points().len() + 2);
    }

    /// Whatever the numbers: a message or a result, no panic.
    #[test]
    fn odd_numbers_are_survived(polygon in any_polygon(), division in 0..ODD.len(), number in odd_number()) {
        let rules = ODD[division].replace('?', &number);
        let (_, diagnostics) = check(&MemoryWorld::default().with("main.cga", rules.as_str()), "main.cga");
        if !diagnostics.iter().any(Diagnostic::is_error) {
            outcome(&rules, &polygon);
        }
    }
}

/// Operations with a number to be filled in.
const ODD: &[&str] = &[
    "Lot --> setback(?) { all : A. | remainder : B. }",
    "Lot --> setbackPerEdge(?) { all : A. | remainder : B. }",
    "Lot --> setbackToArea(?) { all = A. | remainder = B. }",
    "Lot --> splitAndSetbackPerimeter(?) { ~5 : 1 : A. }* { remainder : B. }",
    "Lot --> splitAndSetbackPerimeter(0, ?) { ~5 : ? : A. | ? : 2 : B. } { remainder : C. }",
    "Lot --> shapeO(?, 1, ?, 2) { shape : A. | remainder : B. }",
    "Lot --> splitArea(z) { ? : A. | ~? : B. | '? : C. }",
    "Lot --> convexify(?) A.",
    "Lot --> cleanupGeometry(all, ?) A.",
    "Lot --> extrude(3) comp(f) { all = S } S --> cleanupGeometry(all, ?) A.",
    "Lot --> rectify(?) A.",
];

fn odd_number() -> impl Strategy<Value = String> {
    let any = (-1e3..1e3f64).prop_map(|number| format!("({number})"));
    prop_oneof![
        any,
        prop::sample::select(vec!["0", "(-1)", "1e-9", "1e300", "(0/0)", "(1/0)", "(-1/0)", "0.5"])
            .prop_map(String::from)
    ]
}

/// How much of a rectangle lies outside, m².
fn outside(found: Bounds, polygon: &Polygon) -> f64 {
    let rectangle: Area = Polygon::rectangle(found.min, found.max).into_iter().collect();
    difference(&rectangle, &polygon.clone().into()).area()
}
