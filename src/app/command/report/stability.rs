//! `springbed report stability`: stiff and extreme scenes.

use super::{Common, deliver};
use crate::app::console::{Console, Failure};
use crate::app::export::stability as export;
use crate::app::machine::Machine;
use crate::app::progress::Progress;
use crate::check::stability::{self, Row};
use std::sync::atomic::{AtomicUsize, Ordering};

/// Every trial against its exact answer or law.
///
/// # Errors
/// An error is beyond its bound, a law is broken, or a file cannot be written.
pub fn run(common: &Common, console: &Console) -> Result<(), Failure> {
    let trials = stability::all();
    let progress = Progress::of("report stability", console);
    let behind = AtomicUsize::new(0);
    let all = trials.len();
    #[expect(clippy::cast_precision_loss, reason = "few trials")]
    let rows = stability::rows(&trials, || {
        let done = behind.fetch_add(1, Ordering::Relaxed) + 1;
        progress.done(done as f64 / all as f64);
    });
    drop(progress);
    let machine = Machine::here();
    let json = export::json(&rows, &machine).map_err(Failure::failed)?;
    let csv = export::csv(&rows).map_err(Failure::failed)?;
    let said = if common.json { json.clone() } else { export::table(&rows, &machine) };
    let files = vec![("stability.csv".to_owned(), csv), ("stability.json".to_owned(), json)];
    deliver(files, &said, common, console)?;
    verdict(&rows)
}

fn verdict(rows: &[Row]) -> Result<(), Failure> {
    let failed: Vec<&str> = rows.iter().filter(|row| !row.passed).map(|row| row.name).collect();
    if failed.is_empty() { Ok(()) } else { Err(Failure::Failed(format!("beyond their bounds: {}", failed.join("; ")))) }
}
