//! `bosquet derive --watch`: derives, and again whenever a file that was read changes, until Ctrl-C.
//!
//! What was read is known from the world, files that were asked for and not there among it, and folders that were
//! listed. The folders of files are watched and not the files, since editors put new files in the place of old ones. One
//! line a run, and another run where the outputs of the first are new in a folder that rules list. Outputs that come out
//! as they were are left alone, and where rules or layout are broken the last ones stay.

use crate::cli::derive::{self, Done, Stop};
use crate::cli::disk::{hash_now, is_listing, write_changed};
use crate::cli::job::{Arguments, Job};
use crate::cli::prepare::{on_threads, world};
use crate::cli::{Ended, progress, show};
use bosquet::derive::Progress;
use bosquet::text::counted;
use notify::{RecommendedWatcher, RecursiveMode, Watcher};
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::sync::atomic::Ordering;
use std::sync::mpsc::{Receiver, RecvTimeoutError, channel};
use std::time::{Duration, Instant};

/// So long nothing may change before a run begins: editors write in several steps.
const QUIET: Duration = Duration::from_millis(120);
/// How often Ctrl-C is looked for.
const TICK: Duration = Duration::from_millis(100);

/// Files by path as the user would write it, each with the hash of what was read.
type Files = BTreeMap<String, Option<String>>;

/// Runs until Ctrl-C.
pub fn run(arguments: &Arguments) -> Ended {
    if let Err(message) = Job::new(arguments) {
        return Ended::Usage(message);
    }
    let (sender, events) = channel();
    match notify::recommended_watcher(sender) {
        Ok(watcher) => on_threads(&arguments.run, || {
            let (files, folders, progress) = (Files::new(), BTreeSet::new(), progress::interruptible());
            Watch { arguments, watcher, events, folders, files, runs: 0 }.all(&progress)
        }),
        Err(error) => Ended::Usage(format!("files cannot be watched here: {error}")),
    }
}

type Events = Receiver<notify::Result<notify::Event>>;

struct Watch<'a> {
    arguments: &'a Arguments,
    watcher: RecommendedWatcher,
    events: Events,
    /// The folders that are watched, and whether with all below them.
    folders: BTreeSet<(PathBuf, bool)>,
    /// What the last run read.
    files: Files,
    runs: usize,
}

impl Watch<'_> {
    fn all(mut self, progress: &Progress) -> Ended {
        let mut changed = Vec::new();
        while !progress.stopped() {
            self.once(&changed, progress);
            // What changed while a new folder was not watched yet has sent no event.
            changed = if self.look() { self.changed() } else { Vec::new() };
            while changed.is_empty() && !progress.stopped() {
                if self.waited(progress) {
                    changed = self.changed();
                }
            }
        }
        Ended::Well
    }

    /// One run, and its line.
    fn once(&mut self, changed: &[String], progress: &Progress) {
        let begun = Instant::now();
        progress.done.store(0, Ordering::Relaxed);
        self.runs += 1;
        let why = if changed.is_empty() { String::new() } else { format!("{} changed: ", changed.join(", ")) };
        let job = match Job::new(self.arguments) {
            Ok(job) => job,
            Err(message) => {
                // The files of the last run are watched on: one of them is wrong.
                self.files.iter_mut().for_each(|(path, known)| *known = hash_now(path));
                return show::tell(format_args!("{}: {why}error: {message}", self.runs));
            }
        };
        let world = world(&job.basis, &self.arguments.run);
        let done = derive::once(self.arguments, &job, &world, progress, write_changed);
        // What could not be read, whether missing, too large or outside, is compared with what it is now.
        self.files =
            world.asked().into_iter().map(|(path, hash)| (path.clone(), hash.or_else(|| hash_now(&path)))).collect();
        if !matches!(done, Err(Stop::Stopped)) {
            let seconds = begun.elapsed().as_secs_f64();
            show::tell(format_args!("{}: {why}{}", self.runs, words(done, seconds)));
        }
    }

    /// Watches the folders of all files; whether there are new ones among them.
    fn look(&mut self) -> bool {
        let before = self.folders.len();
        let listed = self.listed().into_iter().map(|folder| (folder, true));
        let beside = self.files.keys().flat_map(|path| places(path)).filter_map(|p| Some(p.parent()?.to_path_buf()));
        for (folder, deep) in listed.chain(beside.map(|folder| (folder, false))).collect::<Vec<_>>() {
            let mode = if deep { RecursiveMode::Recursive } else { RecursiveMode::NonRecursive };
            let is_known = [true, deep].into_iter().any(|deep| self.folders.contains(&(folder.clone(), deep)));
            if !is_known && self.watcher.watch(&folder, mode).is_ok() {
                self.folders.insert((folder, deep));
            }
        }
        self.folders.len() > before
    }

    /// Where the folders that were listed lie.
    fn listed(&self) -> Vec<PathBuf> {
        let folders = self.files.iter().filter(|(path, known)| is_listing(path) && known.is_some());
        folders.filter_map(|(path, _)| Path::new(path).canonicalize().ok()).collect()
    }

    /// Waits for a while; whether a file was touched, and all has been quiet since.
    fn waited(&self, progress: &Progress) -> bool {
        let files: BTreeSet<PathBuf> = self.files.keys().flat_map(|path| places(path)).collect();
        let listed = self.listed();
        let mut touched = false;
        loop {
            match self.events.recv_timeout(if touched { QUIET } else { TICK }) {
                Ok(Ok(event)) => touched |= concerns(&event, &files, &listed),
                // Events were lost: one of them may have been ours.
                Ok(Err(_)) => touched = true,
                Err(RecvTimeoutError::Timeout) => return touched,
                Err(RecvTimeoutError::Disconnected) => {
                    std::thread::sleep(TICK);
                    return false;
                }
            }
            if progress.stopped() {
                return false;
            }
        }
    }

    /// The files that are not as the last run read them.
    fn changed(&self) -> Vec<String> {
        self.files.iter().filter(|(path, known)| hash_now(path) != **known).map(|(path, _)| path.clone()).collect()
    }
}

/// What became of a run.
fn words(done: Result<Done, Stop>, seconds: f64) -> String {
    match done {
        Ok(Done { counts, written, errors }) => {
            let errors = if errors > 0 { format!(", {}", counted(errors, "error")) } else { String::new() };
            let written: Vec<String> = written.iter().map(|path| path.display().to_string()).collect();
            let written =
                if written.is_empty() { "nothing new".into() } else { format!("wrote {}", written.join(", ")) };
            format!("{counts}{errors} in {seconds:.1} s; {written}")
        }
        Err(Stop::Unwritten(message)) => format!("error: {message}"),
        Err(Stop::Unready(unready)) => unready.briefly(seconds),
        Err(Stop::Stopped) => "stopped".into(),
    }
}

/// Where a file lies: as it is named, and where links lead.
fn places(path: &str) -> Vec<PathBuf> {
    let path = Path::new(path);
    let folder = path.parent().filter(|folder| !folder.as_os_str().is_empty()).unwrap_or(Path::new("."));
    let named = folder.canonicalize().ok().zip(path.file_name()).map(|(folder, name)| folder.join(name));
    let mut places: Vec<PathBuf> = named.into_iter().chain(path.canonicalize()).collect();
    places.dedup();
    places
}

fn concerns(event: &notify::Event, files: &BTreeSet<PathBuf>, listed: &[PathBuf]) -> bool {
    let is_one = |path: &PathBuf| files.contains(path) || listed.iter().any(|folder| path.starts_with(folder));
    !event.kind.is_access() && (event.need_rescan() || event.paths.iter().any(is_one))
}
