//! Streets that wind, cut along and across: lanes are a partition, and what stands along them is evenly spaced.

#[path = "common/place.rs"]
mod place;

use bosquet::check::check;
use bosquet::derive::{Limits, Options, Progress, derive};
use bosquet::element::Catalogue;
use bosquet::geometry::{Area, Polygon, overlap_area};
use bosquet::seed::Seed;
use bosquet::shape::{Extent, Shape, on_plan};
use bosquet::world::MemoryWorld;
use glam::{DVec2, DVec3};
use proptest::prelude::*;

/// The outline of a street about a line of arcs: each has a length and how much it turns (degrees).
fn street(arcs: &[(f64, f64)], width: f64) -> Polygon {
    let (mut at, mut heading, mut line) = (DVec2::ZERO, 0.0_f64, vec![(DVec2::ZERO, 0.0_f64)]);
    for (length, turn) in arcs {
        let steps = (length / 4.0).ceil();
        for _ in 0..steps as usize {
            let half = turn.to_radians() / steps * 0.5;
            heading += half;
            at += DVec2::from_angle(heading) * (length / steps);
            heading += half;
            line.push((at, heading));
        }
    }
    let side = |sign: f64| line.iter().map(move |(p, h)| *p + DVec2::from_angle(*h).perp() * (sign * width * 0.5));
    let ring: Vec<DVec2> = side(-1.0).chain(side(1.0).rev()).collect();
    Polygon::new(&ring, &[]).expect("a street")
}

/// The leaves of a rule on a street, with their symbols.
fn leaves(rules: &str, outline: Polygon) -> Vec<(String, Box<Shape>)> {
    let world = MemoryWorld::default().with("main.cga", rules);
    let (program, diagnostics) = check(&world, "main.cga");
    assert!(diagnostics.iter().all(|d| !d.is_error()), "{diagnostics:?}");
    let options = Options {
        start: None,
        seed: Seed(1),
        set: Vec::new(),
        catalogue: Catalogue::built_in(),
        world: &world,
        limits: Limits::default(),
    };
    let layout = place::layout(vec![place::region("street", outline)], Vec::new());
    let (derivation, diagnostics) = derive(&program, &layout, &options, &Progress::default());
    assert!(diagnostics.is_empty(), "{diagnostics:?}");
    let outcome = &derivation.lots[0].outcome;
    let symbol = |node: u32| derivation.symbols[outcome.nodes[node as usize].symbol as usize].to_string();
    outcome.leaves.iter().map(|leaf| (symbol(leaf.node.0), leaf.shape.clone())).collect()
}

fn areas(leaves: &[(String, Box<Shape>)]) -> Vec<Area> {
    let area = |shape: &Shape| match shape.footprint().extent {
        Extent::Area(area) => Some(area),
        _ => None,
    };
    leaves.iter().filter_map(|(_, shape)| area(shape)).collect()
}

fn middle(shape: &Shape) -> DVec2 {
    on_plan(shape.scope.frame.to_world(shape.scope.size * DVec3::new(0.5, 0.0, 0.5)))
}

/// Streets that never bend sharper than they are wide and do not come back to themselves.
fn arcs() -> impl Strategy<Value = Vec<(f64, f64)>> {
    prop::collection::vec((40.0..120.0, -70.0..70.0), 1..4)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn lanes_sum_to_the_street_and_do_not_overlap(arcs in arcs(), width in 6.0..14.0) {
        let outline = street(&arcs, width);
        let rules = "Lot --> split(v, unitSpace, 0) { 1.5 : A. | ~1 : Lane | 2 : Bays }
                     Lane --> split(v, unitSpace, 0) { ~1 : B. | ~1 : C. }
                     Bays --> split(u, unitSpace, 0) { ~7 : D. }*";
        let parts = areas(&leaves(rules, outline.clone()));
        let sum: f64 = parts.iter().map(Area::area).sum();
        prop_assert!((sum - outline.area()).abs() < 1e-3 * outline.area().sqrt(), "{sum} of {}", outline.area());
        for (index, part) in parts.iter().enumerate() {
            for other in &parts[..index] {
                let common = overlap_area(part, other);
                prop_assert!(common < 1e-3, "{common} m² twice");
            }
        }
    }

    #[test]
    fn what_stands_along_a_lane_is_evenly_spaced(arcs in arcs(), spacing in 5.0..9.0f64) {
        let rules = format!(
            "Lot --> split(v, unitSpace, 0) {{ 2 : Strip | ~1 : B. }}
             Strip --> report(\"length\", geometry.du(0, unitSpace)) split(u, unitSpace, 0) {{ ~{spacing} : Pit. }}*"
        );
        let found = leaves(&rules, street(&arcs, 10.0));
        let pits: Vec<DVec2> = found.iter().filter(|(symbol, _)| symbol == "Pit").map(|(_, s)| middle(s)).collect();
        let gaps: Vec<f64> = pits.windows(2).map(|w| w[0].distance(w[1])).collect();
        let mean = gaps.iter().sum::<f64>() / gaps.len() as f64;
        // A bay is stretched by less than half of itself over their number; a chord is shorter than its arc by a little.
        prop_assert!((mean - spacing).abs() < spacing / (gaps.len() as f64) + 0.1, "{mean} m for {spacing} m");
        for gap in &gaps {
            prop_assert!((gap - mean).abs() < 0.03 * mean, "a gap of {gap} m among some of {mean} m");
        }
    }
}

#[test]
fn a_street_of_right_angles_is_covered_too() {
    let points =
        [(0.0, 0.0), (60.0, 0.0), (60.0, 50.0), (90.0, 50.0), (90.0, 58.0), (52.0, 58.0), (52.0, 8.0), (0.0, 8.0)];
    let outline = Polygon::new(&points.map(|(x, y)| DVec2::new(x, y)), &[]).expect("a street");
    let rules = "Lot --> split(v, unitSpace, 0) { ~1 : split(u, unitSpace, 0) { ~5 : A. }* | ~1 : B. }";
    let sum: f64 = areas(&leaves(rules, outline.clone())).iter().map(Area::area).sum();
    assert!((sum - outline.area()).abs() < 0.01, "{sum} of {}", outline.area());
}
