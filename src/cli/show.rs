//! Diagnostics for people: excerpt, caret, hints, and the rules on the way down.

use annotate_snippets::{AnnotationKind, Group, Level, Renderer, Snippet};
use bosquet::diag::{Diagnostic, Place, Severity};
use bosquet::syntax::Source;
use std::io::IsTerminal;

/// Diagnostics shown in full; further ones are counted.
const MOST_SHOWN: usize = 50;

/// Writes diagnostics to stderr, the worst first where there are too many, and a last line that counts them.
pub fn diagnostics(found: &[Diagnostic], sources: &[Source]) {
    let mut shown: Vec<&Diagnostic> = found.iter().collect();
    if shown.len() > MOST_SHOWN {
        shown.sort_by_key(|d| std::cmp::Reverse(d.severity));
    }
    shown.iter().take(MOST_SHOWN).for_each(|diagnostic| eprintln!("{}\n", text(diagnostic, sources)));
    if found.len() > MOST_SHOWN {
        eprintln!("… and {} more: the report (`-o report.json`) holds all\n", found.len() - MOST_SHOWN);
    }
    let count = |severity| found.iter().filter(|d| d.severity == severity).count();
    let (errors, lints) = (count(Severity::Error), count(Severity::Lint));
    let parts = [(errors, "error"), (lints, "warning")];
    let words: Vec<String> =
        parts.iter().filter(|(n, _)| *n > 0).map(|(n, word)| bosquet::text::counted(*n, word)).collect();
    if !words.is_empty() {
        eprintln!("{}", words.join(", "));
    }
}

/// One diagnostic as text.
fn text(diagnostic: &Diagnostic, sources: &[Source]) -> String {
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
