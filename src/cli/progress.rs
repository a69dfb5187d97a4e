//! A progress bar on a terminal after a second, and a clean stop on Ctrl-C.

use bosquet::derive::Progress;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::IsTerminal;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// How long a run stays silent.
const PATIENCE: Duration = Duration::from_secs(1);
/// How often the bar is drawn anew.
const TICK: Duration = Duration::from_millis(100);

/// A progress that Ctrl-C stops; a second Ctrl-C ends the process at once.
pub fn interruptible() -> Arc<Progress> {
    let progress = Arc::new(Progress::default());
    let watched = progress.clone();
    // Without a handler Ctrl-C ends the process as usual: nothing is lost by going on.
    let _ = ctrlc::set_handler(move || {
        if watched.stop.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    });
    progress
}

/// Runs `work` beside a bar that shows how many of `total` are done.
pub fn with_bar<T>(total: usize, progress: &Progress, work: impl FnOnce() -> T) -> T {
    if !std::io::stderr().is_terminal() {
        return work();
    }
    let finished = AtomicBool::new(false);
    std::thread::scope(|scope| {
        scope.spawn(|| watch(total, progress, &finished));
        let result = work();
        finished.store(true, Ordering::Relaxed);
        result
    })
}

fn watch(total: usize, progress: &Progress, finished: &AtomicBool) {
    let begun = Instant::now();
    let mut bar: Option<ProgressBar> = None;
    while !finished.load(Ordering::Relaxed) {
        if begun.elapsed() >= PATIENCE {
            let bar = bar.get_or_insert_with(|| styled(total));
            bar.set_position(progress.done.load(Ordering::Relaxed) as u64);
        }
        std::thread::sleep(TICK);
    }
    if let Some(bar) = bar {
        bar.finish_and_clear();
    }
}

fn styled(total: usize) -> ProgressBar {
    let bar = ProgressBar::new(total as u64);
    let template = "deriving {wide_bar} {pos}/{len} regions, {elapsed} (Ctrl-C stops)";
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar
}
