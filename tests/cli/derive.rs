//! `bosquet derive`: arguments, defaults, seeds, Ctrl-C.

use crate::bench::Bench;

#[test]
fn a_place_writes_its_plan_where_one_stands_and_says_so() {
    let bench = Bench::garden();
    let ran = bench.bosquet("derive garden").ends(0);
    ran.says(&["wrote garden.svg", "wrote garden.png", "1 region, ", " rules, ", " shapes, ", " plants in "]);
    assert_eq!(bench.names(), ["garden", "garden.png", "garden.svg"]);
    assert!(bench.bytes("garden.png").starts_with(b"\x89PNG"));
    roxmltree::Document::parse(&bench.text("garden.svg")).expect("XML");
}

#[test]
fn a_manifest_may_be_named_itself_and_may_name_the_outputs() {
    let bench = Bench::garden();
    let manifest = bench.text("garden/bosquet.toml") + "title = \"Hof\"\noutputs = [\"a.svg\", \"report:b.json\"]\n";
    let bench = bench.with("garden/bosquet.toml", manifest);
    bench.bosquet("derive garden/bosquet.toml").ends(0).says(&["wrote a.svg", "wrote b.json"]);
    assert_eq!(bench.names(), ["a.svg", "b.json", "garden"]);
    assert!(bench.text("a.svg").contains("<title>Hof</title>"));
    bench.bosquet("derive garden -o c.csv").ends(0);
    assert_eq!(bench.names(), ["a.svg", "b.json", "c.csv", "garden"], "arguments come before the manifest");
}

#[test]
fn a_layout_needs_rules_and_a_place_does_not() {
    let bench = Bench::garden();
    bench.bosquet("derive garden/lot.geojson").ends(2).says(&["`--rules FILE.cga`"]);
    bench.bosquet("derive garden/lot.geojson --rules garden/garden.cga -o a.json").ends(0);
    bench.bosquet("derive garden -o b.json").ends(0);
    let counts = |file: &str| bench.json(file)["counts_by_symbol"]["Hedge"].clone();
    assert_eq!(counts("a.json"), counts("b.json"));
    bench.bosquet("derive nowhere").ends(2).says(&["there is no file or folder `nowhere`"]);
    bench.bosquet("derive .").ends(2).says(&["there is no `bosquet.toml`", "bosquet new"]);
}

#[test]
fn settings_come_before_the_layout_and_the_manifest() {
    let bench = Bench::garden();
    let species = |arguments: &str| {
        bench.bosquet(&format!("derive garden -o r.json {arguments}")).ends(0);
        bench.json("r.json")["summary"]["plants_by_species"].as_object().expect("an object").keys().cloned().collect()
    };
    let birch: Vec<String> = species("");
    assert_eq!(birch, ["Betula pendula"]);
    let beech: Vec<String> = species("--set shady=true");
    assert_eq!(beech, ["Fagus sylvatica"]);
    let bench = bench.with("garden/bosquet.toml", "layout='lot.geojson'\nrules='garden.cga'\nattributes.shady=true\n");
    bench.bosquet("derive garden -o r.json").ends(0);
    assert!(bench.json("r.json")["summary"]["plants_by_species"]["Fagus sylvatica"].is_number());
    bench.bosquet("derive garden -o r.json --set shady=false").ends(0);
    assert!(bench.json("r.json")["summary"]["plants_by_species"]["Betula pendula"].is_number());
}

#[test]
fn wrong_settings_are_wrong_usage_with_advice() {
    let bench = Bench::garden();
    let cases: &[(&str, &[&str])] = &[
        ("--set hedge_hight=2", &["no attribute `hedge_hight`", "did you mean `hedge_height`?"]),
        ("--set hedge_height=tall", &["`hedge_height` takes a number", "tall"]),
        ("--set shady=perhaps", &["`shady` takes `true` or `false`"]),
        ("--set hedge_height", &["NAME=VALUE"]),
        ("--start Insid", &["no rule `Insid`", "did you mean `Inside`?"]),
        ("--seed many", &["many"]),
        ("--threads 100000", &["100000"]),
        ("--sed 3", &["--seed"]),
        ("--extent 0,0,inf,inf", &["west, south, east, north"]),
        ("--scale 0", &["1:500"]),
        ("--size 100", &["1600x1200"]),
    ];
    for (arguments, words) in cases {
        bench.bosquet(&format!("derive garden {arguments}")).ends(2).says(words);
    }
    assert_eq!(bench.names(), ["garden"], "nothing is written");
}

#[test]
fn a_start_rule_may_be_asked_for() {
    let bench = Bench::garden();
    bench.bosquet("derive garden --start Inside -o r.json").ends(0);
    let counts = bench.json("r.json")["counts_by_rule"].clone();
    assert!(counts["Inside"] == 1 && counts["Lot"].is_null(), "{counts}");
}

#[test]
fn the_seed_decides_the_bytes() {
    let bench = Bench::garden();
    for (file, seed) in [("a", ""), ("b", "--seed 4"), ("c", "--seed 5"), ("d", "--seed 5")] {
        bench.bosquet(&format!("derive garden {seed} -o plants:{file}.csv -o {file}.svg")).ends(0);
    }
    for ending in ["csv", "svg"] {
        let [a, b, c, d] = ["a", "b", "c", "d"].map(|file| bench.bytes(&format!("{file}.{ending}")));
        assert!(a == b && c == d, "the same seed, the same bytes");
        assert_ne!(a, c, "another seed, other trees");
    }
}

#[test]
fn a_style_may_be_asked_for_and_a_manifest_may_have_one() {
    let rules = "attr height = 1\nLot --> print(height) Lawn\nstyle Winter\nattr height = 2\n";
    let bench = Bench::two_lots(rules);
    assert_eq!(bench.derive_two("-o a.svg").ends(0).out, "west Lot: 1\neast Lot: 1\n");
    assert_eq!(bench.derive_two("-o a.svg --style Winter").ends(0).out, "west Lot: 2\neast Lot: 2\n");
    let wrong = bench.derive_two("-o a.svg --style Wintr").ends(1);
    wrong.says(&["`rules.cga` has no style `Wintr`", "did you mean `Winter`?", "the file has `Default`, `Winter`"]);
    bench.bosquet("check rules.cga --style Summer").ends(1).says(&["has no style `Summer`"]);
    let bench = bench.with("bosquet.toml", "layout = 'two.geojson'\nrules = 'rules.cga'\nstyle = 'Winter'\n");
    assert_eq!(bench.bosquet("derive . -o a.svg").ends(0).out, "west Lot: 2\neast Lot: 2\n");
    assert_eq!(bench.bosquet("derive . -o a.svg --style Default").ends(0).out, "west Lot: 1\neast Lot: 1\n");
}

#[test]
fn every_style_of_a_file_is_checked() {
    let bench = Bench::two_lots("Lot --> Lawn\nstyle Winter\nLot --> extrde(3) Lawn\n");
    bench.bosquet("check rules.cga").ends(1).says(&["there is no operation or rule `extrde`"]);
    bench.bosquet("check rules.cga --style Default").ends(0);
}

#[test]
fn lists_come_from_the_layout_the_manifest_and_the_command_line() {
    let rules = "attr list = [0]\nattr words = [\"a\"]\nLot --> print(list) print(words) Lawn\n";
    let lot = r#"{"type": "Feature", "crs": "local", "properties": {"kind": "lot", "list": [[1, 2], [3, 4]], "mixed": [1, "a"]},
        "geometry": {"type": "Polygon", "coordinates": [[[0, 0], [40, 0], [40, 20], [0, 20], [0, 0]]]}}"#;
    let bench = Bench::new().with("lot.geojson", lot).with("rules.cga", rules);
    let ran = bench.bosquet("derive lot.geojson --rules rules.cga -o a.svg").ends(0);
    assert_eq!(ran.out, "1 Lot: [1, 2; 3, 4]\n1 Lot: [a]\n");
    ran.says(&["properties that are objects or lists of several types are skipped"]);
    let set = "derive lot.geojson --rules rules.cga -o a.svg --set list=[7,8] --set words=[\"b\",\"c\"]";
    assert_eq!(bench.bosquet(set).ends(0).out, "1 Lot: [7, 8]\n1 Lot: [b, c]\n");
    bench
        .bosquet("derive lot.geojson --rules rules.cga --set list=7")
        .ends(2)
        .says(&["`list` takes an array of numbers"]);
    let manifest = "layout = 'lot.geojson'\nrules = 'rules.cga'\nattributes.list = [5]\n";
    let bench = bench.with("bosquet.toml", manifest);
    assert_eq!(bench.bosquet("derive . -o a.svg").ends(0).out, "1 Lot: [5]\n1 Lot: [a]\n");
}

#[test]
fn rules_print_to_standard_output_and_words_go_to_standard_error() {
    let bench = Bench::two_lots("Lot --> print(\"here\") Lawn");
    let ran = bench.derive_two("-o a.svg").ends(0).says(&["wrote a.svg"]);
    assert_eq!(ran.out, "west Lot: here\neast Lot: here\n");
}

#[test]
fn a_reader_that_leaves_stops_nothing() {
    let bench = Bench::two_lots("Lot --> print(1) Lawn.");
    let mut child = bench.command(&["derive", "two.geojson", "--rules", "rules.cga", "-o", "a.svg"]).spawn().unwrap();
    drop((child.stdout.take(), child.stderr.take()));
    assert_eq!(child.wait().unwrap().code(), Some(0));
    assert!(bench.has("a.svg"));
    let mut child = bench.command(&["ops"]).spawn().unwrap();
    drop(child.stdout.take());
    assert_eq!(child.wait().unwrap().code(), Some(0));
}

#[cfg(unix)]
#[test]
fn ctrl_c_stops_cleanly() {
    use std::process::Command;
    use std::time::{Duration, Instant};
    let rules = "Lot --> R(60)\nR(n) --> case n > 0 : R(n - 1) R(n - 1) else : NIL";
    let bench = Bench::two_lots(rules).with("old.svg", "old");
    let arguments = "derive two.geojson --rules rules.cga --limit-shapes 4000000000 -o old.svg -o new.svg";
    let child = bench.command(&arguments.split(' ').collect::<Vec<_>>()).spawn().unwrap();
    std::thread::sleep(Duration::from_secs(2));
    let begun = Instant::now();
    let killed = Command::new("kill").args(["-INT", &child.id().to_string()]).status().expect("kill");
    assert!(killed.success());
    let ran = crate::bench::Ran::of(child.wait_with_output().unwrap());
    assert!(begun.elapsed() < Duration::from_secs(30), "it stops soon");
    ran.ends(130).says(&["stopped: nothing is written"]);
    assert_eq!((bench.text("old.svg"), bench.names().len()), ("old".into(), 3), "{:?}", bench.names());
}
