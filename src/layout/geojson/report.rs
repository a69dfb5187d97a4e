//! What there is to say about an import: each flaw with its feature, everything else counted.

use crate::diag::{Diagnostic, Place, Severity};
use crate::layout::geojson::document::Flaw;
use crate::layout::geojson::properties::Properties;
use crate::layout::{Kind, Layout};
use crate::text::{counted, thousands};
use std::collections::BTreeMap;
use std::sync::Arc;

/// So many flaws of one sort are told one by one; the summary counts them all.
const TOLD: usize = 10;
/// So many names stand for a long list.
const NAMED: usize = 5;

/// What was found while reading one layout.
pub struct Report {
    path: Arc<str>,
    errors: Vec<Diagnostic>,
    /// How often each flaw occurred, in the words of the flaw.
    flaws: BTreeMap<&'static str, usize>,
    guesses: BTreeMap<Kind, usize>,
    repaired: Tally,
    far: Tally,
    nested: Tally,
    misused: Tally,
    /// Ids that occurred before.
    pub renamed: Tally,
    /// Items with lists by edge whose outline was cut anew.
    pub unsettled: Tally,
    /// Items of a kind that needs an area, without one.
    pub without_area: Tally,
}

/// A count with its first few names.
#[derive(Default)]
pub struct Tally {
    count: usize,
    first: Vec<Arc<str>>,
}

impl Tally {
    /// Counts one more.
    pub fn add(&mut self, name: &str) {
        self.count += 1;
        if self.first.len() < NAMED {
            self.first.push(name.into());
        }
    }

    /// The names as a list: `` `a`, `b` and 7 more ``.
    fn names(&self) -> String {
        let mut words: Vec<String> = self.first.iter().map(|n| format!("`{n}`")).collect();
        if self.count > self.first.len() {
            words.push(format!("{} more", thousands(self.count - self.first.len())));
        }
        match words.split_last() {
            Some((last, others)) if !others.is_empty() => format!("{} and {last}", others.join(", ")),
            Some((only, _)) => only.clone(),
            None => String::new(),
        }
    }
}

impl Report {
    /// Nothing found yet in the layout at `path`.
    pub fn new(path: &str) -> Report {
        Report {
            path: path.into(),
            errors: Vec::new(),
            flaws: BTreeMap::new(),
            guesses: BTreeMap::new(),
            repaired: Tally::default(),
            far: Tally::default(),
            nested: Tally::default(),
            misused: Tally::default(),
            renamed: Tally::default(),
            unsettled: Tally::default(),
            without_area: Tally::default(),
        }
    }

    /// A feature cannot be used.
    pub fn leave_out(&mut self, id: &str, flaw: &Flaw) {
        self.flaw(id, flaw, "the feature is left out");
    }

    /// A part of a feature cannot be used.
    pub fn leave_out_part(&mut self, id: &str, flaw: &Flaw) {
        self.flaw(id, flaw, "a part of the feature is left out");
    }

    /// What the feature was taken for.
    pub fn guessed(&mut self, kind: Kind) -> Kind {
        *self.guesses.entry(kind.clone()).or_default() += 1;
        kind
    }

    /// How the feature's geometry was received.
    pub fn note_placing(&mut self, id: &str, is_repaired: bool, is_far: bool) {
        if is_repaired {
            self.repaired.add(id);
        }
        if is_far {
            self.far.add(id);
        }
    }

    /// How the feature's properties were received.
    pub fn note_properties(&mut self, id: &str, properties: &Properties) {
        properties.nested.iter().for_each(|name| self.nested.add(&format!("{id}.{name}")));
        properties.misused.iter().for_each(|name| self.misused.add(&format!("{id}.{name}")));
    }

    /// Everything as diagnostics: errors in file order, then lints, then notes.
    pub fn finish(mut self, layout: &Layout) -> Vec<Diagnostic> {
        let mut diagnostics = std::mem::take(&mut self.errors);
        diagnostics.extend(self.lints());
        diagnostics.extend(self.notes());
        if layout.regions.is_empty() && diagnostics.is_empty() {
            let message = "the layout holds no region: there is nothing for rules to start on";
            diagnostics.push(self.summary(Severity::Lint, "layout-empty", message.to_owned()));
        }
        diagnostics
    }

    fn flaw(&mut self, id: &str, flaw: &Flaw, what: &str) {
        let count = self.flaws.entry(flaw.heading()).or_default();
        *count += 1;
        if *count <= TOLD {
            let place = format!("{}: feature `{id}`", self.path);
            self.errors.push(Diagnostic::data("layout-geometry", place, format!("{what}: {flaw}")));
        }
    }

    fn lints(&self) -> Vec<Diagnostic> {
        let tallies = [
            (
                &self.repaired,
                "layout-repaired",
                "outlines that were open, repeated points or crossed themselves are repaired",
            ),
            (
                &self.unsettled,
                "layout-edges",
                "lists as long as the outline keep the file's order: the outline crossed itself, and its edges are others",
            ),
            (&self.renamed, "layout-id", "ids that occur more than once have got a suffix `-2`, `-3` …"),
            (
                &self.without_area,
                "layout-kind",
                "features whose kind wants an area have none: no rule can start on them",
            ),
            (&self.far, "layout-far", "features lie more than 90 km from the others: lengths are not true there"),
            (&self.nested, "layout-property", "properties that are objects or lists of several types are skipped"),
            (
                &self.misused,
                "layout-property",
                "properties that should be numbers are none and keep no meaning of their own",
            ),
        ];
        let told = tallies.into_iter().filter(|(tally, ..)| tally.count > 0);
        told.map(|(tally, code, words)| {
            self.summary(Severity::Lint, code, format!("{words} ({}): {}", thousands(tally.count), tally.names()))
        })
        .collect()
    }

    fn notes(&self) -> Vec<Diagnostic> {
        let mut notes = Vec::new();
        if !self.flaws.is_empty() {
            let counts: Vec<String> =
                self.flaws.iter().map(|(words, n)| format!("{} {words}", thousands(*n))).collect();
            let message = format!("left out in all: {}", counts.join(", "));
            notes.push(self.summary(Severity::Note, "layout-geometry", message));
        }
        if !self.guesses.is_empty() {
            let total: usize = self.guesses.values().sum();
            let taken: Vec<String> =
                self.guesses.iter().map(|(k, n)| format!("{} as `{}`", thousands(*n), k.word())).collect();
            let message = format!("{} without a `kind` are taken: {}", counted(total, "feature"), taken.join(", "));
            let hint = "give each feature a property `kind`: lot, block, patio, avenue, region, building, street, tree, marker …";
            notes.push(self.summary(Severity::Note, "layout-kind", message).hint(hint));
        }
        notes
    }

    fn summary(&self, severity: Severity, code: &'static str, message: String) -> Diagnostic {
        Diagnostic::new(severity, code, Place::Data(self.path.clone()), message)
    }
}

impl Flaw {
    /// What counts as the same sort of flaw in the summary.
    fn heading(&self) -> &'static str {
        match self {
            Flaw::NotAFeature => "that are no features",
            Flaw::NoGeometry => "without geometry",
            Flaw::Unreadable(_) => "with unreadable geometry",
            Flaw::Empty => "with empty geometry",
            Flaw::TooFew(_) => "with too few points",
            Flaw::NoArea => "without area",
            Flaw::OffTheGlobe => "off the globe",
            Flaw::Unplaceable => "outside the plan",
        }
    }
}
