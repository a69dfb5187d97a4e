//! The main job: the gardens of Versailles from rules.

use crate::bench::{Bench, repository};
use serde_json::Value;

fn derive(bench: &Bench, more: &[&str]) {
    let place = repository("examples/versailles");
    bench.run(&[&["derive", &*place], more].concat()).ends(0);
}

fn symbols(bench: &Bench, more: &[&str]) -> Value {
    derive(bench, &[&["-o", "r.json"], more].concat());
    bench.json("r.json")["counts_by_symbol"].clone()
}

#[test]
fn recursions_divide_the_major_region_into_powers_of_two() {
    let bench = Bench::new();
    assert_eq!(symbols(&bench, &["--set", "recursions=3"])["grassArea"], 8);
    assert_eq!(symbols(&bench, &["--set", "recursions=6"])["grassArea"], 64);
    assert_eq!(symbols(&bench, &[])["grassArea"], 8, "the manifest asks for three");
    assert_eq!(bench.json("r.json")["diagnostics"], serde_json::json!([]));
}

#[test]
fn the_same_bytes_on_one_and_two_threads() {
    let bench = Bench::new();
    let kinds = [
        "plan.svg",
        "plan.png",
        "plants:p.geojson",
        "plants:p.csv",
        "surfaces:s.geojson",
        "schedule:s.csv",
        "report.json",
        "all.geojson",
    ];
    let file = |threads: &str, kind: &str| match kind.split_once(':') {
        Some((kind, file)) => format!("{kind}:{threads}-{file}"),
        None => format!("{threads}-{kind}"),
    };
    for threads in ["1", "2"] {
        let outputs: Vec<String> = kinds.iter().map(|kind| file(threads, kind)).collect();
        let mut arguments = vec!["--threads", threads];
        outputs.iter().for_each(|output| arguments.extend(["-o", output]));
        derive(&bench, &arguments);
    }
    for kind in kinds {
        let name = kind.split(':').next_back().unwrap_or(kind);
        let [one, two] = ["1", "2"].map(|threads| bench.bytes(&format!("{threads}-{name}")));
        assert!(one == two && one.len() > 1000, "{kind} differs between one and two threads");
    }
}

#[test]
fn the_same_rules_run_elsewhere() {
    let bench = Bench::new();
    let rules = repository("examples/versailles/versailles.cga");
    for place in ["island", "square"] {
        let layout = repository(&format!("examples/versailles/elsewhere/{place}.geojson"));
        let run = |recursions: &str| {
            bench
                .run(&["derive", &layout, "--rules", &rules, "--set", recursions, "-o", "a.svg", "-o", "r.json"])
                .ends(0);
            bench.json("r.json")
        };
        assert_eq!(run("recursions=3")["counts_by_symbol"]["grassArea"], 8, "{place}");
        let report = run("recursions=6");
        assert_eq!(report["counts_by_symbol"]["grassArea"], 64, "{place}");
        assert!(report["summary"]["plants"].as_u64().is_some_and(|n| n > 100), "{place} is planted");
    }
}
