//! Half-plane twins: plane contact of a line of heights, free or periodic.

use ndarray::ArrayView1;

use super::grid::Law;
use super::input::{Input, Raw};
use super::transform::Size;
use super::{HalfSpaceError, Prescribed, Settings, Start};

/// What happens at the ends of the line.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum PlaneBoundary {
    /// The half-plane goes on, load-free. Its displacement grows with the logarithm of the distance, so it only
    /// exists relative to a datum: it is zero at this distance from a line load \[m\],
    /// u(x) = (2/πE*) ∫ p(s) ln(datum/|x − s|) ds. Pressure under a given force does not depend on it.
    /// It must be at least the length of the line, lest a load lift its own neighbours.
    Free {
        /// Distance of zero displacement \[m\].
        datum: f64,
    },
    /// Everything repeats; the mean displacement is zero.
    Periodic,
}

/// A line of heights and how it is pressed on a half-plane.
#[derive(Debug, Clone, Copy)]
pub struct PlaneProblem<'a> {
    /// Heights of the rigid indenter, away from the half-plane \[m\]; +∞ where it has no material.
    pub heights: ArrayView1<'a, f64>,
    /// Distance of the heights \[m\].
    pub step: f64,
    /// Effective modulus E* \[Pa\].
    pub modulus: f64,
    /// Ends of the line.
    pub boundary: PlaneBoundary,
    /// Prescribed indentation \[m\], or force per length \[N/m\].
    pub control: Prescribed,
}

/// Solution of a half-plane contact.
#[derive(Debug, Clone, PartialEq)]
pub struct PlaneSolution {
    /// Pressure on each strip \[Pa\], never negative.
    pub pressure: Vec<f64>,
    /// Displacement of each strip into the half-plane, relative to the datum \[m\].
    pub displacement: Vec<f64>,
    /// Approach d of the heights' zero level and the datum \[m\].
    pub indentation: f64,
    /// Relative residual, computed from the pressure returned.
    pub residual: f64,
    /// Conjugate gradient iterations on the finest grid.
    pub iterations: usize,
    /// Width of a strip \[m\].
    pub step: f64,
}

impl PlaneSolution {
    /// Width of all strips under pressure \[m\].
    pub fn contact_width(&self) -> f64 {
        self.pressure.iter().filter(|&&p| p > 0.0).count() as f64 * self.step
    }

    /// Largest pressure \[Pa\].
    pub fn peak_pressure(&self) -> f64 {
        self.pressure.iter().copied().fold(0.0, f64::max)
    }
}

/// Pressure and displacement of a line of heights pressed on a half-plane; `start` is a pressure to start from.
///
/// # Errors
/// As for [`solve`](super::solve), and a datum closer than the line is long.
pub fn solve_plane(
    problem: &PlaneProblem<'_>,
    start: Option<&[f64]>,
    settings: &Settings,
) -> Result<PlaneSolution, HalfSpaceError> {
    let columns = problem.heights.len();
    let law = law(problem, columns as f64 * problem.step)?;
    let size = Size { rows: usize::from(columns > 0), columns };
    let input = Input { size, pixel: [problem.step; 2], modulus: problem.modulus, law, control: problem.control };
    let row = start.map(|pressure| ArrayView1::from(pressure).insert_axis(ndarray::Axis(0)));
    let heights = problem.heights.insert_axis(ndarray::Axis(0));
    let raw = input.solve(&heights, row.map_or(Start::Coarser, Start::Pressure), (settings, None))?;
    Ok(solution(problem, raw))
}

fn law(problem: &PlaneProblem<'_>, length: f64) -> Result<Law, HalfSpaceError> {
    match problem.boundary {
        PlaneBoundary::Periodic => Ok(Law::PeriodicPlane),
        PlaneBoundary::Free { datum } if datum.is_finite() && datum >= length => Ok(Law::FreePlane(datum)),
        PlaneBoundary::Free { datum } => Err(HalfSpaceError::Parameter {
            name: "datum",
            value: datum,
            wanted: "finite and at least the length of the line",
        }),
    }
}

fn solution(problem: &PlaneProblem<'_>, raw: Raw) -> PlaneSolution {
    PlaneSolution {
        pressure: raw.pressure,
        displacement: raw.displacement,
        indentation: raw.approach,
        residual: raw.residual,
        iterations: raw.iterations,
        step: problem.step,
    }
}
