//! Progress of long work: a bar on a terminal, plain lines elsewhere.

use super::console::Console;
use indicatif::{ProgressBar, ProgressStyle};
use std::cell::Cell;
use std::io::{self, IsTerminal};
use std::time::{Duration, Instant};

/// Steps of the bar.
const STEPS: u64 = 1000;
/// Share of the work between two plain lines.
const SHARE: f64 = 0.05;
/// Work shorter than this is not worth a line.
const PATIENCE: Duration = Duration::from_secs(2);

/// Progress of one piece of work.
pub struct Progress<'c> {
    console: &'c Console,
    what: String,
    bar: Option<ProgressBar>,
    began: Instant,
    said: Cell<f64>,
}

impl<'c> Progress<'c> {
    /// Nothing done yet of `what`.
    #[must_use]
    pub fn of(what: impl Into<String>, console: &'c Console) -> Self {
        let what = what.into();
        let bar = (console.talks() && io::stderr().is_terminal()).then(|| bar(&what));
        Self { console, what, bar, began: Instant::now(), said: Cell::new(0.0) }
    }

    /// Tells that a share of the work is behind.
    pub fn done(&self, share: f64) {
        match &self.bar {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a share of a thousand")]
            Some(bar) => bar.set_position((share.clamp(0.0, 1.0) * STEPS as f64) as u64),
            None if share >= self.said.get() + SHARE && self.began.elapsed() > PATIENCE => {
                self.said.set(share);
                self.console.message(&format!("  {}: {:.0} %", self.what, 100.0 * share));
            }
            None => {}
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
