//! Parameters of a scene from measured curves.

use crate::errors::failed;
use crate::scene::{Source, Wrong};
use crate::watch::watched;
use numpy::{IntoPyArray, PyReadonlyArray1};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use springbed::app::export::{self, Fitted};
use springbed::app::fitting::Fitting;
use springbed::fit::Readings;
use springbed::input::problem::Problem;
use springbed::scene::fit::Measured;
use std::path::PathBuf;

/// A curve as the package hands it over: the path of its file, or arrays of depth [m] and force [N], of speed [m/s] and
/// restitution or of slide [m] and tangential force [N], and, if it was measured, time [s].
#[derive(FromPyObject)]
pub enum Measurement<'py> {
    File(PathBuf),
    Timed(PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>),
    Untimed(PyReadonlyArray1<'py, f64>, PyReadonlyArray1<'py, f64>),
}

/// A curve that is the interpreter's no more.
enum Owned {
    File(PathBuf),
    Curve([Vec<f64>; 2], Option<Vec<f64>>),
}

impl Measurement<'_> {
    fn owned(self) -> Owned {
        let numbers = |array: PyReadonlyArray1<'_, f64>| array.as_array().to_vec();
        let (first, second, time) = match self {
            Self::File(path) => return Owned::File(path),
            Self::Timed(depth, force, time) => (numbers(depth), numbers(force), Some(numbers(time))),
            Self::Untimed(depth, force) => (numbers(depth), numbers(force), None),
        };
        Owned::Curve([first, second], time)
    }
}

/// What the scene itself asks for, with the values of `options`, a JSON text, in its place.
fn measured(written: Option<Measured>, options: &str) -> Result<Measured, String> {
    let mut all = serde_json::to_value(written.unwrap_or_default()).map_err(|error| error.to_string())?;
    let given: serde_json::Map<_, _> = serde_json::from_str(options).map_err(|error| error.to_string())?;
    if let Some(all) = all.as_object_mut() {
        all.extend(given);
    }
    serde_json::from_value(all).map_err(|error| error.to_string())
}

fn fitted(source: &Source, options: &str, curve: Owned) -> Result<Fitted, Wrong> {
    let scene = source.plan()?.scene.clone();
    let asked = |message: String| Wrong::Places(vec![Problem::new("fit", message)]);
    let measured = measured(scene.fit.clone(), options).map_err(asked)?;
    let fitting = Fitting::new(&measured, &scene, &source.folder).map_err(asked)?;
    let found = match curve {
        Owned::File(path) => fitting.of_file(&path, &source.tables()),
        Owned::Curve(columns, time) => fitting.of_curve("arrays", fitting.curve(columns, time), &source.tables()),
    };
    found.map_err(Wrong::Failed)
}

/// Fits one curve; gives what `springbed.Fit` is made of.
#[pyfunction]
pub fn fit<'py>(
    py: Python<'py>,
    source: Source,
    options: String,
    curve: Measurement<'py>,
) -> PyResult<Bound<'py, PyDict>> {
    let curve = curve.owned();
    let fitted = watched(py, move |_| fitted(&source, &options, curve))?.map_err(|wrong| wrong.raised(py))?;
    let parts = PyDict::new(py);
    parts.set_item("summary", export::fit_json(&fitted).map_err(|error| failed(py, error))?)?;
    parts.set_item("figure", export::fit_figure(&fitted).svg())?;
    let Fitted { curve, fit, .. } = fitted;
    let mut counts = vec![false; curve.len()];
    for &at in &fit.used {
        counts.get_mut(at).into_iter().for_each(|one| *one = true);
    }
    let (names, columns) = named(curve.readings);
    for (name, column) in names.into_iter().zip(columns) {
        parts.set_item(name, column.into_pyarray(py))?;
    }
    parts.set_item("model", fit.model.into_pyarray(py))?;
    parts.set_item("counts", counts.into_pyarray(py))?;
    Ok(parts)
}

/// The two columns and what they are called.
fn named(readings: Readings) -> ([&'static str; 2], [Vec<f64>; 2]) {
    match readings {
        Readings::Indentation { depth, force } => (["indentation_m", "force_n"], [depth, force]),
        Readings::Impacts { speed, restitution } => (["speed_m_per_s", "restitution"], [speed, restitution]),
        Readings::Slides { slide, force } => (["slide_m", "tangential_force_n"], [slide, force]),
    }
}
