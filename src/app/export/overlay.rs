//! Curves of several scenes and of measured data beside each other.

use super::tables::{cell, text};
use crate::run::record::{CONTACT_RADIUS, FORCE, INDENTATION, Outcome, Record, SLIDE, TANGENTIAL_FORCE, TIME};
use crate::run::table::Column;
use std::fmt::Write;

/// Quantities that can be laid over each other.
pub(super) const COLUMNS: [Column<Record>; 6] = [TIME, INDENTATION, FORCE, CONTACT_RADIUS, SLIDE, TANGENTIAL_FORCE];
/// Names of their columns.
pub const OVERLAID: [&str; 6] =
    ["time_s", "indentation_m", "force_n", "contact_radius_m", "slide_m", "tangential_force_n"];

/// The curves of one scene or of one table.
#[derive(Debug, Clone, PartialEq)]
pub struct Overlaid {
    /// What they are of.
    pub label: String,
    /// Whether they are measured.
    pub measured: bool,
    /// For each of the quantities its values, row by row; empty if there are none.
    pub columns: [Vec<Option<f64>>; OVERLAID.len()],
}

impl Overlaid {
    /// The curves of a scene.
    #[must_use]
    pub fn computed(label: String, outcome: &Outcome) -> Self {
        let values = |column: &Column<Record>| -> Vec<Option<f64>> {
            let values: Vec<_> = outcome.records.iter().map(|record| (column.of)(record)).collect();
            if values.iter().all(Option::is_none) { Vec::new() } else { values }
        };
        Self { label, measured: false, columns: COLUMNS.each_ref().map(values) }
    }

    /// The curves in the named columns of a table; `None` if it has not two of those that are known.
    #[must_use]
    pub fn measured(label: String, table: Vec<(String, Vec<f64>)>) -> Option<Self> {
        let of = |name: &str| table.iter().find(|(known, _)| known == name);
        let columns = OVERLAID
            .map(|name| of(name).map_or_else(Vec::new, |(_, values)| values.iter().copied().map(Some).collect()));
        let count = columns.iter().filter(|column| !column.is_empty()).count();
        (count > 1).then_some(Self { label, measured: true, columns })
    }

    /// Number of rows.
    pub(super) fn rows(&self) -> usize {
        self.columns.iter().map(Vec::len).max().unwrap_or(0)
    }
}

/// One table of all curves: what each row is of, then the quantities that any of them has.
///
/// # Errors
/// The text cannot be put together.
pub fn overlay_table(curves: &[Overlaid]) -> Result<String, csv::Error> {
    let present: Vec<usize> =
        (0..OVERLAID.len()).filter(|&at| curves.iter().any(|of| !of.columns[at].is_empty())).collect();
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(std::iter::once("curve").chain(present.iter().map(|&at| OVERLAID[at])))?;
    for of in curves {
        for row in 0..of.rows() {
            let values = present.iter().map(|&at| cell(of.columns[at].get(row).copied().flatten()));
            writer.write_record(std::iter::once(of.label.clone()).chain(values))?;
        }
    }
    text(writer)
}

/// The names of the curves and how far they go.
///
/// # Errors
/// They cannot be written as JSON.
pub fn overlay_json(curves: &[Overlaid]) -> Result<String, serde_json::Error> {
    let one = |of: &Overlaid| {
        let least_and_most = |at: usize| of.columns[at].iter().flatten().fold(None, widened);
        let ranges: serde_json::Map<String, serde_json::Value> = (0..OVERLAID.len())
            .filter_map(|at| Some((OVERLAID[at].to_owned(), serde_json::json!(least_and_most(at)?))))
            .collect();
        serde_json::json!({ "label": of.label, "measured": of.measured, "rows": of.rows(), "ranges": ranges })
    };
    serde_json::to_string_pretty(&serde_json::json!({ "curves": curves.iter().map(one).collect::<Vec<_>>() }))
}

fn widened(range: Option<(f64, f64)>, value: &f64) -> Option<(f64, f64)> {
    let (least, most) = range.unwrap_or((*value, *value));
    Some((least.min(*value), most.max(*value)))
}

/// The names of the curves and their largest forces, line by line.
#[must_use]
pub fn overlay_text(curves: &[Overlaid]) -> String {
    let mut text = String::new();
    let width = curves.iter().map(|of| of.label.chars().count()).max().unwrap_or(0);
    let force = OVERLAID.iter().position(|name| *name == "force_n").unwrap_or(0);
    for of in curves {
        let largest = of.columns[force].iter().flatten().copied().fold(f64::NEG_INFINITY, f64::max);
        let largest = if largest.is_finite() { super::with_prefix(largest, "N") } else { String::new() };
        let _ = writeln!(text, "  {:width$}  {:6} rows  {largest}", of.label, of.rows());
    }
    text
}
