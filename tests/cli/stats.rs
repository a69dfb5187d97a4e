//! `bosquet stats`: what it measures, what it assumes, what it refuses.

use crate::bench::Bench;
use serde_json::{Value, json};

const LOTS: &str = r#"{"type": "FeatureCollection", "crs": "local", "features": [
{"type": "Feature", "properties": {"kind": "lot"}, "geometry": {"type": "Polygon",
  "coordinates": [[[0, 0], [50, 0], [50, 100], [0, 100], [0, 0]]]}},
{"type": "Feature", "properties": {"kind": "lot"}, "geometry": {"type": "Polygon",
  "coordinates": [[[50, 0], [100, 0], [100, 100], [50, 100], [50, 0]]]}}]}"#;

/// Points of a square lattice of 10 m from (5, 5), as a collection with these members.
fn lattice(side: usize, members: &str, place: impl Fn(f64, f64) -> [f64; 2]) -> String {
    let features: Vec<Value> = (0..side * side)
        .map(|i| {
            let at = place((i % side) as f64 * 10.0 + 5.0, (i / side) as f64 * 10.0 + 5.0);
            json!({ "type": "Feature", "properties": { "kind": "tree" },
                    "geometry": { "type": "Point", "coordinates": at } })
        })
        .collect();
    format!(r#"{{"type": "FeatureCollection", {members} "features": {}}}"#, json!(features))
}

fn bench() -> Bench {
    let trees = lattice(10, r#""crs": "local","#, |x, y| [x, y]);
    Bench::new().with("trees.geojson", trees).with("lots.geojson", LOTS)
}

fn close(value: &Value, wanted: f64) {
    let found = value.as_f64().unwrap_or(f64::NAN);
    assert!((found - wanted).abs() < 1e-6 * wanted.abs().max(1.0), "{found}, not {wanted}");
}

#[test]
fn a_lattice_is_measured_in_its_window() {
    let bench = bench();
    let ran = bench.bosquet("stats trees.geojson --window lots.geojson --csv a.csv --json a.json --rmax 20").ends(0);
    assert!(ran.out.contains("100 per ha") && !ran.err.contains("hull"), "{ran:#?}");
    let set = &bench.json("a.json")["sets"][0];
    close(&set["area"], 10_000.0);
    close(&set["clark_evans"]["uncorrected"], 2.0);
    close(&set["nearest_neighbour"]["p50"], 10.0);
    close(&set["to_window"]["least"], 5.0);
    let table = bench.text("a.csv");
    assert!(
        table.starts_with("set,r,k,l_less_r,g,nearest_within,window_within\r\n\"trees.geojson\",0.3125,0,"),
        "{table}"
    );
    assert_eq!(table.lines().count(), 65);
    assert!(table.ends_with(",1,0.64\r\n"), "64 of the 100 trees are no farther than 20 m from the edge: {table}");
}

#[test]
fn without_a_window_the_hull_is_taken_and_told() {
    let bench = bench();
    bench.bosquet("stats trees.geojson --json a.json").ends(0).says(&["trees.geojson", "convex hull"]);
    close(&bench.json("a.json")["sets"][0]["area"], 8_100.0);
}

#[test]
fn points_outside_are_left_out_and_counted() {
    let small = LOTS.replace("100", "55");
    let bench = bench().with("small.geojson", small);
    let ran = bench.bosquet("stats trees.geojson --window small.geojson --json a.json").ends(0);
    ran.says(&["64 points outside of the window left out"]);
    assert_eq!(bench.json("a.json")["sets"][0]["points"], 36);
}

#[test]
fn degrees_are_measured_in_metres() {
    // 10 m at the equator of the sphere of the same length as WGS84's.
    let degrees = |x: f64, y: f64| [2.0 + x / 111_319.490_8, y / 110_574.3];
    let bench = Bench::new().with("trees.geojson", lattice(6, "", degrees));
    bench.bosquet("stats trees.geojson --json a.json").ends(0);
    let mean = bench.json("a.json")["sets"][0]["nearest_neighbour"]["mean"].as_f64().expect("a number");
    assert!((mean - 10.0).abs() < 0.001, "{mean}");
}

#[test]
fn two_sets_are_compared_beside_chance() {
    let bench = bench().with("moved.geojson", lattice(10, r#""crs": "local","#, |x, y| [x + 3.0, y - 4.0]));
    let line = "stats trees.geojson moved.geojson --window lots.geojson --random --seed 7 --json a.json";
    let first = bench.bosquet(line).ends(0).out;
    assert_eq!(first, bench.bosquet(line).ends(0).out, "the seed decides");
    let all = bench.json("a.json");
    let [moved, random] = [&all["comparisons"][0], &all["comparisons"][1]];
    close(&moved["metres"]["nearest_w1"], 0.0);
    close(&moved["hausdorff"], 5.0);
    close(&moved["chamfer"], 10.0);
    assert_eq!((&random["with"], &all["sets"][2]["points"]), (&json!("random"), &json!(100)));
    assert!(random["scaled"]["nearest_w1"].as_f64() > Some(0.3), "{random}");
}

#[test]
fn tables_stand_in_the_system_of_their_window() {
    let bench = bench().with("trees.csv", "x,y,kind\n10,10,tree\n20,10,tree\n90,90,shrub\n");
    bench.bosquet("stats trees.csv --window lots.geojson --kind tree --json a.json").ends(0);
    close(&bench.json("a.json")["sets"][0]["nearest_neighbour"]["mean"], 10.0);
    let degrees = LOTS.replace(r#""crs": "local","#, "").replace("100", "0.02").replace("50", "0.01");
    let bench = bench.with("degrees.geojson", degrees);
    bench.bosquet("stats trees.csv --window degrees.geojson").ends(1).says(&["trees.csv", "in metres", "`WGS84`"]);
    let ran = bench.bosquet("stats trees.csv --window lots.geojson --kind hedge").ends(1);
    ran.says(&["no point of kind `hedge`", "`shrub`, `tree`"]);
}

#[test]
fn what_bosquet_plants_it_measures() {
    let bench = Bench::two_lots("Lot --> [ Distr(0.05, 0) { T } ] Lawn\nT --> I(birch)");
    bench.derive_two("-o plants:p.geojson -o plants:p.csv").ends(0);
    bench.bosquet("stats p.geojson p.csv --window two.geojson --json a.json").ends(0);
    let all = bench.json("a.json");
    close(&all["comparisons"][0]["hausdorff"], 0.0);
    assert_eq!(all["sets"][0]["points"], all["sets"][1]["points"]);
}

#[test]
fn distances_to_houses_and_streets() {
    let house = r#"{"type": "Feature", "crs": "local", "properties": {"kind": "building"}, "geometry": {"type": "Polygon",
        "coordinates": [[[0, 0], [100, 0], [100, 10], [0, 10], [0, 0]]]}}"#;
    let street = r#"{"type": "Feature", "crs": "local", "properties": {}, "geometry": {"type": "LineString",
        "coordinates": [[-1, 102], [101, 102]]}}"#;
    let bench = bench().with("house.geojson", house).with("street.geojson", street);
    let line = "stats trees.geojson --window lots.geojson --buildings house.geojson --streets street.geojson";
    bench.bosquet(&format!("{line} --json a.json")).ends(0);
    let further = bench.json("a.json")["sets"][0]["distances"].clone();
    close(&further["to_buildings"]["least"], 0.0);
    close(&further["to_buildings"]["most"], 85.0);
    close(&further["to_streets"]["least"], 7.0);
}

#[test]
fn threads_change_no_byte() {
    let bench = bench();
    let with = |threads: &str| {
        let mut command = bench.command(&["stats", "trees.geojson", "--random", "--json", "a.json"]);
        assert!(command.env("RAYON_NUM_THREADS", threads).status().expect("it runs").success());
        bench.text("a.json")
    };
    assert_eq!(with("1"), with("2"));
}

#[test]
fn what_cannot_be_measured_is_refused() {
    let point =
        |coordinates: &str| format!(r#"{{"type": "MultiPoint", "crs": "local", "coordinates": {coordinates}}}"#);
    let cases = [
        ("", "empty"),
        ("{", "no valid JSON"),
        ("name,species\nA,B\n", "columns"),
        (&point("[[1, 1]]"), "no area"),
        (&point("[[1, 1], [2, 2], [3, 3]]"), "no area"),
        (&point("[]"), "empty"),
        (r#"{"type": "MultiPoint", "coordinates": [[652000, 6862000], [652001, 6862003]]}"#, "no degrees"),
        (r#"{"type": "LineString", "crs": "local", "coordinates": [[0, 0], [1, 1]]}"#, "no points"),
        ("longitude,latitude\n652000,6862000\n652001,6862003\n", "off the globe"),
    ];
    for (text, words) in cases {
        let bench = bench().with("a.geojson", text);
        bench.bosquet("stats a.geojson --json b.json").ends(1).says(&[words, "a.geojson"]);
        assert!(!bench.has("b.json"), "{text}");
    }
    let bench = bench();
    bench.bosquet("stats none.geojson").ends(1).says(&["none.geojson"]);
    bench.bosquet("stats trees.geojson --window trees.geojson").ends(1).says(&["no polygon"]);
    for usage in ["stats", "stats trees.geojson --rmax 0", "stats trees.geojson --rmax NaN", "stats a --radii 0"] {
        bench.bosquet(usage).ends(2);
    }
}
