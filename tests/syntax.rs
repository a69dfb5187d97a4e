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
