//! What editors are told, on files in memory: completions place by place, names across files, and any bytes at all.

use bosquet::element::Catalogue;
use bosquet::ide::{CompletionKind, Desk};
use bosquet::world::MemoryWorld;
use proptest::prelude::*;

/// A text without its cursor `‸`, and where that was.
fn cursor(text: &str) -> (String, usize) {
    let at = text.find('‸').expect("a cursor");
    (text.replace('‸', ""), at)
}

/// The labels of what could stand at the cursor of `a.cga`, beside `b.cga`.
fn offered(text: &str) -> Vec<String> {
    let (text, at) = cursor(text);
    let b = "@Range(0, 9)\nattr gap = 3\nRow(n) --> Lawn\nhalf(x) = x / 2\n";
    let world = MemoryWorld::default().with("a.cga", text).with("b.cga", b);
    let files = ["a.cga".to_string(), "b.cga".to_string()];
    let found = Desk::new(&world, Catalogue::built_in()).with_files(&files).completions("a.cga", at);
    found.into_iter().map(|completion| completion.label).collect()
}

fn offers(text: &str, wanted: &[&str], unwanted: &[&str]) {
    let found = offered(text);
    for label in wanted {
        assert!(found.iter().any(|f| f == label), "`{label}` is missing at {text:?}: {found:?}");
    }
    for label in unwanted {
        assert!(!found.iter().any(|f| f == label), "`{label}` is offered at {text:?}");
    }
}

#[test]
fn every_place_is_offered_what_can_stand_there() {
    offers("‸", &["attr", "import", "rule"], &["split", "rand"]);
    offers("Lot --> Lawn\n‸", &["attr", "split"], &["rand"]);
    offers("Lot --> ‸", &["split", "Lot", "NIL", "case", "Lawn"], &["attr", "rand", "front"]);
    offers("Lot --> [ ext‸ ]", &["extrude"], &["attr"]);
    offers("Bed(area) --> case ar‸", &["area", "rand", "geometry.area"], &["split"]);
    offers("Bed(area) --> case area > 2 : La‸", &["split", "Bed"], &["area"]);
    offers("attr w = ‸", &["rand", "true"], &["split"]);
    offers("attr w = 1\nf(x) = ‸", &["w", "x"], &["split"]);
    offers("Lot --> comp(f) { ‸", &["front", "object.front"], &["split"]);
    offers("Lot --> setback(2) { front : A | ‸ }", &["remainder", "side"], &["split"]);
    offers("Lot --> setback(2) { front : ‸ }", &["split"], &["remainder"]);
    offers("attr w = 1\nLot --> split(x) { ~‸ : A }", &["w", "scope.sx"], &["front", "extrude"]);
    offers("Lot --> split(x) { 1 : A | { ~1 : ‸ }* }", &["extrude"], &["front"]);
    offers("Lot --> boundary(‸", &["width =", "radius =", "rand"], &["split"]);
    offers("Lot --> boundary(width = ‸", &["rand"], &["width ="]);
    offers("Lot --> split(‸) { 1 : A }", &["x", "y", "z"], &[]);
    offers("Lot --> [ Distr(0.1, 0) { ‸ } ] B", &["I"], &["front"]);
    offers("Lot --> I(‸", &["birch"], &[]);
    offers("Lot --> I(birch, ‸", &["adult", "young"], &[]);
    offers("Lot --> plant(\"‸\")", &["Betula pendula"], &["split"]);
    offers("Lot --> plant(palette = ‸", &["temperate"], &[]);
    offers("Lot --> set(material.name, \"gra‸\") X.", &["gravel"], &["Betula pendula"]);
    offers("Lot --> label(\"pond\") A\nA --> without(\"‸\") B", &["pond", "building"], &[]);
    offers("attr r = species.crown(\"‸\", 30)", &["birch"], &["gravel"]);
    offers("@‸", &["Range", "Zone"], &["split"]);
    offers("import b : \"‸\"", &["b.cga", "bosquet:patterns/cluster.cga"], &["a.cga"]);
    offers("import b : \"b.cga\"\nLot --> b.‸", &["b.Row"], &["b.gap"]);
    offers("import b : \"b.cga\"\nattr w = b.‸", &["b.gap", "b.half"], &["b.Row"]);
    offers("import b : \"b.cga\" (‸", &["gap", "Row"], &["split"]);
    offers("import b : \"b.cga\" (gap = ‸", &["rand"], &["split"]);
}

#[test]
fn comments_and_numbers_are_offered_nothing() {
    for text in ["// Lot ‸", "Lot --> A # ‸", "/* ‸ */ Lot --> A", "/* ‸", "Lot --> split(x) { 3‸", "attr a = 2.‸"]
    {
        assert_eq!(offered(text), Vec::<String>::new(), "{text:?}");
    }
}

#[test]
fn a_call_that_is_there_already_keeps_its_parentheses() {
    let world = MemoryWorld::default().with("a.cga", "Lot --> spl(x) { 1 : A }");
    let found = Desk::new(&world, Catalogue::built_in()).completions("a.cga", 11);
    let split = found.iter().find(|c| c.label == "split").expect("split");
    assert_eq!((&*split.insert, split.kind, split.replaces.clone()), ("split", CompletionKind::Operation, 8..11));
}

/// Every file as its name and text, the names of one meaning marked by `‹…›` in one of them; the place asked is the first.
fn uses(marked: &[(&str, &str)]) {
    let plain = |text: &str| text.replace(['‹', '›'], "");
    let world = marked.iter().fold(MemoryWorld::default(), |world, (path, text)| world.with(*path, plain(text)));
    let files: Vec<String> = marked.iter().map(|(path, _)| (*path).to_string()).collect();
    let mut wanted = Vec::new();
    for (path, text) in marked {
        let mut before = 0;
        for (index, _) in text.match_indices('‹') {
            let start = index - before;
            let length = text[index..].find('›').expect("an end") - '‹'.len_utf8();
            wanted.push(((*path).to_string(), start, start + length));
            before += '‹'.len_utf8() + '›'.len_utf8();
        }
    }
    for (path, start, _) in &wanted {
        let desk = Desk::new(&world, Catalogue::built_in()).with_files(&files);
        let found = desk.references(path, *start);
        let found: Vec<_> = found.into_iter().map(|place| (place.path, place.start, place.end)).collect();
        assert_eq!(found, wanted, "asked at {path}:{start}");
    }
}

#[test]
fn names_are_told_apart() {
    uses(&[("a.cga", "attr ‹w› = 1\nf(w) = w\nLot --> extrude(‹w›) w(‹w›)\nB(w) --> extrude(w)\nw(x) --> Lawn\n")]);
    uses(&[(
        "a.cga",
        "attr w = 1\nf(w) = w\nLot --> extrude(w) ‹w›(w)\nB(w) --> [ ‹w›(2) ]\n‹w›(x) --> Lawn\n‹w› --> Lawn",
    )]);
    uses(&[(
        "a.cga",
        "attr w = 1\nB(‹w›) --> case ‹w› > 1 : extrude(‹w›) A else : ‹w›% : C else : D\nC --> t(w, 0, 0) E",
    )]);
    uses(&[("a.cga", "Lot --> boundary(width = 4) { ‹width› }\n‹width› --> Lawn\nattr width = 3")]);
    uses(&[(
        "a.cga",
        "Lot --> comp(f) { front : ‹front› | top = ‹front› | 0 : ‹front› }\n‹front› --> Lawn\nattr top = 1",
    )]);
    uses(&[("a.cga", "1: ‹Lot› ~> Subdiv(x, 1r, 2r) { A | ‹Lot› }\n2: ‹Lot› : w > 3 ~> A : 0.5\nattr w = 1")]);
}

#[test]
fn names_are_followed_through_imports() {
    let b = "attr gap = 3\n‹Row› --> split(x) { ~gap : Tree }*\n";
    uses(&[("a.cga", "import b : \"b.cga\" (‹Row› --> NIL)\nb.‹Row› --> Lawn\nLot --> b.‹Row› Row\n"), ("b.cga", b)]);
    let b = "attr ‹gap› = 3\nRow --> split(x) { ~‹gap› : Tree }*\n";
    uses(&[("a.cga", "import b : \"b.cga\"\nattr ‹gap› = 5\nLot --> t(b.‹gap›, ‹gap›, 0) b.Row\n"), ("b.cga", b)]);
    uses(&[("a.cga", "import b : \"b.cga\" (‹gap› = gap)\nattr gap = 5\nLot --> t(b.‹gap›, gap, 0)\n"), ("b.cga", b)]);
    uses(&[
        ("a.cga", "import b : \"b.cga\" ()\nattr gap = 5\nLot --> b(‹gap› = gap).Row t(gap, 0, 0)\n"),
        ("b.cga", b),
    ]);
    uses(&[
        ("a.cga", "import ‹b› : \"b.cga\"\nb --> ‹b›.Row ‹b›(gap = 1).Row\n"),
        ("b.cga", "attr gap = 3\nRow --> Lawn"),
    ]);
}

#[test]
fn an_attribute_is_shown_with_its_range_and_description() {
    let text = "// How high.\n@Range(min = 1, max = 3)\n@Description(\"Height of the hedge\")\nattr height = 2\nLot --> extrude(height)";
    let world = MemoryWorld::default().with("a.cga", text);
    let hover = Desk::new(&world, Catalogue::built_in()).hover("a.cga", text.len() - 3).expect("a page");
    for part in ["@Range(min = 1, max = 3)", "attr height = 2", "Height of the hedge", "How high."] {
        assert!(hover.text.contains(part), "`{part}` is missing: {}", hover.text);
    }
}

#[test]
fn every_operation_and_function_has_a_page() {
    let has_page = |text: String, at: usize| {
        let world = MemoryWorld::default().with("a.cga", &text);
        assert!(Desk::new(&world, Catalogue::built_in()).hover("a.cga", at).is_some(), "{text}");
    };
    bosquet::ops::OPERATIONS.iter().for_each(|o| has_page(format!("Lot --> {}", o.spec.name), 8));
    bosquet::functions::all().for_each(|f| has_page(format!("attr a = {}", f.name), 9));
}

#[test]
fn two_attributes_are_not_made_one() {
    let plants = "attr spacing = 3\nRow --> split(x) { ~spacing : Tree }*\n";
    let rename = |near: &str, asked: &str, word: &str, new: &str| {
        let world = MemoryWorld::default().with("plants.cga", plants).with("near.cga", near);
        let files = ["near.cga", "plants.cga"].map(String::from);
        let desk = Desk::new(&world, Catalogue::built_in()).with_files(&files);
        let text = if asked == "near.cga" { near } else { plants };
        desk.rename(asked, text.find(word).expect("the word"), new).map_err(|refusal| refusal.to_string())
    };
    let own = |parentheses: &str| format!("import p : \"plants.cga\" {parentheses}\nattr width = 5\nLot --> p.Row\n");
    let refusal = rename(&own(""), "plants.cga", "spacing", "width").expect_err("a refusal");
    assert!(refusal.contains("`near.cga`") && refusal.contains("`width`"), "{refusal}");
    let refusal = rename(&own(""), "near.cga", "width", "spacing").expect_err("a refusal");
    assert!(refusal.contains("`plants.cga`") && refusal.contains("`spacing`"), "{refusal}");
    for held in ["()", "(spacing)", "(spacing = 4)"] {
        assert!(rename(&own(held), "plants.cga", "spacing", "width").is_ok(), "{held} holds it back");
        assert!(rename(&own(held), "near.cga", "width", "spacing").is_ok(), "{held} holds it back");
    }
    assert!(rename(&own("(Row --> NIL)"), "plants.cga", "spacing", "width").is_err(), "a rule holds nothing back");
}

#[test]
fn the_library_is_not_renamed() {
    let text = "import edge : \"bosquet:patterns/boundary.cga\"\nLot --> edge.Planting";
    let world = MemoryWorld::default().with("a.cga", text);
    let desk = Desk::new(&world, Catalogue::built_in());
    let refusal = desk.rename("a.cga", text.len() - 2, "Strip").expect_err("a refusal");
    assert!(refusal.to_string().contains("library"), "{refusal}");
    assert_eq!(desk.rename("a.cga", 8, "border").expect("an alias").len(), 2);
}

/// Asks everything there is to ask at a byte.
fn ask_everything(text: &[u8], at: usize) {
    let world = MemoryWorld::default().with("a.cga", text);
    let files = ["a.cga".to_string()];
    let desk = Desk::new(&world, Catalogue::built_in()).with_files(&files);
    let length = desk.document("a.cga").expect("a document").text().len();
    let at = at % (length + 2);
    let inside = |start: usize, end: usize| assert!(start <= end && end <= length, "{start}..{end} of {length}");
    desk.completions("a.cga", at).iter().for_each(|c| inside(c.replaces.start, c.replaces.end));
    desk.hover("a.cga", at).iter().for_each(|h| inside(h.place.start, h.place.end));
    desk.signatures("a.cga", at);
    desk.definition("a.cga", at);
    let uses = desk.references("a.cga", at);
    uses.iter().for_each(|place| inside(place.start, place.end));
    if let Ok(renaming) = desk.renamable("a.cga", at) {
        assert!(uses.contains(&renaming.place), "{renaming:?} is not among its own uses {uses:?}");
    }
    desk.symbols("a.cga").iter().for_each(|s| inside(s.whole.start, s.whole.end));
    desk.folds("a.cga").iter().for_each(|f| inside(f.range.start, f.range.end));
    desk.swatches("a.cga").iter().for_each(|s| inside(s.range.start, s.range.end));
    let tints = desk.tints("a.cga");
    assert!(tints.windows(2).all(|pair| pair[0].range.end <= pair[1].range.start), "{tints:?}");
}

const WORDS: &[&str] = &[
    "Lot", "-->", "~>", "split", "(", ")", "{", "}", "[", "]", "x", "|", ":", "=", ",", "\"", "\"a\"", "attr", "a",
    "import", "b.c", "case", "else", "30", "%", "@", "Range", "with", ":=", "\n", ".", "~1", "'0.5", "comp", "front",
    "é", "🌳", "//", "/*", "*/", "style", "->", "#ff0000",
];

proptest! {
    #[test]
    fn any_words_are_survived(words in proptest::collection::vec(proptest::sample::select(WORDS), 0..60), at: usize) {
        ask_everything(words.join(" ").as_bytes(), at);
    }

    #[test]
    fn any_bytes_are_survived(bytes: Vec<u8>, at: usize) {
        ask_everything(&bytes, at);
    }
}
