//! What went wrong, where, and what would do: the one type every stage reports with.
//!
//! Messages are lower case with names in backticks, say what was found and what would do; advice goes to the hints.
//! Drawing them is the command's affair.

use crate::text;
use std::sync::Arc;

/// A stretch of a source file, in bytes of its decoded text.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Span {
    /// Which file, in order of loading.
    pub file: u16,
    /// First byte.
    pub start: u32,
    /// One past the last byte.
    pub end: u32,
}

impl Span {
    /// The stretch from the start of `self` to the end of `other`.
    pub fn to(self, other: Span) -> Span {
        Span { file: self.file, start: self.start, end: other.end.max(self.start) }
    }
}

/// How bad it is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Severity {
    /// Nothing is wrong; worth knowing once.
    Note,
    /// Works, but hardly as meant.
    Lint,
    /// Does not work: nothing, or a part, is left out.
    Error,
}

impl Severity {
    /// The word used in every output.
    pub fn word(self) -> &'static str {
        match self {
            Severity::Note => "note",
            Severity::Lint => "warning",
            Severity::Error => "error",
        }
    }
}

/// Where a diagnostic points.
#[derive(Clone, Debug, PartialEq)]
pub enum Place {
    /// A stretch of a rule file.
    Rule(Span),
    /// A feature of the layout, a line of the catalogue, a manifest: words that lead there.
    Data(Arc<str>),
    /// The run as a whole.
    Run,
}

/// One rule on the way down to where something happened.
#[derive(Clone, Debug, PartialEq)]
pub struct Step {
    /// The rule's name.
    pub rule: Arc<str>,
    /// Where the rule is written.
    pub span: Span,
}

/// One thing to tell the user.
#[derive(Clone, Debug, PartialEq)]
pub struct Diagnostic {
    /// How bad.
    pub severity: Severity,
    /// A stable word for machines: `syntax`, `syntax-case`, `unknown-name`, `geometry`, …
    pub code: &'static str,
    /// What was found and what would do.
    pub message: String,
    /// Where.
    pub place: Place,
    /// Advice.
    pub hints: Vec<String>,
    /// The rules on the way down, innermost first; empty before derivation.
    pub trace: Vec<Step>,
    /// The lot it happened in; empty where it concerns all.
    pub lot: Option<Arc<str>>,
}

impl Diagnostic {
    /// An error at a stretch of a rule file.
    pub fn error(code: &'static str, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Severity::Error, code, Place::Rule(span), message)
    }

    /// A lint at a stretch of a rule file.
    pub fn lint(code: &'static str, span: Span, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Severity::Lint, code, Place::Rule(span), message)
    }

    /// An error in data: the layout, the catalogue, the manifest.
    pub fn data(code: &'static str, place: impl Into<Arc<str>>, message: impl Into<String>) -> Diagnostic {
        Diagnostic::new(Severity::Error, code, Place::Data(place.into()), message)
    }

    /// Any diagnostic, without hints, trace or lot.
    pub fn new(severity: Severity, code: &'static str, place: Place, message: impl Into<String>) -> Diagnostic {
        Diagnostic { severity, code, message: message.into(), place, hints: Vec::new(), trace: Vec::new(), lot: None }
    }

    /// The same with one more piece of advice.
    pub fn hint(mut self, hint: impl Into<String>) -> Diagnostic {
        self.hints.push(hint.into());
        self
    }

    /// The same with a "did you mean" where there is a likely candidate.
    pub fn did_you_mean(self, candidate: Option<&str>) -> Diagnostic {
        match candidate {
            Some(name) => self.hint(text::did_you_mean(name)),
            None => self,
        }
    }

    /// Whether it is an error.
    pub fn is_error(&self) -> bool {
        self.severity == Severity::Error
    }
}
