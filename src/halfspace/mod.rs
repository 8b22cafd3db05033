//! Frictionless normal contact of a height map on an elastic half-space: the referee of the spring bed.
//!
//! The rigid indenter's heights h above its lowest point, the surface displacement u into the half-space
//! and the approach d leave the gap g = u + h − d. Sought is the pressure p with
//!
//! > g ≥ 0, p ≥ 0, p·g = 0 on every pixel, u = G p,
//!
//! where G is the exact influence of uniformly loaded pixels (free boundary: Love 1929; Johnson, Contact
//! Mechanics, eq. 3.25) or 2/(E*|q|) on every wave (periodic boundary, Johnson eq. 13.7).
//! The equality in contact is solved by conjugate gradients (Polonsky & Keer 1999), preconditioned
//! by an approximate inverse of G in Fourier space; the contact is corrected as often as its own error is
//! what is left. Each grid starts from the solution of a grid of half the resolution. Steps are made with transforms in
//! single precision; what they are off by is found in the gap, which is computed in double, and worked off.
//!
//! **Residual.** The largest |g| where p > 0 and the largest −g elsewhere, over the whole grid, relative to the
//! largest displacement in contact (or to what the largest pressure does to its own pixel, if that is more).
//! It is computed from the pressure returned, not from the iteration's own recurrence.
//!
//! # Examples
//! ```
//! use ndarray::Array2;
//! use springbed::halfspace::{Boundary, Prescribed, PressedMap, Settings, Start, solve};
//!
//! // A ball, R = E* = 1, pressed by 0.01 on 32² pixels: the depth is Hertz' (3F/4)^{2/3} to a few per cent.
//! let side = 1.5 * 0.0075f64.cbrt() / 16.0;
//! let place = |k: usize| (k as f64 - 16.0) * side;
//! let heights = Array2::from_shape_fn((32, 32), |(i, j)| 0.5 * (place(i).powi(2) + place(j).powi(2)));
//! let problem = PressedMap {
//!     heights: heights.view(),
//!     pixel: [side; 2],
//!     modulus: 1.0,
//!     boundary: Boundary::Free,
//!     control: Prescribed::Force(0.01),
//! };
//! let solution = solve(&problem, Start::Coarser, &Settings::default())?;
//! assert!((solution.indentation / 0.0075f64.powf(2.0 / 3.0) - 1.0).abs() < 0.02);
//! # Ok::<(), springbed::halfspace::HalfSpaceError>(())
//! ```

mod alone;
mod coupled;
mod error;
mod face;
mod grid;
mod input;
mod kernel;
mod leak;
mod lengthwise;
mod line;
mod pieces;
mod precision;
mod response;
mod run;
mod solution;
mod spectrum;
pub mod steady;
mod transform;
mod vector;
mod yielding;

pub use crate::shape::Boundary;
pub use coupled::{CoupledResponse, RubbedState, RubbingMap};
pub use error::HalfSpaceError;
pub use leak::leak;
pub use lengthwise::lengthwise;
pub use line::{PlaneBoundary, PlaneProblem, PlaneSolution, solve_plane};
pub use pieces::{Pieces, pieces};
pub use response::SurfaceResponse;
pub use solution::Solution;

use ndarray::ArrayView2;

use grid::Law;
use input::Input;
use transform::Size;

/// What is prescribed.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Prescribed {
    /// Approach d of the height map's zero level and the undeformed surface \[m\].
    Indentation(f64),
    /// Normal force on the map \[N\], compression positive.
    Force(f64),
}

/// A height map and how it is pressed.
#[derive(Debug, Clone, Copy)]
pub struct PressedMap<'a> {
    /// Heights of the rigid indenter, upwards, i.e. away from the half-space \[m\]: f(x, y) of a ball is
    /// r²/2R. +∞ where it has no material.
    pub heights: ArrayView2<'a, f64>,
    /// Pixel width (along a row) and height (from row to row) \[m\].
    pub pixel: [f64; 2],
    /// Effective modulus E* \[Pa\].
    pub modulus: f64,
    /// Edge of the map.
    pub boundary: Boundary,
    /// Prescribed quantity.
    pub control: Prescribed,
}

/// Numerical settings.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Settings {
    /// Relative residual (see the module) to reach; default 1e-8, between 1e-14 and 0.1.
    /// Larger leaves the pressure rough, below about 1e-13 rounding keeps it from being reached.
    pub tolerance: f64,
    /// Iterations allowed on the finest grid; default 2000. Too few end in an error.
    pub max_iterations: usize,
    /// Bytes the solution may take; default 8 GiB. A larger grid is refused before it is allocated.
    pub memory_limit: u64,
}

impl Default for Settings {
    fn default() -> Self {
        Self { tolerance: 1e-8, max_iterations: 2000, memory_limit: 8 << 30 }
    }
}

/// Pressure the iteration starts from.
#[derive(Debug, Clone, Copy, Default)]
pub enum Start<'a> {
    /// The solution on a grid of half the resolution, started likewise.
    #[default]
    Coarser,
    /// No knowledge: every overlapping pixel, or a uniform pressure.
    Nothing,
    /// A pressure on the same pixels \[Pa\], for instance the spring bed's.
    Pressure(ArrayView2<'a, f64>),
}

/// Pressure and displacement of a height map pressed on a half-space.
///
/// # Errors
/// [`HalfSpaceError`] for an empty map, a height that is NaN or −∞, a number out of range, a grid larger than
/// the memory allowed, an indentation beyond full contact, and an iteration that does not converge.
pub fn solve(problem: &PressedMap<'_>, start: Start<'_>, settings: &Settings) -> Result<Solution, HalfSpaceError> {
    solved(problem, start, (settings, None))
}

/// The same for one of many maps on the same pixels, whose `response` is known; if it yields, the pressures end at its
/// hardness and the surfaces overlap where they do, by what is dented for good.
///
/// # Errors
/// As [`solve`].
///
/// # Panics
/// The response is that of other pixels.
pub fn solve_on(
    response: &SurfaceResponse,
    problem: &PressedMap<'_>,
    start: Start<'_>,
    settings: &Settings,
) -> Result<Solution, HalfSpaceError> {
    assert!(response.suits(problem), "the response of other pixels");
    let Prescribed::Force(force) = problem.control else { return solved(problem, start, (settings, Some(response))) };
    let elastic = solved(problem, start, (settings, Some(response)))?;
    if elastic.peak_pressure() <= response.hardness() {
        return Ok(elastic);
    }
    yielding::under_force(response, (problem, force), elastic, settings)
}

fn solved(
    problem: &PressedMap<'_>,
    start: Start<'_>,
    how: (&Settings, Option<&SurfaceResponse>),
) -> Result<Solution, HalfSpaceError> {
    let (rows, columns) = problem.heights.dim();
    let law = match problem.boundary {
        Boundary::Free => Law::FreeSpace,
        Boundary::Periodic => Law::PeriodicSpace,
    };
    let input = Input {
        size: Size { rows, columns },
        pixel: problem.pixel,
        modulus: problem.modulus,
        law,
        control: problem.control,
    };
    let raw = input.solve(&problem.heights, start, how)?;
    Ok(Solution::new(problem, raw))
}

/// Bytes that [`solve`] takes for a grid of this many rows and columns, an upper bound.
pub fn bytes_needed(size: [usize; 2], boundary: Boundary) -> u64 {
    input::bytes_needed(Size { rows: size[0], columns: size[1] }, boundary == Boundary::Periodic)
}

#[cfg(test)]
mod tests;
