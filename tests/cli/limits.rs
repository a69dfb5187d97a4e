//! Rules without end stop at limits that have names and flags; the rest of the run is written.

use crate::bench::{Bench, Ran};
use std::process::Command;
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

/// Rules that would go on or grow for ever, and the limit that ends each.
const RUNAWAYS: &[(&str, &str)] = &[
    ("`depth`", "Lot --> A\nA --> A A"),
    ("`depth`", "Lot --> A\nA --> [ A ] A"),
    ("`depth`", "Lot --> A\nA --> split(x) { '0.5 : A | '0.5 : A }"),
    ("`depth`", "Lot --> A(1)\nA(n) with (m := n + 1) --> B(m)\nB(n) with (m := n + 1) --> A(m)"),
    ("`depth`", "Lot --> primitiveSphere(100, 100) A\nA --> s('0.9, '1, '1) [ A ] A"),
    ("`shapes`", "Lot --> R(60)\nR(n) --> case n > 0 : R(n - 1) R(n - 1) else : NIL"),
    ("`shapes`", "Lot --> split(x) { 0.01 : split(z) { 0.01 : Lawn. }* }*"),
    ("`children`", "Lot --> split(x) { 1e-9 : Lawn. }*"),
    ("`children`", "Lot --> scatter(surface, 1e9, uniform) { Tree. }"),
    ("limit of 10,000,000", "Lot --> Distr(1e9) { Tree. }"),
    ("`calls`", "f(x) = f(x + 1)\nLot --> extrude(f(1)) Lawn."),
    ("`calls`", "f(x) with (y := g(x)) = y\ng(x) with (y := f(x)) = y\nLot --> extrude(f(1)) Lawn."),
    ("`evaluations`", "f(n) = case n > 0 : f(n - 1) + f(n - 1) else : 1\nLot --> extrude(f(99)) Lawn."),
    ("`array`", "Lot --> print([1 : 1e12]) Lawn."),
    ("`array`", "f(a) = f([a, a])\nLot --> print(f([1, 2])) Lawn."),
    ("`array`", "Lot --> A([1, 2])\nA(a) --> A([a, a])"),
    ("`text`", "f(t, n) = f(t + t, n + 1)\nLot --> print(f(\"a\", 1)) Lawn."),
    ("`text`", "Lot --> A(\"a\")\nA(t) --> A(t + t)"),
    ("`text`", "attr t = \"a\"\nLot --> A\nA --> set(t, t + t) A"),
    ("`text`", "f(t) = f(listAdd(t, t))\nLot --> print(f(\"a;b\")) Lawn."),
    ("`text`", "Lot --> A(\"aa\")\nA(t) --> A(replace(t, \"a\", t))"),
    ("`text`", "f(t) = f(str([t, t, t, t]))\nLot --> print(f(\"abc\")) Lawn."),
    ("than 48 times", "Lot --> A\nA --> inline(unify) { A }"),
    ("than 48 times", "Lot --> A\nA --> union { A | extrude(1) }"),
    ("circle", "import me : \"rules.cga\"\nattr a = 1\nLot --> me(a = a + 1).Lot"),
];

#[test]
fn runaway_rules_stay_small() {
    for (limit, rules) in RUNAWAYS {
        let bench = Bench::garden().with("rules.cga", rules);
        let (ran, peak) = measured(bench.command(&["derive", "garden", "--rules", "rules.cga", "-o", "a.json"]));
        assert_eq!(ran.code, 1, "{rules}: {ran:#?}");
        assert!(ran.err.contains(limit), "{rules} does not name {limit}: {}", ran.err);
        assert!(peak <= 1 << 20, "{rules} takes {peak} KiB");
    }
}

/// Runs a command; what it left, and the most memory that it held, KiB: 0 where the system does not tell.
fn measured(mut command: Command) -> (Ran, u64) {
    let mut child = command.spawn().expect("the command starts");
    let (status, mut peak) = (format!("/proc/{}/status", child.id()), 0);
    while child.try_wait().expect("a child").is_none() {
        let text = std::fs::read_to_string(&status).unwrap_or_default();
        let line = text.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let held = line.and_then(|line| line.split_whitespace().next()?.parse().ok());
        peak = peak.max(held.unwrap_or(0));
        std::thread::sleep(Duration::from_millis(2));
    }
    (Ran::of(child.wait_with_output().expect("a child")), peak)
}
