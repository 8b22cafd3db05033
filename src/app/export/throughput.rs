//! Throughput of the kernels: table, CSV, JSON, figure of the scaling.

use crate::app::export::work_precision::seconds;
#[cfg(feature = "plot")]
use crate::app::figure::{Axis, Figure, Guide, Marks, Panel, Series};
use crate::app::machine::Machine;
use crate::check::throughput::Row;
use std::fmt::Write;

/// The rows in aligned lines.
#[must_use]
pub fn table(rows: &[Row], machine: &Machine) -> String {
    let width = rows.iter().map(|row| row.kernel.chars().count()).max().unwrap_or(0);
    let mut text = String::new();
    for row in rows {
        let (kernel, size, counted) = (row.kernel, row.size, row.counted);
        let (time, each) = (seconds(row.time_s), seconds(row.each_s));
        let ratio = row.ratio.map_or_else(String::new, |ratio| format!("{ratio:.2} times {}", row.beside));
        let line = format!("{kernel:width$}  {size:>9} {counted:18}{time:>10}{each:>10} each  {ratio}");
        let _ = writeln!(text, "{}", line.trim_end());
    }
    let _ = writeln!(text, "{}; one kernel at a time, least time of warm repeats", machine.line());
    text
}

/// The rows as CSV.
///
/// # Errors
/// The table cannot be put together (never for rows of a report).
pub fn csv(rows: &[Row]) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    for row in rows {
        writer.serialize(row)?;
    }
    let bytes = writer.into_inner().map_err(|error| std::io::Error::other(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| std::io::Error::other(error).into())
}

/// The rows as JSON.
///
/// # Errors
/// The text cannot be put together (never for rows of a report).
pub fn json(rows: &[Row], machine: &Machine) -> Result<String, serde_json::Error> {
    serde_json::to_string_pretty(&serde_json::json!({ "rows": rows, "machine": machine }))
}

/// Run time against size, for the kernels measured at several sizes.
#[cfg(feature = "plot")]
#[must_use]
#[expect(clippy::cast_precision_loss, reason = "sizes are far below 2^53")]
pub fn figure(rows: &[Row], machine: &Machine) -> Figure {
    let mut panel =
        Panel::new(Axis::log("number of springs, terms, records or pixels", "1"), Axis::log("run time", "s"));
    let mut seen: Vec<&str> = Vec::new();
    for row in rows {
        let same: Vec<&Row> = rows.iter().filter(|other| other.kernel == row.kernel).collect();
        if same.len() > 1 && !seen.contains(&row.kernel) {
            seen.push(row.kernel);
            let points = same.iter().map(|row| (row.size as f64, row.time_s)).collect();
            let label = format!("{}: {}", row.kernel, row.counted);
            panel = panel.with(Series::new(label, points).marks(Marks::Numbered));
        }
    }
    let panel = panel.guide(Guide::slope(1.0, "in proportion")).note(format!("{}.", machine.line()));
    Figure::new("Run time against size").with(panel)
}
