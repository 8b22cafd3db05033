//! A comparison of methods as table, CSV and JSON.

use super::with_prefix;
use crate::check::comparison::{Comparison, Method, Row, State};
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
    line(format!("  {}", state_in_words(&comparison.state)));
    line(format!("  errors relative to: {}", comparison.reference));
    let is_rough = comparison.state.contact_radius_m.is_none();
    let is_plane = comparison.rows.iter().any(|row| row.method == Method::HalfPlane);
    let names = if is_rough {
        ROUGH
    } else if is_plane {
        PLANE
    } else {
        SMOOTH
    };
    let [first, second, third, last] = names;
    line(format!(
        "  {:<12}{:>10}{first:>13}{second:>12}{third:>12}{:>12}{:>11}{last:>12}",
        "method", "fineness", "time", "memory"
    ));
    for row in &comparison.rows {
        line(if is_rough { rough_cells(row) } else { cells(row) });
    }
    for note in &comparison.notes {
        line(format!("  note: {note}"));
    }
    text
}

const SMOOTH: [&str; 4] = ["force", "radius", "pressure", "iterations"];
const PLANE: [&str; 4] = ["indentation", "half width", "pressure", "iterations"];
const ROUGH: [&str; 4] = ["indentation", "stiffness", "pressure", "area share"];

/// The state compared.
fn state_in_words(state: &State) -> String {
    let mut words =
        vec![format!("at d = {}: F = {}", with_prefix(state.indentation_m, "m"), with_prefix(state.force_n, "N"))];
    let mut add = |name: &str, value: Option<f64>, unit: &str| {
        words.extend(value.map(|value| format!("{name} {}", with_prefix(value, unit))));
    };
    add("a =", state.contact_radius_m, "m");
    add("k =", state.stiffness_n_per_m, "N/m");
    add("largest pressure", state.peak_pressure_pa, "Pa");
    words.extend(state.area_fraction.map(|share| format!("contact on {:.2} % of the area", 100.0 * share)));
    words.join(", ")
}

fn cells(row: &Row) -> String {
    let iterations = row.iterations.map_or_else(String::new, |count| count.to_string());
    // Plane contacts are compared under a force.
    aligned(row, [row.force_error.or(row.indentation_error), row.radius_error, row.pressure_error], &iterations)
}

fn rough_cells(row: &Row) -> String {
    let share = row.state.area_fraction.map_or_else(String::new, |share| format!("{:.2} %", 100.0 * share));
    aligned(row, [row.indentation_error, row.stiffness_error, row.pressure_error], &share)
}

fn aligned(row: &Row, errors: [Option<f64>; 3], last: &str) -> String {
    let [first, second, third] = errors.map(|error| error.map_or("–".to_owned(), |error| format!("{error:+.1e}")));
    let (time, memory) = (short(row.time_s, "s"), short(row.bytes as f64, "B"));
    format!(
        "  {:<12}{:>10}{first:>13}{second:>12}{third:>12}{time:>12}{memory:>11}{last:>12}",
        row.method.name(),
        fineness(row),
    )
}

fn fineness(row: &Row) -> String {
    match (row.springs, row.grid) {
        (Some(springs), _) => springs.to_string(),
        (_, Some(strips)) if row.method == Method::HalfPlane => strips.to_string(),
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
        "indentation_error",
        "stiffness_error",
        "indentation_m",
        "stiffness_n_per_m",
        "area_fraction",
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
        number(row.state.contact_radius_m),
        number(row.state.peak_pressure_pa),
        number(row.indentation_error),
        number(row.stiffness_error),
        number(Some(row.state.indentation_m)),
        number(row.state.stiffness_n_per_m),
        number(row.state.area_fraction),
    ]
}

/// The comparison as JSON.
///
/// # Errors
/// The text cannot be put together (never for a comparison).
pub fn comparison_json(comparison: &Comparison) -> Result<String, serde_json::Error> {
    serde_json::to_string_pretty(comparison).map(|text| text + "\n")
}
