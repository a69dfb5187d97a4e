//! Rules without end stop at limits that have names and flags; the rest of the run is written.

use crate::bench::Bench;
use std::time::{Duration, Instant};

#[test]
fn every_limit_ends_its_lot_by_name() {
    let tree = "Lot --> R(60)\nR(n) --> case n > 0 : R(n - 1) R(n - 1) else : NIL";
    let comb = "Lot --> split(x) { 0.01 : Lawn }*";
    let cases = [
        ("depth", "Lot --> Lot", "--limit-depth 50"),
        ("depth", "Lot --> Lot", ""),
        ("shapes", tree, "--limit-shapes 10000"),
        ("children", comb, "--limit-children 100"),
        ("shapes", comb, "--limit-shapes 100"),
        ("time", tree, "--limit-time 1 --limit-shapes 4000000000"),
        ("calls", "f(n) = f(n + 1)\nLot --> extrude(f(1)) Lawn", ""),
        ("calls", "f(n) = case n > 90 : 1 else : f(n + 1)\nLot --> extrude(f(1)) Lawn", "--limit-calls 80"),
    ];
    for (name, rules, flags) in cases {
        let begun = Instant::now();
        let bench = Bench::two_lots(rules);
        let ran = bench.derive_two(&format!("-o a.json {flags}")).ends(1);
        ran.says(&[&format!("`{name}`"), "limit", "(lot `west`)", "wrote a.json"]);
        assert!(begun.elapsed() < Duration::from_secs(30), "{name}");
    }
}

#[test]
fn a_lot_at_its_limit_leaves_the_others_whole() {
    let rules = "attr wide = 1\nLot --> case wide == 0 : Lot else : Lawn";
    let bench = Bench::two_lots(rules);
    bench.derive_two("-o a.json").ends(1).says(&["limit `depth` of 1000 (lot `east`)"]);
    assert_eq!(bench.json("a.json")["summary"]["area_by_material"]["lawn"], 400);
}

#[test]
fn the_highest_expressions_fit_the_stack_at_every_limit_of_calls() {
    let (open, signs, close) = ("min(1, ".repeat(120), "-".repeat(380), ")".repeat(120));
    let high = format!("f(x) = {open}{signs}f(x){close}\nLot --> extrude(f(1)) Lawn");
    let bench = Bench::two_lots(&high);
    for flags in ["", "--limit-calls 4000 --threads 1"] {
        bench.derive_two(&format!("-o a.json {flags}")).ends(1).says(&["`calls`"]);
    }
    bench.derive_two("--limit-calls 1000000").ends(2);
}

#[test]
fn files_have_a_largest_size() {
    let bench = Bench::garden();
    let ran = bench.bosquet("derive garden -o a.svg --limit-file 20").ends(1);
    ran.says(&["garden/garden.cga", "garden/lot.geojson", "limit `file` of 20", "nothing is written"]);
    bench.bosquet("check garden/garden.cga --limit-file 20").ends(1).says(&["limit `file`"]);
}

#[test]
fn brackets_have_a_greatest_depth() {
    for (open, close) in [("[ ", "] "), ("split(x) { ~1 : ", "} "), ("extrude((", ")) ")] {
        let bench = Bench::two_lots(&format!("Lot --> {}Lawn {}", open.repeat(5000), close.repeat(5000)));
        bench.derive_two("-o a.svg").ends(1).says(&["error[syntax-limit]"]);
    }
}
