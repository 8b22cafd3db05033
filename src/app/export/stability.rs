//! Stiff and extreme scenes: table, CSV, JSON.

use crate::app::machine::Machine;
use crate::check::stability::{Row, Whose};
use std::fmt::Write;

/// The rows in aligned lines, the range and what it is held against below each.
#[must_use]
pub fn table(rows: &[Row], machine: &Machine) -> String {
    let width = rows.iter().map(|row| row.name.chars().count()).max().unwrap_or(0);
    let mut text = format!("{:width$}  {:>8}  {:>11}  {:>8}  {:>6}\n", "", "scenes", "worst error", "bound", "broken");
    for row in rows {
        let bound = if row.whose == Whose::Ours { format!("{:.0e}", row.bound) } else { "–".to_owned() };
        let word = match (row.whose, row.passed) {
            (Whose::Usual, _) => "the usual way",
            (Whose::Ours, true) => "ok",
            (Whose::Ours, false) => "FAILED",
        };
        let (name, tried, worst, broken) = (row.name, row.tried, row.worst, row.broken);
        let _ = writeln!(text, "{name:width$}  {tried:>8}  {worst:>11.1e}  {bound:>8}  {broken:>6}  {word}");
        let _ = writeln!(text, "    {}", row.range);
        let _ = writeln!(text, "    {}", row.against);
    }
    let _ = writeln!(text, "{}", machine.line());
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
    let passed = rows.iter().all(|row| row.passed);
    serde_json::to_string_pretty(&serde_json::json!({ "passed": passed, "rows": rows, "machine": machine }))
}
