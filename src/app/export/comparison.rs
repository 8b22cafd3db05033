//! A comparison of methods as table, CSV and JSON.

use super::reports::{self, Heading};
use super::with_prefix;
use crate::check::comparison::{Compared, Comparison};
use crate::check::row::{Found, Row};
use std::fmt::Write;

/// The comparison as an aligned table.
#[must_use]
pub fn comparison_text(title: &str, comparison: &Comparison) -> String {
    let mut text = if title.is_empty() { String::new() } else { format!("{title}\n") };
    let _ = writeln!(text, "  {}", in_words(&comparison.state));
    let _ = writeln!(text, "  errors relative to: {}", comparison.reference);
    let compared = comparison.compared;
    let [first, second, third, last] = match compared {
        Compared::Round => ["force", "radius", "pressure", "iterations"],
        Compared::Plane => ["indentation", "half width", "pressure", "iterations"],
        Compared::Rough => ["indentation", "stiffness", "pressure", "area share"],
    };
    let head = ["method", "fineness", first, second, third, "time", "memory", last].map(str::to_owned).to_vec();
    let lines: Vec<_> = std::iter::once(head).chain(comparison.rows.iter().map(|row| cells(row, compared))).collect();
    text.push_str(&reports::aligned(&lines));
    for note in &comparison.notes {
        let _ = writeln!(text, "  note: {note}");
    }
    text
}

/// The state compared.
fn in_words(state: &Found) -> String {
    let known =
        |name: &str, value: Option<f64>, unit: &str| value.map(|value| format!("{name} {}", with_prefix(value, unit)));
    let area = state.area_fraction.map(|share| format!("contact on {:.2} % of the area", 100.0 * share));
    let words = [
        known("at d =", state.indentation_m, "m"),
        known("F =", state.force_n, "N"),
        known("a =", state.contact_radius_m, "m"),
        known("k =", state.stiffness_n_per_m, "N/m"),
        known("largest pressure", state.peak_pressure_pa, "Pa"),
        area,
    ];
    words.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn cells(row: &Row, compared: Compared) -> Vec<String> {
    let errors = &row.errors;
    let iterations = row.solved.iterations.map(|count| count.to_string());
    let share = row.solved.found.area_fraction.map(|share| format!("{:.2} %", 100.0 * share));
    let (errors, last) = match compared {
        Compared::Round => ([errors.force, errors.radius, errors.pressure], iterations),
        Compared::Plane => ([errors.indentation, errors.radius, errors.pressure], iterations),
        Compared::Rough => ([errors.indentation, errors.stiffness, errors.pressure], share),
    };
    let fineness = match (row.setting.springs, row.setting.grid, compared) {
        (Some(springs), ..) => springs.to_string(),
        (_, Some(strips), Compared::Plane) => strips.to_string(),
        (_, Some(grid), _) => format!("{grid}²"),
        _ => String::new(),
    };
    let errors = errors.map(|error| error.map_or("–".to_owned(), |error| format!("{error:+.1e}")));
    let time = row.times.map_or_else(String::new, |times| short(times.warm, "s"));
    let memory = short(row.solved.bytes as f64, "B");
    let first = [row.method.to_owned(), fineness];
    first.into_iter().chain(errors).chain([time, memory, last.unwrap_or_default()]).collect()
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
    reports::csv(&[COMPARED, &UNDER_FORCE[..], STATE].concat(), &comparison.rows)
}

/// The comparison as JSON.
///
/// # Errors
/// The text cannot be put together (never for a comparison).
pub fn comparison_json(comparison: &Comparison) -> Result<String, serde_json::Error> {
    let mut rows = reports::objects(&[COMPARED, &UNDER_FORCE[..]].concat(), &comparison.rows);
    let only_known = ["springs", "grid", "indentation_error", "stiffness_error"];
    for row in rows.iter_mut().filter_map(|row| row.as_object_mut()) {
        row.retain(|name, value| !value.is_null() || !only_known.contains(&name.as_str()));
    }
    let Comparison { reference, state, notes, .. } = comparison;
    let value = serde_json::json!({ "reference": reference, "state": state, "rows": rows, "notes": notes });
    serde_json::to_string_pretty(&value).map(|text| text + "\n")
}

/// What is known of every contact.
const COMPARED: &[Heading] = &[
    ("method", |row| row.method.into()),
    ("springs", |row| row.setting.springs.into()),
    ("grid", |row| row.setting.grid.into()),
    ("force_error", |row| row.errors.force.into()),
    ("radius_error", |row| row.errors.radius.into()),
    ("pressure_error", |row| row.errors.pressure.into()),
    ("time_s", |row| row.times.map(|times| times.warm).into()),
    ("bytes", |row| row.solved.bytes.into()),
    ("iterations", |row| row.solved.iterations.into()),
];

/// What is compared under a force.
const UNDER_FORCE: [Heading; 2] = [
    ("indentation_error", |row| row.errors.indentation.into()),
    ("stiffness_error", |row| row.errors.stiffness.into()),
];

/// What a method has found.
const STATE: &[Heading] = &[
    ("force_n", |row| row.solved.found.force_n.into()),
    ("contact_radius_m", |row| row.solved.found.contact_radius_m.into()),
    ("peak_pressure_pa", |row| row.solved.found.peak_pressure_pa.into()),
    ("indentation_m", |row| row.solved.found.indentation_m.into()),
    ("stiffness_n_per_m", |row| row.solved.found.stiffness_n_per_m.into()),
    ("area_fraction", |row| row.solved.found.area_fraction.into()),
];
