//! `bosquet derive --tree`: the derivation as text on standard output.

use crate::cli::derive::prints;
use crate::cli::disk::Disk;
use crate::cli::job::{Arguments, Job};
use crate::cli::prepare::Prepared;
use crate::cli::{Ended, show};
use bosquet::derive::Progress;
use bosquet::diag::Diagnostic;
use bosquet::layout::Layout;
use bosquet::text::{nearest, suggestion};
use bosquet::trace::{TreeOptions, tree_text};

/// Shapes of a lot that are shown where no lot is asked for: what a person may still leaf through.
const MOST: usize = 5_000;

/// Derives with a record and shows it; what rules print stands before the trees.
pub fn show(arguments: &Arguments, job: &Job, world: &Disk, progress: &Progress) -> Ended {
    let ready = match Prepared::new(&job.basis, world) {
        Ok(ready) => ready,
        Err(unready) => return unready.told("nothing is derived"),
    };
    let regions = match regions(&ready.layout, arguments.lot.as_deref()) {
        Ok(regions) => regions,
        Err(message) => return Ended::Usage(message),
    };
    let options = ready.options(&job.basis, world, &arguments.run);
    let (program, layout) = (&ready.program, &ready.layout);
    let (derivation, found) = bosquet::derive::recorded(program, layout, &options, progress, &regions);
    if progress.stopped() {
        return Ended::Stopped;
    }
    let most = if arguments.lot.is_some() { usize::MAX } else { MOST };
    let depth = arguments.depth.unwrap_or(usize::MAX);
    prints(&derivation);
    show::print(tree_text(&derivation, &TreeOptions { program: Some(program), depth, most }));
    if job.outputs.is_empty() {
        let found: Vec<Diagnostic> = ready.found.iter().cloned().chain(found).collect();
        show::diagnostics(&found, &program.sources);
        return if found.iter().any(Diagnostic::is_error) { Ended::Wrong } else { Ended::Well };
    }
    // The run that writes the files says the rest.
    Ended::Well
}

/// The regions with that id, or all.
fn regions(layout: &Layout, lot: Option<&str>) -> Result<Vec<usize>, String> {
    let all = 0..layout.regions.len();
    let Some(lot) = lot else { return Ok(all.collect()) };
    let found: Vec<usize> = all.filter(|index| &*layout.regions[*index].id == lot).collect();
    if found.is_empty() {
        let near = nearest(lot, layout.regions.iter().map(|region| &*region.id));
        return Err(format!("the layout has no lot `{lot}`{}", suggestion(near)));
    }
    Ok(found)
}
