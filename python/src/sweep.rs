//! Sweeps: all rows, or those of one chunk, on all threads.

use crate::columns::columns;
use crate::scene::{Source, Wrong, value};
use crate::watch::watched;
use pyo3::prelude::*;
use pyo3::types::PyDict;
use rayon::prelude::*;
use springbed::input::problem::Problem;
use springbed::input::values::Values;
use springbed::scene::Scene;
use springbed::sweep::{Arrangement, Axis, Curves, Row, Sweep, table};
use springbed::text::place::Places;

/// A place and its values: as the command line writes them, or a list in JSON.
type Set = Vec<(String, String, bool)>;

fn made(scene: &Scene, set: &Set, zip: bool) -> Result<Sweep, Problem> {
    let places = Places::of(&Scene { sweep: None, ..scene.clone() })?;
    let axis = |(path, text, written): &(String, String, bool)| {
        let at = |error: String| Problem::new(path, error);
        if *written {
            let values: Values =
                text.parse().map_err(|error: springbed::input::values::ValuesError| at(error.to_string()))?;
            return Axis::new(&places, path, &values);
        }
        let listed = value(text)?.as_array().cloned().ok_or_else(|| at("expected a list of values".to_owned()))?;
        Axis::given(&places, path, listed)
    };
    let axes = set.iter().map(axis).collect::<Result<Vec<_>, _>>()?;
    let arrangement = if zip { Arrangement::Zip } else { Arrangement::Grid };
    Sweep::over(scene, axes, arrangement)
}

fn read(source: &Source, set: &Set, zip: bool) -> Result<Sweep, Wrong> {
    let plan = source.plan()?;
    match Sweep::written(&plan.scene) {
        Some(written) if set.is_empty() => written,
        _ => made(&plan.scene, set, zip),
    }
    .map_err(|problem| Wrong::Places(vec![problem]))
}

/// Number of rows of a sweep, and the paths of what is varied.
#[pyfunction]
pub fn rows(py: Python<'_>, source: Source, set: Set, zip: bool) -> PyResult<(usize, Vec<String>)> {
    let sweep = watched(py, move |_| read(&source, &set, zip))?.map_err(|wrong| wrong.raised(py))?;
    Ok((sweep.rows(), sweep.axes().iter().map(|axis| axis.path.clone()).collect()))
}

/// Rows of a sweep, from one up to another, as columns: parameters, results, `error_estimate`, `warnings`, `failure`.
#[pyfunction]
pub fn sweep<'py>(
    py: Python<'py>,
    source: Source,
    set: Set,
    zip: bool,
    range: (usize, usize),
) -> PyResult<Bound<'py, PyDict>> {
    let computed = watched(py, move |wanted| {
        let sweep = read(&source, &set, zip)?;
        let all = range.0..range.1.min(sweep.rows());
        let row = |number| (!wanted.is_given_up()).then(|| sweep.row(number, &source.tables(), Curves::Absent));
        let rows: Option<Vec<Row>> = all.into_par_iter().map(row).collect();
        Ok(table(&sweep, &rows.unwrap_or_default()))
    })?;
    columns(py, computed.map_err(|wrong: Wrong| wrong.raised(py))?)
}
