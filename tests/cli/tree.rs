//! `bosquet derive --tree`: the derivation as text.

use crate::bench::Bench;

/// Rules with arguments, a set attribute and a leaf.
const RULES: &str =
    "attr tall = 2\nLot --> split(x) { 5 : set(tall, 3) Bed(1) | ~1 : Lawn }\nBed(n) --> extrude(tall) B.\n";

#[test]
fn every_shape_says_where_it_is_and_what_it_was_given() {
    let bench = Bench::two_lots(RULES);
    let ran = bench.derive_two("--tree --lot west").ends(0);
    let lines: Vec<&str> = ran.out.lines().map(|line| line.split(", seed ").next().unwrap_or(line)).collect();
    let wanted = [
        "  Lot --> flat 20 0 20 about 10 0 -10, area 400",
        "    Bed(1) --> flat 5 0 20 about 2.5 0 -10, area 100, tall = 3",
        "      B: prism 5 3 20 about 2.5 1.5 -10, area 350, volume 300",
        "    Lawn: flat 15 0 20 about 12.5 0 -10, area 300",
    ];
    assert!(lines[0].starts_with("west: seed ") && ran.out.lines().next().unwrap().ends_with("tall = 2"), "{ran:#?}");
    assert_eq!(lines[1..], wanted);
    assert_eq!(bench.names(), ["rules.cga", "two.geojson"], "a tree writes no file");
}

#[test]
fn what_is_cut_is_said() {
    let bench = Bench::two_lots(RULES);
    let ran = bench.derive_two("--tree --depth 0").ends(0);
    assert!(ran.out.contains("\n    … 3 shapes below\n") && ran.out.contains("\neast: "), "{ran:#?}");
    let many = Bench::two_lots("Lot --> split(x) { 0.003 : Lawn. }*");
    let ran = many.derive_two("--tree").ends(0);
    let rest = "  … and 1,668 more shapes: `--lot` shows all, `--depth` fewer";
    assert!(ran.out.lines().any(|line| line == rest), "{:?}", ran.out.lines().last());
    let whole = many.derive_two("--tree --lot east").ends(0);
    assert_eq!(whole.out.lines().count(), 2 + 6_667);
}

#[test]
fn the_same_run_gives_the_same_text_on_any_number_of_threads() {
    let bench = Bench::garden();
    let [one, four] = ["1", "4"].map(|n| bench.bosquet(&format!("derive garden --tree --threads {n}")).ends(0).out);
    assert_eq!(one, four);
    let other = bench.bosquet("derive garden --tree --seed 9").ends(0).out;
    assert_ne!(one, other);
}

#[test]
fn outputs_are_written_where_they_are_asked_for() {
    let bench = Bench::garden();
    let ran = bench.bosquet("derive garden --tree -o a.svg").ends(0).says(&["wrote a.svg"]);
    assert!(ran.out.contains("Hedge --> "), "{ran:#?}");
    bench.bosquet("derive garden --tree --lot lto").ends(2).says(&["no lot `lto`"]);
    bench.bosquet("derive garden --lot lot").ends(2).says(&["--tree"]);
}
