//! The figures of Niese et al. 2022, by what their captions and Table 4 say.

use crate::planting::{EXACT, Planting, assert_apart, from_edge, kinds, mean};
use bosquet::scene::Plant;
use glam::DVec2;

const LETTERS: [&str; 12] = ["a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "l"];

#[test]
fn figure_5_keeps_the_radii_of_table_4() {
    let figure = Planting::figure("5");
    for letter in LETTERS.into_iter().filter(|letter| !["g", "h", "i"].contains(letter)) {
        let panel = figure.lot(&format!("5{letter}"));
        assert_apart(&panel, letter);
        // N(3.13, 0.35) without its lowest part, and the last gaps take small plants: about the mean all the same.
        let radius = mean(&panel, |plant| plant.spacing_radius);
        assert!((2.8..3.4).contains(&radius), "{letter}: {radius}");
    }
    assert!(figure.all().iter().all(|plant| figure.to("building", plant.position) >= 6.0 - EXACT));
}

#[test]
fn figure_5_plants_bands_as_wide_as_stated() {
    let figure = Planting::figure("5");
    for (panel, width) in [("5a", 4.0), ("5b", 10.0), ("5c", 10.0)] {
        let lot = figure.outline(panel);
        let deepest = figure.lot(panel).iter().map(|plant| from_edge(&lot, plant)).fold(0.0, f64::max);
        assert!(deepest <= width + EXACT, "{panel}: {deepest}");
        assert!(deepest > 0.8 * width, "{panel} leaves its band empty: {deepest}");
    }
}

/// Panels of one seed differ in density alone: τ is the share of the same places.
#[test]
fn figure_5_thins_by_density() {
    let figure = Planting::figure("5");
    let places = |panel: &str, of: &str| -> Vec<DVec2> {
        let corner = figure.outline(panel).outer()[0] - figure.outline(of).outer()[0];
        figure.lot(panel).iter().map(|plant| plant.position - corner).collect()
    };
    for (thin, full, share) in [("5j", "5l", 0.2), ("5k", "5l", 0.4), ("5j", "5k", 0.5), ("5c", "5b", 0.5)] {
        let (thin, full) = (places(thin, full), places(full, full));
        assert!((thin.len() as f64 - share * full.len() as f64).abs() <= 1.0, "{} of {}", thin.len(), full.len());
        let known = |p: &&DVec2| full.iter().any(|q| q.distance(**p) < 0.01);
        assert_eq!(thin.iter().filter(known).count(), thin.len(), "a thinner panel keeps places of the fuller one");
    }
}

/// With at most π centres two of any π + 1 plants share one, so they are no farther apart than 2κ.
#[test]
fn figure_5_gathers_clusters() {
    let figure = Planting::figure("5");
    for (panel, most, radius) in [("5d", 1, 10.0), ("5e", 3, 10.0), ("5f", 3, 15.0)] {
        let places: Vec<DVec2> = figure.lot(panel).iter().map(|plant| plant.position).collect();
        assert!(!has_apart(&places, most + 1, 2.0 * radius + EXACT), "{panel} needs more than {most} clusters");
    }
}

/// Whether `count` of the places are all farther apart than `distance`.
fn has_apart(places: &[DVec2], count: usize, distance: f64) -> bool {
    let far = |p: DVec2| -> Vec<DVec2> { places.iter().copied().filter(|q| q.distance(p) > distance).collect() };
    count == 0 || places.iter().any(|p| has_apart(&far(*p), count - 1, distance))
}

#[test]
fn figure_5_turns_and_jitters_a_lattice() {
    let figure = Planting::figure("5");
    // Without jitter every plant is a node of one lattice of 9 m, turned by 30° against the front.
    for (panel, jitter) in [("5g", 0.0), ("5h", 0.30), ("5i", 0.55)] {
        let lot = figure.outline(panel);
        let front = (lot.outer()[1] - lot.outer()[0]).normalize();
        let along = DVec2::from_angle(30f64.to_radians()).rotate(front);
        let origin = figure.lot("5g")[0].position - figure.outline("5g").outer()[0] + lot.outer()[0];
        for plant in figure.lot(panel) {
            let off = plant.position - origin;
            let cell = DVec2::new(along.dot(off), along.perp_dot(off)) / 9.0;
            let moved = (cell - cell.round()).abs().max_element() * 9.0;
            assert!(moved <= jitter * 4.5 + EXACT, "{panel}: {moved} m off the lattice");
        }
    }
}

#[test]
fn figure_7_keeps_the_envelope_free() {
    let figure = Planting::figure("7");
    let nearest = |garden: &str, kind: &str| {
        let plants = figure.lot(garden);
        plants.iter().map(|plant| figure.to(kind, plant.position)).fold(f64::INFINITY, f64::min)
    };
    assert!(nearest("garden a", "building") >= 6.0 - EXACT);
    assert!(nearest("garden a", "driveway") >= 1.5 - EXACT);
    assert!(nearest("garden a", "door") >= 9.0 - EXACT && nearest("garden a", "window") >= 9.0 - EXACT);
    assert!(nearest("garden b", "building") < 2.0 && nearest("garden b", "driveway") < 1.5);
    let inside = figure.all().iter().filter(|plant| figure.to("building", plant.position) <= 0.0);
    assert_eq!(inside.count(), 0, "nothing grows in a house, with or without an envelope");
}

#[test]
fn figure_8_varies_age_kind_and_species() {
    let figure = Planting::figure("8");
    let panel = |letter: &str| figure.lot(&format!("8{letter}"));
    let oldest = |letter| panel(letter).iter().map(|plant| plant.age).fold(0.0, f64::max);
    assert!(oldest("a") <= 4.0 && oldest("b") <= 12.0 && oldest("c") <= 80.0);
    let crown = |letter| mean(&panel(letter), |plant| plant.crown_radius);
    assert!(crown("a") < crown("b") && crown("b") < crown("c"));
    let trees = |letter| mean(&panel(letter), |plant| f64::from(u8::from(&*plant.kind == "tree")));
    assert_eq!(trees("d"), 0.0);
    assert!((trees("e") - 0.5).abs() < 0.15 && trees("f") > 0.75, "{} {}", trees("e"), trees("f"));
    let species = |letter| kinds(&panel(letter), |plant| &plant.species);
    assert_eq!(species("g"), 1);
    assert!((2..=3).contains(&species("h")) && (4..=6).contains(&species("i")), "{} {}", species("h"), species("i"));
}

/// The mean radius and how it varies jump in the upper row and change gradually in the lower one (§5.5).
#[test]
fn figure_9_smooths_what_jumps() {
    let figure = Planting::figure("9");
    let row = |row: &str| -> Vec<f64> {
        let lots = (1..=6).map(|lot| figure.lot(&format!("{row} {lot}")));
        lots.map(|plants: Vec<Plant>| mean(&plants, |plant| plant.spacing_radius)).collect()
    };
    let steps = |row: &[f64]| row.windows(2).map(|w| w[1] - w[0]).fold(0.0, f64::max);
    let (own, blended) = (row("own"), row("blended"));
    assert!(own[..3].iter().all(|radius| (radius - 2.2).abs() < EXACT), "{own:?}");
    assert!(steps(&own) > 1.4 && steps(&blended) < 0.6 * steps(&own), "{own:?} {blended:?}");
    assert!(blended[0] > 2.2 && blended[5] > blended[0] + 0.8, "{blended:?}");
}

/// The larger the building, the fewer plants, and the nearer to the edge of the lot.
#[test]
fn figure_15_lines_up_along_the_edge() {
    let figure = Planting::figure("15");
    let states: Vec<(String, Vec<Plant>)> =
        (1..=5).map(|state| format!("state {state}")).map(|id| (id.clone(), figure.lot(&id))).collect();
    let counts: Vec<usize> = states.iter().map(|(_, plants)| plants.len()).collect();
    assert!(counts.is_sorted_by(|one, next| one > next), "{counts:?}");
    let depth = |(id, plants): &(String, Vec<Plant>)| {
        let lot = figure.outline(id);
        mean(plants, |plant| from_edge(&lot, plant))
    };
    let depths: Vec<f64> = states.iter().map(depth).collect();
    assert!(depths.is_sorted_by(|one, next| one > next), "{depths:?}");
    states.iter().for_each(|(id, plants)| assert_apart(plants, id));
}
