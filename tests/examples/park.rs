//! Central Park: its measures, and the two plantings of Niese et al. 2022, figure 21.

use crate::planting::{EXACT, Planting, outside};
use bosquet::geometry::Polygon;
use std::sync::LazyLock;

static ONE: LazyLock<Planting> = LazyLock::new(|| Planting::of("central-park", "one.geojson", "bosquet.toml"));
static MANY: LazyLock<Planting> = LazyLock::new(|| Planting::of("central-park", "many.geojson", "many.toml"));

/// Hectares, as the park's conservancy publishes them in acres: 843, 106, 18, 11, 15 and 55 with its surroundings.
#[test]
fn the_park_and_its_waters_are_of_their_true_size() {
    let measures = [("park", 341.2), ("The Reservoir", 42.9), ("The Lake", 7.3), ("Harlem Meer", 4.5)];
    for (id, hectares) in measures.into_iter().chain([("Sheep Meadow", 6.07)]) {
        let found = ONE.outline(id).area() / 1e4;
        assert!((found / hectares - 1.0).abs() < 0.01, "{id}: {found} ha instead of {hectares}");
    }
    let lots: f64 = MANY.outlines("lot").iter().map(Polygon::area).sum();
    assert!((lots / ONE.outline("park").area() - 1.0).abs() < 1e-3, "the lots are the park");
}

#[test]
fn one_lot_has_54_000_plants_and_many_have_16_000() {
    for (park, wanted) in [(&ONE, 54_000.0), (&MANY, 16_000.0)] {
        let found = park.all().len() as f64;
        assert!((found / wanted - 1.0).abs() < 0.03, "{found} instead of {wanted}");
    }
}

#[test]
fn waters_meadows_and_paving_stay_free() {
    for park in [&*ONE, &*MANY] {
        let open: Vec<Polygon> = park.outlines("meadow").into_iter().chain(park.outlines("water")).collect();
        // Every seventh plant will do: they are in no order of place.
        for plant in park.all().iter().step_by(7) {
            let p = plant.position;
            assert!(open.iter().all(|polygon| !polygon.bounds().contains(p) || outside(polygon, p) > 0.0), "{p}");
            assert!(park.to("street", p) >= 1.5 - EXACT && park.to("footway", p) >= 1.5 - EXACT, "{p} on a path");
        }
    }
}
