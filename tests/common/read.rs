//! Any bytes as a rule file: whoever reads them holds to what is promised. For fuzzers and what they found.

use crate::told::is_told_well;
use bosquet::check::check;
use bosquet::diag::Diagnostic;
use bosquet::syntax::ast::File;
use bosquet::syntax::{Source, format, parse};
use bosquet::world::MemoryWorld;

/// Reads, checks and formats; what parses is the same rules once it is formatted, and stays as it is the second time.
pub fn rules(bytes: &[u8]) {
    let (tree, reports) = read(bytes);
    let checked = check(&MemoryWorld::default().with("main.cga", bytes), "main.cga").1;
    reports.iter().chain(&checked).for_each(is_told_well);
    let broken = reports.iter().any(Diagnostic::is_error);
    match format(0, &Source::new("main.cga", bytes)) {
        Ok(once) => {
            assert!(!broken, "what is broken was formatted");
            let (again, reports) = read(once.as_bytes());
            assert!(!reports.iter().any(Diagnostic::is_error), "formatting broke it:\n{once}\n{reports:?}");
            assert_eq!(bare(&tree), bare(&again), "formatting changed it:\n{once}");
            let twice = format(0, &Source::new("main.cga", once.as_bytes()));
            assert_eq!(twice.as_deref().ok(), Some(&*once), "formatting does not settle");
        }
        Err(told) => assert!(broken && !told.is_empty(), "what is whole was not formatted"),
    }
}

fn read(bytes: &[u8]) -> (File, Vec<Diagnostic>) {
    parse(0, &Source::new("main.cga", bytes))
}

/// The tree without its places.
fn bare(tree: &File) -> String {
    let full = format!("{tree:?}");
    let mut parts = full.split("Span {");
    let first = parts.next().unwrap_or_default().to_string();
    parts.fold(first, |bare, part| bare + part.split_once('}').map_or("", |(_, rest)| rest))
}
