//! Which rule begins on a region: `--start`, the feature's `start`, `@Zone`, a rule named like the kind, the file's
//! start rule; in this order.

use crate::check::Program;
use crate::diag::{Diagnostic, Place, Severity};
use crate::layout::{Layout, Region};
use crate::text::nearest;

/// Why no rule begins on a region.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum StartError {
    /// Nothing names one: the region is left as it is.
    None,
    /// A rule of this name was asked for and is not there, or takes arguments.
    Unknown(String),
}

/// The rule that begins on the region; `asked` comes before all else.
pub fn start_of(program: &Program, region: &Region, asked: Option<&str>) -> Result<u32, StartError> {
    if let Some(name) = asked.or(region.start.as_deref()) {
        return program.start_named(name).ok_or_else(|| StartError::Unknown(name.into()));
    }
    zone(program, region).or_else(|| named_like(program, region.kind.word())).or(program.start).ok_or(StartError::None)
}

/// `@Zone(kind, zone)` before `@Zone(kind)`.
fn zone(program: &Program, region: &Region) -> Option<u32> {
    let kind = |z: &&crate::check::Zone| *z.kind == *region.kind.word();
    let exact = program.zones.iter().filter(kind).find(|z| z.zone.as_ref() == Some(&region.zone));
    exact.or_else(|| program.zones.iter().filter(kind).find(|z| z.zone.is_none())).map(|z| z.rule)
}

/// A rule named like the kind, whatever its capitals: `lot` finds `Lot`.
fn named_like(program: &Program, kind: &str) -> Option<u32> {
    let same = |name: &str| name.eq_ignore_ascii_case(&kind.replace(['-', ' '], "_"));
    program.starts.iter().find(|(name, _)| same(name)).map(|(_, rule)| *rule)
}

/// One diagnostic per missing rule, with the regions that asked for it; one note for those without any.
pub(super) fn report(program: &Program, layout: &Layout, starts: &[Result<u32, StartError>]) -> Vec<Diagnostic> {
    let mut diagnostics: Vec<Diagnostic> = Vec::new();
    let mut missing: std::collections::BTreeMap<&str, Vec<&str>> = std::collections::BTreeMap::new();
    let mut silent: Vec<&str> = Vec::new();
    for (region, start) in layout.regions.iter().zip(starts) {
        match start {
            Err(StartError::Unknown(name)) => missing.entry(name).or_default().push(&region.id),
            Err(StartError::None) => silent.push(&region.id),
            Ok(_) => {}
        }
    }
    for (name, regions) in missing {
        let near = nearest(name, program.starts.iter().map(|(n, _)| &**n));
        let message = format!("there is no rule `{name}` without arguments to start with on {}", some(&regions));
        diagnostics.push(Diagnostic::new(Severity::Error, "start", Place::Run, message).did_you_mean(near));
    }
    if !silent.is_empty() {
        let message = format!("no rule starts on {}", some(&silent));
        let hint = "a rule named like the kind, `@Zone(kind)` on a rule, or `--start RULE` would";
        diagnostics.push(Diagnostic::new(Severity::Note, "start", Place::Run, message).hint(hint));
    }
    diagnostics
}

/// The first few of a list of ids, and how many more.
fn some(ids: &[&str]) -> String {
    let shown: Vec<String> = ids.iter().take(3).map(|id| format!("`{id}`")).collect();
    match ids.len() - shown.len() {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}
