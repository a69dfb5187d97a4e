//! `bosquet check`: for people and for machines.

use crate::bench::Bench;
use serde_json::{Value, json};

fn records(bench: &Bench, files: &str, code: i32) -> Vec<Value> {
    let ran = bench.bosquet(&format!("check --format json {files}")).ends(code);
    assert!(ran.err.is_empty(), "{ran:?}");
    serde_json::from_str(&ran.out).expect("an array")
}

#[test]
fn a_good_file_has_an_empty_array() {
    let bench = Bench::garden();
    assert_eq!(records(&bench, "garden/garden.cga", 0), Vec::<Value>::new());
    bench.bosquet("check garden/garden.cga").ends(0).says(&["1 file, 4 rules: nothing to report"]);
}

#[test]
fn a_record_has_these_fields() {
    let bench = Bench::new().with("a.cga", "Lot -->\n  extrud(3) Grün.");
    let wanted = json!({
        "severity": "error", "code": "unknown-name", "message": "there is no operation or rule `extrud`",
        "file": "a.cga", "start": 10, "end": 16, "line": 2, "column": 3, "hints": ["did you mean `extrude`?"],
    });
    assert_eq!(records(&bench, "a.cga", 1)[0], wanted);
}

#[test]
fn offsets_lead_into_the_original_bytes_and_columns_count_characters() {
    let utf8 = "// Allée\r\n/* é */ Lot --> extrud(3) X.".as_bytes();
    let windows = b"// All\xe9e\r\n/* \xe9\xe9 */ Lot --> extrud(3) X.";
    let marked = [b"\xef\xbb\xbf".as_slice(), b"Lot -->\r\n\r\n\textrud(3) X."].concat();
    for (bytes, line, column) in [(utf8, 2, 17), (windows.as_slice(), 2, 18), (&marked, 3, 2)] {
        let bench = Bench::new().with("a.cga", bytes);
        let records = records(&bench, "a.cga", 1);
        let record = records.iter().find(|r| r["message"].as_str().is_some_and(|m| m.contains("extrud"))).expect("one");
        let at = |key: &str| record[key].as_u64().expect("a number") as usize;
        assert_eq!(&bytes[at("start")..at("end")], b"extrud", "{record}");
        assert_eq!((at("line"), at("column")), (line, column), "{record}");
    }
}

#[test]
fn several_mistakes_in_several_files_are_all_told() {
    let bench = Bench::new()
        .with("a.cga", "Lot --> split(x) { 1 : A. | 2 B. }\nA --> extrude( B.\nC --> colour(\"red\") D.")
        .with("b.cga", "attr a = \nLot --> Lawn")
        .with("c.cga", "Lot --> Lawn");
    let found = records(&bench, "a.cga b.cga c.cga", 1);
    let of = |file: &str| found.iter().filter(|r| r["file"] == file).count();
    assert!(of("a.cga") >= 3 && of("b.cga") == 1 && of("c.cga") == 0, "{found:#?}");
    let syntax = found.iter().filter(|r| r["code"].as_str().is_some_and(|c| c.starts_with("syntax")));
    assert!(syntax.count() >= 3, "{found:#?}");
    let ran = bench.bosquet("check a.cga b.cga c.cga").ends(1);
    ran.says(&["--> a.cga:1:", "--> b.cga:1:", "^", "did you mean `color`?", "errors"]);
}

#[test]
fn mistakes_in_an_import_point_into_that_file() {
    let bench =
        Bench::new().with("a.cga", "import b : \"sub/b.cga\"\nLot --> b.B").with("sub/b.cga", "\nB --> extrud(1) X.");
    let found = records(&bench, "a.cga", 1);
    assert_eq!((&found[0]["file"], &found[0]["line"]), (&json!("sub/b.cga"), &json!(2)));
}

#[test]
fn lints_alone_pass() {
    let bench = Bench::new().with("a.cga", "Lot --> Nowhere");
    assert_eq!(records(&bench, "a.cga", 0)[0]["severity"], "warning");
}

#[test]
fn what_is_no_file_is_an_error() {
    let bench = Bench::new().with("folder/x", "");
    for file in ["missing.cga", "folder"] {
        let found = records(&bench, file, 1);
        assert_eq!((&found[0]["code"], &found[0]["file"]), (&json!("file"), &json!(file)));
    }
    bench.bosquet("check").ends(2);
}

#[test]
fn imports_in_a_circle_are_told_with_the_way_round() {
    let bench = Bench::new()
        .with("a.cga", "import b : \"b.cga\"\nLot --> Lawn")
        .with("b.cga", "import a : \"a.cga\"\nB --> Lawn");
    bench.bosquet("check a.cga").ends(1).says(&["a.cga → b.cga → a.cga", "--> b.cga:1:12"]);
}

#[test]
fn long_chains_do_not_exhaust_the_stack() {
    let chain: String = (0..20_000).map(|i| format!("attr a{i} = a{}\n", i + 1)).collect();
    let bench = Bench::new().with("a.cga", chain + "attr a20000 = 1\nLot --> Lawn");
    bench.bosquet("check a.cga").ends(0);
}
