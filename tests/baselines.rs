//! The baselines of the pattern library: what they promise to whoever compares a strategy with them.

#[path = "common/patterns.rs"]
mod patterns;
#[path = "common/place.rs"]
mod place;

use bosquet::layout::Layout;
use bosquet::seed::Seed;
use glam::DVec2;

const RANDOM: &str = "patterns/baseline-random.cga";
const BENES: &str = "patterns/baseline-benes.cga";

/// Where the rules of a file plant.
fn planted(main: &str, file: &str, layout: &Layout, seed: u64) -> Vec<DVec2> {
    let plants = patterns::plants(&patterns::world(main), file, layout, Seed(seed));
    plants.iter().map(|plant| plant.position).collect()
}

/// A lot with a house over half of it.
fn yard(lot: &str) -> Layout {
    place::parse(&[lot, "feature building 10,5 50,5 50,25 10,25"]).expect("a layout")
}

fn is_in_the_house(p: &DVec2) -> bool {
    (10.0..=50.0).contains(&p.x) && (5.0..=25.0).contains(&p.y)
}

#[test]
fn chance_draws_every_lot_anew_and_the_same_again() {
    let squares: Vec<String> = (0..24).map(|i| format!("rect 40 40 {} 0", i * 50)).collect();
    let layout = place::parse(&squares.iter().map(String::as_str).collect::<Vec<_>>()).expect("a layout");
    let main = r#"
        import chance : "patterns/baseline-random.cga" (Plant --> NIL)
        attr strategy = 0
        Lot --> chance.Lot
    "#;
    assert!(planted(main, "main.cga", &layout, 1).is_empty(), "`Plant` is not replaced");
    let all = planted("", RANDOM, &layout, 1);
    let mut counts: Vec<usize> =
        (0..24).map(|i| all.iter().filter(|p| (p.x / 50.0).floor() == f64::from(i)).count()).collect();
    assert_eq!(all, planted("", RANDOM, &layout, 1));
    counts.sort_unstable();
    counts.dedup();
    assert!(counts.len() > 8, "24 equal lots have only {counts:?} plants");
}

#[test]
fn chance_plants_in_houses_and_what_is_given_is_not_drawn() {
    let layout = yard("rect 60 30");
    let main = r#"
        import chance : "patterns/baseline-random.cga"
        attr strategy = 0
        attr radius = 1
        attr radius_sd = 0
        attr density = 1
        @StartRule
        Lot --> chance.Planting
    "#;
    let all = planted(main, "main.cga", &layout, 1);
    // Random disks of one metre that touch no other cover 55 % of the ground at saturation, edges aside.
    assert!((280..400).contains(&all.len()), "{} plants", all.len());
    let house = all.iter().filter(|p| is_in_the_house(p)).count() as f64 / all.len() as f64;
    assert!((house - 800.0 / 1800.0).abs() < 0.06, "{house} of the plants stand in the house");
}

#[test]
fn each_strategy_plants_in_its_own_way() {
    let layout = place::parse(&["rect 60 30"]).expect("a layout");
    let way = |strategy: usize| {
        let main = format!(
            "import chance : \"patterns/baseline-random.cga\" (\n\
             strategy = {strategy}, radius = 2, density = 1, width = 3, clusters = 5, cell = 9, spacing = 6)\n\
             Lot --> chance.Planting"
        );
        planted(&main, "main.cga", &layout, 1)
    };
    let ways: Vec<Vec<DVec2>> = (0..6).map(way).collect();
    let rim = |p: &DVec2| p.min(DVec2::new(60.0, 30.0) - *p).min_element();
    let middle = |p: &DVec2| (p.y - 15.0).abs();
    assert!(ways[0].len() > 60 && ways[0].iter().any(|p| rim(p) > 10.0), "semi-random fills the lot");
    assert!(ways[1].len() > 20 && ways[1].iter().all(|p| rim(p) <= 3.0 + 1e-6), "boundary keeps to the band");
    assert!(ways[2].len() < ways[0].len(), "clusters leave room");
    assert_eq!(ways[3].len(), 1, "a single one");
    assert!((15..35).contains(&ways[4].len()), "a cell has 81 m² of 1,800 m²");
    assert!(ways[5].len() >= 4 && ways[5].iter().all(|p| middle(p) < 0.01), "equidistant keeps to the middle");
}

#[test]
fn rows_follow_the_longer_side_and_stay_in_the_lot() {
    for (lot, along) in [("rect 90 30", DVec2::X), ("rect 30 90", DVec2::Y)] {
        let layout = place::parse(&[lot]).expect("a layout");
        let all = planted("", BENES, &layout, 1);
        let size = if along == DVec2::X { DVec2::new(90.0, 30.0) } else { DVec2::new(30.0, 90.0) };
        assert!(all.iter().all(|p| p.cmpge(DVec2::ZERO).all() && p.cmple(size).all()), "{all:?}");
        // 28 m between the outer rows, 12 m from row to row: three; 88 m at 8 m: twelve in each.
        assert_eq!(all.len(), 36);
        let nearest = |p: &DVec2| {
            let others = all.iter().filter(|other| *other != p);
            others.map(|other| (*other - *p).abs()).min_by(|a, b| a.length().total_cmp(&b.length())).expect("another")
        };
        let in_rows = all.iter().filter(|p| nearest(p).dot(along) > 5.9).count();
        assert_eq!(in_rows, 36, "the nearest plant stands in the same row");
    }
}

#[test]
fn blocks_with_a_house_get_a_row_before_one_behind_and_what_the_axis_has_left() {
    let all = planted("", BENES, &yard("rect 60 30"), 1);
    assert!(!all.iter().any(is_in_the_house));
    // Places along the axis would be eight; the house leaves those at its two ends.
    let rows = [0.0..3.0, 12.0..18.0, 27.0..30.0].map(|row| all.iter().filter(|p| row.contains(&p.y)).count());
    assert_eq!(rows, [8, 2, 8]);
    assert_eq!(all.len(), 18);
}
