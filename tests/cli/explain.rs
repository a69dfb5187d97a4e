//! `bosquet explain`: why something is there.

use crate::bench::Bench;
use serde_json::Value;

/// A choice by condition, one by chance, a selector, an alternative of the papers'.
const RULES: &str = "attr wide = 1\n\
    Lot --> setback(2) { street.front : Edge | remainder : Inside(wide) }\n\
    Edge --> 25% : Gravel. 50% : Sand. else : Lawn.\n\
    Inside(w) --> case w > 3 : Bed(w * 2) else : Lawn.\n\
    Bed(n) --> extrude(n) Raised.\n";

fn records(bench: &Bench, arguments: &str) -> Vec<Value> {
    let ran = bench.bosquet(&format!("explain two.geojson --rules rules.cga --json {arguments}")).ends(0);
    serde_json::from_str(&ran.out).expect("JSON")
}

/// What the steps of a record did.
fn deeds(record: &Value) -> Vec<String> {
    let steps = record["steps"].as_array().expect("steps").iter();
    let deeds = steps.flat_map(|step| step["did"].as_array().expect("deeds"));
    deeds.map(|deed| deed["what"].as_str().expect("words").to_string()).collect()
}

#[test]
fn the_way_leads_from_the_start_rule_through_every_choice() {
    let bench = Bench::two_lots(&RULES.replace("street.front", "front"));
    let found = records(&bench, "--at 15,4");
    let raised = &found[0];
    assert_eq!((&raised["class"], &raised["lot"]), (&"solid".into(), &"west".into()));
    let steps = raised["steps"].as_array().expect("steps");
    let rules: Vec<&str> = steps.iter().map(|step| step["rule"].as_str().expect("a name")).collect();
    assert_eq!(rules, ["Lot", "Inside", "Bed", "Raised"]);
    assert_eq!(steps[1]["place"], "rules.cga:4");
    assert!(steps[1]["source"].as_str().expect("a line").starts_with("Inside(w) --> case w > 3"));
    assert_eq!(steps[2]["arguments"], serde_json::json!([["n", "10"]]));
    let deeds = deeds(raised);
    assert!(deeds.iter().any(|deed| deed.starts_with("piece ") && deed.ends_with(": `remainder`")), "{deeds:?}");
    assert!(deeds.contains(&"`w > 3` holds, with w = 5".to_string()), "{deeds:?}");
    assert!(deeds.iter().any(|deed| deed.starts_with("`extrude(") && deed.contains("10")), "{deeds:?}");
    assert_eq!(raised["attributes"]["wide"], "5", "the layout's value");
}

#[test]
fn a_number_that_was_drawn_lies_in_the_part_that_was_followed() {
    let bench = Bench::two_lots(&RULES.replace("street.front", "front"));
    for seed in 1..8 {
        let found = records(&bench, &format!("--at 15,1 --seed {seed}"));
        let ground = found.iter().find(|thing| thing["class"] == "ground").expect("a ground");
        let deeds = deeds(ground);
        let drawn = deeds.iter().find_map(|deed| deed.strip_prefix("drew ")).expect("a number");
        let (number, part) = drawn.split_once(" of 100: the part from ").expect("its part");
        let (from, to) = part.split_once(" to ").expect("two ends");
        let [number, from, to]: [f64; 3] = [number, from, to].map(|text| text.parse().expect("a number"));
        assert!(from <= number && number <= to, "{drawn}");
        let cover = match from {
            0.0 => "Gravel",
            25.0 => "Sand",
            _ => "Lawn",
        };
        let last = ground["steps"].as_array().expect("steps").last().expect("a leaf");
        assert_eq!(last["rule"], cover);
    }
}

#[test]
fn an_else_says_what_did_not_hold() {
    let bench = Bench::two_lots(&RULES.replace("street.front", "front"));
    let found = records(&bench, "--at 35,10");
    assert!(deeds(&found[0]).contains(&"`else`, as `w > 3` does not hold, with w = 0".to_string()), "{found:#?}");
}

#[test]
fn things_lie_from_top_to_bottom_and_the_layout_made_some() {
    let bench = Bench::two_lots("Lot --> Lawn.\n");
    let found = records(&bench, "--at 30,10");
    let classes: Vec<&Value> = found.iter().map(|thing| &thing["class"]).collect();
    assert_eq!(classes, ["plant", "ground"]);
    assert_eq!((&found[0]["id"], found[0]["steps"].as_array().map(Vec::len)), (&"oak".into(), Some(0)));
    let ran = bench.bosquet("explain two.geojson --rules rules.cga --id oak").ends(0);
    assert!(ran.out.contains("no rule made it"), "{ran:#?}");
}

#[test]
fn a_plant_of_the_table_is_found_by_its_id() {
    let bench = Bench::garden();
    bench.bosquet("derive garden -o plants:p.csv").ends(0);
    let id = bench.text("p.csv").lines().nth(1).and_then(|row| row.split(',').nth(2)).expect("an id").to_string();
    let ran = bench.bosquet(&format!("explain garden --id {id}")).ends(0);
    for words in [&*format!("plant {id}: birch (Betula pendula)"), "garden.cga:6: Tree --> case shady", "shady = false"]
    {
        assert!(ran.out.contains(words), "{words}: {ran:#?}");
    }
    let part = bench.bosquet(&format!("explain garden --id {}", &id[..12])).ends(0);
    assert_eq!(part.out, ran.out, "the beginning of an id does");
    let beech = bench.bosquet(&format!("explain garden --id {id} --set shady=true")).ends(0);
    assert!(beech.out.contains("Fagus sylvatica") && beech.out.contains("`shady` holds"), "{beech:#?}");
}

#[test]
fn where_nothing_lies_the_nearest_lot_is_named() {
    let bench = Bench::two_lots("Lot --> NIL");
    let explain = |at: &str| bench.bosquet(&format!("explain two.geojson --rules rules.cga --at {at}"));
    explain("18,18").ends(2).says(&["nothing lies at 18, 18 in lot `west`"]);
    // The street is six metres wide.
    explain("10,-100").ends(2).says(&["the nearest lot, `street`, is 93.0 m away"]);
    explain("10").ends(2).says(&["12.5,40"]);
    bench.bosquet("explain two.geojson --rules rules.cga").ends(2).says(&["--at"]);
    bench.bosquet("explain two.geojson --rules rules.cga --id zzz").ends(2).says(&["nothing has the id `zzz`"]);
}

#[test]
fn what_an_operand_does_is_not_on_the_way_of_others() {
    let bench = Bench::two_lots("Lot --> A inline B Paved.\nA --> Lawn.\nB --> offset(-2, inside) X.\n");
    let found = records(&bench, "--at 15,4");
    let of = |rule: &str| found.iter().find(|thing| thing["steps"].to_string().contains(rule)).expect("a surface");
    let (lawn, paved) = (deeds(of("Lawn")), deeds(of("Paved")));
    assert!(!lawn.iter().any(|deed| deed.contains("offset") || deed.contains("inline")), "{lawn:?}");
    assert!(paved.iter().any(|deed| deed.contains("inline")), "{paved:?}");
    assert!(!paved.iter().any(|deed| deed.contains("offset")), "{paved:?}");
}
