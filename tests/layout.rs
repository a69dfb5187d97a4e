//! What people rely on when they hand in a layout: true metres, every feature used or named, who sees whom.

use bosquet::diag::{Diagnostic, Severity};
use bosquet::layout::{Crs, Kind, Layout, Region, Shapes, read_geojson};
use bosquet::value::{Array, Cells, Value};
use glam::DVec2;
use proptest::prelude::*;
use serde_json::{Value as Json, json};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

fn read(json: &Json) -> (Layout, Vec<Diagnostic>) {
    let (layout, diagnostics) = read_geojson("plan.geojson", json.to_string().as_bytes());
    sanity_check(&layout);
    (layout, diagnostics)
}

fn local(features: Vec<Json>) -> Json {
    json!({"type": "FeatureCollection", "crs": "local", "features": features})
}

fn feature(id: &str, properties: Json, geometry: Json) -> Json {
    json!({"type": "Feature", "id": id, "properties": properties, "geometry": geometry})
}

/// A square with its lower left corner at `x, y`.
fn square(x: f64, y: f64, side: f64) -> Json {
    json!({"type": "Polygon", "coordinates": [[[x, y], [x + side, y], [x + side, y + side], [x, y + side], [x, y]]]})
}

fn region<'a>(layout: &'a Layout, id: &str) -> &'a Region {
    layout.regions.iter().find(|r| &*r.id == id).unwrap_or_else(|| panic!("no region `{id}`"))
}

fn seen<'a>(layout: &'a Layout, region: &Region) -> Vec<&'a str> {
    region.features.iter().map(|f| &*layout.features[*f].id).collect()
}

fn of<'a>(diagnostics: &'a [Diagnostic], code: &str) -> Vec<&'a Diagnostic> {
    diagnostics.iter().filter(|d| d.code == code).collect()
}

/// What holds for every layout.
fn sanity_check(layout: &Layout) {
    let ids: BTreeSet<_> = layout.regions.iter().map(|r| &r.id).collect();
    assert_eq!(ids.len(), layout.regions.len(), "region ids are unique");
    let ids: BTreeSet<_> = layout.features.iter().map(|f| &f.id).collect();
    assert_eq!(ids.len(), layout.features.len(), "feature ids are unique");
    for (index, region) in layout.regions.iter().enumerate() {
        assert!(region.polygon.area() > 0.0 && region.polygon.points().iter().all(|p| p.is_finite()));
        assert!(region.features.is_sorted() && region.features.iter().all(|f| *f < layout.features.len()));
        assert!(region.neighbours.is_sorted());
        for other in &region.neighbours {
            assert!(layout.regions[*other].neighbours.contains(&index), "neighbours see each other");
        }
    }
}

#[test]
fn versailles_has_its_real_dimensions() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/versailles");
    let bytes = std::fs::read(root.join("versailles.geojson")).expect("the example is part of the project");
    let (layout, diagnostics) = read_geojson("versailles.geojson", &bytes);
    sanity_check(&layout);
    assert_eq!(diagnostics, []);
    let lawn = region(&layout, "tapis-vert");
    assert!((lawn.polygon.area() - 335.0 * 40.0).abs() < 20.0, "{}", lawn.polygon.area());
    let canal = region(&layout, "grand-canal").polygon.area() / 1e4;
    assert!((22.0..24.0).contains(&canal), "{canal} ha");
    assert_eq!(layout.regions.iter().filter(|r| r.kind == Kind::Other("bosquet".into())).count(), 16);
    assert!(seen(&layout, region(&layout, "petit-bois-canal")).contains(&"grand-canal"));
    assert_eq!(region(&layout, "petit-bois-canal").start.as_deref(), Some("Versailles"));
    let centre = |id: &str| region(&layout, id).polygon.bounds().centre();
    let bearing = |from: &str, to: &str| {
        let way = centre(to) - centre(from);
        (libm::atan2(way.x, way.y).to_degrees().rem_euclid(360.0), way.length())
    };
    let (azimuth, length) = bearing("bassin-de-latone", "bassin-d-apollon");
    assert!((azimuth - 292.75).abs() < 0.1 && (length - 550.0).abs() < 0.5, "{azimuth} {length}");
    let (azimuth, _) = bearing("bassin-de-l-orangerie", "bassin-du-dragon");
    assert!((azimuth - 22.75).abs() < 0.1, "the plan is not mirrored: {azimuth}");
}

#[test]
fn the_other_examples_are_clean() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/versailles/elsewhere");
    for (name, id, hectares) in [("square.geojson", "square", 6.9357), ("island.geojson", "island", 16.0588)] {
        let bytes = std::fs::read(root.join(name)).expect("the example is part of the project");
        let (layout, diagnostics) = read_geojson(name, &bytes);
        sanity_check(&layout);
        assert_eq!(diagnostics, [], "{name}");
        let area = region(&layout, id).polygon.area() / 1e4;
        assert!((area - hectares).abs() < 1e-4, "{name}: {area} ha");
    }
}

#[test]
fn a_lot_sees_what_lies_in_it_and_who_lives_next_door() {
    let (layout, diagnostics) = read(&local(vec![
        feature("a", json!({"kind": "lot"}), square(0.0, 0.0, 20.0)),
        feature("b", json!({"kind": "lot"}), square(20.3, 0.0, 20.0)),
        feature("c", json!({"kind": "lot"}), square(60.0, 0.0, 20.0)),
        feature("house", json!({"kind": "building", "height": "7.5 m"}), square(5.0, 5.0, 8.0)),
        feature("gate", json!({"kind": "entrance"}), json!({"type": "Point", "coordinates": [10.0, -0.4]})),
        feature(
            "tree",
            json!({"kind": "tree", "species": "tilia"}),
            json!({"type": "Point", "coordinates": [22.0, 5.0]}),
        ),
        feature(
            "road",
            json!({"kind": "street", "width": 6}),
            json!({"type": "LineString", "coordinates": [[-9, -3.2], [50, -3.2]]}),
        ),
    ]));
    assert_eq!(diagnostics, []);
    assert_eq!(seen(&layout, region(&layout, "a")), ["house", "gate", "road"]);
    assert_eq!(seen(&layout, region(&layout, "b")), ["tree", "road"]);
    assert_eq!(seen(&layout, region(&layout, "c")), Vec::<&str>::new());
    let ids = |r: &Region| r.neighbours.iter().map(|n| &*layout.regions[*n].id).collect::<Vec<_>>();
    assert_eq!(ids(region(&layout, "a")), ["b", "road"]);
    assert_eq!(ids(region(&layout, "c")), Vec::<&str>::new());
    assert_eq!(layout.features[0].height, 7.5);
    assert!((region(&layout, "road").polygon.area() - 59.0 * 6.0).abs() < 1e-6, "a line with a width has an area");
    assert!(!seen(&layout, region(&layout, "road")).contains(&"road"), "nobody sees himself");
    assert_eq!(layout.features[1].kind, Kind::Marker("entrance".into()));
}

#[test]
fn a_hole_is_outside() {
    let ring = |low: f64, high: f64| json!([[low, low], [high, low], [high, high], [low, high], [low, low]]);
    let (layout, _) = read(&local(vec![
        feature(
            "park",
            json!({"kind": "region"}),
            json!({"type": "Polygon", "coordinates": [ring(0.0, 90.0), ring(20.0, 70.0)]}),
        ),
        feature("island", json!({"kind": "region"}), square(40.0, 40.0, 10.0)),
        feature("hut", json!({"kind": "building"}), square(42.0, 42.0, 4.0)),
    ]));
    let park = region(&layout, "park");
    assert_eq!(park.polygon.area(), 90.0 * 90.0 - 50.0 * 50.0);
    assert!(park.features.is_empty() && park.neighbours.is_empty());
    assert_eq!(seen(&layout, region(&layout, "island")), ["hut"]);
}

#[test]
fn properties_become_attributes_and_facts() {
    let properties = json!({
        "kind": "lot", "name": "Rose cottage", "zone": "residential", "start": "Garden", "seed": 41, "elevation": 12.5,
        "income": 3.5, "corner": true, "owner": "A. N.", "nothing": null, "tags": ["a"], "mixed": ["a", 1],
        "more": {"b": 1}
    });
    let (layout, diagnostics) = read(&local(vec![feature("7", properties, square(0.0, 0.0, 9.0))]));
    let lot = &layout.regions[0];
    assert_eq!(
        (&*lot.id, &*lot.name, &*lot.zone, lot.start.as_deref()),
        ("7", "Rose cottage", "residential", Some("Garden"))
    );
    assert_eq!((lot.seed, lot.elevation), (Some(41), 12.5));
    assert_eq!(lot.attributes.get("income"), Some(&Value::Float(3.5)));
    assert_eq!(lot.attributes.get("corner"), Some(&Value::Bool(true)));
    assert_eq!(lot.attributes.get("owner"), Some(&Value::text("A. N.")));
    assert_eq!(lot.attributes.get("nothing"), None);
    let tags = Array::row(Cells::Texts(vec!["a".into()]));
    assert_eq!(lot.attributes.get("tags"), Some(&Value::Array(Arc::new(tags))));
    let told = of(&diagnostics, "layout-property");
    assert!(told.len() == 1 && told[0].message.contains("`7.mixed`") && told[0].message.contains("(2)"), "{told:?}");
}

#[test]
fn parts_and_repeated_ids_stay_apart() {
    let two = json!({"type": "MultiPolygon", "coordinates": [square(0.0, 0.0, 5.0)["coordinates"], square(50.0, 0.0, 5.0)["coordinates"]]});
    let mixed = json!({"type": "GeometryCollection", "geometries": [square(80.0, 0.0, 5.0), {"type": "Point", "coordinates": [81, 1]}]});
    let (layout, diagnostics) = read(&local(vec![
        feature("x", json!({"kind": "lot"}), two),
        feature("y", json!({"kind": "lot"}), square(20.0, 0.0, 5.0)),
        feature("y", json!({"kind": "lot"}), square(30.0, 0.0, 5.0)),
        feature("z", json!({"kind": "water"}), mixed),
    ]));
    let ids: Vec<&str> = layout.regions.iter().map(|r| &*r.id).collect();
    assert_eq!(ids, ["x/1", "x/2", "y", "y-2", "z"]);
    let ids: Vec<&str> = layout.features.iter().map(|f| &*f.id).collect();
    assert_eq!(ids, ["z", "z/points"]);
    assert_eq!(of(&diagnostics, "layout-id").len(), 1);
}

#[test]
fn dirty_geometry_is_repaired_or_named() {
    let ring = |points: Json| json!({"type": "Polygon", "coordinates": [points]});
    let (layout, diagnostics) = read(&local(vec![
        feature("clockwise", json!({"kind": "lot"}), ring(json!([[0, 0], [0, 9], [9, 9], [9, 0], [0, 0]]))),
        feature("open", json!({"kind": "lot"}), ring(json!([[20, 0], [29, 0], [29, 9], [20, 9]]))),
        feature("bow tie", json!({"kind": "lot"}), ring(json!([[40, 0], [50, 10], [50, 0], [40, 10], [40, 0]]))),
        feature("null", json!({"kind": "lot"}), Json::Null),
        feature("thin", json!({"kind": "lot"}), ring(json!([[60, 0], [70, 0], [60, 0]]))),
        feature("flat", json!({"kind": "lot"}), ring(json!([[60, 0], [65, 0], [70, 0], [60, 0]]))),
        feature("words", json!({"kind": "lot"}), ring(json!([["a", 0], [1, 1]]))),
        feature("circle", json!({"kind": "lot"}), json!({"type": "Circle", "coordinates": [1, 2]})),
        json!("not even an object"),
    ]));
    let ids: Vec<&str> = layout.regions.iter().map(|r| &*r.id).collect();
    assert_eq!(ids, ["clockwise", "open", "bow tie/1", "bow tie/2"]);
    assert_eq!(layout.regions[0].polygon.area(), 81.0);
    let repaired = of(&diagnostics, "layout-repaired");
    assert!(repaired.len() == 1 && repaired[0].message.ends_with("(2): `open` and `bow tie`"), "{repaired:?}");
    let left_out: Vec<_> = diagnostics.iter().filter(|d| d.is_error()).collect();
    assert_eq!(left_out.len(), 6, "{left_out:#?}");
    for id in ["null", "thin", "flat", "words", "circle", "9"] {
        assert!(left_out.iter().any(|d| format!("{:?}", d.place).contains(&format!("`{id}`"))), "{id} is named");
    }
    let summary = diagnostics.iter().find(|d| d.severity == Severity::Note).expect("a summary");
    assert!(summary.message.contains("1 without geometry"), "{}", summary.message);
}

#[test]
fn a_thousand_flaws_are_counted_not_recited() {
    let features = (0..1000).map(|i| feature(&i.to_string(), json!({}), Json::Null)).collect();
    let (_, diagnostics) = read(&local(features));
    assert!(diagnostics.len() < 20 && diagnostics.iter().any(|d| d.message.contains("1,000 without geometry")));
}

#[test]
fn coordinate_systems_give_true_metres() {
    let with_crs = |crs: Json, geometry: Json| json!({"type": "FeatureCollection", "crs": crs, "features": [feature("a", json!({"kind": "lot"}), geometry)]});
    let named = |name: &str| json!({"type": "name", "properties": {"name": name}});
    let (layout, _) = read(&with_crs(named("urn:ogc:def:crs:EPSG::2154"), square(652_469.0, 6_862_035.0, 100.0)));
    assert_eq!(layout.georeference.crs, Crs::Epsg(2154));
    assert!((layout.regions[0].polygon.area() - 1e4).abs() < 1e-6);
    let (layout, _) = read(&with_crs(named("EPSG:3857"), square(1_603_599.0, 6_464_369.0, 100.0)));
    assert!((layout.regions[0].polygon.area() - 64.15 * 64.15).abs() < 50.0, "web mercator metres are not metres");
    // One second of arc at the equator: 30.92 m east, 30.72 m north.
    let (layout, _) = read(&with_crs(Json::Null, square(9.0, 0.0, 1.0 / 3600.0)));
    let size = layout.regions[0].polygon.bounds().size();
    assert!((size - DVec2::new(30.922, 30.715)).length() < 0.01, "{size}");
    let corner = layout.georeference.to_world(layout.regions[0].polygon.outer()[0]);
    assert!((corner[0] - 9.0).abs() < 1e-9 && corner[1].abs() < 1e-9);
}

#[test]
fn metres_without_a_system_are_not_taken_for_degrees() {
    let metres = json!({"type": "FeatureCollection", "features": [feature("a", json!({}), square(652_469.0, 6_862_035.0, 10.0))]});
    let (layout, diagnostics) = read(&metres);
    assert!(layout.regions.is_empty() && diagnostics.len() == 1 && diagnostics[0].is_error());
    assert!(
        diagnostics[0].hints.iter().any(|h| h.contains("EPSG:"))
            && diagnostics[0].hints.iter().any(|h| h.contains("local"))
    );
    let (_, diagnostics) = read(&json!({"type": "FeatureCollection", "crs": "EPSG:9", "features": []}));
    assert!(diagnostics[0].is_error() && diagnostics[0].message.contains("`EPSG:9`"));
}

#[test]
fn heights_are_read() {
    let geometry =
        json!({"type": "Polygon", "coordinates": [[[0, 0, 10], [9, 0, 12], [9, 9, 14], [0, 9, 12], [0, 0, 10]]]});
    let (layout, _) = read(&local(vec![
        feature("z", json!({"kind": "lot"}), geometry.clone()),
        feature("e", json!({"kind": "lot", "elevation": 3}), geometry),
    ]));
    assert!((layout.regions[0].elevation - 11.6).abs() < 1e-9 && layout.regions[1].elevation == 3.0);
}

#[test]
fn what_is_not_geojson_says_where() {
    let (_, diagnostics) =
        read_geojson("plan.geojson", b"{\n  \"type\": \"FeatureCollection\",\n  \"features\": [,]\n}");
    assert!(
        diagnostics.len() == 1 && format!("{:?}", diagnostics[0].place).contains("plan.geojson:3:16"),
        "{diagnostics:?}"
    );
    for (text, word) in [
        ("[]", "JSON object"),
        ("{\"type\":\"FeatureColection\"}", "`FeatureColection`"),
        ("{\"type\":\"FeatureCollection\"}", "`features`"),
    ] {
        let (_, diagnostics) = read_geojson("plan.geojson", text.as_bytes());
        assert!(diagnostics.len() == 1 && diagnostics[0].message.contains(word), "{text}: {diagnostics:?}");
    }
}

#[test]
fn a_bare_polygon_is_a_lot() {
    let (layout, diagnostics) = read(&square(2.0, 48.0, 0.001));
    assert_eq!(layout.regions[0].kind, Kind::Lot);
    assert!(diagnostics.len() == 1 && diagnostics[0].severity == Severity::Note, "{diagnostics:?}");
}

#[test]
fn the_plan_does_not_move_when_a_corner_is_edited() {
    let lots = |extra: f64| {
        (0..9)
            .map(|i| {
                feature(
                    &i.to_string(),
                    json!({"kind": "lot"}),
                    square(2.1 + 1e-4 * f64::from(i) + extra * f64::from(i / 8), 48.8, 1e-5),
                )
            })
            .collect::<Vec<_>>()
    };
    let read = |extra| read(&json!({"type": "FeatureCollection", "features": lots(extra)})).0;
    let (before, after) = (read(0.0), read(1e-3));
    assert_eq!(before.regions[0].polygon, after.regions[0].polygon);
    assert_ne!(before.regions[8].polygon, after.regions[8].polygon);
}

#[test]
fn neighbours_of_a_grid_are_the_eight_around() {
    let side = 40;
    let lots = (0..side * side).map(|i| {
        feature(
            &i.to_string(),
            json!({"kind": "lot"}),
            square(f64::from(i % side) * 20.0, f64::from(i / side) * 20.0, 20.0),
        )
    });
    let (layout, _) = read(&local(lots.collect()));
    let inner = layout.regions.iter().filter(|r| r.neighbours.len() == 8).count();
    assert_eq!(inner as i32, (side - 2) * (side - 2));
}

/// A file of the shared data, where there is any.
fn shared(path: &str) -> Option<Vec<u8>> {
    let root: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared/data");
    let bytes = std::fs::read(root.join(path)).ok();
    if bytes.is_none() {
        println!("skipped: no shared data `{path}`");
    }
    bytes
}

#[test]
fn real_parcels_import_whole() {
    // Areas by PROJ and GEOS, on WGS84.
    let files = [("cambridge_ma/parcels_fy2014.geojson", 505, 144.9312), ("bubenec/plots.geojson", 407, 27.8937)];
    for (path, count, hectares) in files {
        let Some(bytes) = shared(path) else { continue };
        let (layout, diagnostics) = read_geojson(path, &bytes);
        sanity_check(&layout);
        assert!(layout.regions.len() >= count, "{path}: {} regions, {diagnostics:#?}", layout.regions.len());
        assert!(diagnostics.iter().all(|d| !d.is_error()), "{diagnostics:#?}");
        let area: f64 = layout.regions.iter().map(|r| r.polygon.area()).sum::<f64>() / 1e4;
        assert!((area - hectares).abs() < 0.002 * hectares, "{path}: {area} ha");
        let adjoining = layout.regions.iter().filter(|r| !r.neighbours.is_empty()).count();
        assert!(adjoining * 10 > layout.regions.len() * 8, "{path}: {adjoining} have neighbours");
    }
}

/// Some JSON that looks like GeoJSON and is wrong in places.
fn nearly_geojson() -> impl Strategy<Value = Json> {
    let number = prop_oneof![
        5 => (-50i32..50).prop_map(|n| json!(n)),
        2 => (-60.0..60.0f64).prop_map(|n| json!(n)),
        1 => prop_oneof![Just(json!(1e308)), Just(json!(-1e17)), Just(json!(null)), Just(json!("x"))],
    ];
    let position = prop::collection::vec(number, 1..4).prop_map(Json::Array);
    let ring = prop::collection::vec(position, 0..8).prop_map(|mut r| {
        r.extend(r.first().cloned());
        Json::Array(r)
    });
    let rings = prop::collection::vec(ring, 0..3).prop_map(Json::Array);
    let geometry = (
        prop::sample::select(vec!["Polygon", "MultiLineString", "MultiPolygon", "Point", "GeometryCollection"]),
        rings,
    )
        .prop_map(|(kind, rings)| match kind {
            "MultiPolygon" => json!({"type": kind, "coordinates": [rings]}),
            "Point" => json!({"type": kind, "coordinates": rings.pointer("/0/0")}),
            "GeometryCollection" => json!({"type": kind, "geometries": [{"type": "Polygon", "coordinates": rings}]}),
            _ => json!({"type": kind, "coordinates": rings}),
        });
    let kinds = vec![json!("lot"), json!("street"), json!("tree"), json!("own word"), json!(3), json!(null)];
    let features = prop::collection::vec((prop::sample::select(kinds), geometry, -3.0..9.0f64), 0..9);
    let crs =
        prop::sample::select(vec![json!("local"), json!(null), json!("EPSG:3857"), json!("EPSG:32633"), json!(7)]);
    (features, crs).prop_map(|(features, crs)| {
        let features: Vec<Json> = features
            .into_iter()
            .map(|(kind, geometry, width)| json!({"type": "Feature", "id": "same", "properties": {"kind": kind, "width": width}, "geometry": geometry}))
            .collect();
        json!({"type": "FeatureCollection", "crs": crs, "features": features})
    })
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(400))]

    #[test]
    fn no_json_panics(json in nearly_geojson()) {
        read(&json);
    }

    #[test]
    fn no_bytes_panic(json in nearly_geojson(), at in any::<prop::sample::Index>(), byte: u8) {
        let mut bytes = json.to_string().into_bytes();
        let at = at.index(bytes.len());
        bytes[at] = byte;
        let (layout, _) = read_geojson("plan.geojson", &bytes);
        sanity_check(&layout);
    }

    #[test]
    fn the_way_back_is_the_way_in(longitude in -179.0..179.0f64, latitude in -80.0..80.0f64) {
        let (layout, _) = read(&square(longitude, latitude, 1e-4));
        let corner = layout.georeference.to_world(layout.regions[0].polygon.outer()[0]);
        let metres = (DVec2::from(corner) - DVec2::new(longitude, latitude)) * 111_000.0;
        prop_assert!(metres.length() < 1e-4, "{metres}");
    }

    #[test]
    fn trees_stand_where_they_were_put(x in -500.0..500.0f64, y in -500.0..500.0f64) {
        let (layout, _) = read(&local(vec![feature("p", json!({"kind": "tree"}), json!({"type": "Point", "coordinates": [x, y]}))]));
        let Shapes::Points(points) = &layout.features[0].shapes else { panic!("a point stays one") };
        prop_assert!(points[0].distance(DVec2::new(x, y)) < 1e-9);
    }
}

/// `streetWidth` of a lot whose outline has these corners.
fn street_widths(corners: &[[f64; 2]], widths: &[f64]) -> (Value, Vec<Diagnostic>) {
    let ring: Vec<[f64; 2]> = corners.iter().chain(corners.first()).copied().collect();
    let geometry = json!({"type": "Polygon", "coordinates": [ring]});
    let lot = feature("a", json!({"kind": "lot", "streetWidth": widths}), geometry);
    let (layout, diagnostics) = read(&local(vec![lot]));
    (region(&layout, "a").attributes["streetWidth"].clone(), diagnostics)
}

#[test]
fn lists_by_edge_follow_the_edges() {
    let row = |numbers: &[f64]| Value::Array(Arc::new(Array::row(Cells::Numbers(numbers.to_vec()))));
    let clockwise = [[0.0, 0.0], [0.0, 30.0], [40.0, 30.0], [40.0, 0.0]];
    // The street lies in the north; from the same first corner the edges are south, east, north, west.
    assert_eq!(street_widths(&clockwise, &[0.0, 6.0, 0.0, 0.0]).0, row(&[0.0, 0.0, 6.0, 0.0]));
    let repeated = [[0.0, 0.0], [40.0, 0.0], [40.0, 0.0], [40.0, 30.0], [0.0, 30.0]];
    assert_eq!(street_widths(&repeated, &[0.0, 0.0, 6.0, 0.0, 0.0]).0, row(&[0.0, 6.0, 0.0, 0.0]));
    let ring = json!([[0, 0], [40, 30], [40, 0], [0, 30], [0, 0]]);
    let geometry = json!({"type": "Polygon", "coordinates": [ring]});
    let (_, told) = read(&local(vec![feature("b", json!({"streetWidth": [1, 0, 0, 0]}), geometry)]));
    assert_eq!(of(&told, "layout-edges").len(), 1, "a bow tie has other edges");
}
