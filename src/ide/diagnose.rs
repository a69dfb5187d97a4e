//! What is wrong in a file and in what it imports; and a file laid out, where nothing is.

use crate::check::check;
use crate::diag::{Diagnostic, Place as At, Severity};
use crate::ide::{Desk, Place};
use crate::syntax::format;

/// Something to tell about a stretch of a file.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Where.
    pub place: Place,
    /// How bad.
    pub severity: Severity,
    /// A stable word: `unknown-name`.
    pub code: &'static str,
    /// What was found and what would do, with the advice in lines of its own.
    pub message: String,
}

impl Desk<'_> {
    /// What is wrong in the file at a path and in all that it imports. What concerns no stretch of a file stands at the
    /// beginning of this one. Cost: linear in the files.
    pub fn diagnose(&self, path: &str) -> Vec<Finding> {
        let (program, found) = check(self.world, path);
        let place = |diagnostic: &Diagnostic| match diagnostic.place {
            At::Rule(span) => match program.sources.get(span.file as usize) {
                Some(source) => Place::new(source.path(), span.start as usize..span.end as usize),
                None => Place::new(path, 0..0),
            },
            _ => Place::new(path, 0..0),
        };
        let finding = |diagnostic: &Diagnostic| Finding {
            place: place(diagnostic),
            severity: diagnostic.severity,
            code: diagnostic.code,
            message: with_hints(diagnostic),
        };
        found.iter().map(finding).collect()
    }
}

impl Desk<'_> {
    /// The text of a file as `bosquet fmt` lays it out; `None` where it cannot be read. Cost: linear.
    pub fn laid_out(&self, path: &str) -> Option<String> {
        format(0, self.document(path)?.source()).ok()
    }
}

fn with_hints(diagnostic: &Diagnostic) -> String {
    diagnostic.hints.iter().fold(diagnostic.message.clone(), |text, hint| format!("{text}\n{hint}"))
}
