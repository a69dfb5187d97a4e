//! `bosquet ops` and `bosquet new`.

use crate::bench::Bench;
use serde_json::Value;

fn manual(bench: &Bench) -> Value {
    serde_json::from_str(&bench.bosquet("ops --json").ends(0).out).expect("JSON")
}

fn operations(manual: &Value) -> &Vec<Value> {
    manual["operations"].as_array().expect("operations")
}

#[test]
fn every_operation_is_explained_with_an_example_that_checks() {
    let mut bench = Bench::new();
    let manual = manual(&bench);
    let mut files = Vec::new();
    for operation in operations(&manual) {
        let name = operation["name"].as_str().expect("a name");
        let docs = operation["docs"].as_str().expect("docs");
        let sentence = docs.split("```").next().and_then(|text| text.split("\n\n").next()).unwrap_or_default();
        assert!(sentence.trim_end().ends_with('.'), "`{name}` has no first sentence: {docs}");
        let example = docs.split("```cga").nth(1).and_then(|rest| rest.split("```").next());
        let example = example.unwrap_or_else(|| panic!("`{name}` has no example"));
        files.push(format!("{}.cga", files.len()));
        bench = bench.with(&files[files.len() - 1], example);
        for param in operation["params"].as_array().expect("params") {
            assert!(param["docs"].as_str().is_some_and(|d| d.len() > 5), "`{name}`: {param}");
        }
    }
    let ran = bench.bosquet(&format!("check {}", files.join(" ")));
    assert_eq!(ran.code, 0, "{ran:#?}");
}

#[test]
fn the_pages_of_one_operation_agree() {
    let bench = Bench::new();
    let manual = manual(&bench);
    for operation in operations(&manual) {
        let name = operation["name"].as_str().expect("a name");
        let one: Value = serde_json::from_str(&bench.run(&["ops", name, "--json"]).ends(0).out).expect("JSON");
        assert_eq!(one, *operation);
        let page = bench.run(&["ops", name]).ends(0).out;
        assert!(page.starts_with(operation["usage"].as_str().expect("usage")), "{page}");
    }
    let overview = bench.bosquet("ops").ends(0).out;
    operations(&manual).iter().for_each(|o| assert!(overview.contains(o["usage"].as_str().unwrap_or("?"))));
}

#[test]
fn all_chapters_print_and_unknown_names_get_advice() {
    let bench = Bench::new();
    for (chapter, least) in [("functions", 100), ("covers", 10), ("elements", 50), ("unbuilt", 2)] {
        assert!(bench.run(&["ops", chapter]).ends(0).out.lines().count() > least, "{chapter}");
    }
    bench.bosquet("ops extrud").ends(2).says(&["did you mean `extrude`?"]);
    assert!(!bench.run(&["ops", "unbuilt"]).ends(0).out.contains("Functions"), "no heading without a list");
    let unbuilt = manual(&bench)["unbuilt"]["operations"][0]["name"].as_str().expect("a name").to_owned();
    assert!(bench.run(&["ops", &unbuilt]).ends(0).out.contains("does not have it yet"));
}

#[test]
fn a_new_place_derives_and_is_never_written_over() {
    let bench = Bench::new();
    bench.bosquet("new yard").ends(0).says(&["bosquet derive yard"]);
    bench.bosquet("derive yard -o p.svg -o p.png -o p.csv -o p.json -o p.geojson").ends(0);
    assert_eq!(bench.json("p.json")["diagnostics"], serde_json::json!([]), "a starter has nothing to report");
    let bench = bench.with("yard/garden.cga", "Lot --> Mine.");
    bench.bosquet("new yard").ends(2).says(&["is there already"]);
    assert_eq!(bench.text("yard/garden.cga"), "Lot --> Mine.");
    bench.bosquet("check yard/garden.cga").ends(0);
}

#[test]
fn help_and_version_are_there() {
    let bench = Bench::new();
    assert!(bench.bosquet("--version").ends(0).out.starts_with("bosquet 0."));
    let help = bench.bosquet("derive --help").ends(0).out;
    for flag in ["depth", "calls", "shapes", "children", "time", "file"] {
        assert!(help.contains(&format!("--limit-{flag}")), "limits have flags: {flag}");
    }
    bench.bosquet("").ends(2);
    bench.bosquet("drive x").ends(2).says(&["derive"]);
}
