//! A sweep as a table: its parameters, its named results, its warnings.

use super::{Row, Sweep};
use crate::run::table::{Content, Filled, Table};
use crate::run::unit::Unit;
use crate::text::place::Value;

/// The rows of a sweep under the paths of its parameters, the names of its results, `error_estimate`, `warnings`, and
/// `failure` where a scene could not be computed. Numbers are in SI units; a value that does not exist is empty.
#[must_use]
pub fn table(sweep: &Sweep, rows: &[Row]) -> Table {
    let mut columns = Vec::new();
    for (at, axis) in sweep.axes().iter().enumerate() {
        let pick = |row: &Row| axis.values.get(*sweep.picks(row.number).get(at)?);
        columns.push(column(&axis.path, rows.iter().map(pick).collect()));
    }
    for name in names(rows) {
        columns.push(column(name, rows.iter().map(|row| row.value(name)).collect()));
    }
    let estimates = rows.iter().map(|row| row.error_estimate).collect();
    columns.push(filled("error_estimate", Content::Numbers(estimates)));
    columns.push(filled("warnings", Content::Words(rows.iter().map(|row| row.warnings.join("; ")).collect())));
    if rows.iter().any(|row| row.failure.is_some()) {
        let failures = rows.iter().map(|row| row.failure.clone().unwrap_or_default());
        columns.push(filled("failure", Content::Words(failures.collect())));
    }
    Table { name: "sweep", columns }
}

/// Names of the results of all rows, in the order in which they first appear.
fn names(rows: &[Row]) -> Vec<&str> {
    let mut names: Vec<&str> = Vec::new();
    for (name, _) in rows.iter().flat_map(|row| &row.results) {
        if !names.contains(&name.as_str()) {
            names.push(name);
        }
    }
    names
}

fn column(name: &str, values: Vec<Option<&Value>>) -> Filled {
    let numbers = values.iter().all(|value| value.is_none_or(|value| value.is_number() || value.is_null()));
    filled(
        name,
        if numbers {
            Content::Numbers(values.iter().map(|value| value.and_then(Value::as_f64)).collect())
        } else {
            Content::Words(values.into_iter().map(|value| value.map_or_else(String::new, words)).collect())
        },
    )
}

/// A word without its quotes; anything else as JSON.
fn words(value: &Value) -> String {
    value.as_str().map_or_else(|| value.to_string(), str::to_owned)
}

fn filled(name: &str, cells: Content) -> Filled {
    Filled { quantity: name.to_owned(), unit: Unit::ONE, label: "", cells }
}
