//! Measured tables by name: what the physics asks of whoever can read files.
//!
//! A scene names a table by its path; physics opens no file, so the reader comes in as a
//! [`Tables`]. What a table must hold (rising radii, rising times) is checked where it is used, and
//! the error carries the row of the file so that a person finds it in their editor.
//!
//! # Examples
//! ```
//! use springbed::input::table::{InMemory, Tables};
//!
//! let tables = InMemory::default().with("h.csv", &[("time_s", &[0.0, 1.0]), ("force_n", &[0.0, 2.0])]);
//! let columns = tables.columns("h.csv".as_ref(), &["force_n"])?;
//! assert_eq!(columns.values, [[0.0, 2.0]]);
//! assert!(tables.columns("h.csv".as_ref(), &["depth_m"]).is_err());
//! # Ok::<(), springbed::input::table::TableError>(())
//! ```

use ndarray::Array2;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Columns of a table, all of one length.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Columns {
    /// The columns in the order they were asked for, in SI units.
    pub values: Vec<Vec<f64>>,
    /// Row of the file (the first line is 1) in which each line of values stands.
    pub rows: Vec<usize>,
}

/// What is wrong with a table, and where.
#[derive(Debug, Clone, PartialEq, Eq, thiserror::Error)]
#[error("{}{}: {message}", path.display(), row.map_or_else(String::new, |row| format!(", row {row}")))]
pub struct TableError {
    /// The table.
    pub path: PathBuf,
    /// Row of the file, the first line being 1; `None` if the table as a whole is meant.
    pub row: Option<usize>,
    /// What was found and what would be right.
    pub message: String,
}

impl TableError {
    /// An error about the whole table.
    pub fn whole(path: &Path, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), row: None, message: message.into() }
    }

    /// An error about one row of the file.
    pub fn at(path: &Path, row: usize, message: impl Into<String>) -> Self {
        Self { path: path.to_owned(), row: Some(row), message: message.into() }
    }
}

/// A source of tables, which several threads may ask.
pub trait Tables: Sync {
    /// Names of the columns the table at `path` has, in its order.
    ///
    /// # Errors
    /// The table cannot be read.
    fn names(&self, path: &Path) -> Result<Vec<String>, TableError>;

    /// The named columns of the table at `path`.
    ///
    /// # Errors
    /// The table cannot be read, has no such column, or holds something that is not a finite number.
    fn columns(&self, path: &Path, names: &[&str]) -> Result<Columns, TableError>;

    /// The matrix of numbers at `path`, such as a height map.
    ///
    /// # Errors
    /// The matrix cannot be read, is empty or ragged, or holds something that is not a finite number.
    fn heights(&self, path: &Path) -> Result<Array2<f64>, TableError>;

    /// The measured surface at `path`, with what its file says of unit and size, and NaN where a height is missing.
    ///
    /// # Errors
    /// It cannot be read.
    fn topography(&self, path: &Path) -> Result<RawMap, TableError> {
        Ok(RawMap { heights: self.heights(path)?, unit: None, sides: None })
    }
}

/// Heights as a file has them.
#[derive(Debug, Clone, PartialEq)]
pub struct RawMap {
    /// Numbers, rows along y and columns along x; NaN where there is none.
    pub heights: Array2<f64>,
    /// What the number 1 stands for [m], if the file says so.
    pub unit: Option<f64>,
    /// Sides along x and y [m], if the file says so.
    pub sides: Option<[f64; 2]>,
}

/// Tables held in memory, for callers of the library that have their columns at hand.
///
/// Row numbers are those of a file with one header line.
#[derive(Debug, Clone, Default)]
pub struct InMemory {
    tables: BTreeMap<PathBuf, Vec<(String, Vec<f64>)>>,
    matrices: BTreeMap<PathBuf, Array2<f64>>,
}

impl InMemory {
    /// The same tables and one more, given as pairs of name and column.
    #[must_use]
    pub fn with(mut self, path: impl Into<PathBuf>, columns: &[(&str, &[f64])]) -> Self {
        let owned = columns.iter().map(|&(name, values)| (name.to_owned(), values.to_vec())).collect();
        self.tables.insert(path.into(), owned);
        self
    }

    /// The same tables and a matrix.
    #[must_use]
    pub fn with_heights(mut self, path: impl Into<PathBuf>, heights: Array2<f64>) -> Self {
        self.matrices.insert(path.into(), heights);
        self
    }

    fn table(&self, path: &Path) -> Result<&[(String, Vec<f64>)], TableError> {
        self.tables.get(path).map(Vec::as_slice).ok_or_else(|| TableError::whole(path, "there is no such table"))
    }
}

impl Tables for InMemory {
    fn names(&self, path: &Path) -> Result<Vec<String>, TableError> {
        Ok(self.table(path)?.iter().map(|(name, _)| name.clone()).collect())
    }

    fn columns(&self, path: &Path, names: &[&str]) -> Result<Columns, TableError> {
        let table = self.table(path)?;
        let values = names
            .iter()
            .map(|&wanted| {
                let found = table.iter().find(|(name, _)| name == wanted);
                found.map(|(_, column)| column.clone()).ok_or_else(|| missing(path, wanted, table))
            })
            .collect::<Result<Vec<_>, _>>()?;
        let length = values.first().map_or(0, Vec::len);
        for (index, line) in (0..length).map(|index| (index, index + 2)) {
            if values.iter().any(|column| column.get(index).is_none_or(|value| !value.is_finite())) {
                return Err(TableError::at(path, line, "expected a finite number in every column"));
            }
        }
        Ok(Columns { values, rows: (2..length + 2).collect() })
    }

    fn heights(&self, path: &Path) -> Result<Array2<f64>, TableError> {
        self.matrices.get(path).cloned().ok_or_else(|| TableError::whole(path, "there is no such table"))
    }
}

fn missing(path: &Path, wanted: &str, table: &[(String, Vec<f64>)]) -> TableError {
    let known: Vec<&str> = table.iter().map(|(name, _)| name.as_str()).collect();
    TableError::whole(path, format!("there is no column \"{wanted}\", only {}", known.join(", ")))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_come_in_the_order_asked_for_with_rows_of_the_file() {
        let tables = InMemory::default().with("tip.csv", &[("height_m", &[0.0, 1.0]), ("radius_m", &[0.0, 2.0])]);
        let columns = tables.columns(Path::new("tip.csv"), &["radius_m", "height_m"]).unwrap();
        assert_eq!(columns.values, [[0.0, 2.0], [0.0, 1.0]]);
        assert_eq!(columns.rows, [2, 3]);
    }

    #[test]
    fn an_error_names_table_and_row() {
        let tables = InMemory::default().with("tip.csv", &[("radius_m", &[0.0, f64::NAN])]);
        let error = tables.columns(Path::new("tip.csv"), &["radius_m"]).unwrap_err();
        assert_eq!(error.to_string(), "tip.csv, row 3: expected a finite number in every column");
        let error = tables.columns(Path::new("tip.csv"), &["height_m"]).unwrap_err();
        assert_eq!(error.to_string(), "tip.csv: there is no column \"height_m\", only radius_m");
    }
}
