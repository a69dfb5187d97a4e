//! Hostile bytes: truncated, mutated, random. Nothing panics, and what is told as an error does not end well.

use crate::bench::{Bench, Ran, TWO_LOTS, repository};
use proptest::prelude::*;

/// What may happen to a text.
#[derive(Clone, Debug)]
enum Damage {
    /// It ends early.
    Cut(prop::sample::Index),
    /// A byte is another.
    Byte(prop::sample::Index, u8),
    /// A stretch is gone.
    Gap(prop::sample::Index, usize),
    /// A stretch comes twice.
    Echo(prop::sample::Index, usize),
    /// A number, word or sign is in between.
    Graft(prop::sample::Index, &'static str),
}

const GRAFTS: &[&str] = &[
    "1e308",
    "-1e308",
    "NaN",
    "null",
    "\"",
    "'",
    "[",
    "{",
    "}}",
    "]]]]",
    "(",
    ":",
    "-->",
    "~>",
    "*",
    "0",
    "-1",
    "1e-320",
    "\u{0}",
    "\u{feff}",
    "é",
    "🌳",
    "99999999999999999999",
    "split(x) { ",
    "/*",
    "\r",
    "true",
    "case",
    "%",
    "^",
    "--",
    "import a : \"a\"\n",
];

fn damage() -> impl Strategy<Value = Damage> {
    let at = any::<prop::sample::Index>;
    prop_oneof![
        at().prop_map(Damage::Cut),
        (at(), any::<u8>()).prop_map(|(i, b)| Damage::Byte(i, b)),
        (at(), 1..60usize).prop_map(|(i, n)| Damage::Gap(i, n)),
        (at(), 1..60usize).prop_map(|(i, n)| Damage::Echo(i, n)),
        (at(), prop::sample::select(GRAFTS)).prop_map(|(i, g)| Damage::Graft(i, g)),
    ]
}

fn damaged(text: &[u8], damages: &[Damage]) -> Vec<u8> {
    let mut bytes = text.to_vec();
    for damage in damages.iter() {
        let length = bytes.len();
        let stretch = |at: usize, n: usize| at..(at + n).min(length);
        match damage {
            _ if length == 0 => {}
            Damage::Cut(at) => bytes.truncate(at.index(length)),
            Damage::Byte(at, byte) => bytes[at.index(length)] = *byte,
            Damage::Gap(at, n) => drop(bytes.drain(stretch(at.index(length), *n))),
            Damage::Echo(at, n) => {
                let stretch = stretch(at.index(length), *n);
                let again = bytes[stretch.clone()].to_vec();
                bytes.splice(stretch.start..stretch.start, again);
            }
            Damage::Graft(at, graft) => {
                let at = at.index(length);
                bytes.splice(at..at, graft.bytes());
            }
        }
    }
    bytes
}

fn damages() -> impl Strategy<Value = Vec<Damage>> {
    prop::collection::vec(damage(), 1..4)
}

/// Ends with 0, 1 or 2, and not well where it tells of an error.
fn is_orderly(ran: &Ran) -> Result<(), TestCaseError> {
    prop_assert!((0..=2).contains(&ran.code), "{:#?}", ran);
    let tells = ran.err.lines().any(|line| line.starts_with("error"));
    prop_assert_eq!(ran.code == 0, !tells, "{:#?}", ran);
    Ok(())
}

const LIMITS: &str = "--limit-shapes 20000 --limit-children 20000 --limit-depth 100 --limit-time 5";
const OUTPUTS: &str = "-o a.svg -o a.csv -o a.json -o a.geojson -o plants:p.csv";

fn example(path: &str) -> Vec<u8> {
    std::fs::read(repository(&format!("examples/versailles/{path}"))).expect(path)
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, max_shrink_iters: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_layouts(damages in damages()) {
        let bench = Bench::two_lots("Lot --> without(\"building\") setback(1) { all = Hedge. | remainder : Lawn }")
            .with("two.geojson", damaged(TWO_LOTS.as_bytes(), &damages));
        is_orderly(&bench.derive_two(&format!("{OUTPUTS} {LIMITS}")))?;
    }

    #[test]
    fn damaged_rules(which in 0..3usize, damages in damages()) {
        let names = ["versailles.cga", "parterre.cga", "bosquet.cga"];
        let mut bench = Bench::new().with("two.geojson", example("elsewhere/square.geojson"));
        for name in names {
            bench = bench.with(name, example(name));
        }
        let bench = bench.with(names[which], damaged(&example(names[which]), &damages));
        is_orderly(&bench.bosquet(&format!("derive two.geojson --rules versailles.cga -o a.json {LIMITS}")))?;
        let ran = bench.bosquet("check --format json versailles.cga");
        prop_assert!(serde_json::from_str::<Vec<serde_json::Value>>(&ran.out).is_ok(), "{:#?}", ran);
    }

    #[test]
    fn damaged_manifests(damages in damages()) {
        let manifest = "title = \"A\"\nlayout = \"lot.geojson\"\nrules = \"garden.cga\"\nseed = 3\n\
                        catalogues = []\noutputs = [\"a.svg\"]\n[attributes]\nhedge_height = 2\n\
                        [plan]\nscale = \"1:200\"\nrotation = 12.5\ncodes = true\n";
        let bench = Bench::garden().with("garden/bosquet.toml", damaged(manifest.as_bytes(), &damages));
        is_orderly(&bench.bosquet("derive garden -o a.svg"))?;
    }

    #[test]
    fn damaged_catalogues_and_models(which in 0..3usize, damages in damages()) {
        let bench = crate::models::bench();
        let path = ["more.toml", "models/seat.obj", "models/rock.glb"][which];
        let bytes = damaged(&bench.bytes(path), &damages);
        let bench = bench.with(path, bytes);
        is_orderly(&bench.derive_two(&format!("--catalogue more.toml {OUTPUTS} {LIMITS}")))?;
    }

    #[test]
    fn any_bytes_in_every_place(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        let bench = Bench::garden().with("any.cga", &bytes).with("any.geojson", &bytes).with("any.toml", &bytes);
        for line in [
            "derive any.geojson --rules any.cga -o a.svg",
            "derive garden --rules any.cga -o a.svg",
            "derive garden --catalogue any.toml -o a.svg",
            "check any.cga",
        ] {
            is_orderly(&bench.bosquet(line))?;
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, max_shrink_iters: 64, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_layout_of_versailles_damaged(damages in damages()) {
        let bytes = damaged(&example("elsewhere/square.geojson"), &damages);
        let (layout, found) = bosquet::layout::read_geojson("square.geojson", &bytes);
        prop_assert!(!layout.regions.is_empty() || !found.is_empty());
    }

    #[test]
    fn arguments_of_any_sort(values in prop::collection::vec("[-a-z0-9:=,.x/~é\"]{0,12}", 8)) {
        let flags = ["--scale", "--size", "--rotate", "--extent", "--set", "--seed", "-o", "--start"];
        let bench = Bench::garden();
        let which = values[0].len() % flags.len();
        let value = format!("{}={}", flags[which], values[which]);
        let value = if flags[which] == "-o" { format!("-o{}", values[which]) } else { value };
        let ran = bench.run(&["derive", "garden", &value, "-oa.svg"]);
        prop_assert!((0..=2).contains(&ran.code), "{:#?}", ran);
    }
}
