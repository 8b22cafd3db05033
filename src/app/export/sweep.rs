//! A sweep as JSON, and what is said of it.

use super::summary::with_prefix;
use crate::run::unit::Unit;
use crate::scene::Scene;
use crate::sweep::{Arrangement, Axis, Row, Sweep};
use crate::text::place::Value;
use serde::{Serialize, Serializer, ser::SerializeMap};
use std::fmt::Write;

/// Most warnings that are said; all of them stand in the table.
const MOST_WARNINGS: usize = 3;

#[derive(Serialize)]
struct Summary<'a> {
    version: &'a str,
    scene: Described<'a>,
    parameters: &'a [Axis],
    arrangement: Arrangement,
    rows: Vec<Computed<'a>>,
}

#[derive(Serialize)]
struct Described<'a> {
    title: &'a str,
    file: &'a str,
    resolved: &'a Scene,
}

#[derive(Serialize)]
struct Computed<'a> {
    parameters: InOrder<&'a str, &'a Value>,
    results: InOrder<&'a str, &'a Value>,
    error_estimate: Option<f64>,
    warnings: &'a [String],
    #[serde(skip_serializing_if = "Option::is_none")]
    failure: Option<&'a str>,
}

impl<'a> Computed<'a> {
    fn of(sweep: &'a Sweep, row: &'a Row) -> Self {
        let paths = sweep.axes().iter().map(|axis| axis.path.as_str());
        Self {
            parameters: InOrder(paths.zip(sweep.values(row.number)).collect()),
            results: InOrder(row.results.iter().map(|(name, value)| (name.as_str(), value)).collect()),
            error_estimate: row.error_estimate,
            warnings: &row.warnings,
            failure: row.failure.as_deref(),
        }
    }
}

/// A map in the order of its entries.
struct InOrder<K, V>(Vec<(K, V)>);

impl<K: Serialize, V: Serialize> Serialize for InOrder<K, V> {
    fn serialize<S: Serializer>(&self, serializer: S) -> Result<S::Ok, S::Error> {
        let mut map = serializer.serialize_map(Some(self.0.len()))?;
        for (name, value) in &self.0 {
            map.serialize_entry(name, value)?;
        }
        map.end()
    }
}

/// The JSON text of a sweep: the version that computed it, the file of the scene and the scene.
///
/// # Errors
/// The scene or the results cannot be written as JSON.
pub fn sweep_json(
    (version, file): (&str, &str),
    scene: &Scene,
    sweep: &Sweep,
    rows: &[Row],
) -> Result<String, serde_json::Error> {
    let summary = Summary {
        version,
        scene: Described { title: &scene.title, file, resolved: scene },
        parameters: sweep.axes(),
        arrangement: sweep.arrangement(),
        rows: rows.iter().map(|row| Computed::of(sweep, row)).collect(),
    };
    let mut text = serde_json::to_string_pretty(&summary)?;
    text.push('\n');
    Ok(text)
}

/// From where to where the named results go, as aligned lines with SI prefixes.
#[must_use]
pub fn sweep_summary(title: &str, sweep: &Sweep, rows: &[Row]) -> String {
    let mut text = String::new();
    if !title.is_empty() {
        let _ = writeln!(text, "{title}");
    }
    let lines: Vec<(String, String)> = ranges(rows).into_iter().map(shown).collect();
    let width = lines.iter().map(|line| line.0.chars().count()).max().unwrap_or(0).max("scenes".len());
    let axes: Vec<String> = sweep.axes().iter().map(|axis| format!("{} of {}", axis.values.len(), axis.path)).collect();
    let by = if sweep.arrangement() == Arrangement::Grid { " × " } else { ", " };
    let _ = writeln!(text, "  {:width$}  {}: {}", "scenes", rows.len(), axes.join(by));
    for (name, range) in lines {
        let _ = writeln!(text, "  {name:width$}  {range}");
    }
    text
}

/// Least and largest value of each numeric result, in the order of the results.
pub fn ranges(rows: &[Row]) -> Vec<(&str, f64, f64)> {
    let mut ranges: Vec<(&str, f64, f64)> = Vec::new();
    for (name, value) in rows.iter().flat_map(|row| &row.results) {
        let Some(value) = value.as_f64() else { continue };
        match ranges.iter_mut().find(|range| range.0 == name) {
            Some(range) => *range = (name, range.1.min(value), range.2.max(value)),
            None => ranges.push((name, value, value)),
        }
    }
    ranges
}

fn shown((name, least, largest): (&str, f64, f64)) -> (String, String) {
    let (quantity, unit) = Unit::of_name(name);
    let number = |number: f64| match unit.prefixed {
        true => with_prefix(number, unit.symbol),
        false => format!("{number:.6} {}", unit.symbol).trim_end().to_owned(),
    };
    let same = least.total_cmp(&largest).is_eq();
    let range = if same { number(least) } else { format!("{} … {}", number(least), number(largest)) };
    (quantity.replace('_', " "), range)
}

/// The first warnings of the rows, each with the number of its row, and how many there are beside.
#[must_use]
pub fn sweep_warnings(rows: &[Row]) -> Vec<String> {
    let all = || rows.iter().flat_map(|row| row.warnings.iter().map(move |warning| (row.number, warning)));
    let mut said: Vec<String> =
        all().take(MOST_WARNINGS).map(|(number, warning)| format!("row {number}: {warning}")).collect();
    let more = all().count().saturating_sub(MOST_WARNINGS);
    if more > 0 {
        said.push(format!("{more} more warnings stand in the table"));
    }
    said
}
