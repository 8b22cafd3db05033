//! The rough bed held against the full half-space: where they agree and where they do not.

use super::theory::{StiffnessLaw, area_fraction, stiffness_exponent};
use crate::contact::rough::RoughBed;
use crate::halfspace::{self, Boundary, HalfSpaceError, Prescribed, PressedMap, Settings, Start};
use crate::shape::rough::{Rings, RoughError, RoughLine, RoughnessSpectrum, Scatter, ensemble, rough_surface};
use std::f64::consts::TAU;

/// A study of self-affine squares of side L, of full-band roughness: longest wave L, shortest `pixels_per_wave` pixels.
///
/// Both bodies are pressed with the same forces; lengths are in L and the rms height h, moduli in E*, all of which drop out.
#[derive(Debug, Clone)]
pub struct Agreement {
    /// Pixels on the side of the half-space grid; default 256.
    pub points: usize,
    /// Pixels on the shortest wave; default 4. Fewer leave contact spots of single pixels.
    pub pixels_per_wave: usize,
    /// Springs of the rough line; default 2¹⁶. Fewer leave single springs at the least force.
    pub springs: usize,
    /// Forces in E*hL, rising; default eight from 0.003 to 0.3.
    pub forces: Vec<f64>,
    /// Seeds of the surfaces; default 1 to 10.
    pub seeds: Vec<u64>,
}

impl Default for Agreement {
    fn default() -> Self {
        let forces = (0..8).map(|k| 0.003 * 100f64.powf(f64::from(k) / 7.0)).collect();
        Self { points: 256, pixels_per_wave: 4, springs: 1 << 16, forces, seeds: (1..=10).collect() }
    }
}

/// What the bed and the half-space say of surfaces with one Hurst exponent: mean and scatter over the seeds.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct AgreementRow {
    /// Hurst exponent H.
    pub hurst: f64,
    /// Exponent 1/(1 + H) of the stiffness law k/(E*L) = prefactor·(F/(E*hL))^exponent.
    pub law: f64,
    /// Exponent fitted to the bed and to the half-space.
    pub exponent: Compared,
    /// Prefactor fitted to each, with the exponent fitted.
    pub prefactor: Compared,
    /// Stiffness k/(E*L) at the middle force.
    pub stiffness: Compared,
    /// Approach since first touch in rms heights at the largest force.
    pub approach: Compared,
    /// Share of the springs in contact, and of the area, at the largest force.
    pub area: Compared,
    /// Area after Persson's theory at the largest force.
    pub persson_area: f64,
}

/// One number by both ways.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Compared {
    /// By the rough bed.
    pub bed: Scatter,
    /// By the full half-space.
    pub half_space: Scatter,
}

/// Why a study broke off.
#[derive(Debug, thiserror::Error)]
pub enum AgreementError {
    /// The roughness does not fit the grid.
    #[error(transparent)]
    Rough(#[from] RoughError),
    /// The half-space has no solution.
    #[error(transparent)]
    HalfSpace(#[from] HalfSpaceError),
    /// Fewer than three forces, or no seed.
    #[error("a study of agreement needs at least three rising forces and one seed, found {forces} and {seeds}")]
    TooFew {
        /// Forces given.
        forces: usize,
        /// Seeds given.
        seeds: usize,
    },
}

/// Relative residual asked of the half-space: far below the scatter.
const TOLERANCE: f64 = 1e-6;
/// rms height over side; linear theory, so any will do.
const HEIGHT: f64 = 0.01;

/// Indentation [L] and share in contact at each force.
type Curve = Vec<(f64, f64)>;

impl Agreement {
    /// The row of one Hurst exponent; `done` is called after each seed, from any thread.
    ///
    /// # Errors
    /// Too few forces or seeds; roughness finer than the grid; a half-space solution that does not converge.
    pub fn row(&self, hurst: f64, done: impl Fn(u64) + Sync) -> Result<AgreementRow, AgreementError> {
        let (forces, seeds) = (self.forces.len(), self.seeds.len());
        if forces < 3 || seeds == 0 {
            return Err(AgreementError::TooFew { forces, seeds });
        }
        let spectrum = self.spectrum(hurst)?;
        let member = |seed| {
            let mut row = self.numbers(&self.bed(&spectrum, seed)?);
            row.extend(self.numbers(&self.half_space(&spectrum, seed)?));
            Ok::<_, AgreementError>(row)
        };
        let columns = ensemble(&self.seeds, member, done)?;
        let compared = |k: usize| Compared { bed: columns[k], half_space: columns[k + columns.len() / 2] };
        let pressure = self.forces[forces - 1] * HEIGHT;
        Ok(AgreementRow {
            hurst,
            law: stiffness_exponent(hurst),
            exponent: compared(0),
            prefactor: compared(1),
            stiffness: compared(2),
            approach: compared(3),
            area: compared(4),
            persson_area: area_fraction(pressure, 1.0, spectrum.rms_slope()),
        })
    }

    /// Self-affine from the side to the shortest wave, rms height `HEIGHT`.
    fn spectrum(&self, hurst: f64) -> Result<RoughnessSpectrum, RoughError> {
        #[expect(clippy::cast_precision_loss, reason = "grids are far below 2^53")]
        let range = self.points as f64 / self.pixels_per_wave as f64;
        let shape = RoughnessSpectrum::table(&[(TAU, 1.0), (TAU * range, range.powf(-2.0 * (1.0 + hurst)))])?;
        Ok(shape.scaled((HEIGHT / shape.rms_height()).powi(2)))
    }

    fn bed(&self, spectrum: &RoughnessSpectrum, seed: u64) -> Result<Curve, AgreementError> {
        let line = RoughLine::new(&Rings::of(spectrum, 1.0, self.springs)?, seed);
        let bed = RoughBed::under(&line, self.springs, 1.0, |_| 0.0)?;
        let at = |force: &f64| {
            let state = bed.at_force(force * HEIGHT);
            // E* = L = 1: the stiffness is the share of springs in contact.
            (state.indentation - bed.first_touch(), state.stiffness)
        };
        Ok(self.forces.iter().map(at).collect())
    }

    fn half_space(&self, spectrum: &RoughnessSpectrum, seed: u64) -> Result<Curve, AgreementError> {
        let heights = rough_surface(spectrum, 1.0, self.points, seed)?;
        let lowest = heights.iter().copied().fold(f64::INFINITY, f64::min);
        #[expect(clippy::cast_precision_loss, reason = "grids are far below 2^53")]
        let pixel = 1.0 / self.points as f64;
        let settings = Settings { tolerance: TOLERANCE, ..Settings::default() };
        let at = |force: &f64| {
            let control = Prescribed::Force(force * HEIGHT);
            let (view, boundary) = (heights.view(), Boundary::Free);
            let problem = PressedMap { heights: view, pixel: [pixel; 2], modulus: 1.0, boundary, control };
            let solution = halfspace::solve(&problem, Start::Coarser, &settings)?;
            Ok((solution.indentation - lowest, solution.area_fraction()))
        };
        self.forces.iter().map(at).collect()
    }

    /// Exponent, prefactor, stiffness at the middle, approach and share in contact at the end of a curve.
    ///
    /// Stiffness is the difference quotient between neighbouring forces for both ways alike.
    fn numbers(&self, curve: &Curve) -> Vec<f64> {
        let between = |k: usize| {
            let (low, high) = (self.forces[k], self.forces[k + 1]);
            ((low * high).sqrt(), (high - low) * HEIGHT / (curve[k + 1].0 - curve[k].0))
        };
        let points: Vec<_> = (0..curve.len() - 1).map(between).collect();
        let law = StiffnessLaw::fitted(&points, (1.0, 1.0, 1.0));
        let (exponent, prefactor) = law.map_or((f64::NAN, f64::NAN), |l| (l.exponent, l.prefactor));
        let last = curve[curve.len() - 1];
        vec![exponent, prefactor, points[points.len() / 2].1, last.0 / HEIGHT, last.1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Both follow one stiffness law: exponents within the scatter of each other, prefactors within a quarter; the area does not
    /// agree by any measure. Over H = 0.2 to 0.9 and 8 seeds of 192² the exponents differ by 0.04 at most, the prefactors by 15 %, while
    /// the share of springs in contact is 15 to 40 times that of the area.
    #[test]
    fn stiffness_agrees_and_area_does_not() {
        let study = Agreement { points: 64, springs: 1 << 14, seeds: (1..=6).collect(), ..Agreement::default() };
        let row = study.row(0.8, |_| ()).unwrap();
        let (bed, full) = (row.exponent.bed, row.exponent.half_space);
        assert!((bed.mean - full.mean).abs() < bed.deviation.hypot(full.deviation), "{row:?}");
        assert!((row.prefactor.bed.mean / row.prefactor.half_space.mean - 1.0).abs() < 0.25, "{row:?}");
        assert!(row.area.bed.mean > 5.0 * row.area.half_space.mean, "{row:?}");
        assert!((row.area.half_space.mean / row.persson_area - 1.0).abs() < 0.5, "{row:?}");
    }

    #[test]
    fn a_study_without_seeds_is_refused() {
        let study = Agreement { seeds: Vec::new(), ..Agreement::default() };
        assert!(study.row(0.8, |_| ()).unwrap_err().to_string().contains("found 8 and 0"));
    }
}
