//! The full half-space solver on an array of heights.

use crate::errors::failed;
use crate::watch::watched;
use numpy::{IntoPyArray, PyReadonlyArray2};
use pyo3::prelude::*;
use pyo3::types::PyDict;
use springbed::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};

/// What is prescribed, in words of the package.
#[derive(FromPyObject)]
pub struct Pressed {
    modulus: f64,
    force: Option<f64>,
    indentation: Option<f64>,
    periodic: bool,
    tolerance: f64,
}

/// Presses heights [m] on a half-space; the arrays of the solution are handed over, not copied.
#[pyfunction]
pub fn half_space<'py>(
    py: Python<'py>,
    heights: PyReadonlyArray2<'py, f64>,
    pixel: [f64; 2],
    pressed: Pressed,
) -> PyResult<Bound<'py, PyDict>> {
    let heights = heights.as_array().to_owned();
    let solved = watched(py, move |_| {
        let control = match (pressed.force, pressed.indentation) {
            (Some(force), _) => Prescribed::Force(force),
            (None, depth) => Prescribed::Indentation(depth.unwrap_or(f64::NAN)),
        };
        let boundary = if pressed.periodic { Boundary::Periodic } else { Boundary::Free };
        let map = PressedMap { heights: heights.view(), pixel, modulus: pressed.modulus, boundary, control };
        let settings = Settings { tolerance: pressed.tolerance, ..Settings::default() };
        solve(&map, Start::Coarser, &settings).map_err(|error| error.to_string())
    })?;
    let solution = solved.map_err(|why| failed(py, why))?;
    let found = PyDict::new(py);
    found.set_item("force", solution.force())?;
    found.set_item("indentation", solution.indentation)?;
    found.set_item("contact_area", solution.contact_area())?;
    found.set_item("contact_radius", solution.contact_radius())?;
    found.set_item("area_fraction", solution.area_fraction())?;
    found.set_item("peak_pressure", solution.peak_pressure())?;
    found.set_item("residual", solution.residual)?;
    found.set_item("iterations", solution.iterations)?;
    found.set_item("pressure", solution.pressure.into_pyarray(py))?;
    found.set_item("displacement", solution.displacement.into_pyarray(py))?;
    Ok(found)
}
