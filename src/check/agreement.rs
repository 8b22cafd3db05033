//! The rough bed held against the full half-space: where they agree and where they do not.
//!
//! # Examples
//! ```
//! use springbed::check::agreement::SelfAffineSquares;
//!
//! // The bed of the equivalent line beside the half-space on one small square.
//! let squares = SelfAffineSquares { hurst: 0.8, points: 32, seeds: vec![1] };
//! let agreement = squares.agreement(|_| ())?;
//! assert!((agreement.law - 1.0 / 1.8).abs() < 1e-15);
//! # Ok::<(), Box<dyn std::error::Error + Send + Sync>>(())
//! ```

use super::case::{Attempt, Pairs};
use super::theory::{StiffnessLaw, area_fraction, stiffness_exponent};
use crate::contact::rough::RoughBed;
use crate::halfspace::{self, Boundary, Prescribed, PressedMap, Settings, Start};
use crate::shape::rough::{Rings, RoughError, RoughLine, RoughnessSpectrum, Scatter, ensemble, rough_surface};
use std::f64::consts::TAU;

/// Self-affine squares of side L, of full-band roughness: longest wave L, shortest four pixels, fewer of which leave contact
/// spots of single pixels.
///
/// Both bodies are pressed with the same forces; lengths are in L and the rms height h, moduli in E*, all of which drop out.
#[derive(Debug, Clone, PartialEq)]
pub struct SelfAffineSquares {
    /// Hurst exponent H.
    pub hurst: f64,
    /// Pixels on the side of the half-space grid.
    pub points: usize,
    /// Seeds of the surfaces.
    pub seeds: Vec<u64>,
}

/// What the bed and the half-space say of the squares: mean and scatter over the seeds, of each.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Agreement {
    /// Exponent 1/(1 + H) of the stiffness law k/(E*L) = prefactor·(F/(E*hL))^exponent.
    pub law: f64,
    /// Exponent fitted to the bed and to the half-space.
    pub exponent: [Scatter; 2],
    /// Prefactor fitted to each, with the exponent fitted.
    pub prefactor: [Scatter; 2],
    /// Share of the springs in contact, and of the area, at the largest force.
    pub area: [Scatter; 2],
    /// Area after Persson's theory at the largest force.
    pub persson_area: f64,
}

/// Springs of the rough line: fewer leave single springs at the least force.
const SPRINGS: usize = 1 << 16;
/// Pixels on the shortest wave.
const SHORTEST: usize = 4;
/// Relative residual asked of the half-space: far below the scatter.
const TOLERANCE: f64 = 1e-6;
/// rms height over side; linear theory, so any will do.
const HEIGHT: f64 = 0.01;

/// Forces in E*hL: eight from 0.003 to 0.3.
fn forces() -> [f64; 8] {
    [0.0, 1.0, 2.0, 3.0, 4.0, 5.0, 6.0, 7.0].map(|k| 0.003 * 100f64.powf(k / 7.0))
}

impl SelfAffineSquares {
    /// The squares by the bed and by the half-space; `done` is called after each seed, from any thread.
    ///
    /// # Errors
    /// No seeds; roughness finer than the grid; a half-space solution that does not converge.
    pub fn agreement(&self, done: impl Fn(u64) + Sync) -> Attempt<Agreement> {
        if self.seeds.is_empty() {
            return Err("a study of agreement needs at least one seed".into());
        }
        let spectrum = self.spectrum()?;
        let member = |seed| -> Attempt<Vec<f64>> {
            Ok([numbers(&bed(&spectrum, seed)?)?, numbers(&self.half_space(&spectrum, seed)?)?].concat())
        };
        let columns = ensemble(&self.seeds, member, done)?;
        let pressure = forces()[7] * HEIGHT;
        Ok(Agreement {
            law: stiffness_exponent(self.hurst),
            exponent: [columns[0], columns[3]],
            prefactor: [columns[1], columns[4]],
            area: [columns[2], columns[5]],
            persson_area: area_fraction(pressure, 1.0, spectrum.rms_slope()),
        })
    }

    /// Self-affine from the side to the shortest wave, rms height `HEIGHT`.
    fn spectrum(&self) -> Result<RoughnessSpectrum, RoughError> {
        let range = self.points as f64 / SHORTEST as f64;
        let shape = RoughnessSpectrum::table(&[(TAU, 1.0), (TAU * range, range.powf(-2.0 * (1.0 + self.hurst)))])?;
        Ok(shape.scaled((HEIGHT / shape.rms_height()).powi(2)))
    }

    /// Indentation [L] and share of the area in contact at each force.
    fn half_space(&self, spectrum: &RoughnessSpectrum, seed: u64) -> Attempt<Pairs> {
        let heights = rough_surface(spectrum, 1.0, self.points, seed)?;
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        let pixel = [1.0 / self.points as f64; 2];
        let settings = Settings { tolerance: TOLERANCE, ..Settings::default() };
        let at = |force: f64| {
            let (boundary, control) = (Boundary::Free, Prescribed::Force(force * HEIGHT));
            let problem = PressedMap { heights: heights.view(), pixel, modulus: 1.0, boundary, control };
            let solution = halfspace::solve(&problem, Start::Coarser, &settings)?;
            Ok((solution.indentation - lowest, solution.area_fraction()))
        };
        forces().into_iter().map(at).collect()
    }
}

/// Indentation [L] and share of the springs in contact at each force.
fn bed(spectrum: &RoughnessSpectrum, seed: u64) -> Attempt<Pairs> {
    let line = RoughLine::new(&Rings::of(spectrum, 1.0, SPRINGS)?, seed);
    let bed = RoughBed::under(&line, SPRINGS, 1.0, |_| 0.0)?;
    let at = |force: f64| {
        let state = bed.at_force(force * HEIGHT);
        // E* = L = 1: the stiffness is the share of springs in contact.
        (state.indentation - bed.first_touch(), state.stiffness)
    };
    Ok(forces().map(at).to_vec())
}

/// Exponent and prefactor of a curve, and its share in contact at the end.
///
/// Stiffness is the difference quotient between neighbouring forces for both ways alike.
fn numbers(curve: &Pairs) -> Attempt<Vec<f64>> {
    let between = |(forces, states): (&[f64], &[(f64, f64)])| {
        let stiffness = (forces[1] - forces[0]) * HEIGHT / (states[1].0 - states[0].0);
        ((forces[0] * forces[1]).sqrt(), stiffness)
    };
    let points: Vec<_> = forces().windows(2).zip(curve.windows(2)).map(between).collect();
    let law = StiffnessLaw::fitted(&points, (1.0, 1.0, 1.0)).ok_or("no law fits the stiffness")?;
    Ok(vec![law.exponent, law.prefactor, curve[curve.len() - 1].1])
}

impl Agreement {
    /// The parts used of: the scatter by the difference of the exponents, a quarter by the prefactors, a half by the areas of
    /// half-space and theory; and of a fifth of the share of springs by the area.
    #[must_use]
    pub fn parts(&self) -> Pairs {
        let [bed, full] = self.exponent;
        let exponents = (bed.mean - full.mean) / bed.deviation.hypot(full.deviation);
        let prefactors = (self.prefactor[0].mean / self.prefactor[1].mean - 1.0) / 0.25;
        let [springs, area] = self.area;
        let areas = (area.mean / self.persson_area - 1.0) / 0.5;
        [exponents, prefactors, areas, 5.0 * area.mean / springs.mean].map(|part| (part, 0.0)).to_vec()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_study_without_seeds_is_refused() {
        let squares = SelfAffineSquares { hurst: 0.8, points: 64, seeds: Vec::new() };
        assert!(squares.agreement(|_| ()).unwrap_err().to_string().contains("at least one seed"));
    }
}
