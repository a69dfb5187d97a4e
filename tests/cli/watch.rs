//! `bosquet derive --watch`: a real process, edits, and what it writes.

use crate::bench::{Bench, Ran};
use std::io::{BufRead, BufReader};
use std::process::Child;
use std::sync::mpsc::{Receiver, channel};
use std::time::{Duration, Instant};

/// A run that watches, and the lines that it says.
struct Watching {
    child: Child,
    lines: Receiver<String>,
    heard: Vec<String>,
}

impl Watching {
    fn new(bench: &Bench, line: &str) -> Watching {
        let mut child = bench.command(&line.split(' ').collect::<Vec<_>>()).spawn().expect("the command starts");
        let (sender, lines) = channel();
        let said = BufReader::new(child.stderr.take().expect("standard error"));
        std::thread::spawn(move || said.lines().map_while(Result::ok).for_each(|line| drop(sender.send(line))));
        Watching { child, lines, heard: Vec::new() }
    }

    /// The line of the run number `run`.
    fn run(&mut self, run: usize) -> String {
        let (begun, start) = (Instant::now(), format!("{run}: "));
        while begun.elapsed() < Duration::from_secs(60) {
            let Ok(line) = self.lines.recv_timeout(Duration::from_millis(500)) else { continue };
            self.heard.push(line.clone());
            if line.starts_with(&start) {
                return line;
            }
        }
        panic!("run {run} does not come: {:#?}", self.heard);
    }
}

/// Puts a file in the place of another at once, as editors do: a half written one would be a run more.
fn edit(bench: &Bench, path: &str, text: &str) {
    let beside = bench.path("edited");
    std::fs::write(&beside, text).expect("a file");
    std::fs::rename(beside, bench.path(path)).expect("its place");
}

impl Drop for Watching {
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

#[cfg(unix)]
#[test]
fn edits_are_derived_and_errors_keep_what_was_there() {
    let bench = Bench::garden();
    let rules = bench.text("garden/garden.cga");
    let mut watching = Watching::new(&bench, "derive garden --watch -o a.svg -o plants:b.csv");
    let first = watching.run(1);
    assert!(first.contains("1 region") && first.ends_with("wrote a.svg, b.csv"), "{first}");
    let (plan, plants) = (bench.bytes("a.svg"), bench.bytes("b.csv"));

    // Another height of the hedge is no other plan, and no other tree.
    edit(&bench, "garden/garden.cga", &rules.replace("hedge_height = 1.2", "hedge_height = 1.3"));
    let second = watching.run(2);
    assert!(second.starts_with("2: garden/garden.cga changed: "), "{second}");
    assert_eq!(bench.bytes("b.csv"), plants);

    edit(&bench, "garden/garden.cga", &rules.replace("extrude", "extrud"));
    let third = watching.run(3);
    assert!(third.contains("1 error in ") && third.ends_with("nothing is written"), "{third}");
    assert!(watching.heard.iter().any(|line| line.contains("did you mean `extrude`?")), "{:#?}", watching.heard);
    assert_eq!(bench.bytes("b.csv"), plants, "the last good outputs stay");

    edit(&bench, "garden/bosquet.toml", "layout = \"lot.geojson\"\nrules = \"garden.cga\"\nseed = 5\n");
    let fourth = watching.run(4);
    assert!(fourth.contains("garden/bosquet.toml changed") && fourth.contains("1 error"), "{fourth}");

    edit(&bench, "garden/garden.cga", &rules);
    let fifth = watching.run(5);
    assert!(fifth.contains("wrote a.svg, b.csv"), "another seed, other trees: {fifth}");
    assert!(bench.bytes("a.svg") != plan && bench.bytes("b.csv") != plants);

    let killed = std::process::Command::new("kill").args(["-INT", &watching.child.id().to_string()]).status();
    assert!(killed.expect("kill").success());
    assert_eq!(watching.child.wait().expect("it ends").code(), Some(0), "Ctrl-C is how it ends");
}

#[test]
fn an_import_that_is_not_there_yet_is_waited_for() {
    let bench = Bench::two_lots("import more : \"more.cga\"\nLot --> more.Inside");
    let mut watching = Watching::new(&bench, "derive two.geojson --rules rules.cga --watch -o a.svg");
    assert!(watching.run(1).ends_with("nothing is written"));
    edit(&bench, "more.cga", "Inside --> Lawn");
    let second = watching.run(2);
    assert!(second.contains("more.cga changed") && second.ends_with("wrote a.svg"), "{second}");
    assert!(bench.has("a.svg"));
}

#[test]
fn a_new_file_that_a_search_finds_is_a_change() {
    let rules = "Lot --> print(size(filesSearch(\"trees/*.txt\"))) Lawn";
    let bench = Bench::two_lots(rules).with("trees/oak.txt", "").with("trees/old/elm.txt", "");
    bench.derive_two("-o a.svg -o report:r.json").ends(0);
    let inputs = bench.json("r.json")["inputs"].to_string();
    assert!(inputs.contains("\"./\""), "the listing is an input: {inputs}");
    let mut watching = Watching::new(&bench, "derive two.geojson --rules rules.cga --watch -o a.svg");
    assert!(watching.run(1).ends_with("nothing new"));
    edit(&bench, "trees/lime.txt", "");
    let second = watching.run(2);
    assert!(second.contains("./ changed"), "{second}");
    edit(&bench, "trees/old/ash.txt", "");
    assert!(watching.run(3).contains("./ changed"), "folders inside are watched too");
}

#[test]
fn wrong_usage_ends_at_once() {
    let bench = Bench::garden();
    bench.bosquet("derive garden --watch -o plan.doc").ends(2).says(&[".doc"]);
    let ran: Ran = bench.bosquet("derive nowhere --watch").ends(2);
    ran.says(&["there is no file or folder `nowhere`"]);
}
