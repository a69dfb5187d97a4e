//! The formatter: the same rules, laid out evenly.

#[path = "common/rule_texts.rs"]
mod rule_texts;
#[path = "common/section.rs"]
mod section;

use bosquet::diag::Diagnostic;
use bosquet::syntax::{Source, format, parse};
use proptest::prelude::*;
use std::path::{Path, PathBuf};

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// The rule files below a folder.
fn rule_files(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder") {
        let path = entry.expect("an entry").path();
        match path.is_dir() {
            true => found.extend(rule_files(&path)),
            false => found.extend(path.extension().is_some_and(|ending| ending == "cga").then_some(path)),
        }
    }
    found
}

fn formatted(text: &str) -> String {
    format(0, &Source::new("x.cga", text.as_bytes())).unwrap_or_else(|reports| panic!("{text}\n{:?}", reports[0]))
}

/// The tree of a text without its places.
fn tree(text: &str) -> String {
    let (file, reports) = parse(0, &Source::new("x.cga", text.as_bytes()));
    assert!(!reports.iter().any(Diagnostic::is_error), "{text}\n{reports:?}");
    let (full, mut bare) = (format!("{file:?}"), String::new());
    let mut rest = full.as_str();
    while let Some(at) = rest.find("Span {") {
        bare.push_str(&rest[..at]);
        rest = &rest[at + rest[at..].find('}').expect("a closing brace") + 1..];
    }
    bare + rest
}

/// All that is no blank, sorted: bars change places with comments behind them.
fn ink(text: &str) -> Vec<char> {
    let mut ink: Vec<char> = text.chars().filter(|c| !c.is_whitespace() && *c != '\u{feff}').collect();
    ink.sort_unstable();
    ink
}

/// Formatting keeps the tree and all that is no blank, and doing it twice changes nothing more.
fn holds(text: &str) {
    let once = formatted(text);
    assert_eq!(tree(&once), tree(text), "{text}\n---\n{once}");
    assert_eq!(ink(&once), ink(text), "{text}\n---\n{once}");
    assert_eq!(formatted(&once), once, "{text}");
    assert!(!once.lines().any(|line| line.ends_with([' ', '\t'])), "{once}");
}

#[test]
fn the_rules_of_the_house_stay_what_they_are() {
    let files: Vec<PathBuf> =
        ["rules", "examples", "tests/syntax", "src"].iter().flat_map(|f| rule_files(&root().join(f))).collect();
    assert!(files.len() > 30, "{}", files.len());
    for path in files {
        holds(&std::fs::read_to_string(&path).expect("a readable file"));
    }
    let sections = section::sections(&root().join("tests/suite"));
    for file in sections.iter().flat_map(|section| &section.files) {
        let text = file.text();
        if !parse(0, &Source::new("x.cga", text.as_bytes())).1.iter().any(Diagnostic::is_error) {
            holds(&text);
        }
    }
}

#[test]
fn a_ragged_file_is_laid_out_evenly() {
    let [ragged, even] = ["ragged", "even"].map(|name| root().join(format!("tests/syntax/{name}.cga")));
    let found = formatted(&std::fs::read_to_string(ragged).expect("a readable file"));
    if std::env::var_os("UPDATE_SUITE").is_some() {
        std::fs::write(&even, &found).expect("a writable reference");
    }
    assert_eq!(found, std::fs::read_to_string(even).expect("a readable file"));
}

#[test]
fn line_ends_and_encodings_stay() {
    let windows = "// a\r\nA-->B\r\n\r\n\r\n/* x\r\n   y */\r\nattr  t=\"é\"\r\n";
    assert_eq!(formatted(windows), "// a\r\nA --> B\r\n\r\n/* x\r\n   y */\r\nattr t = \"é\"\r\n");
    let bytes = b"\xef\xbb\xbf// caf\xe9 \x93x\x94\nA-->B";
    let source = Source::new("x.cga", bytes);
    let text = format(0, &source).expect("a text");
    assert_eq!(source.encoded(&text), b"\xef\xbb\xbf// caf\xe9 \x93x\x94\nA --> B\n");
}

/// What old files hold parses, and what is odd about it is a lint.
#[test]
fn old_files_are_read_with_lints() {
    let table: [(&[u8], &str); 6] = [
        (b"// caf\xe9\nLot --> A.", "is not UTF-8"),
        (b"Lot\0 --> A.\0", "NUL bytes"),
        (b"Lot -->\r\n A.\r\n", ""),
        (b"\xef\xbb\xbfLot --> A.", ""),
        (b"@Decription(\"x\")\nLot --> A. B.", "`@Decription`"),
        (b"@Range(0 1)\nLot --> A.", "a `,` is missing"),
    ];
    for (bytes, says) in table {
        let (file, reports) = parse(0, &Source::new("x.cga", bytes));
        assert_eq!(file.items.len(), 1, "{reports:?}");
        assert!(!reports.iter().any(Diagnostic::is_error), "{reports:?}");
        assert_eq!(reports.len(), usize::from(!says.is_empty()), "{reports:?}");
        assert!(reports.iter().all(|report| report.message.contains(says)), "{reports:?}");
    }
}

#[test]
fn broken_files_are_refused_with_their_reports() {
    let source = Source::new("x.cga", b"A --> B\nLot --> split(x){ 1 : A\nC --> D");
    let reports = format(0, &source).expect_err("a refusal");
    assert!(reports.iter().any(|report| report.code == "syntax-bracket"), "{reports:?}");
}

#[test]
fn the_empty_file_stays_empty_and_a_lone_comment_alone() {
    for (text, even) in
        [("", ""), ("\n\n \t", ""), ("  // a", "// a\n"), ("/* a */", "/* a */\n"), ("@Hidden", "@Hidden\n")]
    {
        assert_eq!(formatted(text), even);
    }
}

#[test]
fn deep_and_long_files_are_formatted_in_no_time() {
    let deep = ["(", "f(", "[1, "].map(|open| (open, "attr a = ", "1"));
    let deep = deep.into_iter().chain([
        ("[ ", "A --> ", "X"),
        ("split(x){ 1 : ", "A --> ", "X"),
        ("case a : ", "A --> ", "X"),
    ]);
    for (open, head, middle) in deep {
        let close = match open {
            "case a : " => " else : Y",
            "[ " | "[1, " => "]",
            "split(x){ 1 : " => "}",
            _ => ")",
        };
        holds(&format!("{head}{}{middle}{}", open.repeat(110), close.repeat(110)));
    }
    for (head, piece) in [("A --> ", "B(1) "), ("attr a = 1 ", "+ 1\n"), ("attr a = [0", ", 1"), ("", "A --> B // c\n")]
    {
        let piece = piece.repeat(if head.contains('1') { 400 } else { 50_000 });
        let text = format!("{head}{piece}{}", if head.contains('[') { "]" } else { "" });
        let start = std::time::Instant::now();
        formatted(&text);
        assert!(start.elapsed().as_secs() < 5, "{head}: {:?}", start.elapsed());
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn any_valid_text_keeps_its_tree(bytes in prop::collection::vec(any::<u8>(), 0..400)) {
        holds(&rule_texts::rules(&bytes));
    }
}
