//! `bosquet fmt`: in place, as a check, and as a filter.

use crate::bench::Bench;
use std::io::Write;
use std::process::Stdio;

const RAGGED: &str = "Lot-->color( \"#fff\" )   Lawn // c\n";
const EVEN: &str = "Lot --> color(\"#fff\") Lawn // c\n";

#[test]
fn files_are_replaced_and_folders_walked() {
    let bench = Bench::new().with("a.cga", RAGGED).with("in/b.cga", RAGGED).with("in/c.txt", RAGGED);
    bench.bosquet("fmt a.cga in").ends(0).says(&["2 of 2 files laid out anew"]);
    for (file, text) in [("a.cga", EVEN), ("in/b.cga", EVEN), ("in/c.txt", RAGGED)] {
        assert_eq!(bench.text(file), text, "{file}");
    }
    bench.bosquet("fmt a.cga in").ends(0).says(&["0 of 2 files laid out anew"]);
}

#[test]
fn folders_of_other_tools_are_passed_over() {
    let kept = ["in/.git/a.cga", "in/.b.cga", "in/node_modules/c.cga", "in/target/d.cga"];
    let bench = kept.iter().fold(Bench::new().with("in/e.cga", RAGGED), |bench, file| bench.with(file, RAGGED));
    let bench = bench.with("in/target/CACHEDIR.TAG", "");
    bench.bosquet("fmt in").ends(0).says(&["1 of 1 file laid out anew"]);
    kept.iter().for_each(|file| assert_eq!(bench.text(file), RAGGED, "{file}"));
}

#[test]
fn a_check_names_the_files_and_changes_none() {
    let bench = Bench::new().with("a.cga", RAGGED).with("b.cga", EVEN);
    let ran = bench.bosquet("fmt --check a.cga b.cga").ends(1);
    assert_eq!(ran.out, "a.cga\n");
    assert_eq!(bench.text("a.cga"), RAGGED);
    bench.bosquet("fmt --check b.cga").ends(0);
}

#[test]
fn broken_files_are_told_and_left_alone() {
    let broken = "Lot --> split(x){ 1 : A\n";
    let bench = Bench::new().with("a.cga", broken).with("b.cga", RAGGED);
    bench.bosquet("fmt a.cga b.cga").ends(1).says(&["is never closed", "`a.cga` is left as it is"]);
    assert_eq!((bench.text("a.cga").as_str(), bench.text("b.cga").as_str()), (broken, EVEN));
    bench.bosquet("fmt missing.cga").ends(2).says(&["`missing.cga` cannot be read"]);
}

#[test]
fn a_dash_filters() {
    let bench = Bench::new();
    let filter = |text: &str| {
        let mut child = bench.command(&["fmt", "-"]).stdin(Stdio::piped()).spawn().expect("the command starts");
        child.stdin.take().expect("a pipe").write_all(text.as_bytes()).expect("a reader");
        child.wait_with_output().expect("an end")
    };
    let even = filter(RAGGED);
    assert_eq!((even.status.code(), String::from_utf8_lossy(&even.stdout).as_ref()), (Some(0), EVEN));
    let broken = filter("Lot -> A");
    assert_eq!((broken.status.code(), broken.stdout.len()), (Some(1), 0));
    assert!(String::from_utf8_lossy(&broken.stderr).contains("is no arrow"));
}
