//! Tables of the library as NumPy arrays by the names of their columns.

use numpy::IntoPyArray;
use pyo3::prelude::*;
use pyo3::types::{PyDict, PyList};
use springbed::run::table::{Content, Table};

/// The columns of a table: arrays of numbers, NaN where there is none, and lists of words.
pub fn columns(py: Python<'_>, table: Table) -> PyResult<Bound<'_, PyDict>> {
    let columns = PyDict::new(py);
    for column in table.columns {
        let name = column.name();
        match column.cells {
            Content::Numbers(numbers) => {
                let numbers: Vec<f64> = numbers.into_iter().map(|number| number.unwrap_or(f64::NAN)).collect();
                // The array takes the numbers over; nothing is copied.
                columns.set_item(name, numbers.into_pyarray(py))?;
            }
            Content::Words(words) => columns.set_item(name, PyList::new(py, words)?)?,
        }
    }
    Ok(columns)
}
