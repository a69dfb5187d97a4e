//! Figure 16 and the task of the expert users (§8.2) of Niese et al. 2022.

use crate::planting::{EXACT, Planting, assert_apart, from_edge, outside};
use bosquet::scene::Plant;
use glam::DVec2;

#[test]
fn figure_16_plants_a_street_every_13_metres() {
    let figure = Planting::figure("16");
    let strip = figure.outline("16j");
    let mut row = figure.lot("16j");
    row.sort_by(|one, other| one.position.x.total_cmp(&other.position.x));
    assert!(row.len() >= 6, "{} trees", row.len());
    for pair in row.windows(2) {
        // Measured along the axis, which bends: the chord is a little shorter.
        let chord = pair[0].position.distance(pair[1].position);
        assert!((12.7..=13.0 + EXACT).contains(&chord), "{chord}");
    }
    assert!(row.iter().all(|tree| (from_edge(&strip, tree) - 2.6).abs() < 0.1), "off the middle of the strip");
}

#[test]
fn figure_16_keeps_buildings_drives_and_water_free() {
    let figure = Planting::figure("16");
    for plant in figure.all() {
        let to = |kind| figure.to(kind, plant.position);
        for (kind, distance) in [("building", 6.0), ("driveway", 1.5), ("footway", 1.5), ("street", 1.5)] {
            assert!(to(kind) >= distance - EXACT, "{} m from a {kind} in {}", to(kind), plant.origin.lot);
        }
        assert!(to("water") > 0.0, "a plant in the pond, at {}", plant.position);
    }
}

#[test]
fn the_expert_task_meets_its_five_demands() {
    let task = Planting::of("expert-task", "expert-task.geojson", "bosquet.toml");
    let lot = task.outline("lot");
    assert!(task.all().iter().all(|plant| task.to("building", plant.position) >= 6.0 - EXACT), "1: off the buildings");

    let border = task.by_rule("BorderTree");
    assert!(border.iter().all(|tree| (from_edge(&lot, tree) - 4.0).abs() < 0.01), "2: the row is in the band's middle");
    let gaps: Vec<f64> = border.iter().map(|tree| nearest(&border, tree)).collect();
    assert!(gaps.iter().all(|gap| (gap - 8.0).abs() < 1.0), "2: consistent space: {gaps:?}");

    let loose = task.by_rule("LooseTree");
    assert_apart(&loose, "3");
    let middle = 0.5 * (lot.bounds().min.x + lot.bounds().max.x);
    let (left, right): (Vec<&Plant>, Vec<&Plant>) = loose.iter().partition(|tree| tree.position.x < middle);
    assert!(right.len() > 2 * left.len() && left.len() > 1, "3: {} and {}", left.len(), right.len());

    let orchard = task.by_rule("OrchardTree");
    let cells = orchard.iter().map(|tree| (tree.position - orchard[0].position) / 8.0);
    assert!(cells.clone().all(|cell| (cell - cell.round()).abs().max_element() < 1e-3), "4: on a lattice of 8 m");
    assert!(orchard.len() > 8, "4: {}", orchard.len());

    let groups = groups(&task.by_rule("GroupTree"));
    assert!((2..=3).contains(&groups.len()), "5: {} clusters", groups.len());
    assert!(groups.iter().all(|group| spread(group) <= 16.0 + EXACT), "5: clusters of 8 m");
    assert!(task.all().iter().all(|plant| outside(&lot, plant.position) == 0.0), "all stand in the lot");
}

fn nearest(among: &[Plant], tree: &Plant) -> f64 {
    let others = among.iter().map(|other| other.position.distance(tree.position)).filter(|distance| *distance > 0.0);
    others.fold(f64::INFINITY, f64::min)
}

/// Places that hang together by steps of less than 7 m.
fn groups(plants: &[Plant]) -> Vec<Vec<DVec2>> {
    let mut groups: Vec<Vec<DVec2>> = Vec::new();
    for place in plants.iter().map(|plant| plant.position) {
        let is_near = |group: &Vec<DVec2>| group.iter().any(|p| p.distance(place) < 7.0);
        let (near, far): (Vec<_>, Vec<_>) = groups.into_iter().partition(is_near);
        groups = far;
        groups.push(near.into_iter().flatten().chain([place]).collect());
    }
    groups
}

fn spread(group: &[DVec2]) -> f64 {
    group.iter().flat_map(|p| group.iter().map(|q| p.distance(*q))).fold(0.0, f64::max)
}
