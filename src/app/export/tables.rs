//! Tables as CSV.

use crate::run::table::{Content, Filled, Table};

/// A table as CSV: the names of its columns, then its rows.
///
/// # Errors
/// The text cannot be put together (never for a table of a simulation).
pub fn csv(table: &Table) -> Result<String, csv::Error> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record(table.columns.iter().map(Filled::name))?;
    for row in 0..table.rows() {
        writer.write_record(table.columns.iter().map(|column| match &column.cells {
            Content::Numbers(numbers) => cell(numbers[row]),
            Content::Words(words) => words[row].clone(),
        }))?;
    }
    text(writer)
}

/// The shortest text that reads back as the same number; empty where there is none.
pub(super) fn cell(value: Option<f64>) -> String {
    // Adding zero turns −0 into 0.
    value.filter(|value| value.is_finite()).map_or_else(String::new, |value| format!("{:?}", value + 0.0))
}

pub(super) fn text(writer: csv::Writer<Vec<u8>>) -> Result<String, csv::Error> {
    let bytes = writer.into_inner().map_err(|error| std::io::Error::other(error.to_string()))?;
    String::from_utf8(bytes).map_err(|error| std::io::Error::other(error).into())
}
