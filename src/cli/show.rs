//! What the command says: results, words, and diagnostics with excerpt, caret, hints, and the rules on the way down.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use bosquet::diag::{Diagnostic, Place, Severity, Span};
use bosquet::syntax::Source;
use bosquet::text::counted;
use std::collections::BTreeMap;
use std::fmt::Display;
use std::io::{IsTerminal, Write};

/// Diagnostics shown in full; further ones are counted.
const MOST_SHOWN: usize = 50;

/// A result, on standard output. Whoever reads it may leave (`bosquet ops | head`): that stops nothing.
pub fn print(text: impl Display) {
    let _ = write!(std::io::stdout().lock(), "{text}");
}

/// A line for people, on standard error.
pub fn tell(line: impl Display) {
    let _ = writeln!(std::io::stderr().lock(), "{line}");
}

/// Lots that are named where the same is to be said of many.
const MOST_LOTS: usize = 3;

/// Writes diagnostics to stderr, what is said of many lots once, the worst first where there are too many, and a last
/// line that counts them.
pub fn diagnostics(found: &[Diagnostic], sources: &[Source]) {
    let mut shown = gathered(found);
    if shown.len() > MOST_SHOWN {
        shown.sort_by_key(|(d, _)| std::cmp::Reverse(d.severity));
    }
    for (diagnostic, lots) in shown.iter().take(MOST_SHOWN) {
        tell(text(diagnostic, lots, sources) + "\n");
    }
    if shown.len() > MOST_SHOWN {
        tell(format_args!("… and {} more: the report (`-o report.json`) holds all\n", shown.len() - MOST_SHOWN));
    }
    let count = |severity| found.iter().filter(|d| d.severity == severity).count();
    let (errors, lints) = (count(Severity::Error), count(Severity::Lint));
    let parts = [(errors, "error"), (lints, "warning")];
    let words: Vec<String> = parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| counted(*n, word)).collect();
    if !words.is_empty() {
        tell(words.join(", "));
    }
}

/// Each diagnostic with the further lots in which the same place gave one of its kind.
fn gathered(found: &[Diagnostic]) -> Vec<(&Diagnostic, Vec<&str>)> {
    let mut shown: Vec<(&Diagnostic, Vec<&str>)> = Vec::new();
    let mut first: BTreeMap<(Span, &str), usize> = BTreeMap::new();
    for diagnostic in found {
        let key = match (&diagnostic.place, &diagnostic.lot) {
            (Place::Rule(span), Some(lot)) => Some(((*span, diagnostic.code), &**lot)),
            _ => None,
        };
        match key.and_then(|(key, lot)| Some((*first.get(&key)?, lot))) {
            Some((index, lot)) => shown[index].1.push(lot),
            None => {
                first.extend(key.map(|(key, _)| (key, shown.len())));
                shown.push((diagnostic, Vec::new()));
            }
        }
    }
    shown
}

/// `likewise in …`.
fn likewise(lots: &[&str]) -> String {
    let named: Vec<String> = lots.iter().take(MOST_LOTS).map(|lot| format!("`{lot}`")).collect();
    match lots.len() - named.len() {
        0 => format!("likewise in {}", named.join(", ")),
        more => format!("likewise in {} and {}", named.join(", "), counted(more, "more lot")),
    }
}

/// One diagnostic as text, with the lots of which the same is to be said.
fn text(diagnostic: &Diagnostic, lots: &[&str], sources: &[Source]) -> String {
    let level = match diagnostic.severity {
        Severity::Error => Level::ERROR,
        Severity::Lint => Level::WARNING,
        Severity::Note => Level::NOTE,
    };
    let message = match &diagnostic.lot {
        Some(lot) => format!("{} (lot `{lot}`)", diagnostic.message),
        None => diagnostic.message.clone(),
    };
    let title = level.primary_title(message).id(diagnostic.code);
    let mut group = match (&diagnostic.place, source(diagnostic, sources)) {
        (Place::Rule(span), Some(source)) => {
            let length = source.text().len();
            let (start, end) = ((span.start as usize).min(length), (span.end as usize).min(length));
            let annotation = AnnotationKind::Primary.span(start..end.max(start));
            title.element(Snippet::source(source.text()).path(source.path()).annotation(annotation))
        }
        (Place::Data(place), _) => title.element(annotate_snippets::Origin::path(place.to_string())),
        _ => Group::with_title(title),
    };
    for hint in &diagnostic.hints {
        group = group.element(Level::HELP.message(hint.as_str()));
    }
    let steps: Vec<String> = diagnostic.trace.iter().map(|step| format!("`{}`", step.rule)).collect();
    if !steps.is_empty() {
        group = group.element(Level::NOTE.message(format!("in {}", steps.join(", in "))));
    }
    if !lots.is_empty() {
        group = group.element(Level::NOTE.message(likewise(lots)));
    }
    let renderer = if std::io::stderr().is_terminal() { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&[group])
}

/// The file a diagnostic points into.
pub fn source<'s>(diagnostic: &Diagnostic, sources: &'s [Source]) -> Option<&'s Source> {
    match diagnostic.place {
        Place::Rule(span) => sources.get(span.file as usize),
        _ => None,
    }
}

/// Where a diagnostic points, on one line: `file:line:column`.
pub fn place(diagnostic: &Diagnostic, sources: &[Source]) -> String {
    match (&diagnostic.place, source(diagnostic, sources)) {
        (Place::Rule(span), Some(source)) => {
            let (line, column) = source.line_column(span.start);
            format!("{}:{line}:{column}", source.path())
        }
        (Place::Data(place), _) => place.to_string(),
        _ => String::new(),
    }
}
