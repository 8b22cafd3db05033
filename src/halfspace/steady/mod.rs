//! Steady sliding over a half-space that remembers.
//!
//! A body slides along x at the speed v, and has done so for ever: with ξ = x − vt the pressure p(ξ, y) stands still, and
//! each place of the ground has been loaded by what lies before it,
//!
//! > u(ξ, y) = ∫₀^∞ J̇(s) (g ∗ p)(ξ + vs, y) ds, û = 2p̂/(|k| E*(ω)), ω = −k_x v,
//!
//! J(s) the creep compliance, g = 1/(πr) the influence of a point, E*(ω) the complex modulus (Persson 2001; Carbone &
//! Putignano 2013, J. Mech. Phys. Solids 61, 1822). The contact is sought as at rest, u + h ≥ d, p ≥ 0; what the ground gives back too
//! late is the resistance F_x = −∫ p ∂u/∂ξ dA, and F_x v is all turned into heat. Where everything repeats, what is
//! the same all along the motion (k_x = 0) is never relieved: it is borne by E∞ at any speed.
//!
//! # Examples
//! ```
//! use ndarray::Array2;
//! use springbed::halfspace::steady::{SteadyResponse, Travelled};
//! use springbed::halfspace::{Boundary, Prescribed, Settings};
//! use springbed::material::{Relaxation, Spectrum};
//! use std::f64::consts::{PI, TAU};
//!
//! // A wave of height h pressed flat on a ground of the modulus 1 + 1·e^{−t}: F_x = ½πh²·E″(kv)/λ·… of each wavelength.
//! let ground = Spectrum::new(&Relaxation { equilibrium: 1.0, terms: vec![(1.0, 1.0)], viscosity: 0.0 });
//! let height = 0.01;
//! let wave = Array2::from_shape_fn((2, 64), |(_, j)| height * (1.0 - (TAU * j as f64 / 64.0).cos()));
//! let speed = 1.0 / TAU;
//! let travelled = Travelled { pixel: [1.0 / 64.0; 2], boundary: Boundary::Periodic, speed, ground: None };
//! let response = SteadyResponse::new(&ground, [2, 64], &travelled);
//! let contact = response.solve(wave.view(), Prescribed::Force(0.01), None, &Settings::default())?;
//! // p̂ = |k|E*(ω)û/2: per area ½ k² h² E″(kv)/2, here k = 2π, kv = 1 and E″ = 1/2.
//! let exact = 0.25 * TAU.powi(2) * height.powi(2) * 0.5 * (2.0 / 64.0);
//! assert!((contact.resistance / exact - 1.0).abs() < 1e-9);
//! # Ok::<(), springbed::halfspace::HalfSpaceError>(())
//! ```

mod face;
mod kernel;
mod subspace;
#[cfg(test)]
mod tests;

use super::grid::Grid;
use super::input::Raw;
use super::precision::Scratch;
use super::transform::{Multiplier, Size};
use super::vector::dot;
use super::{Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Solution, Start};
use crate::ground::Ground;
use crate::material::Spectrum;
use face::SlidingContact;
use ndarray::ArrayView2;
use realfft::num_complex::Complex;
use std::fmt::{self, Debug, Formatter};
use std::sync::Arc;

/// How a body slides over pixels.
#[derive(Debug, Clone)]
pub struct Travelled {
    /// Pixel width (along which it slides) and height \[m\].
    pub pixel: [f64; 2],
    /// Edge of the map.
    pub boundary: Boundary,
    /// Speed v \[m/s\], towards larger x; at least zero.
    pub speed: f64,
    /// What lies beneath if it is not alike at all depths, all of it of one relaxation; periodic maps alone.
    pub ground: Option<Arc<dyn Ground>>,
}

/// The steady state of a body that slides.
#[derive(Debug, Clone, PartialEq)]
pub struct SteadyContact {
    /// Pressure and displacement.
    pub solution: Solution,
    /// Force against the motion F_x \[N\].
    pub resistance: f64,
}

/// What pressures that slide do to the pixels of a half-space: made once for many loads at one speed.
pub struct SteadyResponse {
    influence: Multiplier<Complex<f64>>,
    stiffness: Multiplier<Complex<f64>>,
    /// Pressure → −∂u/∂ξ.
    slope: Multiplier<Complex<f64>>,
    compliance: f64,
    size: Size,
    pixel: [f64; 2],
    boundary: Boundary,
    unit: f64,
    /// E*∞ \[Pa\].
    modulus: f64,
}

impl Debug for SteadyResponse {
    fn fmt(&self, f: &mut Formatter<'_>) -> fmt::Result {
        let Self { size, pixel, boundary, modulus, .. } = self;
        f.debug_struct("SteadyResponse")
            .field("size", size)
            .field("pixel", pixel)
            .field("boundary", boundary)
            .field("modulus", modulus)
            .finish_non_exhaustive()
    }
}

impl SteadyResponse {
    /// Of `[rows, columns]` pixels on a ground of the plane modulus E*(t) whose `spectrum` this is; a solid.
    #[must_use]
    pub fn new(spectrum: &Spectrum, [rows, columns]: [usize; 2], travelled: &Travelled) -> Self {
        let size = Size { rows, columns };
        let &Travelled { pixel, boundary, .. } = travelled;
        let unit = pixel[0].sqrt() * pixel[1].sqrt();
        let grid = Grid { size, pixel: pixel.map(|side| side / unit), heights: Vec::new() };
        let depths = kernel::Depths { ground: travelled.ground.as_ref(), unit };
        let late = kernel::Late::new(spectrum, travelled.speed, unit);
        let kernel::Symbols { period, influence, slope, compliance } = match boundary {
            Boundary::Periodic => kernel::periodic(&grid, &late, depths),
            Boundary::Free => kernel::free(&grid, &late),
        };
        let stiffness = kernel::inverse(&grid, &late, (boundary, depths));
        Self {
            influence: Multiplier::new(size, period, influence),
            stiffness: Multiplier::new(size, size, stiffness),
            slope: Multiplier::new(size, period, slope),
            compliance,
            size,
            pixel,
            boundary,
            unit,
            modulus: spectrum.equilibrium(),
        }
    }

    /// The contact of `heights` \[m\], its pressures sought from `start` \[Pa\] on, or from those of a body at rest.
    ///
    /// # Errors
    /// As [`solve`](super::solve).
    pub fn solve(
        &self,
        heights: ArrayView2<'_, f64>,
        control: Prescribed,
        start: Option<ArrayView2<'_, f64>>,
        settings: &Settings,
    ) -> Result<SteadyContact, HalfSpaceError> {
        let (pixel, boundary) = (self.pixel, self.boundary);
        let problem = PressedMap { heights, pixel, modulus: self.modulus, boundary, control };
        let pressure = match start.filter(|start| start.iter().any(|&p| p > 0.0)) {
            Some(start) => start.to_owned(),
            None => {
                let resting = super::solve(&problem, Start::Coarser, &Settings { tolerance: 1e-3, ..*settings })?;
                if resting.contact_pixels() == 0 {
                    return Ok(SteadyContact { solution: resting, resistance: 0.0 });
                }
                resting.pressure
            }
        };
        let pressure: Vec<f64> = pressure.iter().map(|p| p / self.modulus).collect();
        let scaled: Vec<f64> = heights.iter().map(|height| height / self.unit).collect();
        let contact = SlidingContact {
            influence: &self.influence,
            stiffness: &self.stiffness,
            columns: self.size.columns,
            heights: &scaled,
            load: match control {
                Prescribed::Indentation(depth) => face::Load::Approach(depth / self.unit),
                Prescribed::Force(force) => face::Load::Sum(force / (self.modulus * self.unit * self.unit)),
            },
            compliance: self.compliance,
        };
        let found = contact.solve(pressure, settings)?;
        let resistance = self.resistance(&found.pressure);
        Ok(SteadyContact { solution: Solution::new(&problem, self.in_si(found)), resistance })
    }

    /// −∫ p ∂u/∂ξ dA \[N\] of a pressure in the solver's units.
    fn resistance(&self, pressure: &[f64]) -> f64 {
        let mut slope = vec![0.0; pressure.len()];
        self.slope.apply(pressure, &mut slope, &mut Scratch::default());
        self.modulus * self.unit * self.unit * dot(pressure, &slope)
    }

    fn in_si(&self, found: face::Found) -> Raw {
        let times = |values: Vec<f64>, unit: f64| values.into_iter().map(|value| unit * value).collect();
        Raw {
            pressure: times(found.pressure, self.modulus),
            displacement: times(found.displacement, self.unit),
            approach: found.approach * self.unit,
            residual: found.residual,
            iterations: found.iterations,
            products: found.products,
            bytes: self.bytes(),
        }
    }

    /// Upper bound of the bytes that a solution takes.
    fn bytes(&self) -> u64 {
        let complex = 3 * 2 * 2 * self.size.pixels();
        let real = (8 + face::DIRECTIONS) * self.size.pixels();
        8 * u64::try_from(complex + real).unwrap_or(u64::MAX / 8)
    }
}
