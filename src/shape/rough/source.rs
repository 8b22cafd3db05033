//! Where a scene takes its spectrum from.

use super::{RoughError, RoughnessSpectrum, SelfAffine};
use crate::input::table::{TableError, Tables};
use serde::{Deserialize, Serialize};
use std::path::PathBuf;

/// The spectrum of a scene: `SelfAffine(…)` or `Table("spectrum.csv")`.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub enum SpectrumSource {
    /// Self-affine between cut-offs.
    SelfAffine(SelfAffine),
    /// A table of C(q) with the columns `wavevector_rad_per_m` and `spectrum_m4`, power laws between its rows.
    Table(PathBuf),
}

/// Why a scene's spectrum was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SourceError {
    /// The table cannot be read, or a row of it makes no sense.
    #[error(transparent)]
    Table(#[from] TableError),
    /// The parameters do not fit together.
    #[error(transparent)]
    Parameters(#[from] RoughError),
}

impl SpectrumSource {
    /// The spectrum, its table read from `tables`.
    ///
    /// # Errors
    /// Cut-offs out of order; a table that cannot be read or does not rise, with the row of the file.
    pub fn spectrum(&self, tables: &dyn Tables) -> Result<RoughnessSpectrum, SourceError> {
        let path = match self {
            Self::SelfAffine(parameters) => return Ok(parameters.spectrum()?),
            Self::Table(path) => path,
        };
        let columns = tables.columns(path, &["wavevector_rad_per_m", "spectrum_m4"])?;
        let [wavevectors, densities] = columns.values.as_slice() else {
            return Err(RoughError::SpectrumRows(0).into());
        };
        let rows: Vec<_> = wavevectors.iter().copied().zip(densities.iter().copied()).collect();
        RoughnessSpectrum::table(&rows).map_err(|error| {
            let RoughError::SpectrumRow { row, fault } = error else {
                return TableError::whole(path, error.to_string()).into();
            };
            let line = columns.rows.get(row - 1).copied().unwrap_or(row);
            TableError::at(path, line, fault).into()
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::table::InMemory;

    #[test]
    fn a_table_is_read_and_a_bad_row_is_found_in_its_file() {
        let columns: [(&str, &[f64]); 2] =
            [("wavevector_rad_per_m", &[1.0, 2.0, 2.0]), ("spectrum_m4", &[1.0, 0.25, 0.1])];
        let bad = InMemory::default().with("s.csv", &columns);
        let source = SpectrumSource::Table("s.csv".into());
        let error = source.spectrum(&bad).unwrap_err().to_string();
        assert_eq!(error, "s.csv, row 4: wavevector 2.0 rad/m does not increase from 2.0 rad/m");
        let columns: [(&str, &[f64]); 2] = [("wavevector_rad_per_m", &[1.0, 2.0]), ("spectrum_m4", &[1.0, 0.25])];
        let good = InMemory::default().with("s.csv", &columns);
        assert!((source.spectrum(&good).unwrap().density(2.0) - 0.25).abs() < 1e-15);
        assert!(source.spectrum(&InMemory::default()).unwrap_err().to_string().contains("no such table"));
    }
}
