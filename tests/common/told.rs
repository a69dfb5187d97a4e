//! What every diagnostic has to be.

use bosquet::diag::Diagnostic;

/// A message says something, and is no sentence.
pub fn is_told_well(diagnostic: &Diagnostic) {
    let message = &diagnostic.message;
    assert!(!message.is_empty() && !message.ends_with('.'), "{message}");
}
