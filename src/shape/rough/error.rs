//! What can be wrong with a rough shape.

/// Why a spectrum, a rough line or a height map was refused.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum RoughError {
    /// Two cut-off wavelengths in the wrong order.
    #[error("cut-offs out of order: {larger} = {larger_value:?} m must be {relation} {smaller} = {smaller_value:?} m")]
    CutOffs {
        /// Name of the wavelength that must be the larger one.
        larger: &'static str,
        /// Its value [m].
        larger_value: f64,
        /// "above" or "at least".
        relation: &'static str,
        /// Name of the wavelength that must be the smaller one.
        smaller: &'static str,
        /// Its value [m].
        smaller_value: f64,
    },
    /// Not exactly one of the two ways to say how rough the surface is.
    #[error("{0} of `rms` and `amplitude`: give the rms height or the plateau of the spectrum, not both")]
    RmsOrAmplitude(&'static str),
    /// The spectrum holds waves shorter than two steps of the grid.
    #[error(
        "spectrum finer than the grid: shortest wavelength {short:?} m needs a step of at most half of it, but the step is {step:?} m ({length:?} m in {points} points); use at least {needed} points"
    )]
    TooFine {
        /// Shortest wavelength of the spectrum [m].
        short: f64,
        /// Step of the grid [m].
        step: f64,
        /// Length of the grid [m].
        length: f64,
        /// Points on the length.
        points: usize,
        /// Points that would do.
        needed: usize,
    },
    /// The spectrum holds waves longer than the line or surface.
    #[error("spectrum longer than the sample: longest wavelength {long:?} m does not fit into the length {length:?} m")]
    TooLong {
        /// Longest wavelength of the spectrum [m].
        long: f64,
        /// Length of the line or surface [m].
        length: f64,
    },
    /// A row of a tabulated spectrum that makes no sense.
    #[error("spectrum row {row}: {fault}")]
    SpectrumRow {
        /// Row, counted from 1.
        row: usize,
        /// What is wrong with it.
        fault: String,
    },
    /// A tabulated spectrum without two rows.
    #[error("a spectrum needs at least two rows of wavevector and density, found {0}")]
    SpectrumRows(usize),
    /// A number that must be positive and finite and is not.
    #[error("{name} = {value:?} is out of range: expected a finite number above zero")]
    NotPositive {
        /// What it is.
        name: &'static str,
        /// Its value.
        value: f64,
    },
    /// A height that is not a number.
    #[error("height in row {row}, column {column} is {value:?}: expected a finite number")]
    Height {
        /// Row, counted from 1.
        row: usize,
        /// Column, counted from 1.
        column: usize,
        /// The value found.
        value: f64,
    },
    /// A height map too small to have a spectrum.
    #[error("a height map needs at least 4 rows and 4 columns, found {rows} × {columns}")]
    TooSmall {
        /// Rows of the map.
        rows: usize,
        /// Columns of the map.
        columns: usize,
    },
}

/// `value` if it is finite and above zero.
pub(crate) fn positive(name: &'static str, value: f64) -> Result<f64, RoughError> {
    if value.is_finite() && value > 0.0 { Ok(value) } else { Err(RoughError::NotPositive { name, value }) }
}
