//! A measured curve as the history of a scene.

use super::curve::Curve;
use crate::input::table::{Columns, RawMap, TableError, Tables};
use ndarray::Array2;
use std::path::Path;

/// Part of the first interval in which the first row is reached.
const SOON: f64 = 1e-9;
/// Name of the table that drives.
pub const DRIVE: &str = "measured drive";

/// The curve as a table that drives a scene, beside the tables of the scene itself.
pub struct Prescribed<'d> {
    tables: &'d dyn Tables,
    columns: Vec<(&'static str, Vec<f64>)>,
    rows: &'d [usize],
}

impl<'d> Prescribed<'d> {
    /// Of a curve that gives these columns beside the time, for bodies that relax or not; beside other `tables`.
    ///
    /// # Errors
    /// The bodies relax and there are no times.
    pub fn of(
        (curve, tables): (&'d Curve, &'d dyn Tables),
        columns: Vec<(&'static str, Vec<f64>)>,
        relaxes: bool,
    ) -> Result<Self, String> {
        let time = match &curve.time {
            // What stands in the first row is reached in no time worth it, and not at once: creep needs a way.
            Some(time) => {
                let early = SOON * time.get(1).map_or(1.0, |next| next - time[0]);
                time.iter().map(|t| t - time[0] + early).collect()
            }
            None if relaxes => return Err("bodies that relax need the times: expected a column of them".to_owned()),
            // The order alone matters.
            None => (0..curve.len()).map(|row| row as f64).collect(),
        };
        let columns = std::iter::once(("time_s", time)).chain(columns).collect();
        Ok(Self { tables, columns, rows: &curve.rows })
    }

    fn column(&self, name: &str) -> Vec<f64> {
        self.columns.iter().find(|(known, _)| *known == name).map(|(_, values)| values.clone()).unwrap_or_default()
    }
}

impl Tables for Prescribed<'_> {
    fn names(&self, path: &Path) -> Result<Vec<String>, TableError> {
        if path == Path::new(DRIVE) {
            return Ok(self.columns.iter().map(|(name, _)| (*name).to_owned()).collect());
        }
        self.tables.names(path)
    }

    fn columns(&self, path: &Path, names: &[&str]) -> Result<Columns, TableError> {
        if path == Path::new(DRIVE) {
            let values = names.iter().map(|name| self.column(name)).collect();
            return Ok(Columns { values, rows: self.rows.to_vec() });
        }
        self.tables.columns(path, names)
    }

    fn heights(&self, path: &Path) -> Result<Array2<f64>, TableError> {
        self.tables.heights(path)
    }

    fn topography(&self, path: &Path) -> Result<RawMap, TableError> {
        self.tables.topography(path)
    }
}
