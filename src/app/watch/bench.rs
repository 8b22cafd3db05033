//! What is to be seen, kept up to date: the newest text is computed, and what it has overtaken is forgotten.

use super::drawing::{Drawn, Slider, Told, drawn, sliders, told};
use crate::app::fault::Fault;
use crate::text::written;
use serde::Serialize;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Condvar, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant, SystemTime, UNIX_EPOCH};

/// Computations at a time: one that has been overtaken ends where it next tells how far it is, beside the newest.
const MOST_RUNNING: usize = 4;
/// Work as long as this is told of.
const LONG: Duration = Duration::from_millis(150);

/// Why a computation has ended without an answer: there is something newer.
struct Overtaken;

/// Numbers set by sliders, by their paths.
pub type Set = Vec<(String, f64)>;

/// Whether the tables a scene reads have been saved since the last look.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Tables {
    /// None has.
    Same,
    /// At least one has.
    Changed,
}

/// A scene on the bench; all copies are the same one.
#[derive(Clone)]
pub struct Bench {
    /// Its file.
    pub path: PathBuf,
    shared: Arc<(Mutex<Inner>, Condvar)>,
}

/// All that changes.
#[derive(Default)]
struct Inner {
    /// Text of the file, or what is wrong with the file, and how often that has changed.
    text: String,
    unread: Vec<Told>,
    revision: u64,
    saved: Option<SystemTime>,
    set: Set,
    /// Number of the newest text, with sliders, of the newest begun and of that which is shown.
    asked: u64,
    begun: u64,
    shown: u64,
    since: Option<Instant>,
    running: usize,
    drawn: Arc<Drawn>,
    /// Number of what a page can see, and whether that tells of work going on.
    version: u64,
    busy: bool,
}

/// What a page is told.
#[derive(Serialize)]
struct View<'v> {
    version: u64,
    revision: u64,
    busy: bool,
    file: String,
    /// Milliseconds since 1970 at which the file was saved.
    saved: Option<f64>,
    text: String,
    sliders: Vec<Slider>,
    set: &'v Set,
    drawn: &'v Drawn,
}

/// Why numbers are not put in or saved.
#[derive(Debug, Clone, Copy, PartialEq, Eq, thiserror::Error)]
pub enum Stale {
    /// The file has been saved since.
    #[error("the file has changed since")]
    Changed,
}

impl Bench {
    /// The scene in a file that has not been looked at yet.
    #[must_use]
    pub fn of(path: &Path) -> Self {
        Self { path: path.to_owned(), shared: Arc::default() }
    }

    fn lock(&self) -> MutexGuard<'_, Inner> {
        self.shared.0.lock().unwrap_or_else(PoisonError::into_inner)
    }

    /// Tables the scene shown reads.
    #[must_use]
    pub fn tables(&self) -> Vec<PathBuf> {
        self.lock().drawn.tables.clone()
    }

    /// The file holds this; sliders go back.
    pub fn saved(&self, read: Result<String, Vec<Fault>>, saved: Option<SystemTime>, tables: Tables) {
        let mut inner = self.lock();
        let (text, unread) = match read {
            Ok(text) => (text, Vec::new()),
            Err(faults) => (String::new(), told(faults)),
        };
        let same = inner.revision > 0 && inner.text == text && inner.unread.is_empty() == unread.is_empty();
        if same && tables == Tables::Same {
            return;
        }
        if !same {
            inner.set.clear();
            inner.revision += 1;
        }
        (inner.text, inner.unread, inner.saved) = (text, unread, saved);
        self.ask(inner);
    }

    /// Sliders of the file as it was at `revision` stand so.
    ///
    /// # Errors
    /// The file has changed.
    pub fn set(&self, revision: u64, set: Set) -> Result<(), Stale> {
        let mut inner = self.lock();
        if revision != inner.revision {
            return Err(Stale::Changed);
        }
        inner.set = set;
        self.ask(inner);
        Ok(())
    }

    /// The text of the file as it was at `revision`, and that with the numbers of its sliders.
    ///
    /// # Errors
    /// The file has changed.
    pub fn texts(&self, revision: u64) -> Result<(String, String), Stale> {
        let inner = self.lock();
        let texts = || (inner.text.clone(), written::with(&inner.text, &inner.set));
        if revision == inner.revision { Ok(texts()) } else { Err(Stale::Changed) }
    }

    /// There is something newer to compute.
    fn ask(&self, mut inner: MutexGuard<'_, Inner>) {
        inner.asked += 1;
        inner.since = Some(Instant::now());
        if inner.running < MOST_RUNNING {
            inner.running += 1;
            let bench = self.clone();
            std::thread::spawn(move || while bench.computes_the_newest() {});
        }
    }

    /// Computes the newest text unless that is done already.
    fn computes_the_newest(&self) -> bool {
        let mut inner = self.lock();
        if inner.begun == inner.asked {
            inner.running -= 1;
            return false;
        }
        inner.begun = inner.asked;
        let (number, text) = (inner.asked, written::with(&inner.text, &inner.set));
        let unread = inner.unread.clone();
        drop(inner);
        let work = || drawn(&self.path, &text, &|_| self.gives_way(number));
        let found = if unread.is_empty() { caught(work) } else { Some(Drawn { faults: unread, ..Drawn::default() }) };
        if let Some(found) = found {
            self.show(number, found);
        }
        true
    }

    /// Ends the present computation if its text is not the newest any more.
    ///
    /// Unwinds up to [`caught`], through whatever threads it is done on, without a word of a panic.
    fn gives_way(&self, number: u64) {
        if self.lock().asked != number {
            std::panic::resume_unwind(Box::new(Overtaken));
        }
    }

    /// Shows what came out of the text of a number, unless something newer is shown.
    fn show(&self, number: u64, mut found: Drawn) {
        let mut inner = self.lock();
        if number <= inner.shown {
            return;
        }
        if !found.faults.is_empty() && found.tables.is_empty() {
            found.tables = inner.drawn.tables.clone();
        }
        (inner.shown, inner.drawn, inner.busy) = (number, Arc::new(found), number < inner.asked && inner.busy);
        inner.version += 1;
        self.shared.1.notify_all();
    }

    /// Tells of work that takes long.
    pub fn tick(&self) {
        let mut inner = self.lock();
        let long = inner.since.is_some_and(|since| since.elapsed() > LONG);
        if inner.shown < inner.asked && long && !inner.busy {
            inner.busy = true;
            inner.version += 1;
            self.shared.1.notify_all();
        }
    }

    /// What is to be seen as JSON, as soon as it is newer than `after`; none if that takes longer than `patience`.
    #[must_use]
    pub fn newer(&self, after: u64, patience: Duration) -> Option<String> {
        let waiting = self.shared.1.wait_timeout_while(self.lock(), patience, |inner| inner.version <= after);
        let (inner, _) = waiting.unwrap_or_else(PoisonError::into_inner);
        if inner.version <= after {
            return None;
        }
        let saved = inner.saved.and_then(|at| at.duration_since(UNIX_EPOCH).ok());
        let view = View {
            version: inner.version,
            revision: inner.revision,
            busy: inner.busy,
            file: self.path.file_name().unwrap_or_default().to_string_lossy().into_owned(),
            saved: saved.map(|since| 1e3 * since.as_secs_f64()),
            text: written::with(&inner.text, &inner.set),
            sliders: sliders(&inner.text),
            set: &inner.set,
            drawn: &inner.drawn,
        };
        serde_json::to_string(&view).ok()
    }
}

/// What `work` gives, or a fault where it failed as no work should: the page lives on.
fn caught(work: impl FnOnce() -> Drawn) -> Option<Drawn> {
    let failed = || Drawn {
        faults: told(vec![Fault::whole(
            Path::new(""),
            "springbed has failed where it should not: please report the scene",
        )]),
        ..Drawn::default()
    };
    match std::panic::catch_unwind(std::panic::AssertUnwindSafe(work)) {
        Ok(found) => Some(found),
        Err(why) if why.is::<Overtaken>() => None,
        Err(_) => Some(failed()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_overtaken_ends_without_a_word() {
        assert!(caught(|| std::panic::resume_unwind(Box::new(Overtaken))).is_none());
        assert!(
            caught(|| std::panic::resume_unwind(Box::new("another"))).is_some_and(|found| !found.faults.is_empty())
        );
    }

    #[test]
    fn only_the_newest_goes_on() {
        let bench = Bench { path: PathBuf::new(), shared: Arc::default() };
        bench.lock().asked = 2;
        bench.gives_way(2);
        let older = || {
            bench.gives_way(1);
            Drawn::default()
        };
        assert!(caught(older).is_none());
    }
}
