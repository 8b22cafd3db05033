//! Progress of long work: a bar on a terminal, plain lines elsewhere.

use super::console::Console;
use indicatif::{ProgressBar, ProgressStyle};
use std::io::{self, IsTerminal};
use std::sync::atomic::{AtomicU64, Ordering};
use std::time::{Duration, Instant};

/// Steps of the bar.
const STEPS: u64 = 1000;
/// Steps between two plain lines.
const BETWEEN: u64 = STEPS / 20;
/// Work shorter than this is not worth a line.
const PATIENCE: Duration = Duration::from_secs(2);

/// Progress of one piece of work.
pub struct Progress<'c> {
    console: &'c Console,
    what: String,
    bar: Option<ProgressBar>,
    began: Instant,
    /// Step at which the last plain line was printed.
    said: AtomicU64,
}

impl<'c> Progress<'c> {
    /// Nothing done yet of `what`.
    #[must_use]
    pub fn of(what: impl Into<String>, console: &'c Console) -> Self {
        let what = what.into();
        let bar = (console.talks() && io::stderr().is_terminal()).then(|| bar(&what));
        Self { console, what, bar, began: Instant::now(), said: AtomicU64::new(0) }
    }

    /// Tells that a share of the work is behind; from any thread.
    pub fn done(&self, share: f64) {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a thousand")]
        let step = (share.clamp(0.0, 1.0) * STEPS as f64) as u64;
        if let Some(bar) = &self.bar {
            bar.set_position(step);
            return;
        }
        let said = self.said.load(Ordering::Relaxed);
        let due = step >= said + BETWEEN && self.began.elapsed() > PATIENCE;
        // Of several threads one prints the line.
        if due && self.said.compare_exchange(said, step, Ordering::Relaxed, Ordering::Relaxed).is_ok() {
            self.console.message(&format!("  {}: {:.0} %", self.what, 100.0 * share));
        }
    }
}

impl Drop for Progress<'_> {
    fn drop(&mut self) {
        if let Some(bar) = &self.bar {
            bar.finish_and_clear();
        }
    }
}

fn bar(what: &str) -> ProgressBar {
    let style = ProgressStyle::with_template("{msg} {bar:40} {percent} %, {eta} left");
    let bar = ProgressBar::new(STEPS).with_message(what.to_owned());
    bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
