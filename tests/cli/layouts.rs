//! Layouts: what regions see, what is kept, and what is wrong with them.

use crate::bench::Bench;
use serde_json::json;

fn reports(bench: &Bench) -> Vec<(String, f64)> {
    let report = bench.json("a.json");
    let list = report["reports"].as_array().expect("reports").iter();
    list.map(|r| (r["key"].as_str().unwrap_or_default().into(), r["sum"].as_f64().unwrap_or(f64::NAN))).collect()
}

#[test]
fn buildings_drives_and_trees_are_seen_by_their_lot() {
    let rules = "Lot -->
        [ without(\"building\") report(\"beside building\", geometry.area) NIL ]
        [ without(\"driveway\") report(\"beside drive\", geometry.area) NIL ]
        [ without(\"tree\") report(\"beside tree\", geometry.area) NIL ]
        Lawn";
    let bench = Bench::two_lots(rules);
    bench.derive_two("-o a.json").ends(0);
    let crown = 0.5 * 16.0 * 9.0 * (std::f64::consts::TAU / 16.0).sin();
    let wanted = [("beside building", 750.0), ("beside drive", 770.0), ("beside tree", 800.0 - crown)];
    for (key, sum) in wanted {
        let found = reports(&bench).into_iter().find(|(k, _)| k == key).expect(key).1;
        assert!((found - sum).abs() < 0.01, "{key}: {found}, not {sum}");
    }
}

#[test]
fn existing_trees_are_kept_drawn_and_kept_clear_of() {
    let rules = "Lot --> [ Distr(0.2, 0) { T } ] Lawn\nT --> case overlaps(intra, \"tree\") : NIL else : I(boxwood)";
    let bench = Bench::two_lots(rules);
    bench.derive_two("-o a.svg -o plants:p.geojson -o a.csv").ends(0);
    let plants = bench.json("p.geojson");
    let plants = plants["features"].as_array().expect("features");
    assert_eq!(
        (&plants[0]["properties"]["species"], &plants[0]["properties"]["existing"]),
        (&json!("Quercus robur"), &json!(true))
    );
    assert_eq!(plants[0]["geometry"]["coordinates"], json!([30.0, 10.0, 2.5]), "its height is kept");
    for plant in &plants[1..] {
        let at = |axis: usize| plant["geometry"]["coordinates"][axis].as_f64().expect("a number");
        assert!((at(0) - 30.0).hypot(at(1) - 10.0) > 2.9, "{plant}");
    }
    assert!(plants.len() > 100 && bench.text("a.svg").contains("Quercus robur"));
    assert!(bench.text("a.csv").contains("Quercus robur,English oak,tree,medium,yes,1,14,3,3"));
}

#[test]
fn properties_become_attributes_of_the_rules() {
    let bench =
        Bench::two_lots("attr wide = 7\nLot --> report(\"wide\", wide) Lawn\nPatio --> report(\"wide\", wide) Lawn");
    bench.derive_two("-o a.json").ends(0);
    assert_eq!(reports(&bench), [("wide".to_owned(), 12.0)], "5 and 0 of the lots, 7 of the rules");
    bench.derive_two("-o a.json --set wide=1").ends(0);
    assert_eq!(reports(&bench), [("wide".to_owned(), 3.0)]);
}

#[test]
fn an_empty_layout_gives_an_empty_plan_and_a_warning() {
    let bench = Bench::two_lots("Lot --> Lawn").with("two.geojson", r#"{"type": "FeatureCollection", "features": []}"#);
    let ran = bench.derive_two("-o a.svg -o a.png -o a.csv -o a.json -o a.geojson -o plants:p.csv").ends(0);
    ran.says(&["the layout holds no region", "0 regions"]);
    roxmltree::Document::parse(&bench.text("a.svg")).expect("XML");
}

#[test]
fn what_is_no_layout_is_refused() {
    let cases: &[(&str, &str)] = &[
        ("", "no valid JSON"),
        ("Lot --> Lawn", "no valid JSON"),
        ("[1, 2]", "JSON object"),
        (r#"{"type": "Topology"}"#, "TopoJSON"),
        (r#"{"type": "FeatureColection", "features": []}"#, "did you mean `FeatureCollection`?"),
        (r#"{"type": "FeatureCollection", "features": 3}"#, "no list of `features`"),
        (r#"{"type": "FeatureCollection", "crs": "EPSG:99", "features": []}"#, "`EPSG:99` is not known"),
    ];
    for (text, words) in cases {
        let bench = Bench::two_lots("Lot --> Lawn").with("two.geojson", text).with("a.svg", "old");
        bench.derive_two("-o a.svg").ends(1).says(&[words, "two.geojson", "nothing is written"]);
        assert_eq!(bench.text("a.svg"), "old");
    }
}

#[test]
fn broken_features_are_left_out_by_name() {
    let text = crate::bench::TWO_LOTS
        .replace("[[[20, 0], [40, 0], [40, 20], [20, 20], [20, 0]]]", "[[[20, 0], [40, 0], [20, 0]]]")
        .replace("[[[0, 0], [20, 0], [20, 20], [0, 20], [0, 0]]]", "[[[0, 0], [20, 0], [0, 20], [20, 20], [0, 0]]]");
    let bench = Bench::two_lots("Lot --> Lawn").with("two.geojson", text);
    let ran = bench.derive_two("-o a.json").ends(1);
    ran.says(&["feature `east`", "the feature is left out", "repaired", "`west`", "wrote a.json"]);
    assert_eq!(bench.json("a.json")["summary"]["area_by_material"]["lawn"], 200);
}

#[test]
fn coordinates_come_back_in_the_layouts_own_system() {
    let lambert = r#"{"type": "Feature", "crs": "EPSG:2154", "properties": {"kind": "lot"}, "geometry": {"type": "Polygon",
        "coordinates": [[[652000, 6862000], [652020, 6862000], [652020, 6862020], [652000, 6862020], [652000, 6862000]]]}}"#;
    let degrees = r#"{"type": "Feature", "properties": {"kind": "lot"}, "geometry": {"type": "Polygon",
        "coordinates": [[[2.1, 48.8], [2.1003, 48.8], [2.1003, 48.8002], [2.1, 48.8002], [2.1, 48.8]]]}}"#;
    let cases =
        [(lambert, [652000.0..652020.0, 6862000.0..6862020.0], true), (degrees, [2.1..2.1003, 48.8..48.8002], false)];
    for (layout, [xs, ys], named) in cases {
        let bench =
            Bench::two_lots("Lot --> [ Distr(0.05, 0) { T } ] Lawn\nT --> I(birch)").with("two.geojson", layout);
        bench.derive_two("-o plants:p.geojson").ends(0);
        let file = bench.json("p.geojson");
        assert_eq!(file["crs"].is_object(), named);
        let plants = file["features"].as_array().expect("features");
        let at =
            |plant: &serde_json::Value, axis: usize| plant["geometry"]["coordinates"][axis].as_f64().unwrap_or(0.0);
        assert!(!plants.is_empty() && plants.iter().all(|p| xs.contains(&at(p, 0)) && ys.contains(&at(p, 1))));
    }
}

#[test]
fn numbers_beyond_reason_are_left_out_and_told() {
    let text = crate::bench::TWO_LOTS
        .replace("[20, 0], [40, 0], [40, 20]", "[20, 0], [1e300, 0], [40, 20]")
        .replace("\"width\": 6", "\"width\": 1e300")
        .replace("\"height\": 14", "\"height\": 1e300")
        .replace("2.5]", "1e308]");
    let bench = Bench::two_lots("Lot --> Lawn").with("two.geojson", text);
    let ran = bench.derive_two("-o a.svg -o a.json -o plants:p.geojson").ends(1);
    ran.says(&["feature `east`", "`oak.height`", "`street.width`"]);
    assert_eq!(bench.json("a.json")["summary"]["lot_area"], 800);
    assert_eq!(bench.json("p.geojson")["features"][0]["geometry"]["coordinates"][2], 0);
}
