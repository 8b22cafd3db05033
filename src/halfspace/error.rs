//! What can be wrong with a half-space problem, and what to do about it.

/// Reason why a half-space contact has no answer; rows and columns count from zero.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum HalfSpaceError {
    /// A height map without a single pixel.
    #[error("the height map is empty ({rows} rows, {columns} columns); it needs at least one pixel")]
    Empty {
        /// Rows given.
        rows: usize,
        /// Columns given.
        columns: usize,
    },
    /// A height that is NaN or −∞ (+∞ is allowed: no material there).
    #[error(
        "the height at row {row}, column {column} is {value}; heights are finite, or +inf where the indenter has no material"
    )]
    Height {
        /// Row of the pixel.
        row: usize,
        /// Column of the pixel.
        column: usize,
        /// The value found.
        value: f64,
    },
    /// A height map whose every pixel is +∞.
    #[error("every height is +inf: the indenter has no material to touch with")]
    NoMaterial,
    /// A number outside its range.
    #[error("{name} is {value}; it must be {wanted}")]
    Parameter {
        /// Which number.
        name: &'static str,
        /// The value given.
        value: f64,
        /// The range that would be right.
        wanted: &'static str,
    },
    /// A start that does not fit the grid or is not a pressure.
    #[error("the starting pressure has {found_rows}×{found_columns} pixels, the height map {rows}×{columns}")]
    StartSize {
        /// Rows of the start.
        found_rows: usize,
        /// Columns of the start.
        found_columns: usize,
        /// Rows of the height map.
        rows: usize,
        /// Columns of the height map.
        columns: usize,
    },
    /// A starting pressure that is negative, NaN or infinite.
    #[error("the starting pressure at row {row}, column {column} is {value}; it must be finite and not negative")]
    StartValue {
        /// Row of the pixel.
        row: usize,
        /// Column of the pixel.
        column: usize,
        /// The value found.
        value: f64,
    },
    /// More memory than allowed; refused before anything is allocated.
    #[error(
        "a grid of {rows}×{columns} needs about {needed} bytes, {limit} are allowed: take a coarser grid or raise the limit"
    )]
    Memory {
        /// Rows of the grid.
        rows: usize,
        /// Columns of the grid.
        columns: usize,
        /// Bytes the solution would take.
        needed: u64,
        /// Bytes allowed.
        limit: u64,
    },
    /// A periodic surface pushed in deeper than its mean height: full contact carries any load there.
    #[error(
        "an indentation of {indentation} m reaches the mean height {mean} m of the periodic surface: it is in full contact and the indentation no longer decides the load; control the force instead"
    )]
    FullContact {
        /// Indentation asked for \[m\].
        indentation: f64,
        /// Mean height of the surface \[m\].
        mean: f64,
    },
    /// The residual did not fall below the tolerance.
    #[error(
        "no convergence: residual {residual:e} after {iterations} iterations, {tolerance:e} asked for; raise max_iterations or the tolerance"
    )]
    NotConverged {
        /// Iterations made on the finest grid.
        iterations: usize,
        /// Relative residual reached.
        residual: f64,
        /// Relative residual asked for.
        tolerance: f64,
    },
}
