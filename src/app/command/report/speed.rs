//! `springbed report speed`: throughput of the kernels.

use super::{Common, deliver};
use crate::app::console::{Console, Failure};
use crate::app::export::throughput as export;
use crate::app::machine::Machine;
use crate::app::progress::Progress;
use crate::check::throughput;
use crate::check::work_precision::Effort;

/// Every kernel at several sizes.
///
/// # Errors
/// A kernel fails, or a file cannot be written.
pub fn run(effort: Effort, common: &Common, console: &Console) -> Result<(), Failure> {
    let kernels = throughput::all();
    let progress = Progress::of("report speed", console);
    let mut behind = 0.0;
    #[expect(clippy::cast_precision_loss, reason = "few kernels")]
    let rows = throughput::rows(&kernels, 5 * effort.budget(), || {
        behind += 1.0;
        progress.done(behind / kernels.len() as f64);
    });
    drop(progress);
    let machine = Machine::here();
    let json = export::json(&rows, &machine).map_err(Failure::failed)?;
    let csv = export::csv(&rows).map_err(Failure::failed)?;
    let said = if common.json { json.clone() } else { export::table(&rows, &machine) };
    #[cfg_attr(not(feature = "plot"), expect(unused_mut, reason = "no figure"))]
    let mut files = vec![("speed.csv".to_owned(), csv), ("speed.json".to_owned(), json)];
    #[cfg(feature = "plot")]
    files.push(("speed.svg".to_owned(), export::figure(&rows, &machine).svg()));
    deliver(files, &said, common, console)?;
    let failed: Vec<&str> = rows.iter().filter(|row| row.time_s.is_nan()).map(|row| row.kernel).collect();
    if failed.is_empty() { Ok(()) } else { Err(Failure::Failed(format!("failed: {}", failed.join(", ")))) }
}
