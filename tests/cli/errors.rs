//! Bad input: what is written, what is said, how it ends.

use crate::bench::Bench;
use serde_json::json;

#[test]
fn broken_rules_write_nothing_and_leave_old_files_alone() {
    for rules in ["Lot --> split(x) { 1 : A. ", "Lot --> extrud(3) A.", "attr a = b\nattr b = a\nLot --> Lawn"] {
        let bench = Bench::two_lots(rules).with("a.svg", "old");
        bench.derive_two("-o a.svg -o b.json").ends(1).says(&["--> rules.cga:1:", "nothing is written"]);
        assert_eq!(bench.names(), ["a.svg", "rules.cga", "two.geojson"]);
        assert_eq!(bench.text("a.svg"), "old");
    }
}

#[test]
fn rules_and_layout_are_both_told_about() {
    let bench = Bench::two_lots("Lot --> extrud(3) A.\nB --> )").with("two.geojson", "{ no json");
    bench.derive_two("-o a.svg").ends(1).says(&["extrud", "rules.cga:2:", "two.geojson:1:", "3 errors"]);
}

#[test]
fn missing_files_are_named() {
    let bench = Bench::garden();
    let ran = bench.bosquet("derive garden --rules nowhere.cga -o a.svg").ends(1);
    ran.says(&["there is no file `nowhere.cga`", "nothing is written"]);
    let bench = bench.with("garden/bosquet.toml", "layout = 'gone.geojson'\nrules = 'garden.cga'");
    bench.bosquet("derive garden -o a.svg").ends(1).says(&["there is no file `garden/gone.geojson`"]);
}

#[test]
fn one_lot_fails_and_the_others_are_written() {
    let bench = Bench::two_lots("attr wide = 1\nLot --> split(x) { 10 / wide : Gravel | ~1 : Lawn }");
    let ran = bench.derive_two("-o a.svg -o surfaces:a.geojson -o a.json -o schedule:a.csv").ends(1);
    ran.says(&["(lot `east`)", "in `Lot`", "rules.cga:2:9", "wrote a.svg", "wrote a.json"]);
    let report = bench.json("a.json");
    let errors: Vec<_> =
        report["diagnostics"].as_array().unwrap().iter().filter(|d| d["severity"] == "error").collect();
    assert_eq!(errors.len(), 1);
    assert_eq!((&errors[0]["lot"], &errors[0]["rules"]), (&json!("east"), &json!(["Lot"])));
    assert_eq!((&report["counts_by_symbol"]["Gravel"], &report["counts_by_rule"]["Lot"]), (&json!(1), &json!(2)));
    let surfaces = bench.json("a.geojson");
    let lots: Vec<&str> =
        surfaces["features"].as_array().unwrap().iter().filter_map(|f| f["properties"]["lot"].as_str()).collect();
    assert!(lots.contains(&"west") && !lots.contains(&"east"), "{lots:?}");
}

#[test]
fn a_branch_fails_and_the_rest_of_its_lot_stands() {
    let bench =
        Bench::two_lots("Lot --> split(x) { ~1 : Good | ~1 : Bad }\nGood --> Lawn\nBad --> I(nosuchtree, adult, 1)");
    bench.derive_two("-o a.json").ends(1).says(&["nosuchtree", "in `Bad`, in `Lot`"]);
    assert_eq!(bench.json("a.json")["summary"]["area_by_material"]["lawn"], 400);
}

#[test]
fn lints_alone_end_well() {
    let bench = Bench::two_lots("Lot --> Nowhere");
    bench.derive_two("-o a.svg").ends(0).says(&["warning[leaf]", "`Nowhere` has no rule", "wrote a.svg"]);
}

#[test]
fn operations_that_are_not_built_yet_say_so_where_they_stand() {
    let bench = Bench::two_lots("Lot --> envelope(world.up, 10) Lawn");
    bench.derive_two("-o a.svg").ends(1).says(&["envelope", "rules.cga:1:9", "yet"]);
}

#[test]
fn regions_without_a_rule_are_in_the_report() {
    let bench = Bench::two_lots("Lot --> Lawn");
    bench.derive_two("-o a.json").ends(0).says(&["no rule starts on `yard`, `street`"]);
    let report = bench.json("a.json");
    assert_eq!(report["without_rule"], json!(["yard", "street"]));
    let layout = bench.text("two.geojson").replace("\"kind\": \"patio\"", "\"kind\": \"patio\", \"start\": \"Lott\"");
    let bench = bench.with("two.geojson", layout);
    bench.derive_two("-o a.json").ends(1).says(&["no rule `Lott`", "`yard`", "did you mean `Lot`?"]);
}

#[test]
fn start_rules_are_found_in_their_order() {
    let rules = |extra: &str| format!("{extra}\nOne --> report(\"one\", 1) Lawn\nTwo --> report(\"two\", 1) Lawn");
    let cases = [
        ("start: \"Two\"", rules("Lot --> One"), "two"),
        ("", rules("@Zone(lot)\nThree --> Two\nLot --> One"), "two"),
        ("", rules("@Zone(lot)\nThree --> One\n@Zone(lot, garden)\nFour --> Two"), "two"),
        ("", rules("@StartRule\nSix --> One\nLot --> Two"), "two"),
        ("", rules("@StartRule\nSix --> Two"), "two"),
    ];
    for (start, rules, key) in cases {
        let start = start.replace("start: ", "\"start\": ");
        let start = if start.is_empty() { start } else { format!(", {start}") };
        let layout = format!(
            r#"{{"type": "Feature", "crs": "local", "properties": {{"kind": "lot", "zone": "garden"{start}}},
            "geometry": {{"type": "Polygon", "coordinates": [[[0, 0], [9, 0], [9, 9], [0, 9], [0, 0]]]}}}}"#
        );
        let bench = Bench::new().with("two.geojson", layout).with("rules.cga", &rules);
        bench.derive_two("-o a.json").ends(0);
        assert_eq!(bench.json("a.json")["reports"][0]["key"], key, "{rules}");
        bench.derive_two("-o a.json --start One").ends(0);
        assert_eq!(bench.json("a.json")["reports"][0]["key"], "one", "`--start` comes first");
    }
}

#[test]
fn the_report_says_what_went_in() {
    let bench = Bench::garden().with("garden/more.toml", "").with("garden/part.cga", "P --> Lawn");
    let manifest = bench.text("garden/bosquet.toml") + "catalogues = ['more.toml']";
    let rules = bench.text("garden/garden.cga") + "import part : \"part.cga\"\n";
    let bench = bench.with("garden/bosquet.toml", manifest).with("garden/garden.cga", rules);
    bench.bosquet("derive garden -o a.json").ends(0);
    let report = bench.json("a.json");
    assert_eq!((&report["seed"], &report["version"]), (&json!(4), &json!(env!("CARGO_PKG_VERSION"))));
    let inputs = report["inputs"].as_array().expect("inputs");
    let names: Vec<&str> = inputs.iter().filter_map(|i| i["name"].as_str()).collect();
    assert_eq!(
        names,
        ["bosquet.toml", "garden.cga", "lot.geojson", "more.toml", "part.cga"].map(|n| format!("garden/{n}"))
    );
    assert!(inputs.iter().all(|i| i["blake3"].as_str().is_some_and(|h| h.len() == 64)));
}

#[test]
fn a_manifest_is_read_strictly() {
    let cases: &[(&str, &[&str])] = &[
        ("layout = 'lot.geojson'\nrules = 'garden.cga'\nsede = 1", &["unknown field `sede`", "line 3"]),
        ("layout = 'lot.geojson'", &["missing field `rules`"]),
        ("layout = 3\nrules = 'garden.cga'", &["invalid type", "line 1"]),
        ("layout = 'lot.geojson'\nrules = 'garden.cga'\nattributes.hedge = 1", &["no attribute `hedge`"]),
        ("layout = 'lot.geojson'\nrules = 'garden.cga'\nplan.scale = 'big'", &["`big` is not a scale"]),
        ("layout = 'lot.geojson'\nrules = 'garden.cga'\nstart = 'Lott'", &["no rule `Lott`", "did you mean `Lot`?"]),
        ("layout = ", &["line 1"]),
    ];
    for (manifest, words) in cases {
        let bench = Bench::garden().with("garden/bosquet.toml", manifest);
        bench.bosquet("derive garden").ends(2).says(words);
        assert_eq!(bench.names(), ["garden"]);
    }
}

#[test]
fn what_flies_off_is_left_out_and_told() {
    let bench = Bench::two_lots(
        "Lot --> [ t(1e308, 0, 0) t(1e308, 0, 0) Lawn ] [ s(1e200, 0, 1e200) Lawn ] [ extrude(1e308) Wall. ] \
         [ t(0, 1e308, 0) t(0, 1e308, 0) s(0, 0, 0) I(birch) ] Gravel",
    );
    bench.derive_two("-o a.svg -o a.geojson -o a.json -o a.csv").ends(1).says(&["2 shapes of `Lawn`", "10,000 km"]);
    for file in ["a.svg", "a.geojson", "a.csv"] {
        let text = bench.text(file);
        assert!(!text.contains("NaN") && !text.contains("inf ") && !text.contains("null"), "{file}: {text}");
    }
    let summary = bench.json("a.json")["summary"].clone();
    assert_eq!((&summary["area_by_material"]["gravel"], &summary["plants"]), (&json!(800), &json!(1)));
}
