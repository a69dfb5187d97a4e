//! `bosquet diff`: runs, written plants and reports beside each other.

use crate::bench::Bench;
use serde_json::Value;

fn record(bench: &Bench, arguments: &str, code: i32) -> Value {
    let ran = bench.bosquet(&format!("diff --json {arguments}")).ends(code);
    serde_json::from_str(&ran.out).expect("JSON")
}

fn count(lot: &Value, what: &str) -> usize {
    lot[what].as_array().map_or(0, Vec::len)
}

#[test]
fn a_run_equals_itself() {
    let bench = Bench::garden();
    let ran = bench.bosquet("diff garden garden").ends(0);
    assert_eq!(ran.out, "no differences\n");
    assert_eq!(record(&bench, "garden", 0)["equal"], true);
}

#[test]
fn a_setting_alters_plants_where_they_stand() {
    let bench = Bench::garden();
    let found = record(&bench, "garden --set-b shady=true", 1);
    let lot = found["lots"].as_object().expect("lots").values().next().expect("the lot");
    assert_eq!((count(lot, "added"), count(lot, "removed"), count(lot, "changed")), (0, 0, 10), "{found:#}");
    assert!(lot["changed"].as_array().expect("changes").iter().all(|c| c["altered"] == true && c["moved"] == 0.0));
    assert_eq!(found["species"]["Betula pendula"], serde_json::json!({ "a": 10.0, "b": 0.0 }));
    let ran = bench.bosquet("diff garden --set-b shady=true").ends(1);
    assert!(ran.out.contains("10 altered") && ran.out.contains("Fagus sylvatica: 0 -> 10 (+10)"), "{ran:#?}");
}

#[test]
fn rules_of_two_files_differ_in_grounds_and_symbols() {
    let rules = |width: u32| format!("Lot --> split(x) {{ {width} : Sand. | ~1 : Lawn. }}");
    let bench = Bench::two_lots(&rules(5)).with("wide.cga", rules(8)).with("none.cga", "Lot --> NILL(");
    let found = record(&bench, "two.geojson --rules rules.cga --rules-b wide.cga", 1);
    assert_eq!(found["grounds"]["west"]["sand"], serde_json::json!({ "a": 100.0, "b": 160.0 }), "{found:#}");
    assert_eq!(found["symbols"], serde_json::json!({}), "as many shapes of each");
    bench.bosquet("diff two.geojson --rules rules.cga --rules-b none.cga").ends(2).says(&["nothing is compared"]);
}

#[test]
fn another_seed_shows_in_files_as_in_runs() {
    let bench = Bench::garden();
    for seed in [4, 5] {
        bench.bosquet(&format!("derive garden --seed {seed} -o plants:{seed}.geojson -o plants:{seed}.csv")).ends(0);
    }
    let runs = record(&bench, "garden --seed-b 5", 1);
    for ending in ["geojson", "csv"] {
        let files = record(&bench, &format!("4.{ending} 5.{ending}"), 1);
        assert_eq!(files["species"], runs["species"]);
        let [of_files, of_runs] =
            [&files, &runs].map(|r| r["lots"].as_object().expect("lots").values().next().cloned());
        let (of_files, of_runs) = (of_files.expect("a lot"), of_runs.expect("a lot"));
        for what in ["added", "removed", "changed"] {
            assert_eq!(count(&of_files, what), count(&of_runs, what), "{ending}: {what}");
        }
        bench.bosquet(&format!("diff 4.{ending} 4.{ending}")).ends(0);
    }
    bench.bosquet("diff 4.csv garden").ends(0);
    bench.bosquet("diff garden 5.geojson").ends(1);
}

#[test]
fn one_edit_of_a_table_is_one_difference() {
    let bench = Bench::garden();
    bench.bosquet("derive garden -o plants:a.csv").ends(0);
    let table = bench.text("a.csv");
    let mut rows: Vec<String> = table.lines().map(str::to_string).collect();
    rows.remove(3);
    let mut cells: Vec<String> = rows[1].split(',').map(str::to_string).collect();
    cells[0] = (cells[0].parse::<f64>().expect("x") + 1.5).to_string();
    rows[1] = cells.join(",");
    let bench = bench.with("b.csv", rows.join("\n"));
    let found = record(&bench, "a.csv b.csv", 1);
    let lot = found["lots"].as_object().expect("lots").values().next().expect("the lot");
    assert_eq!((count(lot, "added"), count(lot, "removed"), count(lot, "changed")), (0, 1, 1), "{found:#}");
    assert_eq!((&lot["changed"][0]["moved"], &lot["changed"][0]["altered"]), (&1.5.into(), &false.into()));
}

#[test]
fn reports_are_compared_by_their_figures() {
    let bench = Bench::garden();
    bench.bosquet("derive garden -o a.json").ends(0);
    bench.bosquet("derive garden -o b.json --set shady=true").ends(0);
    bench.bosquet("diff a.json a.json").ends(0);
    let found = record(&bench, "a.json b.json", 1);
    assert_eq!(found["species"]["Fagus sylvatica"]["b"], 10.0);
    assert_eq!(found["totals"]["plants"], Value::Null, "as many as before");
}

#[test]
fn trouble_is_no_difference() {
    let bench = Bench::garden().with("no.csv", "a,b\n1,2\n").with("no.geojson", "{}");
    for (arguments, words) in [
        ("garden nowhere", "nowhere"),
        ("no.csv no.csv", "`longitude` and `latitude`"),
        ("no.geojson no.geojson", "feature collection"),
        ("garden --set-b shay=true", "did you mean `shady`?"),
    ] {
        bench.bosquet(&format!("diff {arguments}")).ends(2).says(&[words]);
    }
}
