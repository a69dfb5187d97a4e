//! Rule text → syntax tree: what users' files must go through, and what broken ones are told.

use bosquet::diag::{Diagnostic, Place};
use bosquet::syntax::ast::*;
use bosquet::syntax::{Source, parse};

const FILES: [&str; 3] =
    [include_str!("syntax/facade.cga"), include_str!("syntax/modern.cga"), include_str!("syntax/papers.cga")];

fn read(text: &str) -> (File, Vec<Diagnostic>) {
    parse(0, &Source::new("test.cga", text.as_bytes()))
}

fn show(text: &str, reports: &[Diagnostic]) -> String {
    let place = |r: &Diagnostic| match &r.place {
        Place::Rule(span) => format!("{:?}", &text[span.start as usize..span.end as usize]),
        other => format!("{other:?}"),
    };
    reports.iter().map(|r| format!("{} at {}: {} {:?}\n", r.code, place(r), r.message, r.hints)).collect()
}

#[test]
fn realistic_files_parse() {
    for text in FILES {
        let (file, reports) = read(text);
        assert!(reports.is_empty(), "{}", show(text, &reports));
        assert!(file.items.len() > 8);
    }
}

/// Offsets of `{ } ( | :` and `else` outside texts and comments, with their lengths.
fn signs(text: &str) -> Vec<(usize, usize)> {
    let (bytes, mut at, mut found) = (text.as_bytes(), 0, Vec::new());
    while at < bytes.len() {
        let rest = &text[at..];
        let skip = match bytes[at] {
            b'"' => rest[1..].find('"').map(|end| end + 2),
            b'#' => rest.find('\n'),
            b'/' if rest.starts_with("//") => rest.find('\n'),
            b'/' if rest.starts_with("/*") => rest.find("*/").map(|end| end + 2),
            b'{' | b'}' | b'(' | b'|' | b':' => {
                found.push((at, 1));
                None
            }
            b'e' if rest.starts_with("else") && !rest[4..].starts_with(char::is_alphanumeric) => {
                found.push((at, 4));
                None
            }
            _ => None,
        };
        at += skip.unwrap_or(1);
    }
    found
}

#[test]
fn a_forgotten_sign_is_reported_in_its_definition() {
    let (mut tried, mut missed) = (0, Vec::new());
    for text in FILES {
        let (file, _) = read(text);
        for (at, length) in signs(text) {
            let Some(item) = file.items.iter().find(|i| (i.span.start as usize..i.span.end as usize).contains(&at))
            else {
                continue;
            };
            let broken = format!("{}{}", &text[..at], &text[at + length..]);
            let (_, reports) = read(&broken);
            let inside = |r: &Diagnostic| match &r.place {
                Place::Rule(span) => item.span.start <= span.start && span.start <= item.span.end,
                _ => false,
            };
            tried += 1;
            if !reports.iter().any(inside) {
                let line = &broken[broken[..at].rfind('\n').map_or(0, |l| l + 1)..];
                missed.push(format!("{:?} before {}", &text[at..at + length], line.lines().next().unwrap_or("")));
            }
        }
    }
    let allowed = tried / 20;
    assert!(tried > 300 && missed.len() <= allowed, "{} of {tried} missed:\n{}", missed.len(), missed.join("\n"));
}

/// The reports of a broken text, code and first hint or message, and that the definition after it stands.
fn told(broken: &str) -> (String, String) {
    let text = format!("{broken}\nAfter --> B\n");
    let (file, reports) = read(&text);
    let errors: Vec<&Diagnostic> = reports.iter().collect();
    assert_eq!(errors.len(), 1, "{broken}\n{}", show(&text, &reports));
    let stands = matches!(&file.items.last().expect("an item").kind, ItemKind::Rule(r) if &*r.name.text == "After");
    assert!(stands, "{broken}: what follows is lost");
    let Place::Rule(span) = &errors[0].place else { panic!("no place") };
    let place = text[span.start as usize..span.end as usize].to_owned();
    (place, format!("{} | {} | {}", errors[0].code, errors[0].message, errors[0].hints.join("; ")))
}

#[test]
fn usual_mistakes_are_understood() {
    // What is written, where the report points, and what it must say.
    let table = [
        ("Lot -- > X", "-- >", "`Lot --> …`"),
        ("Lot -> X", "->", "`Lot --> …`"),
        ("Lot → X", "→", "`Lot --> …`"),
        ("Lot ~ > X", "~ >", "`~>`"),
        ("Lot extrude(3)", "Lot", "neither `-->` nor `=`"),
        ("Lot { extrude(3) }", "Lot", "neither `-->` nor `=`"),
        ("Lot(3) --> X", "3", "a name"),
        ("Lot(a b) --> X", "b", "`,`"),
        ("Lot --> extrude(3) case a : X else : Y", "case", "wrap the choice in brackets"),
        ("Lot --> extrude(3) 30% : X else : Y", "30", "wrap the choice in brackets"),
        ("Lot --> case a : X", "case", "no `else`"),
        ("Lot --> case a : [ case b : X ] else : Y", "case", "no `else`"),
        ("Lot --> 30% : X 20% : Y", "30", "no `else`"),
        ("Lot --> 30% X else : Y", "%", "no `:`"),
        ("Lot --> case a X else : Y", "case", "no `:`"),
        ("Lot --> case a : X else Y", "else", "`:` after `else`"),
        ("Lot --> X else : Y", "else", "no `case`"),
        ("Lot --> case a = 1 : X else : Y", "=", "`==`"),
        ("Lot --> case a & b : X else : Y", "&", "`&&`"),
        ("Lot --> case (a | b) : X else : Y", "|", "`||`"),
        ("Lot --> case a => b : X else : Y", "=>", "`>=`"),
        ("Lot --> t(0 1 0)", "1", "separated by commas"),
        ("Lot --> t(0; 1; 0)", ";", "separated by commas"),
        ("Lot --> X;", ";", "no sign at their end"),
        ("Lot --> X, Y", ",", "nothing between"),
        ("Lot --> if (a > 3) { X } else { Y }", "if", "write `case a : X"),
        ("Lot --> t(a > 3 ? 1 : 2, 0, 0)", "?", "`case a : b else : c`"),
        ("Lot --> color('red')", "'red'", "`\"red\"`"),
        ("Lot --> color(\"red)", "\"red)", "never closed"),
        ("Lot --> split(x){ 2 A | ~1 : B }", "2", "`:` is missing"),
        ("Lot --> split(x){ 2 : A 3 : B }", "3", "`|` is missing before `3`"),
        ("Lot --> split(x){ 2 : A | w B }", "w B", "no size"),
        ("Lot --> comp(f){ top : A side : B }", "side", "`|` is missing before `side`"),
        ("Lot --> comp(f){ top --> A | side --> B }", "-->", "in a block `:`"),
        ("Lot --> comp(f){ top : A | side : B", "{", "never closed"),
        ("Lot --> comp(f) top : A | side : B }", "}", "closes nothing"),
        ("Lot --> t(0, (1, 0) X", "(", "never closed"),
        ("Lot --> extrude(3m)", "3m", "units are not written"),
        ("Lot --> union { A }", "union { A }", "two operands"),
        ("Lot --> A{ 1 : B }*", "{ 1 : B }", "`*` repeats a split"),
        ("Lot --> A € B", "€", "means nothing"),
        ("import Parcel.cga", "import", "import plants : \"plants.cga\""),
        ("import \"x.cga\"", "import", "import plants : \"plants.cga\""),
        ("attr a =", "=", "found the end of the definition"),
        ("attr a", "a", "has no value"),
        ("attr a = true(1)", "true(1)", "takes no arguments"),
        ("attr a = 1e999", "1e999", "too large"),
        ("f(x) = 2 *", "*", "expected a value"),
        ("@Decription(\"x\")\nattr a = 1", "Decription", "did you mean `@Description`?"),
        ("@Startrule\nA --> B", "Startrule", "did you mean `@StartRule`?"),
        ("A ~> Subdiv(y, 1, 2, 3){ B | C }", "Subdiv(y, 1, 2, 3){ B | C }", "3 sizes for 2 parts"),
        ("A ~> Repeat(x, 2){ B | C }", "Repeat(x, 2){ B | C }", "one of each"),
        ("A ~> Comp(\"sidefaces2\"){ B }", "\"sidefaces2\"", "did you mean `sidefaces`?"),
        ("A --> plants(3).Tree", "3", "plants(name = value).Tree"),
        ("A --> f(1 + a = 3)", "1 + a", "`==` compares"),
        ("A --> [ X ] % : Y else : Z", "[ X ]", "before `% :` stands a percentage"),
    ];
    let mut wrong = 0;
    for (broken, place, says) in table {
        let (found, message) = told(broken);
        if found != place || !message.contains(says) {
            println!("{broken}\n   at {found:?}: {message}");
            wrong += 1;
        }
    }
    assert_eq!(wrong, 0);
}

#[test]
fn no_report_shouts() {
    for text in FILES {
        for (at, length) in signs(text) {
            for report in read(&format!("{}{}", &text[..at], &text[at + length..])).1 {
                let first = report.message.chars().next().expect("a message");
                assert!(!first.is_uppercase() && report.code.starts_with("syntax"), "{}", report.message);
            }
        }
    }
}

#[test]
fn unclosed_and_endless_nesting_ends_quickly() {
    let pieces = [
        "(",
        "f(",
        "{",
        "[",
        "case a:",
        "comp(f){",
        "split(x){",
        "10% :",
        "a{",
        "-",
        "!",
        "a+",
        "a[",
        "[a,",
        "'",
        "{ 1 :",
        "w% :",
        "f(x)% :",
        "comp(f){ top :",
        "case ",
        "else :",
        "(x",
        "a.b(",
        "imp(h=",
        "{a[",
        "inline ",
        "inline a[",
        "inline { ",
        "@A(",
        "x := ",
        "with(",
    ];
    for piece in pieces {
        for head in ["attr h = ", "A --> ", "A ~> ", "f(x) = ", "@R(", "import i : \"x\" (", "A with ( ", "A --> X{ "] {
            for count in [10, 30, 60, 250, 100_000] {
                let start = std::time::Instant::now();
                let (_, reports) = read(&format!("{head}{}", piece.repeat(count)));
                assert!(!reports.is_empty(), "{head}{piece} {count}");
                assert!(start.elapsed().as_millis() < 3000, "{head}{piece} {count}: {:?}", start.elapsed());
            }
        }
    }
}

#[test]
fn closed_nesting_is_bounded_and_quick() {
    let shapes = [
        ("(", "1", ")"),
        ("f(", "1", ")"),
        ("[", "1", "]"),
        ("case a : ", "1", " else : 1"),
        ("10% : ", "1", " else : 1"),
        ("-", "1", ""),
        ("", "1", "+1"),
        ("comp(f){ all : ", "1", " }"),
        ("a[", "1", "]"),
    ];
    for (open, middle, close) in shapes {
        for count in [20, 60, 120, 100_000] {
            let value = format!("{}{middle}{}", open.repeat(count), close.repeat(count));
            for text in [
                format!("attr a = {value}"),
                format!("A --> X({value})"),
                format!("A --> split(x){{ x[{value}] : B }}"),
            ] {
                let start = std::time::Instant::now();
                let (_, reports) = read(&text);
                let limit = reports.iter().any(|r| r.code == "syntax-limit");
                assert!(
                    if count > 120 { limit } else { reports.is_empty() },
                    "{open}{close} {count} {}",
                    show(&text, &reports[..1.min(reports.len())]).chars().take(300).collect::<String>()
                );
                assert!(start.elapsed().as_millis() < 3000, "{open} {count}: {:?}", start.elapsed());
            }
        }
    }
    let bodies = [
        ("[ ", "X", " ]"),
        ("X{ ", "X", " }"),
        ("split(x){ 1 : ", "X", " }"),
        ("case a : ", "X", " else : Y"),
        ("w% : ", "X", " else : Y"),
        ("inline { ", "X", " }"),
        ("case a : X else : ", "X", ""),
    ];
    for (open, middle, close) in bodies {
        for count in [20, 60, 120, 100_000] {
            let text = format!("A --> {}{middle}{}", open.repeat(count), close.repeat(count));
            let start = std::time::Instant::now();
            let (_, reports) = read(&text);
            let limit = reports.iter().any(|r| r.code == "syntax-limit");
            assert!(if count > 120 { limit } else { reports.is_empty() }, "{open} {count} {}", reports.len());
            assert!(start.elapsed().as_millis() < 3000, "{open} {count}: {:?}", start.elapsed());
        }
    }
}

#[test]
fn deep_files_fit_small_stacks() {
    let shapes = [
        ("A --> X(", "(", "1", ")", ")"),
        ("attr a = ", "f(g = ", "1", ")", ""),
        ("attr a = ", "[1, ", "1", "]", ""),
        ("attr a = ", "case a : ", "1", " else : 1", ""),
        ("attr a = ", "comp(f){ all : ", "1", " }", ""),
        ("A --> ", "split(x){ 1 : ", "X", " }", ""),
        ("A --> ", "case a : [ ", "X", " ] else : Y", ""),
        ("A --> ", "w% : ", "X", " else : Y", ""),
        ("A --> ", "inline { ", "X", " }", ""),
    ];
    for (head, open, middle, close, tail) in shapes {
        let text = format!("{head}{}{middle}{}{tail}", open.repeat(120), close.repeat(120));
        let shown = text.chars().take(40).collect::<String>();
        let thread = std::thread::Builder::new().stack_size(1 << 20);
        let reports = thread.spawn(move || read(&text).1).expect("a thread").join().expect("no panic");
        assert!(reports.is_empty(), "{shown}: {:?}", reports[0].message);
    }
}

/// The tree of a text without its places.
fn shape(text: &str) -> String {
    let (file, reports) = read(text);
    assert!(!reports.iter().any(Diagnostic::is_error), "{}", show(text, &reports));
    let (full, mut bare) = (format!("{:?}", file.items), String::new());
    let mut rest = full.as_str();
    while let Some(at) = rest.find("Span {") {
        bare.push_str(&rest[..at]);
        rest = &rest[at + rest[at..].find('}').expect("a closing brace") + 1..];
    }
    (bare + rest).replace("spelling: Paper", "spelling: Cga")
}

#[test]
fn the_two_notations_give_one_tree() {
    let pairs = [
        ("Subdiv(y,7,2,5){A|B|A}", "split(y){7:A|2:B|5:A}"),
        ("Subdiv(\"Y\",1r,2,4r){A|B|C}", "split(y){~1:A|2:B|~4:C}"),
        ("Subdiv(x,1r,2){A|B}", "split(x){1r:A|2:B}"),
        ("Repeat(\"X\",2){A}", "split(x){~2:A}*"),
        ("Comp(e){B}", "comp(e){all:B}"),
        ("Comp(\"faces\"){A}", "comp(f){all:A}"),
        ("Comp(\"sidefaces\"){A}", "comp(f){side:A}"),
        ("Comp(\"topfaces\"){A}", "comp(f){top:A}"),
        ("Comp(\"edge\",3){A}", "comp(e){3:A}"),
        ("Comp(f){top:A|side:B}", "comp(f){top:A|side:B}"),
        ("T(1,2,3) S('1,2,3) Rx(9) Ry(8) Rz(7)", "t(1,2,3) s('1,2,3) r(9,0,0) r(0,8,0) r(0,0,7)"),
        ("I(\"oak\")", "i(\"oak\")"),
    ];
    for (paper, cga) in pairs {
        assert_eq!(shape(&format!("Lot --> {paper}")), shape(&format!("Lot --> {cga}")), "{paper}");
        assert_eq!(shape(&format!("Lot ~> [{paper}]")), shape(&format!("Lot --> [{cga}]")), "{paper}");
    }
    for own in ["I(birch, adult, rand(7))", "Distr(0.2, 1)", "S", "T(1)"] {
        let name = own.split('(').next().unwrap_or(own);
        assert!(shape(&format!("Lot --> {own}")).contains(&format!("text: \"{name}\"")), "{own}");
    }
    assert!(
        shape("Lot --> S(1,2,3) S(a,b,c) --> X").contains("name: Name { text: \"S\", span:  }, args: ["),
        "own rules win"
    );
}

#[test]
fn different_spellings_of_one_meaning_give_one_tree() {
    let pairs = [
        ("a = 1 + 2 * 3 - 4", "a = (1 + (2 * 3)) - 4"),
        ("a = x || y && z == 1 + 1", "a = x || (y && (z == (1 + 1)))"),
        ("a = -x * y[0] .+ !z", "a = ((-x) * (y[0])) .+ (!z)"),
        ("a = f('1/n)", "a = f('(1/n))"),
        ("a = f(~n + 1)", "a = f(~(n + 1))"),
        ("a = 50% : 0 25%: 90 else: 45", "a = (50) % : (0) (25) % : (90) else : (45)"),
        ("a = case b : 1 case c : 2 else : 3", "a = case (b) : (1) case (c) : (2) else : (3)"),
        ("A --> 30% : [B] w% : [C] f(1)% : D else : E", "A --> 30%: [B] (w)%: [C] (f(1))%: D else: E"),
        ("A --> w% : B else : C", "A --> (w)% : B else : C"),
        ("A --> case x : 30% : [B] w % : C else : D else : E", "A --> case x : 30% : [B] (w)% : C else : D else : E"),
        ("A --> split(x){ {~1:B}* | 2:C }", "A-->split( x ) { { ~1 : B } * // c\n | 2 /*c*/ : C # d\n }"),
        ("A --> B. C", "A --> B . C"),
        ("a = \"x\"", "a = /* \" */ \"x\" // \""),
        ("a = .5 + 5. + 3e3", "a = 0.5 + 5 + 3000"),
    ];
    for (one, other) in pairs {
        assert_eq!(shape(one), shape(other), "{one}");
    }
}

#[test]
fn imports_and_rules_keep_all_their_parts() {
    let (file, reports) = read(include_str!("syntax/modern.cga"));
    assert!(reports.is_empty());
    assert_eq!(file.version.as_ref().map(|v| &*v.text), Some("2025.1"));
    assert!(matches!(&file.items[0], Item { kind: ItemKind::Nothing, annotations, .. } if annotations.len() == 1));
    let ItemKind::Import(import) = &file.items[1].kind else { panic!("no import") };
    assert_eq!(import.styles.len(), 2);
    let overrides = import.overrides.as_ref().expect("overrides");
    assert!(matches!(&overrides[..], [
        Override::Protect(_),
        Override::Protect(_),
        Override::Attribute(..),
        Override::Rule(trunk),
        Override::Rule(_)
    ] if trunk.params.as_ref().is_some_and(|p| p.len() == 1)));
    let lot = file.items.iter().find_map(|item| match &item.kind {
        ItemKind::Rule(rule) if &*rule.name.text == "Lot" => Some((item, rule)),
        _ => None,
    });
    let (item, lot) = lot.expect("the rule");
    assert_eq!((&*item.annotations[0].name.text, lot.mark, lot.locals.len()), ("StartRule", Some(RuleMark::Start), 2));
    let Body::Ops(ops) = &lot.body else { panic!("no operations") };
    let Op::Dynamic { import, overrides, call } = &ops[3] else { panic!("{:?}", ops[3]) };
    assert_eq!((&*import.text, overrides.len(), &*call.name.text), ("plants", 2, "Generate"));
    let split = |op: &Op| matches!(op, Op::Call(call) if call.blocks.len() == 2 && call.blocks[0].repeat && call.blocks[0].entries.iter().all(|e| e.head.as_ref().is_some_and(|h| h.depth.is_some())));
    assert!(format!("{file:?}").contains("splitAndSetbackPerimeter"));
    let yard = file.items.iter().find_map(|item| match &item.kind {
        ItemKind::Rule(Rule { name, body: Body::Ops(ops), .. }) if &*name.text == "Yard" => Some(ops),
        _ => None,
    });
    assert!(yard.expect("Yard").iter().any(split));
}

#[test]
fn broken_definitions_leave_the_others() {
    let text =
        "A --> split(x){ 1 : B\nattr h = 3\nB --> case x : C\nC --> D\nf(x) = (x\ng(x) = x\n@Range(0 1)\nattr i = 2\n";
    let (file, reports) = read(text);
    let name = |item: &Item| match &item.kind {
        ItemKind::Function(f) => f.name.text.to_string(),
        ItemKind::Rule(r) => r.name.text.to_string(),
        _ => String::new(),
    };
    assert_eq!(file.items.iter().map(name).collect::<Vec<_>>(), ["h", "C", "g", "i"], "{}", show(text, &reports));
    assert_eq!(reports.len(), 4, "{}", show(text, &reports));
    assert_eq!(reports.iter().filter(|r| r.is_error()).count(), 3, "a broken annotation is a lint");
}

mod soup {
    use super::*;
    use proptest::prelude::*;

    const WORDS: [&str; 56] = [
        "A",
        "b.c",
        "Lot",
        "x",
        "1",
        ".5",
        "2r",
        "\"t\"",
        "\"",
        "(",
        ")",
        "{",
        "}",
        "[",
        "]",
        "|",
        ":",
        "=",
        "-->",
        "~>",
        "->",
        "case",
        "else",
        "30%",
        "%",
        "*",
        "+",
        "-",
        "'",
        "~",
        ",",
        ";",
        ".",
        "@",
        "attr",
        "const",
        "import",
        "style",
        "with",
        ":=",
        "=:",
        "==",
        "&&",
        "||",
        "!",
        "//",
        "#",
        "/*",
        "*/",
        "\n",
        "split(x){",
        "inline",
        "version",
        "start",
        "ü",
        "\\",
    ];

    proptest! {
        #![proptest_config(ProptestConfig::with_cases(3000))]

        /// Whatever stands in a file: no panic, and every report points into it, between characters.
        #[test]
        fn any_words_are_read(words in prop::collection::vec((0..WORDS.len(), any::<bool>()), 0..60)) {
            let text: String = words.iter().map(|(w, blank)| format!("{}{}", WORDS[*w], if *blank { " " } else { "" })).collect();
            let (file, reports) = read(&text);
            for report in &reports {
                let Place::Rule(span) = &report.place else { panic!("no place") };
                prop_assert!(text.get(span.start as usize..span.end as usize).is_some(), "{text:?} {report:?}");
            }
            prop_assert!(!file.items.is_empty() || !reports.is_empty() || file.version.is_some() || text_is_blank(&text));
        }

        #[test]
        fn any_bytes_are_read(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
            let source = Source::new("x.cga", &bytes);
            let (_, reports) = parse(3, &source);
            for report in &reports {
                let Place::Rule(span) = &report.place else { panic!("no place") };
                prop_assert!(source.original(span.start) <= bytes.len() as u32 && source.original(span.end) <= bytes.len() as u32);
                prop_assert_eq!(span.file, 3);
            }
        }
    }

    /// Nothing but blanks and comments.
    fn text_is_blank(text: &str) -> bool {
        let mut rest = text.trim_start();
        loop {
            let end = match () {
                () if rest.is_empty() => return true,
                () if rest.starts_with("//") || rest.starts_with('#') => rest.find('\n').unwrap_or(rest.len()),
                () if rest.starts_with("/*") => match rest[2..].find("*/") {
                    Some(end) => end + 4,
                    None => return false,
                },
                () => return false,
            };
            rest = rest[end..].trim_start();
        }
    }
}
