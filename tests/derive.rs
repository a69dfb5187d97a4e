//! What users rely on whatever the rules and layouts are: parts sum to the whole, threads change nothing, an edit stays
//! where it is made, and no input panics.

#[path = "common/place.rs"]
mod place;
#[path = "common/polygons.rs"]
mod polygons;

use bosquet::check::{Program, check};
use bosquet::derive::{Limits, Options, Progress, derive, recorded};
use bosquet::diag::Diagnostic;
use bosquet::element::Catalogue;
use bosquet::geometry::{Area, Polygon};
use bosquet::layout::{Layout, read_geojson};
use bosquet::seed::Seed;
use bosquet::shape::{Derivation, Outcome};
use bosquet::trace::{TreeOptions, lot_text, tree_text};
use bosquet::value::Value;
use bosquet::world::MemoryWorld;
use glam::DVec2;
use proptest::prelude::*;

/// What fails is shown; it becomes a section of the suite rather than a file of seeds.
fn cases(count: u32) -> ProptestConfig {
    ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(count) }
}

/// Rules checked from text.
fn program(rules: &str) -> (Program, Vec<Diagnostic>) {
    check(&MemoryWorld::default().with("main.cga", rules), "main.cga")
}

fn sound(rules: &str) -> Program {
    let (program, diagnostics) = program(rules);
    assert!(!diagnostics.iter().any(Diagnostic::is_error), "{diagnostics:?}");
    program
}

/// Limits that keep a test short.
fn small() -> Limits {
    Limits { depth: 200, shapes: 20_000, children: 2_000, ..Limits::default() }
}

fn run(program: &Program, layout: &Layout) -> (Derivation, Vec<Diagnostic>) {
    let world = MemoryWorld::default();
    let (catalogue, limits) = (Catalogue::built_in(), small());
    let options = Options { start: None, seed: Seed(3), set: Vec::new(), catalogue, world: &world, limits };
    derive(program, layout, &options, &Progress::default())
}

/// The outcome of one lot.
fn outcome(rules: &str, polygon: Polygon) -> Outcome {
    let layout = place::layout(vec![place::region("lot", polygon)], Vec::new());
    let (mut derivation, _) = run(&sound(rules), &layout);
    derivation.lots.remove(0).outcome
}

fn areas(outcome: &Outcome) -> f64 {
    outcome.leaves.iter().map(|leaf| leaf.shape.measure().area).sum()
}

/// Splits, setbacks, offsets: nothing of a lot is lost and nothing is there twice.
const DIVISIONS: &[&str] = &[
    "Lot --> split(x) { 3 : A. | '0.25 : B. | ~1 : C. | ~2 : D. }",
    "Lot --> split(z) { ~4 : A. }*",
    "Lot --> split(x, noAdjust) { 2.5 : A. }*",
    "Lot --> split(z, noAdjust) { 1 : A. | { ~2 : B. | 0.7 : C. }* | 1 : D. }",
    "Lot --> split(x) { ~5 : split(z) { ~5 : setback(0.4) { all : A. | remainder : B. } }* }*",
    "Lot --> setback(0.8) { front : A. | left = B. | remainder : C. }",
    "Lot --> setback(1.5) { all : A. | remainder : B. }",
    "Lot --> setback(1.5) { border = A. | remainder : setback(0.5) { all = B. | remainder : C. } }",
    "Lot --> offset(-1.3)",
    "Lot --> [ offset(-1.3, inside) A. ] offset(-1.3, border) B.",
    "Lot --> offset(-1) comp(f) { inside : A. | border : B. }",
    "Lot --> alignScopeToAxes split(x) { ~3 : r(0, 30, 0) alignScopeToAxes(world.xyz) split(z) { ~3 : A. }* }*",
];

proptest! {
    #![proptest_config(cases(48))]

    #[test]
    fn parts_sum_to_the_whole(polygon in polygons::polygon(), division in 0..DIVISIONS.len()) {
        let (rules, whole) = (DIVISIONS[division], polygon.area());
        let outcome = outcome(rules, polygon);
        prop_assert!(outcome.diagnostics.is_empty(), "{:?}", outcome.diagnostics);
        let slack = 1e-6 * whole + 1e-5 * outcome.leaves.len() as f64;
        prop_assert!((areas(&outcome) - whole).abs() < slack, "{rules}: {} of {whole}", areas(&outcome));
    }

    #[test]
    fn faces_cover_the_surface_and_floors_fill_the_volume(polygon in polygons::polygon(), height in 0.5..20.0f64) {
        let (area, perimeter) = (polygon.area(), polygon.perimeter());
        let faces = outcome(&format!("Lot --> extrude({height}) comp(f) {{ all : A. }}"), polygon.clone());
        let surface = 2.0 * area + perimeter * height;
        prop_assert!((areas(&faces) - surface).abs() < 1e-6 * surface, "{} of {surface}", areas(&faces));
        let floors = outcome(&format!("Lot --> extrude({height}) split(y) {{ 1 : split(x) {{ '0.3 : A. }}* }}*"), polygon);
        let volume: f64 = floors.leaves.iter().map(|leaf| leaf.shape.measure().volume).sum();
        prop_assert!((volume - area * height).abs() < 1e-6 * area * height, "{volume} of {}", area * height);
    }

    #[test]
    fn strips_stay_where_they_were(area in prop_oneof![polygons::area(), polygons::convex().prop_map(Area::from)]) {
        let polygon = area.polygons()[0].clone();
        let layout = place::layout(vec![place::region("lot", polygon.clone())], Vec::new());
        let (derivation, _) = run(&sound("Lot --> setback(1) { all : A. | remainder : B. }"), &layout);
        let bounds = polygon.bounds().grown(1e-5);
        for leaf in &derivation.lots[0].outcome.leaves {
            let found = leaf.shape.footprint().extent.bounds();
            prop_assert!(found.min.cmpge(bounds.min).all() && found.max.cmple(bounds.max).all(), "{found:?}");
        }
    }
}

/// Trees that look at each other, chance, points, solids: whatever a thread could disturb.
const GARDEN: &str = r#"
attr spacing = rand(2, 4)
Lot --> setback(1) { all : Hedge | remainder : Rest }
Hedge --> extrude(rand(1, 2)) Kind
Kind --> 50% : Box. else : Yew.
Rest --> split(x) { ~spacing : Bed }*
Bed --> scatter(surface, 6, uniform) { Tree } Lawn.
Tree --> case overlaps(intra) : NIL else : I(birch, young, rand(7))
"#;

fn city(count: usize) -> Vec<bosquet::layout::Region> {
    let lot = |i: usize| {
        let corner = DVec2::new((i % 5) as f64 * 22.0, (i / 5) as f64 * 17.0);
        let polygon = Polygon::rectangle(corner, corner + DVec2::new(20.0 + (i % 3) as f64 * 0.5, 15.0));
        place::region(&format!("lot{i}"), polygon.expect("a rectangle"))
    };
    (0..count).map(lot).collect()
}

fn garden() -> Program {
    sound(GARDEN)
}

#[test]
fn threads_change_nothing() {
    let (program, layout) = (garden(), place::layout(city(20), Vec::new()));
    let with = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build().expect("threads");
        pool.install(|| tree_text(&run(&program, &layout).0, &TreeOptions::default()))
    };
    let one = with(1);
    assert!(one.lines().count() > 500, "the garden is not bare");
    assert_eq!(one, with(2));
    assert_eq!(one, with(7));
}

#[test]
fn a_record_changes_nothing_and_lacks_nothing() {
    let (program, layout) = (garden(), place::layout(city(6), Vec::new()));
    let world = MemoryWorld::default();
    let options = Options {
        start: None,
        seed: Seed(1),
        set: Vec::new(),
        catalogue: Catalogue::built_in(),
        world: &world,
        limits: Limits::default(),
    };
    let (plain, _) = derive(&program, &layout, &options, &Progress::default());
    let (mut with, _) = recorded(&program, &layout, &options, &Progress::default(), &[0, 1, 2, 3, 4, 5]);
    for outcome in with.lots.iter_mut().map(|lot| &mut lot.outcome) {
        let record = outcome.record.take().expect("a record");
        assert_eq!((record.shapes.len(), record.leaves.len()), (outcome.nodes.len(), outcome.leaves.len()));
        let silent = record.shapes.iter().skip(1).filter(|passage| passage.trail.is_empty()).count();
        assert!(silent < record.shapes.len() / 2, "most shapes come out of blocks: {silent}");
    }
    let options = TreeOptions::default();
    assert_eq!(tree_text(&plain, &options), tree_text(&with, &options));
    assert!(plain.lots.iter().all(|lot| lot.outcome.record.is_none()));
}

#[test]
fn an_edit_in_one_lot_leaves_the_others_alone() {
    let program = garden();
    let lots = |regions| {
        let (derivation, _) = run(&program, &place::layout(regions, Vec::new()));
        let text = |lot| lot_text(&derivation, lot, &TreeOptions::default());
        derivation.lots.iter().map(|lot| (lot.id.to_string(), text(lot))).collect::<Vec<_>>()
    };
    let before = lots(city(12));
    let mut edited = city(12);
    edited[4].attributes.insert("spacing".into(), Value::Float(5.0));
    edited.remove(7);
    let after = lots(edited);
    let changed = |id: &str| before.iter().find(|(i, _)| i == id) != after.iter().find(|(i, _)| i == id);
    assert!(changed("lot4") && changed("lot7"), "the edit has shown");
    let others = (0..12).filter(|i| ![4, 7].contains(i)).map(|i| format!("lot{i}"));
    others.for_each(|id| assert!(!changed(&id), "{id} has changed"));
}

#[test]
fn one_more_tree_moves_none() {
    let layout = place::layout(city(1), Vec::new());
    let points = |count: usize| {
        let rules =
            format!("Lot --> scatter(surface, {count}, uniform) {{ Tree }} NIL\nTree --> I(birch, adult, rand(7))");
        tree_text(&run(&sound(&rules), &layout).0, &TreeOptions::default())
            .lines()
            .map(str::to_string)
            .collect::<Vec<_>>()
    };
    let (ten, eleven) = (points(10), points(11));
    assert_eq!(ten[..], eleven[..ten.len()]);
    assert_eq!(eleven.len(), ten.len() + 2);
}

/// Words and signs of the language, to make soups that get far.
const WORDS: &[&str] = &[
    "Lot",
    "-->",
    "~>",
    "split",
    "(",
    ")",
    "{",
    "}",
    "|",
    ":",
    "x",
    "3",
    "'0.5",
    "~1",
    "1r",
    "*",
    "A",
    ".",
    "comp",
    "f",
    "setback",
    "remainder",
    "all",
    "=",
    "extrude",
    "case",
    "else",
    "30",
    "%",
    "attr",
    "a",
    "const",
    "\"t\"",
    "import",
    "NIL",
    "[",
    "]",
    ",",
    "-",
    "+",
    "/",
    "rand",
    "scope.sx",
    "scatter",
    "surface",
    "uniform",
    "t",
    "s",
    "r",
    "center",
    "xz",
    "Distr",
    "I",
    "birch",
    "adult",
    "i",
    "bench",
    "offset",
    "inside",
    "set",
    "material.name",
    "label",
    "report",
    "overlaps",
    "intra",
    "==",
    "<",
    "&&",
    "!",
    "e",
    "v",
    "Subdiv",
    "Repeat",
    "1e999",
    "0",
    "-1",
    "@Zone",
    "start",
    "\n",
    "without",
    "primitiveSphere",
    "primitiveCube",
    "with",
    ":=",
    "[",
    "]",
    ".+",
    "comp",
    "style",
    "extends",
    "extension",
    "version",
    "alignScopeToAxes",
    "color",
    "print",
];

proptest! {
    #![proptest_config(cases(300))]

    #[test]
    fn any_rules_are_survived(words in prop::collection::vec(0..WORDS.len(), 0..60)) {
        let soup: Vec<&str> = words.iter().map(|word| WORDS[*word]).collect();
        survives(soup.join(" ").as_bytes());
        survives(format!("Lot --> {}", soup.join(" ")).as_bytes());
    }

    #[test]
    fn any_bytes_are_survived(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        survives(&bytes);
        let (layout, _) = read_geojson("soup.geojson", &bytes);
        run(&garden(), &layout);
    }

    #[test]
    fn any_argument_is_survived(call in 0..CALLS.len(), a in number(), b in number(), c in number()) {
        let fill = |n: f64| if n.is_nan() { "sqrt(-1)".into() } else if n.is_infinite() { "(1 / 0)".into() } else { format!("({n:?})") };
        let call = CALLS[call].replace("$a", &fill(a)).replace("$b", &fill(b)).replace("$c", &fill(c));
        survives(format!("Lot --> [ {call} A. ] [ extrude(2) {call} A. ] [ comp(e) {{ 0 : {call} A. }} ] s(0, 0, 0) {call} A.").as_bytes());
    }
}

/// Every operation that takes numbers.
const CALLS: &[&str] = &[
    "print([$a : $b : $c])",
    "print([1, 2; 3, 4][$a, [$b, $c]] .* [$a, $b])",
    "print(comp(e) { $a : $b | scope.sx > $c = $a | all : $c }[$a : $b])",
    "split(x) { $a : A. | '$b : A. | ~$c : A. }",
    "split(z) { $a : A. | ~$b : A. }*",
    "split(y) { '$a : A. | { ~$b : A. | $c : A. }* }",
    "comp(f) { $a : A. | all : A. }",
    "setback($a) { all : A. | remainder : A. }",
    "setback($a) { front = A. | remainder : offset($b) A. }",
    "offset($a) comp(f) { border : A. | inside : A. }",
    "without(\"building\", $a)",
    "scatter(surface, $a, gaussian, front, $b) { A. }",
    "scatter(scope, $a, gaussian, center, '$b) { A. }",
    "Distr($a, $b) { A. }",
    "extrude($a) comp(f) { top : extrude($b) A. | side : split(x) { '$c : A. }* }",
    "s($a, $b, $c) i(\"bench\")",
    "s('$a, '$b, '$c) t($a, '$b, $c) primitiveCube",
    "r($a, $b, $c) alignScopeToAxes split(x) { 2 : A. }*",
    "r(scopeCenter, $a, $b, $c) extrude(world.up, $a) split(y) { 1 : A. }*",
    "primitiveDisk($a, $b) extrude($c)",
    "primitiveCylinder($a, $b, $c) split(x) { 1 : A. }*",
    "primitiveSphere($a, $b, $c) comp(v) { all : A. }",
    "I(birch, adult, $a) center(xyz)",
    "color($a, $b, $c) set(material.opacity, $a) set(seedian, $b)",
];

fn number() -> impl Strategy<Value = f64> {
    let odd =
        [0.0, -0.0, 1.0, -1.0, 0.5, 3.0, 1e-12, 1e-300, 1e300, -1e300, 1e9, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    prop_oneof![prop::sample::select(odd.to_vec()), -10.0..50.0f64]
}

/// Check and derivation end, whatever is said.
fn survives(rules: &[u8]) {
    let (program, diagnostics) = check(&MemoryWorld::default().with("main.cga", rules), "main.cga");
    let ring = [[0.0, 0.0], [12.0, 1.0], [10.0, 7.0], [5.0, 4.0], [1.0, 8.0]].map(DVec2::from);
    let statements = ["feature building 2,2 4,2 4,4 2,4 height=5"];
    let features = place::parse(&statements).expect("a feature").features;
    let polygon = Polygon::new(&ring, &[]).expect("a ring");
    let layout = place::layout(vec![place::region("lot", polygon)], features);
    let (derivation, derived) = run(&program, &layout);
    tree_text(&derivation, &TreeOptions::default());
    let all = diagnostics.iter().chain(&derived);
    all.for_each(|d| assert!(!d.message.is_empty() && !d.message.ends_with('.'), "{}", d.message));
}

#[test]
fn what_grows_without_end_is_stopped() {
    let layout = place::layout(city(1), Vec::new());
    let rules = [
        "Lot --> Lot",
        "Lot --> [ Lot ] Lot",
        "Lot --> split(x) { '0.5 : Lot | '0.5 : Lot }",
        "Lot --> scatter(surface, 2, uniform) { Lot } Lot",
        "Lot --> split(x) { 0.0001 : A. }*",
        "Lot --> Distr(1e6) { A. }",
        "f(x) = f(x)\nLot --> extrude(f(1)) A.",
        "Lot ~> Lot : 0.5\nLot ~> Lot : 0.5",
    ];
    for rules in rules {
        let (_, diagnostics) = run(&sound(rules), &layout);
        assert!(diagnostics.iter().any(Diagnostic::is_error), "{rules} is not stopped");
    }
}

#[test]
fn long_rows_of_definitions_do_not_take_the_stack() {
    let chain = |n: usize| (0..n).map(|i| format!("attr a{i} = a{} + 1\n", i + 1)).collect::<String>();
    survives(format!("{}attr a20000 = 1\nLot --> split(x) {{ a0 : A. }}", chain(20_000)).as_bytes());
    let functions: String = (0..20_000).map(|i| format!("f{i}(x) = f{}(x) + 1\n", i + 1)).collect();
    survives(format!("{functions}f20000(x) = x\nattr b = f0(1)\nLot --> print(b) A.").as_bytes());
    let parts: Vec<String> = (0..70_000).map(|i| format!("1 : A{i}.")).collect();
    survives(format!("Lot --> split(x) {{ {} }}", parts.join(" | ")).as_bytes());
    let attributes: String = (0..70_000).map(|i| format!("attr a{i} = {i}\n")).collect();
    survives(format!("{attributes}Lot --> print(a69999) A.").as_bytes());
}

#[test]
fn deep_nests_fit_the_stack() {
    for (open, close) in
        [("[ ", " ]"), ("split(x) { '1 : ", " }"), ("case 1 < 2 : ", " else : B."), ("50% : ", " else : B.")]
    {
        for depth in [100, 240, 500, 5_000] {
            survives(format!("Lot --> {}A.{}", open.repeat(depth), close.repeat(depth)).as_bytes());
        }
    }
}

#[test]
fn deep_calls_fit_a_small_stack() {
    let deep = format!("f(x) = {}f(x + 1){}\nLot --> print(f(1)) A.", "(1 + ".repeat(120), ")".repeat(120));
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(1 << 20).build().expect("a thread");
    let program = sound(&deep);
    let layout = place::layout(city(1), Vec::new());
    let (_, diagnostics) = pool.install(|| run(&program, &layout));
    assert!(diagnostics.iter().any(|d| d.message.contains("`calls`")), "{diagnostics:?}");
}
