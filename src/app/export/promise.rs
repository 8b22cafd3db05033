//! Errors asked for, estimated and true, side by side.

use crate::check::promise::Row;
use std::fmt::Write;

/// The rows in aligned lines.
#[must_use]
pub fn table(rows: &[Row]) -> String {
    let width = rows.iter().map(|row| row.scene.chars().count()).max().unwrap_or(0);
    let mut text = "errors asked for, estimated and true\n".to_owned();
    let _ =
        writeln!(text, "  {:width$}  {:12}{:>8}{:>10}{:>11}{:>10}", "", "", "springs", "asked", "estimated", "true");
    for row in rows {
        let word = if row.kept { "ok" } else { "FAILED: the true error is larger than the estimate" };
        let springs = if row.springs > 0 { row.springs.to_string() } else { String::new() };
        let (scene, solver) = (row.scene, row.solver);
        let [asked, estimated, error] = [row.asked, row.estimated, row.error];
        let _ = writeln!(
            text,
            "  {scene:width$}  {solver:12}{springs:>8}{asked:>10.0e}{estimated:>11.1e}{error:>10.1e}  {word}"
        );
    }
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
