//! A comparison of methods as table, CSV and JSON.

use super::with_prefix;
use crate::check::comparison::{Comparison, Row};
use std::fmt::Write;

/// The comparison as an aligned table.
#[must_use]
pub fn comparison_text(title: &str, comparison: &Comparison) -> String {
    let mut text = String::new();
    let mut line = |line: String| {
        let _ = writeln!(text, "{}", line.trim_end());
    };
    if !title.is_empty() {
        line(title.to_owned());
    }
    let state = &comparison.state;
    let peak = state.peak_pressure_pa.map_or("singular".to_owned(), |pressure| with_prefix(pressure, "Pa"));
    line(format!(
        "  at d = {}: F = {}, a = {}, largest pressure {peak}",
        with_prefix(state.indentation_m, "m"),
        with_prefix(state.force_n, "N"),
        with_prefix(state.contact_radius_m, "m"),
    ));
    line(format!("  errors relative to: {}", comparison.reference));
    line(format!(
        "  {:<12}{:>10}{:>12}{:>12}{:>12}{:>12}{:>11}{:>12}",
        "method", "fineness", "force", "radius", "pressure", "time", "memory", "iterations"
    ));
    for row in &comparison.rows {
        line(cells(row));
    }
    for note in &comparison.notes {
        line(format!("  note: {note}"));
    }
    text
}

fn cells(row: &Row) -> String {
    let error = |error: Option<f64>| error.map_or("–".to_owned(), |error| format!("{error:+.1e}"));
    format!(
        "  {:<12}{:>10}{:>12}{:>12}{:>12}{:>12}{:>11}{:>12}",
        row.method.name(),
        fineness(row),
        error(row.force_error),
        error(row.radius_error),
        error(row.pressure_error),
        short(row.time_s, "s"),
        short(row.bytes as f64, "B"),
        row.iterations.map_or_else(String::new, |count| count.to_string()),
    )
}

fn fineness(row: &Row) -> String {
    match (row.springs, row.grid) {
        (Some(springs), _) => springs.to_string(),
        (_, Some(grid)) => format!("{grid}²"),
        _ => String::new(),
    }
}

/// Three digits and a prefix.
fn short(value: f64, unit: &str) -> String {
    let rounded = format!("{value:.2e}").parse().unwrap_or(value);
    with_prefix(rounded, unit)
}

/// The comparison as CSV.
///
/// # Errors
/// The table cannot be put together (never for a comparison).
pub fn comparison_table(comparison: &Comparison) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "method",
        "springs",
        "grid",
        "force_error",
        "radius_error",
        "pressure_error",
        "time_s",
        "bytes",
        "iterations",
        "force_n",
        "contact_radius_m",
        "peak_pressure_pa",
    ])?;
    for row in &comparison.rows {
        writer.write_record(record(row))?;
    }
    super::tables::text(writer)
}

fn record(row: &Row) -> Vec<String> {
    let count = |count: Option<usize>| count.map_or_else(String::new, |count| count.to_string());
    let number = super::tables::cell;
    vec![
        row.method.name().to_owned(),
        count(row.springs),
        count(row.grid),
        number(row.force_error),
        number(row.radius_error),
        number(row.pressure_error),
        number(Some(row.time_s)),
        row.bytes.to_string(),
        count(row.iterations),
        number(Some(row.state.force_n)),
        number(Some(row.state.contact_radius_m)),
        number(row.state.peak_pressure_pa),
    ]
}

/// The comparison as JSON.
///
/// # Errors
/// The text cannot be put together (never for a comparison).
pub fn comparison_json(comparison: &Comparison) -> Result<String, serde_json::Error> {
    serde_json::to_string_pretty(comparison).map(|text| text + "\n")
}
